// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_MESH_ARRAYS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_MESH_ARRAYS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Triangles renumbered for locality, and the way back to the caller's numbers.
struct Mesh_arrays
{
  Surface_arrays arrays;
  std::vector<Index> internal_vertex;  // #vertices
  std::vector<Index> caller_vertex;    // #sites
  std::vector<Index> triangle_of_face; // #faces; corners keep the order that they had in the face
  std::vector<Index> face_of_triangle; // #triangles
  // Without area in double precision: a side of length zero, or one not shorter than the two others
  // together.
  std::size_t number_of_degenerate_triangles = 0;
};

// Glues triangles whose twins are known (as a half-edge structure knows them): sites in Morton
// order, triangles in the order of their first site, lengths from scaled coordinates.
// Sides shorter than 2^-36 (1.5e-11) of the size of the whole get that length, so that sites at one
// point act as one.
//
// points  #vertices; corners  3 #faces, indices of points; twins  3 #faces, opposite side or none.
// Throws Invalid_argument_error when a coordinate is not finite, or two of them are so far apart
// that their distance overflows.  O(n); about 150 bytes per vertex.
CGAL_GEODESIC_PROCESSING_EXPORT
Mesh_arrays build_mesh_arrays(std::vector<std::array<double, 3>> points,
                              const std::vector<Index>& corners, const std::vector<Index>& twins);

// The same for a triangle soup, whose sides are glued where exactly two opposite ones join the same
// two vertices; sides that no such pair claims stay on the border.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> twins_of_soup(std::size_t number_of_points, const std::vector<Index>& corners);

// Fills `first` and `star` of triangles that are glued.  A fan starts at its border where it has one, else at
// its first triangle.
CGAL_GEODESIC_PROCESSING_EXPORT
void build_rings(Surface_arrays& arrays, std::size_t number_of_vertices);

// Components of the sites, joined by sides and arcs: a label for each site, and how many there are.
CGAL_GEODESIC_PROCESSING_EXPORT
std::pair<std::vector<Index>, std::size_t> components(const Surface_arrays& arrays);

// The same with sides alone: the islands of a cloud, between which only arcs lead.
CGAL_GEODESIC_PROCESSING_EXPORT
std::pair<std::vector<Index>, std::size_t> triangle_components(const Surface_arrays& arrays);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_MESH_ARRAYS_H
