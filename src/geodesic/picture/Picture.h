// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_PICTURE_H
#define GEODESIC_PROGRAM_PICTURE_PICTURE_H

#include "io/Image.h"
#include "readers/Surface_file.h"

#include <string>
#include <vector>

namespace program {

// Content of a picture. Empty arrays are not drawn.
struct Picture
{
  const Surface_file* surface = nullptr; // triangles, or points with unit normals
  std::vector<double> values = {};       // #points: colors and isolines
  std::string title = {};                // of the color bar
  std::vector<long long> labels = {};    // #points: colored regions, gray if negative
  std::vector<std::vector<Point>> polylines = {};
  std::vector<Point> markers = {};           // sources, seeds, path endpoints
  std::vector<std::uint32_t> triangles = {}; // of a cloud: triangles that carry its lines
  bool show_edges = false;                   // edges of a mesh's triangles
  bool show_isolines = true;   // isolines of `values`; false if they hide narrow ridges
  bool is_transparent = false; // whether lines behind the mesh are visible
  std::vector<std::vector<Point>> thin_polylines = {}; // thinner than `polylines`
  std::vector<Color> colors = {};                      // #points
  const Image* texture = nullptr;                      // of a mesh, with its corner_uv
  std::vector<Point> visible_points = {}; // preferred to be visible, like markers and polylines
  std::vector<Point> normals = {}; // unit vectors; the camera prefers sides that they point to
};

// Renders a PNG file off screen. Requires an existing Display. Throws Output_error.
void draw(const std::string& filename, const Picture& picture);

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_PICTURE_H
