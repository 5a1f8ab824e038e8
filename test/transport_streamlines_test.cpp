// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/transport_streamlines.h>

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace transport_streamlines_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Proposition 2 of Solomon et al. 2014: from a point to a uniformly filled ball, streamlines are
// shortest paths to all points of the ball. As the ball shrinks, the cost converges to the
// distance. Their difference is at most the radius plus the gap of the bounds.
TEST(transport_streamlines, cost_to_ball_approximates_distance)
{
  const Mesh mesh = mesh_of(jittered(icosphere(4), 0.01));
  const Vertex p(7), q(1900);
  GP::Geodesic_distance_solver<Mesh, GP::Exact> from_p(mesh), from_q(mesh);
  from_p.compute(p);
  from_q.compute(q);
  const double distance = from_p.distance(q);
  for(const double radius : {0.4, 0.2, 0.1})
  {
    std::vector<Vertex> ball;
    for(const Vertex v : mesh.vertices())
      if(from_q.distance(v) <= radius)
        ball.push_back(v);
    GP::Earth_movers_solver<Mesh> solver(mesh);
    const GP::Earth_movers_cost cost = solver.compute(p, ball);
    // 0.5 % is lost on the curved surface.
    EXPECT_LE(std::abs(cost.value - distance),
              radius + (cost.upper - cost.lower) + 0.005 * distance);

    std::vector<GP::Streamline<Mesh>> lines;
    GP::transport_streamlines(mesh, p, ball, std::size_t(40), std::back_inserter(lines));
    ASSERT_EQ(lines.size(), 40u);
    for(const auto& line : lines)
    {
      EXPECT_TRUE(line.has_arrived);
      const auto is_at = [&mesh](Vertex v, const Kernel::Point_3& x)
      { return CGAL::squared_distance(mesh.point(v), x) < 1e-24; }; // round-off errors
      EXPECT_TRUE(is_at(p, line.points.front()));
      const auto end = std::find_if(ball.begin(), ball.end(),
                                    [&](Vertex v) { return is_at(v, line.points.back()); });
      ASSERT_NE(end, ball.end());
      // Straightened streamlines are shortest only locally. Measured are 0.6 %.
      EXPECT_LE(line.length, 1.01 * from_p.distance(*end));
      EXPECT_GE(line.length, (1. - 1e-9) * from_p.distance(*end)); // round-off errors
    }
  }
}

TEST(transport_streamlines, starts_at_seeds)
{
  const Mesh mesh = mesh_of(square(12));
  const std::vector<Vertex> from = {Vertex(0), Vertex(12)},
                            to = {Vertex(5 * 13), Vertex(5 * 13 + 12)};
  std::vector<GP::Streamline<Mesh>> lines;
  GP::transport_streamlines<GP::Alternating_directions>(
      mesh, from, to, from, std::back_inserter(lines), GP::parameters::tolerance(1e-3));
  ASSERT_EQ(lines.size(), 2u);
  for(std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_EQ(lines[i].points.front(), mesh.point(from[i]));
    EXPECT_EQ(lines[i].points.back(), mesh.point(to[i]));
    EXPECT_NEAR(lines[i].length, 5. / 12., 1e-12); // round-off errors of five lengths
  }
  // Seeds at other locations: streamlines follow the boundary to their end.
  std::vector<GP::Streamline<Mesh>> lines_from_seeds;
  const std::vector<GP::Location<Mesh>> seeds = {location_of(3, {0.2, 0.3, 0.5})};
  GP::transport_streamlines(mesh, from, to, seeds, std::back_inserter(lines_from_seeds));
  ASSERT_EQ(lines_from_seeds.size(), 1u);
  EXPECT_EQ(lines_from_seeds[0].locations.front(), seeds[0]);
}

} // namespace transport_streamlines_test
