// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_CURVE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_CURVE_H

#include <CGAL/Geodesic_processing/internal/core/Path_surface.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Smooth curves through points on a surface, and their lengths.  All functions are linear in the
// number of points.

// Inserts a point on each sharp edge that a segment of a path crosses.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Projection> insert_sharp_edges(const std::vector<Projection>& path);

// Inserts one point per segment by four-point subdivision (Dyn, Levin and Gregory 1987) and projects
// it to the surface.  At corners of more than 30 degrees the curve is not smoothed.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Projection> subdivide_curve(const Path_surface& surface,
                                        const std::vector<Projection>& path);

CGAL_GEODESIC_PROCESSING_EXPORT
double polyline_length(const std::vector<Projection>& points);

// Along the arc of a circle between two points that makes the angles with their normals that their
// chord makes in the mean, or around the edge of their tangent planes where the normals differ by more
// than 40 degrees: what a chord cuts short counts.
CGAL_GEODESIC_PROCESSING_EXPORT
double arc_length(const Projection& from, const Projection& to);

// Of a smooth curve through points: the circle through three consecutive ones says by how much an
// arc is longer than its chord.  Where they turn by more than 30 degrees there is a corner.
CGAL_GEODESIC_PROCESSING_EXPORT
double curve_length(const std::vector<Projection>& points);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_CURVE_H
