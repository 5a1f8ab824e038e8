// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/karcher_mean.h>

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/geodesic_barycenter.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/locate_on_surface.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"
#include "torus_geodesic.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace karcher_mean_public_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using GP::internal::dot;
using GP::internal::norm;
using GP::internal::unit;
using GP::internal::operator*;
using GP::internal::operator+;
using GP::internal::operator-;
using GP::internal::Vec3;
using Mesh_location = GP::Location<Mesh>;
using Point_3 = Kernel::Point_3;

// The relative tolerance of the gradient is 1e-8. At these means the Hessian is at least 0.1, and
// distances are at most 10.
constexpr double mean_error = 1e-6;
// Round-off errors of sums of squared distances.
constexpr double round_off = 1e-9;

Vec3 to_vec(const Point_3& p) { return {p.x(), p.y(), p.z()}; }
Point_3 to_point(const Vec3& p) { return {p[0], p[1], p[2]}; }

template <typename Surface>
std::vector<GP::Location<Surface>> located(const Surface& surface, const std::vector<Vec3>& points)
{
  const GP::Surface_locator<Surface> locate(surface);
  std::vector<GP::Location<Surface>> result;
  for(const Vec3& p : points)
    result.push_back(locate(to_point(p)));
  return result;
}

// Returns the point of the unit sphere at an angle and a distance from a center.
Vec3 on_sphere(const Vec3& center, double angle, double distance)
{
  const auto [x, y] = GP::internal::tangent_frame(center);
  return std::cos(distance) * center +
         std::sin(distance) * (std::cos(angle) * x + std::sin(angle) * y);
}

TEST(Karcher_mean, is_the_centroid_in_the_plane)
{
  const Mesh mesh = mesh_of(square(12, 0.24));
  std::mt19937 random(1);
  std::vector<Mesh_location> locations;
  std::vector<double> weights;
  Vec3 sum = {0., 0., 0.};
  const auto domain = GP::make_domain(mesh);
  for(int i = 0; i < 30; ++i)
  {
    locations.push_back(random_location_of(mesh, random));
    weights.push_back(i % 4); // also zero
    sum = sum + weights.back() * to_vec(domain.point(locations.back()));
  }
  const Vec3 centroid = 1. / 43. * sum; // the sum of the weights
  const auto mean = GP::karcher_mean(domain, locations, GP::parameters::weights(weights));
  EXPECT_TRUE(mean.is_converged);
  EXPECT_LT(norm(to_vec(mean.point) - centroid), mean_error);
  double value = 0.;
  for(int i = 0; i < 30; ++i)
  {
    const Vec3 difference = to_vec(domain.point(locations[i])) - centroid;
    value += weights[i] * dot(difference, difference);
  }
  EXPECT_NEAR(mean.value, value, round_off);
  EXPECT_LT(norm(to_vec(mean.point) - to_vec(domain.point(mean.location))), round_off);
  // The barycenter is the best vertex, so its value is not smaller.
  EXPECT_LE(mean.value,
            GP::geodesic_barycenter<GP::Exact>(domain, locations, GP::parameters::weights(weights))
                .value);
}

// Unrolled to the plane, means are centroids as long as the locations are on one side.
TEST(Karcher_mean, is_the_centroid_of_the_unrolled_cylinder)
{
  const std::size_t n = 24, number_of_rings = 6;
  // A prism.
  const Mesh mesh = mesh_of(rings(
      n, number_of_rings, [](double) { return 1.; }, [](double height) { return 2. * height; },
      0.));
  const double side = 2. * std::sin(pi / double(n)); // of the polygon
  // Vertices are n ring + i.
  const std::vector<std::pair<std::size_t, std::size_t>> chosen = {{1, 2}, {6, 5}, {8, 1}, {3, 4}};
  std::vector<Vertex> locations;
  const std::vector<double> weights = {1., 2., 3., 4.};
  double mean_s = 0., mean_z = 0., value = 0.;
  for(std::size_t k = 0; k < chosen.size(); ++k)
  {
    locations.push_back(Vertex(Mesh::size_type(n * chosen[k].second + chosen[k].first)));
    mean_s += weights[k] / 10. * double(chosen[k].first);
    mean_z += weights[k] / 10. * mesh.point(locations.back()).z();
  }
  for(std::size_t k = 0; k < chosen.size(); ++k)
  {
    const double s = side * (double(chosen[k].first) - mean_s),
                 z = mesh.point(locations[k]).z() - mean_z;
    value += weights[k] * (s * s + z * z);
  }
  const auto mean = GP::karcher_mean(mesh, locations, GP::parameters::weights(weights));
  EXPECT_TRUE(mean.is_converged);
  const double floor = std::floor(mean_s);
  const Vec3 a = to_vec(mesh.point(Vertex(Mesh::size_type(floor)))),
             b = to_vec(mesh.point(Vertex(Mesh::size_type(floor + 1.))));
  Vec3 expected = a + (mean_s - floor) * (b - a);
  expected[2] = mean_z;
  EXPECT_LT(norm(to_vec(mean.point) - expected), mean_error);
  EXPECT_NEAR(mean.value, value, round_off);
}

TEST(Karcher_mean, is_the_centroid_of_the_unrolled_cone)
{
  const std::size_t n = 12;
  const double total = 4.;
  const Mesh mesh = mesh_of(cone(n, 4, total));
  // Point 1 + n j + i has the direction i total / n and the distance j + 1 from the center.
  const std::vector<std::pair<std::size_t, std::size_t>> chosen = {{0, 3}, {2, 0}, {5, 2}};
  std::vector<Vertex> locations;
  std::vector<GP::internal::Vec2> planar;
  GP::internal::Vec2 sum = {0., 0.};
  for(const auto& [i, j] : chosen)
  {
    locations.push_back(Vertex(Mesh::size_type(1 + n * j + i)));
    const double angle = total * double(i) / double(n), r = double(j) + 1.;
    planar.push_back({r * std::cos(angle), r * std::sin(angle)});
    for(int k = 0; k < 2; ++k)
      sum[k] += planar.back()[k] / 3.;
  }
  const auto mean = GP::karcher_mean(mesh, locations);
  EXPECT_TRUE(mean.is_converged);
  GP::Geodesic_distance_solver<Mesh> solver(mesh);
  solver.compute(mean.location);
  double value = 0.;
  for(std::size_t k = 0; k < chosen.size(); ++k)
  {
    const double distance = std::hypot(planar[k][0] - sum[0], planar[k][1] - sum[1]);
    EXPECT_NEAR(solver.distance(locations[k]), distance, mean_error);
    value += distance * distance;
  }
  EXPECT_NEAR(mean.value, value, round_off);
}

// The sum of the directions' cosines over all directions is positive at a convex vertex, so the
// mean of points around it is not the vertex.
TEST(Karcher_mean, is_not_at_the_corner_of_a_cube)
{
  const Mesh mesh = mesh_of(blocks(3, 3, 3, [](int, int, int) { return true; }));
  const auto locations = located(mesh, {{3., 2., 2.}, {2., 3., 2.}, {2., 2., 3.}});
  const auto mean = GP::karcher_mean(mesh, locations);
  EXPECT_TRUE(mean.is_converged);
  EXPECT_GT(norm(to_vec(mean.point) - Vec3{3., 3., 3.}), 0.1);
  // No point of a grid on the three faces has a smaller sum.
  GP::Geodesic_distance_solver<Mesh> solver(mesh);
  for(int i = 0; i <= 12; ++i)
    for(int j = 0; j <= 12; ++j)
    {
      const double u = 1.5 + i / 8., v = 1.5 + j / 8.;
      for(const Vec3& p : {Vec3{3., u, v}, Vec3{u, 3., v}, Vec3{u, v, 3.}})
      {
        solver.compute(GP::locate_on_surface(mesh, to_point(p)));
        double sum = 0.;
        for(const Mesh_location& location : locations)
          sum += solver.distance(location) * solver.distance(location);
        EXPECT_GE(sum, mean.value - round_off);
      }
    }
}

// The mean of two locations divides the shortest path in the ratio of the weights.
TEST(Karcher_mean, divides_great_circles_by_weights)
{
  const Mesh mesh = mesh_of(icosphere(5));
  const Vec3 p = unit(Vec3{0.3, 0.4, 0.8}), q = on_sphere(p, 1., 1.2);
  const auto locations = located(mesh, {p, q});
  for(const double weight : {0.2, 0.5, 0.9})
  {
    const std::array<double, 2> weights = {1. - weight, weight};
    const auto mean = GP::karcher_mean(mesh, locations, GP::parameters::weights(weights));
    EXPECT_TRUE(mean.is_converged);
    GP::Geodesic_distance_solver<Mesh> solver(mesh);
    solver.compute(mean.location);
    const double from_p = solver.distance(locations[0]), from_q = solver.distance(locations[1]);
    EXPECT_NEAR((1. - weight) * from_p, weight * from_q, mean_error);
    EXPECT_NEAR(mean.value, weight * (1. - weight) * (from_p + from_q) * (from_p + from_q),
                mean_error);
    // The error of the polyhedron: up to 1e-4 was measured.
    EXPECT_LT(norm(unit(to_vec(mean.point)) - on_sphere(p, 1., 1.2 * weight)), 5e-4);
  }
}

TEST(Karcher_mean, is_the_center_of_symmetric_points_on_a_sphere)
{
  const Vec3 pole = unit(Vec3{0.2, -0.5, 0.9});
  double previous_error = 1.;
  for(const unsigned level : {3u, 5u})
  {
    const Mesh mesh = mesh_of(icosphere(level));
    std::vector<Vec3> points;
    for(int i = 0; i < 14; ++i)
      points.push_back(on_sphere(pole, 2. * pi * i / 7., i < 7 ? 0.4 : 1.));
    const auto mean = GP::karcher_mean(mesh, located(mesh, points));
    EXPECT_TRUE(mean.is_converged);
    const double error = norm(unit(to_vec(mean.point)) - pole);
    // The edges become four times shorter. The error of a level depends on the orientation of its
    // triangles.
    EXPECT_LT(error, previous_error / 4.);
    previous_error = error;
  }
  EXPECT_LT(previous_error, 0.001); // 2e-4 was measured
}

TEST(Karcher_mean, does_not_depend_on_the_initial_location)
{
  const Mesh mesh = mesh_of(icosphere(4));
  std::mt19937 random(5);
  const Vec3 center = unit(Vec3{0.3, 0.4, 0.8});
  std::vector<Vec3> points;
  std::uniform_real_distribution<double> number(0., 1.);
  for(int i = 0; i < 40; ++i)
    points.push_back(on_sphere(center, 2. * pi * number(random), 0.7 * number(random)));
  const auto locations = located(mesh, points);
  const auto mean = GP::karcher_mean(mesh, locations);
  for(int i = 0; i < 5; ++i)
  {
    const auto other = GP::karcher_mean(
        mesh, locations,
        GP::parameters::initial_location(located(mesh, {on_sphere(center, 1.3 * i, 0.6)})[0]));
    EXPECT_TRUE(other.is_converged);
    EXPECT_LT(norm(to_vec(other.point) - to_vec(mean.point)), mean_error);
  }
}

// Two arms of an L meet at a reflex vertex, through which all paths between them pass.
TEST(Karcher_mean, can_be_at_a_reflex_vertex)
{
  Triangulation full = square(8), surface;
  surface.points = full.points;
  for(std::size_t c = 0; c < full.corners.size(); c += 3)
  {
    Vec3 center = {0., 0., 0.};
    for(int k = 0; k < 3; ++k)
      center = center + 1. / 3. * full.points[full.corners[c + k]];
    if(center[0] < 0.25 || center[1] < 0.25)
      surface.corners.insert(surface.corners.end(),
                             {full.corners[c], full.corners[c + 1], full.corners[c + 2]});
  }
  // The other vertices of the square remain as isolated vertices.
  const Mesh mesh = mesh_of(surface);
  const auto at = [](std::size_t i, std::size_t j) { return Vertex(Mesh::size_type(i + 9 * j)); };
  const std::vector<Vertex> ends = {at(8, 2), at(2, 8)};
  const auto mean = GP::karcher_mean(mesh, ends);
  EXPECT_TRUE(mean.is_converged);
  EXPECT_LT(norm(to_vec(mean.point) - Vec3{0.25, 0.25, 0.}), round_off);
  EXPECT_NEAR(mean.value, 2. * 0.75 * 0.75, round_off);
  EXPECT_EQ(mean.gradient_norm, 0.);
  const auto started = GP::karcher_mean(mesh, ends, GP::parameters::initial_location(at(1, 1)));
  EXPECT_TRUE(started.is_converged);
  EXPECT_LT(norm(to_vec(started.point) - Vec3{0.25, 0.25, 0.}), mean_error);
}

template <typename AnyMesh>
std::pair<Vec3, double> mean_on(double scale)
{
  Numbered<AnyMesh> sphere;
  fill(sphere, scaled(jittered(icosphere(3), 0.01), scale));
  const auto& v = sphere.vertices;
  const std::vector<typename boost::graph_traits<AnyMesh>::vertex_descriptor> locations = {
      v[12], v[50], v[101], v[200]};
  const auto mean = GP::karcher_mean(sphere.mesh, locations);
  EXPECT_TRUE(mean.is_converged);
  return {1. / scale * Vec3(to_array(mean.point)), mean.value / scale / scale};
}

TEST(Karcher_mean, accepts_all_mesh_types_and_scales)
{
  const auto expected = mean_on<Mesh>(1.);
  const auto check = [&](const std::pair<Vec3, double>& found)
  {
    EXPECT_LT(norm(found.first - expected.first), mean_error);
    EXPECT_NEAR(found.second, expected.second, round_off);
  };
  check(mean_on<CGAL::Polyhedron_3<Kernel>>(1.));
  check(mean_on<Mesh>(1e-6));
  check(mean_on<Mesh>(1e6));
}

TEST(Karcher_mean, accepts_degenerate_input)
{
  // A single location, also repeated, is the mean.
  const Mesh mesh = mesh_of(icosphere(2));
  const Mesh_location location = location_of(7, {0.2, 0.3, 0.5});
  const auto domain = GP::make_domain(mesh);
  for(const std::size_t number : {1u, 3u})
  {
    const auto mean = GP::karcher_mean(domain, std::vector<Mesh_location>(number, location));
    EXPECT_TRUE(mean.is_converged);
    EXPECT_LT(norm(to_vec(mean.point) - to_vec(domain.point(location))), round_off);
    EXPECT_NEAR(mean.value, 0., round_off);
  }
  EXPECT_EQ(GP::karcher_mean(mesh, Vertex(3)).value, 0.);
  // Two components, of which one has only weight zero.
  const Mesh two = mesh_of(disjoint_union(square(4), scaled(icosphere(1), 3.)));
  const std::vector<Vertex> vertices = {Vertex(0), Vertex(24), Vertex(30)};
  const auto mean =
      GP::karcher_mean(two, vertices, GP::parameters::weights(std::array<int, 3>{1, 1, 0}));
  EXPECT_LT(norm(to_vec(mean.point) - Vec3{0.5, 0.5, 0.}), mean_error);
  // Weights whose sum overflows.
  const auto huge = GP::karcher_mean(
      two, vertices, GP::parameters::weights(std::array<double, 3>{1.5e308, 1.5e308, 0.}));
  EXPECT_LT(norm(to_vec(huge.point) - Vec3{0.5, 0.5, 0.}), mean_error);
  // An isolated vertex.
  Mesh isolated;
  const Vertex only = isolated.add_vertex(Point_3(1., 2., 3.));
  const auto there = GP::karcher_mean(isolated, only);
  EXPECT_TRUE(there.is_converged);
  EXPECT_EQ(there.location.first, Mesh::null_face());
  EXPECT_EQ(there.point, Point_3(1., 2., 3.));
}

TEST(Karcher_mean, accepts_faces_without_area)
{
  Triangulation surface = square(2);
  // Splits an edge of one of its two triangles only: a degenerate triangle fills the gap.
  surface.points.push_back({0.25, 0.25, 0.});
  const Index middle = Index(surface.points.size() - 1);
  Triangulation split{surface.points, {}};
  for(std::size_t c = 0; c < surface.corners.size(); c += 3)
  {
    const Index a = surface.corners[c], b = surface.corners[c + 1], d = surface.corners[c + 2];
    const auto on_diagonal = [&](Index i, Index j)
    {
      const Vec3 m = 0.5 * (surface.points[i] + surface.points[j]);
      return norm(m - surface.points[middle]) < 1e-12;
    };
    if(c < 3 && on_diagonal(a, d))
      split.corners.insert(split.corners.end(), {a, b, middle, middle, b, d, a, middle, d});
    else
      split.corners.insert(split.corners.end(), {a, b, d});
  }
  const Mesh mesh = mesh_of(split);
  ASSERT_EQ(num_faces(mesh), 10u);
  const std::vector<Vertex> corners = {Vertex(0), Vertex(2), Vertex(6), Vertex(8)};
  const auto mean = GP::karcher_mean(
      mesh, corners, GP::parameters::weights(std::array<double, 4>{3., 1., 1., 1.}));
  EXPECT_TRUE(mean.is_converged);
  EXPECT_LT(norm(to_vec(mean.point) - 1. / 6. * Vec3{2., 2., 0.}), mean_error);
}

TEST(Karcher_mean, throws_on_invalid_arguments)
{
  const Mesh one = mesh_of(icosphere(1)),
             two = mesh_of(disjoint_union(icosphere(1), scaled(icosphere(1), 3.)));
  using Error = GP::Invalid_argument_error;
  EXPECT_THROW(GP::karcher_mean(one, std::vector<Vertex>{}), Error);
  const std::vector<Vertex> points = {Vertex(0), Vertex(42)};
  EXPECT_THROW(GP::karcher_mean(one, points), Error);
  EXPECT_THROW(GP::karcher_mean(two, points), Error);
  for(const std::vector<double>& weights :
      std::vector<std::vector<double>>{{1.}, {1., -1.}, {0., 0.}, {1., std::nan("")}})
    EXPECT_THROW(GP::karcher_mean(two, points, GP::parameters::weights(weights)), Error);
  EXPECT_THROW(GP::karcher_mean(one, Vertex(0), GP::parameters::tolerance(-1.)), Error);
  EXPECT_THROW(GP::karcher_mean(one, Vertex(0), GP::parameters::tolerance(std::nan(""))), Error);
  EXPECT_THROW(GP::karcher_mean(two, Vertex(0), GP::parameters::initial_location(Vertex(50))),
               Error);
  EXPECT_THROW(GP::karcher_mean(one, Vertex(0), GP::parameters::initial_location(Vertex(50))),
               Error);
}

TEST(Karcher_mean, stops_after_the_maximum_number_of_iterations)
{
  const Mesh mesh = mesh_of(icosphere(4));
  const std::vector<Vertex> locations = {Vertex(0), Vertex(100), Vertex(200)};
  const auto np = GP::parameters::initial_location(Vertex(0));
  double previous = 1e9;
  for(const std::size_t number : {0u, 1u, 2u})
  {
    const auto mean = GP::karcher_mean(mesh, locations, np.maximum_number_of_iterations(number));
    EXPECT_EQ(mean.number_of_iterations, number);
    EXPECT_LT(mean.value, previous);
    previous = mean.value;
  }
}

using Cloud = CGAL::Point_set_3<Point_3>;

Cloud cloud_of(const Surfels& surfels, double scale = 1.)
{
  Cloud cloud(true);
  for(const auto& [point, normal] : surfels)
    cloud.insert(Point_3(scale * point.x(), scale * point.y(), scale * point.z()), normal);
  return cloud;
}

TEST(Karcher_mean, is_the_centroid_of_a_flat_cloud)
{
  const Cloud cloud = cloud_of(flat_surfels(2000));
  Vec3 centroid = {0., 0., 0.};
  std::vector<Cloud::Index> locations;
  for(std::size_t i = 0; i < 20; ++i)
  {
    locations.push_back(Cloud::Index(i * 90));
    centroid = centroid + 1. / 20. * to_vec(cloud.point(locations.back()));
  }
  const auto mean = GP::karcher_mean(cloud, locations);
  EXPECT_TRUE(mean.is_converged);
  EXPECT_LT(norm(to_vec(mean.point) - centroid), 1e-4); // the tolerance is 1e-5
}

TEST(Karcher_mean, matches_sphere_on_clouds)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Cloud cloud = cloud_of(sphere_surfels(4), scale);
    const Vec3 p = unit(Vec3{0.3, 0.4, 0.8}), q = on_sphere(p, 1., 1.2);
    const auto locations = located(cloud, {scale * p, scale * q});
    const std::array<double, 2> weights = {0.75, 0.25};
    const auto mean = GP::karcher_mean(cloud, locations, GP::parameters::weights(weights));
    EXPECT_TRUE(mean.is_converged);
    // The locations are projected to the fitted surface, which is the sphere up to round-off
    // errors. The tolerance is 1e-5; an error of 3e-6 of the locations was measured.
    EXPECT_LT(norm(1. / scale * to_vec(mean.point) - on_sphere(p, 1., 0.3)), 5e-5);
    EXPECT_NEAR(mean.value / scale / scale, 0.75 * 0.25 * 1.44, 1e-5);
  }
}

// Locations at geodesics whose vectors sum to zero, so their start is the mean.
TEST(Karcher_mean, matches_torus_on_clouds)
{
  const Torus torus;
  Cloud cloud(true);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(0., 1.);
  while(cloud.size() < 10000)
  {
    const double u = 2. * pi * number(random), v = 2. * pi * number(random);
    if(1.4 * number(random) > 1. + 0.4 * std::cos(v)) // the density of the area
      continue;
    const Vec3 n = Torus::normal(u, v);
    cloud.insert(to_point(torus.point(u, v)), Kernel::Vector_3(n[0], n[1], n[2]));
  }
  const double u = 0.4, v = 0.9;
  std::vector<Vec3> points;
  for(int i = 0; i < 5; ++i)
    points.push_back(torus.geodesic(u, v, 0.3 + 2. * pi * i / 5., 0.4));
  const auto locations = located(cloud, points);
  const auto mean = GP::karcher_mean(cloud, locations);
  EXPECT_TRUE(mean.is_converged);
  // The mean spacing is 0.04. An error of the fit of 5e-5 was measured.
  constexpr double fit_error = 2e-4;
  EXPECT_LT(norm(to_vec(mean.point) - torus.point(u, v)), fit_error);
  EXPECT_NEAR(mean.value, 5. * 0.16, 5. * 2. * 0.4 * fit_error);
  const auto parallel = GP::karcher_mean(cloud, locations, GP::parameters::number_of_threads(3u));
  EXPECT_EQ(to_vec(parallel.point), to_vec(mean.point));
  EXPECT_EQ(parallel.value, mean.value);
}

TEST(Karcher_mean, throws_on_clouds)
{
  Surfels surfels = flat_surfels(500);
  for(const auto& [point, normal] : flat_surfels(500, 2))
    surfels.emplace_back(Point_3(point.x() + 5., point.y(), 0.), normal);
  const Cloud cloud = cloud_of(surfels);
  using Error = GP::Invalid_argument_error;
  using Index = Cloud::Index;
  EXPECT_THROW(GP::karcher_mean(cloud, std::vector<Index>{}), Error);
  EXPECT_THROW(GP::karcher_mean(cloud, std::vector<Index>{Index(0), Index(700)}), Error);
  EXPECT_THROW(GP::karcher_mean(cloud, Index(0), GP::parameters::initial_location(Index(700))),
               Error);
  EXPECT_THROW(
      GP::karcher_mean(cloud, Index(0), GP::parameters::callback([](double) { return false; })),
      GP::Cancelled);
  const auto mean = GP::karcher_mean(cloud, Index(0));
  EXPECT_TRUE(mean.is_converged);
  EXPECT_LT(norm(to_vec(mean.point) - to_vec(cloud.point(Index(0)))), 1e-5);
}

} // namespace karcher_mean_public_test
