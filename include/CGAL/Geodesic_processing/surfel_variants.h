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
/// which surfels of a cloud are joined by arcs, from which a path starts.
enum class Surfel_graph
{
  /// those whose spheres, of their radii, meet, and whose normals agree: near sheets stay apart.
  /// \cgalCite{cgal:rdsk-asg-06}
  extended_spheres,
  /// those whose spheres of influence meet, as large as the distance to the nearest surfel
  spheres,
  /// each and its nearest ones \cgalCite{cgal:kz-pcsg-04}
  nearest
};

/// \ingroup PkgGeodesicProcessingPaths
/// how a short chain of arcs between two surfels is found.  Dijkstra's search, from both ends, and A* find
/// chains of one length, the least: the same chain where no other is as short.  `coarse_to_fine` is another
/// search, which need not find a shortest chain; a path is never longer than the chain that it started from,
/// whichever found it.
enum class Surfel_search
{
  /// A* below 50,000 surfels; above, a chain of regions first, then a short chain in these and their
  /// neighbours: the fastest by far.  It is a few tenths of a percent longer than the shortest, or over
  /// hundreds of surfels one or two percent.
  coarse_to_fine,
  a_star,        ///< towards the goal, bounded below by the distance in space
  bidirectional, ///< from both ends
  dijkstra       ///< in all directions
};

/// \ingroup PkgGeodesicProcessingPaths
/// what a path on a cloud is held on, or drawn to.
enum class Surfel_path_method
{
  /// held on surfaces of second order over algebraic spheres, fitted to the surfels and their normals
  projected_quadrics,
  /// held on the algebraic spheres alone \cgalCite{cgal:ggg-dpsas-08}
  projected_spheres,
  /// held on fitted planes \cgalCite{cgal:hp-emss-04}
  projected_planes,
  /// drawn to algebraic spheres by the energy
  spheres,
  /// the same with robust weights: surfels far off their neighbours do not count.  For outliers that
  /// `Surfel_noise::kept` leaves, or that are too few to be found as noise
  robust_spheres,
  /// drawn to fitted planes by the energy
  planes,
  /// drawn to the disks of the surfels by the energy \cgalCite{cgal:rdsk-asg-06}
  disks
};

/// \ingroup PkgGeodesicProcessingPaths
/// whether surfels are moved to the surface that they suggest before paths are sought.
enum class Surfel_noise
{
  removed_when_found, ///< where neighbours rise over each other by more than 2 % of the spacing
  removed,
  kept
};

/// \ingroup PkgGeodesicProcessingPaths
/// how the energy of a path went down with equally many control points.
struct Path_energy_level
{
  std::size_t number_of_control_points = 0;
  std::size_t number_of_iterations = 0;
  double first_energy = 0.; ///< in squares of the surface's unit
  double last_energy = 0.;  ///< never higher
};

#endif // DOXYGEN_RUNNING

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SURFEL_VARIANTS_H
