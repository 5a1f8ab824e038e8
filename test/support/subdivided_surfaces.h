// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_SUBDIVIDED_SURFACES_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_SUBDIVIDED_SURFACES_H

#include <CGAL/Geodesic_processing/internal/subdivision/subdivision.h>

#include "triangulations.h"

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

// Triangulations with 1-to-4 subdivision, and values at their vertices.

namespace CGAL::Geodesic_processing::test {

inline std::vector<internal::Triangle> triangles_of(const Triangulation& surface)
{
  std::vector<internal::Triangle> result;
  for(std::size_t c = 0; c < surface.corners.size(); c += 3)
    result.push_back({surface.corners[c], surface.corners[c + 1], surface.corners[c + 2]});
  return result;
}

inline internal::Subdivision subdivided(const Triangulation& surface, unsigned times)
{
  return internal::subdivide(triangles_of(surface), Index(surface.points.size()), times);
}

// Returns the points of a subdivision: each new vertex is the image of the midpoint of its parents.
inline std::vector<Point> subdivided_points(const internal::Subdivision& subdivision,
                                            const std::vector<Point>& base,
                                            const std::function<Point(const Point&)>& map_point)
{
  std::vector<Point> result;
  for(const Point& p : base)
    result.push_back(map_point(p));
  for(std::size_t v = base.size(); v < subdivision.number_of_vertices(); ++v)
  {
    const Point &a = result[subdivision.parents[v][0]], &b = result[subdivision.parents[v][1]];
    result.push_back(map_point({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])}));
  }
  return result;
}

inline Point identity(const Point& p) { return p; }

// Projects a point to a sphere with smooth bumps.
inline Point onto_bumpy_sphere(const Point& p)
{
  const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  const double x = p[0] / length, y = p[1] / length, z = p[2] / length;
  const double r = 1. + 0.2 * std::sin(4. * x) * std::cos(3. * y + z);
  return {r * x, r * y, r * z};
}

inline std::vector<double> flattened(const std::vector<Point>& points)
{
  std::vector<double> result;
  for(const Point& p : points)
    result.insert(result.end(), p.begin(), p.end());
  return result;
}

// Returns the finest level of a subdivision as a triangulation.
inline Triangulation finest(const Triangulation& surface, unsigned times,
                            const std::function<Point(const Point&)>& map_point = identity)
{
  const internal::Subdivision s = subdivided(surface, times);
  Triangulation result;
  result.points = subdivided_points(s, surface.points, map_point);
  for(const internal::Triangle& t : s.finest().triangles)
    result.corners.insert(result.corners.end(), t.begin(), t.end());
  return result;
}

// Returns the root mean square distance of two sequences of points, with three numbers per point.
inline double root_mean_square(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.;
  for(std::size_t i = 0; i < a.size(); ++i)
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(3. * sum / double(a.size()));
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_SUBDIVIDED_SURFACES_H
