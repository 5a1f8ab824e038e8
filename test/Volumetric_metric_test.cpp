// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Volumetric_metric.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>
#include <CGAL/Geodesic_processing/geodesic_distances.h>
#include <CGAL/Geodesic_processing/volumetric_distance.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

namespace Volumetric_metric_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Metric = GP::Volumetric_metric<Mesh>;
using Point_3 = Kernel::Point_3;

// Relative round-off error of sums of some hundred terms and of some tens of back substitutions.
constexpr double round_off = 1e-9;

// The default tolerance of the bounds.
constexpr double relative_gap = 1e-3;

// Returns two long parallel rooms, joined at one end: a U of cubes.
Triangulation u_shaped_room()
{
  return blocks(3, 2, 8, [](int x, int, int z) { return x != 1 || z == 0; });
}

std::vector<Point_3> random_points(std::size_t number, double size, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-size, size);
  std::vector<Point_3> result;
  for(std::size_t i = 0; i < number; ++i)
  {
    const double x = coordinate(random), y = coordinate(random);
    result.emplace_back(x, y, coordinate(random));
  }
  return result;
}

double euclidean_distance(const Point_3& p, const Point_3& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

TEST(Volumetric_metric, equals_transport_distance_on_surface)
{
  const Mesh mesh = mesh_of(jittered(icosphere(3), 0.02));
  const auto np = GP::parameters::number_of_refinements(2u);
  const Metric metric(mesh, np);
  GP::Earth_movers_solver<Mesh> solver(mesh, np);
  Mesh copy = mesh;
  auto exact = vertex_map(copy);
  GP::geodesic_distances<GP::Exact>(copy, Vertex(3), exact);
  for(const Vertex v : {Vertex(0), Vertex(100), Vertex(600)})
  {
    const GP::Earth_movers_cost cost = metric.cost(mesh.point(Vertex(3)), mesh.point(v));
    // At a mesh vertex, the coordinates are ones and zeros up to round-off errors.
    EXPECT_NEAR(cost.value, solver.compute(Vertex(3), v).value, round_off);
    EXPECT_LE(cost.lower, exact[v] * (1. + round_off));
    EXPECT_NEAR(cost.value, exact[v], 0.01 * exact[v]); // a fraction of the edge length 0.04
  }
}

TEST(Volumetric_metric, is_metric_above_euclidean_distance)
{
  for(const Triangulation& shape : {icosphere(2), u_shaped_room()})
  {
    const Metric metric(mesh_of(shape), GP::parameters::number_of_refinements(0u));
    const std::vector<Point_3> points = random_points(7, 2.5);
    std::vector<std::vector<GP::Earth_movers_cost>> d(points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      for(std::size_t j = 0; j < points.size(); ++j)
      {
        d[i].push_back(metric.cost(points[i], points[j]));
        const GP::Earth_movers_cost& cost = d[i][j];
        EXPECT_TRUE(cost.is_converged);
        EXPECT_LE(cost.upper - cost.lower, relative_gap * cost.upper);
        EXPECT_GE(cost.lower, euclidean_distance(points[i], points[j]));
        EXPECT_EQ(i == j, cost.upper == 0.);
        EXPECT_NEAR(cost.value, d[std::min(i, j)][std::max(i, j)].value, relative_gap * cost.upper);
      }
    for(std::size_t i = 0; i < points.size(); ++i)
      for(std::size_t j = 0; j < points.size(); ++j)
        for(std::size_t k = 0; k < points.size(); ++k)
          EXPECT_LE(d[i][j].lower, d[i][k].upper + d[k][j].upper);
  }
}

// Distances along a slab whose side walls are far away and have no influence.
TEST(Volumetric_metric, is_euclidean_between_parallel_planes)
{
  const Mesh mesh = mesh_of(blocks(20, 20, 1, [](int, int, int) { return true; }));
  const Metric metric(mesh);
  const double d = metric.distance(Point_3(5., 10., 0.5), Point_3(15., 10., 0.5));
  EXPECT_GE(d, 10. * (1. - relative_gap));
  EXPECT_LE(d, 10.1); // nearby masses take a detour of at most 1 %
}

TEST(Volumetric_metric, avoids_walls)
{
  const Metric metric(mesh_of(u_shaped_room()));
  const Point_3 end(0.5, 1., 7.5), other_end(2.5, 1., 7.5);
  const double inside = metric.distance(end, other_end);
  EXPECT_GT(inside, 2. * 6.5 + 1.); // along one room and back along the other
  EXPECT_LT(inside, 2. * 8. + 3.);  // along the outer walls
}

// Coordinates are positive, so all mass moves by at most the diameter.
TEST(Volumetric_metric, is_at_most_diameter_inside_convex_meshes)
{
  const Mesh mesh = mesh_of(icosphere(3));
  const Metric metric(mesh);
  const std::vector<Point_3> points = random_points(6, 0.55);
  for(const Point_3& p : points)
    for(const Point_3& q : points)
      EXPECT_LE(metric.cost(p, q).lower, std::acos(-1.));
}

TEST(Volumetric_metric, is_unit_invariant)
{
  const Point_3 p(0.1, 0.3, -0.2), q(1., 2., 0.);
  const double value = Metric(mesh_of(icosphere(2))).distance(p, q);
  for(const double scale : {1e-6, 1e6})
  {
    const CGAL::Aff_transformation_3<Kernel> scaling(CGAL::SCALING, scale);
    const Metric metric(mesh_of(scaled(icosphere(2), scale)));
    EXPECT_NEAR(metric.distance(scaling(p), scaling(q)), scale * value, round_off * scale);
  }
}

TEST(Volumetric_metric, writes_potential_and_flow)
{
  Mesh mesh = mesh_of(icosphere(3));
  const Metric metric(mesh, GP::parameters::number_of_refinements(0u));
  const auto potential = vertex_map(mesh);
  const auto coordinates_of_p = vertex_map(mesh), coordinates_of_q = vertex_map(mesh);
  const auto flow = mesh.add_property_map<Face, Kernel::Vector_3>().first;
  const Point_3 p(0.1, 0.3, -0.2), q(-0.4, 0.1, 0.5);
  const GP::Earth_movers_cost cost = metric.cost(
      p, q, GP::parameters::potential_map(potential).flow_map(flow).do_bound_from_above(true));
  GP::mean_value_coordinates(mesh, p, coordinates_of_p);
  GP::mean_value_coordinates(mesh, q, coordinates_of_q);
  double dual_value = 0.;
  for(const Vertex v : mesh.vertices())
    dual_value += potential[v] * (coordinates_of_q[v] - coordinates_of_p[v]);
  EXPECT_NEAR(std::max(dual_value, euclidean_distance(p, q)), cost.lower,
              1e-12); // round-off errors
  EXPECT_GE(cost.upper_continuous, cost.upper * (1. - round_off));
  // On either side, unit mass is gathered at vertices, which moves it by at most half an edge
  // length of 0.16.
  EXPECT_LE(cost.upper_continuous, cost.upper + 0.16);
  double length = 0.;
  for(const Face f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    length += std::sqrt(flow[f].squared_length() *
                        CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                           mesh.point(mesh.target(mesh.next(h)))));
  }
  EXPECT_NEAR(length, cost.upper, round_off);
}

TEST(Volumetric_metric, one_to_many_error_is_below_one_percent)
{
  const Metric metric(mesh_of(u_shaped_room()));
  const Point_3 from(0.5, 1., 7.5);
  const std::vector<Point_3> to = random_points(60, 5.);
  const auto found = metric.costs(from, to);
  const auto parallel =
      metric.costs<CGAL::Parallel_tag>(from, to, GP::parameters::number_of_threads(3));
  ASSERT_EQ(found.size(), to.size());
  for(std::size_t i = 0; i < to.size(); ++i)
  {
    EXPECT_TRUE(found[i].is_converged);
    EXPECT_EQ(found[i].value, parallel[i].value);
    if(i % 6 == 0)
    {
      const double value = metric.distance(from, to[i]);
      EXPECT_NEAR(found[i].value, value, (0.01 + relative_gap) * value);
    }
  }
  EXPECT_THROW(metric.costs(from, to,
                            GP::parameters::callback(
                                std::function<bool(double)>([](double) { return false; }))),
               GP::Cancelled);
}

// Returns the length of a path. Checks that no segment of it intersects the surface.
double length_of_path(const std::vector<Point_3>& path, const Mesh& mesh)
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  const CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(faces(mesh).begin(),
                                                                   faces(mesh).end(), mesh);
  double result = 0.;
  for(std::size_t i = 1; i < path.size(); ++i)
  {
    EXPECT_FALSE(tree.do_intersect(Kernel::Segment_3(path[i - 1], path[i])));
    result += euclidean_distance(path[i - 1], path[i]);
  }
  return result;
}

TEST(Volumetric_metric, paths_stay_inside)
{
  const Mesh mesh = mesh_of(u_shaped_room());
  const Metric metric(mesh, GP::parameters::number_of_refinements(0u));
  const Point_3 end(0.5, 1., 7.5), other_end(2.5, 1., 7.5);
  std::vector<Point_3> path;
  ASSERT_TRUE(metric.write_path(end, other_end, std::back_inserter(path)));
  EXPECT_EQ(path.front(), end);
  EXPECT_EQ(path.back(), other_end);
  const double length = length_of_path(path, mesh);
  EXPECT_GT(length, 2. * 6.5 + 1.); // around the wall between the rooms
  EXPECT_LT(length, 18.);
}

TEST(Volumetric_metric, finds_paths_outside)
{
  const Mesh mesh = mesh_of(icosphere(3));
  const Metric metric(mesh, GP::parameters::number_of_refinements(0u));
  std::vector<Point_3> path;
  ASSERT_TRUE(
      metric.write_path(Point_3(1.5, 0.1, 0.2), Point_3(-1.5, 0., 0.), std::back_inserter(path)));
  EXPECT_LT(length_of_path(path, mesh), 6.);
}

// A tetrahedron with its barycentric coordinates. The transport distance of two points inside is
// the cost of moving the differences of the coordinates, and the distance of the surface on it.
struct Tetrahedron
{
  Mesh mesh;
  explicit Tetrahedron(double scale = 1.)
  {
    CGAL::make_tetrahedron(Point_3(0., 0., 0.), Point_3(2. * scale, 0., 0.),
                           Point_3(0., 3. * scale, 0.), Point_3(0., 0., scale), mesh);
  }
  std::vector<double> coordinates(const Point_3& p) const
  {
    std::vector<double> result;
    for(const Vertex v : mesh.vertices())
    {
      std::vector<Point_3> q;
      for(const Vertex w : mesh.vertices())
        q.push_back(w == v ? p : mesh.point(w));
      std::vector<Point_3> r;
      for(const Vertex w : mesh.vertices())
        r.push_back(mesh.point(w));
      result.push_back(CGAL::volume(q[0], q[1], q[2], q[3]) / CGAL::volume(r[0], r[1], r[2], r[3]));
    }
    return result;
  }
};

TEST(Volumetric_metric, accepts_coordinates_of_a_tetrahedron)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Tetrahedron tetrahedron(scale);
    std::size_t calls = 0;
    const auto np = GP::parameters::barycentric_coordinates(
                        [&](const Point_3& p)
                        {
                          ++calls;
                          return tetrahedron.coordinates(p);
                        })
                        .number_of_refinements(3u);
    const Metric metric(tetrahedron.mesh, np);
    // On a tetrahedron, mean value coordinates are the barycentric coordinates.
    const Metric by_mean_value(tetrahedron.mesh, GP::parameters::number_of_refinements(3u));
    for(const auto& [p, q] : {std::pair(Point_3(0.2, 0.4, 0.3), Point_3(0.9, 0.6, 0.1)),
                              std::pair(Point_3(0., 0., 0.), Point_3(0.3, 0.3, 0.3)),
                              std::pair(Point_3(-1., 0.5, 2.), Point_3(3., 3., 3.))})
    {
      const CGAL::Aff_transformation_3<Kernel> scaling(CGAL::SCALING, scale);
      const Point_3 from = scaling(p), to = scaling(q);
      const GP::Earth_movers_cost found = metric.cost(from, to);
      EXPECT_NEAR(found.value, by_mean_value.distance(from, to), round_off * scale);
      EXPECT_GE(found.lower, euclidean_distance(from, to) * (1. - round_off));
    }
    EXPECT_EQ(calls, 6u);
    // The distance of the function for one query.
    EXPECT_EQ(GP::volumetric_distance(tetrahedron.mesh, Point_3(0., 0., 0.),
                                      Point_3(0.3 * scale, 0.3 * scale, 0.3 * scale), np)
                  .value,
              metric.distance(Point_3(0., 0., 0.), Point_3(0.3 * scale, 0.3 * scale, 0.3 * scale)));
  }
}

// Harmonic coordinates of a cube with one inner vertex: in each tetrahedron of a face and the
// center, the linear functions whose value at the center is 1/8 for each vertex. They reproduce
// linear functions and differ from mean value coordinates.
std::vector<double> harmonic_coordinates(const Mesh& cube, const Point_3& p)
{
  const Point_3 center(0.5, 0.5, 0.5);
  for(const Face f : cube.faces())
  {
    const auto h = cube.halfedge(f);
    const std::array<Vertex, 3> corner = {cube.source(h), cube.target(h),
                                          cube.target(cube.next(h))};
    const std::array<Point_3, 4> q = {cube.point(corner[0]), cube.point(corner[1]),
                                      cube.point(corner[2]), center};
    const double volume = CGAL::volume(q[0], q[1], q[2], q[3]);
    std::array<double, 4> weight;
    for(std::size_t k = 0; k < 4; ++k)
    {
      std::array<Point_3, 4> r = q;
      r[k] = p;
      weight[k] = CGAL::volume(r[0], r[1], r[2], r[3]) / volume;
    }
    if(*std::min_element(weight.begin(), weight.end()) < -1e-12)
      continue;
    std::vector<double> result(8, weight[3] / 8.);
    for(std::size_t k = 0; k < 3; ++k)
      result[corner[k]] += weight[k];
    return result;
  }
  return {};
}

TEST(Volumetric_metric, accepts_harmonic_coordinates)
{
  Mesh cube;
  CGAL::make_hexahedron(Point_3(0., 0., 0.), Point_3(1., 0., 0.), Point_3(1., 1., 0.),
                        Point_3(0., 1., 0.), Point_3(0., 1., 1.), Point_3(0., 0., 1.),
                        Point_3(1., 0., 1.), Point_3(1., 1., 1.), cube);
  CGAL::Polygon_mesh_processing::triangulate_faces(cube);
  const auto np = GP::parameters::number_of_refinements(2u);
  const Metric metric(cube, np.barycentric_coordinates([&](const Point_3&p)
                                                       { return harmonic_coordinates(cube, p); })),
      by_mean_value(cube, np);
  const Point_3 center(0.5, 0.5, 0.5), corner(0., 0., 0.), other(0.3, 0.4, 0.7);
  // The center has equal weights at all vertices.
  GP::Earth_movers_solver<Mesh> solver(cube, np);
  const std::vector<Vertex> all(cube.vertices().begin(), cube.vertices().end());
  const auto is_corner = [&](Vertex v) { return cube.point(v) == corner; };
  const GP::Earth_movers_cost expected =
      solver.compute(all, *std::find_if(all.begin(), all.end(), is_corner));
  EXPECT_NEAR(metric.cost(center, corner).upper, expected.upper, round_off);
  EXPECT_GT(std::abs(metric.distance(other, corner) - by_mean_value.distance(other, corner)), 1e-3);
  // On the surface the distance is the same, up to the gaps.
  const Point_3 on_face(0.3, 0.6, 0.);
  EXPECT_NEAR(metric.distance(on_face, corner), by_mean_value.distance(on_face, corner), round_off);
  // The properties of a metric.
  const std::vector<Point_3> points = {center, corner, other, on_face, Point_3(0.9, 0.2, 0.5)};
  for(const Point_3& p : points)
    for(const Point_3& q : points)
    {
      const GP::Earth_movers_cost cost = metric.cost(p, q);
      EXPECT_GE(cost.lower, euclidean_distance(p, q) * (1. - round_off));
      for(const Point_3& r : points)
        EXPECT_LE(cost.lower, metric.cost(p, r).upper + metric.cost(r, q).upper + round_off);
    }
  // Threads do not call the function at the same time.
  const auto costs =
      metric.costs<CGAL::Parallel_tag>(corner, points, GP::parameters::number_of_threads(3));
  for(std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(costs[i].value, metric.costs(corner, points)[i].value);
  std::vector<Point_3> path;
  EXPECT_TRUE(metric.write_path(other, Point_3(0.7, 0.6, 0.3), std::back_inserter(path)));
}

TEST(Volumetric_metric, throws_on_invalid_coordinates)
{
  const Tetrahedron tetrahedron;
  const Point_3 p(0.2, 0.4, 0.3), corner(0., 0., 0.);
  const auto expect_rejected = [&](const auto& change)
  {
    const Metric metric(tetrahedron.mesh, GP::parameters::barycentric_coordinates(
                                              [&](const Point_3& point)
                                              {
                                                std::vector<double> w =
                                                    tetrahedron.coordinates(point);
                                                change(w);
                                                return w;
                                              }));
    EXPECT_THROW(metric.distance(p, p), GP::Invalid_argument_error);
    EXPECT_THROW(metric.costs<CGAL::Parallel_tag>(corner, std::vector<Point_3>{p}),
                 GP::Invalid_argument_error);
  };
  expect_rejected([](std::vector<double>& w) { w[0] += 1e-3; });
  expect_rejected([](std::vector<double>& w) { w[0] += 1e-3, w[1] -= 1e-3; });
  expect_rejected([](std::vector<double>& w) { w[2] = std::nan(""); });
  expect_rejected([](std::vector<double>& w) { w.pop_back(); });
  expect_rejected([](std::vector<double>& w) { w.push_back(0.); });
}

TEST(Volumetric_metric, throws_on_invalid_input)
{
  EXPECT_THROW(Metric(mesh_of(square(3))), GP::Unsupported_surface_error);
  const Mesh mesh = mesh_of(icosphere(1));
  const Metric metric(mesh);
  const Point_3 inside(0., 0., 0.), outside(0., 0., 2.);
  EXPECT_THROW(metric.distance(inside, outside, GP::parameters::tolerance(0.)),
               GP::Invalid_argument_error);
  EXPECT_THROW(metric.distance(inside, Point_3(std::nan(""), 0., 0.)), GP::Invalid_argument_error);
  std::vector<Point_3> path;
  EXPECT_THROW(metric.write_path(inside, outside, std::back_inserter(path)),
               GP::Invalid_argument_error);
  EXPECT_THROW(metric.write_path(inside, mesh.point(Vertex(0)), std::back_inserter(path)),
               GP::Invalid_argument_error);
}

} // namespace Volumetric_metric_test
