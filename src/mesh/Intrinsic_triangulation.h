// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_INTRINSIC_TRIANGULATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_INTRINSIC_TRIANGULATION_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include "mesh/intrinsic_delaunay.h"

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A nearly intrinsic Delaunay triangulation of a mesh, without long edges on request, and the map
// from locations on the mesh to it.
//
// Both have the same metric. The vertices of the mesh come first; further vertices are midpoints
// of edges. A location is mapped by the flips and bisections in their order: each step that
// changes its triangle moves it to one of the two new triangles. Its weights stay nonnegative,
// because no areas are computed. Thus needles and triangles of area zero need no special case.
// (Fisher and others 2007, "An algorithm for the construction of intrinsic Delaunay
// triangulations", describe flips of meshes; locating points by the history of the flips is the
// method of Guibas, Knuth and Sharir 1992.)
class CGAL_GEODESIC_PROCESSING_EXPORT Intrinsic_triangulation
{
public:
  using Segment = std::pair<Surface_location, Surface_location>;

  // Flips and bisects the edges of a mesh, in time linear in the number of flips and O(k log k) for
  // k bisections. There are at most 1000 + 8 #halfedges flips; if this bound is reached, some
  // triangles stay thin.
  explicit Intrinsic_triangulation(const Surface_arrays& mesh,
                                   Bisected_edges bisected = Bisected_edges::none);

  // Returns whether no edge was flipped or bisected; then there are no triangles.
  bool is_empty() const { return m_steps.empty(); }
  // Returns the triangles. Two of them can have the same vertices, and one can have a vertex
  // twice.
  const std::shared_ptr<const Surface_arrays>& triangles() const { return m_triangles; }

  // Returns the canonical location in the triangulation of a canonical location on the mesh.
  // Requires that there are triangles.
  Surface_location locate(const Surface_location& location) const;
  // Returns the pieces of a segment between two locations in a triangle of the mesh, each in one
  // triangle of the triangulation. Their order is arbitrary.
  std::vector<Segment> locate_segment(Index triangle, const std::array<double, 3>& begin,
                                      const std::array<double, 3>& end) const;

  // An edge of the mesh, incident to a vertex of the mesh, that is not in the triangulation.
  struct Removed_edge
  {
    Index vertex; // at the far end
    double length;
  };
  // Returns the range of the removed edges of a vertex.
  std::pair<const Removed_edge*, const Removed_edge*> removed_edges(Index vertex) const
  {
    return {m_removed_edges.data() + m_removed_begin[vertex],
            m_removed_edges.data() + m_removed_begin[vertex + 1]};
  }
  const std::vector<Index>& vertices_with_removed_edges() const
  {
    return m_vertices_with_removed_edges;
  }

private:
  // A flip or a bisection, and the next step of each of its two new triangles, or none.
  struct Step
  {
    Edge_flip flip; // of a bisection: `twin` is the halfedge from the midpoint to b
    bool is_bisection;
    std::array<Index, 2> next; // of the triangle of flip.halfedge, and of that of flip.twin
  };
  // A triangle between two of its steps.
  struct Place
  {
    Index triangle;
    Index next_step;
  };

  void append(const std::vector<Edge_flip>& flips);
  void append(const std::vector<Bisection>& bisections);
  void link_steps(std::size_t number_of_triangles);
  void find_removed_edges(const Surface_arrays& mesh);
  Place first_place(Index triangle) const { return {triangle, m_first_step[triangle]}; }
  static double side(const Step& step, Index triangle, const std::array<double, 3>& weights);
  Place follow_flip(const Step& step, Index triangle, bool is_beyond,
                    std::array<double, 3>& weights) const;
  Place follow(const Place& place, bool is_beyond, std::array<double, 3>& weights) const;

  std::shared_ptr<const Surface_arrays> m_triangles;
  std::vector<Step> m_steps;
  std::vector<Index> m_first_step; // #triangles of the mesh; none if the triangle was not changed
  std::vector<Index> m_removed_begin; // #vertices of the mesh + 1: begin of the edges of each
  std::vector<Removed_edge> m_removed_edges;
  std::vector<Index> m_vertices_with_removed_edges;
};

// Returns the intrinsic triangulation of a mesh, computed once as long as any user holds the
// result. The mesh must not change afterwards. Thread-safe.
CGAL_GEODESIC_PROCESSING_EXPORT
std::shared_ptr<const Intrinsic_triangulation>
shared_intrinsic_triangulation(const Surface_arrays& mesh, Bisected_edges bisected);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_INTRINSIC_TRIANGULATION_H
