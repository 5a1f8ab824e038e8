// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "triangulations.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Location location(Index triangle, std::array<double, 3> barycentric)
{
  Location result;
  result.triangle = triangle;
  result.barycentric = barycentric;
  return result;
}

TEST(Path_locations, are_cleaned_of_rounding)
{
  const Glued_mesh mesh = glued(one_triangle());
  const Location clean = cleaned(mesh.triangles, location(0, {1. + 1e-16, 1e-15, -1e-16}));
  EXPECT_EQ(clean.barycentric, (std::array<double, 3>{1., 0., 0.}));
  EXPECT_EQ(corner_of(clean), 0u);
  EXPECT_EQ(side_of(clean), none);
  EXPECT_EQ(site_of(mesh.triangles, clean), mesh.triangles.corner[0]);
}

TEST(Path_locations, at_a_corner_have_nothing_but_one)
{
  // One that misses it by the rounding of a sum.
  const Glued_mesh mesh = glued(one_triangle());
  const Location clean = cleaned(mesh.triangles, location(0, {0., 1. - 2.2e-16, 1e-15}));
  EXPECT_EQ(clean.barycentric, (std::array<double, 3>{0., 1., 0.}));
}

TEST(Path_locations, of_a_site_are_the_same_seen_from_all_its_triangles)
{
  const Glued_mesh mesh = glued(tetrahedron());
  const Glued_triangles& t = mesh.triangles;
  for(Index corner = 0; corner < 12; ++corner)
  {
    const Location p = at_site(t, t.corner[corner]);
    const auto seen = seen_from(t, corner / 3, p);
    ASSERT_TRUE(seen);
    EXPECT_EQ(*seen, location(0, {corner % 3 == 0 ? 1. : 0., corner % 3 == 1 ? 1. : 0.,
                                  corner % 3 == 2 ? 1. : 0.})
                         .barycentric);
    EXPECT_TRUE(is_same_point(t, p, location(corner / 3, *seen)));
  }
}

TEST(Path_locations, of_a_side_are_the_same_seen_from_its_twin)
{
  const Glued_mesh mesh = glued(icosphere(1));
  const Glued_triangles& t = mesh.triangles;
  for(Index side = 0; side < t.corner.size(); ++side)
  {
    std::array<double, 3> b = {0., 0., 0.};
    b[side % 3] = 0.25;
    b[next_side(side) % 3] = 0.75;
    const Location p = location(side / 3, b);
    EXPECT_EQ(side_of(p), side);
    const auto seen = seen_from(t, t.twin[side] / 3, p);
    ASSERT_TRUE(seen);
    const Location q = location(t.twin[side] / 3, *seen);
    EXPECT_TRUE(is_same_point(t, p, q));
    const Point a = point_at(t, p), c = point_at(t, q);
    EXPECT_NEAR(distance(a, c), 0., 1e-15); // roundings of coordinates below 1
    EXPECT_NE(common_triangle(t, p, q), none);
  }
}

TEST(Path_locations, in_far_triangles_have_no_triangle_in_common)
{
  const Glued_mesh mesh = glued(icosphere(2));
  const Glued_triangles& t = mesh.triangles;
  const Location p = at_site(t, mesh.site_of_vertex[0]), q = at_site(t, mesh.site_of_vertex[3]);
  EXPECT_EQ(common_triangle(t, p, q), none);
  EXPECT_THROW(path_length(t, {p, q}), Invalid_argument_error);
}

TEST(Path_locations, give_the_length_of_a_path)
{
  const Glued_mesh mesh = glued(one_triangle());
  const Glued_triangles& t = mesh.triangles;
  const double length = path_length(t, {location(0, {1., 0., 0.}), location(0, {0., 0.5, 0.5}),
                                        location(0, {0., 0.5, 0.5}), location(0, {0., 1., 0.})});
  EXPECT_NEAR(length * t.scale, std::sqrt(2.), 1e-15 * 4); // a few roundings
}

} // namespace
