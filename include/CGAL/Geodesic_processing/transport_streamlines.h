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
/// finds the lines along which masses are moved, once.  `Transport_solution::streamlines()` has those of a
/// solver's last query.
///
/// \tparam Method `Interior_point`, `Alternating_directions` or `Weiszfeld`
/// \tparam Surface as for `geodesic_distances()`
/// \param surface a mesh or a cloud
/// \param from, to masses, as `Earth_movers_solver` takes them
/// \param seeds a number of lines, a `std::size_t`: they stand for equal parts of all the mass; or a range of
///        sites or of locations from where lines are to go
/// \param out receives a `Streamline<Surface>` for each
/// \param np what `Earth_movers_solver`, its `compute()` and `Transport_solution::streamlines()` take
/// \throws as `Earth_movers_solver` and its `compute()`
///
/// On a mesh about as long again as `earth_movers_distance()`, and for each line O(number of faces passed).
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
