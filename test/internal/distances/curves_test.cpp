// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/curves.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"
#include "path_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace curves_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;
using internal::operator*;
using internal::operator+;
using internal::operator-;

using Path = std::vector<Surface_location>;
using Points = std::vector<Vec3>;

// Round-off errors of points of order one after up to 24 steps of midpoints, with the errors of
// shortest paths (2e-12).
constexpr double round_off = 1e-10;

Points points_of(const Array_surface& surface, const Path& path)
{
  Points result;
  for(const Surface_location& location : path)
    result.push_back(coordinates(surface.t(), location));
  return result;
}

Curve_options subdivided(unsigned number)
{
  Curve_options result;
  result.number_of_subdivisions = number;
  return result;
}

double length_of(const Array_surface& surface, const Path& path)
{
  return surface.scale() * path_length(surface.t(), path);
}

// Expects that a path in the plane is the polyline through these points: it passes through all of
// them in this order, and has its length.
void expect_polyline(const Array_surface& surface, const Path& path, const Points& expected)
{
  const Points points = points_of(surface, path);
  double length = 0.;
  std::size_t next = 0;
  for(std::size_t i = 0; i < expected.size(); ++i)
  {
    while(next < points.size() && norm(points[next] - expected[i]) > round_off)
      ++next;
    ASSERT_LT(next, points.size()) << "point " << i << " is not on the path";
    length += i == 0 ? 0. : norm(expected[i] - expected[i - 1]);
  }
  EXPECT_NEAR(length_of(surface, path), length, round_off * double(points.size()));
}

// Random locations in the inner half of a jittered square. Shortest paths in it are straight.
struct Curves_in_plane : testing::Test
{
  Array_surface surface{square(8, 0.24)};
  std::mt19937 random{5};

  Path control_points(std::size_t number)
  {
    Path result;
    for(std::size_t i = 0; i < number; ++i)
      result.push_back(random_location(surface.t(), random));
    return result;
  }
};

Vec3 bezier_point(const Points& control, double t)
{
  const std::size_t p = control.size() - 1;
  Vec3 result = {0., 0., 0.};
  double binomial = 1.;
  for(std::size_t i = 0; i <= p; ++i)
  {
    result =
        result + binomial * std::pow(t, double(i)) * std::pow(1. - t, double(p - i)) * control[i];
    binomial *= double(p - i) / double(i + 1);
  }
  return result;
}

TEST_F(Curves_in_plane, bezier_curve_is_the_sum_of_bernstein_polynomials)
{
  for(const std::size_t degree : {1, 2, 3, 5})
  {
    const Path control = control_points(degree + 1);
    for(const unsigned k : {0u, 1u, 4u})
    {
      Points expected;
      for(unsigned i = 0; i <= 1u << k; ++i)
        expected.push_back(bezier_point(points_of(surface, control), double(i) / double(1u << k)));
      expect_polyline(surface, bezier_curve(surface.triangles(), control, subdivided(k)), expected);
    }
  }
}

// Refines a control polygon by the masks of uniform B-splines. Open polygons lose points at the
// ends.
Points refined(const Points& p, unsigned degree, bool is_closed)
{
  const std::size_t n = p.size();
  Points result;
  const auto at = [&](std::size_t i) { return p[i % n]; };
  if(degree == 2)
    for(std::size_t i = 0; i < (is_closed ? n : n - 1); ++i)
    {
      result.push_back(0.75 * at(i) + 0.25 * at(i + 1));
      result.push_back(0.25 * at(i) + 0.75 * at(i + 1));
    }
  else
    for(std::size_t i = 0; i < (is_closed ? n : n - 1); ++i)
    {
      if(i > 0 || is_closed)
        result.push_back(0.125 * at(i + n - 1) + 0.75 * at(i) + 0.125 * at(i + 1));
      result.push_back(0.5 * at(i) + 0.5 * at(i + 1));
    }
  return result;
}

TEST_F(Curves_in_plane, spline_is_refined_by_the_masks_of_b_splines)
{
  const unsigned k = 3;
  for(const unsigned degree : {2u, 3u})
    for(const bool is_closed : {false, true})
    {
      const Path control = control_points(5);
      Points expected = points_of(surface, control);
      if(!is_closed)
      {
        expected.insert(expected.begin(), degree - 1, Vec3(expected.front()));
        expected.insert(expected.end(), degree - 1, Vec3(expected.back()));
      }
      for(unsigned i = 0; i < k; ++i)
        expected = refined(expected, degree, is_closed);
      Path spline = b_spline(surface.triangles(), control, degree, is_closed, subdivided(k));
      if(is_closed)
      {
        // Both are cyclic. The spline begins at one of the expected points.
        const Vec3 first = points_of(surface, {spline.front()}).front();
        const auto begin = std::find_if(expected.begin(), expected.end(),
                                        [&](const Vec3& p) { return norm(p - first) < round_off; });
        ASSERT_NE(begin, expected.end());
        std::rotate(expected.begin(), begin, expected.end());
        expected.push_back(expected.front());
        EXPECT_TRUE(is_same_point(surface.t(), spline.front(), spline.back()));
      }
      expect_polyline(surface, spline, expected);
    }
}

TEST_F(Curves_in_plane, spline_of_degree_one_is_the_control_polygon)
{
  const Path control = control_points(4);
  expect_polyline(surface, b_spline(surface.triangles(), control, 1, false, subdivided(2)),
                  points_of(surface, control));
  Points closed = points_of(surface, control);
  closed.push_back(closed.front());
  expect_polyline(surface, b_spline(surface.triangles(), control, 1, true, subdivided(2)), closed);
}

TEST_F(Curves_in_plane, open_spline_is_the_sum_of_cubic_b_splines)
{
  const unsigned k = 5;
  const Path control = control_points(6);
  Points p = points_of(surface, control);
  p.insert(p.begin(), 2, Vec3(p.front()));
  p.insert(p.end(), 2, Vec3(p.back()));
  const Path spline = b_spline(surface.triangles(), control, 3, false, subdivided(k));
  const Points points = points_of(surface, spline);
  // The distance of a uniform cubic B-spline from its control polygon is at most 1/6 of the largest
  // second difference, because S(j) = P(j) + (P(j - 1) - 2 P(j) + P(j + 1)) / 6. A subdivision
  // divides second differences by four. Those of points in a unit square are at most 4 sqrt(2).
  const double bound = 4. * std::sqrt(2.) / 6. / std::pow(4., k);
  for(std::size_t j = 1; j + 2 < p.size(); ++j)
    for(const double t : {0., 0.25, 0.5, 0.875})
    {
      const double s = 1. - t;
      const Vec3 expected = 1. / 6. *
                            (s * s * s * p[j - 1] + (4. - 6. * t * t + 3. * t * t * t) * p[j] +
                             (4. - 6. * s * s + 3. * s * s * s) * p[j + 1] + t * t * t * p[j + 2]);
      double smallest = infinity;
      for(std::size_t i = 0; i + 1 < points.size(); ++i)
        smallest = std::min(smallest, distance_to_segment(expected, points[i], points[i + 1]));
      EXPECT_LE(smallest, bound);
    }
}

// The difference of a smooth curve and a polyline of 2^k segments through its points is a multiple
// of 4^-k.
TEST(curves, lengths_converge_quadratically)
{
  // The control points are at multiples of 60 degrees near the equator.
  const Array_surface sphere(icosphere(4));
  Path control;
  for(const Vec3& p : {Vec3{1., 0., 0.}, {0.5, 0.8, 0.4}, {-0.5, 0.8, -0.4}, {-1., 0.1, 0.}})
  {
    Index closest = 0;
    for(Index i = 0; i < sphere.size(); ++i)
      if(distance(sphere.point(i), p) < distance(sphere.point(closest), p))
        closest = i;
    control.push_back(sphere.at(closest));
  }
  for(const bool is_spline : {false, true})
  {
    std::vector<double> lengths;
    for(unsigned k = 0; k < 5; ++k)
      lengths.push_back(length_of(
          sphere, is_spline ? b_spline(sphere.triangles(), control, 3, true, subdivided(k))
                            : bezier_curve(sphere.triangles(), control, subdivided(k))));
    for(std::size_t k = 1; k + 2 < lengths.size(); ++k)
    {
      const double ratio = (lengths[k + 1] - lengths[k]) / (lengths[k + 2] - lengths[k + 1]);
      // Four in the limit. The next term of the expansion is of order 4^-k.
      EXPECT_GT(ratio, 3.);
      EXPECT_LT(ratio, 5.5);
    }
  }
}

TEST(curves, equal_control_points_are_one_point)
{
  const Array_surface surface(square(4));
  const Path control(3, surface.at(7));
  EXPECT_EQ(bezier_curve(surface.triangles(), control).size(), 1u);
  EXPECT_EQ(b_spline(surface.triangles(), control, 3, true).size(), 1u);
}

TEST(curves, midpoint_halves_a_path)
{
  const Array_surface surface(square(4));
  const Path path = {surface.at(0), surface.at(1), surface.at(2), surface.at(3)};
  const Vec3 middle = coordinates(surface.t(), path_midpoint(surface.t(), path));
  EXPECT_LT(norm(middle - Vec3{0.375, 0., 0.}), 1e-15); // round-off
  EXPECT_TRUE(is_same_point(surface.t(), path_midpoint(surface.t(), {path[2]}), path[2]));
}

TEST(curves, reports_fractions_and_throws_on_invalid_input)
{
  const Array_surface surface(disjoint_union(square(2), square(2)));
  const Path control = surface.along({0, 4, 2});
  std::vector<double> fractions;
  Curve_options options;
  options.callback = [&](double fraction)
  {
    fractions.push_back(fraction);
    return true;
  };
  bezier_curve(surface.triangles(), control, options);
  b_spline(surface.triangles(), control, 2, false, options);
  ASSERT_FALSE(fractions.empty());
  EXPECT_GT(*std::max_element(fractions.begin(), fractions.end()), 0.9);
  EXPECT_LE(*std::max_element(fractions.begin(), fractions.end()), 1.);

  const auto& t = surface.triangles();
  EXPECT_THROW(bezier_curve(t, {control[0]}), Invalid_argument_error);
  EXPECT_THROW(bezier_curve(t, control, subdivided(21)), Invalid_argument_error);
  EXPECT_THROW(bezier_curve(t, surface.along({0, 12})), Invalid_argument_error);
  EXPECT_THROW(b_spline(t, control, 0, false), Invalid_argument_error);
  EXPECT_THROW(b_spline(t, surface.along({0, 12}), 2, false), Invalid_argument_error);
}

} // namespace curves_test
