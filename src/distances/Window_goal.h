// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_GOAL_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_GOAL_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_state.h>

#include <array>
#include <memory>
#include <unordered_map>
#include <utility>
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

// Finds the meetings of a backward search with the results of a forward query. The length of the
// shortest meeting bounds the search.
//
// With find_each(), it measures distances of a forward propagation at locations instead.
class CGAL_GEODESIC_PROCESSING_EXPORT Window_goal
{
public:
  explicit Window_goal(std::shared_ptr<const Surface_arrays> triangles);

  // Starts a search for the shortest path, or for all paths of at most this length.
  void find_shortest(const Window_state& forward);
  void find_all(const Window_state& forward, double max_length);
  // Starts a search for the shortest path to a point source that is shorter than this length. The
  // sources of the forward query have been initialized, but it has not run. The straight distance
  // to the source replaces its distances.
  void find_between(const Window_state& initialized, const Surface_location& source,
                    double max_length);
  // Starts a propagation from any sources that measures the distances of point pieces.
  void find_each(const std::vector<Source_piece>& pieces);

  bool collects_all() const { return m_mode == Mode::all; }
  const Meeting& meeting() const { return m_meeting; }
  // After find_each(): for each piece, the shortest line from it to the propagated windows. Its
  // distance is infinite if no window reaches the piece; its location is not set.
  const std::vector<Meeting>& meetings() const { return m_meetings; }
  // Returns the arrivals that were kept at a vertex, in a search for all paths.
  const std::vector<Window_arrival>& arrivals(Index vertex) const;

  // In a search for all paths, stores an arrival at a vertex, unless one from the same direction is
  // stored.
  void keep_arrival(Index vertex, const Window_arrival& arrival);
  // Returns whether the path through a vertex at this backward distance may be short enough. If it
  // is the shortest one so far, it becomes the meeting.
  bool reach(Index vertex, double distance);
  // Returns the distance at a vertex beyond which no path is short enough.
  double max_useful_distance(Index vertex) const;
  // Tests the segments from a position in the layout of a triangle to the closest points of the
  // source pieces in this triangle. The position is at this backward distance from the origin.
  void meet_sources(Index triangle, const Vec2& position, double distance, Index origin);
  // Tests the paths from windows that cross a halfedge to the source pieces in its triangle. The
  // first entry of `windows` is unused.
  void meet_sources_behind(Index h, const std::vector<Window>& windows);

private:
  enum class Mode
  {
    shortest,
    all,
    between,
    each
  };
  // The pieces that windows may meet: those of the forward query, or those of find_each().
  const std::vector<Source_piece>& pieces() const
  {
    return m_mode == Mode::each ? m_pieces : m_forward->source_pieces;
  }
  const std::vector<std::pair<Index, Index>>& pieces_by_triangle() const
  {
    return m_mode == Mode::each ? m_pieces_by_triangle : m_forward->pieces_by_triangle;
  }
  double lower_bound(Index vertex) const;
  void meet_straight(const Source_piece& piece, const Vec2& local_point, const Vec2& point,
                     const Window& window);
  void meet(const Source_piece& piece, const Vec2& position, const Vec2& from, double distance,
            Index origin);
  void meet_each(const Source_piece& piece, double distance, const Vec2& line, Index origin);

  std::shared_ptr<const Surface_arrays> m_triangles;
  Mode m_mode = Mode::shortest;
  const Window_state* m_forward = nullptr;
  std::array<double, 3> m_source_point = {0., 0., 0.};       // between
  std::vector<Source_piece> m_pieces;                        // each
  std::vector<std::pair<Index, Index>> m_pieces_by_triangle; // each: as that of a Window_state
  Meeting m_meeting; // all: its distance is the maximum length
  std::vector<Meeting> m_meetings;
  std::unordered_map<Index, std::vector<Window_arrival>> m_arrivals; // by vertex
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_GOAL_H
