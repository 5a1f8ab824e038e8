// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/streamlines.h>

#include <CGAL/Geodesic_processing/internal/transport/Multilevel_transport_solver.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>
#include "core/unfold.h"

#include "Array_surface.h"
#include "clouds.h"
#include "path_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace streamlines_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of some hundred steps.
constexpr double round_off = 1e-12;

// Returns the fluxes of a linear field on a flat surface. Its divergence must be `source_density`.
Continuous_flow linear_flow(const Array_surface& surface, const std::function<Vec2(Vec2)>& field,
                            double source_density)
{
  const Surface_arrays& t = surface.t();
  Continuous_flow result;
  result.outward_flux.resize(t.corner.size());
  result.absorbed_mass.resize(t.number_of_triangles());
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    const Point &p = surface.point(surface.caller_vertex(t.corner[h])),
                &q = surface.point(surface.caller_vertex(t.corner[next_halfedge(h)]));
    const Vec2 vector = field({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])});
    result.outward_flux[h] = cross(vector, Vec2{q[0] - p[0], q[1] - p[1]});
  }
  const std::vector<double> area = operators(t).area;
  for(std::size_t f = 0; f < area.size(); ++f)
    result.absorbed_mass[f] = -source_density * surface.scale() * surface.scale() * area[f];
  return result;
}

Moved_masses uniform_masses(const Array_surface& surface, double before)
{
  Moved_masses result;
  result.source_masses =
      before * surface.scale() * surface.scale() * lumped_mass(operators(surface.t()));
  result.target_masses = result.source_masses;
  return result;
}

Vec2 planar_position(const Array_surface& surface, const Surface_location& location)
{
  const auto p = coordinates(surface.t(), location);
  return {p[0], p[1]};
}

void expect_near(const Vec2& p, const Vec2& q)
{
  EXPECT_NEAR(p[0], q[0], round_off);
  EXPECT_NEAR(p[1], q[1], round_off);
}

Streamline checked_line(const Streamlines& streamlines, const Array_surface& surface,
                        const Streamline_seed& seed)
{
  const Streamline result = streamlines(seed);
  expect_path_on_surface(surface.t(), result.locations, result.locations.front(),
                         result.locations.back());
  return result;
}

// A uniform flow of density 2 moves all mass by the same vector.
TEST(streamlines, uniform_flow_moves_mass_straight)
{
  const Array_surface surface(square(12, 0.24));
  const Vec2 displacement = {0.3, 0.1};
  const Streamlines streamlines(surface.triangles(),
                                linear_flow(
                                    surface, [&](Vec2) { return 2. * displacement; }, 0.),
                                uniform_masses(surface, 2.));
  std::size_t inside = 0;
  for(const Streamline_seed& seed : streamlines.seeds(50))
  {
    const Streamline line = checked_line(streamlines, surface, seed);
    const Vec2 from = planar_position(surface, line.locations.front());
    for(const Surface_location& location : line.locations)
      EXPECT_NEAR(cross(planar_position(surface, location) - from, displacement), 0., round_off);
    if(from[0] > 0.69 || from[1] > 0.89)
      continue;
    ++inside;
    EXPECT_TRUE(line.has_arrived);
    expect_near(planar_position(surface, line.locations.back()), from + displacement);
  }
  EXPECT_GT(inside, 25u);
}

// A contracting flow reduces areas by the factor by which the density increases.
TEST(streamlines, follows_contracting_flow)
{
  const Array_surface surface(square(12, 0.24));
  const Vec2 center = {0.45, 0.55};
  // The divergence is -2, hence a density of 1 increases to 3.
  const Streamlines streamlines(surface.triangles(),
                                linear_flow(
                                    surface, [&](Vec2 p) { return center - p; }, -2.),
                                uniform_masses(surface, 1.));
  for(const Streamline_seed& seed : streamlines.seeds(50))
  {
    const Streamline line = checked_line(streamlines, surface, seed);
    const Vec2 from = planar_position(surface, line.locations.front());
    EXPECT_TRUE(line.has_arrived);
    expect_near(planar_position(surface, line.locations.back()),
                center + std::sqrt(1. / 3.) * (from - center));
  }
}

// A streamline without mass must follow the flow to its end.
TEST(streamlines, zero_mass_follows_flow_to_sink)
{
  const Array_surface surface(square(12, 0.24));
  const Vec2 center = {0.45, 0.55};
  const Streamlines streamlines(surface.triangles(),
                                linear_flow(
                                    surface, [&](Vec2 p) { return center - p; }, -2.),
                                uniform_masses(surface, 0.));
  const Streamline line = checked_line(streamlines, surface, {surface.in(7, {0.2, 0.3, 0.5})});
  EXPECT_TRUE(line.has_arrived);
  expect_near(planar_position(surface, line.locations.back()), center);
}

TEST(streamlines, ends_in_closed_or_zero_flow)
{
  const Array_surface surface(square(12, 0.24));
  const Streamlines rotating(surface.triangles(),
                             linear_flow(
                                 surface,
                                 [&](Vec2 p) {
                                   return Vec2{0.5 - p[1], p[0] - 0.5};
                                 },
                                 0.),
                             uniform_masses(surface, 0.));
  const Surface_location from = surface.in(100, {0.2, 0.3, 0.5});
  EXPECT_FALSE(rotating({from}).has_arrived);
  // A rotation is not a Raviart-Thomas field, but the streamline still encloses the center.
  EXPECT_GT(rotating({from}).locations.size(), 10u);
  const Streamlines resting(surface.triangles(),
                            linear_flow(
                                surface,
                                [](Vec2) {
                                  return Vec2{0., 0.};
                                },
                                0.),
                            uniform_masses(surface, 0.));
  EXPECT_FALSE(resting({from}).has_arrived);
  EXPECT_EQ(resting({from}).locations.size(), 1u);
}

// A flow from one point mass to two others. The number of streamlines that arrive at each must be
// proportional to its mass.
struct Two_target_flow
{
  Multilevel_transport_solver solver;
  Mass_distribution from, to;
  std::vector<Index> targets;

  Two_target_flow(const std::shared_ptr<const Surface_arrays>& t, Index source, Index first,
                  Index second)
      : solver(t), targets({first, second})
  {
    from.at_locations = {{{none, source, {}}, 1.}};
    to.at_locations = {{{none, first, {}}, 0.3}, {{none, second, {}}, 0.7}};
  }

  // Calls f with each of a hundred streamlines.
  template <typename Function>
  void check(const Surface_arrays& t, Function f)
  {
    Transport_options options;
    options.tolerance = 1e-5;
    const Streamlines streamlines = solver.streamlines(solver.solve(from, to, options));
    std::vector<int> number_arrived(2, 0);
    for(const Streamline_seed& seed : streamlines.seeds(100))
    {
      const Streamline line = streamlines(seed);
      ASSERT_TRUE(line.has_arrived);
      EXPECT_EQ(vertex_of(t, line.locations.front()), from.at_locations[0].first.vertex);
      for(std::size_t i = 0; i < 2; ++i)
        number_arrived[i] += vertex_of(t, line.locations.back()) == targets[i];
      f(line);
    }
    // For each triangle or edge at the source, the number may be wrong by one.
    EXPECT_NEAR(number_arrived[0], 30, 4);
    EXPECT_EQ(number_arrived[0] + number_arrived[1], 100);
  }
};

TEST(streamlines, arrivals_match_masses)
{
  for(const Triangulation& shape :
      {jittered(icosphere(3), 0.02), cylinder(24, 8, 1., 2.), torus(40, 16), square(16, 0.24)})
  {
    const Array_surface surface(shape);
    const Index n = surface.size();
    Two_target_flow two_target_flow(surface.triangles(), surface.vertex(n / 2), surface.vertex(3),
                                    surface.vertex(n - 5));
    two_target_flow.check(surface.t(),
                          [&](const Streamline& line) {
                            expect_path_on_surface(surface.t(), line.locations, surface.at(n / 2),
                                                   line.locations.back());
                          });
  }
}

TEST(streamlines, arrivals_match_masses_on_clouds)
{
  const Cloud cloud = octahedron_sphere(3);
  const Surfel_arrays surfels = build_surfel_arrays(cloud.points, cloud.normals);
  const auto t = std::make_shared<const Surface_arrays>(surfels.arrays);
  Two_target_flow two_target_flow(t, surfels.internal_vertex[0], surfels.internal_vertex[100],
                                  surfels.internal_vertex[230]);
  two_target_flow.check(
      *t,
      [&](const Streamline& line)
      {
        // Each step must be an edge of a triangle, and no vertex may occur twice.
        std::vector<Index> vertices;
        for(const Surface_location& location : line.locations)
          vertices.push_back(vertex_of(*t, location));
        for(std::size_t i = 0; i + 1 < vertices.size(); ++i)
        {
          bool is_edge = false;
          for(Index h = 0; h < t->corner.size(); ++h)
            is_edge =
                is_edge ||
                (t->corner[h] == vertices[i] && t->corner[next_halfedge(h)] == vertices[i + 1]) ||
                (t->corner[h] == vertices[i + 1] && t->corner[next_halfedge(h)] == vertices[i]);
          EXPECT_TRUE(is_edge);
        }
        std::sort(vertices.begin(), vertices.end());
        EXPECT_EQ(std::adjacent_find(vertices.begin(), vertices.end()), vertices.end());
      });
}

// Point masses inside triangles must be reached exactly.
TEST(streamlines, begins_and_ends_inside_triangles)
{
  const Array_surface surface(jittered(icosphere(2), 0.03));
  const Multilevel_transport_solver solver(surface.triangles());
  const Surface_location from = surface.in(3, {0.2, 0.5, 0.3}),
                         to = surface.in(250, {0.1, 0.1, 0.8});
  Mass_distribution before, after;
  before.at_locations = {{from, 2.}};
  after.at_locations = {{to, 2.}};
  const Streamlines streamlines = solver.streamlines(solver.solve(before, after));
  for(const Streamline_seed& seed : streamlines.seeds(20))
    expect_path_on_surface(surface.t(), streamlines(seed).locations, from, to);
}

// No streamline may pass a blocked region.
TEST(streamlines, avoids_obstacles)
{
  const Array_surface surface(grid(20, 10,
                                   [](double x, double y) -> Point {
                                     return {2. * x, y, 0.};
                                   }));
  std::vector<Metric_tensor> metric(surface.t().number_of_triangles(), {1., 0., 1.});
  for(Index f = 0; f < metric.size(); ++f)
  {
    const auto p = coordinates(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}});
    if(p[0] > 1. && p[0] < 1.2 && p[1] < 0.8)
      metric[f] = {infinity, 0., infinity};
  }
  const Multilevel_transport_solver solver(surface.triangles(), 0, metric);
  EXPECT_TRUE(solver.has_surface_metric());
  Mass_distribution before, after;
  before.at_locations = {{surface.at(3), 1.}};
  after.at_locations = {{surface.at(18), 1.}};
  const Streamlines streamlines = solver.streamlines(solver.solve(before, after));
  for(const Streamline_seed& seed : streamlines.seeds(20))
  {
    const Streamline line = streamlines(seed);
    EXPECT_TRUE(line.has_arrived);
    for(const Surface_location& location : line.locations)
    {
      const Vec2 p = planar_position(surface, location);
      EXPECT_FALSE(p[0] > 1. + round_off && p[0] < 1.2 - round_off && p[1] < 0.8 - round_off);
    }
  }
}

// The path leads around a cylinder on the longer side. It is kept if the lower bound permits,
// otherwise replaced by the path on the other side.
TEST(streamlines, is_replaced_by_shorter_path)
{
  const Array_surface surface(cylinder(24, 4, 1., 1.));
  std::vector<Index> around_vertices;
  for(Index i = 0; i <= 14; ++i)
    around_vertices.push_back(48 + i);
  const std::vector<Surface_location> line = surface.along(around_vertices);
  const double h = 2. * std::sin(pi / 24.), scale = surface.scale();
  Line_shortener shortener(surface.triangles());
  EXPECT_NEAR(scale * path_length(surface.t(), shortener(line, 14. * h / scale)), 14. * h,
              round_off);
  const std::vector<Surface_location> shortened = shortener(line, 10. * h / scale);
  EXPECT_NEAR(scale * path_length(surface.t(), shortened), 10. * h, round_off);
  expect_path_on_surface(surface.t(), shortened, line.front(), line.back());
}

} // namespace streamlines_test
