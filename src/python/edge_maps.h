// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_EDGE_MAPS_H
#define GEODESIC_PYTHON_EDGE_MAPS_H

#include "python/Mesh_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace python {

// Edges of a mesh that a remeshing keeps, and the spacing of samples along them.
class Constrained_edges
{
public:
  // edges    None, or one row for each edge: its vertices
  // spacing  None, or one number for each row; 0 stands for the common spacing
  //
  // Throws Invalid_argument_error if an array has another shape, if a spacing is negative or not
  // finite, or if two vertices are not connected by an edge. O(n log k) for k edges.
  Constrained_edges(const Mesh_surface& surface, const py::object& edges, const py::object& spacing)
  {
    if(edges.is_none())
    {
      if(!spacing.is_none())
        reject("edge_spacing needs constrained_edges.");
      return;
    }
    std::vector<Row> rows = rows_of(surface, edges, spacing);
    Computation().run([&] { assign(surface.domain().mesh(), rows); });
  }

  // Property maps of edges. They refer to this object.
  struct Is_constrained_map
  {
    using key_type = Mesh::Edge_index;
    using value_type = bool;
    using reference = bool;
    using category = boost::readable_property_map_tag;

    const std::vector<double>* spacing;

    friend bool get(const Is_constrained_map& map, key_type edge)
    {
      return (*map.spacing)[edge] >= 0.; // the others are not constrained
    }
  };
  struct Spacing_map
  {
    using key_type = Mesh::Edge_index;
    using value_type = double;
    using reference = double;
    using category = boost::readable_property_map_tag;

    const std::vector<double>* spacing;

    friend double get(const Spacing_map& map, key_type edge)
    {
      return std::max(0., (*map.spacing)[edge]);
    }
  };
  // They are empty if no edges are given.
  std::optional<Is_constrained_map> is_constrained_map() const
  {
    return m_spacing.empty() ? std::nullopt : std::optional(Is_constrained_map{&m_spacing});
  }
  std::optional<Spacing_map> spacing_map() const
  {
    return m_spacing.empty() ? std::nullopt : std::optional(Spacing_map{&m_spacing});
  }

private:
  struct Row
  {
    std::array<std::size_t, 2> vertices; // in increasing order
    double spacing;
    bool is_edge = false; // whether the mesh has such an edge

    friend bool operator<(const Row& a, const Row& b) { return a.vertices < b.vertices; }
  };

  static std::vector<Row> rows_of(const Mesh_surface& surface, const py::object& edges,
                                  const py::object& spacing)
  {
    const Integers ends(edges, "constrained_edges", {any, 2});
    std::optional<Numbers> spacings;
    if(!spacing.is_none())
      spacings.emplace(spacing, "edge_spacing", Shape{py::ssize_t(ends.size())});
    std::vector<Row> result;
    for(std::size_t i = 0; i < ends.size(); ++i)
    {
      Row row = {{}, spacings ? (*spacings)(i) : 0.};
      for(std::size_t k = 0; k < 2; ++k)
        row.vertices[k] = checked_index(ends(i, k), "vertex", surface.number_of_points());
      std::sort(row.vertices.begin(), row.vertices.end());
      if(!(row.spacing >= 0.) || !std::isfinite(row.spacing))
        reject("edge_spacing has a number that is negative or not finite.");
      result.push_back(row);
    }
    return result;
  }

  // A mesh can have several edges between two vertices: it is split where it is not a manifold.
  void assign(const Mesh& mesh, std::vector<Row>& rows)
  {
    std::sort(rows.begin(), rows.end());
    m_spacing.assign(mesh.number_of_edges(), -1.);
    for(const Mesh::Edge_index edge : mesh.edges())
    {
      Row key = {{std::size_t(mesh.vertex(edge, 0)), std::size_t(mesh.vertex(edge, 1))}, 0.};
      std::sort(key.vertices.begin(), key.vertices.end());
      const auto [begin, end] = std::equal_range(rows.begin(), rows.end(), key);
      for(auto row = begin; row != end; ++row)
      {
        row->is_edge = true;
        m_spacing[edge] = row->spacing;
      }
    }
    for(const Row& row : rows)
      if(!row.is_edge)
        reject("The vertices " + std::to_string(row.vertices[0]) + " and " +
               std::to_string(row.vertices[1]) + " are not connected by an edge.");
  }

  std::vector<double> m_spacing; // #edges: -1 if it is not constrained; empty if none is given
};

} // namespace python

#endif // GEODESIC_PYTHON_EDGE_MAPS_H
