// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ISOVALUES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ISOVALUES_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/paths/isolines.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <vector>

// The input that isolines() and split_at_isolines() have in common.

namespace CGAL::Geodesic_processing::internal {

// Returns the values of the vertices of a domain, in the order of its arrays.
template <typename Domain, typename ValueMap>
std::vector<double> function_values(const Domain& domain, const ValueMap& value_map)
{
  std::vector<double> values(domain.number_of_vertices());
  for(Index v = 0; v < values.size(); ++v)
    values[v] = CGAL::to_double(get(value_map, domain.vertex(v)));
  return values;
}

// Throws Invalid_argument_error if an isovalue is infinite or not a number.
template <typename Isovalues>
std::vector<double> checked_isovalues(const Isovalues& isovalues)
{
  std::vector<double> levels;
  for(const auto& isovalue : isovalues)
  {
    levels.push_back(CGAL::to_double(isovalue));
    if(!std::isfinite(levels.back()))
      throw Invalid_argument_error("An isovalue is not finite.");
  }
  return levels;
}

template <typename NamedParameters>
Edge_interpolation edge_interpolation(const NamedParameters& np)
{
  return parameter(np, internal_np::do_fit_circles, false) ? Edge_interpolation::circular
                                                           : Edge_interpolation::linear;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ISOVALUES_H
