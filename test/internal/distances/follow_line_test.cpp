// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/follow_line.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

namespace follow_line_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of some tens of edge crossings.
constexpr double round_off = 1e-12;

TEST(Follow_line, finds_a_visible_location)
{
  const Array_surface surface(square(12, 0.24));
  const Surface_arrays& t = surface.t();
  std::mt19937 random(1);
  for(int i = 0; i < 20; ++i)
  {
    const Surface_location from = random_location(t, random), to = random_location(t, random);
    const Point p = point_at(t, from), q = point_at(t, to);
    // The layout of the triangle: its first edge is on the first axis.
    const Index h = 3 * from.triangle;
    const Point a = t.point[t.corner[h]], b = t.point[t.corner[next_halfedge(h)]];
    const Vec2 axis = {(b[0] - a[0]) / t.length[h], (b[1] - a[1]) / t.length[h]};
    const Vec2 step = {(q[0] - p[0]) / t.scale, (q[1] - p[1]) / t.scale};
    const Vec2 begin = unfolded_point(unfolded(t, from.triangle), from.barycentric);
    std::vector<Surface_location> crossings;
    const auto line =
        follow_line(t, {from.triangle, begin, begin + rotated_back(step, axis)}, to, &crossings);
    ASSERT_TRUE(line);
    EXPECT_NEAR(norm(line->target - line->from), norm(step), round_off);
    double length = 0.;
    Point previous = p;
    crossings.push_back(to);
    for(const Surface_location& location : crossings)
    {
      const Point next = point_at(t, location);
      length += distance(previous, next);
      previous = next;
    }
    EXPECT_NEAR(length, distance(p, q), round_off);
  }
}

TEST(Follow_line, returns_nothing_if_the_location_is_missed)
{
  const Array_surface surface(square(12, 0.24));
  const Surface_arrays& t = surface.t();
  const Surface_location center = {0, none, {0.4, 0.3, 0.3}};
  const Vec2 begin = unfolded_point(unfolded(t, 0), center.barycentric);
  for(const double angle : {0.1, 2., 4.})
    EXPECT_FALSE(follow_line(t,
                             {0, begin, begin + Vec2{0.1 * std::cos(angle), 0.1 * std::sin(angle)}},
                             surface.at(surface.size() / 2)));
}

} // namespace follow_line_test
