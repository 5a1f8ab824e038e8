// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_PROPAGATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_PROPAGATION_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/Vertex_queue.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// How the shortest path to a place leaves its source: the exact logarithmic map.
struct Departure
{
  Surface_location from, next; // where on the source, and where the path's first segment ends
  double angle = 0.;           // in the plane of the triangle of `from`, as straightest() takes it
  // Counterclockwise: around a site from the side that leaves the first corner of its star, on a side
  // from that of the two that comes first; elsewhere the angle.
  double polar_angle = 0.;
  double length = infinity; // without the source's offset; infinite where there is no path
};

// Exact distances on a mesh (Mitchell, Mount and Papadimitriou 1987).
//
// A window is an interval of a side through which straight lines come from one unfolded source.  The
// windows that wait at a side cross its triangle together (Qin et al. 2016), in the order of the
// distance of the side's nearer end.  Those that no shortest path can use are dropped before: they
// come later than a detour by an end of the side (Xin and Wang 2009), they are farther than a
// neighbour, or their lines cross the shortest one to the apex.  Saddle, border and pinched sites are
// sources of their own for what no straight line from before them sees.
//
// Windows that unfold to the same source are one again: flat parts cost what a front does, curved
// ones O(n^1.5) in practice.  Nothing is kept of a window once it has crossed.  A query costs in
// proportion to what it visits.  Copies share the triangles and may run at the same time.
class CGAL_GEODESIC_PROCESSING_EXPORT Window_propagation
{
public:
  // Throws Unsupported_surface_error on a cloud.
  explicit Window_propagation(std::shared_ptr<const Surface_arrays> triangles);

  // As Front::run().  Throws Unsupported_surface_error when there is a slowness.
  bool run(const std::vector<Front_source>& sources, const Front_limits& limits = {});

  // All of the last run, in the domain's scale, as of a Front.
  double distance(Index vertex) const { return m_vertices[vertex].distance + m_min_offset; }
  Index source(Index vertex) const { return m_vertices[vertex].source; }
  Index predecessor(Index vertex) const;
  const std::vector<Index>& reached() const { return m_reached; }
  // Anywhere else windows are sent back until they meet a source or a site through which a shortest
  // path leads; only those that can be on one go on.
  double distance(const Surface_location& location) const;
  // The shortest path from a location to the nearest source, as straighten() leaves it.  Empty where
  // no source reaches, or where triangles without area let it lose its way.
  std::vector<Surface_location> path(const Surface_location& from) const;
  // All paths from there that are not longer than the shortest by more than this part of it, which is
  // far smaller than a side; at most 64.
  std::vector<std::vector<Surface_location>> paths(const Surface_location& from,
                                                   double tolerance) const;
  // How the shortest path leaves the source, the other way.
  Departure departure(const Surface_location& to) const;
  // The polar angle alone, for sites, more than ten times as fast: of the path only the straight line next
  // to the source is followed.  Zero at the source.
  double polar_angle_of_departure(Index vertex) const;

private:
  struct Window
  {
    // Where the side begins at the origin and runs along the first axis, with the triangle to be
    // crossed above it.  Of a straight front, a unit vector back.
    Vec2 source;
    double offset;     // distance at the source; of a straight front, at the origin
    double begin, end; // along the side
    Index origin;      // the site that is the source, or #sites + the piece of a source
    float weight;      // 1, or 0 of a straight front: source / weight in homogeneous coordinates

    double distance(double position) const
    {
      if(weight == 0.f)
        return offset - position * source[0];
      const double x = position - source[0];
      return offset + std::sqrt(x * x + source[1] * source[1]);
    }
  };
  // How a path comes to a site.
  struct Arrival
  {
    double distance = infinity; // above the lowest offset
    Vec2 direction = {1., 0.};  // unit vector back to the source, in the plane of the triangle of
    Index corner = none;        //   this corner, whose side lies on the first axis
    Index origin = none;        // of the window that came, or the site at the other end of a side
  };
  struct Vertex_data : Arrival
  {
    Index source = none;
    Index state = 0;
  };
  // Windows next to each other, sorted along a side.
  struct Window_list
  {
    Index position = 0, size = 0;
    Index capacity_log2 = 0; // logarithm of how many fit
  };
  // The part of a source that lies in a triangle.
  struct Source_piece
  {
    Index triangle;
    Index source;
    std::array<double, 3> begin, end;
    double offset;
  };

  // Where windows that are sent back meet what has been reached.
  struct Meeting
  {
    double distance = infinity;
    Index vertex = none;
    // Otherwise a place of a source, and where it is seen from, in the layout of its triangle.
    Surface_location location;
    Vec2 direction = {0., 0.};
    double length = 0.;
    Index origin = none;
  };
  // Where windows are sent back; a copy begins with none.
  struct Reverse_search
  {
    Reverse_search() = default;
    Reverse_search(const Reverse_search&) {}
    Reverse_search& operator=(const Reverse_search&) { return *this; }

    std::mutex mutex;
    std::shared_ptr<Window_propagation> windows;
  };

  Window_propagation(std::shared_ptr<const Surface_arrays> triangles,
                     std::shared_ptr<const std::vector<bool>> is_pseudo_source);
  const Meeting& find_shortest(const Window_propagation& forward, const Surface_location& from);
  void find_all(const Window_propagation& forward, const Surface_location& from, double maximum);
  void propagate_back(const Window_propagation& forward, const Surface_location& from);
  Window_propagation& reverse_propagation() const;
  void meet_sources(Index triangle, const Vec2& position, Index origin);
  void meet_sources_behind(Index h);
  void meet(const Source_piece& piece, const Vec2& position, const Vec2& from, double distance,
            Index origin);
  double append_chain(Index vertex, std::vector<Surface_location>& path) const;
  void collect_paths(Index vertex, const std::vector<Surface_location>& path,
                     std::vector<std::vector<Surface_location>>& paths) const;
  std::optional<Surface_location> source_point(Index origin) const;
  double line_length(const Arrival& arrival) const;
  double append_arrival(const Arrival& arrival, std::vector<Surface_location>& path) const;
  double append_line(const Surface_location& from, const Vec2& direction, double length,
                     Index origin, std::vector<Surface_location>& path) const;

  void clear();
  void start(const std::vector<Front_source>& sources);
  void start_at_point(const Surface_location& location, Index source, double offset);
  void start_along(const Source_piece& piece);
  bool relax(Index vertex, const Arrival& arrival, Index source);
  void keep_arrival(Index vertex, const Arrival& arrival);
  void limit_to_targets(const std::vector<Surface_location>& targets);

  void finalize_vertex(Index vertex);
  void relax_along_edge(Index corner, bool is_incoming);
  void create_pseudosource_windows(Index vertex);
  void emit_window(Index corner, double from, double to);

  void cross_triangle(Index h);
  void collect_windows(Index h);
  void drop_dominated(Index h);
  double max_useful_distance(Index vertex) const;
  bool is_too_long(const Window& window, double max_by_begin, double max_by_end) const;

  Window_list allocate(std::size_t size);
  void release(Window_list& list);
  void enqueue(Index h, int part, Window_list list);
  void enqueue(Index h, const Window& window);

  std::shared_ptr<const Surface_arrays> m_triangles;
  std::shared_ptr<const std::vector<bool>> m_is_pseudo_source; // #sites: paths may bend here
  double m_max_edge_length = 0.;                               // side

  std::vector<Vertex_data> m_vertices;
  std::vector<Index> m_reached;
  Vertex_queue m_queue; // sides, and behind them sites

  // The windows that wait at each side: those through the side that shares its begin, and its end.
  std::vector<Window_list> m_waiting; // 2 #sides
  std::vector<Window> m_pool;
  std::vector<std::vector<Index>>
      m_free_lists; // by the logarithm of their room, places in the pool
  std::vector<std::uint8_t> m_number_of_crossings; // #sides: how often windows have crossed each
  std::vector<Index> m_crossed_halfedges;
  std::unordered_map<Index, std::vector<Window>>
      m_known_windows;           // what has crossed sides crossed often
  std::vector<Window> m_windows; // that cross now

  // Of the last query
  std::vector<Source_piece> m_source_pieces;
  double m_min_offset = 0.;
  double m_max_distance = infinity;                          // above it
  std::vector<std::pair<Index, Index>> m_pieces_by_triangle; // triangle, piece; sorted
  const Window_propagation* m_forward = nullptr;             // of windows that are sent back
  Meeting m_meeting;
  bool m_collects_all = false; // ways back, as far as the meeting's distance:
  std::vector<Meeting> m_meetings;
  std::unordered_map<Index, std::vector<Arrival>> m_arrivals; // by site
  mutable Reverse_search m_reverse_search;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_PROPAGATION_H
