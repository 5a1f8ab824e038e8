// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Region_transport_solver.h>

#include <CGAL/Geodesic_processing/geodesic_distances.h>
#include <CGAL/Geodesic_processing/locate_on_surface.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"
#include "openmesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <vector>

namespace Region_transport_solver_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Relative round-off error of sums of some hundred terms and of some tens of back substitutions.
constexpr double round_off = 1e-9;

// The default tolerance.
constexpr double relative_gap = 1e-3;

// Returns a vertex of the unit square with 12 by 12 cells.
Vertex at(Mesh::size_type column, Mesh::size_type row) { return Vertex(13 * row + column); }

TEST(Region_transport_solver, finds_nearest_exit)
{
  const Mesh mesh = mesh_of(square(12));
  const std::vector<Vertex> exits = {at(0, 0), at(12, 9)};
  GP::Region_transport_solver<Mesh> solver(mesh, exits);
  const auto value = [&](const auto& from)
  {
    const GP::Earth_movers_cost cost = solver.compute(from);
    EXPECT_TRUE(cost.is_converged);
    EXPECT_LE(cost.lower, cost.value);
    EXPECT_LE(cost.upper - cost.lower, relative_gap * cost.upper);
    return cost.value;
  };
  // Costs of one unit of mass, with the relative gap.
  EXPECT_NEAR(value(at(3, 0)), 0.25, 0.25 * relative_gap);
  EXPECT_NEAR(solver.arrival(exits[0]), 1., relative_gap); // relative gap
  EXPECT_NEAR(solver.potential(at(3, 0)), -0.25, 0.25 * relative_gap);
  EXPECT_NEAR(value(at(12, 0)), 0.75, 0.75 * relative_gap);
  EXPECT_NEAR(solver.arrival(exits[1]), 1., relative_gap);
  EXPECT_EQ(solver.arrival(at(5, 5)), 0.);
  EXPECT_NEAR(value(std::vector<Vertex>{at(3, 0), at(12, 0)}), 0.5,
              0.5 * relative_gap);                          // half of the mass each
  EXPECT_NEAR(solver.arrival(exits[0]), 0.5, relative_gap); // relative gap
  EXPECT_EQ(solver.compute(exits[1]).value, 0.);
  EXPECT_NEAR(solver.arrival(exits[1]), 1., round_off);
}

// The region is the boundary: masses also arrive on the edges between its vertices.
TEST(Region_transport_solver, accepts_boundary_sources)
{
  Mesh mesh = mesh_of(square(12));
  std::vector<GP::Source<Mesh>> boundary;
  GP::border_sources(mesh, std::back_inserter(boundary));
  GP::Region_transport_solver<Mesh> solver(mesh, boundary);
  const double center_cost = solver.compute(at(6, 6)).value;
  EXPECT_LE(center_cost, 0.5 * (1. + relative_gap));
  EXPECT_GE(center_cost,
            0.5 - 0.5 / 24.); // discretization error if there are several shortest paths
  EXPECT_NEAR(solver.compute(at(2, 7)).value, 1. / 6., relative_gap / 6.);
  auto arrivals = vertex_map(mesh);
  solver.write_arrivals(arrivals);
  double sum = 0.;
  for(const Vertex v : vertices(mesh))
    sum += arrivals[v];
  EXPECT_NEAR(sum, 1., round_off);
}

// Triangles at the boundary have obtuse angles, at which hat functions of two vertices have
// gradients in similar directions.
TEST(Region_transport_solver, arrivals_are_not_negative)
{
  const Mesh mesh = mesh_of(square(12, 0.3));
  std::vector<GP::Source<Mesh>> boundary;
  GP::border_sources(mesh, std::back_inserter(boundary));
  GP::Region_transport_solver<Mesh> solver(mesh, boundary);
  for(const Vertex from : {at(6, 6), at(1, 1), at(11, 4), at(3, 10), at(0, 5)})
  {
    solver.compute(from);
    double sum = 0.;
    for(const Vertex v : vertices(mesh))
    {
      EXPECT_GE(solver.arrival(v), 0.);
      sum += solver.arrival(v);
    }
    EXPECT_NEAR(sum, 1., round_off);
  }
}

// Returns the cost from vertex 0 to the vertices near a great circle, for any type and size of
// mesh.
template <typename AnyMesh>
double cost_to_great_circle(double scale = 1.)
{
  const Triangulation shape = icosphere(3);
  Numbered<AnyMesh> sphere;
  fill(sphere, scaled(shape, scale));
  std::vector<typename boost::graph_traits<AnyMesh>::vertex_descriptor> ring;
  const Point& base = shape.points[0];
  for(std::size_t i = 0; i < shape.points.size(); ++i)
    if(const Point& p = shape.points[i];
       std::abs(p[0] * base[0] + p[1] * base[1] + p[2] * base[2]) < 0.05)
      ring.push_back(sphere.vertices[i]);
  GP::Region_transport_solver<AnyMesh> solver(sphere.mesh, ring);
  return solver.compute(sphere.vertices[0]).value;
}

TEST(Region_transport_solver, accepts_all_meshes_and_scales)
{
  const double value = cost_to_great_circle<Mesh>();
  EXPECT_NEAR(value, 0.5 * std::acos(-1.), 0.06); // half the width of the band of vertices
  EXPECT_EQ(cost_to_great_circle<CGAL::Polyhedron_3<Kernel>>(), value);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  EXPECT_NEAR(cost_to_great_circle<OpenMesh::TriMesh_ArrayKernelT<>>(), value,
              1e-5); // single precision
#endif
  for(const double scale : {1e-6, 1e6})
    EXPECT_NEAR(cost_to_great_circle<Mesh>(scale), scale * value, round_off * scale);
}

TEST(Region_transport_solver, works_on_clouds)
{
  const Surfels surfels = sphere_surfels(4);
  CGAL::Point_set_3<Kernel::Point_3> cloud(true);
  for(const auto& [point, normal] : surfels)
    cloud.insert(point, normal);
  using Index = CGAL::Point_set_3<Kernel::Point_3>::Index;
  const std::vector<Index> region = {Index(3), Index(1000), Index(2000)};
  GP::Region_transport_solver<CGAL::Point_set_3<Kernel::Point_3>> solver(cloud, region);
  double exact = 10.;
  for(const Index& i : region)
    exact = std::min(exact, 2. * std::asin(0.5 * std::sqrt(CGAL::squared_distance(
                                                     cloud.point(i), cloud.point(Index(500))))));
  EXPECT_NEAR(solver.compute(Index(500)).value, exact, 0.015 * exact); // as between two surfels
}

// Mass that arrives between surfels is distributed to the corners of a triangle, which preserves
// its center.
TEST(Region_transport_solver, accepts_locations_between_surfels)
{
  const Surfels surfels = sphere_surfels(3);
  using Cloud = CGAL::Point_set_3<Kernel::Point_3>;
  Cloud cloud(true);
  for(const auto& [point, normal] : surfels)
    cloud.insert(point, normal);
  const auto domain = GP::make_domain(cloud);
  const auto location = GP::locate_on_surface(domain, Kernel::Point_3(0.3, 0.5, 0.8));
  GP::Region_transport_solver<Cloud> solver(domain, location);
  solver.compute(std::vector<Cloud::Index>{Cloud::Index(500), Cloud::Index(100)});
  Kernel::Vector_3 center(0., 0., 0.);
  double sum = 0.;
  std::size_t number_of_arrivals = 0;
  for(const Cloud::Index& i : cloud)
  {
    EXPECT_TRUE(solver.is_reachable(i));
    const double arrival = solver.arrival(i);
    number_of_arrivals += std::abs(arrival) > round_off;
    sum += arrival;
    center = center + arrival * (cloud.point(i) - CGAL::ORIGIN);
  }
  // Round-off errors of the conservation of mass.
  EXPECT_NEAR(sum, 1., round_off);
  EXPECT_LE(number_of_arrivals, 3u);
  const auto expected = domain.point(domain.inner(location));
  EXPECT_LT(std::sqrt(CGAL::squared_distance(CGAL::ORIGIN + center, expected)), round_off);
}

// Checks capacities and spreading with three exits in one row. The nearest one has too little
// capacity.
template <typename AnyMesh>
void expect_limits(double size)
{
  Numbered<AnyMesh> square;
  fill(square, scaled(GP::test::square(12), size));
  const auto vertex_at = [&](Mesh::size_type column, Mesh::size_type row)
  { return square.vertices[at(column, row).idx()]; };
  using Source = GP::Source<AnyMesh>;
  const std::vector<Source> exits = {Source(vertex_at(12, 6)), Source(vertex_at(0, 6)),
                                     Source(vertex_at(8, 6))};
  const std::vector<double> capacities = {1., 0.4, 0.25};
  GP::Region_transport_solver<AnyMesh> solver(
      square.mesh, exits, GP::parameters::capacities(capacities).number_of_refinements(0u));
  const GP::Earth_movers_cost cost = solver.compute(vertex_at(5, 6));
  EXPECT_TRUE(cost.is_converged);
  EXPECT_LE(cost.number_of_iterations, 30);
  const double exact = size * (0.25 * 3. + 0.4 * 5. + 0.35 * 7.) / 12.;
  EXPECT_NEAR(cost.value, exact, relative_gap * exact);
  // The errors that the gap allows.
  const double arrival_error = 0.01;
  EXPECT_NEAR(solver.arrival(vertex_at(8, 6)), 0.25, arrival_error);
  EXPECT_NEAR(solver.arrival(vertex_at(0, 6)), 0.4, arrival_error);
  EXPECT_NEAR(solver.arrival(vertex_at(12, 6)), 0.35, arrival_error);
  // The interior point method ends inside the limits.
  EXPECT_LE(solver.arrival(vertex_at(8, 6)), 0.25 * (1. + round_off));
  // One more unit of mass would take the last exit.
  EXPECT_NEAR(solver.potential(vertex_at(5, 6)), -size * 7. / 12., 0.01 * size);

  GP::Region_transport_solver<AnyMesh> spreading_solver(
      square.mesh, exits,
      GP::parameters::spreading_weight(1e3 * size * size * size).number_of_refinements(0u));
  spreading_solver.compute(vertex_at(5, 6));
  // The areas of the exits have the ratio 1 : 1 : 2, because two exits are on the boundary.
  EXPECT_NEAR(spreading_solver.arrival(vertex_at(8, 6)), 0.5, 1e-3);
  EXPECT_NEAR(spreading_solver.arrival(vertex_at(0, 6)), 0.25, 1e-3);
}

TEST(Region_transport_solver, respects_limits)
{
  for(const double size : {1e-6, 1., 1e6})
    expect_limits<Mesh>(size);
  expect_limits<CGAL::Polyhedron_3<Kernel>>(1.);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  expect_limits<OpenMesh::TriMesh_ArrayKernelT<>>(1.);
#endif
}

// Arrivals inside a face are distributed to its vertices, with the location as their center of
// mass.
TEST(Region_transport_solver, mass_leaves_a_full_exit)
{
  const Mesh mesh = mesh_of(square(12));
  const std::vector<Vertex> exits = {at(3, 6), at(6, 6), at(9, 6)};
  GP::Region_transport_solver<Mesh> solver(
      mesh, exits, GP::parameters::capacities(std::vector<double>{1., 0.4, 1.}));
  const GP::Earth_movers_cost cost = solver.compute(exits[1]);
  EXPECT_NEAR(cost.value, 0.6 * 0.25, 0.6 * 0.25 * relative_gap);
  // Arrivals have the accuracy of the bounds.
  EXPECT_NEAR(solver.arrival(exits[1]), 0.4, relative_gap);
  EXPECT_NEAR(solver.arrival(exits[0]) + solver.arrival(exits[2]), 0.6, relative_gap);
}

TEST(Region_transport_solver, accepts_locations_in_faces)
{
  const Mesh mesh = mesh_of(square(8, 0.2));
  const auto left = location_of(10, {0.3, 0.3, 0.4}), right = location_of(100, {0.2, 0.5, 0.3});
  const auto point = [&](const auto& location)
  { return CGAL::Polygon_mesh_processing::construct_point(location, mesh); };
  const Vertex from(40);
  const double to_left = std::sqrt(CGAL::squared_distance(mesh.point(from), point(left))),
               to_right = std::sqrt(CGAL::squared_distance(mesh.point(from), point(right)));
  using Solver = GP::Region_transport_solver<Mesh>;
  Solver one(mesh, left);
  EXPECT_NEAR(one.compute(from).value, to_left, 2e-3 * to_left); // relative gap
  double mass = 0., x = 0., y = 0.;
  for(const Vertex v : vertices(mesh))
  {
    mass += one.arrival(v);
    x += one.arrival(v) * mesh.point(v).x();
    y += one.arrival(v) * mesh.point(v).y();
    EXPECT_TRUE(one.is_reachable(v));
  }
  EXPECT_NEAR(mass, 1., round_off);
  EXPECT_NEAR(x, point(left).x(), round_off);
  EXPECT_NEAR(y, point(left).y(), round_off);
  Solver with_capacities(
      mesh, std::vector{left, right},
      GP::parameters::capacities(std::vector<double>{0.25, 1.}).number_of_refinements(0u));
  const double nearest = std::min(to_left, to_right), farthest = std::max(to_left, to_right);
  const double exact = to_left < to_right ? 0.25 * nearest + 0.75 * farthest : nearest;
  EXPECT_NEAR(with_capacities.compute(from).value, exact,
              0.03); // a fraction of an edge length at the separation of flows
  // Streamlines end at the location.
  const GP::Streamline<Mesh> line = one.streamlines()(from);
  ASSERT_FALSE(line.empty());
  EXPECT_LT(std::sqrt(CGAL::squared_distance(line.points.back(), point(left))),
            0.2); // an edge length
}

TEST(Region_transport_solver, throws_on_invalid_region)
{
  const Mesh mesh = mesh_of(disjoint_union(square(4), square(4)));
  using Solver = GP::Region_transport_solver<Mesh>;
  EXPECT_THROW(Solver(mesh, std::vector<Vertex>()), GP::Invalid_argument_error);
  EXPECT_THROW(Solver(mesh, Vertex(99)), GP::Invalid_argument_error);
  EXPECT_THROW(Solver(mesh, location_of(0, {0.5, 0.8, 0.})), GP::Invalid_argument_error);
  EXPECT_NO_THROW(Solver(mesh, location_of(0, {0., 1., 0.})));
  Solver solver(mesh, Vertex(3));
  EXPECT_THROW(solver.arrival(Vertex(3)), GP::Invalid_argument_error);
  EXPECT_THROW(solver.compute(Vertex(30)), GP::Invalid_argument_error);
  EXPECT_THROW(solver.compute(Vertex(0), GP::parameters::tolerance(0.)),
               GP::Invalid_argument_error);
}

} // namespace Region_transport_solver_test
