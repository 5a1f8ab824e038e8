// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_INTRINSIC_DELAUNAY_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_INTRINSIC_DELAUNAY_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Adds the smallest constant to all lengths so that in every triangle the sum of two lengths
// exceeds the third by at least `slack` (Sharp and Crane 2020, section 4.5). The constant is zero
// if this holds already.
CGAL_GEODESIC_PROCESSING_EXPORT
void mollify(Surface_arrays& triangles, double slack);

// The sum of opposite angles exceeds pi by at most this if edges are flipped until the mesh is
// intrinsic Delaunay; many times the round-off error of a right angle.
inline constexpr double delaunay_tolerance = 1e-12;

// Returns whether flip_to_delaunay() flips no edge.
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_delaunay(const Surface_arrays& triangles, double tolerance = delaunay_tolerance);

// A flip of the edge ab of the triangles abc and bad to the edge cd.
struct Edge_flip
{
  Index halfedge, twin; // before: ab and ba. After: cd, followed by db and bc; dc, ca and ad
  double on_edge;       // position of the crossing on ab: 0 at a, 1 at b
  double on_diagonal;   // the same on cd: 0 at c, 1 at d
};

// Flips edges of a mesh until opposite angles sum to at most pi plus `tolerance`, which is less
// than pi / 2. With the default, the mesh is then intrinsic Delaunay, and no cotangent weight is
// negative. Changes corners, twins and lengths; the rings become invalid. Edges that have the same
// triangle at both halfedges are not flipped. Returns the flips in their order.
//
// Flips at most 1000 + max_flips_per_halfedge * #halfedges edges. If this bound is reached, the
// result is a triangulation of the same metric that is not Delaunay.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Edge_flip> flip_to_delaunay(Surface_arrays& triangles,
                                        double tolerance = delaunay_tolerance,
                                        std::size_t max_flips_per_halfedge = 100);

// A bisection of a triangle abc at the midpoint of its edge ab.
struct Bisection
{
  Index halfedge;     // before: ab. After: from a to the midpoint, in the triangle that keeps a
  Index new_triangle; // keeps b
};

// Bisects edges of a mesh that are longer than `max_length`, the longest first, until none is left
// or the number of vertices reaches `max_vertices`. Changes all arrays like flip_to_delaunay();
// the vertices of the midpoints are appended. Halfedges keep their places in their triangles: in
// the new triangle, the halfedge from the midpoint to b is in the place of ab. Edges that have the
// same triangle at both halfedges are kept. Returns the number of vertices, and appends the
// bisections in their order. (Rivara 1984: since only longest edges are bisected, angles stay
// bounded.)
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t bisect_long_edges(Surface_arrays& triangles, std::size_t number_of_vertices,
                              double max_length, std::size_t max_vertices,
                              std::vector<Bisection>& bisections);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_INTRINSIC_DELAUNAY_H
