// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_PARAMETERIZE_OVER_BASE_H
#define CGAL_GEODESIC_PROCESSING_PARAMETERIZE_OVER_BASE_H

#include <CGAL/Geodesic_processing/Base_parameterization.h>

#include <cstddef>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingRemeshing
///
/// Maps the vertices of a mesh, or the surfels of a cloud, to a base mesh with few triangles.
///
/// The returned `Base_parameterization` also maps all other locations.
///
/// \tparam Surface as for `geodesic_distances()`
/// \tparam BaseLocationMap a model of `WritablePropertyMap` with vertices or surfels as keys and
///         `Base_location` as values
/// \param surface as for `geodesic_distances()`
/// \param number the number of base vertices
/// \param base_location_map receives for each vertex or surfel its `Base_location`; vertices
///        without faces are not written
/// \param np as for `Base_parameterization`
/// \returns the map between the surface and the base mesh
/// \throws as `Base_parameterization`
///
/// The time is that of `Base_parameterization`.
template <typename Surface, typename BaseLocationMap,
          typename NamedParameters = internal::Default_parameters>
Base_parameterization<Surface_of<Surface>>
parameterize_over_base(const Surface& surface, std::size_t number,
                       BaseLocationMap base_location_map,
                       const NamedParameters& np = NamedParameters())
{
  Base_parameterization<Surface_of<Surface>> result(surface, number, np);
  const auto& domain = result.domain();
  const auto write = [&](const auto& vertex)
  {
    if(internal::canonical(*domain.triangles(), domain.inner_vertex(vertex)).triangle !=
       internal::none)
      put(base_location_map, vertex, result(vertex));
  };
  for(internal::Index i = 0; i < domain.number_of_vertices(); ++i)
    write(domain.vertex(i));
  if constexpr(!internal::Is_cloud<Surface_of<Surface>>::value)
    for(const auto vertex : domain.merged_vertices())
      write(vertex);
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_PARAMETERIZE_OVER_BASE_H
