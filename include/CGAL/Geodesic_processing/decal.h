// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_DECAL_H
#define CGAL_GEODESIC_PROCESSING_DECAL_H

#include <CGAL/Geodesic_processing/internal/adaptors/colors.h>
#include <CGAL/Geodesic_processing/internal/log_map/decal.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/logarithmic_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDecals
/// Red, green, blue and opacity in [0, 1]. The colors are not premultiplied by the opacity.
using Decal_color = std::array<double, 4>;

/// \ingroup PkgGeodesicProcessingDecals
/// Image coordinates: (0, 0) is the lower left corner, and (1, 1) the upper right one.
using Decal_coordinates = std::array<double, 2>;

/// \ingroup PkgGeodesicProcessingDecals
/// An image: a function that returns the color at image coordinates in [0, 1] x [0, 1].
using Decal_image = std::function<Decal_color(const Decal_coordinates&)>;

/// \ingroup PkgGeodesicProcessingDecals
/// A vertex or surfel that a decal covers, and its image coordinates.
template <typename Surface>
struct Decal_vertex
{
  typename internal::Surface_traits<Surface>::Vertex vertex; ///< the vertex or surfel
  Decal_coordinates coordinates;                             ///< its image coordinates
};

/// \ingroup PkgGeodesicProcessingDecals
/// A face and the image coordinates of its corners. The first corner is the source of
/// `halfedge(face)`. The others follow in the order of the halfedges around the face.
template <typename TriangleMesh>
struct Decal_face
{
  typename boost::graph_traits<TriangleMesh>::face_descriptor face; ///< the face
  std::array<Decal_coordinates, 3> coordinates; ///< the image coordinates of its corners
};

/// \ingroup PkgGeodesicProcessingDecals
///
/// The placement of an image on a surface.
template <typename Surface, bool is_cloud = internal::Is_cloud<Surface>::value>
struct Decal
{
  Tangent_frame<Surface> frame;                ///< the center, and the directions right and up
  std::vector<Decal_vertex<Surface>> vertices; ///< the vertices that the image covers
  /// The faces that intersect the image. Coordinates of corners may be outside the image. If a
  /// face is cut (see `Logarithmic_map`), its coordinates are extrapolated from its longest edge
  /// that is not cut. If all its edges are cut, it is omitted.
  std::vector<Decal_face<Surface>> faces;
};

/// \ingroup PkgGeodesicProcessingDecals
/// The placement of an image on a surfel cloud, which has no faces.
template <typename SurfelRange>
struct Decal<SurfelRange, true>
{
  Tangent_frame<SurfelRange> frame;                ///< the center, and the directions right and up
  std::vector<Decal_vertex<SurfelRange>> vertices; ///< the surfels that the image covers
};

/// \ingroup PkgGeodesicProcessingDecals
///
/// Places images on a surface, one at a time, by a `Logarithmic_map`. Distances and directions
/// from the center of an image are preserved.
///
/// The precomputation does not depend on the center. The cost of `place()` depends on the number
/// of vertices or surfels that are closer to the center than the corners of the image. Memory is
/// allocated for these only.
///
/// \tparam Surface, Method as for `Logarithmic_map`
template <typename Surface, typename Method = Gradient<>>
class Decal_placer
{
  using Map = Logarithmic_map<Surface, Method>;

public:
  using Domain = typename Map::Domain;

  /// Precomputes the domain of the surface in the time of `make_domain()`, and uses it.
  ///
  /// \param surface the surface
  /// \param np the named parameters of `make_domain()`
  /// \throws as `make_domain()`
  template <typename NamedParameters = internal::Default_parameters>
  explicit Decal_placer(const Surface& surface, const NamedParameters& np = NamedParameters())
      : m_map(surface, np)
  {}
  /// Uses an existing `domain`, which is shared. O(n) time.
  explicit Decal_placer(const Domain& domain) : m_map(domain) {}
#ifndef DOXYGEN_RUNNING
  Decal_placer(const Domain& domain, const internal::Log_kind& kind) : m_map(domain, kind) {}
#endif

  /// Returns the domain of the surface. O(1).
  const Domain& domain() const { return m_map.domain(); }

  /// Computes the placement of an image with a given center. Takes the time of
  /// `Logarithmic_map::compute()` up to the corners of the image, a few times on a mesh.
  ///
  /// \tparam Place a vertex, a surfel or a location
  /// \param center a vertex, a surfel or a location
  /// \param width the width of the image, in the unit of the surface
  /// \param height the height of the image, in the unit of the surface
  /// \param np the named parameters of `Logarithmic_map::compute()` except `maximum_distance`;
  ///        `up_direction` is the upward direction of the image
  /// \returns the placement
  /// \throws Invalid_argument_error as `Logarithmic_map::compute()`, and if the width or the height
  ///         is not positive and finite
  template <typename Place, typename NamedParameters = internal::Default_parameters>
  Decal<Surface> place(const Place& center, double width, double height,
                       const NamedParameters& np = NamedParameters());

private:
  template <typename Place, typename NamedParameters>
  void compute(const Place& center, double maximum_distance, const NamedParameters& np)
  {
    m_map.compute(center,
                  internal::chain(np).maximum_distance(maximum_distance * triangles().scale));
  }
  template <typename Place, typename NamedParameters>
  std::vector<internal::Triangle_image> covered_triangles(const Place& center,
                                                          const internal::Vec2& half_size,
                                                          const NamedParameters& np);
  const internal::Surface_arrays& triangles() const { return *m_map.domain().triangles(); }

  Map m_map;
};

// Finds the triangles that intersect the image.
//
// Their corners can be outside the image, so the map is computed up to a margin beyond the image's
// corners. The longest edge at the center is usually a sufficient margin. If an intersecting
// triangle lacks the image of a corner, the margin is enlarged and the map is recomputed.
template <typename Surface, typename Method>
template <typename Place, typename NamedParameters>
std::vector<internal::Triangle_image> Decal_placer<Surface, Method>::covered_triangles(
    const Place& center, const internal::Vec2& half_size, const NamedParameters& np)
{
  double margin = internal::longest_edge_at(triangles(), internal::location(domain(), center));
  for(std::size_t reached_before = 0;;)
  {
    compute(center, internal::norm(half_size) + margin, np);
    internal::Decal_triangles found = internal::find_decal_triangles(
        triangles(), m_map.reached_indices(), m_map.internal_coordinates(), half_size);
    const std::size_t reached = m_map.reached_indices().size();
    if(!(found.longest_edge > 0.) || reached == reached_before)
      return std::move(found.covered);
    margin = (std::max)(2. * margin, 1.1 * found.longest_edge);
    reached_before = reached;
  }
}

template <typename Surface, typename Method>
template <typename Place, typename NamedParameters>
Decal<Surface> Decal_placer<Surface, Method>::place(const Place& center, double width,
                                                    double height, const NamedParameters& np)
{
  const double scale = triangles().scale;
  const internal::Vec2 half_size = {width / scale / 2., height / scale / 2.};
  if(!(half_size[0] > 0. && half_size[1] > 0. && std::isfinite(half_size[0]) &&
       std::isfinite(half_size[1])))
    throw Invalid_argument_error("The width and height of a decal must be positive and finite.");
  const auto coordinates = [&half_size](const internal::Vec2& uv) -> Decal_coordinates {
    return {0.5 + 0.5 * uv[0] / half_size[0], 0.5 + 0.5 * uv[1] / half_size[1]};
  };
  Decal<Surface> decal;
  if constexpr(internal::Is_cloud<Surface>::value)
    compute(center, internal::norm(half_size), np);
  else
    for(const auto& [triangle, corners] : covered_triangles(center, half_size, np))
      decal.faces.push_back(
          {domain().face(triangle),
           {coordinates(corners[0]), coordinates(corners[1]), coordinates(corners[2])}});
  for(const internal::Index vertex : m_map.reached_indices())
  {
    const internal::Vec2& uv = m_map.internal_coordinates()[vertex];
    if(std::abs(uv[0]) <= half_size[0] && std::abs(uv[1]) <= half_size[1])
      decal.vertices.push_back({domain().vertex(vertex), coordinates(uv)});
  }
  decal.frame = m_map.frame();
  return decal;
}

namespace internal {

inline Vec2 interpolate(const std::array<Vec2, 3>& corners,
                        const std::array<double, 3>& barycentric)
{
  return barycentric[0] * corners[0] + barycentric[1] * corners[1] + barycentric[2] * corners[2];
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingDecals
///
/// Composites an image over the colors of the vertices or surfels that the decal covers.
///
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Image a function object
/// \tparam ColorMap a model of `ReadWritePropertyMap` with vertices or surfels as keys
/// \param decal the placement of the image
/// \param image a function with the signature of `Decal_image`
/// \param color_map a read-write property map of colors, which are updated. Its value type is
///        `CGAL::IO::Color`, `Decal_color` or `std::array<double, 3>`
/// \pre The property map has a value for each vertex or surfel that the decal covers.
///
/// O(m) for m vertices or surfels of the decal.
template <typename Surface, typename Image, typename ColorMap>
void composite_decal(const Decal<Surface>& decal, const Image& image, ColorMap color_map)
{
  for(const auto& [vertex, coordinates] : decal.vertices)
  {
    typename boost::property_traits<ColorMap>::value_type color = get(color_map, vertex);
    internal::assign(color, internal::blend_over(image(coordinates), internal::to_rgba(color)));
    put(color_map, vertex, color);
  }
}

/// \ingroup PkgGeodesicProcessingDecals
/// An image and its placement.
template <typename Surface>
struct Decal_layer
{
  Decal<Surface> decal; ///< the placement
  Decal_image image;    ///< the image
};

/// \ingroup PkgGeodesicProcessingDecals
/// A texture in which each covered face of a mesh has its own triangle.
template <typename TriangleMesh>
struct Decal_texture
{
  std::size_t width = 0;                       ///< number of texels in a row
  std::size_t height = 0;                      ///< number of rows
  std::vector<Decal_color> texels;             ///< by rows, from the lowest row up
  std::vector<Decal_face<TriangleMesh>> faces; ///< the covered faces, each once
  Decal_coordinates background = {0., 0.};     ///< coordinates of all corners of all other faces
};

/// \ingroup PkgGeodesicProcessingDecals
///
/// Composites several images into one texture of the mesh. Later layers are drawn over earlier
/// ones.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \param layers images placed on the same mesh, from the lowest layer to the highest
/// \param segments the length, in texels, of the two legs of each covered face's right triangle in
///        the texture. The hypotenuse has equally many segments, which are longer
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{background}
///     \cgalParamDescription{the color of texels that no image covers}
///     \cgalParamType{`Decal_color`}
///     \cgalParamDefault{white and opaque}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the texture, and the coordinates of each covered face in it
/// \throws Invalid_argument_error if `segments` is zero, or if the texture has more than
///         2<SUP>28</SUP> texels
///
/// O(s<SUP>2</SUP> f) for s segments and f covered faces of all layers.
template <typename TriangleMesh, typename NamedParameters = internal::Default_parameters>
Decal_texture<TriangleMesh> bake_decals(const std::vector<Decal_layer<TriangleMesh>>& layers,
                                        std::size_t segments,
                                        const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::bake_decals, TriangleMesh>());
  Decal_texture<TriangleMesh> texture;
  // The first triangle of the texture is the background.
  std::map<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::size_t> triangle_of;
  for(const auto& layer : layers)
    for(const auto& covered : layer.decal.faces)
      if(triangle_of.try_emplace(covered.face, triangle_of.size() + 1).second)
        texture.faces.push_back({covered.face, {}});

  const internal::Texture_cells cells(texture.faces.size() + 1, segments);
  texture.width = cells.width();
  texture.height = cells.height();
  texture.texels.assign(
      texture.width * texture.height,
      internal::parameter(np, internal_np::background, Decal_color{1., 1., 1., 1.}));
  texture.background = cells.corners(0)[0];
  for(std::size_t i = 0; i < texture.faces.size(); ++i)
    texture.faces[i].coordinates = cells.corners(i + 1);

  for(const auto& layer : layers)
    for(const auto& [face, corners] : layer.decal.faces)
      cells.for_each_texel(
          triangle_of.at(face),
          [&, &corners = corners](std::size_t texel, const std::array<double, 3>& barycentric)
          {
            const Decal_coordinates uv = internal::interpolate(corners, barycentric);
            if(uv[0] >= 0. && uv[0] <= 1. && uv[1] >= 0. && uv[1] <= 1.)
              texture.texels[texel] = internal::blend_over(layer.image(uv), texture.texels[texel]);
          });
  return texture;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_DECAL_H
