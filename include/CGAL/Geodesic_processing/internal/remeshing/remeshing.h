// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_REMESHING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_REMESHING_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Remeshing_options
{
  std::size_t number_of_samples = 0;           // of samples, if these are enough
  std::vector<Surface_location> first_samples; // of them, clean
  // #triangles: as in Front_limits, but finite: there are no obstacles
  std::shared_ptr<const std::vector<double>> slowness;
  // #sides, twins alike: curves to be kept, the border among them; empty: the border alone
  std::vector<bool> is_feature;
  // #sides, twins alike, or empty: how far apart samples are to be along curves; where this is zero, as
  // far as all samples
  std::vector<double> feature_spacing;
  std::size_t number_of_relaxation_steps =
      0; // that move samples which are not on curves, or first ones
  // How far sites may be from the triangles in space, and the middles of these and of their sides from
  // the surface: samples are added where they are farther.
  double maximum_deviation = infinity;
  bool does_avoid_self_intersections = false; // samples are added where triangles in space cross
  bool does_fit_to_input = false;       // points leave the surface: triangles are nearer to sites
  unsigned seed = 0;                    // as in Sampling_options
  std::function<bool(double)> callback; // told the fraction done; false cancels
};

struct Remeshing
{
  std::vector<Surface_location> samples;       // clean
  std::vector<std::array<double, 3>> points;   // of samples, in the caller's coordinates
  std::vector<std::array<Index, 3>> triangles; // of samples, counterclockwise
  std::size_t number_of_self_intersections =
      0;                   // pairs, where these were to be avoided; no more than triangles
  bool is_finished = true; // else there are no triangles

  // What they were before edges were flipped for larger angles: those between cells, which are told apart
  // by the sites of a finer surface.
  Refinement surface;
  std::vector<Index>
      cells; // #sites of the surface: the sample of each, none where there is no triangle
  std::vector<std::array<Index, 3>> dual_triangles;
};

// The geodesic Delaunay triangulation of samples on a mesh (Peyré and Cohen 2003, section 3): a
// surface with the components, the genus and the borders of the mesh, without the sites that have no
// triangle.  More samples than asked for come where it takes them: as long as the cells are no closed
// balls, the sites of those that are not that are farthest from their samples.
//
// Cells are told apart by sites: where the mesh has not enough for so many samples its sides are
// halved.  In the worst case each site of such a finer mesh is a sample, and the result is that mesh,
// so that it ends; where that is no surface yet, two triangles have the same corners, its sides are
// halved there.
//
// Throws Invalid_argument_error when a mesh of so many vertices has more than 2^31 half-edges, and
// Unsupported_surface_error when halving does not help.
// About the time of sampling, and O(n log n) for each of some rounds of checking.
CGAL_GEODESIC_PROCESSING_EXPORT
Remeshing remesh(const std::shared_ptr<const Surface_arrays>& triangles,
                 const Remeshing_options& options);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_REMESHING_H
