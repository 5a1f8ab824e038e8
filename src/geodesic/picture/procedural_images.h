// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_PROCEDURAL_IMAGES_H
#define GEODESIC_PROGRAM_PICTURE_PROCEDURAL_IMAGES_H

#include "io/Image.h"

namespace program {

// Round pictures that the program makes itself.

// Tells where up is: a star of eight rays, the upper one red, in a ring.
Image compass_rose();

// Tells distances from its middle and directions: dark and light cells between twenty rings and
// twenty-four rays.
Image polar_grid();

// Dark and light squares, twenty along each side; and of a place in the unit square, whether its square is dark,
// 1, or light, 0.
Image checkerboard();
int checkerboard_cell(const std::array<double, 2>& uv);

// Of a place from (-1, -1) to (1, 1), whether its cell between so many rings and twenty-four rays is dark, 1,
// or light, 0; -1 outside of the rings.
int polar_grid_cell(double x, double y, int number_of_rings);

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_PROCEDURAL_IMAGES_H
