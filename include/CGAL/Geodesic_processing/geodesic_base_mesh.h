// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_BASE_MESH_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_BASE_MESH_H

#include <CGAL/Geodesic_processing/Base_parameterization.h>
#include <CGAL/Geodesic_processing/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingRemeshing
///
/// Computes a base mesh, the geodesic Delaunay triangulation of few samples, and splits a copy of
/// the mesh along its edges. \cgalCite{cgal:pc-grfp-03}
///
/// Each base face is the union of a set of faces of that copy: a disk bounded by its three base
/// edges. Base edges are locally shortest. They keep a distance of about 1/200 of a mesh edge from
/// vertices and from each other, so they meet in base vertices only. The genus, boundary cycles and
/// connected components are the same as for the mesh. A cloud is reconstructed first, as for
/// `geodesic_delaunay_remeshing()`: then `divided` is a copy of the reconstructed mesh.
///
/// \tparam Surface as for `geodesic_distances()`
/// \tparam BaseMesh a model of `MutableFaceGraph`
/// \tparam DividedMesh a model of `MutableFaceGraph`
/// \tparam BaseFaceMap a model of `WritablePropertyMap` with faces of `DividedMesh` as keys and
///         faces of `BaseMesh` as values
/// \param surface as for `geodesic_distances()`
/// \param number the number of base vertices; 0 requests the minimum that the topology requires
/// \param base a model of `MutableFaceGraph`, to which base vertices and faces are added
/// \param divided a model of `MutableFaceGraph`, to which the vertices and faces of the split mesh
///        are added
/// \param base_face_map receives for each face of `divided` the face of `base` that contains it
/// \param np as for `Base_parameterization`
/// \returns a summary of the result
/// \throws as `Base_parameterization`
///
/// The time is that of `Base_parameterization`.
template <typename Surface, typename BaseMesh, typename DividedMesh, typename BaseFaceMap,
          typename NamedParameters = internal::Default_parameters>
Remeshing_result geodesic_base_mesh(const Surface& surface, std::size_t number, BaseMesh& base,
                                    DividedMesh& divided, BaseFaceMap base_face_map,
                                    const NamedParameters& np = NamedParameters())
{
  const auto input_domain = make_domain(surface, np);
  const auto& domain = internal::manifold_domain(input_domain);
  const internal::Base_mesh found = internal::build_base_mesh(
      domain.triangles(), internal::base_mesh_options(domain, number, np));
  if(!found.is_finished)
    throw Cancelled();
  if(found.triangles.empty())
    throw Invalid_argument_error("The mesh has no triangles.");
  Remeshing_result result;
  result.number_of_added_vertices = found.samples.size() - (std::min)(number, found.samples.size());

  std::vector<std::array<double, 3>> base_points;
  for(const internal::Index vertex : found.vertex)
    base_points.push_back(internal::coordinates(found.fine, {internal::none, vertex, {}}));
  const auto base_faces = internal::add_faces(base_points, found.triangles, base);

  const internal::Used_triangles fine = internal::used_triangles(found.fine);
  const auto faces = internal::add_faces(fine.points, fine.triangles, divided);
  for(std::size_t f = 0; f < faces.size(); ++f)
    put(base_face_map, faces[f], base_faces[found.region[f]]);
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_BASE_MESH_H
