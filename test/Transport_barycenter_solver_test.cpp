// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Transport_barycenter_solver.h>

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"
#include "openmesh.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace Transport_barycenter_solver_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Relative round-off error of sums of some hundred terms and of some tens of back substitutions.
constexpr double round_off = 1e-9;

// The default tolerance.
constexpr double relative_gap = 0.01;
const double pi = std::acos(-1.);

// Returns a vertex of the unit square with 12 by 12 cells.
Vertex at(Mesh::size_type column, Mesh::size_type row) { return Vertex(13 * row + column); }

TEST(Transport_barycenter_solver, finds_midpoint_of_two_points)
{
  const Mesh mesh = mesh_of(square(12));
  GP::Transport_barycenter_solver<Mesh> solver(mesh);
  const std::vector<Vertex> points = {at(1, 2), at(9, 8)};
  const GP::Transport_barycenter_cost cost = solver.compute(points);
  const double exact = 0.5 * (std::pow(8. / 12., 2) + std::pow(6. / 12., 2)); // d^2 / 2
  EXPECT_TRUE(cost.is_converged);
  EXPECT_GE(cost.lower, (1. - relative_gap) * cost.upper);
  EXPECT_LE(cost.lower, exact * (1. + round_off));
  EXPECT_GE(cost.upper, exact * (1. - round_off));
  EXPECT_EQ(cost.value, 0.5 * (cost.lower + cost.upper));
  EXPECT_LT(cost.residual, round_off);
  ASSERT_EQ(cost.distances.size(), 2u);
  for(const double distance :
      cost.distances) // d / 2; a cost that is 1 % too large allows an error of 10 %
    EXPECT_NEAR(distance, std::sqrt(0.5 * exact), 0.1 * std::sqrt(0.5 * exact));
  double sum = 0.;
  for(const Vertex v : vertices(mesh))
    sum += solver.mass(v);
  EXPECT_NEAR(sum, 1., round_off);
  // With weights 1 and w, the cost is w / (1 + w) d^2.
  const auto cost_for = [&](const auto& weights)
  { return solver.compute(points, GP::parameters::weights(weights)); };
  const GP::Transport_barycenter_cost weighted = cost_for(std::vector<double>{1., 3.});
  EXPECT_LE(weighted.lower, 0.75 * 2. * exact * (1. + round_off));
  EXPECT_GE(weighted.upper, 0.75 * 2. * exact * (1. - round_off));
  EXPECT_EQ(cost_for(std::array<int, 2>{0, 5}).value, 0.);
  EXPECT_NEAR(solver.mass(points[1]), 1., round_off);
}

TEST(Transport_barycenter_solver, accepts_all_kinds_of_masses)
{
  Mesh mesh = mesh_of(square(12, 0.2));
  GP::Transport_barycenter_solver<Mesh> solver(mesh, GP::parameters::number_of_refinements(0u));
  const std::vector<Vertex> points = {at(2, 2), at(10, 3), at(6, 11)};
  const double value = solver.compute(points).value;
  std::vector<Mesh::Property_map<Vertex, double>> maps;
  std::vector<std::vector<Vertex>> groups;
  for(const Vertex point : points)
  {
    maps.push_back(mesh.add_property_map<Vertex, double>("mass " + std::to_string(point)).first);
    maps.back()[point] = 2.;
    groups.push_back({point, point});
  }
  EXPECT_NEAR(solver.compute(maps).value, 4. * value, round_off * value);
  EXPECT_NEAR(solver.compute(maps, GP::parameters::do_normalize(true)).value, value,
              round_off * value);
  EXPECT_NEAR(solver.compute(groups).value, value, round_off * value);
  // The barycenter of equal densities is the density.
  auto density = mesh.add_property_map<Vertex, double>("density", 3.).first;
  const std::vector<GP::Mass_density<decltype(density)>> same(3, GP::mass_density(density));
  // The value is a square of distances.
  EXPECT_LT(solver.compute(same).value, round_off * round_off);
  auto found = mesh.add_property_map<Vertex, double>("found").first;
  solver.write_density(found);
  double sum = 0.;
  for(const Vertex v : vertices(mesh))
  {
    sum += solver.mass(v);
    EXPECT_NEAR(found[v], 3., round_off);
  }
  EXPECT_NEAR(sum, 3., round_off); // density 3 times the area of the unit square
  // Locations inside faces.
  const std::vector<std::pair<Face, std::array<double, 3>>> locations = {
      location_of(0, {0.2, 0.3, 0.5}), location_of(100, {1., 0., 0.})};
  EXPECT_TRUE(solver.compute(locations).is_converged);
}

// Returns the cost of the barycenter of three points, for any type and size of mesh.
template <typename AnyMesh>
double cost_on_sphere(double scale = 1.)
{
  Numbered<AnyMesh> sphere;
  fill(sphere, scaled(icosphere(2), scale));
  const std::vector<typename boost::graph_traits<AnyMesh>::vertex_descriptor> points = {
      sphere.vertices[0], sphere.vertices[50], sphere.vertices[101]};
  GP::Transport_barycenter_solver<AnyMesh> solver(sphere.mesh);
  return solver.compute(points).value;
}

TEST(Transport_barycenter_solver, accepts_all_meshes_and_scales)
{
  const double value = cost_on_sphere<Mesh>();
  EXPECT_EQ(cost_on_sphere<CGAL::Polyhedron_3<Kernel>>(), value);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  EXPECT_NEAR(cost_on_sphere<OpenMesh::TriMesh_ArrayKernelT<>>(), value, 1e-4); // single precision
#endif
  for(const double scale : {1e-6, 1e6})
    EXPECT_NEAR(cost_on_sphere<Mesh>(scale), scale * scale * value, 1e-6 * scale * scale);
}

TEST(Transport_barycenter_solver, error_decreases_under_refinement)
{
  const Mesh mesh = mesh_of(jittered(icosphere(2), 0.05));
  const std::vector<Vertex> points = {Vertex(0), Vertex(101)};
  const auto value = [&](unsigned refinements)
  {
    GP::Transport_barycenter_solver<Mesh> solver(
        mesh, GP::parameters::number_of_refinements(refinements));
    const auto cost = solver.compute(points, GP::parameters::tolerance(1e-3));
    double sum = 0.;
    for(const Vertex v : vertices(mesh))
      sum += solver.mass(v);
    EXPECT_NEAR(sum, 1., round_off);
    return cost.value;
  };
  GP::Earth_movers_solver<Mesh> distances(mesh, GP::parameters::number_of_refinements(3u));
  const double distance = distances.compute(points[0], points[1]).estimate;
  const double exact = 0.5 * distance * distance;
  EXPECT_LT(value(0), value(1)); // the difference is much larger than the gap
  EXPECT_LT(value(1), exact);
  EXPECT_NEAR(value(1), exact, 0.01 * exact); // ten times the gap, for the discretization
}

TEST(Transport_barycenter_solver, works_on_clouds)
{
  const Surfels surfels = sphere_surfels(4);
  CGAL::Point_set_3<Kernel::Point_3> cloud(true);
  for(const auto& [point, normal] : surfels)
    cloud.insert(point, normal);
  using Index = CGAL::Point_set_3<Kernel::Point_3>::Index;
  GP::Transport_barycenter_solver<CGAL::Point_set_3<Kernel::Point_3>> solver(
      cloud, GP::parameters::number_of_refinements(0u));
  const auto cost = solver.compute(std::vector<Index>{Index(0), Index(700)});
  EXPECT_TRUE(cost.is_converged);
  const auto p = cloud.point(Index(0)), q = cloud.point(Index(700));
  const double d = std::acos((p - CGAL::ORIGIN) * (q - CGAL::ORIGIN));
  // Distances on this cloud are up to 0.5 % too short, their squares up to 1 %.
  EXPECT_NEAR(cost.value, 0.5 * d * d, 0.5 * d * d * (0.5 * relative_gap + 0.01));
  double sum = 0.;
  for(const Index& i : cloud)
    sum += solver.mass(i);
  EXPECT_NEAR(sum, 1., round_off);
}

// Doubling the speed halves distances, and paths avoid a wall of speed zero.
TEST(Transport_barycenter_solver, respects_speeds)
{
  Mesh mesh = mesh_of(square(12));
  const std::vector<Vertex> points = {at(2, 6), at(10, 6)};
  auto speed = mesh.add_property_map<Face, double>("speed", 2.).first;
  const auto value = [&]
  {
    return GP::Transport_barycenter_solver<Mesh>(mesh, GP::parameters::face_speed_map(speed))
        .compute(points)
        .value;
  };
  const double exact = 0.25 * 0.5 * std::pow(8. / 12., 2);
  EXPECT_NEAR(value(), exact, relative_gap * exact);
  for(const Face f : faces(mesh)) // a wall in the lower 5/6
  {
    const auto h = mesh.halfedge(f);
    const auto c = CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                  mesh.point(mesh.target(mesh.next(h))));
    if(c.x() > 0.5 && c.x() < 7. / 12. && c.y() < 10. / 12.)
      speed[f] = 0.;
  }
  const double path_length =
      std::hypot(4., 4.) + 1. + std::hypot(3., 4.); // around the corners of the wall
  const double exact_around_wall = 0.25 * 0.5 * std::pow(path_length / 12., 2);
  EXPECT_NEAR(value(), exact_around_wall,
              0.02 * exact_around_wall); // a fraction of an edge length is lost at the corners
}

// In the plane, the integral of a flow is the displacement of the center of mass, for any speed.
// The integral of its length, divided by the speed, is the distance.
TEST(Transport_barycenter_solver, writes_flows)
{
  Mesh mesh = mesh_of(square(12, 0.2));
  const std::vector<Vertex> points = {at(2, 2), at(10, 3), at(6, 11)};
  const auto speed = mesh.add_property_map<Face, double>("speed", 2.).first;
  auto flow = mesh.add_property_map<Face, Kernel::Vector_3>("flow").first;
  for(const unsigned refinements : {0u, 1u})
  {
    GP::Transport_barycenter_solver<Mesh> solver(
        mesh, GP::parameters::number_of_refinements(refinements).face_speed_map(speed));
    EXPECT_THROW(solver.write_flow(0, flow), GP::Invalid_argument_error);
    const auto cost = solver.compute(points);
    Kernel::Vector_3 center_of_mass(0., 0., 0.);
    for(const Vertex v : vertices(mesh))
      center_of_mass = center_of_mass + solver.mass(v) * (mesh.point(v) - CGAL::ORIGIN);
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      solver.write_flow(i, flow);
      Kernel::Vector_3 flow_integral(0., 0., 0.);
      double length = 0.;
      for(const Face f : faces(mesh))
      {
        const auto h = mesh.halfedge(f);
        const double area =
            std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                         mesh.point(mesh.target(mesh.next(h)))));
        flow_integral = flow_integral + area * flow[f];
        length += area * std::sqrt(flow[f].squared_length());
      }
      const Kernel::Vector_3 difference =
          mesh.point(points[i]) - CGAL::ORIGIN - center_of_mass - flow_integral;
      EXPECT_LT(std::sqrt(difference.squared_length()), round_off); // round-off errors
      EXPECT_LE(0.5 * length, cost.distances[i] * (1. + round_off));
      if(refinements == 0)
      {
        EXPECT_NEAR(0.5 * length, cost.distances[i], round_off);
      }
    }
    EXPECT_THROW(solver.write_flow(3, flow), GP::Invalid_argument_error);
  }
}

TEST(Transport_barycenter_solver, warm_start_saves_iterations)
{
  const Mesh mesh = mesh_of(icosphere(3));
  const std::vector<Vertex> points = {Vertex(0), Vertex(200), Vertex(300)};
  GP::Transport_barycenter_solver<Mesh> solver(mesh);
  const auto cost = solver.compute(points);
  const auto warm_started = solver.compute(points, GP::parameters::do_start_from_last(true));
  EXPECT_LT(warm_started.number_of_iterations, cost.number_of_iterations);
  EXPECT_TRUE(warm_started.is_converged);
  EXPECT_THROW(
      solver.compute(std::vector<Vertex>{Vertex(0)}, GP::parameters::do_start_from_last(true)),
      GP::Invalid_argument_error);
  EXPECT_THROW(solver.compute(points, GP::parameters::callback(std::function<bool(double)>(
                                          [](double) { return false; }))),
               GP::Cancelled);
  const auto few_iterations =
      solver.compute(points, GP::parameters::maximum_number_of_iterations(10u));
  EXPECT_EQ(few_iterations.number_of_iterations, 10u);
  EXPECT_FALSE(few_iterations.is_converged);
}

TEST(Transport_barycenter_solver, throws_on_invalid_input)
{
  Mesh mesh = mesh_of(tetrahedron());
  GP::Transport_barycenter_solver<Mesh> solver(mesh);
  const std::vector<Vertex> points = {Vertex(0), Vertex(1)};
  using Error = GP::Invalid_argument_error;
  const auto expect_throws = [&](const auto& masses, const auto& np)
  { EXPECT_THROW(solver.compute(masses, np), Error); };
  const auto valid_options = GP::parameters::tolerance(0.01);
  expect_throws(std::vector<Vertex>{}, valid_options);
  expect_throws(std::vector<Vertex>{Vertex(0), Vertex(4)}, valid_options);
  expect_throws(std::vector<std::vector<Vertex>>{{Vertex(0)}, {}}, valid_options);
  expect_throws(points, GP::parameters::tolerance(0.));
  for(const auto& weights : std::vector<std::vector<double>>{{1.},
                                                             {1., 2., 3.},
                                                             {1., -1.},
                                                             {0., 0.},
                                                             {1., std::nan("")},
                                                             {1., GP::internal::infinity}})
    expect_throws(points, GP::parameters::weights(weights));
  auto one = vertex_map(mesh), other = vertex_map(mesh);
  const std::vector<decltype(one)> both = {one, other};
  const auto expect_throws_for_masses = [&](double first, double second, bool do_normalize)
  {
    one[Vertex(0)] = first;
    other[Vertex(1)] = second;
    expect_throws(both, GP::parameters::do_normalize(do_normalize));
  };
  expect_throws_for_masses(1., 2., false);
  expect_throws_for_masses(0., 0., false);
  expect_throws_for_masses(0., 1., true);
  expect_throws_for_masses(-1., -1., true);
  expect_throws_for_masses(std::nan(""), 1., false);
  expect_throws_for_masses(std::nan(""), 1., true);
  expect_throws_for_masses(std::numeric_limits<double>::infinity(), 1., true);
}

} // namespace Transport_barycenter_solver_test
