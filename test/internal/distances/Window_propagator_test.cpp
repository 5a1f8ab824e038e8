// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Window_propagator.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include "propagate_windows.h"

#include <gtest/gtest.h>

namespace Window_propagator_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(Window_propagator, distances_on_a_plane_are_euclidean)
{
  const Triangulation plane = square(12, 0.24);
  const Array_surface surface(plane);
  for(const Surface_location& source : {surface.at(40), surface.in(30, {0.2, 0.3, 0.5})})
  {
    const Window_state state = propagate_windows(surface, source);
    const Point p = point_at(surface.t(), source);
    for(Index i = 0; i < surface.size(); ++i)
      // Unfolding some tens of triangles.
      EXPECT_NEAR(state.vertices[surface.vertex(i)].distance * surface.scale(),
                  distance(plane.points[i], p), 1e-12);
  }
}

TEST(Window_propagator, pseudo_sources_are_saddle_and_boundary_vertices)
{
  const Array_surface saddle(cone(12, 3, 9.)), tip(cone(12, 3, 5.));
  EXPECT_TRUE((*find_pseudo_sources(saddle.t()))[saddle.vertex(0)]);
  EXPECT_FALSE((*find_pseudo_sources(tip.t()))[tip.vertex(0)]);
  for(Index i = tip.size() - 12; i < tip.size(); ++i)
    EXPECT_TRUE((*find_pseudo_sources(tip.t()))[tip.vertex(i)]);
}

TEST(Window_propagator, state_can_be_cleared)
{
  const Array_surface surface(icosphere(2));
  Window_state state = propagate_windows(surface, surface.at(0));
  EXPECT_EQ(state.reached.size(), std::size_t(surface.size()));
  state.clear();
  EXPECT_TRUE(state.reached.empty());
  for(const Window_state::Vertex& vertex : state.vertices)
    EXPECT_EQ(vertex.distance, infinity);
}

} // namespace Window_propagator_test
