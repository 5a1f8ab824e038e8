// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_PARAMETERIZE_OVER_BASE_H
#define CGAL_GEODESIC_PROCESSING_PARAMETERIZE_OVER_BASE_H

#include <CGAL/Geodesic_processing/Base_parameterization.h>

#include <cstddef>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingRemeshing
///
/// Maps the vertices of a mesh to a base mesh with few triangles.
///
/// The returned `Base_parameterization` also maps all other locations.
///
/// \tparam TriangleMesh a model of `FaceListGraph`, or its domain
/// \tparam BaseLocationMap a model of `WritablePropertyMap` with vertices as keys and
///         `Base_location` as values
/// \param mesh a model of `FaceListGraph`, all of whose faces are triangles, or its domain
/// \param number the number of base vertices
/// \param base_location_map receives for each vertex its `Base_location`; vertices without faces
///        are not written
/// \param np as for `Base_parameterization`
/// \returns the map between the mesh and the base mesh
/// \throws as `Base_parameterization`
///
/// The time is that of `Base_parameterization`.
template <typename TriangleMesh, typename BaseLocationMap,
          typename NamedParameters = internal::Default_parameters>
Base_parameterization<Surface_of<TriangleMesh>>
parameterize_over_base(const TriangleMesh& mesh, std::size_t number,
                       BaseLocationMap base_location_map,
                       const NamedParameters& np = NamedParameters())
{
  Base_parameterization<Surface_of<TriangleMesh>> result(mesh, number, np);
  const auto& domain = result.domain();
  for(internal::Index i = 0; i < domain.number_of_vertices(); ++i)
    if(internal::vertex_location(*domain.triangles(), i).triangle != internal::none)
      put(base_location_map, domain.vertex(i), result(domain.vertex(i)));
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_PARAMETERIZE_OVER_BASE_H
