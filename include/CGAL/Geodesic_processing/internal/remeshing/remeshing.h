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
  // Minimum number of samples. More are added if the topology or another option requires them.
  std::size_t number_of_samples = 0;
  // Samples to start with, as canonical locations. They stay fixed.
  std::vector<Surface_location> first_samples;
  // #triangles: slowness as in Front_limits. All values must be finite: obstacles are not
  // supported.
  std::shared_ptr<const std::vector<double>> slowness;
  // 3 #triangles, equal for both halfedges of an edge: edges that the result preserves. Must
  // include the boundary. If empty, only the boundary is preserved.
  std::vector<bool> is_feature;
  // 3 #triangles, equal for both halfedges of an edge, or empty: the requested distance between
  // adjacent samples along features, in the scale of the triangles. If it is zero or empty, the
  // distance between samples elsewhere is used.
  std::vector<double> feature_spacing;
  // Steps of Lloyd relaxation. Samples on features and first samples stay fixed.
  std::size_t number_of_relaxation_steps = 0;
  // Maximum distance between input and result, in the scale of the triangles. It is tested from the
  // vertices of the input to the result, and from the centroids and edge midpoints of the result to
  // the input. Samples are added until it holds.
  double maximum_deviation = infinity;
  // Adds samples at intersecting triangles of the result.
  bool does_avoid_self_intersections = false;
  // Moves the points of the result off the input, which reduces the distance of the input vertices.
  bool does_fit_to_input = false;
  unsigned seed = 0; // as in Sampling_options
  // Receives the fraction that is completed. If it returns false, the remeshing is cancelled.
  std::function<bool(double)> callback;
};

struct Remeshing
{
  std::vector<Surface_location> samples;       // canonical locations on the input
  std::vector<std::array<double, 3>> points;   // #samples, in the caller's coordinates
  std::vector<std::array<Index, 3>> triangles; // samples at the corners, counterclockwise
  // Pairs of intersecting triangles, at most the number of triangles. Computed only if
  // does_avoid_self_intersections is set.
  std::size_t number_of_self_intersections = 0;
  bool is_finished = true; // false if the callback cancelled; then there are no triangles

  // The refined input whose vertices determine the cells, and the dual triangulation of the cells
  // before edge flips.
  Refinement surface;
  std::vector<Index> cells; // #vertices of surface: the sample of each, none without triangles
  std::vector<std::array<Index, 3>> dual_triangles;
};

// Computes a geodesic Delaunay triangulation of samples on a mesh (Peyré and Cohen 2003, section
// 3). The result has the same connected components, genus and boundary cycles as the mesh. Isolated
// vertices are ignored. If the Voronoi cells of the samples violate the closed ball property,
// samples are added: the farthest vertices of violating cells.
//
// Cells are represented by labels of vertices. If the mesh has too few vertices for the samples,
// its edges are split at their midpoints. The process terminates: in the worst case every vertex of
// the refined mesh is a sample, and the result is that mesh. If two of its triangles have the same
// vertices, their edges are split.
//
// Throws `Invalid_argument_error` if the result would have more than 2^31 halfedges, and
// `Unsupported_surface_error` if splitting edges or the rounds of checks do not resolve the
// violations.
// Takes about the time of the sampling, and O(n log n) for each round of checks. At most 400 rounds
// add samples to invalid cells; after 64 of them, the number per cell doubles every 16 rounds.
CGAL_GEODESIC_PROCESSING_EXPORT
Remeshing remesh(const std::shared_ptr<const Surface_arrays>& triangles,
                 const Remeshing_options& options);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_REMESHING_H
