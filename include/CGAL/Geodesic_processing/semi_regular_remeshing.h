// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SEMI_REGULAR_REMESHING_H
#define CGAL_GEODESIC_PROCESSING_SEMI_REGULAR_REMESHING_H

#include <CGAL/Geodesic_processing/Base_parameterization.h>
#include <CGAL/Geodesic_processing/internal/remeshing/semi_regular.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingRemeshing
/// The refinement pattern of base faces.
enum class Subdivision_scheme
{
  triangles, ///< each triangle is split into four
  quads      ///< each base face is split into three quads, and each quad into four
};

/// \ingroup PkgGeodesicProcessingRemeshing
/// The summary of a semi-regular remeshing.
struct Semi_regular_result
{
  /// Number of 1-to-4 refinements; for quads, the first split into three is not counted.
  unsigned number_of_levels = 0;
  std::size_t number_of_base_faces = 0; ///< number of faces of the base mesh
  std::size_t number_of_flips = 0;      ///< number of inverted triangles of the parameterization
  /// Maximum distance of a vertex of the mesh from the point of the result with the same base
  /// coordinates; 0 if `maximum_deviation` is 0.
  double deviation = 0.;
};

/// \ingroup PkgGeodesicProcessingRemeshing
///
/// Computes a mesh with subdivision connectivity: the faces of a base mesh are uniformly refined.
/// \cgalCite{cgal:pc-grfp-03}
///
/// All vertices lie on the mesh, at the locations that a `Base_parameterization` assigns to them.
/// In triangle meshes all vertices except base vertices have six neighbors, or four on the
/// boundary. In quad meshes they have four neighbors, or three on the boundary and in the centers
/// of base faces.
///
/// Vertices are added level by level: the vertices of a coarser level come first and keep their
/// order. Faces \f$4f\f$ to \f$4f+3\f$ are the parts of face \f$f\f$ of the previous level. Quads
/// \f$3f\f$ to \f$3f+2\f$ of level 0 are the parts of base face \f$f\f$.
///
/// A cloud is reconstructed first, as for `geodesic_delaunay_remeshing()`.
///
/// \tparam Surface as for `geodesic_distances()`
/// \tparam OutputMesh a model of `MutableFaceGraph`
/// \param surface as for `geodesic_distances()`
/// \param number the number of base vertices
/// \param levels the number of 1-to-4 refinements
/// \param output a model of `MutableFaceGraph`, to which the vertices and faces are added
/// \param np as for `Base_parameterization`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{subdivision_scheme}
///     \cgalParamDescription{the refinement pattern}
///     \cgalParamType{`Subdivision_scheme`}
///     \cgalParamDefault{`Subdivision_scheme::triangles`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_deviation}
///     \cgalParamDescription{for triangles only: refinement stops early once each vertex of the
///       mesh is within this distance of the point with the same base coordinates. The remaining
///       distance is returned as `deviation`. If the value is 0, all levels are computed, and no
///       distance is measured}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{level_map}
///     \cgalParamDescription{receives for each vertex of the output the level that adds it. Level 0
///       contains the base vertices and, for quads, also the vertices that the first split into
///       three adds}
///     \cgalParamType{a model of `WritablePropertyMap` with vertices of the output as keys and
///       `std::size_t` as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns a summary of the result
/// \throws Invalid_argument_error as `Base_parameterization`; also if there would be more than
///         2<SUP>31</SUP> halfedges, and if quads are combined with a maximum deviation
///
/// The time is that of `Base_parameterization`, and linear in the size of the output.
template <typename Surface, typename OutputMesh,
          typename NamedParameters = internal::Default_parameters>
Semi_regular_result semi_regular_remeshing(const Surface& surface, std::size_t number,
                                           unsigned levels, OutputMesh& output,
                                           const NamedParameters& np = NamedParameters())
{
  const double deviation = internal::parameter(np, internal_np::maximum_deviation, 0.);
  if(!(deviation >= 0.))
    throw Invalid_argument_error("The maximum deviation is negative or not a number.");
  const bool has_quads =
      internal::parameter(np, internal_np::subdivision_scheme, Subdivision_scheme::triangles) ==
      Subdivision_scheme::quads;
  if(has_quads && deviation > 0.)
    throw Invalid_argument_error(
        "A maximum deviation is supported only for triangles, not for quads.");
  const Base_parameterization<Surface_of<Surface>> base(surface, number, np);
  const internal::Surface_arrays& coarse = *base.domain().triangles();
  const internal::Semi_regular_mesh found =
      has_quads
          ? internal::build_semi_regular_quads(base.map(), coarse, levels)
          : internal::build_semi_regular_mesh(base.map(), coarse, levels, deviation / coarse.scale);

  std::vector<typename boost::graph_traits<OutputMesh>::vertex_descriptor> vertices;
  if(has_quads)
    internal::add_faces(found.points, found.quads, output, &vertices);
  else
    internal::add_faces(found.points, found.triangles, output, &vertices);
  if constexpr(internal::has_parameter<NamedParameters, internal_np::level_map_t>)
  {
    auto level_map = internal::parameter(np, internal_np::level_map, 0);
    std::size_t level = 0;
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      while(i >= found.number_of_vertices[level])
        ++level;
      put(level_map, vertices[i], level);
    }
  }
  return {unsigned(found.number_of_vertices.size() - 1), base.number_of_base_faces(),
          base.number_of_flips(), found.deviation};
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SEMI_REGULAR_REMESHING_H
