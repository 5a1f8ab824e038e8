// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DIAMETER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DIAMETER_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>

// Bounds of the diameter and of the radius of a mesh by exact distances from few vertices.
//
// The eccentricity of a vertex is the largest distance to a vertex of its component. The diameter
// of a component is the largest eccentricity of its vertices, and its radius the smallest one.
// Those of a mesh are the largest ones of its components. Vertices without triangles are ignored.

namespace CGAL::Geodesic_processing::internal {

struct Diameter_options
{
  double relative_tolerance = 0.01; // not negative: upper is at most (1 + tolerance) lower
  // In each component, positive.
  std::size_t max_number_of_queries = (std::numeric_limits<std::size_t>::max)();
  std::function<bool(double)> callback; // may throw; its result is ignored
};

// Bounds of a diameter, in scaled units.
struct Diameter_bounds
{
  double lower = 0., upper = 0.;
  Index from = none, to = none; // two vertices whose distance is `lower`
  bool is_converged = false;
  std::size_t number_of_queries = 0;
};

// Bounds of a radius, in scaled units.
struct Radius_bounds
{
  double lower = 0., upper = 0.;
  Index center = none;   // the vertex whose eccentricity is `upper`
  Index farthest = none; // a vertex at this distance from the center
  bool is_converged = false;
  std::size_t number_of_queries = 0;
};

// Bounds the diameter of a mesh.
//
// For a vertex s whose distances are known, d(u, v) <= d(s, u) + d(s, v). The largest minimum of
// this sum over all s is the upper bound. A branch-and-bound search over pairs of nodes of a tree
// of vertices finds it without visiting all pairs. The next distances are computed from an end of
// the pair with the largest bound, and from the midpoint of a shortest path that starts there: the
// bound is exact for all pairs with a shortest path through the midpoint, and its error for other
// pairs is of second order in the distance of the midpoint from their path.
//
// Takes one exact query for each number_of_queries, and 128 bytes per vertex of a component for
// each eight queries in it. Throws as Window_propagation, and Unsupported_surface_error if the mesh
// has no triangle.
CGAL_GEODESIC_PROCESSING_EXPORT
Diameter_bounds bound_diameter(const std::shared_ptr<const Surface_arrays>& triangles,
                               const Diameter_options& options = {});

// Bounds the radius of a mesh.
//
// For a vertex s whose distances and eccentricity e(s) are known, e(v) >= d(s, v) and
// e(v) >= e(s) - d(s, v). The next distances are computed from the vertex with the smallest lower
// bound, and from the vertex farthest from it. Takes one exact query for each number_of_queries,
// and 8 bytes per vertex. Throws as bound_diameter().
CGAL_GEODESIC_PROCESSING_EXPORT
Radius_bounds bound_radius(const std::shared_ptr<const Surface_arrays>& triangles,
                           const Diameter_options& options = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DIAMETER_H
