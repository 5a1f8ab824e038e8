// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a grayscale PNG image of concentric rings, used as a density image.
#include <png.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

int main(int argc, char* argv[])
{
  if(argc != 2)
  {
    std::cerr << "usage: make_test_image RESULT.png\n";
    return EXIT_FAILURE;
  }

  constexpr int size = 200;
  std::vector<png_byte> pixels;
  for(int j = 0; j < size; ++j)
    for(int i = 0; i < size; ++i)
      pixels.push_back(std::fmod(std::hypot(i - size / 2, j - size / 2), 50.) < 25. ? 255 : 0);
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = size;
  image.format = PNG_FORMAT_GRAY;
  return png_image_write_to_file(&image, argv[1], 0, pixels.data(), 0, nullptr) ? EXIT_SUCCESS
                                                                                : EXIT_FAILURE;
}
