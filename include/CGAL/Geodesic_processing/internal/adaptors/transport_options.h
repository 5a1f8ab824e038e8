// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_TRANSPORT_OPTIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_TRANSPORT_OPTIONS_H

#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/adaptors/field_vectors.h>
#include <CGAL/Geodesic_processing/internal/transport/Multilevel_transport_solver.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <optional>

namespace CGAL::Geodesic_processing::internal {

// Reads `tolerance`, `maximum_number_of_iterations`, `callback` and `do_bound_from_above`. The
// other options keep their defaults.
template <typename NamedParameters>
Transport_options transport_options(const NamedParameters& np)
{
  Transport_options result;
  result.tolerance = parameter(np, internal_np::tolerance, result.tolerance);
  result.maximum_iterations = parameter(np, internal_np::maximum_number_of_iterations, 0u);
  result.callback = read_throwing_callback(np);
  result.do_bound_from_above = parameter(np, internal_np::do_bound_from_above, false);
  return result;
}

// Reads `number_of_refinements`. The default, also for an empty optional, depends on the number of
// vertices.
template <typename Domain, typename NamedParameters>
unsigned number_of_refinements(const Domain& domain, const NamedParameters& np)
{
  const std::optional<unsigned> result =
      parameter(np, internal_np::number_of_refinements, std::optional<unsigned>());
  return result ? *result : default_number_of_refinements(*domain.triangles());
}

// Writes potential and flow of a result to `potential_map` and `flow_map`, if these are set.
template <typename Domain, typename NamedParameters>
void write_transport_maps(const Domain& domain, const Transport_result& result,
                          const NamedParameters& np)
{
  if constexpr(has_parameter<NamedParameters, internal_np::potential_map_t>)
    domain.write([&](Index i) { return result.potential[i]; },
                 parameter(np, internal_np::potential_map, 0));
  if constexpr(has_parameter<NamedParameters, internal_np::flow_map_t>)
    write_vectors(domain, result.flow, parameter(np, internal_np::flow_map, 0));
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_TRANSPORT_OPTIONS_H
