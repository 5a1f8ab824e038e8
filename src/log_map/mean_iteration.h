// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_MEAN_ITERATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_MEAN_ITERATION_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The common part of the Karcher means on meshes and on clouds. Their line searches differ. On a
// mesh, a step is a polar angle and a length, because the angles around a vertex do not sum up to
// 2 pi. On a cloud, it is a tangent vector, and a step must exceed the errors of the fit.

struct Unit_weights
{
  std::vector<double> values; // with sum one
  double sum;                 // of the given weights; infinity if it overflows
};

// Divides weights by their sum.
inline Unit_weights unit_weights(const std::vector<double>& weights)
{
  // The sum of large weights can overflow.
  const double max_weight = *std::max_element(weights.begin(), weights.end());
  double sum = 0.;
  for(const double weight : weights)
    sum += weight / max_weight;
  std::vector<double> values;
  for(const double weight : weights)
    values.push_back(weight / max_weight / sum);
  return {values, sum * max_weight};
}

// Returns the completed fraction of the iterations, for callbacks.
inline double completed_fraction(std::size_t number, std::size_t max_number)
{
  return std::min(1., double(number) / double(std::max<std::size_t>(1, max_number)));
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_MEAN_ITERATION_H
