// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/ball_area.h>

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/paths/isolines.h>
#include "core/unfold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A point with these distances from the corners of a triangle in the plane, if there is one.
std::optional<Vec2> point_at_distances(const std::array<Vec2, 3>& corners,
                                       const std::array<double, 3>& d)
{
  const double base = corners[1][0], height = corners[2][1];
  if(!(base > 0. && height > 0.))
    return {};
  // Differences of squared distances are linear in the point.
  const double x = 0.5 * (base + (d[0] - d[1]) * ((d[0] + d[1]) / base));
  const double y =
      0.5 * ((d[0] - d[2]) * (d[0] + d[2]) + dot(corners[2], corners[2]) - 2. * x * corners[2][0]) /
      height;
  // Distances of exact windows have relative errors of 1e-12. Those of different windows usually
  // differ by far more than this.
  constexpr double tolerance = 1e-9;
  if(std::abs(norm(Vec2{x, y}) - d[0]) > tolerance * (d[0] + base))
    return {};
  return Vec2{x, y};
}

// Returns the signed area of the intersection of the disk around the origin with the triangle of
// the origin, p and q.
double signed_disk_area(const Vec2& p, const Vec2& q, double radius)
{
  const auto sector = [&](const Vec2& a, const Vec2& b)
  { return 0.5 * radius * radius * std::atan2(cross(a, b), dot(a, b)); };
  const Vec2 step = q - p;
  const double length = norm(step);
  if(length == 0.)
    return 0.;
  // The line enters the disk at first and leaves it at last.
  const double middle = -dot(p, step) / length, distance = cross(p, step) / length;
  const double squared_half = (radius - distance) * (radius + distance);
  const double half = squared_half > 0. ? std::sqrt(squared_half) : 0.;
  const double first = std::clamp((middle - half) / length, 0., 1.),
               last = std::clamp((middle + half) / length, 0., 1.);
  if(!(first < last))
    return sector(p, q);
  const Vec2 entry = p + first * step, exit = p + last * step;
  return sector(p, entry) + 0.5 * cross(entry, exit) + sector(exit, q);
}

double disk_area(const std::array<Vec2, 3>& corners, const Vec2& center, double radius)
{
  double area = 0.;
  for(const int i : {0, 1, 2})
    area += signed_disk_area(corners[i] - center, corners[(i + 1) % 3] - center, radius);
  return std::max(0., area);
}

// Returns the fraction of a triangle that is in the ball, which is bounded by a chord.
double fraction_of_triangle(const Surface_arrays& t, Index triangle, const std::array<double, 3>& d,
                            double radius)
{
  // Returns the fraction of the triangle that the chord cuts off at a corner.
  const auto cut_off = [&](int corner)
  {
    double product = 1.;
    for(const int other : {(corner + 1) % 3, (corner + 2) % 3})
    {
      const bool is_inside = d[corner] <= radius;
      const Index halfedge = 3 * triangle + Index((corner + 1) % 3 == other ? corner : other);
      const double fraction =
          isoline_position(d[is_inside ? corner : other], d[is_inside ? other : corner], radius,
                           t.length[halfedge], Edge_interpolation::circular);
      product *= is_inside ? fraction : 1. - fraction;
    }
    return product;
  };
  int number_inside = 0;
  for(const double distance : d)
    number_inside += distance <= radius;
  for(const int corner : {0, 1, 2})
  {
    if(number_inside == 1 && d[corner] <= radius)
      return cut_off(corner);
    if(number_inside == 2 && d[corner] > radius)
      return 1. - cut_off(corner);
  }
  return number_inside == 3 ? 1. : 0.;
}

} // namespace

Ball measure_ball(const Surface_arrays& t, const std::vector<double>& distances, double radius)
{
  Ball result;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const std::array<double, 3> d = {distances[t.corner[3 * f]], distances[t.corner[3 * f + 1]],
                                     distances[t.corner[3 * f + 2]]};
    const auto [smallest, largest] = std::minmax({d[0], d[1], d[2]});
    const double longest = std::max({t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]});
    if(!(largest < infinity) || smallest - longest > radius)
      continue;
    const double area = 0.5 * twice_area(t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]);
    if(largest <= radius)
    {
      result.triangles.push_back(f);
      result.area += area;
      continue;
    }
    const std::array<Vec2, 3> corners = unfolded(t, f);
    if(const std::optional<Vec2> center = point_at_distances(corners, d))
      result.area += std::min(area, disk_area(corners, *center, radius));
    else
      result.area += area * fraction_of_triangle(t, f, d, radius);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
