// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Window_goal.h"

#include "propagate_windows.h"

#include <gtest/gtest.h>

namespace Window_goal_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of unfolding some triangles; measured are 1e-16.
constexpr double round_off = 1e-14;

TEST(Window_goal, connects_at_vertices_and_bounds_paths)
{
  const Array_surface surface(square(6, 0.24));
  const Window_state forward = propagate_windows(surface, surface.at(0));
  Window_goal goal(surface.triangles());
  goal.find_shortest(forward);
  const Index v = surface.vertex(10);
  const double rest = forward.vertices[v].distance;
  EXPECT_TRUE(goal.reach(v, 0.5));
  EXPECT_EQ(goal.meeting().vertex, v);
  EXPECT_EQ(goal.meeting().distance, 0.5 + rest);
  EXPECT_FALSE(goal.reach(v, 0.6));
  // Enlarged by the relative round_off_tolerance; measured are 3e-12.
  EXPECT_NEAR(goal.max_useful_distance(v), 0.5, 1e-11);
}

TEST(Window_goal, meets_sources_in_the_same_triangle)
{
  const Array_surface surface(square(6, 0.24));
  const Surface_location source = surface.in(7, {0.2, 0.3, 0.5});
  const Window_state forward = propagate_windows(surface, source);
  Window_goal goal(surface.triangles());
  goal.find_shortest(forward);
  goal.meet_sources(source.triangle, {0., 0.}, 0., surface.vertex(0)); // the first corner
  const Index corner = surface.t().corner[3 * source.triangle];
  EXPECT_EQ(goal.meeting().vertex, none);
  EXPECT_NEAR(goal.meeting().distance, forward.vertices[corner].distance, round_off);
}

TEST(Window_goal, keeps_one_arrival_per_direction)
{
  const Array_surface surface(square(6, 0.24));
  const Window_state forward = propagate_windows(surface, surface.at(0));
  Window_goal goal(surface.triangles());
  const Index v = surface.vertex(24), corner = surface.t().ring[surface.t().ring_begin[v]];
  const Window_arrival arrival = {0.1, {1., 0.}, corner, none},
                       other = {0.1, {0.8, 0.6}, corner, none};
  goal.find_shortest(forward);
  goal.keep_arrival(v, arrival);
  EXPECT_TRUE(goal.arrivals(v).empty());
  goal.find_all(forward, 10.);
  goal.keep_arrival(v, arrival);
  goal.keep_arrival(v, arrival);
  EXPECT_EQ(goal.arrivals(v).size(), 1u);
  goal.keep_arrival(v, other);
  EXPECT_EQ(goal.arrivals(v).size(), 2u);
  goal.find_all(forward, forward.vertices[v].distance);
  goal.keep_arrival(v, arrival);
  EXPECT_TRUE(goal.arrivals(v).empty());
}

TEST(Window_goal, bounds_paths_between_locations_by_the_straight_distance)
{
  const Array_surface surface(square(6, 0.24));
  Window_state initialized(surface.triangles(), find_pseudo_sources(surface.t()));
  Window_propagator(initialized).start({surface.source(0)});
  Window_goal goal(surface.triangles());
  goal.find_between(initialized, surface.at(0), 2.);
  const Index v = surface.vertex(24);
  const double straight = distance(surface.point(0), surface.point(24)) / surface.scale();
  EXPECT_NEAR(goal.max_useful_distance(v), 2. - straight, 1e-11); // tolerance of the bound
  EXPECT_TRUE(goal.reach(v, 1.9 - straight));
  EXPECT_FALSE(goal.reach(v, 2.1 - straight));
  EXPECT_EQ(goal.meeting().distance, 2.); // no path yet
  EXPECT_TRUE(goal.reach(surface.vertex(0), 1.5));
  EXPECT_EQ(goal.meeting().distance, 1.5);
}

TEST(Window_goal, measures_each_piece)
{
  const Array_surface surface(square(6, 0.24));
  const std::array<double, 3> barycentric = {0.2, 0.3, 0.5};
  Window_goal goal(surface.triangles());
  goal.find_each({{surface.triangle(9), none, barycentric, barycentric, 0.},
                  {surface.triangle(3), none, barycentric, barycentric, 0.}});
  Window_state state(surface.triangles(), find_pseudo_sources(surface.t()));
  Window_propagator propagator(state, &goal);
  propagator.start({surface.source(40)});
  while(!state.queue.empty())
    propagator.step();
  ASSERT_EQ(goal.meetings().size(), 2u);
  int i = 0;
  for(const Index face : {9, 3}) // in the plane, not seen from the corners of their triangles only
    EXPECT_NEAR(surface.scale() * goal.meetings()[i++].distance,
                distance(surface.point(40), point_at(surface.t(), surface.in(face, barycentric))),
                round_off);
}

} // namespace Window_goal_test
