// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_PROPAGATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_PROPAGATION_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_state.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

class Reverse_window_search;

// The first segment of the shortest path from a source: the exact logarithmic map.
struct Departure
{
  Surface_location from, next; // a point of the source, and the end of the path's first segment
  double angle = 0.;           // in the plane of the triangle of `from`, as for trace_straightest()
  // Counterclockwise. At a vertex: from the halfedge that leaves the first corner of its one-ring.
  // On an edge: from the halfedge with the smaller index. Otherwise equal to `angle`.
  double polar_angle = 0.;
  double length = infinity; // without the offset of the source; infinite if there is no path
};

// A lower and an upper bound of a distance.
struct Distance_bounds
{
  double lower = infinity, upper = infinity;
};

// A path, and a lower bound of the distance between its ends.
struct Bounded_path
{
  std::vector<Surface_location> locations;
  double lower = 0.;
};

// Computes exact geodesic distances on a mesh by window propagation (Mitchell, Mount and
// Papadimitriou 1987).
//
// All windows that wait at a halfedge cross its triangle together (Qin et al. 2016). Halfedges are
// ordered by the smaller distance of their ends. A window is dropped if no shortest path can use
// it. This is the case if a detour through an end of its edge is shorter (Xin and Wang 2009), if
// another window is closer everywhere, or if its lines cross the shortest one to the apex. Saddle,
// boundary and non-manifold vertices are pseudo-sources for the region that no straight line
// through them reaches.
//
// Windows with the same unfolded source are merged again. Therefore flat regions cost as much as a
// front, curved ones O(n^1.5) time in practice. Windows are discarded after they have crossed.
// A query beyond Window_propagator::usual_max_work() throws Unsupported_surface_error; then no
// vertex is reached. The time of a query depends only on the visited triangles. Copies share the
// triangles and may run concurrently.
//
// Degenerate triangles get slightly longer edges first (without_degenerate_triangles()). Bounds,
// also those of paths, contain the errors of thin triangles (distance_error_of_thin_triangles()).
//
// With a relative tolerance, similar windows are merged (approximate_windows.h). Lower and upper
// bounds of the distances then differ by at most this fraction of the lower bound, and distance()
// is their mean. There are fewer windows: on smooth surfaces about one per edge.
//
// Triangles of infinite slowness are obstacles. They are removed from a copy of the arrays, and
// the distances on this copy are exact.
class CGAL_GEODESIC_PROCESSING_EXPORT Window_propagation
{
public:
  // Throws Unsupported_surface_error if the arrays are a cloud.
  explicit Window_propagation(std::shared_ptr<const Surface_arrays> triangles);

  // Throws Unsupported_surface_error if the slowness differs outside of obstacles.
  static void check_speeds(const Front_limits& limits);

  // As Front::run(); known_distance is ignored. Throws as check_speeds(), and
  // Unsupported_surface_error if the query exceeds Window_propagator::usual_max_work().
  bool run(const std::vector<Front_source>& sources, const Front_limits& limits = {});

  // The results of the last query, in the unit of the arrays, as those of a Front.
  double distance(Index vertex) const
  {
    const double result = scaled(m_state.vertices[vertex].distance);
    return m_state.is_exact() ? result : 0.5 * (result + scaled(m_state.upper_bound(vertex)));
  }
  // Certified bounds of the distance, up to round-off errors. Without a relative tolerance and
  // thin triangles they are equal.
  double lower(Index vertex) const
  {
    return scaled(without_excess(m_state.vertices[vertex].distance));
  }
  double upper(Index vertex) const { return scaled(with_shortfall(m_state.upper_bound(vertex))); }
  Index source(Index vertex) const { return m_state.vertices[vertex].source; }
  Index predecessor(Index vertex) const;
  const std::vector<Index>& reached() const { return m_state.reached; }
  // Returns the distance at a location.
  double distance(const Surface_location& location) const;
  // Returns bounds of the distance at a location. Inside a face or edge, windows are propagated
  // back from the location until they meet a source, or a vertex on a shortest path.
  Distance_bounds bounds(const Surface_location& location) const;
  // Returns the distances at many locations. Without a relative tolerance, takes as long as the
  // query, and less than as many calls of distance() if there are hundreds of locations.
  std::vector<double> distances(const std::vector<Surface_location>& locations) const;
  // Returns the shortest path from a location to the nearest source, shortened by
  // shorten_geodesic(). It has no locations if no source reaches the location, or if round-off
  // errors in degenerate triangles prevent the reconstruction. With a relative tolerance, it is a
  // locally shortest path.
  Bounded_path path(const Surface_location& from) const;
  // Returns a shortest path between two locations if it is shorter than `max_length`, otherwise no
  // locations. `lower` is the length of the shortest path, at most `max_length`, minus round-off
  // errors. Only windows in the ellipse of this length around both locations are propagated.
  // Replaces the results of the last query, which has no obstacles.
  //
  // `callback` is called with 0 from time to time. An exception that it throws cancels the search.
  Bounded_path path_between(const Surface_location& from, const Surface_location& to,
                            double max_length, const std::function<bool(double)>& callback = {});
  // Returns all locally shortest paths to the sources whose length exceeds the distance by at most
  // this fraction of it; at most 64 paths. That fraction must be far shorter than an edge. Throws
  // Unsupported_surface_error, as departure(), if the query had a relative tolerance.
  std::vector<std::vector<Surface_location>> paths(const Surface_location& from,
                                                   double tolerance) const;
  // Returns the first segment, at the source, of the shortest path to a location.
  Departure departure(const Surface_location& to) const;
  // Returns departure().polar_angle for a vertex, more than ten times as fast: only the straight
  // line incident to the source is followed. Zero if the vertex is on a source.
  double polar_angle_of_departure(Index vertex) const;

private:
  double scaled(double distance) const { return m_slowness * (distance + m_state.min_offset); }
  // Return a lower and an upper bound of the distance on the input.
  double without_excess(double distance) const { return std::max(0., distance - m_max_excess); }
  double with_shortfall(double distance) const
  {
    return distance > 0. ? distance + m_max_shortfall : distance;
  }

  // The lazily created search from locations back to the sources; a copy starts with none.
  struct Reverse_search
  {
    Reverse_search() = default;
    Reverse_search(const Reverse_search&) {}
    Reverse_search& operator=(const Reverse_search&) { return *this; }

    std::mutex mutex;
    std::shared_ptr<Reverse_window_search> search;
  };

  // Returns bounds of the distance on the triangles with longer edges. Not scaled.
  Distance_bounds unscaled_bounds(const Surface_location& location) const;
  void require_exact() const;
  Bounded_path path_along_edges(const Surface_location& from) const;
  void set_obstacles(const std::vector<double>* slowness);
  Surface_location outside_obstacles(const Surface_location& location) const;
  std::vector<Front_source> outside_obstacles(const std::vector<Front_source>& sources) const;
  Bounded_path shortened(const std::vector<Surface_location>& path, double length) const;
  bool is_inside_obstacle(const Surface_location& location) const;
  void limit_to_targets(const std::vector<Surface_location>& targets);
  Reverse_window_search& reverse_search() const;

  std::shared_ptr<const Surface_arrays> m_triangles; // with obstacles, not degenerate
  // #triangles: the slowness of the last query; empty if it is 1 everywhere.
  std::vector<double> m_slowness_map;
  std::vector<Front_source> m_sources; // of the last query, outside of obstacles
  double m_slowness = 1.;              // outside of obstacles
  Window_state m_state; // on the surface without obstacles; its distances are for slowness 1
  // By how much thin triangles can make a distance too long and too short.
  double m_max_excess = 0., m_max_shortfall = 0.;
  mutable Reverse_search m_reverse_search;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_PROPAGATION_H
