// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Scanner.h"
#include "repair/repair.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace program {

namespace {

using Planar_point = std::array<double, 2>;

double signed_area(const Planar_point& a, const Planar_point& b, const Planar_point& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Projects a polygon to a coordinate plane and scales it to about unit size. Returns an empty
// array if the polygon spans no plane.
std::vector<Planar_point> project_to_plane(const std::vector<Point>& corners)
{
  const Point origin = corners[0];
  double size = 0.;
  std::vector<Point> p = corners;
  // Coordinates are halved, so that differences of huge values do not overflow.
  for(Point& x : p)
    for(std::size_t c = 0; c < 3; ++c)
    {
      x[c] = x[c] / 2. - origin[c] / 2.;
      size = std::max(size, std::abs(x[c]));
    }
  if(size == 0.)
    return {};
  for(Point& x : p)
    for(double& c : x)
      c /= size;

  // Newell's normal, which is correct for concave and nonplanar polygons.
  Point normal = {0., 0., 0.};
  for(std::size_t i = 0; i < p.size(); ++i)
  {
    const Point &a = p[i], &b = p[(i + 1) % p.size()];
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

using Triangle = std::array<std::size_t, 3>;

// Triangulates a polygon by ear clipping. Always returns n - 2 triangles. If there is no ear, as
// in a self-intersecting polygon, the most convex corner is cut off.
std::vector<Triangle> clip_ears(const std::vector<Planar_point>& p)
{
  std::vector<Triangle> triangles;
  std::vector<std::size_t> remaining(p.size());
  for(std::size_t i = 0; i < remaining.size(); ++i)
    remaining[i] = i;

  std::size_t begin = 0;
  while(remaining.size() > 3)
  {
    const std::size_t n = remaining.size();
    const auto area = [&](std::size_t i) {
      return signed_area(p[remaining[(i + n - 1) % n]], p[remaining[i]], p[remaining[(i + 1) % n]]);
    };
    std::vector<std::size_t> reflex;
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
                                      [&](std::size_t r) { return is_in_triangle(a, b, c, p[r]); }))
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

struct Triangle_hash
{
  std::size_t operator()(const std::array<std::uint32_t, 3>& triangle) const
  {
    std::uint64_t result = triangle[0];
    for(const std::uint32_t corner : {triangle[1], triangle[2]})
    {
      result = (result ^ (result >> 29)) * 0xbf58476d1ce4e5b9u + corner;
      result = (result ^ (result >> 32)) * 0x94d049bb133111ebu;
    }
    return static_cast<std::size_t>(result ^ (result >> 31));
  }
};

// Removes triangles with the same corners in the same cyclic order as an earlier one. Two
// triangles of opposite orientation are kept, because they may be a closed surface. Returns
// whether any was removed.
bool remove_duplicate_triangles(Surface_file& surface)
{
  std::unordered_set<std::array<std::uint32_t, 3>, Triangle_hash> seen;
  seen.reserve(surface.number_of_polygons());
  std::size_t number_kept = 0;
  for(std::size_t f = 0; f < surface.number_of_polygons(); ++f)
  {
    std::array<std::uint32_t, 3> triangle;
    std::copy_n(surface.corners.begin() + static_cast<std::ptrdiff_t>(3 * f), 3, triangle.begin());
    std::array<std::uint32_t, 3> rotated = triangle;
    std::rotate(rotated.begin(), std::min_element(rotated.begin(), rotated.end()), rotated.end());
    if(seen.insert(rotated).second)
      std::copy_n(triangle.begin(), 3,
                  surface.corners.begin() + static_cast<std::ptrdiff_t>(3 * number_kept++));
  }
  const bool changed = number_kept != surface.number_of_polygons();
  surface.corners.resize(3 * number_kept);
  surface.polygon_begin.resize(number_kept + 1);
  return changed;
}

} // namespace

bool triangulate(Surface_file& surface, const std::string& name)
{
  // The search for ears takes quadratic time: about one second for 10,000 corners.
  constexpr std::size_t max_corners = 10000;
  bool changed = false;
  std::vector<std::uint32_t> corners, face;
  corners.reserve(surface.corners.size());
  std::vector<Point> points;
  for(std::size_t f = 0; f < surface.number_of_polygons(); ++f)
  {
    face.assign(surface.corners.begin() + static_cast<std::ptrdiff_t>(surface.polygon_begin[f]),
                surface.corners.begin() +
                    static_cast<std::ptrdiff_t>(surface.polygon_begin[f + 1]));
    const std::size_t degree = face.size();
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while(face.size() > 1 && face.front() == face.back())
      face.pop_back();
    changed = changed || face.size() != 3 || degree != 3;
    if(face.size() < 3)
      continue;
    if(face.size() == 3)
    {
      corners.insert(corners.end(), face.begin(), face.end());
      continue;
    }
    if(face.size() > max_corners)
      fail(name, "face " + std::to_string(f) + " has " + std::to_string(face.size()) +
                     " vertices, but the maximum is 10,000");
    points.clear();
    for(const std::uint32_t corner : face)
      points.push_back(surface.points[corner]);
    const std::vector<Planar_point> projected = project_to_plane(points);
    std::vector<Triangle> triangles;
    if(!projected.empty())
      triangles = clip_ears(projected);
    else
      for(std::size_t k = 2; k < face.size(); ++k)
        triangles.push_back({0, k - 1, k});
    for(const Triangle& t : triangles)
      if(face[t[0]] != face[t[1]] && face[t[1]] != face[t[2]] && face[t[2]] != face[t[0]])
        corners.insert(corners.end(), {face[t[0]], face[t[1]], face[t[2]]});
  }
  surface.corners = std::move(corners);
  surface.polygon_begin.resize(surface.corners.size() / 3 + 1);
  for(std::size_t f = 0; f < surface.polygon_begin.size(); ++f)
    surface.polygon_begin[f] = 3 * f;
  const bool dropped = remove_duplicate_triangles(surface);
  return changed || dropped;
}

} // namespace program
