// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_BARYCENTER_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_BARYCENTER_H

#include <CGAL/Geodesic_processing/Transport_barycenter_solver.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes the barycenter of mass distributions: the distribution with the minimum weighted sum
/// of squared earth mover's distances to the given ones.
///
/// If several barycenters on one surface are computed, use `Transport_barycenter_solver`, which
/// factorizes only once. See there for details.
///
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Masses a range of mass distributions
/// \tparam BarycenterMap a model of `WritablePropertyMap` with vertices or surfels as keys and
///         `double` as values
/// \param surface the surface on which masses move
/// \param masses a range of mass distributions as accepted by `Transport_barycenter_solver`
/// \param barycenter_map receives a `double` for each vertex or surfel: the mass of the barycenter
/// \param np named parameters of `Transport_barycenter_solver` and its `compute()`
/// \returns the cost of the barycenter with certified bounds
/// \throws as `Transport_barycenter_solver` and its `compute()`
///
/// The time is that of `Transport_barycenter_solver` and its `compute()`.
template <typename Surface, typename Masses, typename BarycenterMap,
          typename NamedParameters = internal::Default_parameters>
Transport_barycenter_cost transport_barycenter(const Surface& surface, const Masses& masses,
                                               BarycenterMap barycenter_map,
                                               const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  Transport_barycenter_solver<typename decltype(domain)::Surface> solver(domain, np);
  const Transport_barycenter_cost cost = solver.compute(masses, np);
  solver.write_masses(barycenter_map);
  return cost;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_TRANSPORT_BARYCENTER_H
