// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_VIEW_H
#define GEODESIC_PROGRAM_PICTURE_VIEW_H

#include "io/Surface_file.h"

#include <vector>

namespace program {

// Where a camera stands.
struct View
{
  Point right, up, back; // orthonormal; the camera looks along -back
  Point center;          // of what it looks at
  double distance = 1.;  // from the center
};

inline constexpr double view_angle = 20.; // degrees, vertical

// A view from which much of the surface and most of the given places are seen, right way up as far
// as that can be told, and which fills a picture of width : height = aspect.
// samples: points spread evenly over the surface, in a box of size about one.
// normals: unit vectors; the camera sees the sides to which they point.
View choose_view(const std::vector<Point>& samples, const std::vector<Point>& visible_points,
                 double aspect, const std::vector<Point>& normals = {});

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_VIEW_H
