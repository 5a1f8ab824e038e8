// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_RENDER_MESH_H
#define GEODESIC_PROGRAM_PICTURE_RENDER_MESH_H

#include "readers/Surface_file.h"
#include "io/colors.h"

#include <cstdint>
#include <vector>

namespace program {

// Points and triangles as they are rendered, with one color per point or triangle
struct Render_mesh
{
  std::vector<Point> points;
  std::vector<Point> normals; // if empty, VTK computes them and splits creases
  std::vector<std::uint32_t> corners;
  std::vector<Color> colors; // #points or #triangles
};

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_RENDER_MESH_H
