// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_ROUGH_SURFACES_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_ROUGH_SURFACES_H

#include "triangulations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Generated surfaces with the difficulties of scans and CAD models: noise, obtuse triangles, saddle
// vertices, thin parts and needles.

namespace CGAL::Geodesic_processing::test {

// A body with a head and four legs, and noise. Of the vertices, 60 % are saddles; of the triangles,
// 16 % are obtuse.
inline Triangulation animal(unsigned level = 4)
{
  // Directions of the head and the legs, and their lengths.
  const std::array<std::pair<Point, double>, 5> limbs = {{{{0.8, 0., 0.6}, 0.7},
                                                          {{0.64, 0.48, -0.6}, 1.},
                                                          {{0.64, -0.48, -0.6}, 1.},
                                                          {{-0.64, 0.48, -0.6}, 1.},
                                                          {{-0.64, -0.48, -0.6}, 1.}}};
  Triangulation result = icosphere(level);
  for(Point& p : result.points)
  {
    double radius = 1.;
    for(const auto& [direction, length] : limbs)
      radius +=
          length *
          std::exp(25. * (p[0] * direction[0] + p[1] * direction[1] + p[2] * direction[2] - 1.));
    p = {1.5 * radius * p[0], radius * p[1], radius * p[2]};
  }
  return jittered(std::move(result), 0.15 / double(1u << level));
}

// A long shaft with two thick open ends, and noise. Of the triangles, 25 % are obtuse, with angles
// between 1 and 176 degrees.
inline Triangulation bone()
{
  return jittered(rings(
                      40, 60, [](double s) { return 0.3 + 0.3 * std::pow(2. * s - 1., 4); },
                      [](double s) { return 4. * s; }),
                  0.02);
}

// A tube around a trefoil knot, with n vertices along the knot and m around it, and noise. With
// 200 x 16 vertices, 95 % of the triangles are obtuse.
inline Triangulation knot(std::size_t n, std::size_t m)
{
  Triangulation result = torus(Index(n), Index(m));
  for(std::size_t i = 0; i < n; ++i)
  {
    // The knot lies on a torus with radii 2 and 1.
    const double t = 2. * pi * double(i) / double(n), r = 2. + std::cos(3. * t);
    const auto on_torus = [&](double x, double y, double z) // radial, tangential, axial
    {
      return Point{x * std::cos(2. * t) - y * std::sin(2. * t),
                   x * std::sin(2. * t) + y * std::cos(2. * t), z};
    };
    const double length = std::hypot(3., 2. * r);
    const Point center = on_torus(r, 0., std::sin(3. * t)),
                normal = on_torus(std::cos(3. * t), 0., std::sin(3. * t)),
                side = on_torus(-2. * r * std::sin(3. * t) / length, -3. / length,
                                2. * r * std::cos(3. * t) / length);
    for(std::size_t j = 0; j < m; ++j)
    {
      const double angle = 2. * pi * double(j) / double(m);
      Point& p = result.points[i + n * j];
      for(int k = 0; k < 3; ++k)
        p[k] = center[k] + 0.35 * (std::cos(angle) * normal[k] + std::sin(angle) * side[k]);
    }
  }
  return jittered(std::move(result), 0.01);
}

// A spool with a bore, with n vertices around the axis: sharp edges and needles. With 60 vertices
// the smallest angle is 0.7 degrees.
inline Triangulation spool(std::size_t n)
{
  // Radius and height, counterclockwise.
  const std::vector<std::array<double, 2>> profile = {
      {0.25, -1.}, {1., -1.}, {1., -0.7}, {0.5, -0.6}, {0.5, 0.6}, {1., 0.7}, {1., 1.}, {0.25, 1.}};
  Triangulation result = torus(Index(n), Index(profile.size()));
  for(std::size_t v = 0; v < result.points.size(); ++v)
  {
    const double angle = 2. * pi * double(v % n) / double(n);
    const auto [radius, height] = profile[v / n];
    result.points[v] = {radius * std::cos(angle), radius * std::sin(angle), height};
  }
  return result;
}

// A sheet that is rolled up by three quarters of a turn, with small triangles in the middle and
// with angles up to 173 degrees.
inline Triangulation rolled_sheet()
{
  const auto graded = [](double s) { return 0.5 + 4. * (s - 0.5) * (s - 0.5) * (s - 0.5); };
  return grid(
      60, 40,
      [=](double s, double t)
      {
        const double angle = 1.5 * pi * (0.9 * graded(s) + 0.1 * s);
        return Point{std::cos(angle), std::sin(angle), 3. * (0.9 * graded(t) + 0.1 * t)};
      },
      0.2);
}

// A patch of a plane with three peaks, and jitter. Its total curvature is 11 pi.
inline Triangulation three_peaks()
{
  return grid(
      44, 44,
      [](double s, double t)
      {
        const double x = 20. * s - 10., y = 20. * t - 10.;
        double height = 0.;
        for(const auto& [px, py] : {std::pair(-4., -3.), std::pair(4.5, -2.5), std::pair(0., 4.5)})
          height += 15. * std::exp(-0.15 * ((x - px) * (x - px) + (y - py) * (y - py)));
        return Point{x, y, height};
      },
      0.2);
}

// A cap on a stem that stands on a plate, with a small hole in the center. Its total curvature is
// 7 pi.
inline Triangulation mushroom()
{
  // Radius and height, from the boundary of the plate to the hole.
  const std::vector<std::array<double, 2>> profile = {{1., 0.},     {0.5, 0.},   {0.35, 0.1},
                                                      {0.3, 0.35},  {0.4, 0.42}, {0.42, 0.5},
                                                      {0.35, 0.62}, {0.2, 0.7},  {0.02, 0.75}};
  const auto coordinate = [&](double s, int k)
  {
    const double position = s * double(profile.size() - 1);
    const std::size_t i = std::min(std::size_t(position), profile.size() - 2);
    const double fraction = position - double(i);
    return (1. - fraction) * profile[i][k] + fraction * profile[i + 1][k];
  };
  return rings(
      40, 56, [&](double s) { return coordinate(s, 0); },
      [&](double s) { return coordinate(s, 1); });
}

// Returns the triangles whose corners satisfy `keep`, without isolated vertices.
template <typename Keep>
Triangulation part_of(const Triangulation& surface, const Keep& keep)
{
  Triangulation result;
  std::vector<Index> number(surface.points.size(), none);
  for(std::size_t c = 0; c < surface.corners.size(); c += 3)
  {
    const auto is_kept = [&](std::size_t i) { return keep(surface.points[surface.corners[i]]); };
    if(!is_kept(c) || !is_kept(c + 1) || !is_kept(c + 2))
      continue;
    for(const Index corner : {surface.corners[c], surface.corners[c + 1], surface.corners[c + 2]})
    {
      if(number[corner] == none)
      {
        number[corner] = Index(result.points.size());
        result.points.push_back(surface.points[corner]);
      }
      result.corners.push_back(number[corner]);
    }
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_ROUGH_SURFACES_H
