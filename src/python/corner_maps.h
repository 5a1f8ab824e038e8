// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_CORNER_MAPS_H
#define GEODESIC_PYTHON_CORNER_MAPS_H

#include "python/vectors.h"

namespace python {

// Texture coordinates of the corners of faces, as property maps of the halfedges that point to the
// corners. An array has the coordinates of the three corners of a face in a row, in the order of
// the corners in `Surface.faces`.

struct Corner
{
  std::size_t face, position;
};

inline Corner corner_of(const Mesh_domain& domain, Mesh::Halfedge_index h)
{
  const Mesh::Face_index face = domain.mesh().face(h);
  const auto corners = domain.corners(face);
  const std::size_t vertex(domain.mesh().target(h));
  std::size_t position = 0;
  while(position < 2 && corners[position] != vertex)
    ++position;
  return {std::size_t(face), position};
}

// A readable map.
class Corner_map
{
public:
  using key_type = Mesh::Halfedge_index;
  using value_type = UV;
  using reference = UV;
  using category = boost::readable_property_map_tag;

  Corner_map(const Mesh_domain& domain, const Numbers& numbers)
      : m_domain(&domain), m_numbers(&numbers)
  {}

  friend UV get(const Corner_map& map, key_type h)
  {
    const Corner corner = corner_of(*map.m_domain, h);
    return {(*map.m_numbers)(corner.face, 2 * corner.position),
            (*map.m_numbers)(corner.face, 2 * corner.position + 1)};
  }

private:
  const Mesh_domain* m_domain;
  const Numbers* m_numbers;
};

// A writable map.
class Corner_output_map
{
public:
  using key_type = Mesh::Halfedge_index;
  using value_type = UV;
  using reference = UV;
  using category = boost::writable_property_map_tag;

  Corner_output_map(const Mesh_domain& domain, double* data) : m_domain(&domain), m_data(data) {}

  friend void put(const Corner_output_map& map, key_type h, const UV& value)
  {
    const Corner corner = corner_of(*map.m_domain, h);
    double* const uv = map.m_data + 6 * corner.face + 2 * corner.position;
    uv[0] = value[0];
    uv[1] = value[1];
  }

private:
  const Mesh_domain* m_domain;
  double* m_data;
};

} // namespace python

#endif // GEODESIC_PYTHON_CORNER_MAPS_H
