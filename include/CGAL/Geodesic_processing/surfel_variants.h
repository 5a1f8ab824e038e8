// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SURFEL_VARIANTS_H
#define CGAL_GEODESIC_PROCESSING_SURFEL_VARIANTS_H

#include <CGAL/Geodesic_processing/internal/surfels/surfel_variants.h>

namespace CGAL::Geodesic_processing {

#ifndef DOXYGEN_RUNNING
using internal::Path_energy_level;
using internal::Surfel_graph;
using internal::Surfel_noise;
using internal::Surfel_path_method;
using internal::Surfel_search;
#else

/// \ingroup PkgGeodesicProcessingPaths
/// Selects the edges of the proximity graph of a cloud. A path is initialized by a graph path.
enum class Surfel_graph
{
  /// Joins two surfels if their spheres, of the surfels' radii, intersect and their normals agree.
  /// Hence nearby sheets are not joined. \cgalCite{cgal:rdsk-asg-06}
  extended_spheres,
  /// Joins two surfels if their spheres of influence intersect. The radius of such a sphere is the
  /// distance to the nearest surfel.
  spheres,
  /// Joins each surfel to its nearest surfels \cgalCite{cgal:kz-pcsg-04}
  nearest
};

/// \ingroup PkgGeodesicProcessingPaths
/// Selects the search for a short graph path between two surfels. Dijkstra's algorithm,
/// bidirectional search and A* find shortest graph paths. They find the same one if it is unique.
/// `coarse_to_fine` does not always find a shortest graph path. With every search, the resulting
/// path is never longer than the graph path that initialized it.
enum class Surfel_search
{
  /// A* for at most 50,000 surfels. For larger clouds, the search first finds a path of regions.
  /// Then it finds a short graph path in these regions and their neighbors. This is by far the
  /// fastest search. The graph path is some tenths of a percent longer than the shortest one. If it
  /// has hundreds of surfels, it can be one or two percent longer.
  coarse_to_fine,
  a_star,        ///< A* with the Euclidean distance to the target as lower bound
  bidirectional, ///< Dijkstra's algorithm from both ends
  dijkstra       ///< Dijkstra's algorithm from one end
};

/// \ingroup PkgGeodesicProcessingPaths
/// Selects the fitted surface that attracts a path on a cloud, and whether the path is projected
/// onto it.
enum class Surfel_path_method
{
  /// Projects the path onto quadrics over algebraic spheres, which are fitted to the surfels and
  /// their normals
  projected_quadrics,
  /// Projects the path onto algebraic spheres without quadrics \cgalCite{cgal:ggg-dpsas-08}
  projected_spheres,
  /// Projects the path onto fitted planes \cgalCite{cgal:hp-emss-04}
  projected_planes,
  /// Attracts the path to algebraic spheres by the energy
  spheres,
  /// As `spheres`, with robust weights: surfels far from their neighbors are ignored. Use it for
  /// outliers that remain with `Surfel_noise::kept`, or that are too few to be detected as noise.
  robust_spheres,
  /// Attracts the path to fitted planes by the energy
  planes,
  /// Attracts the path to the disks of the surfels by the energy \cgalCite{cgal:rdsk-asg-06}
  disks
};

/// \ingroup PkgGeodesicProcessingPaths
/// Selects whether surfels are denoised before paths are computed. Denoising moves the surfels to
/// an estimated surface.
enum class Surfel_noise
{
  removed_when_found, ///< denoises if the noise level is at least 2 % of the spacing
  removed,            ///< always denoises
  kept                ///< never denoises
};

/// \ingroup PkgGeodesicProcessingPaths
/// Stores the decrease of the energy of a path on one level, with a fixed number of control points.
struct Path_energy_level
{
  std::size_t number_of_control_points = 0; ///< the number of control points
  std::size_t number_of_iterations = 0;     ///< the number of iterations of the minimization
  double first_energy = 0.; ///< before minimization, in squares of the surface's unit
  double last_energy = 0.;  ///< after minimization; at most `first_energy`
};

#endif // DOXYGEN_RUNNING

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SURFEL_VARIANTS_H
