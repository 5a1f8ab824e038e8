// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/untangling.h>

#include <CGAL/Geodesic_processing/internal/parameterization/symmetric_dirichlet.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace untangling_test {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;

// Returns the positions of the points, seen from above.
std::vector<Vec2> planar_image(const Array_surface& surface, double scale = 1.)
{
  std::vector<Vec2> image(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
    image[surface.vertex(i)] = {scale * surface.point(i)[0], scale * surface.point(i)[1]};
  return image;
}

double largest_move(const std::vector<Vec2>& a, const std::vector<Vec2>& b)
{
  double result = 0.;
  for(std::size_t i = 0; i < a.size(); ++i)
    result = std::max(result, norm(a[i] - b[i]));
  return result;
}

// Newton's method ends if a step decreases the energy by less than 1e-4. A triangle stretched by e
// adds 8 e^2. So the last step stretches no triangle of a region of a hundred by more than about
// one hundredth. Displacements are relative to the length of an edge.
constexpr double edge_length_tolerance = 0.05;

TEST(untangling, restores_displaced_vertex_of_planar_map)
{
  constexpr Index n = 40;
  for(const double scale : {1e-6, 1., 1e6})
    for(const Index moved : {20 * (n + 1) + 20, n + 2, 20 * (n + 1) + 1, Index(20)})
    {
      const Array_surface surface(square(n, 0.25));
      const std::vector<Vec2> expected = planar_image(surface, scale);
      std::vector<Vec2> image = expected;
      Vec2& p = image[surface.vertex(moved)];
      p = p + scale / double(n) * Vec2{2.6, 1.7};
      ASSERT_GT(number_of_flips(surface.t(), image), 0u);
      untangle(surface.t(), image);
      EXPECT_EQ(number_of_flips(surface.t(), image), 0u) << moved;
      EXPECT_LT(largest_move(image, expected), edge_length_tolerance * scale / double(n)) << moved;
    }
}

TEST(untangling, changes_only_neighborhood_of_flips)
{
  constexpr std::size_t n = 60;
  const Array_surface surface(square(n, 0.25));
  std::vector<Vec2> image = planar_image(surface);
  for(Vec2& p : image)
    p = {p[0] + 0.1 * p[1] * p[1], 0.8 * p[1]}; // a distorted map
  std::vector<Vec2> before = image;
  untangle(surface.t(), image);
  EXPECT_EQ(image, before);

  const Index moved = Index(30 * (n + 1) + 30);
  image[surface.vertex(moved)][0] += 2.5 / double(n);
  untangle(surface.t(), image);
  EXPECT_EQ(number_of_flips(surface.t(), image), 0u);
  // Squares of as many rings around the moved vertex as can be moved.
  for(Index i = 0; i < surface.size(); ++i)
  {
    const int column = int(i % (n + 1)), row = int(i / (n + 1));
    const bool is_far = std::max(std::abs(column - 30), std::abs(row - 30)) > 10;
    EXPECT_TRUE(!is_far || image[surface.vertex(i)] == before[surface.vertex(i)]);
  }
}

TEST(untangling, limits_total_number_of_moved_triangles)
{
  // 49 regions of more than 100 triangles each; each of the two passes moves at most 3,000
  // triangles.
  constexpr std::size_t n = 160, spacing = 20, max_moved = 2 * 3000;
  const Array_surface surface(square(n, 0.25));
  std::vector<Vec2> image = planar_image(surface);
  for(std::size_t row = spacing; row < n; row += spacing)
    for(std::size_t column = spacing; column < n; column += spacing)
      image[surface.vertex(Index(row * (n + 1) + column))][0] += 2.5 / double(n);
  const std::vector<Vec2> before = image;
  untangle(surface.t(), image);
  EXPECT_GT(number_of_flips(surface.t(), image), 0u);
  EXPECT_LT(number_of_flips(surface.t(), image), number_of_flips(surface.t(), before));
  std::size_t moved = 0;
  for(std::size_t c = 0; c < surface.t().corner.size(); c += 3)
    moved += std::any_of(surface.t().corner.begin() + c, surface.t().corner.begin() + c + 3,
                         [&](Index vertex) { return image[vertex] != before[vertex]; });
  EXPECT_LE(moved, max_moved);
}

TEST(untangling, never_adds_flips)
{
  std::mt19937 random(7);
  const Array_surface surface(square(30, 0.25));
  std::size_t solved = 0;
  for(const double amount : {0.02, 0.05, 0.1, 0.3, 1.})
    for(int round = 0; round < 3; ++round)
    {
      std::vector<Vec2> image = planar_image(surface);
      std::uniform_real_distribution<double> offset(-amount, amount);
      for(int k = 0; k < 5; ++k)
      {
        Vec2& p = image[random() % image.size()];
        p = p + Vec2{offset(random), offset(random)};
      }
      const std::size_t before = number_of_flips(surface.t(), image);
      untangle(surface.t(), image);
      const std::size_t after = number_of_flips(surface.t(), image);
      EXPECT_LE(after, before);
      solved += after == 0;
    }
  EXPECT_GE(solved, 12u); // of 15
}

// An interior vertex with a total angle of 4 pi has a map without inverted triangles that winds
// around it twice.
TEST(untangling, does_not_accept_double_winding)
{
  constexpr std::size_t n = 24, rings = 14;
  const Array_surface surface(cone(n, rings, 4. * pi));
  std::vector<Vec2> image(surface.size());
  for(Index i = 1; i < surface.size(); ++i)
  {
    const double angle = 4. * pi * double((i - 1) % n) / double(n),
                 radius = double((i - 1) / n + 1);
    image[surface.vertex(i)] = {radius * std::cos(angle), radius * std::sin(angle)};
  }
  image[surface.vertex(0)] = {0., 0.};
  EXPECT_EQ(number_of_flips(surface.t(), image), 0u);
  image[surface.vertex(1 + 2 * n)][1] += 2.;
  ASSERT_GT(number_of_flips(surface.t(), image), 0u);
  const std::vector<Vec2> before = image;
  untangle(surface.t(), image);
  EXPECT_EQ(image, before);
}

TEST(untangling, handles_degenerate_maps)
{
  const Array_surface surface(square(8));
  for(const Vec2& factor : {Vec2{0., 0.}, Vec2{1., 0.}, Vec2{1e200, -1e200}, Vec2{1e-200, -1e-200}})
  {
    std::vector<Vec2> image = planar_image(surface);
    for(Vec2& p : image)
      p = {factor[0] * p[0], factor[1] * p[1]};
    const std::size_t before = number_of_flips(surface.t(), image);
    EXPECT_GT(before, 0u);
    untangle(surface.t(), image);
    EXPECT_LE(number_of_flips(surface.t(), image), before);
    for(const Vec2& p : image)
      EXPECT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]));
  }
}

TEST(untangling, orients_positively)
{
  const Array_surface surface(square(5));
  const std::vector<Vec2> expected = planar_image(surface);
  std::vector<Vec2> image = expected;
  orient_positively(surface.t(), image);
  EXPECT_EQ(image, expected);
  for(Vec2& p : image)
    p[1] = -p[1];
  orient_positively(surface.t(), image);
  EXPECT_EQ(image, expected);
}

} // namespace untangling_test
