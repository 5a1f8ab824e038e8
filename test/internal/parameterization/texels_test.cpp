// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/parameterization/texels.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace texels_test {

using namespace CGAL::Geodesic_processing::internal;

TEST(texels, texel_center_selects_triangle)
{
  // Two triangles that form a square from 2 to 6 of 8 texels.
  const std::vector<Vec2> corners = {{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75},
                                     {0.25, 0.25}, {0.75, 0.75}, {0.25, 0.75}};
  const Texel_map texels = rasterize_texels(corners, 8, 1.);
  for(std::size_t j = 0; j < 8; ++j)
    for(std::size_t i = 0; i < 8; ++i)
    {
      const bool is_inside = i >= 2 && i < 6 && j >= 2 && j < 6;
      const std::size_t texel = 8 * j + i;
      if(is_inside)
      {
        EXPECT_EQ(texels.squared_distance[texel], 0.);
        const Index expected = i > j   ? 0
                               : i < j ? 1
                                       // on the common edge both are valid
                                       : texels.triangle[texel];
        EXPECT_EQ(texels.triangle[texel], expected);
      }
      else if(i >= 1 && i < 7 && j >= 1 && j < 7)
      {
        // Half a texel from an edge, or the diagonal of half a texel from a corner.
        EXPECT_NE(texels.triangle[texel], none);
        const bool is_corner = (i == 1 || i == 6) && (j == 1 || j == 6);
        // Round-off errors of numbers below 8.
        EXPECT_NEAR(texels.squared_distance[texel], is_corner ? 0.5 : 0.25, 1e-14);
      }
      else
        EXPECT_EQ(texels.triangle[texel], none);
    }
}

TEST(texels, nearest_barycentric_is_closest_point)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for(int trial = 0; trial < 200; ++trial)
  {
    std::array<Vec2, 3> image;
    for(Vec2& p : image)
      p = {uniform(random), uniform(random)};
    if(cross(image[1] - image[0], image[2] - image[0]) < 0.1)
      continue;
    const Vec2 point = {2. * uniform(random), 2. * uniform(random)};
    const auto b = nearest_barycentric(image, point);
    const double found = norm(b[0] * image[0] + b[1] * image[1] + b[2] * image[2] - point);
    EXPECT_NEAR(b[0] + b[1] + b[2], 1., 1e-13); // two additions
    // No point of a grid on the triangle is closer.
    for(int i = 0; i <= 20; ++i)
      for(int j = 0; i + j <= 20; ++j)
        // A few round-off errors.
        EXPECT_LE(found, norm((i / 20.) * image[0] + (j / 20.) * image[1] +
                              ((20 - i - j) / 20.) * image[2] - point) +
                             1e-13);
  }
}

TEST(texels, throws_on_invalid_size)
{
  using CGAL::Geodesic_processing::Invalid_argument_error;
  EXPECT_THROW(rasterize_texels({}, 0, 1.), Invalid_argument_error);
  EXPECT_THROW(rasterize_texels({}, 16385, 1.), Invalid_argument_error);
  EXPECT_EQ(rasterize_texels({}, 1, 1.).triangle, std::vector<Index>(1, none));
}

} // namespace texels_test
