// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_BASE_MESH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_BASE_MESH_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/remeshing/remeshing.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A coarse triangulation of a mesh whose edges are paths on the mesh. The mesh is split along these
// paths; the result is the fine mesh. Each base triangle is the union of a set of its triangles.
struct Base_mesh
{
  bool is_finished = true; // false if the callback cancelled; then all arrays are empty
  // #base vertices: canonical locations on the mesh. A sample close to an edge or vertex is moved
  // onto it.
  std::vector<Surface_location> samples;
  std::vector<std::array<Index, 3>> triangles; // base vertices at the corners, counterclockwise
  std::vector<Index> twin;                     // 3 #triangles: the opposite halfedge, or none
  std::vector<Index> edge;                     // 3 #triangles: the edge of each halfedge
  std::vector<Index> halfedge;                 // #edges: the smaller one of its halfedges
  // #edges: the vertices of the fine mesh along the edge, in the direction of `halfedge`.
  std::vector<std::vector<Index>> path;
  std::vector<Index> vertex; // #base vertices: the vertex of the fine mesh

  Surface_arrays fine;       // the vertices of the mesh, followed by new ones; has points
  std::vector<Index> parent; // #triangles of `fine`: the triangle of the mesh that contains it
  std::vector<Index> region; // #triangles of `fine`: the base triangle that contains it
  // 3 #triangles of `fine`: the base edge that contains the halfedge, or none.
  std::vector<Index> edge_of_halfedge;
  // 3 #triangles of `fine`: the barycentric coordinates of each corner in `parent`.
  std::vector<std::array<double, 3>> barycentric;
};

// Traces the edges of a triangulation on a mesh, one after the other, and splits the mesh along
// them. Each path is the shortest one in its triangle strip. It is a local geodesic unless it
// touches the previous paths. A path keeps a distance of 1/200 of an edge from previous paths and
// from vertices. Paths therefore meet at samples only, in the cyclic order of the triangulation. A
// halfedge that connects two vertices of one path belongs to this path.
//
// The edges of a spanning tree are traced first. On a sphere, every other edge then has a path. If
// all edges are traced in their cyclic order, the regions are disks, because the triangulation has
// the Euler characteristic of the mesh. The disks are verified nevertheless.
//
// coarse      the mesh, with points
// samples     canonical, pairwise different locations; samples of features lie on their edges
// triangles   samples at the corners, counterclockwise; a surface with the topology of the mesh
// is_feature  3 #triangles of the mesh, equal for both halfedges of an edge: the boundary and other
//             edges that base edges must follow
//
// Returns nothing if there is no path for an edge between the previous ones. A short path can pass
// a handle on the wrong side. Also returns nothing if triangles are so thin that each path
// multiplies the number of triangles that the next ones cross: more than 150,000 + 10 (#triangles +
// #edges) triangles are not split again, and the searches visit at most 50 points per halfedge plus
// 1500 per base edge. Takes near-linear time in the size of the mesh and of the paths.
CGAL_GEODESIC_PROCESSING_EXPORT
std::optional<Base_mesh> build_base_mesh(const Surface_arrays& coarse,
                                         const std::vector<Surface_location>& samples,
                                         const std::vector<std::array<Index, 3>>& triangles,
                                         const std::vector<bool>& is_feature);

// Computes a remeshing and traces its edges. If there is no path for one of them, traces instead
// the edges of the dual triangulation before edge flips, on the refined surface. Each edge is then
// confined to the cells of its end vertices. These cells are disks that meet in an
// arc, so that a path exists.
//
// Throws `Unsupported_surface_error` if tracing fails nevertheless, because the limits of work are
// reached on thin triangles. Throws the exceptions of remesh().
CGAL_GEODESIC_PROCESSING_EXPORT
Base_mesh build_base_mesh(const std::shared_ptr<const Surface_arrays>& triangles,
                          const Remeshing_options& options);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_BASE_MESH_H
