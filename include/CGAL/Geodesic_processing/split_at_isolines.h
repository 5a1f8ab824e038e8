// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SPLIT_AT_ISOLINES_H
#define CGAL_GEODESIC_PROCESSING_SPLIT_AT_ISOLINES_H

#include <CGAL/Geodesic_processing/internal/adaptors/add_triangles.h>
#include <CGAL/Geodesic_processing/internal/adaptors/isovalues.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/split_at_isolines.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

namespace internal {

// Returns the vertices of a domain in the order of the caller if descriptors convert to indices,
// otherwise in the order of the arrays.
template <typename Domain>
std::vector<Index> vertices_in_order(const Domain& domain)
{
  std::vector<Index> order(domain.number_of_vertices());
  std::iota(order.begin(), order.end(), Index(0));
  if constexpr(std::is_convertible_v<typename Domain::Vertex, std::size_t>)
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b)
              { return std::size_t(domain.vertex(a)) < std::size_t(domain.vertex(b)); });
  return order;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingPaths
///
/// Splits a copy of a mesh along the isolines of a function, so that each face of the copy is
/// between two consecutive isovalues, and labels the faces.
///
/// The function is given at the vertices, as for `isolines()`, and the isolines are the same. The
/// result is a subdivision of the mesh:
/// - It has all vertices of the mesh, and one new vertex on each edge for each isovalue that is
///   above the value at one end and below the value at the other end. Equal isovalues add one
///   vertex.
/// - Each face is a part of a face of the mesh and has its orientation. The topology and, except
///   for round-off errors, the surface are the same.
/// - The label of a face is the number of isovalues that are at most the values in its interior.
///   Equal isovalues are counted as often as they are given. If the label is i, and the isovalues
///   are sorted and numbered from zero, the values on the face are at least isovalue i - 1 and at
///   most isovalue i.
/// - A vertex with the isovalue itself counts as above the isovalue. Isolines pass through this
///   vertex, which is not duplicated. A face with three such vertices is above the isovalue.
/// - Faces of the mesh with a vertex whose value is infinite or not a number are split only at the
///   new vertices of an edge between two finite values. Their parts have the largest `std::size_t`
///   as label.
///
/// New vertices are not merged with close vertices. If an isovalue differs from the value of a
/// vertex, or from another isovalue, by a round-off error, the result has faces without area. If
/// they are not wanted, set the value of the vertex to the isovalue.
///
/// \tparam Surface a model of `FaceListGraph`, or its domain
/// \tparam ValueMap a model of `ReadablePropertyMap` with vertices as keys and numbers as values
/// \tparam Isovalues a model of `Range` whose elements are numbers
/// \tparam TriangleMesh a model of `MutableFaceGraph`
/// \tparam FaceLabelMap a model of `WritablePropertyMap` with faces of `TriangleMesh` as keys and
///         `std::size_t` as values
/// \param mesh as for `geodesic_distances()`, but not a cloud
/// \param value_map the values of the vertices; they can be infinite or not a number
/// \param isovalues the values of the isolines, in any order
/// \param split a model of `MutableFaceGraph` to which the vertices and faces are added, the
///        vertices of `mesh` first. If their descriptors convert to indices, they keep their order
/// \param label_map receives the label of each new face
/// \param np parameters of `make_domain()`; and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{do_fit_circles}
///     \cgalParamDescription{as for `isolines()`. The labels and the number of new vertices do not
///       depend on this parameter}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{receives for each edge of `split` whether it is on an isoline. Edges
///       between faces with different labels are on isolines}
///     \cgalParamType{a model of `WritablePropertyMap` with edges of `TriangleMesh` as keys and
///       `bool` as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{location_map}
///     \cgalParamDescription{receives for each new vertex of `split` its location on `mesh`, from
///       which any other function of the vertices can be interpolated. The location of an isolated
///       vertex has the null face}
///     \cgalParamType{a model of `WritablePropertyMap` with vertices of `TriangleMesh` as keys and
///       `Location<Surface>` as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre The property map has a value for each vertex.
/// \throws Invalid_argument_error if an isovalue is infinite or not a number, or if the result has
///         more than 2<SUP>31</SUP> halfedges
/// \throws as `make_domain()`
///
/// If an exception is thrown, `split` is unchanged. O(n log k + m) for n vertices, k isovalues and
/// m new vertices.
template <typename Surface, typename ValueMap, typename Isovalues, typename TriangleMesh,
          typename FaceLabelMap, typename NamedParameters = internal::Default_parameters>
void split_at_isolines(const Surface& mesh, ValueMap value_map, const Isovalues& isovalues,
                       TriangleMesh& split, FaceLabelMap label_map,
                       const NamedParameters& np = NamedParameters())
{
  using internal::Index;
  static_assert(internal::require_support<Function::split_at_isolines, Surface>());
  const auto domain = make_domain(mesh, np);
  const internal::Surface_arrays& arrays = *domain.triangles();
  internal::Split_mesh_at_isolines found = internal::split_at_isolines(
      arrays, internal::function_values(domain, value_map), internal::checked_isovalues(isovalues),
      internal::edge_interpolation(np));

  // The locations of all vertices in the order of the result, and the positions of the vertices of
  // the domain in this order
  std::vector<internal::Surface_location> locations;
  std::vector<Index> position(domain.number_of_vertices());
  locations.reserve(position.size() + found.new_vertices.size());
  for(const Index v : internal::vertices_in_order(domain))
  {
    position[v] = static_cast<Index>(locations.size());
    locations.push_back({internal::none, v, {}});
  }
  locations.insert(locations.end(), found.new_vertices.begin(), found.new_vertices.end());
  std::vector<std::array<double, 3>> points;
  points.reserve(locations.size());
  for(const internal::Surface_location& location : locations)
    points.push_back(internal::coordinates(arrays, location));
  for(auto& triangle : found.triangles)
    for(Index& v : triangle)
      if(v < position.size())
        v = position[v];
  const auto added = internal::add_triangles(points, found.triangles, found.twins, split);
  for(std::size_t f = 0; f < found.labels.size(); ++f)
    put(label_map, internal::face_of(added.halfedges[3 * f], split),
        found.labels[f] == internal::none ? (std::numeric_limits<std::size_t>::max)()
                                          : std::size_t(found.labels[f]));
  if constexpr(internal::has_parameter<NamedParameters, internal_np::location_map_t>)
  {
    auto location_map = internal::parameter(np, internal_np::location_map, 0);
    for(std::size_t v = 0; v < locations.size(); ++v)
      put(location_map, added.vertices[v], domain.outer(locations[v]));
  }
  if constexpr(internal::has_parameter<NamedParameters, CGAL::internal_np::edge_is_constrained_t>)
  {
    auto edge_map = internal::parameter(np, CGAL::internal_np::edge_is_constrained, 0);
    for(const auto h : added.halfedges)
      put(edge_map, edge(h, split), false);
    for(const Index h : found.isoline_halfedges)
      put(edge_map, edge(added.halfedges[h], split), true);
  }
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SPLIT_AT_ISOLINES_H
