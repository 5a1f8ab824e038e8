// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_SPLIT_MESH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_SPLIT_MESH_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns the index of the coordinate that is largest in all corners of a subtriangle. Close to a
// corner of the triangle, this coordinate is one up to round-off errors, whereas the other two have
// small relative errors. Areas and orientations are therefore computed from the other two.
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t dominant_coordinate(const std::array<std::array<double, 3>, 3>& corner);

// Computes the coordinates of p with respect to a subtriangle. p and the corners of the subtriangle
// are given in barycentric coordinates of a triangle. If the subtriangle has no area, returns
// minus infinity.
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<double, 3> subtriangle_coordinates(const std::array<std::array<double, 3>, 3>& corner,
                                              const std::array<double, 3>& p);

// A copy of a mesh in which polylines are embedded as edges: edges and triangles are split at
// inserted vertices. A halfedge has the label of the polyline that contains it.
class CGAL_GEODESIC_PROCESSING_EXPORT Split_mesh
{
public:
  // New vertices keep this fraction of the length of an edge from its ends. A tenth of it makes
  // needles of 100 to 1 near vertices that paths pass; ten times as much makes visible kinks.
  static constexpr double min_split_fraction = 0.005;
  // The label of feature edges until they get another one.
  static constexpr Index curve_label = none - 1;

  // coarse: with points; must outlive this object
  // is_curve: #halfedges, the same for twins: whether the edge is a feature edge
  // A nonmanifold vertex is replaced by one vertex per fan of triangles.
  Split_mesh(const Surface_arrays& coarse, const std::vector<bool>& is_curve);

  // Returns the triangles, without lengths and rings.
  const Surface_arrays& triangles() const { return m_arrays; }
  // #halfedges: the polyline that contains each halfedge, or none
  const std::vector<Index>& labels() const { return m_label; }
  // #triangles: the coarse triangle that contains each triangle
  const std::vector<Index>& coarse_triangles() const { return m_coarse_triangle; }
  // #vertices: the canonical location of each vertex in the coarse mesh
  const std::vector<Surface_location>& locations() const { return m_location; }

  Index source(Index h) const { return m_arrays.corner[h]; }
  Index target(Index h) const { return m_arrays.corner[next_halfedge(h)]; }
  Index apex(Index h) const { return m_arrays.corner[previous_halfedge(h)]; }
  // Returns the halfedge with the smaller index of h and its twin.
  Index smaller_twin(Index h) const { return std::min(h, m_arrays.twin[h]); }
  double length(Index h) const { return distance_between(source(h), target(h)); }
  double distance_between(Index p, Index q) const
  {
    return norm(m_arrays.point[p] - m_arrays.point[q]);
  }
  // Computes the angle at a corner, in [0, pi].
  double angle_at(Index corner) const;
  // Returns the barycentric coordinates of a vertex in the coarse triangle that contains
  // `triangle`.
  std::array<double, 3> barycentric(Index triangle, Index vertex) const;

  // Returns the corners of a vertex in counterclockwise order, beginning at the boundary if there
  // is one.
  std::vector<Index> corners_around(Index vertex) const;
  // Returns one halfedge of each edge that is incident to a vertex.
  std::vector<Index> halfedges_around(Index vertex) const;

  // Sets the label of a halfedge and its twin.
  void set_label(Index h, Index label);

  // Inserts a vertex p on the edge uv = h of the triangles uvw and vux and returns it. The
  // triangles become upw and vpx; the new triangles pvw and pux get the next two indices.
  Index split_edge(Index h, double fraction);

  // Returns a vertex for a sample: a vertex close to it, or a new one. Snapping never moves a
  // sample onto a polyline or across it. Each sample gets a vertex of its own.
  Index insert(const Surface_location& sample);

private:
  using Barycentric = std::array<double, 3>;

  void split_nonmanifold_vertices();
  bool is_on_curve(Index vertex) const;
  bool is_sample(Index vertex) const { return vertex < m_is_sample.size() && m_is_sample[vertex]; }
  Index mark_sample(Index vertex);
  void set_twins(Index h, Index twin);
  Index add_vertex(const Vec3& point, const Surface_location& location);
  Index add_triangle(Index coarse_triangle);
  void move_halfedge(Index from, Index to);
  Index split_halfedge(Index h, Index p);
  Index split_triangle(Index f, const Barycentric& b);
  Barycentric coordinates_in_subtriangle(Index f, const Barycentric& b) const;

  const Surface_arrays& m_coarse;
  Surface_arrays m_arrays;
  std::vector<Index> m_label; // #halfedges: the polyline that contains it, or none
  std::vector<Index> m_coarse_triangle;
  std::vector<Surface_location> m_location;
  std::vector<Index> m_corner_of; // #vertices: one of its corners, or none
  std::vector<bool> m_is_sample;
  // the new triangles in each coarse triangle, without the triangle with its index
  std::map<Index, std::vector<Index>> m_subtriangles;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_SPLIT_MESH_H
