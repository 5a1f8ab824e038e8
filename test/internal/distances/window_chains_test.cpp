// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/window_chains.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "propagate_windows.h"

#include <gtest/gtest.h>

namespace window_chains_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of some tens of edge crossings. A crossing that moves to a vertex, from 1e-9 of
// an edge, changes the length of a shortest path by the square of this.
constexpr double round_off = 1e-12;

TEST(Window_chains, path_is_as_long_as_the_distance)
{
  for(const Triangulation& shape : {cone(12, 6, 9.), jittered(icosphere(2), 0.05)})
  {
    const Array_surface surface(shape);
    const Surface_location source = surface.in(20, {0.2, 0.3, 0.5});
    const Window_state state = propagate_windows(surface, source);
    for(Index v = 0; v < surface.size(); ++v)
    {
      std::vector<Surface_location> path = {vertex_location(surface.t(), v)};
      const double length = append_chain(state, v, path);
      EXPECT_NEAR(length, state.vertices[v].distance, round_off);
      EXPECT_NEAR(path_length(surface.t(), path), length, round_off);
      EXPECT_TRUE(is_same_point(surface.t(), path.back(), source));
    }
  }
}

TEST(Window_chains, vertices_on_sources_have_no_chain)
{
  const Array_surface surface(tetrahedron());
  const Window_state state = propagate_windows(surface, surface.at(1));
  std::vector<Surface_location> path = {surface.at(1)};
  EXPECT_EQ(append_chain(state, surface.vertex(1), path), 0.);
  EXPECT_EQ(path.size(), 1u);
}

} // namespace window_chains_test
