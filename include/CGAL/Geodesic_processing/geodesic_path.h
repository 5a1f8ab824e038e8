// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_H

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
///
/// finds a path from a place to its nearest source: distances by the method until the front has passed
/// the place, the path traced down them, then straightened to a geodesic.
///
/// On a mesh the result is locally shortest: straight in every face, with an angle of at least
/// \f$ \pi \f$ on both sides of every vertex that it touches.  With `Exact` it is the shortest of all; with the other methods
/// not always: its length is at least the distance, and differs from `Surface_path::front_distance` by at most
/// the error of the method.  On a cloud it runs through surfels.
///
/// \param surface as for `geodesic_distances()`
/// \param from a site or a location
/// \param to a site, a location, a `Source`, or a range of one of these, not empty
/// \param np what `geodesic_distances()` takes
/// \returns the path, empty when no source can be reached
/// \throws as `Geodesic_distance_solver::compute()`
template <typename Method = Euclidean_front, typename Surface, typename QueryLocation,
          typename Sources, typename NamedParameters = internal::Default_parameters>
auto geodesic_path(const Surface& surface, const QueryLocation& from, const Sources& to,
                   const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  Geodesic_distance_solver<typename decltype(domain)::Surface, Method> solver(domain);
  solver.compute(to, internal::chain(np).targets(from));
  return solver.path(from);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_H
