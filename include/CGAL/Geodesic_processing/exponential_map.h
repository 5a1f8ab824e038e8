// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_EXPONENTIAL_MAP_H
#define CGAL_GEODESIC_PROCESSING_EXPONENTIAL_MAP_H

#include <CGAL/Geodesic_processing/internal/adaptors/oriented_tangent_plane.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <array>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingLogMap
///
/// Returns the endpoint of the straightest geodesic in the direction of a tangent vector, whose
/// length is that of the vector.
///
/// It is the inverse of `logarithmic_map()`.  Both use the same axes if `up_direction` is the same.
/// Beyond the injectivity radius, the geodesic continues straight, although it is not necessarily a
/// shortest path.  If it reaches the boundary, the point on the boundary is returned.
///
/// \tparam Mesh a model of `FaceListGraph`, or its domain
/// \tparam Place a vertex or a `Location<Mesh>`
/// \param mesh a model of `FaceListGraph` or a `Mesh_domain`; clouds are not supported
/// \param base a vertex or a location
/// \param vector a vector in the tangent plane of `base`
/// \param np `up_direction` as for `Logarithmic_map::compute()`, and the named parameters of
///        `make_domain()`
/// \returns a location
/// \throws Invalid_argument_error if the base is an isolated vertex, the vector is not finite, or
///         `up_direction` is normal to the surface
///
/// O(number of crossed faces) time after `make_domain()`.  \cgalCite{cgal:ps-sgps-98}
template <typename Mesh, typename Place, typename NamedParameters = internal::Default_parameters>
Location<Surface_of<Mesh>> exponential_map(const Mesh& mesh, const Place& base,
                                           const std::array<double, 2>& vector,
                                           const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(mesh, np);
  static_assert(
      !internal::Is_cloud<Surface_of<Mesh>>::value,
      "An exponential map needs a mesh, because the triangles of a cloud are not connected.");
  return internal::exponential(domain, internal::oriented_tangent_plane(domain, base, np), vector);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_EXPONENTIAL_MAP_H
