// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Reverse_window_search.h"

#include "propagate_windows.h"

#include <gtest/gtest.h>

namespace Reverse_window_search_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(Reverse_window_search, distance_equals_that_of_a_forward_query)
{
  const Array_surface surface(jittered(icosphere(2), 0.05));
  const Surface_location source = surface.in(20, {0.2, 0.3, 0.5});
  const Window_state forward = propagate_windows(surface, source);
  Reverse_window_search search(forward.triangles, forward.is_pseudo_source);
  // The same windows in reverse order: round-off errors of some tens of edge crossings.
  for(Index v = 0; v < surface.size(); ++v)
    EXPECT_NEAR(search.find_shortest(forward, {none, v, {}}).distance, forward.vertices[v].distance,
                1e-12);
}

TEST(Reverse_window_search, finds_both_paths_around_a_cone)
{
  const Index n = 12;
  const Array_surface surface(cone(n, 4, 3.));
  const Index source = 1 + 2 * n, opposite = source + n / 2;
  const Window_state forward = propagate_windows(surface, surface.at(source));
  Reverse_window_search search(forward.triangles, forward.is_pseudo_source);
  const double distance = search.find_shortest(forward, surface.at(opposite)).distance;
  search.find_all(forward, surface.at(opposite), distance * (1. + 1e-12));
  std::vector<std::vector<Surface_location>> paths;
  search.collect_paths(surface.vertex(source), {surface.at(source)}, paths);
  EXPECT_EQ(paths.size(), 2u);
}

} // namespace Reverse_window_search_test
