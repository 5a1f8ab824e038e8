// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_PROPAGATOR_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_PROPAGATOR_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_state.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

class Window_goal;
struct Continued_line;

// The relative round-off error of a sum of thousands of lengths is smaller.
constexpr double round_off_tolerance = 1e-12;

// Returns for each vertex whether a shortest path may bend there. This requires an angle sum above
// 2 pi, a boundary, or more than one fan. Throws Unsupported_surface_error if the arrays are a
// cloud.
CGAL_GEODESIC_PROCESSING_EXPORT
std::shared_ptr<const std::vector<bool>> find_pseudo_sources(const Surface_arrays& triangles);

// The steps of window propagation, forward or, with a goal, back from a location.
class Window_propagator
{
public:
  explicit Window_propagator(Window_state& state, Window_goal* goal = nullptr)
      : Window_propagator(state, goal, usual_max_work(state.triangles->corner.size()))
  {}
  Window_propagator(Window_state& state, Window_goal* goal, std::size_t max_work)
      : m_state(state), m_goal(goal), m_max_work(max_work)
  {}

  // Initializes vertices and windows from the sources; requires a cleared state and its min_offset.
  CGAL_GEODESIC_PROCESSING_EXPORT void start(const std::vector<Front_source>& sources);
  // Processes the first item of the queue. Returns true if it is a vertex. If the work exceeds
  // its limit, clears the state and throws Unsupported_surface_error.
  CGAL_GEODESIC_PROCESSING_EXPORT bool step();

  // Returns the work so far: the number of windows that waited at crossed halfedges, of comparisons
  // with stored windows, and of triangles around finalized vertices.
  std::size_t work() const { return m_work; }
  // Returns the limit of the work on n halfedges: 10^9 + 10 n^1.5. On smooth surfaces the work is a
  // small multiple of n. Windows that circulate around a vertex of high degree cross each of its
  // edges; then n^2 is possible.
  CGAL_GEODESIC_PROCESSING_EXPORT static std::size_t usual_max_work(std::size_t n);

private:
  void start_at_point(const Surface_location& location, Index source, double offset);
  void start_along(const Source_piece& piece);
  // `error` is that of the window through which the path arrives.
  bool relax(Index vertex, const Window_arrival& arrival, Index source, double error = 0.);

  void finalize_vertex(Index vertex);
  void relax_along_edge(Index corner, bool is_incoming);
  void create_pseudosource_windows(Index vertex);
  void emit_windows_behind(const Continued_line& line, bool is_left, Index end);
  void emit_windows_of_other_fans(Index vertex);
  void emit_window(Index corner);
  void emit_window(Index corner, double begin, double end);

  // The window with the smallest distance at the apex of the triangle that windows cross.
  struct Nearest_window
  {
    std::size_t index;
    double distance;
    double position; // at which its line to the apex crosses the halfedge
    Vec2 to_source;  // from the apex
  };
  void cross_triangle(const Window_queue::Item& item);
  Nearest_window find_nearest(Index h, const Vec2& apex_point, std::size_t first, std::size_t last);
  void relax_apex(Index h, const Vec2& apex_point, const Nearest_window& nearest);
  // Arguments are passed by value: the loops write doubles that could alias referenced ones.
  void cross_to_left(Index h, Vec2 apex_point, std::size_t last, Nearest_window nearest);
  void cross_to_right(Index h, Vec2 apex_point, std::size_t first, Nearest_window nearest);
  void collect_windows(Window_queue::Item item);
  void merge_similar_windows(Index h);
  void drop_dominated(Index h);
  double max_useful_distance(Index vertex) const;
  bool is_too_long(const Window& window, double max_by_begin, double max_by_end) const;

  void enqueue(Index h, int list_index, Window_list list);
  void enqueue(Index h, const Window& window);

  Window_state& m_state;
  Window_goal* m_goal; // null in a forward propagation
  std::size_t m_work = 0, m_max_work;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_PROPAGATOR_H
