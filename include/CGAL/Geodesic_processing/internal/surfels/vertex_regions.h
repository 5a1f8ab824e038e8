// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_VERTEX_REGIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_VERTEX_REGIONS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A partition of the vertices of a graph into connected regions of about 32 vertices, and the graph
// of the regions.
struct Vertex_regions
{
  std::vector<Index>
      region;              // #vertices: the region of the seed with the shortest path to the vertex
  std::vector<Vec3> point; // #regions: the position of the seed
  // Connects regions that are connected by an edge of the input. The length of an edge is the
  // minimum over these input edges of the length of the path between both seeds through the edge.
  Proximity_graph graph;

  std::size_t size() const { return point.size(); }
};

// Computes regions around seeds: in each component, every 32nd vertex in the order of the indices
// is a seed, beginning with the first.
//
// graph      symmetric; its lengths are ignored: an edge is as long as the distance of its points
// point      #vertices
// component  #vertices: labels of connected components below #vertices
//
// O(n) if edges are short and nearby vertices have similar indices.
CGAL_GEODESIC_PROCESSING_EXPORT
Vertex_regions make_regions(const Proximity_graph& graph, const std::vector<Vec3>& point,
                            const std::vector<Index>& component);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_VERTEX_REGIONS_H
