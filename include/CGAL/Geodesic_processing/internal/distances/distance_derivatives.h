// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_DERIVATIVES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_DERIVATIVES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Whether a distance is differentiable, or the first rule that rejects it.
enum class Differentiability
{
  differentiable,
  unreachable,
  coincident,
  near_vertex,
  second_path
};

struct Derivative_tolerances
{
  // The minimum distance of crossings from vertices, as a fraction of the edge, and the minimum
  // excess over pi, in radians, of the angles at vertices where the path bends.
  double vertex = 1e-4;
  double second_path = 1e-6; // the minimum excess of the length of other paths, as a fraction
};

// The distance between two locations and its derivatives, which have no unit.
struct Distance_derivatives
{
  double distance = std::numeric_limits<double>::infinity(); // in scaled units
  Differentiability differentiability = Differentiability::unreachable;
  // Tangent to the triangles in which the path begins and ends.
  Vec3 source_gradient = {0., 0., 0.}, target_gradient = {0., 0., 0.};
  // By the positions of vertices, in the order of the path. All others are zero. The barycentric
  // coordinates of both locations are constant.
  std::vector<std::pair<Index, Vec3>> vertex_gradients;
};

// Computes the derivatives of the exact distance between two canonical locations of a mesh along
// the shortest path. Crossings of edges are stationary points of the length. Therefore the
// derivative is that of the length of the polyline with constant barycentric coordinates.
//
// The tests are made in the order of Differentiability. If a test fails, the derivatives are those
// of one shortest path. Throws as Window_propagation, and Unsupported_surface_error if round-off
// errors in degenerate triangles prevent the reconstruction of the path.
CGAL_GEODESIC_PROCESSING_EXPORT
Distance_derivatives
distance_derivatives(const std::shared_ptr<const Surface_arrays>& triangles,
                     const Surface_location& source, const Surface_location& target,
                     const Derivative_tolerances& tolerances = Derivative_tolerances());

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_DERIVATIVES_H
