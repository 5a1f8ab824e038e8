// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_FINDER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_FINDER_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/Vertex_queue.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Finds short paths between pairs of locations without computing a distance field.
//
// The search is A* (Hart, Nilsson and Raphael 1968) on the graph of edges. If the surface has
// points, the lower bound is the Euclidean distance to the goal. On meshes, the graph also has
// shortcuts: straight segments from a vertex across one or two edges to the opposite vertex in the
// unfolded triangles. Shortcuts lead to a better strip of triangles, in which shorten_geodesic()
// then computes the shortest path. On scans of 10,000 to 500,000 vertices, the shortened paths are
// on average 0.002 to 0.07 % longer than exact shortest paths, and 0.1 to 2 % in the worst case.
// Without shortcuts, these errors are three to seven times larger.
//
// The cost of a query is that of the visited vertices, not of the surface. Memory: about 110 bytes
// per vertex. Shortcuts are computed when they are first used, and cached. Copies share the
// triangles; different copies can be used concurrently.
class CGAL_GEODESIC_PROCESSING_EXPORT Path_finder
{
public:
  explicit Path_finder(std::shared_ptr<const Surface_arrays> triangles);

  // Adds landmarks: vertices far from each other whose distances to all vertices are stored and
  // improve the lower bound (Goldberg and Harrelson 2005). On scans, a query then visits 2 to 4
  // times fewer vertices. Each landmark takes one Dijkstra search on the whole surface and 4 bytes
  // per vertex.
  void add_landmarks(unsigned number_of_landmarks);

  // Returns a path from one location to the other, which is not yet shortened. It consists of
  // vertices and of one point on each edge that a shortcut crosses. Consecutive locations are
  // joined by a graph edge or lie in a common triangle. Returns one location if both are the same
  // point, and an empty path if they are not connected.
  std::vector<Surface_location> operator()(const Surface_location& from,
                                           const Surface_location& to);

  // Returns the number of vertices that the last query visited.
  std::size_t number_of_visited_vertices() const { return m_number_of_visited_vertices; }

private:
  enum class Step : std::uint8_t
  {
    start,    // from the start location
    edge,     // along an edge
    across,   // across the edge opposite to the corner from which the step starts
    to_right, // across that edge and the next one at its right endpoint
    to_left   // across that edge and the next one at its left endpoint
  };
  struct Vertex
  {
    double distance, heuristic; // distance from the start; lower bound of that to the goal
    Index predecessor; // the corner from which the step starts (on a cloud, the vertex); for
                       //   Step::start, the index of the start link
    Index stamp = 0;   // the search that set the distance; one more if the vertex is finalized
    Index goal_link;   // index of the shortest goal link of this vertex, or `none`
    Step step;
  };
  // The straight segment between a location and a vertex near it.
  struct Link
  {
    Index vertex;
    double length;
    Surface_location crossing; // the point on the edge that is crossed; `triangle` is `none` if the
                               //   segment crosses no edge
  };
  struct Shortcuts
  {
    // The lengths of the shortcuts from a corner; infinite if the segment leaves its triangles.
    float across = -1.f, to_right, to_left; // across == -1: not yet computed
  };

  std::vector<Link> links(const Surface_location& location) const;
  const Shortcuts& shortcuts(Index corner);
  template <typename Function>
  void for_each_step(Index vertex, Function f);
  void expand(Index vertex);
  void relax(Index vertex, double distance, Index from, Step step);
  double heuristic(Index vertex) const;
  void compute_all_distances(Index vertex, std::vector<double>& distance);

  // Prepares the lower bounds of distances to the goal, and marks the vertices linked to it.
  void set_goal(const Surface_location& to, const std::vector<Link>& goal_links);
  // Runs A*.  Returns the last vertex before the goal on the path, or `none` if there is no path.
  Index search(const std::vector<Link>& start_links, const std::vector<Link>& goal_links);
  // Appends a location unless the path already ends there.
  void append_location(std::vector<Surface_location>& path, const Surface_location& location) const;
  // Appends the predecessors of a vertex to the path. Returns the first vertex after the start.
  Index append_predecessors(std::vector<Surface_location>& path, Index vertex) const;

  std::shared_ptr<const Surface_arrays> m_triangles;
  std::vector<Shortcuts> m_shortcuts; // #corners, on meshes
  std::vector<Vertex> m_vertices;
  Vertex_queue m_queue;
  unsigned m_number_of_landmarks = 0;
  std::vector<float> m_landmarks; // #vertices x #landmarks: distances; NaN if not reachable
  Index m_stamp = 0;
  std::size_t m_number_of_visited_vertices = 0;

  // State of the running search
  std::array<double, 3> m_goal_point;
  std::vector<std::array<double, 2>>
      m_goal_distance_range; // #landmarks: bounds of the distance from the landmark to the goal
  bool m_uses_heuristic = false;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_FINDER_H
