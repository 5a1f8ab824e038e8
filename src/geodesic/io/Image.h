// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_IMAGE_H
#define GEODESIC_PROGRAM_IO_IMAGE_H

#include "io/colors.h"

#include <cstddef>
#include <string>
#include <vector>

namespace program {

// Rows of pixels from the lowest one up.
struct Image
{
  std::size_t width = 0, height = 0;
  std::vector<Color> pixels;        // width * height, at least one
  std::vector<double> opacity = {}; // the same number in [0, 1], or none: all are opaque

  // Between the middles of four pixels; (0, 0) is the lower left corner and (1, 1) the upper right
  // one.  Outside the image repeats.
  Color at(double u, double v) const;
  // With its opacity; what is transparent lends nothing of its colour.
  std::array<double, 4> rgba_at(double u, double v) const;
};

// Throws Usage_error where PNG files can be neither read nor written: this is not built in.
void check_png_support(const std::string& filename);

// Reads a PNG file.  Throws Input_error, and Usage_error where this is not built in.
Image read_image(const std::string& filename);

// The bytes of a PNG file without opacity; `filename` stands for it in sentences.  Throws as write_image().
std::string to_png(const std::string& filename, const Image& image);

// Writes a PNG file without opacity.  Throws Output_error, and Usage_error where this is not built in.
void write_image(const std::string& filename, const Image& image);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_IMAGE_H
