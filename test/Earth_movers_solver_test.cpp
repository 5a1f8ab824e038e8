// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Earth_movers_solver.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/property_map.h>

#include "Mesh_of.h"
#include "openmesh.h"

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace Earth_movers_solver_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Vector_3 = Kernel::Vector_3;

// Relative round-off error of sums of some hundred terms and of some tens of back substitutions.
constexpr double round_off = 1e-9;

// The default tolerance. In the plane, distances between points are exact up to this gap.
constexpr double relative_gap = 1e-3;

double great_circle(const Kernel::Point_3& p, const Kernel::Point_3& q)
{
  return 2. * std::asin(0.5 * std::sqrt(CGAL::squared_distance(p, q)));
}

TEST(Earth_movers_solver, accepts_all_kinds_of_masses)
{
  Mesh mesh = mesh_of(square(10, 0.24));
  GP::Earth_movers_solver<Mesh> solver(mesh);
  const Vertex corner(0), middle(5), next(10);
  const auto value = [&](const auto& from, const auto& to)
  {
    const GP::Earth_movers_cost cost = solver.compute(from, to);
    EXPECT_TRUE(cost.is_converged);
    EXPECT_LE(cost.lower, cost.value);
    EXPECT_LE(cost.value, cost.upper);
    EXPECT_LE(cost.upper - cost.lower, relative_gap * cost.upper);
    EXPECT_LT(cost.residual, round_off); // round-off errors
    EXPECT_EQ(cost.upper_continuous, GP::internal::infinity);
    return cost.value;
  };
  EXPECT_NEAR(value(corner, next), 1., relative_gap);
  const auto barycentric_at_corner = location_of(0, {1., 0., 0.}),
             inside = location_of(0, {0.2, 0.4, 0.4});
  const auto point = [&](const auto& location)
  { return CGAL::Polygon_mesh_processing::construct_point(location, mesh); };
  const double exact =
      std::sqrt(CGAL::squared_distance(point(barycentric_at_corner), point(inside)));
  EXPECT_NEAR(value(barycentric_at_corner, inside), exact, relative_gap * exact);
  const std::vector<Vertex> below = {corner, next};
  const std::set<Vertex> above = {Vertex(110), Vertex(120)};
  EXPECT_NEAR(value(below, above), 1., relative_gap); // half of the mass each
  auto left = vertex_map(mesh), right = vertex_map(mesh);
  left[corner] = 2.;
  left[next] = -1.;
  right[middle] = 1.;
  EXPECT_NEAR(value(left, right), 1.5,
              2. * relative_gap); // a unit mass moves by 1 to the negative mass, another by 0.5
  const auto uniform =
      GP::mass_density(boost::make_function_property_map<Vertex>([](const Vertex&) { return 1.; }));
  EXPECT_EQ(solver.compute(uniform, uniform).value, 0.);
  // The mean distance from a corner, up to the discretization error around it.
  const double mean = (std::sqrt(2.) + std::asinh(1.)) / 3.;
  EXPECT_NEAR(value(uniform, corner), mean, 0.05 * mean);
}

// Returns the distance between vertices 0 and 100 of an icosphere, for any type of mesh.
template <typename AnyMesh>
GP::Earth_movers_cost cost_on_sphere(double scale = 1.)
{
  Numbered<AnyMesh> sphere;
  fill(sphere, scaled(icosphere(3), scale));
  GP::Earth_movers_solver<AnyMesh> solver(sphere.mesh);
  return solver.compute(sphere.vertices[0], sphere.vertices[100],
                        GP::parameters::do_bound_from_above(true));
}

TEST(Earth_movers_solver, accepts_all_meshes_and_scales)
{
  const GP::Earth_movers_cost cost = cost_on_sphere<Mesh>();
  const Mesh mesh = mesh_of(icosphere(3));
  const double exact = great_circle(mesh.point(Vertex(0)), mesh.point(Vertex(100)));
  EXPECT_NEAR(cost.value, exact, 0.01 * exact);           // the mesh is coarse
  EXPECT_GT(cost.upper_continuous, exact * (1. - 0.005)); // polyhedral distances are 0.5 % shorter
  using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  EXPECT_EQ(cost_on_sphere<CGAL::Polyhedron_3<Exact_kernel>>().value, cost.value);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  // The coordinates of this mesh have single precision.
  EXPECT_NEAR(cost_on_sphere<OpenMesh::TriMesh_ArrayKernelT<>>().value, cost.value, 1e-5);
#endif
  for(const double scale : {1e-6, 1e6})
  {
    EXPECT_NEAR(cost_on_sphere<Mesh>(scale).value, scale * cost.value, round_off * scale);
    EXPECT_NEAR(cost_on_sphere<Mesh>(scale).upper_continuous, scale * cost.upper_continuous,
                round_off * scale);
  }
}

TEST(Earth_movers_solver, works_on_clouds)
{
  const Surfels surfels = sphere_surfels(4);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  GP::Earth_movers_solver<Surfels> solver(surfels, maps);
  CGAL::Point_set_3<Kernel::Point_3> points(true);
  for(const auto& [point, normal] : surfels)
    points.insert(point, normal);
  GP::Earth_movers_solver<CGAL::Point_set_3<Kernel::Point_3>> other(points);
  for(const std::size_t to : {100u, 1000u, 2000u})
  {
    const double exact = great_circle(surfels[7].first, surfels[to].first);
    const double value = solver.compute(std::size_t(7), to).value;
    EXPECT_NEAR(value, exact, 0.015 * exact); // as on a mesh with triangles of this size
    const auto index = [](std::size_t i) { return CGAL::Point_set_3<Kernel::Point_3>::Index(i); };
    EXPECT_EQ(other.compute(index(7), index(to)).value, value);
  }

  // The flow is tangential to the surface. It is concentrated near the ends and exceeds one there.
  std::vector<Vector_3> flow(surfels.size());
  std::vector<double> potential(surfels.size());
  solver.compute(std::size_t(7), std::size_t(2000));
  solver.write_flow(
      boost::make_iterator_property_map(flow.begin(), CGAL::Identity_property_map<std::size_t>()));
  solver.write_potential(boost::make_iterator_property_map(
      potential.begin(), CGAL::Identity_property_map<std::size_t>()));
  double max_magnitude = 0.;
  for(std::size_t i = 0; i < surfels.size(); ++i)
  {
    const double size = std::sqrt(flow[i].squared_length());
    // Triangles that span ten degrees deviate by five degrees from the tangent plane.
    EXPECT_LE(std::abs(flow[i] * surfels[i].second), 0.1 * size);
    max_magnitude = std::max(max_magnitude, size);
  }
  EXPECT_GT(max_magnitude, 1.);
  EXPECT_THROW(
      solver.compute(std::size_t(7), std::size_t(9), GP::parameters::do_bound_from_above(true)),
      GP::Unsupported_surface_error);
}

TEST(Earth_movers_solver, writes_flow_and_potential)
{
  Mesh mesh = mesh_of(jittered(icosphere(3), 0.01));
  const Vertex from(3), to(500);
  const auto flow = mesh.add_property_map<Face, Vector_3>().first;
  const auto potential = vertex_map(mesh);
  for(const unsigned refinements : {0u, 1u})
  {
    GP::Earth_movers_solver<Mesh> solver(mesh, GP::parameters::number_of_refinements(refinements));
    const GP::Earth_movers_cost cost = solver.compute(from, to);
    solver.write_flow(flow);
    solver.write_potential(potential);
    EXPECT_NEAR(potential[to] - potential[from], cost.lower, round_off);
    EXPECT_EQ(solver.potential(to), potential[to]);
    double length = 0.;
    Vector_3 moment = CGAL::NULL_VECTOR;
    for(const Face f : mesh.faces())
    {
      const auto h = mesh.halfedge(f);
      const auto &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                 &r = mesh.point(mesh.target(mesh.next(h)));
      const Vector_3 normal = CGAL::cross_product(q - p, r - p);
      const double area = 0.5 * std::sqrt(normal.squared_length());
      EXPECT_LT(std::abs(flow[f] * normal), round_off * (1. + std::sqrt(flow[f].squared_length())));
      length += area * std::sqrt(flow[f].squared_length());
      moment = moment + area * flow[f];
    }
    // The mean of the vectors of four triangles is shorter than the mean of their lengths.
    EXPECT_LT(length, cost.upper + round_off);
    EXPECT_GT(length, cost.upper - (refinements == 0 ? round_off : 0.01));
    // The integral of the flow times the gradient of a coordinate is the change of the coordinate.
    EXPECT_LT((moment - (mesh.point(to) - mesh.point(from))).squared_length(), 1e-18);
  }
}

TEST(Earth_movers_solver, respects_speeds_and_metrics)
{
  Mesh mesh = mesh_of(square(12, 0.24));
  const Vertex from(0), to(168);
  const auto value = [&](const auto& np)
  {
    GP::Earth_movers_solver<Mesh> solver(mesh, np);
    return solver.compute(from, to).value;
  };
  const auto speed = mesh.add_property_map<Face, double>("f:speed", 0.5).first;
  EXPECT_NEAR(value(GP::parameters::face_speed_map(speed)), 2. * std::sqrt(2.), 4. * relative_gap);
  // Lengths along x are doubled.
  const Eigen::Matrix3d longer = Eigen::Vector3d(4., 1., 1.).asDiagonal();
  const auto face_metric = mesh.add_property_map<Face, Eigen::Matrix3d>("f:metric", longer).first;
  const auto vertex_metric =
      mesh.add_property_map<Vertex, Eigen::Matrix3d>("v:metric", longer).first;
  EXPECT_NEAR(value(GP::parameters::face_metric_map(face_metric)), std::sqrt(5.),
              3. * relative_gap);
  EXPECT_NEAR(value(GP::parameters::metric_map(vertex_metric)), std::sqrt(5.), 3. * relative_gap);
  EXPECT_NEAR(value(GP::parameters::face_metric_map(face_metric).face_speed_map(speed)),
              2. * std::sqrt(5.), 6. * relative_gap);
  // Vertices and faces both convert to the keys of a map of a vector.
  std::vector<Eigen::Matrix3d> metrics, face_metrics;
  for(const Vertex v : mesh.vertices())
    metrics.push_back(vertex_metric[v] = (1. + mesh.point(v).x()) * longer);
  for(const Face f : mesh.faces())
    face_metrics.push_back(face_metric[f] = (1. + 0.1 * double(f % 7)) * longer);
  EXPECT_EQ(value(GP::parameters::metric_map(CGAL::make_property_map(metrics))),
            value(GP::parameters::metric_map(vertex_metric)));
  EXPECT_EQ(value(GP::parameters::face_metric_map(CGAL::make_property_map(face_metrics))),
            value(GP::parameters::face_metric_map(face_metric)));
  face_metric[Face(17)] = Eigen::Vector3d(1., 0., 1.).asDiagonal();
  EXPECT_THROW(value(GP::parameters::face_metric_map(face_metric)), GP::Invalid_argument_error);
  speed[Face(17)] = -1.;
  EXPECT_THROW(value(GP::parameters::face_speed_map(speed)), GP::Invalid_argument_error);
}

TEST(Earth_movers_solver, methods_agree)
{
  const Mesh mesh = mesh_of(jittered(icosphere(2), 0.03));
  GP::Earth_movers_solver<Mesh> solver(mesh);
  const double value = solver.compute(Vertex(0), Vertex(50)).value;
  const auto np = GP::parameters::tolerance(0.01);
  const auto cold_start = solver.compute<GP::Alternating_directions>(Vertex(0), Vertex(50), np);
  EXPECT_NEAR(cold_start.value, value, 0.01 * value); // the requested gap
  const auto warm_start = solver.compute<GP::Alternating_directions>(Vertex(0), Vertex(50),
                                                                     np.do_start_from_last(true));
  EXPECT_NEAR(warm_start.value, value, 0.01 * value); // the requested gap
  EXPECT_LT(warm_start.number_of_iterations, cold_start.number_of_iterations);
  // The requested gap.
  EXPECT_NEAR(solver.compute<GP::Weiszfeld>(Vertex(0), Vertex(50), np).value, value, 0.01 * value);
  const auto stopped =
      solver.compute(Vertex(0), Vertex(50), GP::parameters::maximum_number_of_iterations(2));
  EXPECT_EQ(stopped.number_of_iterations, 2u);
  EXPECT_FALSE(stopped.is_converged);
}

TEST(Earth_movers_solver, can_be_cancelled)
{
  const Mesh mesh = mesh_of(icosphere(3));
  GP::Earth_movers_solver<Mesh> solver(mesh);
  unsigned calls = 0;
  double last_fraction = 0.;
  const std::function<bool(double)> rising = [&](double fraction)
  {
    EXPECT_GE(fraction, last_fraction);
    last_fraction = fraction;
    return true;
  };
  solver.compute(Vertex(0), Vertex(300), GP::parameters::callback(rising));
  EXPECT_GT(last_fraction, 0.5);
  EXPECT_LE(last_fraction, 1.);
  const double potential = solver.potential(Vertex(300));
  const std::function<bool(double)> callback = [&](double) { return ++calls < 3; };
  EXPECT_THROW(solver.compute(Vertex(0), Vertex(200),
                              GP::parameters::callback(callback).tolerance(round_off)),
               GP::Cancelled);
  EXPECT_EQ(calls, 3u);
  EXPECT_EQ(solver.potential(Vertex(300)), potential);
}

TEST(Earth_movers_solver, likelihood_is_smoothed_by_diffusion)
{
  Mesh mesh = mesh_of(square(16));
  GP::Earth_movers_solver<Mesh> solver(mesh);
  solver.compute(Vertex(0), Vertex(288));
  const auto raw = vertex_map(mesh), smoothed = vertex_map(mesh);
  solver.write_likelihood(raw);
  solver.write_likelihood(smoothed, GP::parameters::smoothing_radius(0.1));
  const auto relative_variation = [&](const auto& likelihood)
  {
    double result = 0., sum = 0.;
    for(const double value : values(mesh, likelihood))
      sum += value;
    for(const auto e : mesh.edges())
      result += std::abs(likelihood[mesh.vertex(e, 0)] - likelihood[mesh.vertex(e, 1)]);
    return result / sum;
  };
  for(const auto& likelihood : {raw, smoothed})
  {
    const std::vector<double> all = values(mesh, likelihood);
    EXPECT_EQ(*std::max_element(all.begin(), all.end()), 1.);
    EXPECT_GE(*std::min_element(all.begin(), all.end()), 0.);
  }
  EXPECT_LT(relative_variation(smoothed), 0.8 * relative_variation(raw)); // the radius is 1.6 edges
  for(const double radius : {-1., std::nan(""), GP::internal::infinity})
    EXPECT_THROW(solver.write_likelihood(smoothed, GP::parameters::smoothing_radius(radius)),
                 GP::Invalid_argument_error);
}

TEST(Earth_movers_solver, throws_on_invalid_masses)
{
  Mesh mesh = mesh_of(disjoint_union(square(4), square(4)));
  GP::Earth_movers_solver<Mesh> solver(mesh);
  EXPECT_THROW(solver.compute(Vertex(0), Vertex(30)), GP::Invalid_argument_error);
  EXPECT_THROW(solver.compute(Vertex(0), Vertex(99)), GP::Invalid_argument_error);
  EXPECT_THROW(solver.compute(std::vector<Vertex>(), Vertex(3)), GP::Invalid_argument_error);
  const auto masses = vertex_map(mesh);
  masses[Vertex(4)] = 3.;
  EXPECT_THROW(solver.compute(masses, Vertex(3)), GP::Invalid_argument_error);
  EXPECT_NEAR(solver.compute(masses, Vertex(0), GP::parameters::do_normalize(true)).value, 1.,
              relative_gap);
  for(const double tolerance : {0., -1., std::nan("")})
    EXPECT_THROW(solver.compute(Vertex(0), Vertex(3), GP::parameters::tolerance(tolerance)),
                 GP::Invalid_argument_error);
  const Mesh empty;
  EXPECT_THROW(GP::Earth_movers_solver<Mesh>{empty}, GP::Unsupported_surface_error);
}

} // namespace Earth_movers_solver_test
