// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_GRAPH_SEARCH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_GRAPH_SEARCH_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>
#include <CGAL/Geodesic_processing/internal/core/Queue.h>
#include <CGAL/Geodesic_processing/internal/surfels/site_regions.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include <CGAL/Geodesic_processing/surfel_variants.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Shortest chains of arcs between two sites, one pair after the other; each search touches what it
// visits and nothing else.  Three methods find chains of one length, and the same chain where no
// other is as short; from coarse to fine, chains are the shortest within the regions of a short
// chain of leaders and their neighbours, 0.3 % longer on average.  On long ways they follow that chain,
// 1 to 2 % longer.  About 20 bytes a site, or 40 from both ends.
class CGAL_GEODESIC_PROCESSING_EXPORT Graph_search
{
public:
  // All stay with the caller; a point for each site, no farther apart than their arc is long.
  // Without regions, searches from coarse to fine search the graph itself.
  Graph_search(const Site_graph& graph, const std::vector<Spatial>& point,
               const Site_regions* regions = nullptr);

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

  bool narrow(Index from, Index to);
  std::vector<Index> find(Index from, Index to, Surfel_search method);
  void lead(const std::vector<Index>& way, Index to);
  double remaining(const Side& side, Index site) const;
  void begin(Side& side, Index site, const Spatial* goal);
  void reach(Side& side, Index site, double distance, Index from);
  Index spread(Side& side);
  bool is_reached(const Side& side, Index site) const { return side.sites[site].run >= m_run; }

  const Site_graph* m_graph;
  const std::vector<Spatial>* m_point;
  const Site_regions* m_regions;
  std::vector<Graph_search> m_coarse; // over the regions, if any
  std::vector<Index> m_open;          // #regions: the last search that has gone there
  bool m_is_narrow = false;           // whether this one goes to open regions alone
  bool m_is_led = false;              // and is led by the way through these
  std::vector<Index> m_ahead;         // #regions: the place of the way that an open one leads to
  std::vector<Spatial> m_way;         // the leaders on the way, and the goal for the rest
  std::vector<double> m_rest;         // #places of the way: how far the goal is from there
  double m_bound;                     // of the rest of a chain, in distances in space
  std::array<Side, 2> m_sides;        // the second for searches from both ends
  Index m_run = 0;
  std::size_t m_visited = 0;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_GRAPH_SEARCH_H
