// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/descent.h"

#include "Array_surface.h"
#include "path_checks.h"

namespace descent_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

constexpr double round_off = 1e-12; // a few hundred round-off errors of lengths below 10

// The field of a function of the caller's coordinates.
std::function<double(Index)> field(const Array_surface& surface,
                                   const std::function<double(const Point&)>& f)
{
  return [&surface, f](Index vertex)
  { return f(surface.point(surface.caller_vertex(vertex))) / surface.scale(); };
}

Front_source source_at(const Surface_location& location, double offset = 0.)
{
  Front_source result;
  result.polyline = {location};
  result.offset = offset;
  return result;
}

double interpolated_value(const Array_surface& surface,
                          const std::function<double(Index)>& distance,
                          const Surface_location& location)
{
  double sum = 0.;
  for(Index k = 0; k < 3; ++k)
    if(location.barycentric[k] > 0.)
      sum += location.barycentric[k] * distance(surface.t().corner[3 * location.triangle + k]);
  return sum;
}

TEST(Descent, descends_distance_field_to_its_source)
{
  std::size_t number_of_steps = 0, number_of_ascents = 0;
  const Array_surface surface(square(20, 0.25));
  std::mt19937 random(1);
  for(int i = 0; i < 200; ++i)
  {
    const Surface_location to =
        i % 2 == 0 ? surface.at(Index(random() % 441)) : random_location(surface.t(), random);
    const Point center = point_at(surface.t(), to);
    const auto distances = field(surface, [&](const Point& p) { return distance(p, center); });
    const Descent descent(surface.t(), {source_at(to)});
    const Surface_location from = random_location(surface.t(), random);
    const auto path = descent(from, distances);
    EXPECT_EQ(path.source, 0u);
    expect_path_on_surface(surface.t(), path.locations, from, to);
    for(std::size_t k = 0; k + 2 < path.locations.size(); ++k)
    {
      ++number_of_steps;
      number_of_ascents += !(interpolated_value(surface, distances, path.locations[k + 1]) <
                             interpolated_value(surface, distances, path.locations[k]));
    }
    const double expected = distance(point_at(surface.t(), from), center) / surface.t().scale;
    const auto geodesic = shorten_geodesic(surface.t(), path.locations);
    EXPECT_NEAR(geodesic.length, expected, round_off);
    EXPECT_LE(geodesic.length, path_length(surface.t(), path.locations) + round_off);
  }
  // On triangles that are not Delaunay, the interpolation of exact distances has a few local
  // minima.
  EXPECT_LE(100 * number_of_ascents, number_of_steps);
}

TEST(Descent, ends_at_nearest_source)
{
  const Array_surface surface(square(20, 0.25));
  std::vector<Front_source> sources = {source_at(surface.at(0)), source_at(surface.at(440), 0.5)};
  const Point p = {0., 0., 0.}, q = {1., 1., 0.};
  const double scale = surface.t().scale;
  const auto distances = field(surface, [&](const Point& x)
                               { return std::min(distance(x, p), 0.5 * scale + distance(x, q)); });
  const Descent descent(surface.t(), sources);
  std::mt19937 random(2);
  for(int i = 0; i < 100; ++i)
  {
    const Surface_location from = random_location(surface.t(), random);
    const Point x = point_at(surface.t(), from);
    const double first = distance(x, p), second = 0.5 * scale + distance(x, q);
    if(std::abs(first - second) > 0.2) // not in a triangle on the bisector
    {
      const auto path = descent(from, distances);
      EXPECT_EQ(path.source, first < second ? 0u : 1u);
    }
  }
}

TEST(Descent, ends_on_polyline_sources)
{
  const Array_surface surface(square(20, 0.25));
  // The lower boundary.
  Front_source boundary;
  for(Index i = 0; i <= 20; ++i)
    boundary.polyline.push_back(surface.at(i));
  const Descent descent(surface.t(), {boundary});
  const auto height = field(surface, [](const Point& p) { return p[1]; });
  std::mt19937 random(3);
  for(int i = 0; i < 100; ++i)
  {
    const Surface_location from = random_location(surface.t(), random);
    const auto path = descent(from, height);
    ASSERT_FALSE(path.locations.empty());
    const Point p = point_at(surface.t(), from), q = point_at(surface.t(), path.locations.back());
    // The height is linear, so that the path is straight.
    EXPECT_NEAR(q[1], 0., round_off);
    EXPECT_NEAR(q[0], p[0], 1e-3); // steps snap to corners closer than 1e-4 edge lengths
  }
}

TEST(Descent, handles_start_at_or_next_to_source)
{
  const Array_surface surface(square(6, 0.2));
  std::mt19937 random(4);
  Surface_location to = random_location(surface.t(), random), from = to;
  const Point center = point_at(surface.t(), to);
  const auto distances = field(surface, [&](const Point& p) { return distance(p, center); });
  const Descent descent(surface.t(), {source_at(to)});
  EXPECT_EQ(descent(to, distances).locations.size(), 1u);
  from.barycentric = {0.2, 0.3, 0.5};
  const auto path = descent(from, distances);
  EXPECT_EQ(path.locations.size(), 2u);
  EXPECT_NEAR(path_length(surface.t(), path.locations) * surface.t().scale,
              distance(center, point_at(surface.t(), from)), round_off);
}

TEST(Descent, terminates_on_arbitrary_fields)
{
  for(unsigned seed = 1; seed <= 20; ++seed)
  {
    const Array_surface surface(jittered(icosphere(2), 0.05, seed));
    const Surface_arrays& t = surface.t();
    std::mt19937 random(seed);
    std::vector<double> values(t.number_of_vertices());
    for(double& value : values)
      switch(seed % 4)
      {
      case 0:
        value = 1.;
        break; // constant
      case 1:
        value = double(random() % 3);
        break; // steps
      case 2:
        value = 1e-300 * double(random() % 1000);
        break;
      default:
        value = double(random());
        break;
      }
    const Surface_location to = random_location(t, random);
    const Descent descent(t, {source_at(to)});
    for(int i = 0; i < 20; ++i)
    {
      const Surface_location from = random_location(t, random);
      const auto path = descent(from, [&](Index vertex) { return values[vertex]; });
      expect_path_on_surface(t, path.locations, from, to);
      EXPECT_LT(path.locations.size(), 3 * t.number_of_vertices());
    }
  }
}

TEST(Descent, starts_from_reached_corner_of_partly_reached_triangle)
{
  const Array_surface surface(square(10));
  const Point center = {0., 0., 0.};
  const Descent descent(surface.t(), {source_at(surface.at(0))});
  // Distances are finite up to 0.5 only.
  const auto distances =
      field(surface, [&](const Point& p)
            { return distance(p, center) < 0.5 ? distance(p, center) : infinity; });
  const auto path = descent(surface.at(30), distances); // at (0.8, 0.2)
  EXPECT_TRUE(path.locations.empty());
  // A triangle with a reached corner is sufficient.
  for(Index f = 0; f < surface.t().number_of_triangles(); ++f)
  {
    int number_of_reached_corners = 0;
    for(Index k = 0; k < 3; ++k)
      number_of_reached_corners += std::isfinite(distances(surface.t().corner[3 * f + k]));
    Surface_location from;
    from.triangle = f;
    from.barycentric = {0.4, 0.3, 0.3};
    const auto path_in_triangle = descent(from, distances);
    if(number_of_reached_corners > 0)
      expect_path_on_surface(surface.t(), path_in_triangle.locations, from, surface.at(0));
    else
      EXPECT_TRUE(path_in_triangle.locations.empty());
  }
}

TEST(Descent, is_empty_when_no_source_is_reachable)
{
  Triangulation shape = disjoint_union(square(4), icosphere(1));
  shape.points.push_back({5., 5., 5.}); // an isolated point
  const Array_surface surface(shape);
  const Index isolated = Index(shape.points.size() - 1);
  const auto constant = [](Index) { return 1.; };
  const Descent descent(surface.t(), {source_at(surface.at(0)), source_at(surface.at(isolated))});
  EXPECT_TRUE(descent(surface.at(30), constant).locations.empty());
  EXPECT_TRUE(descent(surface.at(30), [](Index) { return infinity; }).locations.empty());
  const auto path_to_itself = descent(surface.at(isolated), constant);
  EXPECT_EQ(path_to_itself.locations.size(), 1u);
  EXPECT_EQ(path_to_itself.source, 1u);
}

TEST(Descent, escapes_local_minimum)
{
  const Array_surface surface(square(20, 0.2));
  const Point center = {0.1, 0.1, 0.}, pit = {0.7, 0.6, 0.};
  const auto distances =
      field(surface, [&](const Point& p)
            { return distance(p, center) - 2. * std::max(0., 0.2 - distance(p, pit)); });
  const Surface_location to = surface.at(2 + 21 * 2);
  const Descent descent(surface.t(), {source_at(to)});
  const Surface_location from = surface.at(19 + 21 * 17);
  const auto path = descent(from, distances);
  expect_path_on_surface(surface.t(), path.locations, from, to);
}

} // namespace descent_test
