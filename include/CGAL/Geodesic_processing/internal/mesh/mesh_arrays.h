// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_MESH_ARRAYS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_MESH_ARRAYS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The arrays of a mesh in Morton order, and the maps between the indices of the caller and the
// internal ones.
struct Mesh_arrays
{
  Surface_arrays arrays;
  std::vector<Index> internal_vertex; // #vertices of the caller
  std::vector<Index> caller_vertex;   // #vertices
  // #faces; the corners of a triangle are in the order of the face
  std::vector<Index> triangle_of_face;
  std::vector<Index> face_of_triangle; // #triangles
  // Triangles without area in double precision: a length is zero, or the longest is at least the
  // sum of the two others.
  std::size_t number_of_degenerate_triangles = 0;
};

// The numbers of fans in the one-rings of a mesh.
struct Ring_counts
{
  std::size_t number_of_fans = 0;
  std::size_t number_of_nonmanifold_vertices = 0; // with several fans
};

struct Mesh_counts
{
  Ring_counts rings;
  std::size_t number_of_components = 0; // of the triangles, joined by edges
};

// Builds the arrays of a mesh with given twins, for example from a halfedge data structure.
// Vertices are in Morton order, triangles in the order of their smallest vertex. Lengths are
// computed from scaled coordinates. An edge shorter than `min_edge_length` gets that length, so
// that vertices at the same point act as one.
//
// points: #vertices
// corners: 3 #faces, indices of points
// twins: 3 #faces, the opposite halfedge or none
//
// Throws Invalid_argument_error if a coordinate is not finite or if the distance of two points
// overflows. Throws Unsupported_surface_error if most edges of positive length are shorter than
// `min_edge_length`. O(n) time; about 150 bytes per vertex.
CGAL_GEODESIC_PROCESSING_EXPORT
Mesh_arrays build_mesh_arrays(std::vector<std::array<double, 3>> points,
                              const std::vector<Index>& corners, const std::vector<Index>& twins);

// Builds the same arrays without given twins, if each edge has one triangle, or two that have the
// same orientation. Otherwise returns nothing. This takes half of the time of finding the twins
// first, because vertices and triangles are sorted before. The result does not depend on the number
// of threads.
//
// Throws the exceptions of build_mesh_arrays().
CGAL_GEODESIC_PROCESSING_EXPORT
std::optional<Mesh_arrays> build_oriented_arrays(const std::vector<std::array<double, 3>>& points,
                                                 const std::vector<Index>& corners,
                                                 Mesh_counts& counts,
                                                 unsigned number_of_threads = 1);

// Computes the twins of a triangle soup. Two halfedges are twins if they join the same two
// vertices in opposite directions and no third halfedge joins these vertices. All other halfedges
// are boundary halfedges.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> twins_of_soup(std::size_t number_of_points, const std::vector<Index>& corners);

// Fills `ring_begin` and `ring` from `corner` and `twin`. The fan of a boundary vertex begins at
// the boundary, that of any other vertex at its first triangle.
CGAL_GEODESIC_PROCESSING_EXPORT
void build_rings(Surface_arrays& arrays, std::size_t number_of_vertices);

// Computes the connected components of the vertices, joined by edges of triangles and of the
// proximity graph. Returns the component of each vertex and the number of components.
CGAL_GEODESIC_PROCESSING_EXPORT
std::pair<std::vector<Index>, std::size_t> components(const Surface_arrays& arrays);

// Computes the same, joined by edges of triangles only. On a cloud these components can still be
// joined by edges of the proximity graph.
CGAL_GEODESIC_PROCESSING_EXPORT
std::pair<std::vector<Index>, std::size_t> triangle_components(const Surface_arrays& arrays);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_MESH_ARRAYS_H
