// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_STATE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_STATE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/Vertex_queue.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/distances/obtuse_splits.h>
#include <CGAL/Geodesic_processing/internal/distances/vertex_fans.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The rule by which a front crosses a triangle.
enum class Front_kind
{
  // Along edges only (Dijkstra 1959): an upper bound that does not converge under refinement.
  dijkstra,
  planar,    // as a straight line (Kimmel and Sethian 1998): first order, admits speeds
  euclidean, // as a circle around an unfolded source, whose direction each vertex stores
};

// The tentative or final values of a vertex.
struct Front_vertex
{
  double distance = infinity;
  // On a mesh with directions: the corner of this vertex in the triangle through which the front
  // arrived. Otherwise, and on a cloud: the predecessor, or none.
  Index corner = none;
  Index state = 0; // the flags of front_relaxation.h
};

// The data of a front: the results of the last query, and the variables of the running one. All
// distances are in the unit of the query, except those of previous queries.
//
// The update rules in src/distances are functions of this struct. Between two queries only the
// vertices in `reached` differ from their defaults.
struct Front_state
{
  // Returns true if vertices store the direction to their source. With speeds, a Euclidean front
  // is a planar one.
  bool has_directions() const { return kind == Front_kind::euclidean && !slowness; }
  // Returns true if the front crosses triangles as a straight line.
  bool is_planar() const { return kind != Front_kind::dijkstra && !has_directions(); }
  // Returns true if the front crosses triangles as a circle.
  bool is_circular() const { return has_directions() && !triangles->is_cloud(); }
  // Returns whether a vertex is one of the surface, not an inserted midpoint of an edge.
  bool is_on_surface(Index vertex) const { return vertex < surface->number_of_vertices(); }
  // Returns the offset of the source of a reached vertex.
  double offset_at(Index vertex) const
  {
    return has_single_source ? min_offset : offsets[sources[vertex]];
  }
  bool have_same_source(Index x, Index z) const
  {
    return has_single_source || sources[x] == sources[z];
  }
  double slowness_in(Index triangle) const { return slowness ? (*slowness)[triangle] : 1.; }
  // Returns whether a distance is shorter than the one known from previous queries.
  bool improves(Index vertex, double distance) const
  {
    return unit * distance < (*known_distance)[vertex];
  }

  std::shared_ptr<const Surface_arrays> surface; // locations and speeds refer to it
  // Of a Euclidean front on a mesh with needles, caps or long edges; otherwise null.
  std::shared_ptr<const Intrinsic_triangulation> intrinsic_triangulation;
  std::shared_ptr<const Obtuse_splits> splits; // of a front that was planar in any query
  std::shared_ptr<const Vertex_fans> fans;     // replace the splits after many planar queries
  // #corners: (cos, sin) of the angles, of a front with many circular queries
  std::shared_ptr<const std::vector<Vec2>> corner_angles;
  // Of a Euclidean front on a cloud: the edges of the proximity graph between different components
  // of triangles. Without vertices if there are none.
  std::shared_ptr<const Proximity_graph> component_edges;
  Front_kind kind = Front_kind::dijkstra;

  // Of the vertices of the surface and of those inserted by the intrinsic triangulation.
  std::vector<Front_vertex> vertices; // #vertices
  // #vertices, Euclidean fronts only: the unit vector to the source. On a mesh it is in the plane
  // of the triangle of the vertex's `corner`; the first axis is the halfedge that leaves this
  // corner. On a cloud it is in the tangent frame of the surfel.
  std::vector<Vec2> directions;
  std::vector<Index> sources;           // #vertices: position among the sources, or none
  std::vector<Index> reached;           // vertices of the surface, nearly in the order of distance
  std::vector<Index> reached_midpoints; // inserted vertices
  Vertex_queue queue;
  std::size_t number_invalidated = 0; // number of invalidations in the running query
  // The final vertices whose distance has decreased while the current vertex propagates.
  std::vector<Index> corrected_vertices;

  // Query
  // What the front propagates on: the surface, or its intrinsic triangulation. All corners and
  // halfedges of the results refer to these triangles.
  std::shared_ptr<const Surface_arrays> triangles;
  // #triangles; null if it is the same everywhere
  std::shared_ptr<const std::vector<double>> slowness;
  // The pieces of the sources by triangle, sorted by triangle.
  std::vector<std::pair<Index, Front_source>> source_pieces;
  std::vector<double> offsets; // #sources
  double unit = 1.; // of the distances: the slowness if it is the same everywhere, otherwise 1
  double min_offset = 0.;
  double max_distance = infinity;
  bool has_single_source = false;
  // Euclidean fronts only: the scaled coordinates of the only source, if it is a point and the
  // surface has coordinates. Then no distance is shorter than the straight line to it.
  std::optional<Vec3> point_source;
  const std::vector<double>* known_distance = nullptr; // #vertices; see Front_limits
  // Whether the current vertex improves its known distance. Otherwise it relaxes only vertices
  // whose known distance it improves.
  bool improves_known_distance = true;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_STATE_H
