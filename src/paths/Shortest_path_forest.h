// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEST_PATH_FOREST_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEST_PATH_FOREST_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/Vertex_queue.h>
#include "paths/fans.h"

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The shortest paths along edges from one fan of each component, or from one fan only. Components
// are joined across edges.
class CGAL_GEODESIC_PROCESSING_EXPORT Shortest_path_forest
{
public:
  // root: a fan, or none for one fan of each component
  Shortest_path_forest(const Surface_arrays& triangles, Fans fans, Index root = none);

  const Fans& fans() const { return m_fans; }
  // Returns the length of the path from the root to a fan; infinite if there is none.
  double distance(Index fan) const { return m_distance[fan]; }
  // Returns the length of the loop from the root that an edge closes.
  double loop_length(Index h) const
  {
    return m_distance[origin(h)] + t.length[h] + m_distance[target(h)];
  }
  // Returns whether a halfedge or its twin is in the forest.
  bool contains(Index h) const;

  // Returns the loop that an edge closes, without the part that is passed in both directions.
  // Consecutive locations, also the last and the first one, lie in a common triangle. If several
  // edges join two vertices, the midpoint of the edge is a location of the loop, too.
  std::vector<Surface_location> loop(Index h) const;
  // Returns the same loop from the root to itself.
  std::vector<Surface_location> loop_from_root(Index h) const;

private:
  Index origin(Index h) const { return m_fans.fan[h]; }
  Index target(Index h) const { return m_fans.fan[next_halfedge(h)]; }
  Index other_end(Index h, Index fan) const { return origin(h) == fan ? target(h) : origin(h); }
  void grow(Index root, Vertex_queue& queue); // the queue is empty
  std::vector<Index> edges_from_root(Index fan) const;
  Index add_edge(Index h, Index from, std::vector<Surface_location>& path) const;

  const Surface_arrays& t;
  Fans m_fans;
  std::vector<double> m_distance; // #fans: from the root
  std::vector<Index> m_parent;    // #fans: the last halfedge, of either direction; none at roots
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEST_PATH_FOREST_H
