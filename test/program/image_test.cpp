// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Image.h"

#include "errors.h"

#include <gtest/gtest.h>

namespace {

using program::Colour;
using program::Image;

TEST(Image, is_linear_between_the_middles_of_pixels)
{
  // Two rows of three; the lower one red, from dark to bright.
  const Image image{
      3, 2, {{0., 0., 0.}, {0.5, 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {0., 1., 0.}, {0., 1., 0.}}};
  EXPECT_EQ(image.at(0., 0.), (Colour{0., 0., 0.}));
  EXPECT_EQ(image.at(1., 0.), (Colour{1., 0., 0.}));
  EXPECT_EQ(image.at(0.5, 1.), (Colour{0., 1., 0.}));
  const Colour between = image.at(1. / 3., 0.5);
  EXPECT_NEAR(between[0], 0.125, 1e-15); // rounding
  EXPECT_NEAR(between[1], 0.5, 1e-15);
  // Outside it repeats.
  for(const double shift : {-3., 1., 7.})
    EXPECT_NEAR(image.at(0.25 + shift, 0.25 + shift)[0], image.at(0.25, 0.25)[0], 1e-14);
}

TEST(Image, of_one_pixel_is_plain)
{
  const Image image{1, 1, {{0.2, 0.3, 0.4}}};
  for(const double u : {-1e300, -0.5, 0., 0.3, 1., 1e300})
    EXPECT_EQ(image.at(u, 1. - u), (Colour{0.2, 0.3, 0.4}));
}

} // namespace
