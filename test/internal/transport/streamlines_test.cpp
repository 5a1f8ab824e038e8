// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/streamlines.h>

#include <CGAL/Geodesic_processing/internal/transport/Earth_movers.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>
#include "core/unfold.h"

#include "Glued_surface.h"
#include "clouds.h"
#include "path_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Of some hundred steps.
constexpr double rounding = 1e-12;

// What flows out of the triangles of a flat surface by a field that is linear, of divergence `gain`.
Continuous_flow flow_of(const Glued_surface& surface, const std::function<Planar(Planar)>& field,
                        double gain)
{
  const Glued_triangles& t = surface.t();
  Continuous_flow result;
  result.outward.resize(t.corner.size());
  result.missing.resize(t.number_of_triangles());
  for(Index side = 0; side < t.corner.size(); ++side)
  {
    const Point &p = surface.point(surface.point_of_site(t.corner[side])),
                &q = surface.point(surface.point_of_site(t.corner[next_side(side)]));
    const Planar vector = field({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])});
    result.outward[side] = cross(vector, Planar{q[0] - p[0], q[1] - p[1]});
  }
  const std::vector<double> area = operators(t).area;
  for(std::size_t f = 0; f < area.size(); ++f)
    result.missing[f] = -gain * surface.scale() * surface.scale() * area[f];
  return result;
}

Moved_masses density(const Glued_surface& surface, double before)
{
  Moved_masses result;
  result.before = before * surface.scale() * surface.scale() * lumped_mass(operators(surface.t()));
  result.after = result.before;
  return result;
}

Planar plane(const Glued_surface& surface, const Location& location)
{
  const auto p = coordinates(surface.t(), location);
  return {p[0], p[1]};
}

void expect_near(const Planar& p, const Planar& q)
{
  EXPECT_NEAR(p[0], q[0], rounding);
  EXPECT_NEAR(p[1], q[1], rounding);
}

Streamline checked_line(const Streamlines& streamlines, const Glued_surface& surface,
                        const Grain& grain)
{
  const Streamline result = streamlines(grain);
  expect_path_on_surface(surface.t(), result.locations, result.locations.front(),
                         result.locations.back());
  return result;
}

// An even mass moves by as much as flows, all along.
TEST(streamlines, move_an_even_mass_straight_on)
{
  const Glued_surface surface(square(12, 0.24));
  const Planar way = {0.3, 0.1};
  const Streamlines streamlines(surface.triangles(),
                                flow_of(
                                    surface, [&](Planar) { return 2. * way; }, 0.),
                                density(surface, 2.));
  std::size_t inside = 0;
  for(const Grain& grain : streamlines.grains(50))
  {
    const Streamline line = checked_line(streamlines, surface, grain);
    const Planar from = plane(surface, line.locations.front());
    for(const Location& location : line.locations)
      EXPECT_NEAR(cross(plane(surface, location) - from, way), 0., rounding);
    if(from[0] > 0.69 || from[1] > 0.89)
      continue;
    ++inside;
    EXPECT_TRUE(line.has_arrived);
    expect_near(plane(surface, line.locations.back()), from + way);
  }
  EXPECT_GT(inside, 25u);
}

// Towards a point an even mass gathers: areas shrink as the density grows.
TEST(streamlines, follow_a_mass_that_gathers)
{
  const Glued_surface surface(square(12, 0.24));
  const Planar middle = {0.45, 0.55};
  // The divergence is -2: a density of 1 becomes 3.
  const Streamlines streamlines(surface.triangles(),
                                flow_of(
                                    surface, [&](Planar p) { return middle - p; }, -2.),
                                density(surface, 1.));
  for(const Grain& grain : streamlines.grains(50))
  {
    const Streamline line = checked_line(streamlines, surface, grain);
    const Planar from = plane(surface, line.locations.front());
    EXPECT_TRUE(line.has_arrived);
    expect_near(plane(surface, line.locations.back()),
                middle + std::sqrt(1. / 3.) * (from - middle));
  }
}

// From where nothing is a line goes as far as the flow does.
TEST(streamlines, lead_to_where_all_flows)
{
  const Glued_surface surface(square(12, 0.24));
  const Planar middle = {0.45, 0.55};
  const Streamlines streamlines(surface.triangles(),
                                flow_of(
                                    surface, [&](Planar p) { return middle - p; }, -2.),
                                density(surface, 0.));
  const Streamline line = checked_line(streamlines, surface, {surface.in(7, {0.2, 0.3, 0.5})});
  EXPECT_TRUE(line.has_arrived);
  expect_near(plane(surface, line.locations.back()), middle);
}

TEST(streamlines, end_where_the_flow_turns_in_circles_or_rests)
{
  const Glued_surface surface(square(12, 0.24));
  const Streamlines circles(surface.triangles(),
                            flow_of(
                                surface,
                                [&](Planar p) {
                                  return Planar{0.5 - p[1], p[0] - 0.5};
                                },
                                0.),
                            density(surface, 0.));
  const Location from = surface.in(100, {0.2, 0.3, 0.5});
  EXPECT_FALSE(circles({from}).has_arrived);
  // That flow is no field of Raviart and Thomas; still it leads around the middle.
  EXPECT_GT(circles({from}).locations.size(), 10u);
  const Streamlines rest(surface.triangles(),
                         flow_of(
                             surface,
                             [](Planar) {
                               return Planar{0., 0.};
                             },
                             0.),
                         density(surface, 0.));
  EXPECT_FALSE(rest({from}).has_arrived);
  EXPECT_EQ(rest({from}).locations.size(), 1u);
}

// From one point to two others, on meshes and on a cloud: as many lines arrive as there is mass.
struct Parting
{
  Earth_movers kernel;
  Mass_distribution from, to;
  std::vector<Index> targets;

  Parting(const std::shared_ptr<const Glued_triangles>& t, Index source, Index first, Index second)
      : kernel(t), targets({first, second})
  {
    from.at_locations = {{{none, source, {}}, 1.}};
    to.at_locations = {{{none, first, {}}, 0.3}, {{none, second, {}}, 0.7}};
  }

  // Calls f with each line, of a hundred.
  template <typename Function>
  void check(const Glued_triangles& t, Function f)
  {
    Earth_movers_options options;
    options.transport.tolerance = 1e-5;
    const Streamlines streamlines = kernel.streamlines(kernel.solve(from, to, options));
    std::vector<int> arrived(2, 0);
    for(const Grain& grain : streamlines.grains(100))
    {
      const Streamline line = streamlines(grain);
      ASSERT_TRUE(line.has_arrived);
      EXPECT_EQ(site_of(t, line.locations.front()), from.at_locations[0].first.site);
      for(std::size_t i = 0; i < 2; ++i)
        arrived[i] += site_of(t, line.locations.back()) == targets[i];
      f(line);
    }
    // Each triangle around the source, or each arc, may have one grain too many or too few.
    EXPECT_NEAR(arrived[0], 30, 4);
    EXPECT_EQ(arrived[0] + arrived[1], 100);
  }
};

TEST(streamlines, arrive_as_masses_do)
{
  for(const Triangulation& shape :
      {shaken(icosphere(3), 0.02), cylinder(24, 8, 1., 2.), torus(40, 16), square(16, 0.24)})
  {
    const Glued_surface surface(shape);
    const Index n = surface.size();
    Parting parting(surface.triangles(), surface.site(n / 2), surface.site(3), surface.site(n - 5));
    parting.check(surface.t(),
                  [&](const Streamline& line) {
                    expect_path_on_surface(surface.t(), line.locations, surface.at(n / 2),
                                           line.locations.back());
                  });
  }
}

TEST(streamlines, arrive_on_clouds)
{
  const Cloud cloud = octahedron_sphere(3);
  const Glued_surfels surfels = glue_surfels(cloud.points, cloud.normals);
  const auto t = std::make_shared<const Glued_triangles>(surfels.triangles);
  Parting parting(t, surfels.site_of_surfel[0], surfels.site_of_surfel[100],
                  surfels.site_of_surfel[230]);
  parting.check(
      *t,
      [&](const Streamline& line)
      {
        // Each step is a side of a triangle, and no site comes twice.
        std::vector<Index> sites;
        for(const Location& location : line.locations)
          sites.push_back(site_of(*t, location));
        for(std::size_t i = 0; i + 1 < sites.size(); ++i)
        {
          bool is_side = false;
          for(Index side = 0; side < t->corner.size(); ++side)
            is_side = is_side ||
                      (t->corner[side] == sites[i] && t->corner[next_side(side)] == sites[i + 1]) ||
                      (t->corner[side] == sites[i + 1] && t->corner[next_side(side)] == sites[i]);
          EXPECT_TRUE(is_side);
        }
        std::sort(sites.begin(), sites.end());
        EXPECT_EQ(std::adjacent_find(sites.begin(), sites.end()), sites.end());
      });
}

// Masses in triangles are reached where they are.
TEST(streamlines, begin_and_end_within_triangles)
{
  const Glued_surface surface(shaken(icosphere(2), 0.03));
  const Earth_movers kernel(surface.triangles());
  const Location from = surface.in(3, {0.2, 0.5, 0.3}), to = surface.in(250, {0.1, 0.1, 0.8});
  Mass_distribution before, after;
  before.at_locations = {{from, 2.}};
  after.at_locations = {{to, 2.}};
  const Streamlines streamlines = kernel.streamlines(kernel.solve(before, after));
  for(const Grain& grain : streamlines.grains(20))
    expect_path_on_surface(surface.t(), streamlines(grain).locations, from, to);
}

// A wall has no line through it.
TEST(streamlines, go_around_obstacles)
{
  const Glued_surface surface(grid(20, 10,
                                   [](double x, double y) -> Point {
                                     return {2. * x, y, 0.};
                                   }));
  std::vector<Tensor> measure(surface.t().number_of_triangles(), {1., 0., 1.});
  for(Index f = 0; f < measure.size(); ++f)
  {
    const auto p = coordinates(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}});
    if(p[0] > 1. && p[0] < 1.2 && p[1] < 0.8)
      measure[f] = {infinity, 0., infinity};
  }
  const Earth_movers kernel(surface.triangles(), 0, measure);
  EXPECT_TRUE(kernel.has_own_lengths());
  Mass_distribution before, after;
  before.at_locations = {{surface.at(3), 1.}};
  after.at_locations = {{surface.at(18), 1.}};
  const Streamlines streamlines = kernel.streamlines(kernel.solve(before, after));
  for(const Grain& grain : streamlines.grains(20))
  {
    const Streamline line = streamlines(grain);
    EXPECT_TRUE(line.has_arrived);
    for(const Location& location : line.locations)
    {
      const Planar p = plane(surface, location);
      EXPECT_FALSE(p[0] > 1. + rounding && p[0] < 1.2 - rounding && p[1] < 0.8 - rounding);
    }
  }
}

// Around a cylinder, the longer way: it is pulled taut, unless no path is known to be as long.
TEST(streamlines, give_way_to_shorter_paths)
{
  const Glued_surface surface(cylinder(24, 4, 1., 1.));
  std::vector<Index> around;
  for(Index i = 0; i <= 14; ++i)
    around.push_back(48 + i);
  const std::vector<Location> line = surface.along(around);
  const double side = 2. * std::sin(pi / 24.), scale = surface.scale();
  Line_shortener shorten(surface.triangles());
  EXPECT_NEAR(scale * path_length(surface.t(), shorten(line, 14. * side / scale)), 14. * side,
              rounding);
  const std::vector<Location> other = shorten(line, 10. * side / scale);
  EXPECT_NEAR(scale * path_length(surface.t(), other), 10. * side, rounding);
  expect_path_on_surface(surface.t(), other, line.front(), line.back());
}

} // namespace
