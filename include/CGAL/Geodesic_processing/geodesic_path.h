// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_H

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/Surfel_path_finder.h>

#include <type_traits>

namespace CGAL::Geodesic_processing {

namespace internal {

// Whether paths are those of the energy method: on clouds by default, unless there are speeds.
template <typename Surface, typename Method, typename NamedParameters>
inline constexpr bool uses_path_energy =
    Is_cloud<Surface>::value&& std::is_same_v<Method, Automatic> &&
    !has_parameter<NamedParameters, internal_np::speed_map_t>;

} // namespace internal

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes a path from a vertex, surfel or location to its nearest source.
///
/// Distances are computed by the method until the front has passed `from`. The path is traced
/// along decreasing distances and then shortened to a geodesic.
///
/// On a mesh, the path is a shortest path by default, or if the method is `Exact`. With other
/// methods, it is locally shortest: it is straight in every face, and both angles at every vertex
/// that it passes are at least \f$ \pi \f$.  Its length differs from
/// `Surface_path::front_distance` by at most the error of the method.
///
/// If speeds differ, `Surface_path::front_distance` is a travel time. On a mesh, the travel time
/// of the path is then reduced in the neighborhood of the traced path, instead of its length. It
/// is lower than `Surface_path::front_distance` as a rule. In measurements, it exceeds this value
/// by a few percent at most, or by up to 14 % if the speed differs from face to face. A segment on
/// an edge has the larger speed of the adjacent faces.
///
/// On a cloud, the path is that of `Surfel_path_finder` between `from` and the nearest location of
/// the nearest source. Only a front admits speeds. If there are speeds, or if the method is
/// given, the path is traced along the local triangles of the cloud and, if the speeds are equal,
/// shortened on them. `initial_path` is then empty. The same holds if only these triangles connect
/// `from` with a source.
///
/// \tparam Method as for `geodesic_distances()`, but not `Runtime_method`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam QueryLocation a vertex, a surfel or a `Location<Surface>`
/// \tparam Sources as for `geodesic_distances()`
/// \param surface the surface, as for `geodesic_distances()`
/// \param from a vertex, a surfel or a location
/// \param to a vertex, a surfel, a location, a `Source`, or a non-empty range of one of these
/// \param np the named parameters of `geodesic_distances()`; on a cloud also those of
///        `Surfel_path_finder`
/// \returns the path; empty if no source can be reached
/// \throws as `Geodesic_distance_solver::compute()`
///
/// Takes one distance computation that stops at `from`, and time proportional to the length of the
/// path. On a cloud of n surfels, also the preparation of `Surfel_path_finder` in O(n log n) time:
/// use this class or `Geodesic_path_finder` for more than one path.
template <typename Method = Automatic, typename Surface, typename QueryLocation, typename Sources,
          typename NamedParameters = internal::Default_parameters>
Geodesic_path<Surface_of<Surface>> geodesic_path(const Surface& surface, const QueryLocation& from,
                                                 const Sources& to,
                                                 const NamedParameters& np = NamedParameters())
{
  static_assert(!std::is_same_v<Method, Runtime_method>,
                "The method of geodesic_path() is a tag. Call Geodesic_distance_solver::path().");
  const auto domain = make_domain(surface, np);
  Geodesic_distance_solver<Surface_of<Surface>, Method> solver(domain, np);
  solver.compute(to, internal::chain(np).targets(from));
  Geodesic_path<Surface_of<Surface>> result;
  static_cast<Surface_path<Surface_of<Surface>>&>(result) = solver.path(from);
  if constexpr(internal::uses_path_energy<Surface_of<Surface>, Method, NamedParameters>)
    if(!result.empty())
    {
      Surfel_path_finder<Surface_of<Surface>> finder(domain, np);
      auto path = finder(from, result.locations.back());
      if(!path.empty())
        return path;
    }
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_H
