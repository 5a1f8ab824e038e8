// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_ISOLINES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_ISOLINES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A polyline of constant value. If it is closed, its last location equals the first one.
struct Isoline
{
  std::size_t level = 0; // index of its value in `levels`
  bool is_closed = false;
  std::vector<Surface_location> polyline;
};

// The interpolation of values along an edge.
enum class Edge_interpolation
{
  linear,
  // The values are distances from a point in the plane of the edge. Negative values are
  // interpolated linearly.
  circular
};

// Returns the position between the ends of an edge at which its interpolated value is `level`, from
// zero at the lower to one at the upper end. lower < level <= upper. `length` is the length of the
// edge in the unit of the values; linear interpolation does not use it.
CGAL_GEODESIC_PROCESSING_EXPORT
double isoline_position(double lower, double upper, double level, double length,
                        Edge_interpolation interpolation);

// Computes the isolines of a function on a mesh, given by its values at the vertices.
//
// A vertex whose value equals the level counts as above the level. Therefore a triangle has one
// edge on which an isoline enters it, and one on which it leaves it, or none. The isolines of a
// level visit each triangle whose smallest value is below the level and whose largest value is not
// below it exactly once, and cross each edge at most once. They end at boundary edges and at
// triangles with an infinite value or NaN. Larger values are on the left. Crossings that coincide
// at a vertex are merged, and isolines that shrink to a vertex are omitted.
//
// values: #vertices, may be infinite or NaN
// levels: any number of values, finite, in any order
//
// The result is in the order of the levels. For each level, open isolines precede closed ones.
// `callback` is called with the fraction of the levels before each level. An exception that it
// throws cancels the computation.
// O(n log k + m) for n triangles, k levels and m locations.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Isoline> find_isolines(const Surface_arrays& triangles,
                                   const std::vector<double>& values,
                                   const std::vector<double>& levels,
                                   Edge_interpolation interpolation = Edge_interpolation::linear,
                                   const std::function<bool(double)>& callback = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_ISOLINES_H
