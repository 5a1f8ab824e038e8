// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_MASS_DENSITY_H
#define CGAL_GEODESIC_PROCESSING_MASS_DENSITY_H

#include <utility>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
/// Stores a mass distribution with a density, which is linear in each triangle. See
/// `mass_density()`.
///
/// \tparam PropertyMap a model of `ReadablePropertyMap` with vertices or surfels as keys and
///   numbers as values
template <typename PropertyMap>
struct Mass_density
{
  PropertyMap map; ///< mass per area at each vertex or surfel, in the unit of the coordinates
};

/// \ingroup PkgGeodesicProcessingTransport
///
/// Creates a mass distribution for `earth_movers_distance()` from a property map of densities.
///
/// \tparam PropertyMap a model of `ReadablePropertyMap` with vertices or surfels as keys and
///         numbers as values
/// \param map the mass per area at each vertex or surfel, per squared unit of the coordinates
/// \pre The map has a value for each vertex or surfel when it is read.
/// \returns the density, to be passed as `from` or `to`
///
/// O(1); the map is read by the function that receives the density.
template <typename PropertyMap>
Mass_density<PropertyMap> mass_density(PropertyMap map)
{
  return {std::move(map)};
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_MASS_DENSITY_H
