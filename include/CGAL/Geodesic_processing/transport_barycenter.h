// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_BARYCENTER_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_BARYCENTER_H

#include <CGAL/Geodesic_processing/Transport_barycenter_solver.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// finds the barycenter of masses: those masses from which the weighted sum of squared earth mover's
/// distances to given ones is the least.  `Transport_barycenter_solver` says more, and is prepared only
/// once for many masses.
///
/// \tparam Surface as for `geodesic_distances()`
/// \param surface along which masses move
/// \param masses a range, as `Transport_barycenter_solver` takes them
/// \param barycenter_map receives a `double` for each site: the barycenter's mass there
/// \param np what `Transport_barycenter_solver` and its `compute()` take
/// \throws as `Transport_barycenter_solver` and its `compute()`
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
