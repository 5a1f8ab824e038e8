// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_CURVES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_CURVES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <functional>
#include <memory>
#include <vector>

// Curves on a mesh by repeated subdivision of control polygons. The midpoint of two points is that
// of a shortest path between them (Morera, Carvalho and Velho 2008; Mancinelli et al. 2022).

namespace CGAL::Geodesic_processing::internal {

struct Curve_options
{
  unsigned number_of_subdivisions = 6;
  std::function<bool(double)> callback; // may throw; its result is ignored
};

// Returns the point of a path that halves its length. Consecutive locations are in a common
// triangle, and there is at least one. O(#path).
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location path_midpoint(const Surface_arrays& triangles,
                               const std::vector<Surface_location>& path);

// Computes a Bezier curve by repeated subdivision at the parameter 1/2 with the algorithm of de
// Casteljau. The degree p is the number of control points minus one. The result joins 2^k + 1
// points of the curve by shortest paths, for k subdivisions. Takes 2^k (1 + p (p + 1) / 2) queries
// of Shortest_path_finder. Throws Invalid_argument_error if there are fewer than two control
// points, or if two consecutive ones are not connected.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> bezier_curve(const std::shared_ptr<const Surface_arrays>& triangles,
                                           const std::vector<Surface_location>& control_points,
                                           const Curve_options& options = {});

// Computes a uniform B-spline by the algorithm of Lane and Riesenfeld (1980): a subdivision doubles
// all points and then replaces consecutive points by their midpoints `degree` times. The result
// joins the control points of the last subdivision by shortest paths. If the curve is open, its end
// points are control points that count `degree` times, so that it interpolates them. Takes 2^k n
// (degree + 1) queries of Shortest_path_finder for n control points and k subdivisions. Throws
// Invalid_argument_error as bezier_curve(), and if the degree is zero.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> b_spline(const std::shared_ptr<const Surface_arrays>& triangles,
                                       const std::vector<Surface_location>& control_points,
                                       unsigned degree, bool is_closed,
                                       const Curve_options& options = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_CURVES_H
