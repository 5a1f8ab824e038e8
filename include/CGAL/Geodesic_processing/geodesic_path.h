// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_H

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes a path from a vertex, surfel or location to its nearest source.
///
/// Distances are computed by the method until the front has passed `from`.  The path is traced
/// along decreasing distances and then shortened to a geodesic.
///
/// On a mesh, the path is a shortest path by default, or if the method is `Exact`.  With other
/// methods, it is locally shortest: it is straight in every face, and both angles at every vertex
/// that it passes are at least \f$ \pi \f$.  Its length differs from
/// `Surface_path::front_distance` by at most the error of the method.  On a cloud, the path consists
/// of surfels.
///
/// \tparam Method as for `geodesic_distances()`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam QueryLocation a vertex, a surfel or a `Location<Surface>`
/// \tparam Sources as for `geodesic_distances()`
/// \param surface the surface, as for `geodesic_distances()`
/// \param from a vertex, a surfel or a location
/// \param to a vertex, a surfel, a location, a `Source`, or a non-empty range of one of these
/// \param np the named parameters of `geodesic_distances()`
/// \returns the path; empty if no source can be reached
/// \throws as `Geodesic_distance_solver::compute()`
///
/// Takes one distance computation that stops at `from`, and time proportional to the length of the
/// path.
template <typename Method = Automatic, typename Surface, typename QueryLocation, typename Sources,
          typename NamedParameters = internal::Default_parameters>
Surface_path<Surface_of<Surface>> geodesic_path(const Surface& surface, const QueryLocation& from,
                                                const Sources& to,
                                                const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  Geodesic_distance_solver<typename decltype(domain)::Surface, Method> solver(domain);
  solver.compute(to, internal::chain(np).targets(from));
  return solver.path(from);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_H
