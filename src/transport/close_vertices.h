// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CLOSE_VERTICES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CLOSE_VERTICES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Disjoint sets of vertices, for example the exits of a region.
using Vertex_groups = std::vector<std::vector<Index>>;

// Replaces all vertices of a group by the first one, so that they share one unknown.
CGAL_GEODESIC_PROCESSING_EXPORT
void merge_vertices(Operators& operators, const Vertex_groups& groups);

// Adds the masses of a group at its first vertex.
CGAL_GEODESIC_PROCESSING_EXPORT
void merge_vertices(Vector& masses, const Vertex_groups& groups);

// Groups of vertices that are joined by tiny edges, which form a tree for each group. Its root is
// the first vertex. Parents precede their children.
struct Close_vertices
{
  Vertex_groups groups;
  std::vector<Index> parent;           // #vertices: none at roots and outside of groups
  std::vector<double> parent_distance; // #vertices: the length of the edge to the parent
};

// Finds the vertices that are joined by edges shorter than `max_length`. The longest edge of the
// surface has a length between 1 and 2. O(n)
CGAL_GEODESIC_PROCESSING_EXPORT
Close_vertices close_vertices(const Surface_arrays& triangles, double max_length);

// Merges close vertices in the operators without a metric of their triangles. Across tiny edges,
// differences of potentials are round-off errors, and the weights exceed those of other edges by
// many orders of magnitude.
//
// A triangle with two close corners becomes an edge: its gradients are those of a function on an
// interval, whose length is that of its shorter long edge. The area is arbitrary, since the cost of
// a mass that flows through the triangle is the mass times this length. A triangle with three close
// corners is skipped.
//
// Distances become shorter by at most the lengths of tiny edges on the path.
CGAL_GEODESIC_PROCESSING_EXPORT
void merge_close_vertices(const Surface_arrays& triangles, const Close_vertices& close,
                          Operators& operators);

// Returns the cost of moving masses along tiny edges. In each group, the sum of the masses is zero.
CGAL_GEODESIC_PROCESSING_EXPORT
double cost_between_close_vertices(const Close_vertices& close, Vector masses);

// Converts a flow of merged operators to one of the original operators: in a triangle that became
// an edge, it carries the same mass along this edge. The masses that it moves differ only by
// movements between close vertices.
CGAL_GEODESIC_PROCESSING_EXPORT
void separate_close_vertices(const Operators& merged, const Operators& original, Field& flow);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CLOSE_VERTICES_H
