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

// A coarse triangulation of a mesh whose edges are drawn on it: each triangle of the base is exactly a
// set of triangles of the fine mesh, which is the mesh divided along these edges.
struct Base_mesh
{
  bool is_finished = true; // else there is nothing: a callback cancelled it
  // The base vertices, clean: samples, of which those next to a side or a site have gone there.
  std::vector<Surface_location> samples;
  std::vector<std::array<Index, 3>> triangles; // of base vertices, counterclockwise
  std::vector<Index> twin;                     // 3 #triangles: the opposite side, or none
  std::vector<Index> edge;                     // 3 #triangles: which edge each side is
  std::vector<Index> halfedge;                 // #edges: the first of its sides
  std::vector<std::vector<Index>> path; // #edges: the fine mesh's sites along it, as `side` runs
  std::vector<Index> vertex;            // #base vertices: where they are in the fine mesh

  Surface_arrays fine;       // the mesh's sites, and then new ones; with points
  std::vector<Index> parent; // #triangles of `fine`: the triangle of the mesh it is a part of
  std::vector<Index> region; // #triangles of `fine`: the triangle of the base
  std::vector<Index> edge_of_halfedge; // #sides of `fine`: the edge that it is a part of, or none
  std::vector<std::array<double, 3>> barycentric; // 3 #triangles of `fine`: of corners, in `whole`
};

// Draws the edges of a triangulation on a mesh, one after the other: each is the shortest in its strip of
// triangles, and locally shortest as far as those before are not in its way, which it keeps off by a
// two-hundredth of a side.  So it does with sites: edges meet at samples and nowhere else, in the order
// of the base.  No side but those on edges joins two sites of one edge.
//
// Edges that form a spanning tree come first: then on a sphere there is a way for each of the others.
// Where all edges have been drawn, in their order around samples, the regions are discs, as the base has
// the mesh's Euler characteristic; that is checked all the same.
//
// coarse     with points
// samples    of the base, clean, at different places; those on curves lie on their sides
// triangles  of samples, counterclockwise: a surface with the topology of the mesh
// is_feature   #sides of the mesh, twins alike: the border, and what else base edges are to follow
//
// Nothing where an edge finds no way between those before it, as a short path can lead around the wrong
// side of a handle, or where triangles are so thin that each edge makes the next ones cross many more of
// them.
// Near-linear in the size of the mesh and the paths.
CGAL_GEODESIC_PROCESSING_EXPORT
std::optional<Base_mesh> build_base_mesh(const Surface_arrays& coarse,
                                         const std::vector<Surface_location>& samples,
                                         const std::vector<std::array<Index, 3>>& triangles,
                                         const std::vector<bool>& is_feature);

// The same for the samples and triangles of a remeshing.  Where these edges find no way, it has those
// between cells before any was flipped, and each is drawn within the cells of its ends on the finer
// surface whose sites tell them apart: as cells are discs that meet in arcs, there is room for all.
//
// Throws Unsupported_surface_error where even so one finds no way, which nothing is known to cause, and
// what remeshing() throws.
CGAL_GEODESIC_PROCESSING_EXPORT
Base_mesh build_base_mesh(const std::shared_ptr<const Surface_arrays>& triangles,
                          const Remeshing_options& options);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_BASE_MESH_H
