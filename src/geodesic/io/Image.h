// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_IMAGE_H
#define GEODESIC_PROGRAM_IO_IMAGE_H

#include "io/colors.h"

#include <cstddef>
#include <string>
#include <vector>

namespace program {

// An image; rows are stored from bottom to top.
struct Image
{
  std::size_t width = 0, height = 0;
  std::vector<Color> pixels;        // width * height, at least one
  std::vector<double> opacity = {}; // width * height values in [0, 1]; empty: opaque

  // Returns the color by bilinear interpolation between pixel centers. (0, 0) is the lower left
  // corner and (1, 1) is the upper right corner. The image repeats outside of the unit square.
  Color at(double u, double v) const;
  // Returns the color and opacity. Colors are weighted by opacity, so transparent pixels have no
  // effect.
  std::array<double, 4> rgba_at(double u, double v) const;
};

// Throws Usage_error that names the file if the program was built without PNG support.
void check_png_support(const std::string& filename);

// Reads a PNG file. Throws Input_error, or Usage_error without PNG support.
Image read_image(const std::string& filename);

// Returns the image as a PNG file without opacity. `filename` is used in error messages. Throws
// the exceptions of write_image().
std::string to_png(const std::string& filename, const Image& image);

// Writes a PNG file without opacity. Throws Output_error, or Usage_error without PNG support.
void write_image(const std::string& filename, const Image& image);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_IMAGE_H
