// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Image.h"

#include "Scanner.h"
#include "Surface_file.h"
#include "errors.h"
#include "read_bytes.h"

#include <algorithm>
#include <cmath>

#ifdef GEODESIC_PROCESSING_HAS_PNG
#  include <png.h>
#endif

namespace program {

namespace {

// The two pixels around a coordinate in [0, 1], and the share of the second one.
struct Between
{
  std::size_t first, second;
  double share;

  Between(double x, std::size_t size)
  {
    if(!(x >= 0. && x <= 1.))
      x -= std::floor(x);
    const double place =
        std::clamp(x * static_cast<double>(size) - 0.5, 0., static_cast<double>(size - 1));
    first = std::min(static_cast<std::size_t>(place), size - 1);
    second = std::min(first + 1, size - 1);
    share = place - static_cast<double>(first);
  }
};

} // namespace

Colour Image::at(double u, double v) const
{
  const Between column(u, width), row(v, height);
  Colour result = {0., 0., 0.};
  for(const bool right : {false, true})
    for(const bool up : {false, true})
    {
      const double share =
          (right ? column.share : 1. - column.share) * (up ? row.share : 1. - row.share);
      const Colour& pixel =
          pixels[(up ? row.second : row.first) * width + (right ? column.second : column.first)];
      for(std::size_t c = 0; c < 3; ++c)
        result[c] += share * pixel[c];
    }
  return result;
}

#ifdef GEODESIC_PROCESSING_HAS_PNG

Image read_image(const std::string& filename)
{
  constexpr std::size_t most_pixels = std::size_t{1} << 25; // less than a gigabyte
  const std::string bytes = read_bytes(filename);
  if(ending(filename) != "png")
    fail(filename, "the name of an image ends with .png");
  const std::string complaint = "it cannot be read as an image";
  struct Reader : png_image
  {
    Reader() : png_image() { version = PNG_IMAGE_VERSION; }
    ~Reader() { png_image_free(this); }
  } png;
  if(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0)
    fail(filename, complaint);
  Image image;
  image.width = png.width;
  image.height = png.height;
  if(image.width == 0 || image.height == 0)
    fail(filename, complaint);
  if(image.width > most_pixels / image.height)
    fail(filename, "it has more than 2^25 pixels");
  png.format = PNG_FORMAT_RGBA;
  std::vector<png_byte> values(PNG_IMAGE_SIZE(png));
  if(png_image_finish_read(&png, nullptr, values.data(), 0, nullptr) == 0)
    fail(filename, complaint);
  // The file begins with the highest row; what is transparent has a colour as well.
  image.pixels.resize(image.width * image.height);
  for(std::size_t row = 0; row < image.height; ++row)
    for(std::size_t column = 0; column < image.width; ++column)
      for(std::size_t c = 0; c < 3; ++c)
        image.pixels[(image.height - 1 - row) * image.width + column][c] =
            values[4 * (row * image.width + column) + c] / 255.;
  return image;
}

#else

Image read_image(const std::string& filename)
{
  throw Usage_error(filename + ": this program was built without libpng, which reads images.");
}

#endif

} // namespace program
