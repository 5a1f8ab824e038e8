// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_GOAL_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_GOAL_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_state.h>

#include <memory>
#include <unordered_map>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A path that joins windows propagated back from a location with the results of a forward query.
struct Meeting
{
  double distance = infinity; // total length of the path
  Index vertex = none;        // at which they meet; none if they meet on a source
  // Otherwise: a point of a source piece, the vector from it to the origin of the windows in the
  // layout of its triangle, the length of that vector, and the origin.
  Surface_location location;
  Vec2 direction = {0., 0.};
  double length = 0.;
  Index origin = none;
};

// Finds the meetings of a backward search with the results of a forward query.  The length of the
// shortest meeting bounds the search.
class CGAL_GEODESIC_PROCESSING_EXPORT Window_goal
{
public:
  explicit Window_goal(std::shared_ptr<const Surface_arrays> triangles);

  // Starts a search for the shortest path, or for all paths of at most this length.
  void find_shortest(const Window_state& forward);
  void find_all(const Window_state& forward, double max_length);

  bool collects_all() const { return m_collects_all; }
  const Meeting& meeting() const { return m_meeting; }
  const std::vector<Meeting>& meetings() const { return m_meetings; }
  // Returns the arrivals that were kept at a vertex, in a search for all paths.
  const std::vector<Window_arrival>& arrivals(Index vertex) const;

  // In a search for all paths, stores an arrival at a vertex, unless one from the same direction is
  // stored.
  void keep_arrival(Index vertex, const Window_arrival& arrival);
  // Returns whether the path through a vertex at this backward distance may be short enough.  If it
  // is the shortest one so far, it becomes the meeting.
  bool reach(Index vertex, double distance);
  // Returns the distance at a vertex beyond which no path is short enough.
  double max_useful_distance(Index vertex) const;
  // Tests the segments from a position in the layout of a triangle to the closest points of the
  // source pieces in this triangle.
  void meet_sources(Index triangle, const Vec2& position, Index origin);
  // Tests the paths from windows that cross a halfedge to the source pieces in its triangle.  The
  // first entry of `windows` is unused.
  void meet_sources_behind(Index h, const std::vector<Window>& windows);

private:
  void meet(const Source_piece& piece, const Vec2& position, const Vec2& from, double distance,
            Index origin);

  std::shared_ptr<const Surface_arrays> m_triangles;
  const Window_state* m_forward = nullptr;
  bool m_collects_all = false; // then m_meeting.distance is the maximum length
  Meeting m_meeting;
  std::vector<Meeting> m_meetings;
  std::unordered_map<Index, std::vector<Window_arrival>> m_arrivals; // by vertex
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_GOAL_H
