// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BAKE_ATLAS_H
#define CGAL_GEODESIC_PROCESSING_BAKE_ATLAS_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/decal.h>
#include <CGAL/Geodesic_processing/distortion.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/mesh_of.h>
#include <CGAL/Geodesic_processing/internal/parameterization/texels.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingAtlas
///
/// Computes the texture of a mesh with texture coordinates. Each texel gets the color of the
/// location on the mesh that its center shows.
///
/// Texels outside of a chart, up to half of the gutter away, get the color of the closest location
/// on the chart. The background is therefore not visible if adjacent texels are interpolated.
///
/// \tparam Mesh a model of `FaceListGraph`, or its domain
/// \tparam UVMap a model of `ReadablePropertyMap` with vertices or halfedges as keys and `Point_2`
///         or arrays of two numbers as values
/// \tparam Color a function object
/// \param mesh_or_domain a triangle mesh, or its domain. For a cloud, `texture_atlas()` creates a
///        mesh, which is passed here.
/// \param corner_uv_map texture coordinates of halfedges, as `texture_atlas()` writes them
/// \param color a function that is called with a `Polygon_mesh_processing::Face_location` and
///        returns a `Decal_color`
/// \param size the number of texels along each edge of the texture, at most 2<SUP>14</SUP>
/// \param np optional named parameters:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{gutter_width}
///     \cgalParamDescription{the width of the gutter in texels}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{4}
///   \cgalParamNEnd
///   \cgalParamNBegin{background}
///     \cgalParamDescription{the color of all other texels}
///     \cgalParamType{`Decal_color`}
///     \cgalParamDefault{white and transparent}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre The property map has a value for each halfedge of a face.
/// \returns the colors of `size * size` texels, in rows from bottom to top
/// \throws Unsupported_surface_error if a face is not a triangle
/// \throws Invalid_argument_error if the size is zero or too large
///
/// Takes linear time in the number of texels and of faces.
template <typename Mesh, typename UVMap, typename Color,
          typename NamedParameters = internal::Default_parameters>
std::vector<Decal_color> bake_atlas(const Mesh& mesh_or_domain, UVMap corner_uv_map,
                                    const Color& color, std::size_t size,
                                    const NamedParameters& np = NamedParameters())
{
  using TriangleMesh = Surface_of<Mesh>;
  static_assert(internal::require_support<Function::bake_atlas, Mesh>());
  const TriangleMesh& mesh = internal::mesh_of(mesh_or_domain);
  if(!is_triangle_mesh(mesh))
    throw Unsupported_surface_error("A face is not a triangle.");
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> all_faces;
  std::vector<internal::Vec2> coordinates;
  for(const auto face : faces(mesh))
  {
    all_faces.push_back(face);
    // Corner k is the source of halfedge k and the target of the previous halfedge.
    const auto h = halfedge(face, mesh);
    for(const auto to : {prev(h, mesh), h, next(h, mesh)})
      coordinates.push_back(internal::image_of(to, mesh, corner_uv_map));
  }
  // Bilinear lookup reads diagonal neighbors, so the margin is at least 1.5 texels for any gutter.
  const double gutter = double(internal::parameter(np, internal_np::gutter_width, std::size_t(4)));
  const internal::Texel_map texels =
      internal::rasterize_texels(coordinates, size, (std::max)(gutter / 2., 1.5));
  std::vector<Decal_color> result(
      size * size, internal::parameter(np, internal_np::background, Decal_color{1., 1., 1., 0.}));
  for(std::size_t i = 0; i < result.size(); ++i)
    if(const internal::Index f = texels.triangle[i]; f != internal::none)
    {
      const internal::Vec2* const image = &coordinates[3 * std::size_t(f)];
      const internal::Vec2 texel_center = {(double(i % size) + 0.5) / double(size),
                                           (double(i / size) + 0.5) / double(size)};
      result[i] = color(typename internal::Surface_traits<TriangleMesh>::Location(
          all_faces[f],
          internal::nearest_barycentric({image[0], image[1], image[2]}, texel_center)));
    }
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_BAKE_ATLAS_H
