// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_STRAIGHTEST_GEODESIC_H
#define CGAL_GEODESIC_PROCESSING_STRAIGHTEST_GEODESIC_H

#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/adaptors/trace_on_cloud.h>
#include <CGAL/Geodesic_processing/internal/paths/trace_straightest.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
/// A straightest geodesic, and whether it reached the boundary before it had the requested length.
template <typename Surface>
struct Straightest_geodesic : Surface_path<Surface>
{
  bool is_cut_by_boundary = false; ///< whether it ends at the boundary, shorter than requested
};

namespace internal {

template <typename Domain>
Straightest_geodesic<typename Domain::Surface>
straightest_on_mesh(const Domain& domain, const Surface_location& from, const Vec3& direction,
                    double length)
{
  const Surface_arrays& t = *domain.triangles();
  const Straightest_path path = trace_straightest_in_space(t, from, direction, length / t.scale);
  if(path.end == Straightest_path_end::degenerate)
    throw Unsupported_surface_error("The straightest geodesic crosses too many thin triangles.");
  Straightest_geodesic<typename Domain::Surface> result{
      surface_path(domain, path.locations, t.scale * path.length)};
  result.length = t.scale * path.length;
  result.is_cut_by_boundary = path.end == Straightest_path_end::boundary;
  return result;
}

template <typename Domain>
Straightest_geodesic<typename Domain::Surface> outer_path(const Domain& domain,
                                                          const Traced_path& path)
{
  Straightest_geodesic<typename Domain::Surface> result;
  for(const Tangent_location& location : path.locations)
    result.locations.push_back(outer_location(domain, location));
  double max_coordinate = 0.;
  for(const Vec3& p : path.points)
  {
    result.points.emplace_back(p[0], p[1], p[2]);
    for(const double coordinate : p)
      max_coordinate = (std::max)(max_coordinate, std::abs(coordinate));
  }
  result.length = result.front_distance = path.length;
  // The coordinates are rounded.
  const double round_off = 16. * std::numeric_limits<double>::epsilon() * max_coordinate;
  result.lower = (std::max)(0., norm(path.points.back() - path.points.front()) - round_off);
  result.is_cut_by_boundary = path.is_cut_by_boundary;
  return result;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingPaths
///
/// Traces the straightest geodesic from a location in a direction. Its endpoint is the exponential
/// map.
///
/// On a mesh, faces are unfolded one after the other. If the path hits a vertex, it continues with
/// equal angles on both sides. \cgalCite{cgal:ps-sgps-98}  If it reaches a boundary edge, or a
/// boundary vertex that it cannot pass, it ends there.
///
/// On a cloud, the path is a geodesic of the surface that `Surfel_path_finder` fits to the surfels
/// by default: the acceleration is normal to the surface. If noise is found, it is removed. Sharp
/// edges are unfolded. The path starts at the projection of `from` to the surface. The surface
/// ends at most 1.5 radii beyond the last surfel; there the path is cut. It also ends in front of
/// holes. Its points satisfy the bound on the distance to the nearest surfel that
/// `Surfel_path_finder` states. Each location is the projection of its point to the tangent plane
/// of the nearest surfel.
///
/// \tparam Surface a model of `FaceListGraph`, a model of `SurfelRange`, or its domain
/// \tparam QueryLocation a vertex, a surfel or a `Location<Surface>`
/// \tparam Vector a 3D vector of any kernel
/// \param surface a mesh, a cloud or a domain
/// \param from a vertex, a surfel or a location
/// \param direction a vector in space, which is projected to the plane of the face of `from`, or to
///        the tangent plane of the fitted surface. At a vertex, the face is the incident one that
///        contains the projected direction. If several do, it is the one whose plane is closest to
///        the direction
/// \param length the length of the path, finite and not negative
/// \param np the named parameters of `make_domain()`
/// \returns the path; its `length` is smaller than the requested length only if it ends at the
///          boundary. On a cloud, `length` is that of the smooth curve through the points; if the
///          path is not cut, it agrees with the requested length to about nine digits
/// \throws Invalid_argument_error if the direction is normal to the plane, the length is invalid,
///         or the surfel is not in the cloud
/// \throws Unsupported_surface_error if the path crosses more than 10<SUP>6</SUP> + 10 n faces of
///         a mesh of n faces, or 10<SUP>4</SUP> faces one after the other at one point
///
/// After `make_domain()`, O(number of crossed faces) time on a mesh. On a cloud of n surfels,
/// O(n log n) time for the fit, and O(1) time for each half of the distance between surfels. For
/// many geodesics on a cloud, use `Logarithmic_map::exponential()`, which fits the surface once.
template <typename Surface, typename QueryLocation, typename Vector,
          typename NamedParameters = internal::Default_parameters>
Straightest_geodesic<Surface_of<Surface>>
straightest_geodesic(const Surface& surface, const QueryLocation& from, const Vector& direction,
                     double length, const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  const internal::Vec3 vector = {CGAL::to_double(direction.x()), CGAL::to_double(direction.y()),
                                 CGAL::to_double(direction.z())};
  if constexpr(internal::Is_cloud<Surface_of<Surface>>::value)
  {
    const internal::Tangent_location start = internal::traced_location(domain, from);
    const unsigned number_of_threads = internal::parameter(np, internal_np::number_of_threads, 1u);
    return internal::outer_path(
        domain, internal::make_cloud_tracer(domain, number_of_threads)(start, vector, length));
  }
  else
    return internal::straightest_on_mesh(domain, internal::location(domain, from), vector, length);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_STRAIGHTEST_GEODESIC_H
