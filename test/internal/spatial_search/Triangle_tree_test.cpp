// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/spatial_search/Triangle_tree.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

namespace Triangle_tree_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of coordinates near 1.
constexpr double round_off = 1e-14;

TEST(Triangle_tree, locates_points_on_surface)
{
  const Array_surface surface(jittered(icosphere(3), 0.03));
  const Triangle_tree tree(surface.triangles());
  std::mt19937 random(1);
  for(int i = 0; i < 300; ++i)
  {
    const Point p = point_at(*surface.triangles(), random_location(*surface.triangles(), random));
    const Point q = point_at(*surface.triangles(), tree.nearest(p));
    EXPECT_LT(distance(p, q), round_off); // round-off errors of coordinates up to 1
  }
}

TEST(Triangle_tree, is_at_most_as_far_as_any_sample)
{
  const Array_surface surface(jittered(icosphere(2), 0.1));
  const Triangle_tree tree(surface.triangles());
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-2., 2.);
  std::vector<Point> samples;
  for(int i = 0; i < 5000; ++i)
    samples.push_back(
        point_at(*surface.triangles(), random_location(*surface.triangles(), random)));
  for(int i = 0; i < 100; ++i)
  {
    const Point p = {coordinate(random), coordinate(random), coordinate(random)};
    const Surface_location found = tree.nearest(p);
    double sum = 0.;
    for(const double b : found.barycentric)
    {
      EXPECT_GE(b, 0.);
      sum += b;
    }
    EXPECT_NEAR(sum, 1., 4e-16); // two additions
    const double smallest = distance(p, point_at(*surface.triangles(), found));
    for(const Point& sample : samples)
      EXPECT_LE(smallest, distance(p, sample) * (1. + round_off));
  }
}

TEST(Triangle_tree, projects_onto_plane_and_boundary)
{
  const Array_surface surface(square(5, 0.24));
  const Triangle_tree tree(surface.triangles());
  const auto found = [&](const Point& p)
  { return point_at(*surface.triangles(), tree.nearest(p)); };
  EXPECT_LT(distance(found({0.3, 0.7, 5.}), {0.3, 0.7, 0.}), round_off);
  EXPECT_LT(distance(found({-3., 0.7, 1.}), {0., 0.7, 0.}), round_off);
  EXPECT_LT(distance(found({2., 3., -1.}), {1., 1., 0.}), round_off);
}

TEST(Triangle_tree, handles_far_query_points)
{
  const Array_surface surface(square(5));
  const Triangle_tree tree(surface.triangles());
  for(const double far : {1e20, 1e150, 1e300})
  {
    const Surface_location location = tree.nearest({far, far, 0.});
    // The round-off error of such distances exceeds the size of the square.
    for(const double b : location.barycentric)
      EXPECT_TRUE(b >= 0. && b <= 1.);
  }
}

TEST(Triangle_tree, ignores_degenerate_triangles)
{
  Triangulation surface = square(4);
  for(Index i = 6; i < 9; ++i)
    surface.points[i] = surface.points[6];
  const Array_surface array_surface(surface);
  const Triangle_tree tree(array_surface.triangles());
  for(const Point& p : surface.points)
    // Round-off errors of coordinates near 1.
    EXPECT_LT(distance(p, point_at(*array_surface.triangles(), tree.nearest(p))), 1e-15);
}

TEST(Triangle_tree, returns_vertex_without_triangles)
{
  const Array_surface surface({{{0., 0., 0.}, {1., 0., 0.}, {5., 5., 5.}}, {}});
  const Surface_location found = Triangle_tree(surface.triangles()).nearest({4., 4., 6.});
  EXPECT_EQ(found.triangle, none);
  EXPECT_EQ(found.vertex, surface.vertex(2));
}

TEST(Triangle_tree, throws_on_nonfinite_points_and_empty_surfaces)
{
  const Triangle_tree tree(Array_surface(square(2)).triangles());
  EXPECT_THROW(tree.nearest({0., infinity, 0.}), Invalid_argument_error);
  EXPECT_THROW(tree.nearest({std::numeric_limits<double>::quiet_NaN(), 0., 0.}),
               Invalid_argument_error);
  EXPECT_THROW(Triangle_tree(Array_surface({}).triangles()).nearest({0., 0., 0.}),
               Invalid_argument_error);
}

TEST(Triangle_tree, queries_are_thread_safe)
{
  const Array_surface surface(icosphere(3));
  const Triangle_tree tree(surface.triangles());
  std::vector<Surface_location> answers[2];
  const auto query = [&](int k)
  {
    const Triangle_tree copy = tree;
    for(const Index i : {0u, 5u, 77u, 300u})
      answers[k].push_back(copy.nearest(surface.point(i)));
  };
  std::thread other(query, 1);
  query(0);
  other.join();
  for(std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(answers[0][i].triangle, answers[1][i].triangle);
    EXPECT_EQ(answers[0][i].barycentric, answers[1][i].barycentric);
  }
}

} // namespace Triangle_tree_test
