// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Shortest_path_finder.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"
#include "path_checks.h"

#include <gtest/gtest.h>

#include <random>

namespace Shortest_path_finder_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of sums of some hundred lengths.
constexpr double round_off = 1e-12;

// A height field whose hills make many locally shortest paths.
Triangulation hilly_square(std::size_t n)
{
  return grid(
      n, n,
      [=](double u, double v) {
        return Point{u, v, 0.3 * std::sin(17. * u) * std::cos(19. * v + u)};
      },
      0.24, 3);
}

TEST(Shortest_path_finder, path_is_as_long_as_the_exact_distance)
{
  for(const Triangulation& shape : {hilly_square(24), jittered(icosphere(3), 0.1), square(12)})
  {
    const Array_surface surface(shape);
    const Surface_arrays& t = surface.t();
    Shortest_path_finder finder(surface.triangles());
    Window_propagation exact(surface.triangles());
    std::mt19937 random(1);
    int number_of_longer_paths = 0;
    const auto location = [&](int i)
    {
      return i % 2 == 0 ? surface.at(Index(random() % surface.size()))
                        : surface.in(Index(random() % t.number_of_triangles()), {0.2, 0.3, 0.5});
    };
    for(int i = 0; i < 60; ++i)
    {
      const Surface_location from = location(i), to = location(i / 2);
      exact.run({surface.source(to)});
      const double distance = exact.distance(from);
      const Bounded_path path = finder.shortest_path(from, to),
                         local = finder.locally_shortest_path(from, to);
      ASSERT_FALSE(path.locations.empty());
      EXPECT_TRUE(is_same_point(t, path.locations.front(), canonical(t, from)));
      EXPECT_TRUE(is_same_point(t, path.locations.back(), canonical(t, to)));
      EXPECT_NEAR(path_length(t, path.locations), distance, round_off);
      EXPECT_LE(path.lower, distance);
      EXPECT_GE(path.lower, distance * (1. - 1e-11)); // twice the tolerance of the search
      EXPECT_LE(local.lower, distance);
      number_of_longer_paths += path_length(t, local.locations) > distance * (1. + 1e-6);
    }
    // Otherwise the second search is not tested.
    const bool is_hilly = shape.points.size() == hilly_square(24).points.size();
    EXPECT_TRUE(!is_hilly || number_of_longer_paths > 0);
  }
}

TEST(Shortest_path_finder, returns_one_location_or_none)
{
  const Array_surface surface(disjoint_union(tetrahedron(), square(2)));
  Shortest_path_finder finder(surface.triangles());
  EXPECT_EQ(finder.shortest_path(surface.at(1), surface.at(1)).locations.size(), 1u);
  EXPECT_TRUE(finder.shortest_path(surface.at(1), surface.at(8)).locations.empty());
}

} // namespace Shortest_path_finder_test
