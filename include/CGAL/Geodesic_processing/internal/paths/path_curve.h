// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_CURVE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_CURVE_H

#include <CGAL/Geodesic_processing/internal/core/Path_surface.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Smooth curves through points on a surface, and their lengths. All functions take linear time.

// Inserts a point on each sharp edge that a segment of a path crosses. Such an edge exists if the
// normals at the segment's endpoints differ by more than 40 degrees. It is the intersection line
// of both tangent planes, which must pass between the endpoints.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Projection> insert_sharp_edges(const std::vector<Projection>& path);

// Inserts one point per segment by four-point subdivision (Dyn, Levin and Gregory 1987) and
// projects it to the surface. Points at which the path turns by 30 degrees or more remain corners.
// If the lengths of two adjacent segments differ by more than a factor of two, the intervals of the
// cubic polynomial are proportional to them; with equal intervals, the curve would reverse.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Projection> subdivide_curve(const Path_surface& surface,
                                        const std::vector<Projection>& path);

// Returns the sum of the lengths of the segments.
CGAL_GEODESIC_PROCESSING_EXPORT
double polyline_length(const std::vector<Projection>& points);

// Returns the estimated length of the surface path between two points with normals.
//
// The estimate is the length of a circular arc over their chord. The arc's central angle is the
// difference of the signed angles between the chord and the two tangent planes. If a sharp edge
// separates the points (see insert_sharp_edges()), the shortest path across it in both tangent
// planes is measured instead.
CGAL_GEODESIC_PROCESSING_EXPORT
double arc_length(const Projection& from, const Projection& to);

// Returns the length of a smooth curve through points.
//
// Each segment is replaced by a circular arc whose curvature is the average of those at its
// endpoints. The curvature at a point is that of the circle through the point and both neighbors.
// It is zero at corners of 30 degrees or more. The first and the last point have the curvature of
// their neighbor.
CGAL_GEODESIC_PROCESSING_EXPORT
double curve_length(const std::vector<Projection>& points);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_CURVE_H
