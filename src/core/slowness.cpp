// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/core/slowness.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <cmath>

namespace CGAL::Geodesic_processing::internal {

std::vector<double> slowness_of(std::vector<double> speed)
{
  for(double& x : speed)
  {
    if(!std::isfinite(x) || x < 0.)
      throw Invalid_argument_error("A speed is negative or not finite.");
    x = 1. / x; // infinity for an obstacle
  }
  return speed;
}

std::vector<double> mean_over_corners(const Surface_arrays& triangles,
                                      const std::vector<double>& vertex_slowness)
{
  std::vector<double> result(triangles.number_of_triangles());
  for(std::size_t f = 0; f < result.size(); ++f)
    for(int k = 0; k < 3; ++k)
      result[f] += vertex_slowness[triangles.corner[3 * f + k]] / 3.;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
