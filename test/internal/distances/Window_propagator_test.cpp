// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Window_propagator.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include "core/unfold.h"

#include "propagate_windows.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(Window_propagator, pseudo_sources_have_an_angle_sum_above_two_pi)
{
  for(const Triangulation& triangulation :
      {icosphere(3), torus(24, 16), square(9, 0.), square(9, 0.3), cone(7, 1, 6.3)})
  {
    const Array_surface surface(triangulation);
    const Surface_arrays& t = surface.t();
    const auto is_pseudo_source = find_pseudo_sources(t);
    for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    {
      double total_angle = 0.;
      bool is_boundary = false;
      for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
      {
        total_angle += interior_angle(t, t.ring[i]);
        is_boundary = is_boundary || t.twin[t.ring[i]] == none;
      }
      EXPECT_EQ((*is_pseudo_source)[vertex], is_boundary || total_angle > 2. * pi + 1e-8);
    }
  }
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

// Returns the work of the query from a vertex.
std::size_t work(const Triangulation& triangulation, Index source)
{
  const Array_surface surface(triangulation);
  Window_state state(surface.triangles(), find_pseudo_sources(surface.t()));
  Window_propagator propagator(state);
  propagator.start({surface.source(surface.at(source))});
  while(!state.queue.empty())
    propagator.step();
  return propagator.work();
}

// Returns two cones with a common rim, whose vertices begin at index 2.
Triangulation double_cone(Index degree)
{
  Triangulation result = {{{0., 0., 1.}, {0., 0., -1.}}, {}};
  for(Index i = 0; i < degree; ++i)
  {
    const double angle = 2. * pi * i / degree;
    result.points.push_back({std::cos(angle), std::sin(angle), 0.});
    const Index p = 2 + i, q = 2 + (i + 1) % degree;
    result.corners.insert(result.corners.end(), {0, p, q, 1, q, p});
  }
  return result;
}

TEST(Window_propagator, work_is_bounded)
{
  const std::size_t n = icosphere(3).corners.size();
  EXPECT_LT(work(icosphere(3), 0), 20 * n); // a few windows cross each halfedge
  EXPECT_EQ(Window_propagator::usual_max_work(10000), 1010000000u);
  // Windows circulate around the tips. Twice the degree makes four times the work, and 2^1.5 = 2.8
  // times the variable part of the bound.
  EXPECT_GT(work(double_cone(200), 2), 3 * work(double_cone(100), 2));
}

TEST(Window_propagator, throws_beyond_the_maximum_work)
{
  const Array_surface surface(double_cone(100));
  const Window_state expected = propagate_windows(surface, surface.at(2));
  Window_state state(surface.triangles(), find_pseudo_sources(surface.t()));
  const auto propagate = [&](std::size_t max_work)
  {
    Window_propagator propagator(state, nullptr, max_work);
    propagator.start({surface.source(surface.at(2))});
    while(!state.queue.empty())
      propagator.step();
  };
  EXPECT_THROW(propagate(100), Unsupported_surface_error);
  // No vertex is reached, and the state can be used again.
  EXPECT_TRUE(state.reached.empty());
  propagate(1000000);
  for(std::size_t i = 0; i < expected.vertices.size(); ++i)
    EXPECT_EQ(state.vertices[i].distance, expected.vertices[i].distance);
}

} // namespace Window_propagator_test
