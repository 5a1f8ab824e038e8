// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Second_path_search.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Shortest_path_finder.h>
#include "distances/Window_propagator.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Second_path_search_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Returns whether there is a path besides the shortest one, of at most this length.
bool has_second_path(const Array_surface& surface, const Surface_location& from,
                     const Surface_location& to, double max_length)
{
  const Surface_arrays& t = surface.t();
  Window_propagation windows(surface.triangles());
  windows.run({surface.source(to)});
  const auto path = windows.path(from).locations;
  const auto search = [&](const Second_path_search::Lower_bound& lower_bound)
  {
    return Second_path_search(surface.triangles(), find_pseudo_sources(t), canonical(t, from),
                              canonical(t, to), lower_bound, max_length / surface.scale())
        .has_path_other_than(path);
  };
  const bool result = search([&](Index v) { return windows.distance(v); });
  EXPECT_EQ(search([](Index) { return 0.; }), result);
  return result;
}

// Checks that the second path from `from` to `to` has this length.
void expect_second_path(const Array_surface& surface, const Surface_location& from,
                        const Surface_location& to, double length)
{
  // Sums of some tens of lengths have smaller round-off errors.
  constexpr double round_off = 1e-12;
  EXPECT_FALSE(has_second_path(surface, from, to, length * (1. - round_off)));
  EXPECT_TRUE(has_second_path(surface, from, to, length * (1. + round_off)));
  EXPECT_FALSE(has_second_path(surface, to, from, length * (1. - round_off)));
  EXPECT_TRUE(has_second_path(surface, to, from, length * (1. + round_off)));
}

TEST(Second_path_search, finds_both_paths_around_the_apex_of_a_cone)
{
  const Array_surface surface(cone(12, 4, 1.5 * pi));
  // Vertices at distances 2 and 3 from the apex.
  for(const Index i : {4, 5, 6})
  {
    const double angle = 1.5 * pi * (12. - i) / 12.;
    expect_second_path(surface, surface.at(1 + 12), surface.at(1 + 24 + i),
                       std::sqrt(4. + 9. - 12. * std::cos(angle)));
  }
  // On one side, the angle at the apex exceeds pi.
  EXPECT_FALSE(has_second_path(surface, surface.at(1 + 12), surface.at(1 + 24 + 3), 100.));
}

TEST(Second_path_search, finds_both_helices_on_a_prism)
{
  const Array_surface surface(rings(
      16, 4, [](double) { return 1.; }, [](double s) { return 2. * s; }, 0.));
  const double side = 2. * std::sin(pi / 16.);
  // From ring 1 to ring 3.
  expect_second_path(surface, surface.at(16), surface.at(3 * 16 + 5), std::hypot(11. * side, 1.));
  // Inside faces: the centroids of the lower triangles of two sides.
  const std::array<double, 3> centroid = {1. / 3., 1. / 3., 1. / 3.};
  expect_second_path(surface, surface.in(2 * 16, centroid), surface.in(2 * (2 * 16 + 5), centroid),
                     std::hypot(11. * side, 0.5));
}

TEST(Second_path_search, finds_a_path_on_each_side_of_a_hole)
{
  const Array_surface surface(annulus(16, 3, 1., 2.));
  const Index inner = 3 * 16;
  const Surface_location from = surface.at(0), to = surface.at(7);
  Shortest_path_finder finder(surface.triangles());
  double longer = 0.;
  for(const Index i : {2, 10})
    longer = std::max(
        longer,
        surface.scale() *
            path_length(surface.t(), finder.shorten({from, surface.at(inner + i), to}).locations));
  expect_second_path(surface, from, to, longer);
}

TEST(Second_path_search, finds_no_path_in_a_convex_polygon_and_on_a_saddle)
{
  const std::array<double, 3> p = {0.2, 0.3, 0.5};
  const Array_surface square_surface(square(8, 0.2)), saddle(cone(12, 3, 3. * pi));
  EXPECT_FALSE(
      has_second_path(square_surface, square_surface.in(3, p), square_surface.in(99, p), 10.));
  EXPECT_FALSE(has_second_path(square_surface, square_surface.at(0), square_surface.at(80), 10.));
  EXPECT_FALSE(has_second_path(saddle, saddle.at(1 + 24), saddle.at(1 + 24 + 3), 20.));
  // Through the center.
  EXPECT_FALSE(has_second_path(saddle, saddle.in(0, p), saddle.at(1 + 6), 20.));
}

TEST(Second_path_search, compares_paths_that_begin_on_an_edge)
{
  const Array_surface surface(cone(12, 3, 1.5 * pi));
  // Point 1 + 12 and point 1 + 24 have the direction 0.
  Index face = 0;
  const auto& corners = surface.t().corner;
  while(!(surface.caller_vertex(corners[3 * face]) == 1 + 12 &&
          surface.caller_vertex(corners[3 * face + 1]) == 1 + 24))
    ++face;
  const Surface_location middle = {face, none, {0.5, 0.5, 0.}};
  const double angle = 1.5 * pi * 7. / 12.;
  expect_second_path(surface, middle, surface.at(1 + 12 + 5),
                     std::sqrt(6.25 + 4. - 10. * std::cos(angle)));
  // Along the edge.
  expect_second_path(surface, middle, surface.at(1 + 12 + 6),
                     std::sqrt(6.25 + 4. - 10. * std::cos(1.5 * pi / 2.)));
}

} // namespace Second_path_search_test
