// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/curvature/speeds.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/curvature/curvature.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Bounds the absolute values. Sharp edges of a mesh of 2^31 halfedges yield some hundred thousands.
// Without the bound, needles overflow.
constexpr double max_curvature_bound = 1e6;

// Returns the weight of a triangle: 1 on a mesh; on a cloud the fraction of its corners' surfels
// that have it.
double weight(const Surface_arrays& t, Index triangle)
{
  return t.weight.empty() ? 1. : t.weight[triangle];
}

// Returns twice the weighted area of a triangle.
double doubled_area(const Surface_arrays& t, Index triangle)
{
  const double* const l = &t.length[3 * std::size_t(triangle)];
  return weight(t, triangle) * twice_area(l[0], l[1], l[2]);
}

// Returns sqrt(area) * function(min_curvature, max_curvature) of each vertex, bounded.
template <typename Function>
std::vector<double> map_curvatures(const std::shared_ptr<const Surface_arrays>& triangles,
                                   double radius, unsigned number_of_threads,
                                   const Function& function)
{
  double area = 0.;
  for(Index f = 0; f < triangles->number_of_triangles(); ++f)
    area += 0.5 * doubled_area(*triangles, f);
  std::vector<double> result;
  for(const Curvature& curvature : curvatures(triangles, radius, number_of_threads))
    result.push_back(
        std::clamp(std::sqrt(area) * function(curvature.min_curvature, curvature.max_curvature),
                   -max_curvature_bound, max_curvature_bound));
  return result;
}

} // namespace

std::vector<double> total_curvatures(const std::shared_ptr<const Surface_arrays>& triangles,
                                     double radius, unsigned number_of_threads)
{
  return map_curvatures(triangles, radius, number_of_threads,
                        [](double min_curvature, double max_curvature)
                        { return std::abs(min_curvature) + std::abs(max_curvature); });
}

std::vector<double> doubled_mean_curvatures(const std::shared_ptr<const Surface_arrays>& triangles,
                                            double radius, unsigned number_of_threads)
{
  return map_curvatures(triangles, radius, number_of_threads,
                        [](double min_curvature, double max_curvature)
                        { return min_curvature + max_curvature; });
}

std::vector<double> relative_gradient_norms(const Surface_arrays& t,
                                            std::vector<std::vector<double>> channels)
{
  std::vector<double> result(t.number_of_vertices(), 0.), area(result.size(), 0.);
  double largest = 0.;
  for(const std::vector<double>& channel : channels)
    for(const double x : channel)
    {
      if(!std::isfinite(x))
        throw Invalid_argument_error("A value of the image is not finite.");
      largest = std::max(largest, std::abs(x));
    }
  if(largest == 0.)
    return result;
  for(std::vector<double>& channel : channels)
    for(double& x : channel)
      x /= largest;

  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const auto p = unfolded(t, f);
    const Index* const v = &t.corner[3 * std::size_t(f)];
    // Twice the area times the gradient, rotated by a right angle: the sum over the corners of the
    // value times the opposite edge.
    double squared_norm = 0.;
    for(const std::vector<double>& channel : channels)
    {
      const double origin = channel[v[0]];
      const Vec2 rotated_gradient =
          (channel[v[1]] - origin) * (p[0] - p[2]) + (channel[v[2]] - origin) * (p[1] - p[0]);
      squared_norm += dot(rotated_gradient, rotated_gradient);
    }
    for(int k = 0; k < 3; ++k)
    {
      result[v[k]] += weight(t, f) * std::sqrt(squared_norm);
      area[v[k]] += doubled_area(t, f);
    }
  }
  double max_gradient = 0.;
  for(std::size_t v = 0; v < result.size(); ++v)
  {
    result[v] = area[v] > 0. ? result[v] / area[v] : 0.;
    max_gradient = std::max(max_gradient, result[v]);
  }
  if(max_gradient > 0.)
    for(double& x : result)
      x /= max_gradient;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
