// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/Polar_frame.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Departure_finder.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace Polar_frame_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of paths across some tens of triangles.
constexpr double round_off = 1e-11;

// The path in the direction of a departure ends at its location.
TEST(Polar_frame, inverts_departures)
{
  std::mt19937 random(1);
  for(const Triangulation& triangulation :
      {square(8, 0.2), jittered(icosphere(2), 0.05), cone(12, 4, 9.), annulus(24, 5, 1., 2.)})
  {
    const Array_surface surface(triangulation);
    const Surface_arrays& t = surface.t();
    for(int i = 0; i < 30; ++i)
    {
      const Index triangle = Index(random() % t.number_of_triangles());
      const Surface_location from = i % 3 == 0 ? canonical(t, random_location(t, random))
                                    : i % 3 == 1
                                        ? vertex_location(t, Index(random() % surface.size()))
                                        : canonical(t, {triangle, none, {0., 0.6, 0.4}});
      // Locations in the triangles at `from`, which no other vertex hides.
      const std::vector<Index> triangles = triangles_at(t, from);
      std::vector<Surface_location> to;
      for(const Index near_triangle : triangles)
        to.push_back(canonical(t, {near_triangle, none, {0.3, 0.3, 0.4}}));
      const Polar_frame frame(t, from);
      const auto departures = Departure_finder(surface.triangles(), to)(from);
      for(std::size_t k = 0; k < to.size(); ++k)
      {
        const Straightest_path path = frame.path(departures[k].polar_angle, departures[k].length);
        EXPECT_LT(distance(point_at(t, path.locations.back()), point_at(t, to[k])), round_off);
      }
    }
  }
}

TEST(Polar_frame, lists_fans)
{
  const Array_surface flat(square(4));
  const auto only_fan = [&](const Surface_location& location)
  {
    const Polar_frame frame(flat.t(), location);
    EXPECT_EQ(frame.fans().size(), 1u);
    return frame.fans().at(0);
  };
  EXPECT_TRUE(only_fan(flat.in(3, {0.2, 0.3, 0.5})).is_closed);
  EXPECT_NEAR(only_fan(flat.at(12)).angle, 2. * pi, round_off);
  EXPECT_TRUE(only_fan(flat.at(12)).is_closed);
  EXPECT_NEAR(only_fan(flat.at(0)).angle, pi / 2., round_off);
  EXPECT_FALSE(only_fan(flat.at(0)).is_closed);
  EXPECT_NEAR(only_fan(flat.at(2)).angle, pi, round_off);
  EXPECT_FALSE(only_fan(flat.at(2)).is_closed);
  const Array_surface saddle(cone(12, 2, 9.));
  EXPECT_NEAR(Polar_frame(saddle.t(), saddle.at(0)).fans().at(0).angle, 9., round_off);
  // Two triangles that share a vertex only, and a vertex without triangles.
  const Array_surface bowtie(
      {{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}, {5., 5., 5.}},
       {0, 1, 2, 0, 3, 4}});
  const Polar_frame frame(bowtie.t(), bowtie.at(0));
  ASSERT_EQ(frame.fans().size(), 2u);
  for(const Direction_fan& fan : frame.fans())
  {
    EXPECT_NEAR(fan.angle, pi / 2., round_off);
    EXPECT_FALSE(fan.is_closed);
  }
  EXPECT_TRUE(Polar_frame(bowtie.t(), bowtie.at(5)).fans().empty());
}

// A path that is traced back from its end returns to its start, so the angles at both ends agree.
TEST(Polar_frame, measures_the_direction_at_the_end)
{
  const Array_surface surface(jittered(icosphere(2), 0.05));
  const Surface_arrays& t = surface.t();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0., 2. * pi);
  for(int i = 0; i < 30; ++i)
  {
    const Polar_frame from(t, random_location(t, random));
    const Straightest_path path = from.path(angle(random), 1.);
    const Polar_frame to(t, path.locations.back());
    ASSERT_EQ(to.vertex(), none);
    const Straightest_path back = to.path(to.polar_angle(path.angle) + pi, 1.);
    EXPECT_LT(distance(point_at(t, back.locations.back()), point_at(t, from.location())),
              round_off);
  }
}

} // namespace Polar_frame_test
