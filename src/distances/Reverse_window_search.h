// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_REVERSE_WINDOW_SEARCH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_REVERSE_WINDOW_SEARCH_H

#include <CGAL/Geodesic_processing/internal/distances/Window_state.h>
#include "distances/Window_goal.h"

#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Propagates windows from a location back to the sources of a forward query.
//
// The forward distance of a vertex is a lower bound of the rest of a path. Therefore only windows
// that may be on a path of the required length are propagated.
class CGAL_GEODESIC_PROCESSING_EXPORT Reverse_window_search
{
public:
  Reverse_window_search(std::shared_ptr<const Surface_arrays> triangles,
                        std::shared_ptr<const std::vector<bool>> is_pseudo_source);

  // Returns the end of the shortest path; its distance is infinite if there is none.
  const Meeting& find_shortest(const Window_state& forward, const Surface_location& from);
  // Returns the end of a path to a point source that is shorter than `max_length`; if there is
  // none, only the distance is set, to `max_length`. See Window_goal::find_between(). `callback` is
  // called with 0 from time to time. An exception that it throws cancels the search.
  const Meeting& find_between(const Window_state& initialized, const Surface_location& source,
                              const Surface_location& from, double max_length,
                              const std::function<bool(double)>& callback = {});
  // Finds the ends of all paths of at most this length.
  void find_all(const Window_state& forward, const Surface_location& from, double max_length);

  const Window_state& state() const { return m_state; }
  const std::vector<Meeting>& meetings() const { return m_goal.meetings(); }
  // Continues a path from the sources, which ends at a vertex, recursively by all arrivals kept
  // there. Appends the complete paths, at most 64 in total. Requires find_all().
  void collect_paths(Index vertex, const std::vector<Surface_location>& path,
                     std::vector<std::vector<Surface_location>>& paths) const;

private:
  void propagate_back(const Surface_location& from,
                      const std::function<bool(double)>& callback = {});

  Window_state m_state;
  Window_goal m_goal;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_REVERSE_WINDOW_SEARCH_H
