// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_SURFACE_ARRAYS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_SURFACE_ARRAYS_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A graph of vertices 0..n-1 in compressed rows. The edges that leave vertex v have the indices
// begin[v], ..., begin[v + 1] - 1.
struct Proximity_graph
{
  std::vector<Index> begin;  // #vertices + 1
  std::vector<Index> target; // #edges
  // #edges, finite, not negative; if empty: the distance between the ends
  std::vector<double> length;
};

// Minimum length of an edge, for surfaces whose extent is about one. Shorter edges are set to it:
// across an edge of length zero no direction is defined. Far below every tolerance of distances,
// far above the round-off errors of coordinates.
inline constexpr double min_edge_length = 0x1p-36;

struct Vertex_fans;
struct Obtuse_splits;
class Intrinsic_triangulation;

// The edges of a mesh that an intrinsic triangulation bisects.
enum class Bisected_edges
{
  none,
  long_edges, // much longer than edges of equilateral triangles
};

// What all fronts on the same arrays share, as long as one of these fronts exists; see
// vertex_fans.h, obtuse_splits.h and Intrinsic_triangulation.h. A copy of the arrays starts without
// it, because its lengths may be changed.
struct Shared_structures
{
  Shared_structures() = default;
  Shared_structures(const Shared_structures&) {}
  Shared_structures& operator=(const Shared_structures&)
  {
    vertex_fans = {};
    corner_angles = {};
    obtuse_splits = {};
    intrinsic_triangulations = {};
    return *this;
  }

  std::mutex mutex;
  std::weak_ptr<const Vertex_fans> vertex_fans;
  std::weak_ptr<const std::vector<std::array<double, 2>>> corner_angles;
  std::weak_ptr<const Obtuse_splits> obtuse_splits;
  // Without and with bisected edges.
  std::array<std::weak_ptr<const Intrinsic_triangulation>, 2> intrinsic_triangulations;
};

// The connectivity and the edge lengths of a triangle mesh or of the triangles of a surfel cloud.
// Intrinsic algorithms need nothing else.
//
// Mesh: a halfedge has at most one twin, corners are in counterclockwise order around each vertex,
// and the proximity graph is empty because the edges of the mesh replace it.
//
// Surfel cloud: triangles overlap and have weights, an edge can belong to more than two triangles,
// and there are no twins.
struct Surface_arrays
{
  std::vector<Index> corner;  // 3 #triangles: the vertex of each corner
  std::vector<Index> twin;    // 3 #triangles: the opposite halfedge or none; empty for a cloud
  std::vector<double> length; // 3 #triangles: of each halfedge; for a mesh the maximum is in [1, 2)
  std::vector<Index> ring_begin; // #vertices + 1: begin of the corners of each vertex in `ring`
  // 3 #triangles: the corners of each vertex. On a mesh the corners of a fan are in
  // counterclockwise order; the fans of a nonmanifold vertex follow each other
  std::vector<Index> ring;
  // #triangles, in (0, 1]; empty for a mesh, whose triangles have weight 1
  std::vector<float> weight;
  Proximity_graph graph;                     // between surfels, without lengths; empty for a mesh
  std::vector<std::array<double, 3>> point;  // #vertices: scaled coordinates; may be empty
  std::vector<std::array<double, 3>> normal; // #vertices: unit normals; empty for a mesh

  // Lengths in the unit of the caller are divided by this power of two.
  double scale = 1.;
  std::array<double, 3> origin = {0., 0., 0.}; // coordinates of the caller = origin + scale * point

  // Of the construction of shared structures, whose content does not depend on it.
  unsigned number_of_threads = 1;
  mutable Shared_structures shared;

  std::size_t number_of_vertices() const { return ring_begin.empty() ? 0 : ring_begin.size() - 1; }
  std::size_t number_of_triangles() const { return corner.size() / 3; }
  bool is_cloud() const { return !graph.begin.empty(); }
};

// A location on a mesh or cloud: a point of a triangle, or, if `triangle` is none, a vertex. A
// vertex without triangles can only be given as a vertex. The barycentric coordinates are in the
// order of the corners and sum to one.
struct Surface_location
{
  Index triangle = none;
  Index vertex = none;
  std::array<double, 3> barycentric = {1., 0., 0.};
};

// A source of a front: a polyline of one or more locations. Consecutive locations must be in a
// common triangle.
struct Front_source
{
  std::vector<Surface_location> polyline; // a single location is a point source
  double offset = 0.;                     // distance at the source, in scaled units
  Index label = 0;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_SURFACE_ARRAYS_H
