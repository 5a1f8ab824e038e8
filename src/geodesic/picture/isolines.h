// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_ISOLINES_H
#define GEODESIC_PROGRAM_PICTURE_ISOLINES_H

#include "picture/actors.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace program {

struct Value_range
{
  double low = INFINITY, high = -INFINITY;
  bool empty() const { return !(low < high); }
};

Value_range finite_range(const std::vector<double>& values);

// Adds isolines on the triangles whose three values are finite.
vtkActor* add_isolines(vtkRenderer* renderer, const std::vector<Point>& points,
                       const std::vector<std::uint32_t>& corners, const std::vector<double>& values,
                       const Value_range& range);

void add_color_bar(vtkRenderer* renderer, const Value_range& range, const std::string& title);

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_ISOLINES_H
