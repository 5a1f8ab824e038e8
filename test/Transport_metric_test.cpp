// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Transport_metric.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

namespace Transport_metric_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

Point_set point_set_of(const Surfels& surfels)
{
  Point_set result(true);
  for(const auto& [point, normal] : surfels)
    result.insert(point, normal);
  return result;
}

// Checks that pairs, matrices and maps are consistent on a domain, for some of its locations.
template <typename Domain, typename Vertex_or_location>
void expect_consistent_metric(const Domain& domain,
                              const std::vector<Vertex_or_location>& locations)
{
  using Metric = GP::Transport_metric<typename Domain::Surface>;
  for(const std::size_t k : {0, 12})
  {
    const Metric metric(domain, k);
    EXPECT_GE(metric.basis_size(), k);
    const double tolerance = 1e-3; // the requested gap
    const Eigen::MatrixXd d =
        metric.distance_matrix(locations, GP::parameters::tolerance(tolerance));
    ASSERT_EQ(d.rows(), Eigen::Index(locations.size()));
    EXPECT_EQ(d, Eigen::MatrixXd(d.transpose()));
    EXPECT_EQ(d, (metric.template distance_matrix<CGAL::Parallel_tag>(
                     locations, GP::parameters::tolerance(tolerance).number_of_threads(3))));
    for(Eigen::Index i = 0; i < d.rows(); ++i)
      for(Eigen::Index j = 0; j < d.cols(); ++j)
      {
        const GP::Earth_movers_cost cost =
            metric.cost(locations[i], locations[j], GP::parameters::tolerance(tolerance));
        EXPECT_TRUE(cost.is_converged);
        EXPECT_LE(cost.upper - cost.lower, tolerance * cost.upper);
        EXPECT_LT(cost.residual, 1e-9); // round-off errors with some hundred unknowns
        EXPECT_EQ(metric.distance(locations[i], locations[j], GP::parameters::tolerance(tolerance)),
                  cost.value);
        EXPECT_EQ(metric.distance(locations[j], locations[i], GP::parameters::tolerance(tolerance)),
                  cost.value);
        EXPECT_EQ(i == j, cost.upper == 0.);
        // Without a basis, fields have single precision. With one, the order of summation differs.
        EXPECT_NEAR(d(i, j), cost.value, (k == 0 ? 1e-5 : tolerance) * cost.upper);
      }
  }
}

// Checks that a distance map over all vertices equals the distances of pairs.
template <typename Surface, typename Map, typename Key>
void expect_map_matches_pairs(const GP::Transport_metric<Surface>& metric, Map map,
                              const std::vector<Key>& keys)
{
  metric.write_distances(keys[0], map);
  EXPECT_EQ(get(map, keys[0]), 0.);
  double sum = 0.;
  for(std::size_t i = 1; i < keys.size(); ++i)
  {
    const GP::Earth_movers_cost cost = metric.cost(keys[0], keys[i]);
    EXPECT_GE(get(map, keys[i]), cost.lower * (1. - 1e-6)); // sums in single precision
    sum += get(map, keys[i]) / cost.upper - 1.;
  }
  // Measured are at most 0.1 %.
  EXPECT_LT(sum / double(keys.size()), 0.003);
  const std::vector<double> previous_upper = {get(map, keys[1]), get(map, keys.back())};
  metric.template write_distances<CGAL::Parallel_tag>(keys[0], map,
                                                      GP::parameters::number_of_threads(3));
  EXPECT_EQ(get(map, keys[1]), previous_upper[0]);
  EXPECT_EQ(get(map, keys.back()), previous_upper[1]);
}

TEST(Transport_metric, is_consistent_on_meshes_and_clouds)
{
  const Triangulation sphere = jittered(icosphere(2), 0.03);
  Mesh mesh = mesh_of(sphere);
  const std::vector<Vertex> vertices = {Vertex(0), Vertex(5), Vertex(100), Vertex(77)};
  expect_consistent_metric(GP::make_domain(mesh), vertices);
  std::mt19937 random(1);
  std::vector<GP::Location<Mesh>> locations;
  for(int i = 0; i < 4; ++i)
    locations.push_back(random_location_of(mesh, random));
  expect_consistent_metric(GP::make_domain(mesh), locations);

  Numbered<CGAL::Polyhedron_3<Kernel>> polyhedron;
  fill(polyhedron, sphere);
  expect_consistent_metric(GP::make_domain(polyhedron.mesh),
                           std::vector{polyhedron.vertices[0], polyhedron.vertices[100]});

  const Point_set cloud = point_set_of(sphere_surfels(2));
  const std::vector<Point_set::Index> surfels = {*cloud.begin(), *(cloud.begin() + 60),
                                                 *(cloud.begin() + 130)};
  expect_consistent_metric(GP::make_domain(cloud), surfels);
  expect_consistent_metric(GP::make_domain(cloud),
                           std::vector<GP::Location<Point_set>>{{surfels[0], {0.01, 0.02}},
                                                                {surfels[1], {0., 0.}},
                                                                {surfels[2], {-0.01, 0.}}});
}

TEST(Transport_metric, distance_map_matches_pairs)
{
  const Triangulation sphere = jittered(icosphere(3), 0.02);
  Mesh mesh = mesh_of(sphere);
  Point_set cloud = point_set_of(sphere_surfels(3));
  auto surfel_distances = cloud.add_property_map<double>("distance", 0.).first;
  std::vector<Vertex> vertices;
  std::vector<Point_set::Index> surfels;
  for(std::size_t i = 3; i < 640; i += 40)
  {
    vertices.push_back(Vertex(Mesh::size_type(i)));
    surfels.push_back(*(cloud.begin() + std::ptrdiff_t(i)));
  }
  for(const std::size_t k : {0, 12})
  {
    expect_map_matches_pairs(GP::Transport_metric<Mesh>(mesh, k), vertex_map(mesh), vertices);
    expect_map_matches_pairs(GP::Transport_metric<Point_set>(cloud, k), surfel_distances, surfels);
  }
}

// Distances scale with the surface. Scaling by powers of two is exact; other factors round
// coordinates.
TEST(Transport_metric, is_unit_invariant)
{
  const Triangulation shape = torus(20, 10);
  const Mesh mesh = mesh_of(shape);
  for(const double scale : {1e-6, 1e6})
    for(const std::size_t k : {0, 12})
    {
      const Mesh other = mesh_of(scaled(shape, scale));
      const GP::Transport_metric<Mesh> metric(mesh, k), other_metric(other, k);
      EXPECT_EQ(metric.basis_size(), other_metric.basis_size());
      for(const std::size_t i : {7, 50, 111})
      {
        const Vertex to{Mesh::size_type(i)};
        const double expected =
            scale * metric.distance(Vertex(0), to, GP::parameters::tolerance(1e-5));
        // Each of the two has the requested gap.
        EXPECT_NEAR(other_metric.distance(Vertex(0), to, GP::parameters::tolerance(1e-5)), expected,
                    2e-5 * expected);
      }
    }
}

// Returns a sheet that is rolled up while its columns of squares stay planar. Rolling preserves
// lengths.
Triangulation rolled_sheet(std::size_t columns, std::size_t rows, double angle)
{
  std::vector<std::array<double, 2>> line = {{0., 0.}};
  for(std::size_t i = 0; i < columns; ++i)
  {
    const double direction = angle * double(i) / double(columns);
    line.push_back({line.back()[0] + std::cos(direction), line.back()[1] + std::sin(direction)});
  }
  return grid(columns, rows,
              [&](double u, double v)
              {
                const auto& p = line[std::size_t(std::lround(u * double(columns)))];
                return Point{p[0], p[1], v * double(rows)};
              });
}

TEST(Transport_metric, is_isometry_invariant)
{
  const Mesh flat = mesh_of(rolled_sheet(24, 8, 0.)), rolled = mesh_of(rolled_sheet(24, 8, 4.));
  for(const std::size_t k : {0, 12})
  {
    const GP::Transport_metric<Mesh> metric(flat, k), rolled_metric(rolled, k);
    EXPECT_EQ(metric.basis_size(), rolled_metric.basis_size());
    for(const std::size_t i : {7, 50, 111, 224})
    {
      const Vertex to{Mesh::size_type(i)};
      const GP::Earth_movers_cost expected = metric.cost(Vertex(0), to),
                                  found = rolled_metric.cost(Vertex(0), to);
      // Coordinates are rounded, and eigenfunctions have limited precision.
      EXPECT_LE(found.lower, expected.upper * (1. + 1e-6));
      EXPECT_LE(expected.lower, found.upper * (1. + 1e-6));
    }
  }
}

TEST(Transport_metric, decreases_towards_geodesic_distance)
{
  const Mesh mesh = mesh_of(square(20, 0.24));
  const auto domain = GP::make_domain(mesh);
  const Vertex p(Mesh::size_type(0)), q(Mesh::size_type(440));
  for(const GP::Transport_flow flow : {GP::Transport_flow::gradient, GP::Transport_flow::balanced})
  {
    double previous_upper = infinity;
    for(const std::size_t k : {0, 5, 50, 200})
    {
      const GP::Transport_metric<Mesh> metric(domain, k, GP::parameters::transport_flow(flow));
      EXPECT_EQ(metric.flow(), flow);
      const GP::Earth_movers_cost cost = metric.cost(p, q);
      EXPECT_LE(cost.lower, previous_upper);
      previous_upper = cost.upper;
    }
    // The paper's distance between points exceeds the exact one by this factor for every basis
    // size.
    EXPECT_LT(previous_upper, 1.26 * std::sqrt(2.));
    // Masses distributed in triangles around points may shorten the distance.
    EXPECT_GT(previous_upper, 0.99 * std::sqrt(2.));
  }
}

// The cost equals that of the written flow: for masses on all vertices, densities and locations.
TEST(Transport_metric, accepts_all_kinds_of_masses)
{
  Mesh mesh = mesh_of(square(12, 0.24));
  auto low = mesh.add_property_map<Vertex, double>("low", 0.).first;
  auto high = mesh.add_property_map<Vertex, double>("high", 0.).first;
  for(const Vertex v : vertices(mesh))
  {
    low[v] = 1.;
    high[v] = 2. * mesh.point(v).x();
  }
  auto flow = mesh.add_property_map<Face, Kernel::Vector_3>("flow").first;
  const auto measured = GP::parameters::flow_map(flow).tolerance(1e-4);
  const double round_off = 1e-12; // of sums over 288 faces
  const auto cost_of_flow = [&]
  {
    double result = 0.;
    for(const Face f : faces(mesh))
      result +=
          std::sqrt(flow[f].squared_length()) * CGAL::Polygon_mesh_processing::face_area(f, mesh);
    return result;
  };
  for(const std::size_t k : {0, 30})
  {
    const GP::Transport_metric<Mesh> metric(mesh, k);
    // From density 1 to density 2 x: all mass moves along x, by the integral of x - x * x.
    const GP::Earth_movers_cost ramp =
        metric.cost(GP::mass_density(low), GP::mass_density(high), measured);
    EXPECT_NEAR(ramp.upper, cost_of_flow(), round_off);
    EXPECT_NEAR(ramp.value, 1. / 6., 0.5 / (12. * 12.)); // of the order of the squared edge length

    // Sums of masses, and equal distributions.
    const std::vector<Vertex> corners = {Vertex(0), Vertex(168)};
    const GP::Earth_movers_cost apart = metric.cost(corners, Vertex(84), measured);
    EXPECT_NEAR(apart.upper, cost_of_flow(), round_off);
    // Moving each half on its own is feasible.
    EXPECT_LE(apart.lower,
              0.5 * (metric.distance(corners[0], Vertex(84), GP::parameters::tolerance(1e-6)) +
                     metric.distance(corners[1], Vertex(84), GP::parameters::tolerance(1e-6))));
    EXPECT_EQ(metric.distance(low, low), 0.);
    EXPECT_THROW(metric.cost(low, Vertex(0)), GP::Invalid_argument_error);
    const GP::Earth_movers_cost spread =
        metric.cost(low, Vertex(84), GP::parameters::do_normalize(true));
    EXPECT_GT(spread.lower, 0.3); // the mean distance of a square's points from its center is 0.38
  }
}

TEST(Transport_metric, bounds_hold_if_stopped)
{
  const Mesh mesh = mesh_of(icosphere(2));
  const GP::Transport_metric<Mesh> metric(mesh, 20);
  const GP::Earth_movers_cost stopped = metric.cost(
      Vertex(0), Vertex(70), GP::parameters::maximum_number_of_iterations(8u).tolerance(1e-6));
  const GP::Earth_movers_cost complete =
      metric.cost(Vertex(0), Vertex(70), GP::parameters::tolerance(1e-6));
  EXPECT_EQ(stopped.number_of_iterations, 8u);
  EXPECT_FALSE(stopped.is_converged);
  EXPECT_TRUE(complete.is_converged);
  EXPECT_LE(stopped.lower, complete.upper);
  EXPECT_LE(complete.lower, stopped.upper);
  int number_of_calls = 0;
  const std::function<bool(double)> cancel = [&number_of_calls](double)
  { return ++number_of_calls < 9; };
  EXPECT_THROW(metric.cost(Vertex(0), Vertex(70), GP::parameters::callback(cancel).tolerance(1e-6)),
               GP::Cancelled);
  EXPECT_EQ(number_of_calls, 9);
}

TEST(Transport_metric, is_infinite_between_components)
{
  Mesh mesh = mesh_of(disjoint_union(icosphere(1), torus(9, 6)));
  const Vertex ball(Mesh::size_type(0)), ring(Mesh::size_type(50));
  for(const std::size_t k : {0, 5})
  {
    const GP::Transport_metric<Mesh> metric(mesh, k);
    EXPECT_EQ(metric.distance(ball, ring), infinity);
    EXPECT_TRUE(metric.cost(ball, ring).is_converged);
    EXPECT_EQ(metric.distance_matrix(std::vector{ball, ring})(0, 1), infinity);
    auto map = vertex_map(mesh);
    metric.write_distances(ring, map);
    EXPECT_EQ(map[ball], infinity);
    EXPECT_LT(map[Vertex(Mesh::size_type(60))], 10.);
  }
}

TEST(Transport_metric, accepts_surfaces_without_eigenfunctions)
{
  // All vertices are on the boundary, where the eigenfunctions are zero.
  const Mesh mesh = mesh_of(cylinder(3, 1, 2., 1.));
  const GP::Transport_metric<Mesh> metric(mesh, 3);
  EXPECT_EQ(metric.basis_size(), 0u);
  const GP::Earth_movers_cost cost = metric.cost(Vertex(0), Vertex(1));
  EXPECT_GT(cost.lower, 0.);
  EXPECT_LE(cost.lower, cost.upper);
}

TEST(Transport_metric, accepts_triangles_without_area)
{
  // Vertices 0 and 1 coincide, so that the gradients of the eigenfunctions are zero.
  const Mesh mesh =
      mesh_of(Triangulation{{{0., 0., 0.}, {0., 0., 0.}, {0., 0., 1.}}, {2, 1, 0, 0, 1, 2}});
  const GP::Transport_metric<Mesh> metric(mesh, 1);
  EXPECT_FALSE(std::isnan(metric.distance(Vertex(0), Vertex(2))));
}

TEST(Transport_metric, crosses_triangles_without_area)
{
  const Mesh mesh = mesh_of(rectangle_with_slit(8));
  const Vertex from(0), to(80);
  const double straight = std::sqrt(CGAL::squared_distance(mesh.point(from), mesh.point(to)));
  for(const std::size_t k : {0, 5})
  {
    const double distance = GP::Transport_metric<Mesh>(mesh, k).distance(from, to);
    // Flows are shorter than paths by up to an edge length at both ends; measured are 0.93 and 1.2.
    EXPECT_GT(distance, straight - 2.);
    EXPECT_LT(distance, 2. * straight);
  }
}

TEST(Transport_metric, can_be_cancelled)
{
  Mesh mesh = mesh_of(icosphere(1));
  const GP::Transport_metric<Mesh> metric(mesh, 3);
  const auto cancel =
      GP::parameters::callback(std::function<bool(double)>([](double) { return false; }));
  EXPECT_THROW(metric.write_distances(Vertex(0), vertex_map(mesh), cancel), GP::Cancelled);
  EXPECT_THROW(metric.distance_matrix(std::vector{Vertex(0), Vertex(1)}, cancel), GP::Cancelled);
}

TEST(Transport_metric, throws_on_invalid_location)
{
  const Mesh mesh = mesh_of(icosphere(1));
  const GP::Transport_metric<Mesh> metric(mesh);
  EXPECT_THROW(metric.distance(Vertex(0), Vertex(1000)), GP::Invalid_argument_error);
  EXPECT_THROW(metric.distance(Vertex(0), Vertex(1), GP::parameters::tolerance(0.)),
               GP::Invalid_argument_error);
  EXPECT_THROW(metric.distance(Vertex(0), location_of(0, {2., 0., 0.})),
               GP::Invalid_argument_error);
  const Mesh nothing;
  EXPECT_THROW(GP::Transport_metric<Mesh>{nothing}, GP::Unsupported_surface_error);
}

} // namespace Transport_metric_test
