// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_BALL_AREA_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_BALL_AREA_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The points of a mesh within a distance of a source.
struct Ball
{
  std::vector<Index> triangles; // those with all corners in the ball
  double area = 0.;             // in squared scaled units
};

// Measures a ball from the distances of the vertices.
//
// In a triangle whose distances are those of a point in its plane, the area is that of the
// intersection with a disk, up to round-off errors. In other triangles, the ball is bounded by the
// chord between the points of two edges at which the isolines of `Edge_interpolation::circular`
// cross them. Such triangles with all corners outside are ignored.
//
// distances: #vertices, in scaled units, may be infinite: triangles with an infinite distance are
// ignored. O(n) for n triangles.
CGAL_GEODESIC_PROCESSING_EXPORT
Ball measure_ball(const Surface_arrays& triangles, const std::vector<double>& distances,
                  double radius);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_BALL_AREA_H
