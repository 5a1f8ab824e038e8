// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_GRAPH_SEARCH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_GRAPH_SEARCH_H

#include <CGAL/Geodesic_processing/internal/Glued_triangles.h>
#include <CGAL/Geodesic_processing/internal/Queue.h>
#include <CGAL/Geodesic_processing/internal/spatial.h>
#include <CGAL/Geodesic_processing/surfel_variants.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Shortest chains of arcs between two sites, one pair after the other; each search touches what it
// visits and nothing else.  The three methods find chains of one length, and the same chain where
// no other is as short.  About 40 bytes a site.
class CGAL_GEODESIC_PROCESSING_EXPORT Graph_search
{
public:
  // Both stay with the caller; a point for each site, no farther apart than their arc is long.
  Graph_search(const Site_graph& graph, const std::vector<Spatial>& point);

  // The sites of the chain, both ends among them; none when they are not connected.
  std::vector<Index> operator()(Index from, Index to, Surfel_search method);

  // How many sites the last search has visited.
  std::size_t visited() const { return m_visited; }

private:
  struct Site
  {
    double distance;
    Index from;
    Index run = 0; // the search that it belongs to, plus one when it is final
  };
  // A search from one end, in the direction of a goal when it has one.
  struct Side
  {
    std::vector<Site> sites;
    Queue queue;
    const Spatial* goal = nullptr;
  };

  void begin(Side& side, Index site, const Spatial* goal);
  void reach(Side& side, Index site, double distance, Index from);
  Index spread(Side& side);
  bool is_reached(const Side& side, Index site) const { return side.sites[site].run >= m_run; }

  const Site_graph* m_graph;
  const std::vector<Spatial>* m_point;
  std::array<Side, 2> m_sides; // the second for searches from both ends
  Index m_run = 0;
  std::size_t m_visited = 0;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_GRAPH_SEARCH_H
