// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Image.h"

#include "io/Output_file.h"
#include "readers/Scanner.h"
#include "readers/Surface_file.h"
#include "io/errors.h"
#include "readers/read_bytes.h"

#include <algorithm>
#include <cmath>

#ifdef GEODESIC_PROCESSING_HAS_PNG
#  include <png.h>
#endif

namespace program {

namespace {

// The two pixels adjacent to a coordinate in [0, 1], and the weight of the upper one.
struct Interpolation
{
  std::size_t lower, upper;
  double weight;

  Interpolation(double x, std::size_t size)
  {
    if(!(x >= 0. && x <= 1.))
      x -= std::floor(x);
    const double position =
        std::clamp(x * static_cast<double>(size) - 0.5, 0., static_cast<double>(size - 1));
    lower = std::min(static_cast<std::size_t>(position), size - 1);
    upper = std::min(lower + 1, size - 1);
    weight = position - static_cast<double>(lower);
  }
};

// Calls f(pixel, weight) for the four pixels of a bilinear interpolation.
template <typename Function>
void for_each_adjacent_pixel(const Image& image, double u, double v, Function f)
{
  const Interpolation column(u, image.width), row(v, image.height);
  for(const bool is_right : {false, true})
    for(const bool is_upper : {false, true})
      f((is_upper ? row.upper : row.lower) * image.width + (is_right ? column.upper : column.lower),
        (is_right ? column.weight : 1. - column.weight) *
            (is_upper ? row.weight : 1. - row.weight));
}

} // namespace

Color Image::at(double u, double v) const
{
  Color result = {0., 0., 0.};
  for_each_adjacent_pixel(*this, u, v,
                          [&](std::size_t pixel, double weight)
                          {
                            for(std::size_t c = 0; c < 3; ++c)
                              result[c] += weight * pixels[pixel][c];
                          });
  return result;
}

std::array<double, 4> Image::rgba_at(double u, double v) const
{
  std::array<double, 4> result = {0., 0., 0., 0.};
  for_each_adjacent_pixel(*this, u, v,
                          [&](std::size_t pixel, double weight)
                          {
                            const double opaque_weight =
                                opacity.empty() ? weight : weight * opacity[pixel];
                            for(std::size_t c = 0; c < 3; ++c)
                              result[c] += opaque_weight * pixels[pixel][c];
                            result[3] += opaque_weight;
                          });
  if(result[3] > 0.)
    for(std::size_t c = 0; c < 3; ++c)
      result[c] /= result[3];
  return result;
}

#ifdef GEODESIC_PROCESSING_HAS_PNG

void check_png_support(const std::string&) {}

Image read_image(const std::string& filename)
{
  constexpr std::size_t max_number_of_pixels = std::size_t{1} << 25; // less than a gigabyte
  const Bytes file = read_bytes(filename);
  const std::string_view bytes = file;
  if(file_extension(filename) != "png")
    fail(filename, "the extension of an image must be .png");
  const std::string error_message = "it is not a valid PNG image";
  struct Png_reader : png_image
  {
    Png_reader() : png_image() { version = PNG_IMAGE_VERSION; }
    ~Png_reader() { png_image_free(this); }
  } png;
  if(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0)
    fail(filename, error_message);
  Image image;
  image.width = png.width;
  image.height = png.height;
  if(image.width == 0 || image.height == 0)
    fail(filename, error_message);
  if(image.width > max_number_of_pixels / image.height)
    fail(filename, "it has more than 2^25 pixels");
  png.format = PNG_FORMAT_RGBA;
  std::vector<png_byte> values(PNG_IMAGE_SIZE(png));
  if(png_image_finish_read(&png, nullptr, values.data(), 0, nullptr) == 0)
    fail(filename, error_message);
  // Rows are stored from top to bottom in the file. Transparent pixels have a color as well.
  image.pixels.resize(image.width * image.height);
  image.opacity.resize(image.pixels.size());
  for(std::size_t row = 0; row < image.height; ++row)
    for(std::size_t column = 0; column < image.width; ++column)
    {
      const png_byte* const value = &values[4 * (row * image.width + column)];
      const std::size_t pixel = (image.height - 1 - row) * image.width + column;
      for(std::size_t c = 0; c < 3; ++c)
        image.pixels[pixel][c] = value[c] / 255.;
      image.opacity[pixel] = value[3] / 255.;
    }
  return image;
}

std::string to_png(const std::string& filename, const Image& image)
{
  std::vector<png_byte> values;
  values.reserve(3 * image.pixels.size());
  for(std::size_t row = image.height; row-- > 0;)
    for(std::size_t column = 0; column < image.width; ++column)
      for(const double channel : image.pixels[row * image.width + column])
        values.push_back(static_cast<png_byte>(std::lround(255. * std::clamp(channel, 0., 1.))));
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  // The first call computes the size of the encoded file.
  png_alloc_size_t size = 0;
  std::string bytes;
  if(png_image_write_to_memory(&png, nullptr, &size, 0, values.data(), 0, nullptr) != 0)
    bytes.resize(size);
  if(bytes.empty() ||
     png_image_write_to_memory(&png, bytes.data(), &size, 0, values.data(), 0, nullptr) == 0)
    throw Output_error(filename + ": the image cannot be encoded as PNG.");
  bytes.resize(size);
  return bytes;
}

void write_image(const std::string& filename, const Image& image)
{
  write_file(filename, to_png(filename, image));
}

#else

void check_png_support(const std::string& filename)
{
  throw Usage_error(filename +
                    ": images are not supported, because this program was built without libpng.");
}

Image read_image(const std::string& filename)
{
  check_png_support(filename);
  return {};
}

std::string to_png(const std::string& filename, const Image&)
{
  check_png_support(filename);
  return {};
}

void write_image(const std::string& filename, const Image&) { check_png_support(filename); }

#endif

} // namespace program
