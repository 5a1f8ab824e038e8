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
/// returns the place of a mesh to which a tangent vector leads, straight on: the inverse of
/// `logarithmic_map()`, whose axes are these when `up_direction` is the same.
///
/// Beyond the radius up to which shortest paths are unique it goes on straight.  Where it meets a border, the
/// place there is returned.
///
/// \param mesh a model of `FaceListGraph` or a `Mesh_domain`; a cloud has no straight lines
/// \param base a vertex or a location
/// \param vector in the tangent plane of the base
/// \param np `up_direction`, as for `Logarithmic_map::compute()`, and what `make_domain()` takes
/// \throws Invalid_argument_error when the base is an isolated vertex, the vector is not finite, or the direction
///         is normal to the surface
///
/// O(number of faces crossed) after `make_domain()`.  \cgalCite{cgal:ps-sgps-98}
template <typename Mesh, typename Place, typename NamedParameters = internal::Default_parameters>
auto exponential_map(const Mesh& mesh, const Place& base, const std::array<double, 2>& vector,
                     const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(mesh, np);
  return internal::exponential(domain, internal::oriented_tangent_plane(domain, base, np), vector);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_EXPONENTIAL_MAP_H
