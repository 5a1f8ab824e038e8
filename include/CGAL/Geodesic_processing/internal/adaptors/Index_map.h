// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_INDEX_MAP_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_INDEX_MAP_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>

#include <CGAL/Surface_mesh/Surface_mesh.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A map from the descriptors of vertices or faces of a mesh to indices.
//
// DynamicProperty: dynamic_vertex_property_t<Index> or dynamic_face_property_t<Index>
template <typename Mesh, typename DynamicProperty>
class Index_map
{
  using Map = typename boost::property_map<Mesh, DynamicProperty>::const_type;

public:
  explicit Index_map(const Mesh& mesh) : m_map(get(DynamicProperty(), mesh)) {}

  template <typename Descriptor>
  Index operator[](const Descriptor& descriptor) const
  {
    return get(m_map, descriptor);
  }
  template <typename Descriptor>
  void set(const Descriptor& descriptor, Index index)
  {
    put(m_map, descriptor, index);
  }

private:
  Map m_map;
};

// The descriptors of a Surface_mesh are positions in an array of indices. So the mesh of a soup
// need not exist.
template <typename Point, typename DynamicProperty>
class Index_map<Surface_mesh<Point>, DynamicProperty>
{
public:
  explicit Index_map(std::vector<Index> index) : m_index(std::move(index)) {}
  explicit Index_map(const Surface_mesh<Point>& mesh) : m_index(size(mesh, DynamicProperty())) {}

  template <typename Descriptor>
  Index operator[](const Descriptor& descriptor) const
  {
    return m_index[std::size_t(descriptor)];
  }
  template <typename Descriptor>
  void set(const Descriptor& descriptor, Index index)
  {
    m_index[std::size_t(descriptor)] = index;
  }

private:
  // The numbers include removed vertices and faces.
  static std::size_t size(const Surface_mesh<Point>& mesh, dynamic_vertex_property_t<Index>)
  {
    return mesh.num_vertices();
  }
  static std::size_t size(const Surface_mesh<Point>& mesh, dynamic_face_property_t<Index>)
  {
    return mesh.num_faces();
  }

  std::vector<Index> m_index;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_INDEX_MAP_H
