// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/straightest_geodesic.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "clouds.h"
#include "meshes.h"
#include "torus_geodesic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace straightest_geodesic_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr double round_off = 1e-12; // sums of some tens of lengths
using Vector_3 = Kernel::Vector_3;

TEST(Straightest_geodesic, is_straight_in_plane)
{
  const Triangulation plane = square(10, 0.24);
  Numbered<Surface_mesh> mesh;
  fill(mesh, plane);
  const auto domain = make_domain(mesh.mesh);
  const Point center = plane.points[60];
  for(int i = 0; i < 36; ++i)
  {
    const double angle = i * pi / 18.;
    const auto path = straightest_geodesic(
        domain, mesh.vertices[60], Vector_3(3. * std::cos(angle), 3. * std::sin(angle), 7.), 0.4);
    EXPECT_FALSE(path.is_cut_by_boundary);
    EXPECT_NEAR(path.length, 0.4, round_off);
    const Point end = {center[0] + 0.4 * std::cos(angle), center[1] + 0.4 * std::sin(angle), 0.};
    EXPECT_LT(distance(to_array(path.points.back()), end), round_off);
  }
}

TEST(Straightest_geodesic, ends_at_boundary)
{
  const Triangulation plane = square(10, 0.24);
  Numbered<Surface_mesh> mesh;
  fill(mesh, plane);
  const auto from = location_in(mesh, plane, 87, {0.2, 0.3, 0.5});
  const Point start = point_of(mesh.mesh, from);
  const auto path = straightest_geodesic(mesh.mesh, from, Vector_3(1., 0., 0.), 5.);
  EXPECT_TRUE(path.is_cut_by_boundary);
  EXPECT_NEAR(path.length, 1. - start[0], round_off);
  EXPECT_LT(distance(to_array(path.points.back()), {1., start[1], 0.}), round_off);
}

TEST(Straightest_geodesic, closes_around_tetrahedron)
{
  // A geodesic parallel to an edge passes the midpoints of the four adjacent edges. It closes
  // after two edge lengths.
  Numbered<Surface_mesh> mesh;
  fill(mesh, tetrahedron());
  const Triangulation shape = tetrahedron();
  const auto from = location_in(mesh, shape, 0, {0.5, 0.5, 0.});
  const Point a = shape.points[0], b = shape.points[1], c = shape.points[2];
  const double edge_length = distance(a, b);
  // To the midpoint of the next edge of face 0.
  const Vector_3 direction(c[0] - a[0], c[1] - a[1], c[2] - a[2]);
  const auto path = straightest_geodesic(mesh.mesh, from, direction, 2. * edge_length);
  EXPECT_NEAR(path.length, 2. * edge_length, round_off);
  EXPECT_LT(distance(to_array(path.points.back()), point_of(mesh.mesh, from)), round_off);
}

TEST(Straightest_geodesic, is_single_point_for_zero_length)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, tetrahedron());
  const auto path = straightest_geodesic(mesh.mesh, mesh.vertices[1], Vector_3(1., 0.3, 0.2), 0.);
  EXPECT_EQ(path.length, 0.);
  ASSERT_FALSE(path.empty());
  EXPECT_LT(distance(to_array(path.points.front()), tetrahedron().points[1]), round_off);
}

TEST(Straightest_geodesic, throws_on_invalid_direction_or_length)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, square(2));
  const auto trace = [&](const Vector_3& direction, double length)
  { return straightest_geodesic(mesh.mesh, mesh.vertices[4], direction, length); };
  EXPECT_THROW(trace(Vector_3(0., 0., 0.), 1.), Invalid_argument_error);
  EXPECT_THROW(trace(Vector_3(0., 0., 1.), 1.), Invalid_argument_error); // along the normal
  EXPECT_THROW(trace(Vector_3(1., 0., 0.), -1.), Invalid_argument_error);
  EXPECT_THROW(trace(Vector_3(1., 0., 0.), std::nan("")), Invalid_argument_error);
  EXPECT_NO_THROW(trace(Vector_3(1., 0., 0.), 0.1));
}

using Point_3 = Kernel::Point_3;
using Point_set = CGAL::Point_set_3<Point_3>;

Point_set point_set_of(const Cloud& cloud, double factor = 1.)
{
  Point_set result(true);
  for(std::size_t i = 0; i < cloud.size(); ++i)
  {
    const auto &p = cloud.points[i], &n = cloud.normals[i];
    result.insert(Point_3(factor * p[0], factor * p[1], factor * p[2]), Vector_3(n[0], n[1], n[2]));
  }
  return result;
}

TEST(Straightest_geodesic, follows_great_circles_on_cloud)
{
  // Algebraic spheres reproduce the sphere, so that only round-off errors remain.
  for(const unsigned level : {2u, 4u})
  {
    const Cloud cloud = octahedron_sphere(level);
    const Point_set points = point_set_of(cloud);
    const auto domain = make_domain(points);
    for(std::size_t i = 0; i < 5; ++i)
    {
      const auto from = points.begin() + std::ptrdiff_t(7 * i);
      const internal::Vec3& p = cloud.points[7 * i];
      const internal::Vec3 u = internal::tangent_frame(p).second;
      const auto path = straightest_geodesic(domain, *from, Vector_3(u[0], u[1], u[2]), 4.);
      EXPECT_FALSE(path.is_cut_by_boundary);
      EXPECT_NEAR(path.length, 4., round_off);
      EXPECT_EQ(path.front_distance, path.length);
      const internal::Vec3 end = std::cos(4.) * p + std::sin(4.) * u;
      EXPECT_LT(distance(to_array(path.points.back()), end), round_off);
      EXPECT_NEAR(path.lower, 2. * std::sin(2.), round_off); // the chord
      EXPECT_EQ(path.locations.size(), path.points.size());
    }
  }
}

TEST(Straightest_geodesic, converges_on_cloud_of_torus)
{
  const Torus torus;
  const auto error = [&](std::size_t n)
  {
    const Point_set points = point_set_of(torus_cloud(n, torus.tube));
    const auto domain = make_domain(points);
    double sum = 0.;
    for(int i = 0; i < 6; ++i)
    {
      // Surfel 0 is at both angles zero.
      const auto path = straightest_geodesic(
          domain, *points.begin(), Vector_3(0., std::cos(double(i)), std::sin(double(i))), 2.);
      EXPECT_NEAR(path.length, 2., round_off);
      sum += distance(to_array(path.points.back()), torus.geodesic(0., 0., double(i), 2.));
    }
    return sum / 12.; // relative to the length
  };
  const double coarse = error(2500), fine = error(10000);
  EXPECT_LT(fine, 0.5 * coarse); // about a quarter for half of the spacing
  EXPECT_LT(fine, 5e-4);
}

TEST(Straightest_geodesic, ends_at_boundary_of_cloud)
{
  const Point_set points = point_set_of(square_cloud(41));
  const double spacing = 1. / 40.;
  const Surfel_location<Point_set::Index> from = {Point_set::Index(20 * 41 + 20), {0.01, 0.}};
  const auto path = straightest_geodesic(points, from, Vector_3(1., 0.5, 0.), 5.);
  EXPECT_TRUE(path.is_cut_by_boundary);
  EXPECT_LT(distance(to_array(path.points.front()), {0.51, 0.5, 0.}), round_off);
  // The surface ends at most two spacings beyond the last surfel.
  const double length = 0.49 * std::sqrt(1.25);
  EXPECT_GT(path.length, length);
  EXPECT_LT(path.length, length + 2. * spacing * std::sqrt(1.25));
  const auto& end = path.locations.back();
  EXPECT_EQ(points.point(end.surfel).x(), 1.);
  EXPECT_LT(std::hypot(end.offset[0], end.offset[1]), 2. * spacing);
}

TEST(Straightest_geodesic, is_same_for_all_kinds_of_clouds)
{
  const Cloud cloud = torus_cloud(2500, 0.4);
  const Point_set points = point_set_of(cloud);
  std::vector<std::pair<Point_3, Vector_3>> range;
  for(const auto& index : points)
    range.emplace_back(points.point(index), points.normal(index));
  using Pair = std::pair<Point_3, Vector_3>;
  const auto maps = parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
                        .normal_map(CGAL::Second_of_pair_property_map<Pair>());
  const Vector_3 direction(0.3, 1., 0.2);
  const auto on_set = straightest_geodesic(points, *(points.begin() + 40), direction, 2.);
  const auto on_domain =
      straightest_geodesic(make_domain(points), *(points.begin() + 40), direction, 2.);
  const auto on_range = straightest_geodesic(range, std::size_t(40), direction, 2., maps);
  const auto with_threads =
      straightest_geodesic(range, std::size_t(40), direction, 2., maps.number_of_threads(3));
  EXPECT_EQ(on_set.points, on_domain.points);
  EXPECT_EQ(on_set.points, on_range.points);
  EXPECT_EQ(on_set.points, with_threads.points);
  EXPECT_EQ(on_set.length, on_range.length);
  for(std::size_t i = 0; i < on_set.locations.size(); ++i)
  {
    EXPECT_EQ(std::size_t(on_set.locations[i].surfel), on_range.locations[i].surfel);
    EXPECT_EQ(on_set.locations[i].offset, on_range.locations[i].offset);
  }
}

TEST(Straightest_geodesic, scales_with_cloud)
{
  const Cloud cloud = torus_cloud(2500, 0.4);
  const auto end = [&](double factor)
  {
    const Point_set points = point_set_of(cloud, factor);
    const auto path =
        straightest_geodesic(points, *(points.begin() + 9), Vector_3(0., 1., 0.4), 2. * factor);
    EXPECT_NEAR(path.length, 2. * factor, round_off * factor);
    const auto& p = path.points.back();
    return Point{p.x() / factor, p.y() / factor, p.z() / factor};
  };
  // Scaled coordinates have round-off errors, which geodesics and the fit amplify.
  EXPECT_LT(distance(end(1e-6), end(1.)), 1e-9);
  EXPECT_LT(distance(end(1e6), end(1.)), 1e-9);
}

TEST(Straightest_geodesic, tolerates_noise_of_cloud)
{
  const Cloud clean = octahedron_sphere(5); // 4,098 surfels
  const Point_set points =
      point_set_of(with_noise(clean, std::vector<double>(clean.size(), 0.05), 0.2, 3));
  const auto path = straightest_geodesic(points, *points.begin(), Vector_3(0., 1., 0.), 3.);
  EXPECT_NEAR(path.length, 3., round_off);
  // The normals have errors of up to 10 degrees and the points of 0.01.
  EXPECT_LT(distance(to_array(path.points.back()), {std::cos(3.), std::sin(3.), 0.}), 0.05);
  // All points are near the sphere: the noise is 0.01.
  for(const auto& p : path.points)
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(p, Point_3(0., 0., 0.))), 1., 0.01);
}

TEST(Straightest_geodesic, accepts_cloud_of_exact_kernel)
{
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  CGAL::Point_set_3<Exact_kernel::Point_3> points(true);
  const Cloud cloud = square_cloud(10);
  for(const auto& p : cloud.points)
    points.insert(Exact_kernel::Point_3(p[0], p[1], p[2]), Exact_kernel::Vector_3(0, 0, 1));
  const auto path =
      straightest_geodesic(points, *points.begin(), Exact_kernel::Vector_3(1, 0, 0), 0.5);
  EXPECT_NEAR(CGAL::to_double(path.points.back().x()), 0.5, round_off);
}

TEST(Straightest_geodesic, throws_on_invalid_input_of_cloud)
{
  const Point_set points = point_set_of(square_cloud(10));
  const auto domain = make_domain(points);
  const Point_set::Index surfel(55);
  const double nan = std::nan("");
  const auto trace = [&](const auto& from, const Vector_3& direction, double length)
  { return straightest_geodesic(domain, from, direction, length); };
  EXPECT_THROW(trace(surfel, Vector_3(0., 0., 0.), 1.), Invalid_argument_error);
  EXPECT_THROW(trace(surfel, Vector_3(0., 0., 1.), 1.), Invalid_argument_error); // the normal
  EXPECT_THROW(trace(surfel, Vector_3(nan, 0., 1.), 1.), Invalid_argument_error);
  EXPECT_THROW(trace(surfel, Vector_3(1., 0., 0.), -1.), Invalid_argument_error);
  EXPECT_THROW(trace(surfel, Vector_3(1., 0., 0.), nan), Invalid_argument_error);
  EXPECT_THROW(trace(Point_set::Index(100), Vector_3(1., 0., 0.), 1.), Invalid_argument_error);
  using Location = Surfel_location<Point_set::Index>;
  EXPECT_THROW(trace(Location{surfel, {nan, 0.}}, Vector_3(1., 0., 0.), 1.),
               Invalid_argument_error);
  EXPECT_NO_THROW(trace(Location{surfel, {0.01, 0.}}, Vector_3(1., 0., 0.), 0.1));
  EXPECT_EQ(trace(surfel, Vector_3(1., 0., 0.), 0.).points.size(), 1u);
}

} // namespace straightest_geodesic_test
