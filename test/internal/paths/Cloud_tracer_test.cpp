// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Cloud_tracer.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "clouds.h"
#include "torus_geodesic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <thread>
#include <vector>

namespace Cloud_tracer_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

constexpr double round_off = 1e-12; // sums of some hundreds of lengths near 1

Cloud_tracer tracer_of(const Cloud& cloud, unsigned number_of_threads = 1)
{
  return Cloud_tracer(cloud.points, cloud.normals, {}, number_of_threads);
}

TEST(Cloud_tracer, follows_great_circles)
{
  // The fit reproduces a sphere, and a step reproduces a great circle. So only round-off errors
  // remain at any density.
  for(const Cloud& cloud : {octahedron_sphere(2), octahedron_sphere(4), random_sphere(4000)})
  {
    const Cloud_tracer trace = tracer_of(cloud);
    for(Index i = 0; i < 20; ++i)
    {
      const Vec3 p = cloud.points[i];
      const Vec3 direction = tangent_frame(p).first;
      const Traced_path path = trace({i, {0., 0.}}, 5. * direction, 3.);
      EXPECT_FALSE(path.is_cut_by_boundary);
      EXPECT_NEAR(path.length, 3., round_off);
      EXPECT_LT(norm(path.points.back() - std::cos(3.) * p - std::sin(3.) * direction), round_off);
    }
  }
}

// Returns the mean error of the endpoints of geodesics on a torus, relative to their length.
double error_on_torus(std::size_t n)
{
  const Torus torus;
  const Cloud cloud = torus_cloud(n, torus.tube);
  const Cloud_tracer trace = tracer_of(cloud);
  double sum = 0.;
  constexpr int number_of_paths = 30;
  for(int i = 0; i < number_of_paths; ++i)
  {
    const std::size_t surfel = std::size_t(i) * 7919 % cloud.size();
    const Vec3& p = cloud.points[surfel];
    const double u = std::atan2(p[1], p[0]), v = std::atan2(p[2], std::hypot(p[0], p[1]) - 1.);
    const Vec3 direction =
        std::cos(double(i)) * Torus::tangent_u(u) + std::sin(double(i)) * Torus::tangent_v(u, v);
    const Traced_path path = trace({Index(surfel), {0., 0.}}, direction, 2.);
    EXPECT_FALSE(path.is_cut_by_boundary);
    EXPECT_NEAR(path.length, 2., 1e-9); // corrected in the last step
    sum += norm(path.points.back() - torus.geodesic(u, v, double(i), 2.)) / 2.;
  }
  return sum / number_of_paths;
}

TEST(Cloud_tracer, converges_to_geodesics_of_torus)
{
  const double coarse = error_on_torus(2500), fine = error_on_torus(10000);
  // Half of the spacing divides the error by about four. Geodesics diverge on the inside, which
  // amplifies the error of the fit.
  EXPECT_LT(fine, 0.5 * coarse);
  EXPECT_LT(fine, 3e-4); // measured: 1.5e-4
}

TEST(Cloud_tracer, satisfies_clairaut_relation)
{
  // The distance to the axis times the cosine of the angle to the circle around it is constant.
  const Torus torus;
  const Cloud cloud = torus_cloud(10000, torus.tube);
  const Cloud_tracer trace = tracer_of(cloud);
  const Vec3 start = cloud.points[17];
  const double u = std::atan2(start[1], start[0]),
               v = std::atan2(start[2], std::hypot(start[0], start[1]) - 1.);
  const Traced_path path = trace({17, {0., 0.}}, Torus::tangent_u(u) + Torus::tangent_v(u, v), 6.);
  const double constant = std::hypot(start[0], start[1]) * std::sqrt(0.5);
  ASSERT_GT(path.points.size(), 100u);
  for(std::size_t i = 1; i + 1 < path.points.size(); ++i)
  {
    // The difference of both neighbors is tangential up to the square of the step, 0.03.
    const Vec3 &p = path.points[i], tangent = unit(path.points[i + 1] - path.points[i - 1]);
    EXPECT_NEAR(tangent[1] * p[0] - tangent[0] * p[1], constant, 2e-3);
  }
}

TEST(Cloud_tracer, is_straight_in_plane_and_stops_at_boundary)
{
  const Cloud cloud = square_cloud(41);
  const Cloud_tracer trace = tracer_of(cloud);
  const double spacing = 1. / 40.;
  const Tangent_location from = {Index(20 * 41 + 20), {0.3 * spacing, -0.2 * spacing}};
  // The first axis of the tangent plane is the x-axis.
  const Vec3 start = {0.5 + 0.3 * spacing, 0.5 - 0.2 * spacing, 0.};
  for(int i = 0; i < 12; ++i)
  {
    const Vec3 direction = {std::cos(0.5 * i), std::sin(0.5 * i), 0.};
    const Traced_path inside = trace(from, direction + Vec3{0., 0., 2.}, 0.4);
    EXPECT_FALSE(inside.is_cut_by_boundary);
    EXPECT_NEAR(inside.length, 0.4, round_off);
    EXPECT_LT(norm(inside.points.front() - start), round_off);
    EXPECT_LT(norm(inside.points.back() - start - 0.4 * direction), round_off);

    const Traced_path cut = trace(from, direction, 5.);
    EXPECT_TRUE(cut.is_cut_by_boundary);
    EXPECT_LT(norm(cut.points.back() - start - cut.length * direction), round_off);
    // Beyond the last surfels, the surface ends at 1.5 radii. The radius of a surfel at the
    // boundary is 1.1 spacings on average with its neighbors.
    const Vec3& end = cut.points.back();
    const double distance_outside = std::max(std::abs(end[0] - 0.5), std::abs(end[1] - 0.5)) - 0.5;
    EXPECT_GT(distance_outside, 0.);
    EXPECT_LT(distance_outside, 2. * spacing);
  }
}

TEST(Cloud_tracer, does_not_cross_gaps)
{
  const double spacing = 1. / 40.;
  const Cloud cloud = part_of(square_cloud(41),
                              [=](const Vec3& p) { return std::abs(p[0] - 0.5) > 3.6 * spacing; });
  const Traced_path path = tracer_of(cloud)({20, {0., 0.}}, {1., 0., 0.}, 1.);
  EXPECT_TRUE(path.is_cut_by_boundary);
  // The last surfels are 4 spacings in front of the middle.
  EXPECT_NEAR(path.length, 0.5 - 4. * spacing, 2. * spacing);
}

TEST(Cloud_tracer, rarely_stops_on_random_cloud)
{
  const Cloud cloud = random_sphere(4000);
  const Cloud_tracer trace = tracer_of(cloud);
  int number_of_cut_paths = 0;
  for(Index i = 0; i < 40; ++i)
    number_of_cut_paths +=
        trace({i, {0., 0.}}, tangent_frame(cloud.points[i]).first, 30.).is_cut_by_boundary;
  EXPECT_LE(number_of_cut_paths, 1); // holes that are wider than four steps
}

TEST(Cloud_tracer, unfolds_cube)
{
  const std::size_t n = 20;
  const Cloud cloud = cube_cloud(n);
  const Cloud_tracer trace = tracer_of(cloud);
  // A surfel on the face x = 0.5 near its center.
  const auto surfel = std::find_if(cloud.points.begin(), cloud.points.end(),
                                   [](const Vec3& p) {
                                     return p[0] == 0.5 && std::abs(p[1] - 0.025) < 1e-9 &&
                                            std::abs(p[2] - 0.025) < 1e-9;
                                   });
  ASSERT_NE(surfel, cloud.points.end());
  const Index from = Index(surfel - cloud.points.begin());
  for(const double slope : {0., 0.1, -0.15})
  {
    // It crosses the faces y = 0.5 and x = -0.5, and ends in y = -0.5.
    const double length = 3. * std::hypot(1., slope);
    const Traced_path path = trace({from, {0., 0.}}, {0., 1., slope}, length);
    const double z = 0.025 + 3. * slope;
    EXPECT_FALSE(path.is_cut_by_boundary);
    // 0.475 to the first edge, and 1 to each of the next two: 0.525 remain.
    const Vec3 end = {-0.5 + 0.525, -0.5, z};
    EXPECT_LT(norm(path.points.back() - end), 1e-9) << slope; // the fit of planes is exact
  }
}

TEST(Cloud_tracer, does_not_depend_on_scale)
{
  const Cloud cloud = torus_cloud(2500, 0.4);
  const auto run = [&](double factor)
  {
    Cloud scaled = cloud;
    for(Vec3& p : scaled.points)
      p = factor * p;
    Traced_path path = tracer_of(scaled)({5, {0., 0.}}, {0.3, 1., 0.2}, 2. * factor);
    for(Vec3& p : path.points)
      p = (1. / factor) * p;
    path.length /= factor;
    return path;
  };
  const Traced_path expected = run(1.);
  for(const double factor : {1e-6, 1e6})
  {
    const Traced_path path = run(factor);
    EXPECT_NEAR(path.length, expected.length, round_off);
    ASSERT_EQ(path.points.size(), expected.points.size());
    // The scaled coordinates differ by round-off errors, which geodesics and the fit amplify.
    for(std::size_t i = 0; i < path.points.size(); ++i)
      EXPECT_LT(norm(path.points[i] - expected.points[i]), 1e-9);
  }
}

TEST(Cloud_tracer, tolerates_noise)
{
  const Cloud clean = octahedron_sphere(5); // 4,098 surfels
  const std::vector<double> radii(clean.size(), 0.05);
  const Cloud noisy = with_noise(clean, radii, 0.2, 3);
  const Cloud_tracer trace = tracer_of(noisy);
  double sum = 0.;
  for(Index i = 0; i < 50; ++i)
  {
    const Vec3 p = clean.points[i], direction = tangent_frame(p).first;
    const Traced_path path = trace({i, {0., 0.}}, direction, 3.);
    EXPECT_FALSE(path.is_cut_by_boundary);
    EXPECT_NEAR(path.length, 3., round_off);
    sum += norm(path.points.back() - std::cos(3.) * p - std::sin(3.) * direction) / 3.;
  }
  // The normals have errors of up to 10 degrees, the points of 0.01. Measured: 0.003.
  EXPECT_LT(sum / 50., 0.01);
}

TEST(Cloud_tracer, locations_are_near_points)
{
  const Cloud cloud = octahedron_sphere(4);
  const Traced_path path = tracer_of(cloud)({3, {0.01, 0.02}}, {0.3, 0.5, -0.7}, 1.5);
  ASSERT_EQ(path.locations.size(), path.points.size());
  for(std::size_t i = 0; i < path.points.size(); ++i)
  {
    const Tangent_location& location = path.locations[i];
    const auto [u, v] = tangent_frame(cloud.normals[location.vertex]);
    const Vec3 offset = location.offset[0] * u + location.offset[1] * v;
    const Vec3 p = cloud.points[location.vertex] + offset;
    // The tangent plane is above the sphere by half of the squared distance.
    EXPECT_LT(norm(p - path.points[i]), 0.51 * dot(offset, offset) + round_off);
    EXPECT_LT(norm(offset), 0.1); // the spacing
  }
}

TEST(Cloud_tracer, copies_can_be_used_concurrently)
{
  const Cloud_tracer tracer = tracer_of(torus_cloud(2500, 0.4), 2);
  const auto run = [](const Cloud_tracer& trace, Index i) {
    return trace({i, {0., 0.}}, {0.3, 1., 0.2}, 1.).points;
  };
  std::vector<std::vector<Vec3>> results(40);
  const auto run_half = [&, copy = tracer](std::size_t half)
  {
    for(std::size_t i = half; i < results.size(); i += 2)
      results[i] = run(copy, Index(i));
  };
  std::thread thread(run_half, 0);
  run_half(1);
  thread.join();
  for(std::size_t i = 0; i < results.size(); ++i)
    EXPECT_EQ(results[i], run(tracer, Index(i)));
}

TEST(Cloud_tracer, handles_single_and_coincident_surfels)
{
  Cloud cloud;
  cloud.add({1., 2., 3.}, {0., 0., 1.});
  const Traced_path single = tracer_of(cloud)({0, {0., 0.}}, {1., 0., 0.}, 1.);
  EXPECT_TRUE(single.is_cut_by_boundary);
  EXPECT_LT(single.length, 1e-5); // the smallest step
  EXPECT_EQ(single.locations.front().vertex, 0u);
  Cloud square = square_cloud(20);
  for(int i = 0; i < 10; ++i)
    square.add(square.points[0], square.normals[0]);
  const Traced_path path =
      tracer_of(square)({Index(square.size() - 1), {0., 0.}}, {1., 1., 0.}, 0.5);
  EXPECT_FALSE(path.is_cut_by_boundary);
  EXPECT_LT(norm(path.points.back() - Vec3{0.5 * std::sqrt(0.5), 0.5 * std::sqrt(0.5), 0.}),
            round_off);
}

TEST(Cloud_tracer, throws_on_invalid_direction_or_length)
{
  const Cloud_tracer trace = tracer_of(square_cloud(10));
  EXPECT_THROW(trace({55, {0., 0.}}, {0., 0., 0.}, 1.), Invalid_argument_error);
  EXPECT_THROW(trace({55, {0., 0.}}, {0., 0., 1.}, 1.), Invalid_argument_error); // normal
  EXPECT_THROW(trace({55, {0., 0.}}, {1., 0., 0.}, -1.), Invalid_argument_error);
  EXPECT_THROW(trace({55, {0., 0.}}, {1., 0., 0.}, infinity), Invalid_argument_error);
}

} // namespace Cloud_tracer_test
