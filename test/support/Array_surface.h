// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_ARRAY_SURFACE_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_ARRAY_SURFACE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include "triangulations.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::test {

using internal::dot;
using internal::infinity;

// The arrays of a triangulation, with results in the indices and the unit of the triangulation.
class Array_surface
{
public:
  explicit Array_surface(const Triangulation& surface)
      : m_surface(surface), m_arrays(arrays_of(surface)),
        m_triangles(std::make_shared<const Surface_arrays>(m_arrays.arrays))
  {}

  const std::shared_ptr<const Surface_arrays>& triangles() const { return m_triangles; }
  const Surface_arrays& t() const { return *m_triangles; }
  const Mesh_arrays& mesh_arrays() const { return m_arrays; }
  double scale() const { return m_triangles->scale; }
  Index size() const { return Index(m_surface.points.size()); }
  const Point& point(Index i) const { return m_surface.points[i]; }
  Index vertex(Index i) const { return m_arrays.internal_vertex[i]; }
  Index caller_vertex(Index i) const { return m_arrays.caller_vertex[i]; }
  Index triangle(Index face) const { return m_arrays.triangle_of_face[face]; }

  Surface_location at(Index i) const { return {none, vertex(i), {}}; }
  Surface_location in(Index face, const std::array<double, 3>& barycentric) const
  {
    return {triangle(face), none, barycentric};
  }
  // Returns the location at a fraction of edge k of a face.
  Surface_location on(Index face, int k, double fraction) const
  {
    std::array<double, 3> barycentric = {0., 0., 0.};
    barycentric[k] = 1. - fraction;
    barycentric[(k + 1) % 3] = fraction;
    return in(face, barycentric);
  }

  // Returns the path along edges between points.
  std::vector<Surface_location> along(const std::vector<Index>& points) const
  {
    std::vector<Surface_location> path;
    for(const Index i : points)
      path.push_back(at(i));
    return path;
  }

  internal::Front_source source(const Surface_location& location, double offset = 0.,
                                Index label = 0) const
  {
    return {{location}, offset / scale(), label};
  }
  internal::Front_source source(Index i, double offset = 0., Index label = 0) const
  {
    return source(at(i), offset, label);
  }
  // Returns a polyline source along edges between points.
  internal::Front_source line(const std::vector<Index>& points, double offset = 0.) const
  {
    return {along(points), offset / scale(), 0};
  }

  // Returns the distance of each point.
  template <typename Engine>
  std::vector<double> distances(const Engine& engine) const
  {
    std::vector<double> result(size());
    for(Index i = 0; i < size(); ++i)
      result[i] = scale() * engine.distance(vertex(i));
    return result;
  }

private:
  Triangulation m_surface;
  Mesh_arrays m_arrays;
  std::shared_ptr<const Surface_arrays> m_triangles;
};

// Returns farthest point samples.
inline std::vector<Surface_location>
farthest_points(const std::shared_ptr<const Surface_arrays>& triangles, std::size_t number)
{
  using namespace internal;
  Sampling sampling(triangles, Front(triangles, Front_kind::euclidean), Sample_location::triangle);
  Sampling_options options;
  options.number_of_samples = number;
  sample_farthest_points(sampling, options, [](double) {});
  return sampling.samples();
}

// Returns the maximum of |value(i) - truth(i)| over all points; infinity if only one of them is
// infinite or one is not a number.
template <typename Truth>
double largest_error(const std::vector<double>& value, const Truth& truth)
{
  double result = 0.;
  for(Index i = 0; i < value.size(); ++i)
  {
    const double expected = truth(i);
    if(value[i] == expected)
      continue;
    const double error = std::abs(value[i] - expected);
    result = error <= result ? result : error; // propagates NaN
    if(std::isnan(error))
      return infinity;
  }
  return result;
}

// Returns the mean of |value / truth - 1| over the points whose truth is at least `min_truth`.
template <typename Truth>
double mean_relative_error(const std::vector<double>& value, double min_truth, const Truth& truth)
{
  double sum = 0.;
  std::size_t count = 0;
  for(Index i = 0; i < value.size(); ++i)
    if(truth(i) >= min_truth)
    {
      sum += std::abs(value[i] / truth(i) - 1.);
      ++count;
    }
  return sum / double(count);
}

// Computes the distance along a great circle of the unit sphere.
inline double great_circle(const Point& p, const Point& q)
{
  return 2. * std::asin(std::min(1., 0.5 * distance(p, q)));
}

// Computes the distance to a segment.
inline double distance_to_segment(const Point& p, const Point& a, const Point& b)
{
  const Point ab = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const Point ap = {p[0] - a[0], p[1] - a[1], p[2] - a[2]};
  const double fraction = std::clamp(dot(ap, ab) / dot(ab, ab), 0., 1.);
  return distance(p, {a[0] + fraction * ab[0], a[1] + fraction * ab[1], a[2] + fraction * ab[2]});
}

// Computes the distance on a cone or saddle made by cone(), from radius a to radius b, between
// directions at the angles `angle` and total - `angle`.
inline double distance_on_cone(double a, double b, double angle, double total)
{
  angle = std::min(angle, total - angle);
  return angle < pi ? std::sqrt(std::max(0., a * a + b * b - 2. * a * b * std::cos(angle))) : a + b;
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_ARRAY_SURFACE_H
