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

// Short paths between two locations, one pair after the other, without a distance field.
//
// A* (Hart, Nilsson and Raphael 1968) over the arcs, bounded below by the distance in space where
// the domain has points.  On meshes there are hops as well: straight lines from a site across one
// or two sides to the opposite site, unfolded.  What they gain is not the length, which
// straighten() finds, but the right strip of triangles to begin with: straightened, paths on scans
// of 10,000 to 500,000 vertices are 0.002 to 0.07 % longer than the shortest in the mean and 0.1 to
// 2 % at worst; along arcs alone three to seven times as much.
//
// A query touches what it visits and nothing else.  About 110 bytes a site; hops are found when
// they are first needed and kept.  Copies share the triangles and may run at the same time.
class CGAL_GEODESIC_PROCESSING_EXPORT Path_finder
{
public:
  explicit Path_finder(std::shared_ptr<const Surface_arrays> triangles);

  // Sharpens the lower bound by distances from `number` sites far from each other (Goldberg and
  // Harrelson 2005): on scans a query visits 2 to 4 times fewer sites.  Takes as many times as long
  // as a front over the whole domain, and 4 bytes a site.
  void add_landmarks(unsigned number_of_landmarks);

  // A chain of sites from one location to the other, with the points where hops cross sides;
  // consecutive locations are joined by an arc or lie in a common triangle.  One location when the
  // two are the same, none when they are not connected.  The path is not yet straight.
  std::vector<Surface_location> operator()(const Surface_location& from,
                                           const Surface_location& to);

  // How many sites the last search has visited.
  std::size_t number_of_visited_vertices() const { return m_number_of_visited_vertices; }

private:
  enum class Step : std::uint8_t
  {
    start,    // from the location itself
    edge,     // along a side, or an arc of a cloud
    across,   // over the opposite side of `corner`
    to_right, // and then over the side that leaves its right end
    to_left   // and then over the side that arrives at its left end
  };
  struct Vertex
  {
    double distance, heuristic; // from the begin, and at least to the end
    Index predecessor;          // the corner that the way came from; on a cloud, the site
    Index stamp = 0;            // the search that it belongs to, plus one when it is final
    Index goal_link;            // its place among the goals, or none
    Step step;
  };
  // The straight way between a location and a site near it.
  struct Link
  {
    Index vertex;
    double length;
    Surface_location crossing; // where it passes a side; triangle == none when it passes none
  };
  struct Shortcuts
  {
    float across = -1.f, to_right, to_left; // -1: not yet known; infinite: not straight
  };

  std::vector<Link> links(const Surface_location& location) const;
  const Shortcuts& shortcuts(Index corner);
  template <typename Function>
  void for_each_step(Index vertex, Function f);
  void expand(Index vertex);
  void relax(Index vertex, double distance, Index from, Step step);
  double heuristic(Index vertex) const;
  void compute_all_distances(Index vertex, std::vector<double>& distance);

  // Sets the lower bound of distances to the goal, and marks the vertices that are linked to it.
  void set_goal(const Surface_location& to, const std::vector<Link>& goal_links);
  // Returns the vertex before the goal on the shortest path found, or none if there is no path.
  Index search(const std::vector<Link>& start_links, const std::vector<Link>& goal_links);
  // Appends a location unless the path already ends there.
  void append_location(std::vector<Surface_location>& path, const Surface_location& location) const;
  // Appends the path from a vertex back to the first one, which is returned.
  Index append_predecessors(std::vector<Surface_location>& path, Index vertex) const;

  std::shared_ptr<const Surface_arrays> m_triangles;
  std::vector<Shortcuts> m_shortcuts; // #corners, on meshes
  std::vector<Vertex> m_vertices;
  Vertex_queue m_queue;
  unsigned m_number_of_landmarks = 0;
  std::vector<float> m_landmarks; // #sites times #landmarks: distances; NaN where not reached
  Index m_stamp = 0;
  std::size_t m_number_of_visited_vertices = 0;

  // Of the running search
  std::array<double, 3> m_goal_point;
  std::vector<std::array<double, 2>>
      m_goal_distance_range; // #landmarks: of the goal's distance from it
  bool m_uses_heuristic = false;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_FINDER_H
