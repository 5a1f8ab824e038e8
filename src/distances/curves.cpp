// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/curves.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Shortest_path_finder.h>

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Computes midpoints and paths, and reports the fraction of them that is done.
class Curve_subdivision
{
public:
  Curve_subdivision(const std::shared_ptr<const Surface_arrays>& triangles,
                    const std::function<bool(double)>& callback, double number_of_queries)
      : m_triangles(*triangles), m_finder(triangles), m_callback(callback),
        m_number_of_queries(number_of_queries)
  {}

  Surface_location midpoint(const Surface_location& p, const Surface_location& q)
  {
    return path_midpoint(m_triangles, path(p, q));
  }

  // Joins points by shortest paths.
  std::vector<Surface_location> joined(const std::vector<Surface_location>& points)
  {
    std::vector<Surface_location> result = {points.front()};
    for(std::size_t i = 1; i < points.size(); ++i)
    {
      const std::vector<Surface_location> part = path(points[i - 1], points[i]);
      for(auto location = part.begin() + 1; location < part.end(); ++location)
        if(!is_same_point(m_triangles, result.back(), *location))
          result.push_back(*location);
    }
    return result;
  }

private:
  std::vector<Surface_location> path(const Surface_location& p, const Surface_location& q)
  {
    if(m_callback)
      m_callback(std::min(1., m_number_done / m_number_of_queries));
    m_number_done += 1.;
    if(is_same_point(m_triangles, p, q))
      return {p};
    std::vector<Surface_location> result = m_finder.shortest_path(p, q).locations;
    if(result.empty())
      throw Invalid_argument_error("Two consecutive control points are not connected.");
    return result;
  }

  const Surface_arrays& m_triangles;
  Shortest_path_finder m_finder;
  const std::function<bool(double)>& m_callback;
  double m_number_of_queries, m_number_done = 0.;
};

// Checks the control points, and returns their canonical locations.
std::vector<Surface_location> checked_control_points(const Surface_arrays& triangles,
                                                     const std::vector<Surface_location>& points,
                                                     const Curve_options& options)
{
  if(points.size() < 2)
    throw Invalid_argument_error("A curve has fewer than two control points.");
  // A curve of a million segments takes minutes.
  if(options.number_of_subdivisions > 20)
    throw Invalid_argument_error("The number of subdivisions is above 20.");
  std::vector<Surface_location> result;
  for(const Surface_location& point : points)
    result.push_back(canonical(triangles, point));
  return result;
}

} // namespace

Surface_location path_midpoint(const Surface_arrays& triangles,
                               const std::vector<Surface_location>& path)
{
  double remaining = 0.5 * path_length(triangles, path);
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const double length = path_length(triangles, {path[i], path[i + 1]});
    if(length > 0. && remaining <= length)
    {
      const double fraction = remaining / length;
      Surface_location result;
      result.triangle = common_triangle(triangles, path[i], path[i + 1]);
      const auto p = *barycentric_in(triangles, result.triangle, path[i]),
                 q = *barycentric_in(triangles, result.triangle, path[i + 1]);
      for(const int corner : {0, 1, 2})
        result.barycentric[corner] = (1. - fraction) * p[corner] + fraction * q[corner];
      return canonical(triangles, result);
    }
    remaining -= length;
  }
  return path.back();
}

std::vector<Surface_location> bezier_curve(const std::shared_ptr<const Surface_arrays>& triangles,
                                           const std::vector<Surface_location>& control_points,
                                           const Curve_options& options)
{
  // The control points of all segments. Consecutive segments share one.
  std::vector<Surface_location> points =
      checked_control_points(*triangles, control_points, options);
  const std::size_t degree = points.size() - 1;
  const double number_of_segments = double(std::size_t(1) << options.number_of_subdivisions);
  Curve_subdivision curve(triangles, options.callback,
                          number_of_segments * (1. + 0.5 * double(degree * (degree + 1))));
  for(unsigned k = 0; k < options.number_of_subdivisions; ++k)
  {
    std::vector<Surface_location> subdivided(2 * (points.size() - 1) + 1);
    for(std::size_t begin = 0; begin + 1 < points.size(); begin += degree)
    {
      // The points of de Casteljau's triangle on its left and on its right side are the control
      // points of the halves.
      std::vector<Surface_location> row(points.begin() + std::ptrdiff_t(begin),
                                        points.begin() + std::ptrdiff_t(begin + degree + 1));
      for(std::size_t i = 0;; ++i)
      {
        subdivided[2 * begin + i] = row.front();
        subdivided[2 * begin + 2 * degree - i] = row.back();
        if(i == degree)
          break;
        for(std::size_t j = 0; j + 1 < row.size(); ++j)
          row[j] = curve.midpoint(row[j], row[j + 1]);
        row.pop_back();
      }
    }
    points = std::move(subdivided);
  }
  std::vector<Surface_location> ends;
  for(std::size_t i = 0; i < points.size(); i += degree)
    ends.push_back(points[i]);
  return curve.joined(ends);
}

std::vector<Surface_location> b_spline(const std::shared_ptr<const Surface_arrays>& triangles,
                                       const std::vector<Surface_location>& control_points,
                                       unsigned degree, bool is_closed,
                                       const Curve_options& options)
{
  std::vector<Surface_location> points =
      checked_control_points(*triangles, control_points, options);
  if(degree == 0)
    throw Invalid_argument_error("The degree of a spline is zero.");
  if(!is_closed)
  {
    const Surface_location first = points.front(), last = points.back();
    points.insert(points.begin(), degree - 1, first);
    points.insert(points.end(), degree - 1, last);
  }
  const double number_of_segments =
      double(points.size()) * double(std::size_t(1) << options.number_of_subdivisions);
  Curve_subdivision curve(triangles, options.callback, number_of_segments * (degree + 1.));
  for(unsigned k = 0; k < options.number_of_subdivisions; ++k)
  {
    std::vector<Surface_location> doubled;
    for(const Surface_location& point : points)
      doubled.insert(doubled.end(), 2, point);
    points = std::move(doubled);
    for(unsigned i = 0; i < degree; ++i)
    {
      const Surface_location first = points.front();
      for(std::size_t j = 0; j + 1 < points.size(); ++j)
        points[j] = curve.midpoint(points[j], points[j + 1]);
      if(is_closed)
        points.back() = curve.midpoint(points.back(), first);
      else
        points.pop_back();
    }
  }
  if(is_closed)
    points.push_back(points.front());
  return curve.joined(points);
}

} // namespace CGAL::Geodesic_processing::internal
