// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_SHORTEST_PATH_FINDER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_SHORTEST_PATH_FINDER_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Finds paths between pairs of locations without computing a distance field.
//
// The path of a Path_finder is shortened to a locally shortest path. On a mesh, its length bounds
// a search by exact windows (Window_propagation::path_between()). Copies share the triangles;
// different copies can be used concurrently.
class CGAL_GEODESIC_PROCESSING_EXPORT Shortest_path_finder
{
public:
  explicit Shortest_path_finder(std::shared_ptr<const Surface_arrays> triangles);

  // As Path_finder::add_landmarks().
  void add_landmarks(unsigned number_of_landmarks) { m_finder.add_landmarks(number_of_landmarks); }

  // Returns a locally shortest path; no locations if there is none. `lower` is the straight
  // distance.
  Bounded_path locally_shortest_path(const Surface_location& from, const Surface_location& to);
  // Shortens a polyline to a locally shortest path with the same ends. Paths of the search join
  // consecutive locations; no locations if there is none. Throws Invalid_argument_error if there
  // are fewer than two locations.
  Bounded_path shorten(const std::vector<Surface_location>& polyline);
  // Returns a shortest path; no locations if there is none. On a cloud, returns a locally shortest
  // path. The exact search calls `callback` with 0 from time to time. An exception that it throws
  // cancels the search.
  Bounded_path shortest_path(const Surface_location& from, const Surface_location& to,
                             const std::function<bool(double)>& callback = {});

private:
  std::shared_ptr<const Surface_arrays> m_triangles;
  Path_finder m_finder;
  std::optional<Window_propagation> m_windows; // created by the first search
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_SHORTEST_PATH_FINDER_H
