// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_VOLUMETRIC_DISTANCE_H
#define CGAL_GEODESIC_PROCESSING_VOLUMETRIC_DISTANCE_H

#include <CGAL/Geodesic_processing/Volumetric_metric.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes the distance between two points in space, inside or outside of a closed mesh. For many
/// queries, use a `Volumetric_metric`, which is precomputed only once.
///
/// \tparam Mesh a model of `FaceListGraph`, or its domain
/// \tparam From a `Point_3` of any kernel
/// \tparam To a `Point_3` of any kernel
/// \param mesh as for `Volumetric_metric`, or a domain of such a mesh
/// \param from, to `Point_3` of any kernel
/// \param np named parameters of `Volumetric_metric` and its `cost()`
/// \returns the cost with certified bounds
/// \throws as `Volumetric_metric` and its `cost()`
///
/// The time is that of `Volumetric_metric` and its `cost()`.
template <typename Mesh, typename From, typename To,
          typename NamedParameters = internal::Default_parameters>
Earth_movers_cost volumetric_distance(const Mesh& mesh, const From& from, const To& to,
                                      const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::volumetric_distance, Mesh>());
  const auto domain = make_domain(mesh, np);
  return Volumetric_metric<typename decltype(domain)::Surface>(domain, np).cost(from, to, np);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_VOLUMETRIC_DISTANCE_H
