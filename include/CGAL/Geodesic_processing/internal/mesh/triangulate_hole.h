// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_TRIANGULATE_HOLE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_TRIANGULATE_HOLE_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A boundary cycle that visits each vertex once. Its direction is counterclockwise around the
// hole, seen from outside, like that of a face which fills it.
struct Hole_boundary
{
  std::vector<std::array<double, 3>> points; // #vertices
  // #vertices: the third corner of the triangle at the edge from point i to point i + 1
  std::vector<std::array<double, 3>> apexes;
  // Pairs of vertices, not adjacent on the boundary, that have an edge already, in both orders and
  // sorted. Triangles must not have these edges.
  std::vector<std::array<Index, 2>> edges;
};

// Positions on the boundary, counterclockwise. n - 2 triangles fill a hole of n edges.
using Hole_triangles = std::vector<std::array<Index, 3>>;

// Returns the triangles if they are not degenerate in space and have none of the existing edges;
// otherwise returns an empty vector.
CGAL_GEODESIC_PROCESSING_EXPORT
Hole_triangles checked_triangles(const Hole_boundary& hole, Hole_triangles triangles);

// Triangulates a hole. The triangles minimize the largest dihedral angle first and the area
// second (Liepa, Filling Holes in Meshes, 2003). Returns an empty vector if the triangles would be
// degenerate or have an existing edge, or if the search takes too long.
//
// Up to 200 edges, the search considers all triangulations, in cubic time. Up to 1,000 edges it
// considers a projection to a plane and the three-dimensional Delaunay triangulation, up to 5,000
// edges only the projection.
//
// steps_left: steps of about 0.1 microseconds, reduced by those that the search takes. If none are
// left, only the projection is considered.
CGAL_GEODESIC_PROCESSING_EXPORT
Hole_triangles triangulate_hole(const Hole_boundary& hole, double& steps_left);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_TRIANGULATE_HOLE_H
