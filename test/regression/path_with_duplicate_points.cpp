// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"
#include "path_checks.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// No path is empty, has a point twice in a row, or leaves the triangles that it names.
void expect_clean_paths(const Triangulation& shape)
{
  const Glued_surface surface(shape);
  const Glued_triangles& t = *surface.triangles();
  std::mt19937 random(2);
  const auto place = [&]() -> Location
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
    const Location to = place();
    const std::vector<internal::Source> sources = {surface.source(to)};
    front.run(sources);
    for(int i = 0; i < 10; ++i)
    {
      const Location from = i == 0 ? to : place();
      const auto found = path(t, front, sources, from);
      expect_path_on_surface(t, found, from, to);
      EXPECT_GE(surface.scale() * internal::path_length(t, found),
                distance(point_at(t, from), point_at(t, to)) - rounding);
    }
  }
}

TEST(Path_with_duplicate_points, is_not_found_in_a_plane) { expect_clean_paths(square(10)); }

TEST(Path_with_duplicate_points, is_not_found_among_odd_triangles)
{
  expect_clean_paths(square(10, 0.24, 3));
}

TEST(Path_with_duplicate_points, is_not_found_on_a_rough_sphere)
{
  expect_clean_paths(shaken(icosphere(3), 0.05));
}

TEST(Path_with_duplicate_points, is_not_found_around_a_hole)
{
  expect_clean_paths(annulus(16, 4, 1., 3.));
}

TEST(Path_with_duplicate_points, is_not_found_on_saddles)
{
  expect_clean_paths(cone(12, 5, 3. * pi));
}

TEST(Path_with_duplicate_points, is_not_found_on_few_triangles)
{
  expect_clean_paths(one_triangle());
  expect_clean_paths(square(1));
  expect_clean_paths(tetrahedron());
}

} // namespace
