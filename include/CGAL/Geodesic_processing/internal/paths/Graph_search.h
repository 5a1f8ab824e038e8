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

// Finds shortest paths in a proximity graph between pairs of vertices.
//
// Dijkstra's algorithm, bidirectional search and A* return shortest paths. These paths are the
// same if the shortest path is unique. The coarse-to-fine search returns the shortest path in a
// corridor: the regions on a path in the coarse graph and their neighbors. It is on average 0.3 %
// longer. If the coarse path is long, the search is guided along it, and the result is 1 to 2 %
// longer.
//
// The cost of a search is that of the visited vertices. Memory: about 20 bytes per vertex, or 40
// after a bidirectional search.
class CGAL_GEODESIC_PROCESSING_EXPORT Graph_search
{
public:
  // Keeps references to the arguments.
  //
  // point    #vertices: the Euclidean length of an edge is at most its length in the graph
  // regions  optional; without it, coarse-to-fine searches are A* searches
  Graph_search(const Proximity_graph& graph, const std::vector<Vec3>& point,
               const Vertex_regions* regions = nullptr);

  // Returns the vertices of the path, including both endpoints. Returns an empty path if the
  // endpoints are not connected.
  std::vector<Index> operator()(Index from, Index to, Surfel_search method);

  // Returns the number of vertices that the last search visited.
  std::size_t number_of_visited_vertices() const { return m_number_of_visited_vertices; }

private:
  struct Vertex
  {
    double distance;
    Index predecessor;
    Index stamp = 0; // the search that set the distance; one more if the vertex is finalized
  };
  // The state of a search from one endpoint; of A* if it has a goal.
  struct Frontier
  {
    std::vector<Vertex> vertices;
    Vertex_queue queue;
    const Vec3* goal = nullptr;
  };

  bool restrict_to_corridor(Index from, Index to);
  std::vector<Index> find(Index from, Index to, Surfel_search method);
  std::vector<Index> find_bidirectional(Index from, Index to);
  std::vector<Index> path_to(const Frontier& frontier, Index vertex) const;
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
  std::vector<Graph_search> m_coarse_search; // one search in the graph of regions, if there are any
  std::vector<Index> m_corridor_stamp;       // #regions: the last search with it in the corridor
  bool m_is_restricted = false;              // whether the search is restricted to the corridor
  bool m_is_guided = false;                  // whether waypoints define the heuristic
  std::vector<Index> m_waypoint_ahead;       // #regions: the waypoint to which a region is guided
  std::vector<Vec3> m_waypoints;             // leaders on the coarse path, then copies of the goal
  std::vector<double> m_remaining_length;    // #waypoints: length of the way from it to the goal
  double m_heuristic_factor;                 // of the Euclidean distance to the goal
  std::array<Frontier, 2> m_frontiers;       // the second one for bidirectional searches
  Index m_stamp = 0;
  std::size_t m_number_of_visited_vertices = 0;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_GRAPH_SEARCH_H
