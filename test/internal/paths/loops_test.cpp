// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/loops.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"
#include "path_checks.h"

#include <gtest/gtest.h>

namespace loops_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(loops, distant_locations_are_joined_by_paths)
{
  const std::size_t n = 24;
  const Array_surface surface(cylinder(n, 6, 1., 2.));
  Loop loop = join_loop(surface.triangles(), surface.along({72, 80, 88}));
  EXPECT_GT(loop.size(), 12u);
  for(std::size_t i = 0; i < loop.size(); ++i)
    EXPECT_NE(common_triangle(surface.t(), loop[i], loop[(i + 1) % loop.size()]), none);
  std::vector<Loop> loops = {loop, loop};
  shorten_loops(surface.t(), loops);
  for(const Loop& shortened : loops)
  {
    expect_path_on_surface(surface.t(), shortened, shortened.front(), shortened.front());
    // the perimeter of a regular polygon
    EXPECT_NEAR(surface.scale() * path_length(surface.t(), shortened), 2. * n * std::sin(pi / n),
                1e-12);
  }
}

TEST(loops, joins_adjacent_locations_directly)
{
  const Array_surface surface(square(4));
  const Loop loop = join_loop(surface.triangles(), surface.along({0, 1, 6}));
  EXPECT_EQ(loop.size(), 3u);
  EXPECT_EQ(join_loop(surface.triangles(), surface.along({7})).size(), 1u);
}

TEST(loops, has_no_location_if_points_are_not_connected)
{
  const Array_surface surface(disjoint_union(square(2), square(2)));
  EXPECT_TRUE(join_loop(surface.triangles(), surface.along({0, 12})).empty());
  EXPECT_THROW(join_loop(surface.triangles(), {}), Invalid_argument_error);
}

} // namespace loops_test
