// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/fitting.h"

#include "Glued_surface.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Two triangles over the unit square, whose corners are the cells 0 to 3, and the cell of each site:
// the nearest corner.
struct Over_square
{
  Glued_surface fine;
  Coarse_mesh coarse;
  std::vector<Index> labels;

  explicit Over_square(const Triangulation& surface) : fine(surface)
  {
    const Glued_triangles& t = fine.t();
    const auto scaled = [&](const Point& p) { return (1. / t.scale) * (p - t.origin); };
    coarse.points = {scaled({0., 0., 0.}), scaled({1., 0., 0.}), scaled({0., 1., 0.}),
                     scaled({1., 1., 0.})};
    coarse.triangles = {{0, 1, 3}, {0, 3, 2}};
    for(Index site = 0; site < t.number_of_sites(); ++site)
    {
      const Point p = t.origin + t.scale * t.point[site];
      labels.push_back((p[0] > 0.5 ? 1 : 0) + (p[1] > 0.5 ? 2 : 0));
    }
  }
};

TEST(Fitting, leaves_what_is_on_the_surface)
{
  Over_square over(square(10));
  const std::vector<Spatial> before = over.coarse.points;
  // Roundings of numbers below two.
  EXPECT_TRUE(far_sites(over.fine.t(), over.labels, over.coarse, 1e-14).empty());
  fit(over.fine.t(), over.labels, std::vector<bool>(4, false), over.coarse);
  for(std::size_t i = 0; i < 4; ++i)
    EXPECT_LT(norm(over.coarse.points[i] - before[i]), 1e-14);
}

TEST(Fitting, moves_points_to_a_surface_above_them)
{
  Triangulation high = square(10);
  for(Point& p : high.points)
    p[2] = 0.1;
  Over_square over(high);
  const double scale = over.fine.scale();
  // One for each cell, as all are as far.
  EXPECT_EQ(far_sites(over.fine.t(), over.labels, over.coarse, 0.09 / scale).size(), 4u);
  EXPECT_TRUE(far_sites(over.fine.t(), over.labels, over.coarse, 0.11 / scale).empty());
  Over_square held = over;
  fit(over.fine.t(), over.labels, std::vector<bool>(4, false), over.coarse);
  fit(held.fine.t(), held.labels, {true, false, false, false}, held.coarse);
  const Spatial first = held.coarse.points[0];
  for(std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(scale * (over.coarse.points[i][2] - first[2]), 0.1, 1e-14); // rounding
  for(std::size_t i = 1; i < 4; ++i)
    EXPECT_GT(scale * (held.coarse.points[i][2] - first[2]), 0.1); // for what is held

  Over_square near(high);
  fit(near.fine.t(), near.labels, std::vector<bool>(4, false), near.coarse, 0.04 / scale);
  for(std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(scale * (near.coarse.points[i][2] - first[2]), 0.04, 1e-14); // rounding
}

TEST(Fitting, finds_the_farthest_site_of_a_cell)
{
  // A bump at one vertex.
  Triangulation bump = square(10);
  bump.points[3 * 11 + 8][2] = 0.3;
  bump.points[3 * 11 + 7][2] = 0.2;
  Over_square over(bump);
  const double scale = over.fine.scale();
  EXPECT_EQ(far_sites(over.fine.t(), over.labels, over.coarse, 0.1 / scale),
            std::vector<Index>{over.fine.site(3 * 11 + 8)});
  over.labels[over.fine.site(3 * 11 + 8)] = none;
  EXPECT_EQ(far_sites(over.fine.t(), over.labels, over.coarse, 0.1 / scale),
            std::vector<Index>{over.fine.site(3 * 11 + 7)});
}

TEST(Fitting, takes_no_more_from_small_angles_with_care)
{
  // A wavy square of 40 by 40 over one of 8 by 8 whose points are moved at random.
  constexpr std::size_t n = 40, m = 8;
  const auto wave = [](double x, double y) -> Point {
    return {x, y, 0.08 * std::sin(9. * x) * std::cos(7. * y)};
  };
  const Glued_surface fine(grid(n, n, wave));
  const double scale = fine.scale();
  const Triangulation places = square(m, 0.25);
  Coarse_mesh coarse;
  for(const Point& p : places.points)
    coarse.points.push_back((1. / scale) * (wave(p[0], p[1]) - fine.t().origin));
  for(std::size_t c = 0; c < places.corners.size(); c += 3)
    coarse.triangles.push_back({places.corners[c], places.corners[c + 1], places.corners[c + 2]});
  std::vector<Index> labels;
  for(const Spatial& p : fine.t().point)
  {
    const auto near = [&](const Spatial& a, const Spatial& b) { return norm(a - p) < norm(b - p); };
    labels.push_back(Index(std::min_element(coarse.points.begin(), coarse.points.end(), near) -
                           coarse.points.begin()));
  }
  const std::vector<bool> is_fixed(coarse.points.size(), false);
  Coarse_mesh with_care = coarse;
  fit(fine.t(), labels, is_fixed, coarse);
  fit(fine.t(), labels, is_fixed, with_care, infinity, 5);
  std::size_t moved = 0;
  for(std::size_t i = 0; i < coarse.points.size(); ++i)
    moved += norm(with_care.points[i] - coarse.points[i]) > 0.;
  EXPECT_GT(moved, 0u);
  EXPECT_LT(moved, coarse.points.size()); // some triangles have had small angles
  const double small = std::cos(42. * pi / 180.);
  for(const auto& [a, b, c] : coarse.triangles)
    // The constant has three digits.
    EXPECT_LE(
        largest_cosine(with_care.points[a], with_care.points[b], with_care.points[c]),
        std::max(small, largest_cosine(coarse.points[a], coarse.points[b], coarse.points[c])) +
            1e-3);
  const auto sum_of_squares = [&](const Coarse_mesh& mesh)
  {
    double sum = 0.;
    for(const Spatial& p : fine.t().point)
    {
      double least = infinity;
      for(const auto& [a, b, c] : mesh.triangles)
      {
        const std::array<Spatial, 3> corners = {mesh.points[a], mesh.points[b], mesh.points[c]};
        const auto at = nearest_in_triangle(corners[0], corners[1], corners[2], p);
        const Spatial way = at[0] * corners[0] + at[1] * corners[1] + at[2] * corners[2] - p;
        least = std::min(least, dot(way, way));
      }
      sum += least;
    }
    return sum;
  };
  EXPECT_LT(sum_of_squares(with_care), sum_of_squares(coarse));
}

} // namespace
