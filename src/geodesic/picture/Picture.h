// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_PICTURE_H
#define GEODESIC_PROGRAM_PICTURE_PICTURE_H

#include "io/Image.h"
#include "io/Surface_file.h"

#include <string>
#include <vector>

namespace program {

// What a picture shows; empty arrays are not shown.
struct Picture
{
  const Surface_file* surface = nullptr; // triangles, or points with unit normals
  std::vector<double> values = {};       // #points: colours and lines of equal value
  std::string title = {};                // of the values
  std::vector<long long> labels = {};    // #points: coloured regions, grey where negative
  std::vector<std::vector<Point>> polylines = {};
  std::vector<Point> markers = {};           // sources, seeds, ends of paths
  std::vector<std::uint32_t> triangles = {}; // of a cloud: corners of those that carry its lines
  bool show_edges = false;                   // of a mesh's triangles
  bool show_isolines = true;                 // of equal value; of a narrow ridge they hide it
  bool is_transparent = false;               // a mesh through which lines are seen
  std::vector<std::vector<Point>> thin_polylines = {}; // thinner than polylines
  std::vector<Color> colors = {};                      // #points
  const Image* texture = nullptr;                      // of a mesh, seen through its corner_uv
  std::vector<Point> visible_points = {};              // to be seen, like markers and polylines
  std::vector<Point> normals = {};                     // unit vectors out of the sides to be seen
};

// Draws a PNG file off screen.  A Display must exist.  Throws Output_error.
void draw(const std::string& filename, const Picture& picture);

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_PICTURE_H
