// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/feature_polylines.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace feature_polylines_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Samples feature edges with a spacing per halfedge in the unit of the caller.
std::vector<Point> sample(const Array_surface& surface, std::vector<double> spacing)
{
  for(double& s : spacing)
    s /= surface.scale();
  std::vector<Point> result;
  for(const Surface_location& location : sample_feature_polylines(surface.t(), spacing))
    result.push_back(coordinates(surface.t(), location));
  return result;
}

std::vector<Point> sample(const Array_surface& surface, double spacing,
                          const std::vector<bool>& is_curve)
{
  std::vector<double> spacings;
  for(const bool is_on_curve : is_curve)
    spacings.push_back(is_on_curve ? spacing : 0.);
  return sample(surface, std::move(spacings));
}

std::vector<Point> sample_boundary(const Array_surface& surface, double spacing)
{
  return sample(surface, spacing, boundary_and_sharp_halfedges(surface.t()));
}

bool contains(const std::vector<Point>& points, const Point& p)
{
  // Round-off errors of numbers up to one.
  return std::any_of(points.begin(), points.end(),
                     [&](const Point& q) { return distance(p, q) < 1e-14; });
}

TEST(Feature_polylines, square_boundary_keeps_corners)
{
  const Array_surface surface(square(20, 0.2));
  for(const auto& [spacing, number] :
      std::vector<std::pair<double, std::size_t>>{{0.07, 56}, {0.25, 16}, {0.3, 12}, {0.9, 4}})
  {
    const std::vector<Point> samples = sample_boundary(surface, spacing);
    EXPECT_EQ(samples.size(), number);
    for(std::size_t i = 0; i <= number / 4; ++i)
    {
      const double x = double(i) / double(number / 4);
      EXPECT_TRUE(contains(samples, {x, 0., 0.}) && contains(samples, {0., x, 0.}));
      EXPECT_TRUE(contains(samples, {x, 1., 0.}) && contains(samples, {1., x, 0.}));
    }
  }
  // The spacing is too large for more than one corner, the sharpest; a closed polyline gets two
  // more samples.
  EXPECT_EQ(sample_boundary(surface, 10.).size(), 3u);
}

TEST(Feature_polylines, cylinder_has_two_boundary_loops)
{
  const Array_surface surface(cylinder(48, 10, 1., 1.));
  for(const double spacing : {0.1, 0.5, 100.})
  {
    std::size_t number_at_bottom = 0;
    const std::vector<Point> samples = sample_boundary(surface, spacing);
    for(const Point& p : samples)
    {
      EXPECT_TRUE(p[2] == 0. || p[2] == 1.);
      number_at_bottom += p[2] == 0.;
    }
    const double length = 48. * 2. * std::sin(pi / 48.);
    EXPECT_EQ(number_at_bottom, std::max(3., std::round(length / spacing)));
    EXPECT_EQ(samples.size(), 2 * number_at_bottom);
  }
}

TEST(Feature_polylines, cube_features_are_its_edges)
{
  const Array_surface cube(blocks(4, 4, 4, [](int, int, int) { return true; }));
  const std::vector<bool> is_sharp = boundary_and_sharp_halfedges(cube.t(), 60.);
  EXPECT_EQ(std::count(is_sharp.begin(), is_sharp.end(), true), 2 * 12 * 4);
  EXPECT_EQ(boundary_and_sharp_halfedges(cube.t()), std::vector<bool>(is_sharp.size(), false));
  const std::vector<Point> samples = sample(cube, 2., is_sharp);
  EXPECT_EQ(std::set<Point>(samples.begin(), samples.end()).size(), 8u + 12u);
  EXPECT_EQ(samples.size(), 8u + 12u);
  for(const Point& p : samples)
    EXPECT_GE((p[0] == 0. || p[0] == 4.) + (p[1] == 0. || p[1] == 4.) + (p[2] == 0. || p[2] == 4.),
              2);
}

TEST(Feature_polylines, sampling_follows_spacing)
{
  const Array_surface surface(square(10));
  const std::vector<bool> is_boundary = boundary_and_sharp_halfedges(surface.t());
  std::vector<double> spacing(is_boundary.size(), 0.);
  for(Index h = 0; h < spacing.size(); ++h)
    if(is_boundary[h])
      spacing[h] = coordinates(surface.t(), {h / 3, none, barycentric_on_halfedge(h, 0.5)})[0] < 0.5
                       ? 0.025
                       : 0.1;
  const std::vector<Point> samples = sample(surface, spacing);
  const auto number_left = std::count_if(samples.begin(), samples.end(),
                                         [](const Point& p) { return p[0] < 0.5 - 1e-9; });
  // On the left, one edge and two halves of the square have 40, 20 and 20 steps, and the last
  // sample is at x = 0.5. On the right they have 5, 5 and 10 steps.
  EXPECT_EQ(number_left, 79);
  EXPECT_EQ(samples.size(), 100u);
}

TEST(Feature_polylines, polyline_may_end_in_interior)
{
  // A feature polyline through three points.
  const Array_surface surface(square(4));
  std::vector<bool> is_curve(surface.t().corner.size(), false);
  const Index a = surface.vertex(6), b = surface.vertex(7), c = surface.vertex(8);
  for(Index h = 0; h < is_curve.size(); ++h)
  {
    const std::pair<Index, Index> ends = {surface.t().corner[h],
                                          surface.t().corner[next_halfedge(h)]};
    for(const auto& [x, z] : {std::pair{a, b}, std::pair{b, c}})
      if(ends == std::pair{x, z} || ends == std::pair{z, x})
        is_curve[h] = true;
  }
  EXPECT_EQ(sample(surface, 0.26, is_curve).size(), 3u);
  EXPECT_EQ(sample(surface, 10., is_curve).size(), 2u);
  EXPECT_TRUE(sample(surface, 1., std::vector<bool>(is_curve.size(), false)).empty());
}

// A rectangle with a crack of zero width: a boundary cycle whose two sides coincide. One side has a
// vertex that is not on the other one.
TEST(Feature_polylines, consecutive_samples_on_both_sides_of_a_crack_differ)
{
  Triangulation cracked;
  cracked.points = {{-3., -2., 0.}, {3., -2., 0.}, {3., 2., 0.},  {-3., 2., 0.},
                    {-1., 0., 0.},  {1., 0., 0.},  {0.25, 0., 0.}};
  cracked.corners = {0, 1, 5, 0, 5, 4, 1, 2, 5, 2, 3, 6, 2, 6, 5, 3, 4, 6, 3, 0, 4};
  const Array_surface surface(cracked);
  std::vector<Point> samples = sample_boundary(surface, 10.);
  samples.erase(std::remove_if(samples.begin(), samples.end(),
                               [](const Point& p) { return p[1] != 0. || std::abs(p[0]) > 1.; }),
                samples.end());
  ASSERT_EQ(samples.size(), 3u);
  for(std::size_t i = 0; i < 3; ++i)
    EXPECT_GT(distance(samples[i], samples[(i + 1) % 3]), 0.1);
}

} // namespace feature_polylines_test
