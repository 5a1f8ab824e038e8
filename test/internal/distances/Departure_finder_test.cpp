// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Departure_finder.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include "core/unfold.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace Departure_finder_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of lines across some tens of triangles: at most 4e-14 was measured.
constexpr double round_off = 1e-11;

// Returns random locations in triangles, on edges and at vertices.
std::vector<Surface_location> random_locations(const Array_surface& surface, std::mt19937& random)
{
  const Surface_arrays& t = surface.t();
  std::vector<Surface_location> result;
  for(int i = 0; i < 20; ++i)
  {
    result.push_back(canonical(t, random_location(t, random)));
    result.push_back(vertex_location(t, Index(random() % surface.size())));
    result.push_back(
        canonical(t, {Index(random() % t.number_of_triangles()), none, {0.3, 0.7, 0.}}));
  }
  return result;
}

// Returns the angle between two directions at a location.
double angle_between_directions(const Surface_arrays& t, const Surface_location& at, double a,
                                double b)
{
  double total = 2. * pi;
  if(const Index vertex = vertex_of(t, at); vertex != none)
  {
    total = 0.;
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
      total += interior_angle(t, t.ring[i]);
  }
  return std::abs(std::remainder(a - b, total));
}

TEST(Departure_finder, agrees_with_single_searches)
{
  std::mt19937 random(1);
  const std::vector<std::pair<std::string, Triangulation>> surfaces = {
      {"square", square(12, 0.24)},      {"rough sphere", jittered(icosphere(3), 0.05)},
      {"saddle", cone(12, 4, 9.)},       {"torus", torus(40, 20)},
      {"double torus", double_torus(2)}, {"annulus", annulus(24, 5, 1., 2.)}};
  for(const auto& [name, triangulation] : surfaces)
  {
    SCOPED_TRACE(name);
    const Array_surface surface(triangulation);
    const std::vector<Surface_location> to = random_locations(surface, random);
    Departure_finder finder(surface.triangles(), to);
    Window_propagation windows(surface.triangles());
    for(std::size_t k = 0; k < 6; ++k)
    {
      const Surface_location& from = to[k];
      const std::vector<Polar_departure> found = finder(from);
      windows.run({{{from}, 0., 0}});
      ASSERT_EQ(found.size(), to.size());
      for(std::size_t i = 0; i < to.size(); ++i)
      {
        const Departure expected = windows.departure(to[i]);
        EXPECT_NEAR(found[i].length, expected.length, round_off);
        EXPECT_LT(
            angle_between_directions(surface.t(), from, found[i].polar_angle, expected.polar_angle),
            expected.length > 0. ? round_off : infinity);
      }
    }
  }
}

TEST(Departure_finder, matches_plane)
{
  const Array_surface surface(square(6, 0.24));
  const Surface_arrays& t = surface.t();
  std::mt19937 random(2);
  const std::vector<Surface_location> to = random_locations(surface, random);
  const Surface_location from = canonical(t, random_location(t, random));
  const std::vector<Polar_departure> found = Departure_finder(surface.triangles(), to)(from);
  const Point p = point_at(t, from), q = point_at(t, to[0]);
  const double first_angle = std::atan2(q[1] - p[1], q[0] - p[0]);
  for(std::size_t i = 0; i < to.size(); ++i)
  {
    const Point r = point_at(t, to[i]);
    EXPECT_NEAR(surface.scale() * found[i].length, distance(p, r), round_off);
    const double angle = std::atan2(r[1] - p[1], r[0] - p[0]);
    EXPECT_NEAR(std::remainder(angle - first_angle - (found[i].polar_angle - found[0].polar_angle),
                               2. * pi),
                0., round_off);
  }
}

TEST(Departure_finder, reports_unreachable_locations_and_cancels)
{
  const Array_surface surface(disjoint_union(icosphere(1), scaled(icosphere(1), 3.)));
  const Surface_arrays& t = surface.t();
  const Index a = surface.vertex(0), b = surface.vertex(42);
  Departure_finder finder(surface.triangles(), {vertex_location(t, a), vertex_location(t, b)});
  const auto found = finder(vertex_location(t, a));
  EXPECT_EQ(found[0].length, 0.);
  EXPECT_EQ(found[1].length, infinity);
  EXPECT_THROW(finder(vertex_location(t, a), [](double) { return false; }), Cancelled);
  EXPECT_EQ(finder(vertex_location(t, b))[1].length, 0.);
  EXPECT_TRUE(Departure_finder(surface.triangles(), {})(vertex_location(t, a)).empty());
}

} // namespace Departure_finder_test
