// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Mass_distribution.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "transport/uniform_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Adds factor * source to target. An empty vector is zero.
void add(Vector& target, double factor, const Vector& source)
{
  if(source.size() == 0)
    return;
  if(target.size() == 0)
    target = Vector::Zero(source.size());
  target += factor * source;
}

void add(Mass_distribution& target, double factor, const Mass_distribution& source)
{
  add(target.at_vertices, factor, source.at_vertices);
  for(const auto& [location, mass] : source.at_locations)
    target.at_locations.emplace_back(location, factor * mass);
  add(target.density, factor, source.density);
}

// Two distributions are equal if their difference is at most this fraction of their masses. The
// round-off errors of sums over a million vertices are smaller.
constexpr double equality_tolerance = 1e-12;

} // namespace

Vector masses_at_vertices(const Surface_arrays& t, const std::vector<double>& area,
                          const Mass_distribution& masses)
{
  Vector result = Vector::Zero(Eigen::Index(t.number_of_vertices()));
  add(result, 1., masses.at_vertices);
  for(const auto& [location, mass] : masses.at_locations)
    if(location.triangle == none)
      result[location.vertex] += mass;
    else
      for(std::size_t k = 0; k < 3; ++k)
        result[t.corner[3 * location.triangle + k]] += mass * location.barycentric[k];
  if(masses.density.size() > 0)
    for(std::size_t f = 0; f < area.size(); ++f)
    {
      const Index* corner = &t.corner[3 * f];
      const double factor = t.scale * t.scale * area[f] / 12.;
      const Vector& density = masses.density;
      const double sum = density[corner[0]] + density[corner[1]] + density[corner[2]];
      for(std::size_t k = 0; k < 3; ++k)
        result[corner[k]] += factor * (sum + density[corner[k]]);
    }
  return result;
}

Mass_distribution refined(const Surface_arrays& coarse, const Surface_arrays& fine,
                          const Mass_distribution& masses)
{
  Mass_distribution result;
  if(masses.at_vertices.size() > 0)
  {
    result.at_vertices = Vector::Zero(Eigen::Index(fine.number_of_vertices()));
    result.at_vertices.head(masses.at_vertices.size()) = masses.at_vertices;
  }
  for(const auto& [location, mass] : masses.at_locations)
    result.at_locations.emplace_back(refined(location), mass);
  if(masses.density.size() > 0)
    result.density = refined(coarse, fine, masses.density);
  return result;
}

Mass_distribution difference(const Surface_arrays& triangles, const std::vector<double>& area,
                             const Mass_distribution& from, const Mass_distribution& to,
                             bool do_normalize)
{
  std::array<double, 2> total{}, size{}, factor = {1., 1.};
  const std::array<const Mass_distribution*, 2> distributions = {&from, &to};
  for(std::size_t i = 0; i < 2; ++i)
  {
    const Vector mass = masses_at_vertices(triangles, area, *distributions[i]);
    total[i] = mass.sum();
    size[i] = mass.lpNorm<1>();
    if(!std::isfinite(size[i]))
      throw Invalid_argument_error("A mass is not a finite number.");
    if(do_normalize && !(total[i] > 0.))
      throw Invalid_argument_error("A total mass of " + std::to_string(total[i]) +
                                   " cannot be scaled to one.");
    if(do_normalize)
      factor[i] = 1. / total[i];
  }
  if(!do_normalize && std::abs(total[1] - total[0]) > 1e-9 * std::max(size[0], size[1]))
    throw Invalid_argument_error(
        "The total masses before and after differ: " + std::to_string(total[0]) + " and " +
        std::to_string(total[1]) + ".");
  Mass_distribution result;
  add(result, factor[1], to);
  add(result, -factor[0], from);
  // Later checks of the total mass are relative to the difference.
  if(masses_at_vertices(triangles, area, result).lpNorm<1>() <=
     equality_tolerance * std::max(factor[0] * size[0], factor[1] * size[1]))
  {
    result = Mass_distribution();
    result.at_vertices = Vector::Zero(Eigen::Index(triangles.number_of_vertices()));
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
