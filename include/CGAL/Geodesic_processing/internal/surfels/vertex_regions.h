// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_VERTEX_REGIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_VERTEX_REGIONS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Sites grouped into regions of about 32 that chains of arcs connect, and the coarse graph of these.
struct Vertex_regions
{
  std::vector<Index> region; // #sites: that of the leader with the shortest chain to the site
  std::vector<Vec3> point;   // #regions: the leader
  // Between regions that touch; as long as the shortest chain over one arc between them that joins
  // their leaders.
  Proximity_graph graph;

  std::size_t size() const { return point.size(); }
};

// Each component of the graph has a leader for every 32 of its sites, in their order, and one for
// the rest.  O(n) where arcs join near sites, and the order is a locality order.
//
// graph      its arcs are as long as their sites are apart; component  #sites: labels below #sites
CGAL_GEODESIC_PROCESSING_EXPORT
Vertex_regions make_regions(const Proximity_graph& graph, const std::vector<Vec3>& point,
                            const std::vector<Index>& component);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_VERTEX_REGIONS_H
