// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_WRITE_SVG_H
#define GEODESIC_PROGRAM_IO_WRITE_SVG_H

#include <array>
#include <string>
#include <vector>

namespace program {

// A polyline in the plane. The last point of a closed one equals the first.
struct Planar_line
{
  std::vector<std::array<double, 2>> points;
  bool is_closed = false;
  double value = 0.;
};

// Returns an SVG image of lines in the plane, and of the boundary of the region that contains them.
// Coordinates keep their unit; the second axis points up in the image. Each line is a path with its
// value as the attribute "data-value".
std::string to_svg(const std::vector<Planar_line>& lines,
                   const std::vector<std::array<double, 2>>& boundary);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_WRITE_SVG_H
