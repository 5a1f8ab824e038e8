// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_PROCEDURAL_IMAGES_H
#define GEODESIC_PROGRAM_PICTURE_PROCEDURAL_IMAGES_H

#include "io/Image.h"

namespace program {

// Circular images and a checkerboard that the program generates

// Returns a compass rose with eight rays in a ring. It shows orientation: the upper ray is red.
Image compass_rose();

// Returns a polar grid that shows distances from the center and directions. It has dark and light
// cells between 20 circles and 24 rays.
Image polar_grid();

// Returns a checkerboard with 20 squares along each side. checkerboard_cell() returns 1 if the
// square at `uv` in the unit square is dark, or 0 if it is light.
Image checkerboard();
int checkerboard_cell(const std::array<double, 2>& uv);

// Returns the cell color of a polar grid at (x, y) in [-1, 1]^2, with number_of_rings circles and
// 24 rays. The value is 1 (dark), 0 (light), or -1 outside of the grid.
int polar_grid_cell(double x, double y, int number_of_rings);

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_PROCEDURAL_IMAGES_H
