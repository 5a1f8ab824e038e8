// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_SECOND_PATH_SEARCH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_SECOND_PATH_SEARCH_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_state.h>

#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Searches for a second locally shortest path between two locations, by all straight lines that
// may be part of a path of at most this length.
//
// In contrast to window propagation, windows do not cut off each other: a path is also found if
// parts of it are not shortest paths between their ends. Distances from `to` bound the search.
class CGAL_GEODESIC_PROCESSING_EXPORT Second_path_search
{
public:
  // Returns a lower bound of the distance from a vertex to `to`.
  using Lower_bound = std::function<double(Index vertex)>;

  // The pseudo-sources are those of find_pseudo_sources(). The locations are canonical.
  Second_path_search(std::shared_ptr<const Surface_arrays> triangles,
                     std::shared_ptr<const std::vector<bool>> is_pseudo_source,
                     const Surface_location& from, const Surface_location& to,
                     Lower_bound lower_bound, double max_length);

  // Returns whether there is a path other than this one, which begins at `from`, ends at `to` and
  // crosses edges in their interiors. Paths differ if they cross different edges or bend at
  // different vertices. Returns true also if there are more than 2^20 windows.
  bool has_path_other_than(const std::vector<Surface_location>& path);

private:
  // A window that waits at a halfedge, or the arrival of a path at a vertex.
  struct Node
  {
    Index parent;           // index in m_nodes, or none
    Index halfedge;         // none for an arrival
    Window window;          // not for an arrival
    Window_arrival arrival; // not for a window; its origin is the vertex
  };

  Index strip_element(const Node& node) const;
  void report(Index parent, double length);
  void start();
  void leave_triangle(Index triangle);
  void cross_triangle(Index node);
  void leave_vertex(Index node, Index vertex, const Window_arrival& arrival);
  void emit_window(Index parent, Index h, const Vec2& position, double offset, double begin,
                   double end);
  void push_window(Index parent, Index h, const Window& window);
  void visit_vertex(Index parent, Index vertex, const Window_arrival& arrival);

  std::shared_ptr<const Surface_arrays> m_triangles;
  std::shared_ptr<const std::vector<bool>> m_is_pseudo_source;
  Surface_location m_from, m_to;
  Index m_end_vertex; // that of m_to, or none
  Lower_bound m_lower_bound;
  double m_max_length;
  std::vector<Index> m_strip; // edges and vertices of the first path
  std::vector<Node> m_nodes;
  bool m_is_found = false;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_SECOND_PATH_SEARCH_H
