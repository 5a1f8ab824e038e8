// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Image.h"

#include "picture/procedural_images.h"
#include "io/errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace image_test {

using program::Color;
using program::Image;

TEST(Image, interpolates_bilinearly)
{
  // Two rows of three pixels. The lower row is red, from dark to bright.
  const Image image{
      3, 2, {{0., 0., 0.}, {0.5, 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {0., 1., 0.}, {0., 1., 0.}}};
  EXPECT_EQ(image.at(0., 0.), (Color{0., 0., 0.}));
  EXPECT_EQ(image.at(1., 0.), (Color{1., 0., 0.}));
  EXPECT_EQ(image.at(0.5, 1.), (Color{0., 1., 0.}));
  const Color between = image.at(1. / 3., 0.5);
  EXPECT_NEAR(between[0], 0.125, 1e-15); // round-off errors
  EXPECT_NEAR(between[1], 0.5, 1e-15);   // round-off error
  // Outside the unit square, the image repeats.
  for(const double shift : {-3., 1., 7.})
    EXPECT_NEAR(image.at(0.25 + shift, 0.25 + shift)[0], image.at(0.25, 0.25)[0], 1e-14);
}

TEST(Image, single_pixel_is_constant)
{
  const Image image{1, 1, {{0.2, 0.3, 0.4}}};
  for(const double u : {-1e300, -0.5, 0., 0.3, 1., 1e300})
    EXPECT_EQ(image.at(u, 1. - u), (Color{0.2, 0.3, 0.4}));
}

TEST(Image, transparent_pixels_do_not_bleed)
{
  const Image image{2, 1, {{1., 0., 0.}, {0., 1., 0.}}, {1., 0.}};
  const auto middle = image.rgba_at(0.5, 0.5);
  EXPECT_EQ(middle, (std::array<double, 4>{1., 0., 0., 0.5}));
  EXPECT_EQ(image.rgba_at(1., 0.5)[3], 0.);
  // An image without opacities is opaque.
  const Image opaque{2, 1, {{1., 0., 0.}, {0., 1., 0.}}};
  EXPECT_EQ(opaque.rgba_at(0.5, 0.5), (std::array<double, 4>{0.5, 0.5, 0., 1.}));
}

#ifdef GEODESIC_PROCESSING_HAS_PNG
TEST(Image, round_trip_preserves_pixels)
{
  const Image image{
      3,
      2,
      {{0., 0., 0.}, {0.2, 0.4, 0.6}, {1., 1., 1.}, {1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};
  const std::string name = testing::TempDir() + "image_test.png";
  program::write_image(name, image);
  const Image again = program::read_image(name);
  std::remove(name.c_str());
  EXPECT_EQ(again.width, 3u);
  EXPECT_EQ(again.height, 2u);
  ASSERT_EQ(again.pixels.size(), 6u);
  for(std::size_t i = 0; i < 6; ++i)
    for(std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(again.pixels[i][c], image.pixels[i][c], 1e-15); // multiples of 1/255
  EXPECT_EQ(again.opacity, std::vector<double>(6, 1.));
}
#endif

TEST(Image, polar_grid_alternates)
{
  EXPECT_EQ(program::polar_grid_cell(1., 0.1, 20), -1);
  EXPECT_EQ(program::polar_grid_cell(std::nan(""), 0., 20), -1);
  // Cells alternate across a ring and across a ray.
  const double angle = std::acos(-1.) / 24.;
  const int cell = program::polar_grid_cell(0.525 * std::cos(angle), 0.525 * std::sin(angle), 20);
  EXPECT_EQ(program::polar_grid_cell(0.575 * std::cos(angle), 0.575 * std::sin(angle), 20),
            1 - cell);
  EXPECT_EQ(program::polar_grid_cell(0.525 * std::cos(angle), -0.525 * std::sin(angle), 20),
            1 - cell);
  const Image grid = program::polar_grid();
  EXPECT_EQ(grid.pixels.size(), grid.width * grid.height);
  EXPECT_EQ(grid.opacity.front(), 0.);
  const auto color = [&](double x, double y) { return grid.at(0.5 + 0.5 * x, 0.5 + 0.5 * y); };
  const double c = std::cos(angle), s = std::sin(angle);
  EXPECT_GT(std::abs(color(0.525 * c, 0.525 * s)[0] - color(0.575 * c, 0.575 * s)[0]), 0.5);
  const Color here = color(0.525 * c, 0.525 * s), there = color(0.575 * c, -0.575 * s);
  // Equal up to round-off errors.
  for(std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(here[k], there[k], 1e-12);
}

TEST(Image, compass_rose_is_round_and_points_up)
{
  const Image rose = program::compass_rose();
  const auto above = rose.at(0.51, 0.75), below = rose.at(0.49, 0.25);
  EXPECT_GT(above[0], above[2] + 0.5);
  EXPECT_LT(below[0], below[2]);
  EXPECT_EQ(rose.rgba_at(0.01, 0.01)[3], 0.);
  EXPECT_EQ(rose.rgba_at(0.5, 0.5)[3], 1.);
}

} // namespace image_test
