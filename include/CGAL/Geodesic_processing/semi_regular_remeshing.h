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
/// what base faces are cut into.
enum class Subdivision_scheme
{
  triangles, ///< four triangles, and each of these into four
  quads      ///< three quadrilaterals, and each of these into four
};

/// \ingroup PkgGeodesicProcessingRemeshing
/// what became of a semi-regular remeshing.
struct Semi_regular_result
{
  unsigned levels = 0; ///< how often faces have been cut; of quads, after the first three
  std::size_t base_faces = 0;
  std::size_t folds = 0; ///< of the parameterization
  double deviation = 0.; ///< of the mesh's vertices, where `maximum_deviation` is given
};

/// \ingroup PkgGeodesicProcessingRemeshing
///
/// makes a mesh with subdivision connectivity: each face of a base mesh is cut again and again, by the same
/// pattern, and vertices lie on the mesh where a `Base_parameterization` has their places.
/// \cgalCite{cgal:pc-grfp-03}
///
/// All vertices but those of the base have six neighbours, or on borders four; in meshes of quads four, or
/// three on borders and in the middles of base faces.  Vertices are added level by level: those of a coarser
/// mesh come first, in its order.  Faces \f$4f\f$ to \f$4f+3\f$ are the parts of face \f$f\f$ of the level
/// before; quads \f$3f\f$ to \f$3f+2\f$ of level 0 are those of base face \f$f\f$.
///
/// \param mesh all of whose faces are triangles
/// \param number of base vertices
/// \param levels how often faces are cut
/// \param output any model of `MutableFaceGraph`, to which the vertices and faces are added
/// \param np as for `Base_parameterization`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{subdivision_scheme}
///     \cgalParamDescription{a `Subdivision_scheme`}
///     \cgalParamDefault{`Subdivision_scheme::triangles`} \cgalParamNEnd
///   \cgalParamNBegin{maximum_deviation}
///     \cgalParamDescription{of triangles: less levels where these are enough that no vertex of the mesh is
///       farther from what is at its place: what is left over is the result's `deviation`}
///     \cgalParamDefault{all levels} \cgalParamNEnd
///   \cgalParamNBegin{level_map}
///     \cgalParamDescription{receives for each vertex of the output the level on which it comes, 0 of the
///       base, and of quads also of the vertices that the first three have} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_argument_error also when there would be more than 2<SUP>31</SUP> sides, and when quads have a
///         maximum deviation
template <typename TriangleMesh, typename OutputMesh,
          typename NamedParameters = internal::Default_parameters>
Semi_regular_result semi_regular_remeshing(const TriangleMesh& mesh, std::size_t number,
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
    throw Invalid_argument_error("The maximum deviation is of triangles, not of quads.");
  const Base_parameterization<TriangleMesh> base(mesh, number, np);
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
    std::size_t level = 0;
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      while(i >= found.number_of_vertices[level])
        ++level;
      put(internal::parameter(np, internal_np::level_map, 0), vertices[i], level);
    }
  }
  return {unsigned(found.number_of_vertices.size() - 1), base.number_of_base_faces(), base.folds(),
          found.deviation};
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SEMI_REGULAR_REMESHING_H
