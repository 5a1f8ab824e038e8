// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/trace_on_surface.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include "torus_geodesic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace trace_on_surface_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using CGAL::Geodesic_processing::test::Torus;

constexpr double round_off = 1e-12; // sums of some hundreds of lengths near 1

// A surface whose closest points are computed by a function.
class Function_surface : public Path_surface
{
public:
  using Function = std::function<Projection(const Vec3&)>;

  explicit Function_surface(Function function) : m_function(std::move(function)) {}
  Projection project(const Vec3& point, Index) const override { return m_function(point); }

private:
  Function m_function;
};

Projection project_to_sphere(const Vec3& p) { return {unit(p), unit(p), {0., 0., 0.}, none}; }

Projection project_to_torus(const Vec3& p)
{
  const Torus torus;
  const double u = std::atan2(p[1], p[0]), v = std::atan2(p[2], std::hypot(p[0], p[1]) - 1.);
  return {torus.point(u, v), Torus::normal(u, v), {0., 0., 0.}, none};
}

// The plane z = 0 for x <= 1.
Projection project_to_half_plane(const Vec3& p)
{
  Projection result = {{std::min(p[0], 1.), p[1], 0.}, {0., 0., 1.}, {0., 0., 0.}, none};
  if(p[0] > 1.)
    result.conormal = {1., 0., 0.};
  return result;
}

// The floor z = 0 for x < 1, and the wall x = 1 for z > 0 or for z < 0. As on a cloud, a point is
// projected to the plane of the nearest surfel. The surfels begin at 0.02 from the edge.
template <int sign>
Projection project_to_edge(const Vec3& p)
{
  const double floor = std::hypot(std::max(0., p[0] - 0.98), p[2]),
               wall = std::hypot(p[0] - 1., std::max(0., 0.02 - sign * p[2]));
  if(floor <= wall)
    return {{p[0], p[1], 0.}, {0., 0., 1.}, {0., 0., 0.}, none};
  return {{1., p[1], p[2]}, {-double(sign), 0., 0.}, {0., 0., 0.}, none};
}

Traced_curve trace(const Function_surface::Function& function, const Vec3& from,
                   const Vec3& direction, double length, double step)
{
  return trace_on_surface(
      Function_surface(function), [&](Index) { return step; }, function(from), direction, length);
}

TEST(trace_on_surface, follows_great_circles)
{
  const Vec3 from = unit(Vec3{0.3, -0.5, 0.8});
  const auto [u, v] = tangent_frame(from);
  for(const double step : {0.3, 0.03})
    for(const double length : {0.01, 1., 10.})
    {
      const Traced_curve curve = trace(project_to_sphere, from, 3. * u + 1. * from, length, step);
      EXPECT_FALSE(curve.is_cut_by_boundary);
      EXPECT_NEAR(curve.length, length, round_off * length);
      const Vec3 end = std::cos(length) * from + std::sin(length) * u;
      EXPECT_LT(norm(curve.points.back().point - end), round_off * std::max(1., length));
      const Vec3 direction = std::cos(length) * u - std::sin(length) * from;
      EXPECT_LT(norm(curve.end_direction - direction), round_off * std::max(1., length));
    }
}

// Returns the error of the endpoint of a geodesic on a torus.
double error_on_torus(double step)
{
  const Torus torus;
  double error = 0.;
  for(int i = 0; i < 6; ++i)
  {
    const double angle = 0.2 + i;
    const Vec3 direction =
        std::cos(angle) * Torus::tangent_u(0.) + std::sin(angle) * Torus::tangent_v(0., 0.3);
    const Traced_curve curve = trace(project_to_torus, torus.point(0., 0.3), direction, 4., step);
    // Corrections of the last step leave 1e-12 of the length.
    EXPECT_NEAR(curve.length, 4., 4. * round_off);
    error = std::max(error, norm(curve.points.back().point - torus.geodesic(0., 0.3, angle, 4.)));
  }
  return error;
}

TEST(trace_on_surface, converges_with_order_4_on_torus)
{
  const double coarse = error_on_torus(0.04), fine = error_on_torus(0.02);
  // Half of the step divides the error by 16; the last steps differ.
  EXPECT_LT(fine, coarse / 12.);
  EXPECT_LT(fine, 1e-7); // measured: 1.7e-8
}

TEST(trace_on_surface, satisfies_clairaut_relation)
{
  // The distance to the axis times the cosine of the angle to the circle around it is constant.
  const Torus torus;
  const Vec3 direction = Torus::tangent_u(0.) + Torus::tangent_v(0., 0.3);
  const double constant = (1. + torus.tube * std::cos(0.3)) * std::sqrt(0.5);
  for(int i = 1; i <= 20; ++i)
  {
    const Traced_curve curve =
        trace(project_to_torus, torus.point(0., 0.3), direction, 0.2 * i, 0.02);
    const Vec3& p = curve.points.back().point;
    const Vec3 around = {-p[1], p[0], 0.}; // its length is the distance to the axis
    EXPECT_NEAR(dot(around, curve.end_direction), constant, 1e-7); // as the error of the endpoint
  }
}

TEST(trace_on_surface, stops_at_boundary)
{
  for(const double slope : {0., 0.5, 2.})
  {
    const Traced_curve curve =
        trace(project_to_half_plane, {0.33, 0., 0.}, {1., slope, 0.}, 10., 0.1);
    EXPECT_TRUE(curve.is_cut_by_boundary);
    // Bisection ends at 2^-30 steps.
    EXPECT_NEAR(curve.length, 0.67 * std::hypot(1., slope), 1e-9);
    EXPECT_LT(norm(curve.points.back().point - Vec3{1., 0.67 * slope, 0.}), 1e-9);
  }
  const Traced_curve outward = trace(project_to_half_plane, {1., 0., 0.}, {1., 0., 0.}, 1., 0.1);
  EXPECT_TRUE(outward.is_cut_by_boundary);
  // Bisection ends at 2^-30 steps.
  EXPECT_LT(outward.length, 1e-9);
  const Traced_curve inward = trace(project_to_half_plane, {1., 0., 0.}, {-1., 0., 0.}, 1., 0.1);
  EXPECT_FALSE(inward.is_cut_by_boundary);
  EXPECT_NEAR(inward.length, 1., round_off);
}

TEST(trace_on_surface, crosses_small_holes_only)
{
  // A plane with a slit of a given width.
  const auto curve = [](double width)
  {
    const auto project = [=](const Vec3& p)
    {
      Projection result = {{p[0], p[1], 0.}, {0., 0., 1.}, {0., 0., 0.}, none};
      if(std::abs(p[0]) < 0.5 * width)
      {
        const double side = std::copysign(1., p[0]);
        result.point[0] = side * 0.5 * width;
        result.conormal = {-side, 0., 0.};
      }
      return result;
    };
    return trace(project, {-0.93, 0., 0.}, {1., 0., 0.}, 2., 0.1);
  };
  EXPECT_FALSE(curve(0.05).is_cut_by_boundary);
  EXPECT_NEAR(curve(0.05).points.back().point[0], 1.07, round_off);
  EXPECT_TRUE(curve(0.5).is_cut_by_boundary);
  EXPECT_NEAR(curve(0.5).length, 0.93 - 0.25, 1e-9); // bisection
}

TEST(trace_on_surface, unfolds_sharp_edges)
{
  const auto check = [](const auto& project, double sign)
  {
    for(const double slope : {0., 0.5, 2.})
    {
      const Vec3 from = {0.33, 0.1, 0.}, direction = {1., slope, 0.};
      const double length = 1.2 * std::hypot(1., slope);
      const Traced_curve curve = trace(project, from, direction, length, 0.1);
      EXPECT_FALSE(curve.is_cut_by_boundary);
      EXPECT_NEAR(curve.length, length, round_off);
      // On the wall after 0.67 units of x, at the height 0.53.
      const Vec3 end = {1., 0.1 + 1.2 * slope, sign * 0.53};
      EXPECT_LT(norm(curve.points.back().point - end), round_off);
    }
  };
  check(project_to_edge<1>, 1.);
  check(project_to_edge<-1>, -1.);
}

TEST(trace_on_surface, is_single_point_for_zero_length)
{
  const Traced_curve curve = trace(project_to_sphere, {1., 0., 0.}, {0., 1., 0.}, 0., 0.1);
  EXPECT_EQ(curve.points.size(), 1u);
  EXPECT_EQ(curve.length, 0.);
  EXPECT_FALSE(curve.is_cut_by_boundary);
}

TEST(trace_on_surface, accepts_directions_of_any_magnitude)
{
  const auto end = [](double size) {
    return trace(project_to_sphere, {1., 0., 0.}, {0., size, 0.}, 1., 0.1).points.back().point;
  };
  EXPECT_EQ(end(1e-300), end(1.));
  EXPECT_EQ(end(1e300), end(1.));
}

TEST(trace_on_surface, throws_on_invalid_direction_or_length)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto run = [](const Vec3& direction, double length) {
    return trace(project_to_sphere, {1., 0., 0.}, direction, length, 0.1);
  };
  EXPECT_THROW(run({0., 0., 0.}, 1.), Invalid_argument_error);
  EXPECT_THROW(run({2., 0., 0.}, 1.), Invalid_argument_error); // normal to the surface
  EXPECT_THROW(run({0., nan, 1.}, 1.), Invalid_argument_error);
  EXPECT_THROW(run({0., infinity, 1.}, 1.), Invalid_argument_error);
  EXPECT_THROW(run({0., 1., 0.}, -1.), Invalid_argument_error);
  EXPECT_THROW(run({0., 1., 0.}, nan), Invalid_argument_error);
  EXPECT_THROW(run({0., 1., 0.}, infinity), Invalid_argument_error);
}

} // namespace trace_on_surface_test
