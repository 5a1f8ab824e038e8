// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/feature_distance.h>

#include <CGAL/Geodesic_processing/Geodesic_path_finder.h>
#include <CGAL/Geodesic_processing/geodesic_distances.h>
#include <CGAL/Geodesic_processing/locate_on_surface.h>
#include <CGAL/Geodesic_processing/transport_to_region.h>

#include <CGAL/Point_set_3.h>

#include <boost/property_map/function_property_map.hpp>

#include "Array_surface.h"
#include "Mesh_of.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <vector>

namespace feature_distance_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Checks that the result never exceeds the exact distance. Its mean error is at most 1 % of the
// largest distance. Point features add an error of a fraction of the incident edge lengths.
template <typename Feature>
void expect_lower_bound_of_exact(Mesh& mesh, const Feature& feature,
                                 double tolerance_at_points = 0.)
{
  auto found = vertex_map(mesh), exact = mesh.add_property_map<Vertex, double>("v:exact").first;
  const GP::Earth_movers_cost cost = GP::feature_distance(mesh, feature, found);
  EXPECT_TRUE(cost.is_converged);
  GP::geodesic_distances<GP::Exact>(mesh, feature, exact);
  double largest = 0., mean_difference = 0.;
  for(const Vertex v : vertices(mesh))
  {
    EXPECT_LE(found[v], exact[v] * (1. + 1e-9)); // round-off errors
    EXPECT_GE(found[v], 0.);
    largest = std::max(largest, exact[v]);
    mean_difference += (exact[v] - found[v]) / double(num_vertices(mesh));
  }
  EXPECT_LT(mean_difference, 0.01 * largest + tolerance_at_points);
}

TEST(Feature_distance, is_accurate_for_curves_and_boundary)
{
  Mesh plane = mesh_of(square(20, 0.24));
  std::vector<GP::Source<Mesh>> boundary_sources;
  GP::border_sources(plane, std::back_inserter(boundary_sources));
  expect_lower_bound_of_exact(plane, boundary_sources);

  Mesh ring = mesh_of(torus(60, 30)); // rings of 30 vertices
  std::vector<Vertex> curve;
  for(Mesh::size_type i = 0; i < 30; ++i)
    curve.push_back(Vertex(i));
  expect_lower_bound_of_exact(ring, curve);
}

// An interval with features at 0 and 0.3. If the masses at the features were fixed, the error
// would be 0.3.
TEST(Feature_distance, is_zero_on_every_feature)
{
  Mesh mesh = mesh_of(square(20));
  std::vector<Vertex> lines;
  for(Mesh::size_type row = 0; row <= 20; ++row)
    for(const Mesh::size_type column : {0, 6})
      lines.push_back(Vertex(21 * row + column));
  auto found = vertex_map(mesh);
  GP::feature_distance(mesh, lines, found, GP::parameters::tolerance(1e-5));
  for(const Vertex v : vertices(mesh))
  {
    const double x = mesh.point(v).x();
    EXPECT_NEAR(found[v], std::min(x, std::abs(x - 0.3)),
                2e-3); // the duality gap allows this error; the mean distance is 0.19
  }
}

using Location = GP::Source<Mesh>::Location;

// Returns the zero set of a function that is linear in each face, as one source per face.
template <typename Function>
std::vector<GP::Source<Mesh>> zero_set(const Mesh& mesh, const Function& function)
{
  std::vector<GP::Source<Mesh>> result;
  for(const Face f : faces(mesh))
  {
    std::vector<Location> piece;
    auto h = mesh.halfedge(f);
    for(std::size_t k = 0; k < 3; ++k, h = mesh.next(h))
    {
      const double a = function(mesh.point(mesh.source(h))),
                   b = function(mesh.point(mesh.target(h)));
      if(a * b < 0.)
      {
        std::array<double, 3> coordinates = {0., 0., 0.};
        coordinates[k] = b / (b - a);
        coordinates[(k + 1) % 3] = a / (a - b);
        piece.emplace_back(f, coordinates);
      }
    }
    if(piece.size() == 2)
      result.emplace_back(piece);
  }
  return result;
}

// In the plane, for faces of any orientation: the distance is linear on both sides of the line.
TEST(Feature_distance, is_exact_for_straight_lines)
{
  for(const double scale : {1., 1e-6, 1e6})
    for(const double angle : {0.2, 1.1, 1.9, 2.8})
    {
      Mesh mesh = mesh_of(scaled(square(12, 0.24), scale));
      const double c = std::cos(angle), s = std::sin(angle);
      const auto height = [&](const Kernel::Point_3& p)
      { return c * (p.x() - 0.52 * scale) + s * (p.y() - 0.47 * scale); };
      auto found = vertex_map(mesh);
      const GP::Earth_movers_cost cost =
          GP::feature_distance(mesh, zero_set(mesh, height), found,
                               GP::parameters::tolerance(1e-8).number_of_refinements(0u));
      EXPECT_TRUE(cost.is_converged);
      // The gap of 1e-8 is that of the integral, in which a vertex has a weight of 1/144.
      for(const Vertex v : vertices(mesh))
        EXPECT_NEAR(found[v], std::abs(height(mesh.point(v))), 1e-6 * scale);
    }
}

TEST(Feature_distance, is_accurate_for_locations_and_paths_in_faces)
{
  Mesh plane = mesh_of(square(16, 0.24)), ball = mesh_of(jittered(icosphere(3), 0.02));
  const Location inside(Face(100), {0.2, 0.5, 0.3}), other(Face(300), {0.6, 0.1, 0.3});
  for(Mesh* mesh : {&plane, &ball})
  {
    const double tolerance_at_points = mesh == &plane ? 0.02 : 0.04; // a third of an edge length
    expect_lower_bound_of_exact(*mesh, inside, tolerance_at_points);
    expect_lower_bound_of_exact(*mesh,
                                std::vector<Location>{inside, other, {Face(100), {0.7, 0.1, 0.2}}},
                                tolerance_at_points);
    const auto path = GP::Geodesic_path_finder<Mesh>(*mesh)(inside, other);
    expect_lower_bound_of_exact(*mesh, GP::Source<Mesh>(path.locations), tolerance_at_points);
    // Locations close to vertices.
    expect_lower_bound_of_exact(*mesh,
                                std::vector<GP::Source<Mesh>>{GP::Source<Mesh>(path.locations),
                                                              GP::Source<Mesh>(Vertex(11))},
                                tolerance_at_points);
  }
}

TEST(Feature_distance, is_accurate_for_circle_of_latitude)
{
  Mesh mesh = mesh_of(icosphere(4));
  const double height = 0.3;
  const auto circle = zero_set(mesh, [&](const Kernel::Point_3& p) { return p.z() - height; });
  expect_lower_bound_of_exact(mesh, circle);
  auto found = vertex_map(mesh);
  GP::feature_distance(mesh, circle, found);
  for(const Vertex v : vertices(mesh))
  {
    const double exact = std::abs(std::asin(mesh.point(v).z()) - std::asin(height));
    EXPECT_NEAR(found[v], exact,
                0.01 * (1. + exact)); // a fifth of an edge length, reached near the poles
  }
}

// Faces that the feature crosses are split. Their pieces inherit the speed of the face.
TEST(Feature_distance, accepts_speeds)
{
  Mesh mesh = mesh_of(square(12, 0.24));
  const auto speed = mesh.add_property_map<Face, double>("speed", 2.).first;
  auto found = vertex_map(mesh);
  GP::feature_distance(
      mesh, zero_set(mesh, [](const Kernel::Point_3& p) { return p.x() + 0.3 * p.y() - 0.61; }),
      found, GP::parameters::face_speed_map(speed).tolerance(1e-8));
  // The gap of 1e-8 is that of the integral, in which a vertex has a weight of 1/144.
  for(const Vertex v : vertices(mesh))
    EXPECT_NEAR(found[v],
                0.5 * std::abs(mesh.point(v).x() + 0.3 * mesh.point(v).y() - 0.61) /
                    std::hypot(1., 0.3),
                1e-6);
}

TEST(Feature_distance, accepts_point_sets)
{
  const Surfels surfels = sphere_surfels(4);
  CGAL::Point_set_3<Kernel::Point_3> cloud(true);
  for(const auto& [point, normal] : surfels)
    cloud.insert(point, normal);
  auto found = cloud.add_property_map<double>("distance", 0.).first;
  GP::feature_distance(cloud, *cloud.begin(), found);
  double mean_difference = 0.;
  for(const auto& i : cloud)
    mean_difference += (2. * std::asin(0.5 * std::sqrt(CGAL::squared_distance(
                                                 cloud.point(*cloud.begin()), cloud.point(i)))) -
                        found[i]) /
                       double(cloud.size());
  // A fraction of the edge length 0.06 around the point.
  EXPECT_LT(std::abs(mean_difference), 0.03);
}

using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

Point_set point_set_of(const Cloud& cloud, double scale = 1.)
{
  Point_set result(true);
  for(std::size_t i = 0; i < cloud.size(); ++i)
  {
    const Vec3 p = scale * cloud.points[i], &n = cloud.normals[i];
    result.insert(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(n[0], n[1], n[2]));
  }
  return result;
}

// Distances of all surfels to a feature.
template <typename Domain, typename Feature>
std::vector<double> distances_to(const Domain& domain, const Feature& feature)
{
  std::vector<double> result(domain.number_of_vertices());
  EXPECT_TRUE(GP::feature_distance(domain, feature,
                                   boost::make_function_property_map<std::size_t>(
                                       [&](std::size_t i) -> double& { return result[i]; }))
                  .is_converged);
  return result;
}

// Returns the point of the unit sphere above a location.
template <typename Domain, typename Location>
Point on_sphere(const Domain& domain, const Location& location)
{
  const auto p = domain.point(domain.inner(location));
  return GP::internal::unit({p.x(), p.y(), p.z()});
}

TEST(Feature_distance, accepts_locations_between_surfels)
{
  for(const std::size_t n : {1000, 4000})
  {
    const Cloud cloud = ellipsoid_cloud(n, {1., 1., 1.});
    const double edge_length = std::sqrt(8. * GP::internal::pi / (std::sqrt(3.) * double(n)));
    const auto domain = GP::make_domain(point_set_of(cloud));
    for(const Kernel::Point_3& p :
        {Kernel::Point_3(0.3, 0.5, 0.8), Kernel::Point_3(-0.9, 0.3, -0.3)})
    {
      const auto location = GP::locate_on_surface(domain, p);
      ASSERT_NE(location.offset, (std::array<double, 2>{0., 0.}));
      const Point center = on_sphere(domain, location);
      const std::vector<double> found = distances_to(domain, location);
      double mean_difference = 0.;
      for(std::size_t i = 0; i < n; ++i)
      {
        const double exact = great_circle(center, cloud.points[i]);
        // Along chords, which are shorter than great circles, the slope is at most one.
        EXPECT_LE(found[i], exact);
        mean_difference += (exact - found[i]) / double(n);
      }
      // The triangle is split at the location, with angles up to 180 degrees. The slope of the
      // potential is at most one there, so that it rises less than the distance does, by at most an
      // edge length. Measured: up to 0.6 edge lengths.
      EXPECT_LT(mean_difference, 0.75 * edge_length);
    }
  }
}

TEST(Feature_distance, of_location_without_offset_is_that_of_the_surfel)
{
  const auto domain = GP::make_domain(point_set_of(ellipsoid_cloud(500, {1., 1., 1.})));
  const Point_set::Index surfel(17);
  EXPECT_EQ(distances_to(domain, GP::Location<Point_set>{surfel, {0., 0.}}),
            distances_to(domain, surfel));
}

TEST(Feature_distance, is_symmetric_and_scale_invariant_between_surfels)
{
  const Cloud cloud = ellipsoid_cloud(1000, {1., 1., 1.});
  using Domain = GP::Surfel_domain<Point_set>;
  const auto locate = [](const Domain& domain, const Point& p, double scale)
  {
    return GP::locate_on_surface(domain, Kernel::Point_3(scale * p[0], scale * p[1], scale * p[2]));
  };
  const auto cost = [&](const Point& from, const Point& to, double scale)
  {
    const Domain domain = GP::make_domain(point_set_of(cloud, scale));
    return GP::transport_to_region(domain, locate(domain, from, scale), locate(domain, to, scale))
               .value /
           scale;
  };
  const Point p = {0.3, 0.5, 0.8}, q = {-0.9, 0.3, -0.3};
  const double value = cost(p, q, 1.);
  // A location of a mass is distributed to the corners of its triangle, and the triangle of a
  // region is split. Each of them costs a fraction of the edge length 0.12.
  const double error = 0.06;
  EXPECT_NEAR(cost(q, p, 1.), value, error);
  const Domain domain = GP::make_domain(point_set_of(cloud));
  EXPECT_NEAR(value,
              great_circle(on_sphere(domain, locate(domain, p, 1.)),
                           on_sphere(domain, locate(domain, q, 1.))),
              error);
  for(const double scale : {1e-6, 1e6})
    EXPECT_NEAR(cost(p, q, scale), value, 1e-6); // the steps of the solver amplify round-off errors
}

// The distance to a parallel of a torus is the length of an arc around the tube.
TEST(Feature_distance, is_accurate_for_many_locations_on_a_torus)
{
  constexpr double tube = 0.4, angle = 0.37;
  const Cloud cloud = torus_cloud(1000, tube);
  const auto domain = GP::make_domain(point_set_of(cloud));
  std::vector<GP::Location<Point_set>> parallel;
  const double radius = 1. + tube * std::cos(angle);
  for(int i = 0; i < 300; ++i)
  {
    const double u = 2. * GP::internal::pi * i / 300.;
    parallel.push_back(
        GP::locate_on_surface(domain, Kernel::Point_3(radius * std::cos(u), radius * std::sin(u),
                                                      tube * std::sin(angle))));
  }
  const std::vector<double> found = distances_to(domain, parallel);
  double mean_difference = 0.;
  for(std::size_t i = 0; i < cloud.size(); ++i)
  {
    const Vec3& p = cloud.points[i];
    const double difference = std::abs(std::atan2(p[2], std::hypot(p[0], p[1]) - 1.) - angle);
    const double exact = tube * std::min(difference, 2. * GP::internal::pi - difference);
    // Locations are on triangles, below the tube by up to 0.006.
    EXPECT_LE(found[i], exact + 0.006);
    mean_difference += (exact - found[i]) / double(cloud.size());
  }
  EXPECT_LT(mean_difference, 0.09); // 0.75 edge lengths, as above
}

// A polyline in one triangle, and a polyline without common triangles.
TEST(Feature_distance, accepts_polylines_within_triangles_of_clouds)
{
  const Cloud cloud = square_cloud(11);
  const auto domain = GP::make_domain(point_set_of(cloud));
  // Both ends of an edge between adjacent surfels of the grid.
  const std::size_t corner = 11 * 5 + 5;
  const auto at = [&](double x, double y)
  { return GP::locate_on_surface(domain, Kernel::Point_3(x, y, 0.)); };
  using Source = GP::Source<Point_set>;
  const std::vector<GP::Location<Point_set>> edge = {at(0.5, 0.5), at(0.6, 0.5)};
  ASSERT_EQ(std::size_t(edge[0].surfel), corner);
  const std::vector<double> found = distances_to(domain, Source(edge));
  EXPECT_EQ(found[corner], 0.);
  EXPECT_EQ(found[corner + 11], 0.);
  const std::vector<GP::Location<Point_set>> too_far = {at(0.5, 0.5), at(0.9, 0.5)};
  EXPECT_THROW(distances_to(domain, Source(too_far)), GP::Invalid_argument_error);
}

TEST(Feature_distance, is_infinite_if_unreachable)
{
  Mesh mesh = mesh_of(disjoint_union(square(4), square(4)));
  const Vertex isolated = mesh.add_vertex(Kernel::Point_3(0., 0., 9.));
  auto found = vertex_map(mesh);
  // A fraction of the edge length 0.25.
  const double error = 0.05;
  EXPECT_TRUE(GP::feature_distance(mesh, Vertex(0), found).is_converged);
  EXPECT_NEAR(found[Vertex(4)], 1., error);
  EXPECT_EQ(found[Vertex(30)], infinity);
  EXPECT_EQ(found[isolated], infinity);
  GP::feature_distance(mesh, std::vector<Vertex>{Vertex(0), Vertex(25), isolated}, found);
  EXPECT_NEAR(found[Vertex(29)], 1., error);
  EXPECT_EQ(found[isolated], 0.);
  // Vertices behind a wall of speed zero.
  Mesh plane = mesh_of(square(4));
  const auto speed = plane.add_property_map<Vertex, double>("speed", 1.).first;
  for(Mesh::size_type row = 0; row < 5; ++row)
    for(const Mesh::size_type column : {1, 2})
      speed[Vertex(5 * row + column)] = 0.;
  auto behind_obstacle = vertex_map(plane);
  GP::feature_distance(plane, Vertex(0), behind_obstacle, GP::parameters::speed_map(speed));
  EXPECT_EQ(behind_obstacle[Vertex(4)], infinity);
}

// The lines x = 0.11 and x = 0.57 receive half of the mass of the square each. Mass moves to the
// left at x if more of it is on the left of x than arrives there, and the potential has slope one.
// It is therefore not zero on the second line, unlike the distance.
TEST(Feature_distance, with_fixed_masses_is_the_dual_in_an_interval)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Mesh mesh = mesh_of(scaled(square(16, 0.24), scale));
    std::vector<GP::Source<Mesh>> lines;
    for(const double x : {0.11, 0.57})
      for(const auto& piece :
          zero_set(mesh, [&](const Kernel::Point_3& p) { return p.x() - x * scale; }))
        lines.push_back(piece);
    auto found = vertex_map(mesh);
    const GP::Earth_movers_cost cost = GP::feature_distance(
        mesh, lines, found, GP::parameters::do_fix_masses(true).tolerance(1e-5));
    EXPECT_TRUE(cost.is_converged);
    // The integral of the flow, whose size is the difference of the masses on the left.
    const double flow = 0.5 * (0.11 * 0.11 + 0.39 * 0.39 + 0.07 * 0.07 + 0.43 * 0.43);
    EXPECT_NEAR(cost.value, flow * scale * scale * scale, 0.01 * scale * scale * scale);
    for(const Vertex v : vertices(mesh))
    {
      const double x = mesh.point(v).x() / scale;
      const double dual = x < 0.5 ? std::abs(x - 0.11) : x < 0.57 ? 0.89 - x : x - 0.25;
      // The maximum of the potential is that of the vertices, which are up to an edge length of
      // 1/16 from the lines.
      EXPECT_NEAR(found[v], dual * scale, scale / 16.);
    }
  }
}

// The result certifies its own optimality: its slope is at most one, and its integral against both
// uniform distributions is the lower bound of the cost.
TEST(Feature_distance, with_fixed_masses_is_an_optimal_dual_potential)
{
  Mesh mesh = mesh_of(jittered(icosphere(3), 0.02));
  const std::vector<Vertex> feature = {Vertex(0), Vertex(17), Vertex(300)};
  const auto found = vertex_map(mesh);
  const GP::Earth_movers_cost cost = GP::feature_distance(
      mesh, feature, found, GP::parameters::do_fix_masses(true).number_of_refinements(0u));
  EXPECT_TRUE(cost.is_converged);
  EXPECT_GE(cost.lower, (1. - 1e-3) * cost.upper); // the default tolerance
  double area = 0., dual_value = 0.;
  for(const Face f : faces(mesh))
  {
    const auto h = mesh.halfedge(f);
    const std::array<Vertex, 3> v = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
    const Kernel::Vector_3 a = mesh.point(v[1]) - mesh.point(v[0]),
                           b = mesh.point(v[2]) - mesh.point(v[0]), n = CGAL::cross_product(a, b);
    const double x = found[v[1]] - found[v[0]], y = found[v[2]] - found[v[0]],
                 size = std::sqrt(n.squared_length());
    EXPECT_LE(std::sqrt((x * b - y * a).squared_length()) / size, 1. + 1e-9); // round-off errors
    area += 0.5 * size;
    dual_value += 0.5 * size * (found[v[0]] + found[v[1]] + found[v[2]]) / 3.;
  }
  for(const Vertex v : feature)
    dual_value -= area / 3. * found[v];
  EXPECT_NEAR(dual_value, cost.lower, 1e-9); // round-off errors
  double smallest = GP::internal::infinity;
  for(const Vertex v : vertices(mesh))
    smallest = std::min(smallest, found[v]);
  EXPECT_EQ(smallest, 0.);
}

TEST(Feature_distance, with_fixed_masses_is_the_distance_to_a_point)
{
  Mesh mesh = mesh_of(disjoint_union(icosphere(3), square(3, 0.2)));
  const auto fixed = vertex_map(mesh);
  const auto found = mesh.add_property_map<Vertex, double>("v:found").first;
  GP::feature_distance(mesh, Vertex(7), fixed, GP::parameters::do_fix_masses(true));
  GP::feature_distance(mesh, Vertex(7), found);
  for(const Vertex v : vertices(mesh))
    if(std::isinf(found[v]))
    {
      EXPECT_EQ(fixed[v], found[v]);
    }
    else
    {
      EXPECT_NEAR(fixed[v], found[v], 0.02); // twice the gaps of 0.1 % of distances up to pi
    }
}

TEST(Feature_distance, accepts_fixed_masses_on_point_sets)
{
  const auto domain = GP::make_domain(point_set_of(ellipsoid_cloud(1000, {1., 1., 1.})));
  const std::vector<Point_set::Index> feature = {Point_set::Index(0), Point_set::Index(999)};
  std::vector<double> fixed(1000), found = distances_to(domain, feature);
  GP::feature_distance(domain, feature,
                       boost::make_function_property_map<std::size_t>([&](std::size_t i) -> double&
                                                                      { return fixed[i]; }),
                       GP::parameters::do_fix_masses(true));
  // Both poles of the sphere are the nearest ones of half of the mass, by symmetry.
  for(std::size_t i = 0; i < fixed.size(); ++i)
    EXPECT_NEAR(fixed[i], found[i], 0.12); // the edge length
}

TEST(Feature_distance, with_fixed_masses_can_be_cancelled)
{
  Mesh mesh = mesh_of(icosphere(2));
  auto found = mesh.add_property_map<Vertex, double>("v:kept", 7.).first;
  EXPECT_THROW(GP::feature_distance(mesh, Vertex(0), found,
                                    GP::parameters::do_fix_masses(true).callback(
                                        std::function<bool(double)>([](double) { return false; }))),
               GP::Cancelled);
  EXPECT_EQ(found[Vertex(3)], 7.);
  EXPECT_THROW(
      GP::feature_distance(mesh, std::vector<Vertex>(), found, GP::parameters::do_fix_masses(true)),
      GP::Invalid_argument_error);
}

} // namespace feature_distance_test
