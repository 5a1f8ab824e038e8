// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_MESH_DOMAIN_H
#define CGAL_GEODESIC_PROCESSING_MESH_DOMAIN_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/Index_map.h>
#include <CGAL/Geodesic_processing/internal/adaptors/Lazy_mesh.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/slowness.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

namespace internal {

// Calls face() of the mesh in scopes in which a member function of this name hides it.
template <typename Halfedge, typename TriangleMesh>
typename boost::graph_traits<TriangleMesh>::face_descriptor face_of(Halfedge h,
                                                                    const TriangleMesh& mesh)
{
  return face(h, mesh);
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingDomain
///
/// Represents a triangle mesh for all algorithms of this package: its triangles, their adjacency
/// and their edge lengths. It is returned by `make_domain()` and can be passed to functions instead
/// of the mesh. It is immutable, and copies are cheap, since they share the data.
///
/// A domain stores the descriptors of the mesh. If the mesh is changed, the domain cannot be used
/// any longer. If the mesh is destroyed or moved, it can still be used by all functions that do not
/// read or write a property map of halfedges or edges. It takes about 175 bytes per vertex.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
template <typename TriangleMesh>
class Mesh_domain
{
  using Graph = boost::graph_traits<TriangleMesh>;
  using Face = typename Graph::face_descriptor;

public:
  using Surface = TriangleMesh;
  using Traits = internal::Surface_traits<Surface>;
  using Vertex = typename Traits::Vertex; ///< a vertex descriptor
  /// `Polygon_mesh_processing::Face_location<TriangleMesh, double>`, for meshes of any kernel
  using Location = typename Traits::Location;
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;

  /// Constructs the domain by reading the mesh once. O(n).
  ///
  /// \param mesh a triangle mesh
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{vertex_point_map}
  ///     \cgalParamDescription{the positions of the vertices}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with vertices as keys and 3D points as
  ///       values}
  ///     \cgalParamDefault{the vertex point map of the mesh}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \pre The mesh is valid: `CGAL::is_valid_polygon_mesh(mesh)`. The property map has a value for
  ///      each vertex.
  /// \throws Unsupported_surface_error if a face is not a triangle, if there are more than
  ///         2<SUP>31</SUP> halfedges, or if most edges are more than
  ///         5 &middot; 10<SUP>10</SUP> times shorter than the extent of the faces
  /// \throws Invalid_argument_error if a coordinate is not finite, or if distances overflow
  template <typename NamedParameters = internal::Default_parameters>
  explicit Mesh_domain(const TriangleMesh& mesh, const NamedParameters& np = NamedParameters());

  /// Returns the number of vertices, of a soup without points that have been merged with earlier
  /// ones. The number of keys of a map is therefore `num_vertices(mesh())`. O(1).
  std::size_t number_of_vertices() const { return m_data->vertices.size(); }

  /// Returns the point of a location. O(1).
  /// \param location a location on the mesh
  /// \throws Invalid_argument_error if the face is not in the mesh, or if the barycentric
  ///         coordinates are negative or do not sum to one
  Point_3 point(const Location& location) const { return point(inner(location)); }

  /// Returns the mesh, which must not have been destroyed or moved. O(1). The mesh of a soup is
  /// built by the first call, in O(n); several threads may call it.
  const TriangleMesh& mesh() const { return m_mesh_of_soup ? m_mesh_of_soup->get() : *m_mesh; }

  /// \cond INTERNAL
  // Conversion between the mesh and the kernels.
  const std::shared_ptr<const internal::Surface_arrays>& triangles() const { return m_triangles; }
  internal::Index index(Vertex v) const { return m_data->index_of_vertex[v]; }
  Vertex vertex(internal::Index index) const { return m_data->vertices[index]; }
  internal::Surface_location inner(const Location& location) const;
  internal::Surface_location inner_vertex(Vertex v) const;
  Location outer(const internal::Surface_location& location) const;
  Point_3 point(const internal::Surface_location& location) const;
  // Returns the vertices of a soup that were merged with others, in increasing order.
  const std::vector<Vertex>& merged_vertices() const { return m_data->merged_vertices; }
  internal::Index triangle(Face face) const { return m_data->triangle_of_face[face]; }
  Face face(internal::Index triangle) const { return m_data->faces[triangle]; }
  template <typename SpeedMap>
  std::vector<double> slowness(SpeedMap speed) const;
  template <typename FaceSpeedMap>
  std::vector<double> face_slowness(FaceSpeedMap speed) const;
  // Writes a value for each vertex to a property map. values maps an internal index to a value.
  template <typename Values, typename PropertyMap>
  void write(const Values& values, PropertyMap map) const
  {
    static_assert(internal::is_keyed_by<PropertyMap, Vertex>,
                  "An output map is a property map with vertices as keys. "
                  "CGAL::make_property_map() makes a map of a vector for vertices that "
                  "convert to indices.");
    using Value = typename boost::property_traits<PropertyMap>::value_type;
    static_assert(std::is_constructible_v<Value, decltype(values(internal::Index()))>,
                  "The values of an output map must be constructible from the results, for "
                  "example from double.");
    for(internal::Index i = 0; i < number_of_vertices(); ++i)
      put(map, m_data->vertices[i], static_cast<Value>(values(i)));
    for(const Vertex v : m_data->merged_vertices)
      put(map, v, static_cast<Value>(values(index(v))));
  }
  /// \endcond

protected:
  // For Soup_domain, which defines all members.
  Mesh_domain() = default;

  struct Data
  {
    explicit Data(const TriangleMesh& mesh) : index_of_vertex(mesh), triangle_of_face(mesh) {}
    // For Soup_domain: the indices of all points, and the triangles of all faces.
    Data(std::vector<internal::Index> indices, std::vector<internal::Index> triangles)
        : index_of_vertex(std::move(indices)), triangle_of_face(std::move(triangles))
    {}

    internal::Index_map<TriangleMesh, dynamic_vertex_property_t<internal::Index>> index_of_vertex;
    internal::Index_map<TriangleMesh, dynamic_face_property_t<internal::Index>> triangle_of_face;
    std::vector<Vertex> vertices; // #vertices
    std::vector<Face> faces;      // #triangles
    // Vertices of a soup that were merged, in increasing order. They have the index of the vertex
    // that replaces them.
    std::vector<Vertex> merged_vertices;
    // The minimum and maximum descriptors. The maps must not be read outside of these ranges.
    std::pair<Vertex, Vertex> vertex_range;
    std::pair<Face, Face> face_range;
  };
  // Sorts the vertices and faces, which are in the order of the caller, in the order of the arrays.
  void initialize(Data data, internal::Mesh_arrays arrays);

  const TriangleMesh* m_mesh = nullptr; // null if the surface is a soup
  std::shared_ptr<const internal::Lazy_mesh<TriangleMesh>> m_mesh_of_soup;
  std::shared_ptr<const internal::Surface_arrays> m_triangles;
  std::shared_ptr<const Data> m_data;

private:
  bool is_merged(Vertex v) const
  {
    return std::binary_search(m_data->merged_vertices.begin(), m_data->merged_vertices.end(), v);
  }
  template <typename Descriptor>
  static bool is_within(const Descriptor& descriptor,
                        const std::pair<Descriptor, Descriptor>& range)
  {
    return !(descriptor < range.first) && !(range.second < descriptor);
  }
  template <typename Descriptor, typename SpeedMap>
  static std::vector<double> slowness_at(const std::vector<Descriptor>& descriptors,
                                         const SpeedMap& speed)
  {
    std::vector<double> values;
    values.reserve(descriptors.size());
    for(const Descriptor& descriptor : descriptors)
      values.push_back(get(speed, descriptor));
    return internal::slowness_of(std::move(values));
  }
};

/// \cond INTERNAL

template <typename TriangleMesh>
template <typename NamedParameters>
Mesh_domain<TriangleMesh>::Mesh_domain(const TriangleMesh& mesh, const NamedParameters& np)
    : m_mesh(&mesh)
{
  using internal::Index;
  static_assert(!internal::has_parameter<NamedParameters, CGAL::internal_np::vertex_index_t> &&
                    !internal::has_parameter<NamedParameters, CGAL::internal_np::face_index_t>,
                "A domain numbers vertices and faces itself: it does not use index maps.");
  static_assert(!internal::has_parameter<NamedParameters, CGAL::internal_np::geom_traits_t>,
                "The kernel is that of the vertex point map: geom_traits is not used.");
  const auto points = internal::parameter(np, CGAL::internal_np::vertex_point,
                                          get_const_property_map(vertex_point, mesh));

  Data data(mesh);
  std::vector<std::array<double, 3>> coordinates;
  coordinates.reserve(num_vertices(mesh));
  data.vertices.reserve(num_vertices(mesh));
  for(const Vertex v : vertices(mesh))
  {
    const auto& point = get(points, v);
    data.index_of_vertex.set(v, static_cast<Index>(data.vertices.size()));
    data.vertices.push_back(v);
    coordinates.push_back(
        {CGAL::to_double(point[0]), CGAL::to_double(point[1]), CGAL::to_double(point[2])});
  }

  std::vector<Index> corners, twins;
  data.faces.reserve(num_faces(mesh));
  for(const Face face : faces(mesh))
  {
    data.triangle_of_face.set(face, static_cast<Index>(data.faces.size()));
    data.faces.push_back(face);
  }
  if(data.faces.size() > (std::size_t(1) << 31) / 3)
    throw Unsupported_surface_error("The mesh has more than 2^31 halfedges.");
  corners.reserve(3 * data.faces.size());
  twins.reserve(3 * data.faces.size());
  for(const Face read_face : data.faces)
  {
    auto h = halfedge(read_face, mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh))
    {
      corners.push_back(data.index_of_vertex[source(h, mesh)]);
      const auto twin = opposite(h, mesh);
      const Face twin_face = internal::face_of(twin, mesh);
      if(twin_face == Graph::null_face())
      {
        twins.push_back(internal::none);
        continue;
      }
      auto candidate = halfedge(twin_face, mesh);
      Index twin_index = 3 * data.triangle_of_face[twin_face];
      for(int k_twin = 0; candidate != twin && k_twin < 2; ++k_twin, ++twin_index)
        candidate = next(candidate, mesh);
      twins.push_back(twin_index);
    }
    if(h != halfedge(read_face, mesh))
      throw Unsupported_surface_error("A face of the mesh is not a triangle.");
  }
  initialize(std::move(data), internal::build_mesh_arrays(std::move(coordinates), corners, twins));
}

template <typename TriangleMesh>
void Mesh_domain<TriangleMesh>::initialize(Data data, internal::Mesh_arrays arrays)
{
  using internal::Index;
  const auto read_vertices = std::move(data.vertices);
  const auto read_faces = std::move(data.faces);
  data.vertices = {};
  data.faces = {};
  if(!read_vertices.empty())
  {
    const auto [first_descriptor, last_descriptor] =
        std::minmax_element(read_vertices.begin(), read_vertices.end());
    data.vertex_range = {*first_descriptor, *last_descriptor};
  }
  if(!read_faces.empty())
  {
    const auto [first_descriptor, last_descriptor] =
        std::minmax_element(read_faces.begin(), read_faces.end());
    data.face_range = {*first_descriptor, *last_descriptor};
  }

  data.vertices.reserve(read_vertices.size());
  for(const Index v : arrays.caller_vertex)
  {
    data.index_of_vertex.set(read_vertices[v], static_cast<Index>(data.vertices.size()));
    data.vertices.push_back(read_vertices[v]);
  }
  data.faces.reserve(read_faces.size());
  for(const Index face : arrays.face_of_triangle)
  {
    data.triangle_of_face.set(read_faces[face], static_cast<Index>(data.faces.size()));
    data.faces.push_back(read_faces[face]);
  }
  m_triangles = std::make_shared<const internal::Surface_arrays>(std::move(arrays.arrays));
  m_data = std::make_shared<const Data>(std::move(data));
}

template <typename TriangleMesh>
internal::Surface_location Mesh_domain<TriangleMesh>::inner_vertex(Vertex v) const
{
  if(v != Graph::null_vertex() && number_of_vertices() > 0 && is_within(v, m_data->vertex_range))
  {
    const internal::Index i = index(v);
    if(i < number_of_vertices() && (vertex(i) == v || is_merged(v)))
      return {internal::none, i, {}};
  }
  throw Invalid_argument_error("A vertex does not belong to the mesh.");
}

template <typename TriangleMesh>
internal::Surface_location Mesh_domain<TriangleMesh>::inner(const Location& location) const
{
  if(location.first == Graph::null_face())
    throw Invalid_argument_error("The face of a location is the null face.");
  const internal::Index f = m_data->faces.empty() || !is_within(location.first, m_data->face_range)
                                ? internal::none
                                : triangle(location.first);
  if(f >= m_data->faces.size() || face(f) != location.first)
    throw Invalid_argument_error("A face does not belong to the mesh.");
  return internal::checked(*m_triangles, {f, internal::none, location.second});
}

template <typename TriangleMesh>
typename Mesh_domain<TriangleMesh>::Location
Mesh_domain<TriangleMesh>::outer(const internal::Surface_location& location) const
{
  const internal::Surface_location in_triangle =
      location.triangle == internal::none ? internal::vertex_location(*m_triangles, location.vertex)
                                          : location;
  if(in_triangle.triangle == internal::none)
    return {Graph::null_face(), {0., 0., 0.}};
  return {face(in_triangle.triangle), in_triangle.barycentric};
}

template <typename TriangleMesh>
typename Mesh_domain<TriangleMesh>::Point_3
Mesh_domain<TriangleMesh>::point(const internal::Surface_location& location) const
{
  const auto p = internal::coordinates(*m_triangles, location);
  return Point_3(p[0], p[1], p[2]);
}

template <typename TriangleMesh>
template <typename SpeedMap>
std::vector<double> Mesh_domain<TriangleMesh>::slowness(SpeedMap speed) const
{
  return internal::mean_over_corners(*m_triangles, slowness_at(m_data->vertices, speed));
}

template <typename TriangleMesh>
template <typename FaceSpeedMap>
std::vector<double> Mesh_domain<TriangleMesh>::face_slowness(FaceSpeedMap speed) const
{
  return slowness_at(m_data->faces, speed);
}
/// \endcond

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_MESH_DOMAIN_H
