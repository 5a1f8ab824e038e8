// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_EXPONENTIAL_MAP_H
#define CGAL_GEODESIC_PROCESSING_EXPONENTIAL_MAP_H

#include <CGAL/Geodesic_processing/internal/adaptors/oriented_tangent_plane.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <array>
#include <type_traits>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingLogMap
///
/// Returns the endpoint of the straightest geodesic in the direction of a tangent vector, whose
/// length is that of the vector.
///
/// It is the inverse of `logarithmic_map()`. Both use the same axes if they have the same
/// `up_direction`, or none.
/// Beyond the injectivity radius, the geodesic continues straight, although it is not necessarily a
/// shortest path. If it reaches the boundary, the point on the boundary is returned.
///
/// On a cloud, the geodesic is traced on a surface that is fitted to the surfels, see
/// `straightest_geodesic()`. For many vectors, `Logarithmic_map::exponential()` is faster, because
/// it fits the surface only once.
///
/// \tparam Surface a model of `FaceListGraph`, a model of `SurfelRange`, or its domain
/// \tparam Place a vertex, a surfel or a `Location<Surface>`
/// \tparam TangentVector `Vector_2`, `Point_2`, or an array of two numbers
/// \param surface a mesh, a cloud or a domain
/// \param base a vertex, a surfel or a location
/// \param vector the two components of a vector in the tangent plane of `base`, in the axes of
///        `Logarithmic_map::frame()`
/// \param np `up_direction` as for `Logarithmic_map::compute()`, and the named parameters of
///        `make_domain()`
/// \returns a location; on a cloud, the projection of the endpoint to the tangent plane of the
///          nearest surfel
/// \throws Invalid_argument_error if the base is an isolated vertex or not in the cloud, the vector
///         is not finite, or `up_direction` is normal to the surface
///
/// After `make_domain()`, O(number of crossed faces) time on a mesh, \cgalCite{cgal:ps-sgps-98} and
/// O(n log n) time for the fit on a cloud of n surfels.
template <typename Surface, typename Place, typename TangentVector = std::array<double, 2>,
          typename NamedParameters = internal::Default_parameters>
Location<Surface_of<Surface>> exponential_map(const Surface& surface, const Place& base,
                                              const TangentVector& vector,
                                              const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  const internal::Exponential_tracer<std::decay_t<decltype(domain)>> exponential(
      internal::parameter(np, internal_np::number_of_threads, 1u));
  return exponential(domain, internal::oriented_tangent_plane(domain, base, np),
                     internal::tangent_vector(vector));
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_EXPONENTIAL_MAP_H
