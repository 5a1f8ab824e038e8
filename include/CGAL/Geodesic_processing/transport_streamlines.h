// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_STREAMLINES_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_STREAMLINES_H

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>

#include <cstddef>
#include <type_traits>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes the streamlines along which one mass distribution is transported to another. For the
/// streamlines of a solver's last query, use `Transport_solution::streamlines()`.
///
/// \tparam Method `Interior_point`, `Alternating_directions` or `Weiszfeld`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam From a mass distribution as accepted by `Earth_movers_solver`
/// \tparam To a mass distribution as accepted by `Earth_movers_solver`
/// \tparam Seeds an integer, or a range of vertices, surfels or locations
/// \tparam OutputIterator a model of `OutputIterator` for `Streamline<Surface>`
/// \param surface a mesh or a cloud
/// \param from, to mass distributions, as for `Earth_movers_solver`
/// \param seeds an integer or a range. An integer is the number of streamlines, each for an equal
///        fraction of the mass. A range contains the vertices, surfels or locations at which
///        streamlines begin.
/// \param out receives a `Streamline<Surface>` for each seed
/// \param np named parameters of `Earth_movers_solver`, its `compute()` and
///        `Transport_solution::streamlines()`
/// \returns the output iterator past the last streamline
/// \throws as `Earth_movers_solver` and its `compute()`
///
/// On a mesh this takes about twice as long as `earth_movers_distance()`, and O(number of crossed
/// faces) for each streamline.
template <typename Method = Interior_point, typename Surface, typename From, typename To,
          typename Seeds, typename OutputIterator,
          typename NamedParameters = internal::Default_parameters>
OutputIterator transport_streamlines(const Surface& surface, const From& from, const To& to,
                                     const Seeds& seeds, OutputIterator out,
                                     const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  Earth_movers_solver<typename decltype(domain)::Surface> solver(domain, np);
  solver.template compute<Method>(from, to, np);
  const auto trace = solver.streamlines(np);
  if constexpr(std::is_integral_v<Seeds>)
    return trace(std::size_t(seeds), out);
  else
  {
    for(const auto& seed : seeds)
      *out++ = trace(seed);
    return out;
  }
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_TRANSPORT_STREAMLINES_H
