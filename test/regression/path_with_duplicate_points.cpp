// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"
#include "path_checks.h"

#include <gtest/gtest.h>

namespace path_with_duplicate_points {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Checks that no path is empty, repeats a point, or leaves the triangles of its locations.
void expect_no_duplicate_points(const Triangulation& shape)
{
  const Array_surface surface(shape);
  const Surface_arrays& t = *surface.triangles();
  std::mt19937 random(2);
  const auto random_query_location = [&]() -> Surface_location
  {
    switch(random() % 3)
    {
    case 0:
      return surface.at(Index(random() % surface.size()));
    case 1:
      return surface.on(Index(random() % t.number_of_triangles()), int(random() % 3), 0.25);
    default:
      return random_location(t, random);
    }
  };
  internal::Front front(surface.triangles(), internal::Front_kind::euclidean);
  for(int query = 0; query < 20; ++query)
  {
    const Surface_location to = random_query_location();
    const std::vector<internal::Front_source> sources = {surface.source(to)};
    front.run(sources);
    for(int i = 0; i < 10; ++i)
    {
      const Surface_location from = i == 0 ? to : random_query_location();
      const auto geodesic = path(t, front, sources, from);
      expect_path_on_surface(t, geodesic, from, to);
      EXPECT_GE(surface.scale() * internal::path_length(t, geodesic),
                distance(point_at(t, from), point_at(t, to)) - round_off_tolerance);
    }
  }
}

TEST(Path_with_duplicate_points, does_not_occur_in_plane)
{
  expect_no_duplicate_points(square(10));
}

TEST(Path_with_duplicate_points, does_not_occur_on_irregular_mesh)
{
  expect_no_duplicate_points(square(10, 0.24, 3));
}

TEST(Path_with_duplicate_points, does_not_occur_on_rough_sphere)
{
  expect_no_duplicate_points(jittered(icosphere(3), 0.05));
}

TEST(Path_with_duplicate_points, does_not_occur_around_hole)
{
  expect_no_duplicate_points(annulus(16, 4, 1., 3.));
}

TEST(Path_with_duplicate_points, does_not_occur_on_saddles)
{
  expect_no_duplicate_points(cone(12, 5, 3. * pi));
}

TEST(Path_with_duplicate_points, does_not_occur_on_few_triangles)
{
  expect_no_duplicate_points(one_triangle());
  expect_no_duplicate_points(square(1));
  expect_no_duplicate_points(tetrahedron());
}

} // namespace path_with_duplicate_points
