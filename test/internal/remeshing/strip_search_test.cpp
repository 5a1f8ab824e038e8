// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/strip_search.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

namespace strip_search_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

constexpr Detour_factors no_detours = {1., 1., true};

// A square mesh with the vertices 0 and 120 at opposite corners, in two cells.
struct Split_square
{
  Split_square()
      : arrays(square(10)), mesh(arrays.t(), std::vector<bool>(arrays.t().corner.size(), false)),
        from(arrays.vertex(0)), to(arrays.vertex(120)), cells(arrays.size(), 2)
  {}

  std::vector<Index> find(Strip_search& search) const
  {
    search.set_nearby_cells({0, 1, 3, 3});
    return search.find(mesh.corners_around(from), mesh.corners_around(to), to);
  }

  Array_surface arrays;
  Split_mesh mesh;
  Index from, to;
  std::vector<Index> cells;
};

TEST(Strip_search, strip_is_connected_from_start_to_goal)
{
  const Split_square s;
  Strip_search search(s.mesh, no_detours, s.cells, 10000);
  const std::vector<Index> strip = s.find(search);
  ASSERT_FALSE(strip.empty());
  const std::vector<Index>& twin = s.mesh.triangles().twin;
  EXPECT_EQ(s.mesh.apex(strip.front()), s.from);
  EXPECT_EQ(s.mesh.apex(twin[strip.back()]), s.to);
  for(std::size_t i = 0; i + 1 < strip.size(); ++i)
    EXPECT_EQ(twin[strip[i]] / 3, strip[i + 1] / 3);
}

TEST(Strip_search, second_search_gives_the_same_strip)
{
  const Split_square s;
  Strip_search search(s.mesh, no_detours, s.cells, 10000);
  EXPECT_EQ(s.find(search), s.find(search));
}

TEST(Strip_search, labeled_edges_are_not_crossed)
{
  Split_square s;
  for(const Index corner : s.mesh.corners_around(s.to))
    s.mesh.set_label(next_halfedge(corner), 7);
  Strip_search search(s.mesh, no_detours, s.cells, 10000);
  EXPECT_TRUE(s.find(search).empty());
}

TEST(Strip_search, confined_strips_stay_in_the_cells_of_their_ends)
{
  Split_square s;
  const Detour_factors confined = {infinity, infinity, false};
  {
    Strip_search search(s.mesh, confined, s.cells, 10000);
    EXPECT_TRUE(s.find(search).empty());
  }
  for(Index i = 0; i < s.arrays.size(); ++i)
    s.cells[s.arrays.vertex(i)] = s.arrays.point(i)[0] < 0.5 ? 0 : 1;
  Strip_search search(s.mesh, confined, s.cells, 10000);
  EXPECT_FALSE(s.find(search).empty());
}

TEST(Strip_search, gives_up_after_the_limit_of_visits)
{
  const Split_square s;
  Strip_search search(s.mesh, no_detours, s.cells, 3);
  EXPECT_TRUE(s.find(search).empty());
}

} // namespace strip_search_test
