// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_IN_STRIP_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_IN_STRIP_H

#include "mesh/Split_mesh.h"

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A path between two vertices that touches no other vertex, given by the edges that it crosses.
struct Strip_path
{
  std::vector<Index> halfedges;  // each in the triangle that is left; empty if no edge is crossed
  std::vector<double> fractions; // #halfedges: the crossing points, from source to target
};

// Shortens a path between two vertices. The path keeps away from the endpoints of the edges that
// it crosses, by Split_mesh::min_split_fraction times the edge's length. Unlike
// shorten_geodesic(), it touches no vertex.
//
// The shortest path in the strip is computed by the funnel algorithm (Lee and Preparata 1984). The
// strip is rerouted around the other side of a vertex while that shortens the path (Xin and Wang
// 2007).
//
// is_barred  #vertices: whether the strip must not be rerouted around a vertex
// halfedges  the edges that the initial path crosses; loops are removed
//
// Complexity: the length of the strip times the number of reroutings. In strips of thousands of
// edges, the number of reroutings is limited.
CGAL_GEODESIC_PROCESSING_EXPORT
Strip_path shorten_in_strip(const Split_mesh& mesh, const std::vector<bool>& is_barred, Index from,
                            Index to, std::vector<Index> halfedges);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_IN_STRIP_H
