// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/parameterization/texels.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace CGAL::Geodesic_processing::internal;

TEST(texels, show_the_triangle_around_their_middle)
{
  // Two triangles of a square from 2 to 6 texels in 8.
  const std::vector<Planar> corners = {{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75},
                                       {0.25, 0.25}, {0.75, 0.75}, {0.25, 0.75}};
  const Texels texels = find_texels(corners, 8, 1.);
  for(std::size_t j = 0; j < 8; ++j)
    for(std::size_t i = 0; i < 8; ++i)
    {
      const bool is_inside = i >= 2 && i < 6 && j >= 2 && j < 6;
      const std::size_t texel = 8 * j + i;
      if(is_inside)
      {
        EXPECT_EQ(texels.square[texel], 0.);
        const Index expected = i > j   ? 0
                               : i < j ? 1
                                       : texels.triangle[texel]; // both at the diagonal
        EXPECT_EQ(texels.triangle[texel], expected);
      }
      else if(i >= 1 && i < 7 && j >= 1 && j < 7)
      {
        // Half a texel from a side, or the diagonal of that from a corner.
        EXPECT_NE(texels.triangle[texel], none);
        const bool is_corner = (i == 1 || i == 6) && (j == 1 || j == 6);
        EXPECT_NEAR(texels.square[texel], is_corner ? 0.5 : 0.25, 1e-14);
      }
      else
        EXPECT_EQ(texels.triangle[texel], none);
    }
}

TEST(texels, nearest_place_of_a_triangle)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for(int trial = 0; trial < 200; ++trial)
  {
    std::array<Planar, 3> image;
    for(Planar& p : image)
      p = {uniform(random), uniform(random)};
    if(cross(image[1] - image[0], image[2] - image[0]) < 0.1)
      continue;
    const Planar place = {2. * uniform(random), 2. * uniform(random)};
    const auto b = nearest_barycentric(image, place);
    const double found = norm(b[0] * image[0] + b[1] * image[1] + b[2] * image[2] - place);
    EXPECT_NEAR(b[0] + b[1] + b[2], 1., 1e-13);
    // No place of a grid on the triangle is nearer.
    for(int i = 0; i <= 20; ++i)
      for(int j = 0; i + j <= 20; ++j)
        EXPECT_LE(found, norm((i / 20.) * image[0] + (j / 20.) * image[1] +
                              ((20 - i - j) / 20.) * image[2] - place) +
                             1e-13);
  }
}

TEST(texels, limits_of_the_size)
{
  using CGAL::Geodesic_processing::Invalid_argument_error;
  EXPECT_THROW(find_texels({}, 0, 1.), Invalid_argument_error);
  EXPECT_THROW(find_texels({}, 16385, 1.), Invalid_argument_error);
  EXPECT_EQ(find_texels({}, 1, 1.).triangle, std::vector<Index>(1, none));
}

} // namespace
