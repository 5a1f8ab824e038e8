// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Curve_embedding.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Barycentric = std::array<double, 3>;

// Returns the area of a subtriangle, relative to its parent.
double area_fraction(const std::array<Barycentric, 3>& corner)
{
  const auto& [a, b, c] = corner;
  return std::abs((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]));
}

} // namespace

Surface_location Curve_embedding::refined(const Surface_location& location) const
{
  if(location.triangle == none)
    return location;
  const auto begin = m_subtriangles_begin.find(location.triangle);
  if(begin == m_subtriangles_begin.end())
    return location;
  // Round-off errors can move the point out of all subtriangles. Hence the subtriangle with the
  // largest minimum coordinate is used.
  Surface_location result;
  double best_minimum = -infinity;
  const auto& b = location.barycentric;
  for(std::size_t i = begin->second;
      i < m_subtriangles.size() && m_subtriangles[i].parent == location.triangle; ++i)
  {
    const double fraction = area_fraction(m_subtriangles[i].corner);
    if(!(fraction > 0.))
      continue;
    Barycentric coordinates;
    const auto& corner = m_subtriangles[i].corner;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Barycentric &next = corner[(k + 1) % 3], &last = corner[(k + 2) % 3];
      coordinates[k] =
          ((next[1] - b[1]) * (last[2] - b[2]) - (next[2] - b[2]) * (last[1] - b[1])) / fraction;
    }
    const double minimum = std::min({coordinates[0], coordinates[1], coordinates[2]});
    if(minimum > best_minimum)
    {
      best_minimum = minimum;
      result.triangle = m_subtriangles[i].triangle;
      result.barycentric = coordinates;
    }
  }
  return canonical(*m_fine, result);
}

Vector Curve_embedding::refined(const Vector& function) const
{
  if(function.size() == 0)
    return function;
  Vector result(Eigen::Index(m_fine->number_of_vertices()));
  result.head(function.size()) = function;
  Eigen::Index vertex = function.size();
  for(const Surface_location& location : m_new_locations)
  {
    result[vertex] = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      result[vertex] += location.barycentric[k] *
                        function[m_coarse->corner[3 * std::size_t(location.triangle) + k]];
    ++vertex;
  }
  return result;
}

Mass_distribution Curve_embedding::refined(const Mass_distribution& masses) const
{
  Mass_distribution result;
  if(masses.at_vertices.size() > 0)
  {
    result.at_vertices = Vector::Zero(Eigen::Index(m_fine->number_of_vertices()));
    result.at_vertices.head(masses.at_vertices.size()) = masses.at_vertices;
  }
  for(const auto& [location, mass] : masses.at_locations)
    result.at_locations.emplace_back(refined(location), mass);
  result.density = refined(masses.density);
  return result;
}

std::vector<Metric_tensor> Curve_embedding::refined(const std::vector<Metric_tensor>& metric) const
{
  std::vector<Metric_tensor> result = metric;
  if(metric.empty())
    return result;
  result.resize(m_fine->number_of_triangles());
  for(const Subtriangle& subtriangle : m_subtriangles)
  {
    const Metric_tensor& parent_metric = metric[subtriangle.parent];
    const Vec2 u = product(parent_metric, subtriangle.axis),
               rotated_axis = rotated_left(subtriangle.axis);
    result[subtriangle.triangle] =
        is_blocked(parent_metric)
            ? parent_metric
            : Metric_tensor{dot(subtriangle.axis, u), dot(rotated_axis, u),
                            dot(rotated_axis, product(parent_metric, rotated_axis))};
  }
  return result;
}

Field Curve_embedding::coarsened(const Field& fine) const
{
  Field result(fine.begin(), fine.begin() + std::ptrdiff_t(m_coarse->number_of_triangles()));
  for(const auto& [parent, begin] : m_subtriangles_begin)
    result[parent] = {0., 0.};
  for(const Subtriangle& subtriangle : m_subtriangles)
  {
    const Vec2& v = fine[subtriangle.triangle];
    result[subtriangle.parent] =
        result[subtriangle.parent] +
        area_fraction(subtriangle.corner) *
            (v[0] * subtriangle.axis + v[1] * rotated_left(subtriangle.axis));
  }
  return result;
}

Vector Curve_embedding::coarsened(const Vector& masses) const
{
  Vector result = masses.head(masses.size() - Eigen::Index(m_new_locations.size()));
  Eigen::Index vertex = result.size();
  for(const Surface_location& location : m_new_locations)
  {
    for(std::size_t k = 0; k < 3; ++k)
      result[m_coarse->corner[3 * std::size_t(location.triangle) + k]] +=
          location.barycentric[k] * masses[vertex];
    ++vertex;
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
