// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_WEIGHTS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_WEIGHTS_H

#include <CGAL/Geodesic_processing/internal/transport/Barycenter_solver.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns the weights given by a named parameter, by default ones. Throws Invalid_argument_error
// as check_weights() does.
template <typename NamedParameters>
std::vector<double> weights(const NamedParameters& np, std::size_t number)
{
  std::vector<double> result;
  if constexpr(has_parameter<NamedParameters, internal_np::weights_t>)
    for(const auto& weight : parameter(np, internal_np::weights, 0))
      result.push_back(to_double(weight));
  else
    result.assign(number, 1.);
  check_weights(result, number);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_WEIGHTS_H
