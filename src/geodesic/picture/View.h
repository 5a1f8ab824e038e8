// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_VIEW_H
#define GEODESIC_PROGRAM_PICTURE_VIEW_H

#include "readers/Surface_file.h"

#include <cstdint>
#include <vector>

namespace program {

// Position and orientation of a camera
struct View
{
  Point right, up, back; // orthonormal; the camera looks along -back
  Point center;          // the point that the camera looks at
  double distance = 1.;  // from `center`
};

inline constexpr double view_angle = 20.; // degrees, vertical

// Returns points distributed over the triangles, or all points if there are no triangles. The
// result is deterministic.
std::vector<Point> sample_points(const std::vector<Point>& points,
                                 const std::vector<std::uint32_t>& corners);

// Returns a view that shows much of the surface and many of the given points. The up direction is
// estimated from the bounding box. The surface fills an image whose width : height equals
// `aspect`.
// samples: points that cover the surface uniformly, in a box of about unit size.
// visible_points: points that the view should show.
// normals: unit vectors; views that face them are preferred.
View choose_view(const std::vector<Point>& samples, const std::vector<Point>& visible_points,
                 double aspect, const std::vector<Point>& normals = {});

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_VIEW_H
