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

// Sharp creases of a mesh of 2^31 half-edges come to some hundred thousands; needles may come to more,
// and overflow.
constexpr double most_bent = 1e6;

// On a cloud each triangle counts as far as the surfels agree on it.
double weight(const Glued_triangles& t, Index triangle)
{
  return t.weight.empty() ? 1. : t.weight[triangle];
}

double doubled_area(const Glued_triangles& t, Index triangle)
{
  const double* const l = &t.length[3 * std::size_t(triangle)];
  return weight(t, triangle) * twice_area(l[0], l[1], l[2]);
}

template <typename Number>
std::vector<double> numbers_of(const std::shared_ptr<const Glued_triangles>& triangles,
                               double radius, unsigned threads, const Number& number)
{
  double area = 0.;
  for(Index f = 0; f < triangles->number_of_triangles(); ++f)
    area += 0.5 * doubled_area(*triangles, f);
  std::vector<double> result;
  for(const Curvature& here : curvatures(triangles, radius, threads))
    result.push_back(
        std::clamp(std::sqrt(area) * number(here.least, here.most), -most_bent, most_bent));
  return result;
}

} // namespace

std::vector<double> total_curvatures(const std::shared_ptr<const Glued_triangles>& triangles,
                                     double radius, unsigned threads)
{
  return numbers_of(triangles, radius, threads,
                    [](double least, double most) { return std::abs(least) + std::abs(most); });
}

std::vector<double> summed_curvatures(const std::shared_ptr<const Glued_triangles>& triangles,
                                      double radius, unsigned threads)
{
  return numbers_of(triangles, radius, threads,
                    [](double least, double most) { return least + most; });
}

std::vector<double> relative_gradients(const Glued_triangles& t,
                                       std::vector<std::vector<double>> channels)
{
  std::vector<double> result(t.number_of_sites(), 0.), area(result.size(), 0.);
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
    const Index* const site = &t.corner[3 * std::size_t(f)];
    // Twice the area times the gradient, turned by a right angle: each corner gives the side behind it.
    double square = 0.;
    for(const std::vector<double>& channel : channels)
    {
      const double origin = channel[site[0]];
      const Planar turned =
          (channel[site[1]] - origin) * (p[0] - p[2]) + (channel[site[2]] - origin) * (p[1] - p[0]);
      square += dot(turned, turned);
    }
    for(int k = 0; k < 3; ++k)
    {
      result[site[k]] += weight(t, f) * std::sqrt(square);
      area[site[k]] += doubled_area(t, f);
    }
  }
  double steepest = 0.;
  for(std::size_t site = 0; site < result.size(); ++site)
  {
    result[site] = area[site] > 0. ? result[site] / area[site] : 0.;
    steepest = std::max(steepest, result[site]);
  }
  if(steepest > 0.)
    for(double& x : result)
      x /= steepest;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
