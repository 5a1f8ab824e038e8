// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_GRAPH_SEARCH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_GRAPH_SEARCH_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/Vertex_queue.h>
#include <CGAL/Geodesic_processing/internal/surfels/vertex_regions.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_variants.h>

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
  Graph_search(const Proximity_graph& graph, const std::vector<Vec3>& point,
               const Vertex_regions* regions = nullptr);

  // The sites of the chain, both ends among them; none when they are not connected.
  std::vector<Index> operator()(Index from, Index to, Surfel_search method);

  // How many sites the last search has visited.
  std::size_t number_of_visited_vertices() const { return m_number_of_visited_vertices; }

private:
  struct Vertex
  {
    double distance;
    Index predecessor;
    Index stamp = 0; // the search that it belongs to, plus one when it is final
  };
  // A search from one end, in the direction of a goal when it has one.
  struct Frontier
  {
    std::vector<Vertex> vertices;
    Vertex_queue queue;
    const Vec3* goal = nullptr;
  };

  bool restrict_to_corridor(Index from, Index to);
  std::vector<Index> find(Index from, Index to, Surfel_search method);
  void set_waypoints(const std::vector<Index>& coarse_path, Index to);
  double heuristic(const Frontier& frontier, Index vertex) const;
  void initialize(Frontier& frontier, Index vertex, const Vec3* goal);
  void relax(Frontier& frontier, Index vertex, double distance, Index from);
  Index expand(Frontier& frontier);
  bool is_reached(const Frontier& frontier, Index vertex) const
  {
    return frontier.vertices[vertex].stamp >= m_stamp;
  }

  const Proximity_graph* m_graph;
  const std::vector<Vec3>* m_point;
  const Vertex_regions* m_regions;
  std::vector<Graph_search> m_coarse_search; // over the regions, if any
  std::vector<Index> m_corridor_stamp;       // #regions: the last search that has gone there
  bool m_is_restricted = false;              // whether this one goes to open regions alone
  bool m_is_guided = false;                  // and is led by the way through these
  std::vector<Index> m_waypoint_ahead; // #regions: the place of the way that an open one leads to
  std::vector<Vec3> m_waypoints;       // the leaders on the way, and the goal for the rest
  std::vector<double> m_remaining_length; // #places of the way: how far the goal is from there
  double m_heuristic_factor;              // of the rest of a chain, in distances in space
  std::array<Frontier, 2> m_frontiers;    // the second for searches from both ends
  Index m_stamp = 0;
  std::size_t m_number_of_visited_vertices = 0;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_GRAPH_SEARCH_H
