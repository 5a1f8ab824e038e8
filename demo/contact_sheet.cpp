// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arranges images of equal size in rows of four, each scaled to half its size.
#include <png.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

struct Picture
{
  std::size_t width = 0, height = 0;
  std::vector<png_byte> pixels; // red, green and blue, row by row

  png_byte& at(std::size_t x, std::size_t y, std::size_t channel)
  {
    return pixels[3 * (y * width + x) + channel];
  }
};

bool read(const char* file, Picture& picture)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if(!png_image_begin_read_from_file(&image, file))
    return false;
  image.format = PNG_FORMAT_RGB;
  picture = {image.width, image.height, std::vector<png_byte>(PNG_IMAGE_SIZE(image))};
  return png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr);
}

bool write(const char* file, const Picture& picture)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = png_uint_32(picture.width);
  image.height = png_uint_32(picture.height);
  image.format = PNG_FORMAT_RGB;
  return png_image_write_to_file(&image, file, 0, picture.pixels.data(), 0, nullptr);
}

int main(int argc, char* argv[])
{
  if(argc < 3)
  {
    std::cerr << "usage: contact_sheet PICTURE.png ... RESULT.png\n";
    return EXIT_FAILURE;
  }

  constexpr std::size_t columns = 4;
  const std::size_t number = std::size_t(argc - 2), rows = (number + columns - 1) / columns;
  Picture result;
  std::size_t width = 0, height = 0;
  for(std::size_t i = 0; i < number; ++i)
  {
    Picture picture;
    if(!read(argv[i + 1], picture))
    {
      std::cerr << argv[i + 1] << " is not a PNG file.\n";
      return EXIT_FAILURE;
    }
    if(i == 0)
    {
      width = picture.width / 2;
      height = picture.height / 2;
      result = {columns * width, rows * height,
                std::vector<png_byte>(3 * columns * width * rows * height, 255)};
    }
    if(picture.width / 2 != width || picture.height / 2 != height)
    {
      std::cerr << argv[i + 1] << " and " << argv[1] << " have different sizes.\n";
      return EXIT_FAILURE;
    }
    for(std::size_t y = 0; y < height; ++y)
      for(std::size_t x = 0; x < width; ++x)
        for(std::size_t c = 0; c < 3; ++c)
        {
          const int sum = picture.at(2 * x, 2 * y, c) + picture.at(2 * x + 1, 2 * y, c) +
                          picture.at(2 * x, 2 * y + 1, c) + picture.at(2 * x + 1, 2 * y + 1, c);
          result.at(i % columns * width + x, i / columns * height + y, c) = png_byte(sum / 4);
        }
  }
  std::cout << number << " pictures arranged.\n";
  return write(argv[argc - 1], result) ? EXIT_SUCCESS : EXIT_FAILURE;
}
