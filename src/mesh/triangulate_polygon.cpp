// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangulate_polygon.h"

#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Planar_point = std::array<double, 2>;

double signed_area(const Planar_point& a, const Planar_point& b, const Planar_point& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Projects a polygon to a coordinate plane and scales it to about unit size. Returns an empty
// array if the polygon spans no plane.
std::vector<Planar_point> project_to_plane(const std::vector<Vec3>& corners)
{
  const Vec3 origin = corners[0];
  double size = 0.;
  std::vector<Vec3> p = corners;
  // Coordinates are halved, so that differences of huge values do not overflow.
  for(Vec3& x : p)
    for(std::size_t c = 0; c < 3; ++c)
    {
      x[c] = x[c] / 2. - origin[c] / 2.;
      size = std::max(size, std::abs(x[c]));
    }
  if(size == 0.)
    return {};
  for(Vec3& x : p)
    for(double& c : x)
      c /= size;

  // Newell's normal, which is correct for concave and nonplanar polygons.
  Vec3 normal = {0., 0., 0.};
  for(std::size_t i = 0; i < p.size(); ++i)
  {
    const Vec3 &a = p[i], &b = p[(i + 1) % p.size()];
    for(std::size_t c = 0; c < 3; ++c)
      normal[c] += a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
  }
  std::size_t axis = 0;
  for(std::size_t c = 1; c < 3; ++c)
    if(std::abs(normal[c]) > std::abs(normal[axis]))
      axis = c;
  if(normal[axis] == 0.)
    return {};
  // The polygon is projected along the axis that is closest to its normal. This preserves the
  // signs of areas and adds no round-off errors.
  const double sign = normal[axis] > 0. ? 1. : -1.;
  std::vector<Planar_point> projected(p.size());
  for(std::size_t i = 0; i < p.size(); ++i)
    projected[i] = {p[i][(axis + 1) % 3], sign * p[i][(axis + 2) % 3]};
  return projected;
}

double squared_distance(const Planar_point& a, const Planar_point& b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

bool is_in_triangle(const Planar_point& a, const Planar_point& b, const Planar_point& c,
                    const Planar_point& p)
{
  return p != a && p != b && p != c && signed_area(a, b, p) >= 0. && signed_area(b, c, p) >= 0. &&
         signed_area(c, a, p) >= 0.;
}

using Ear = std::array<Index, 3>;

// Triangulates a polygon by ear clipping. Always returns n - 2 triangles. If there is no ear, as
// in a self-intersecting polygon, the most convex corner is cut off.
std::vector<Ear> clip_ears(const std::vector<Planar_point>& p)
{
  std::vector<Ear> triangles;
  std::vector<Index> remaining(p.size());
  std::iota(remaining.begin(), remaining.end(), 0);

  std::size_t begin = 0;
  while(remaining.size() > 3)
  {
    const std::size_t n = remaining.size();
    const auto area = [&](std::size_t i) {
      return signed_area(p[remaining[(i + n - 1) % n]], p[remaining[i]], p[remaining[(i + 1) % n]]);
    };
    std::vector<Index> reflex;
    for(std::size_t i = 0; i < n; ++i)
      if(area(i) <= 0.)
        reflex.push_back(remaining[i]);

    // In a quadrilateral, the ear with the shorter diagonal is cut off. In larger polygons, it is
    // the first ear after the previous one, which avoids a fan of triangles in round polygons.
    std::size_t ear = n, most_convex = 0;
    double shortest = INFINITY;
    for(std::size_t k = 0; k < n; ++k)
    {
      const std::size_t i = (begin + k) % n;
      if(area(i) > area(most_convex))
        most_convex = i;
      const Planar_point &a = p[remaining[(i + n - 1) % n]], &b = p[remaining[i]],
                         &c = p[remaining[(i + 1) % n]];
      if(area(i) <= 0. || std::any_of(reflex.begin(), reflex.end(),
                                      [&](Index r) { return is_in_triangle(a, b, c, p[r]); }))
        continue;
      const double squared_diagonal = squared_distance(a, c);
      if(squared_diagonal < shortest)
      {
        shortest = squared_diagonal;
        ear = i;
      }
      if(n > 4)
        break;
    }
    if(ear == n)
      ear = most_convex;
    triangles.push_back({remaining[(ear + n - 1) % n], remaining[ear], remaining[(ear + 1) % n]});
    remaining.erase(remaining.begin() + static_cast<std::ptrdiff_t>(ear));
    begin = (ear + 1) % remaining.size();
  }
  triangles.push_back({remaining[0], remaining[1], remaining[2]});
  return triangles;
}

} // namespace

std::vector<std::array<Index, 3>>
triangulate_polygon(const std::vector<std::array<double, 3>>& corners)
{
  const std::vector<Planar_point> projected = project_to_plane(corners);
  if(!projected.empty())
    return clip_ears(projected);
  std::vector<Ear> triangles;
  for(Index k = 2; k < corners.size(); ++k)
    triangles.push_back({0, k - 1, k});
  return triangles;
}

} // namespace CGAL::Geodesic_processing::internal
