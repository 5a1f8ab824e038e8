// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Window_propagator.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include "core/prefetch.h"
#include "core/unfold.h"
#include "distances/Window_goal.h"
#include "distances/approximate_windows.h"
#include "distances/window_operations.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Windows cross most halfedges once or twice. If they cross one more often than this, they may
// circulate around spikes or between coincident faces. Then the halfedge stores the windows that
// cross it.
constexpr std::uint8_t max_untracked_crossings = 8;

// Cuts off the parts of windows, from `first` on, that are dominated by other ones, and erases the
// windows of which nothing is left.
void trim_all(std::vector<Window>::iterator first, std::vector<Window>& windows,
              std::vector<Window>::const_iterator first_other,
              std::vector<Window>::const_iterator last_other, double min_length)
{
  const auto is_dominated = [&](Window& w)
  {
    for(double width = infinity; w.end - w.begin > min_length && w.end - w.begin < width;)
    {
      width = w.end - w.begin;
      for(auto other = first_other; other != last_other; ++other)
        trim_dominated(w, *other);
    }
    return !(w.end - w.begin > min_length);
  };
  windows.erase(std::remove_if(first, windows.end(), is_dominated), windows.end());
}

// Prefetches the data of the item that follows next, unless the current one inserts another one
// before. This saves 10 % of the time of a query on a million triangles.
void prefetch_item(Window_state& state, const Window_queue::Item& item)
{
  const Surface_arrays& t = *state.triangles;
  const auto prefetch_corner = [&](Index corner)
  {
    prefetch(&t.length[corner]);
    prefetch(&t.corner[corner]);
    prefetch(&t.twin[corner]);
  };
  const Index number_of_halfedges = Index(t.corner.size());
  if(item.index >= number_of_halfedges)
  {
    const Index v = item.index - number_of_halfedges;
    for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
      prefetch_corner(t.ring[i]);
    return;
  }
  prefetch_corner(item.index);
  prefetch(&state.number_of_crossings[item.index]);
  const Index first = item.index - item.index % 3;
  for(Index corner = first; corner < first + 3; ++corner)
    prefetch(&state.vertices[t.corner[corner]]);
  // The processor prefetches the rest of an array after its first lines.
  for(const Window_list& list : item.windows)
    if(list.size > 0)
      for(std::uintptr_t offset = 0; offset < 256; offset += 64)
        prefetch(reinterpret_cast<const void*>(
            reinterpret_cast<std::uintptr_t>(state.pool.begin(list)) + offset));
}

} // namespace

Window_state::Window_state(std::shared_ptr<const Surface_arrays> arrays,
                           std::shared_ptr<const std::vector<bool>> pseudo_sources)
    : triangles(std::move(arrays)), is_pseudo_source(std::move(pseudo_sources)),
      vertices(triangles->number_of_vertices()),
      queue(triangles->corner.size() + triangles->number_of_vertices()),
      number_of_crossings(triangles->corner.size()),
      is_crossed_block((triangles->corner.size() + block_size - 1) / block_size)
{
  for(const double length : triangles->length)
    max_edge_length = std::max(max_edge_length, length);
}

void Window_state::clear()
{
  for(const Index vertex : reached)
  {
    vertices[vertex] = Window_state::Vertex{};
    if(!is_exact())
      upper[vertex] = infinity;
  }
  reached.clear();
  for(const Index block : crossed_blocks)
  {
    const std::size_t first = block * std::size_t(block_size);
    std::fill_n(number_of_crossings.begin() + std::ptrdiff_t(first),
                std::min<std::size_t>(block_size, number_of_crossings.size() - first),
                std::uint8_t(0));
    is_crossed_block[block] = false;
  }
  crossed_blocks.clear();
  known_windows.clear();
  while(!queue.empty())
    for(Window_list& list : queue.pop().windows)
      pool.release(list);
}

void Window_state::set_tolerance(double tolerance)
{
  relative_tolerance = tolerance;
  upper.resize(tolerance > 0. ? vertices.size() : 0, infinity);
}

std::size_t Window_propagator::usual_max_work(std::size_t n)
{
  return 1000000000 + std::size_t(10. * double(n) * std::sqrt(double(n)));
}

bool Window_propagator::step()
{
  if(m_work > m_max_work)
  {
    m_state.clear();
    throw Unsupported_surface_error("The exact method needs too many windows on this mesh: many "
                                    "windows cross the same edges, or circulate around a vertex of "
                                    "high degree.");
  }
  const Window_queue::Item item = m_state.queue.pop();
  const Index number_of_halfedges = Index(m_state.triangles->corner.size());
  if(!m_state.queue.empty())
    prefetch_item(m_state, m_state.queue.front());
  if(item.index < number_of_halfedges)
  {
    cross_triangle(item);
    return false;
  }
  finalize_vertex(item.index - number_of_halfedges);
  return true;
}

bool Window_propagator::relax(Index v, const Window_arrival& arrival, Index source, double error)
{
  if(m_goal)
    m_goal->keep_arrival(v, arrival);
  Window_state::Vertex& vertex = m_state.vertices[v];
  const double distance = arrival.distance;
  if(!m_state.is_exact() && distance <= m_state.max_distance)
    m_state.upper[v] = std::min(m_state.upper[v], distance + error);
  if(!(distance < vertex.distance) || distance > m_state.max_distance)
    return false;
  if(m_goal && !m_goal->reach(v, distance))
    return false;
  if(!(vertex.state & Window_state::reached_flag))
    m_state.reached.push_back(v);
  // A finalized vertex is not reopened by round-off errors.
  const bool is_unchanged = (vertex.state & Window_state::finalized_flag) &&
                            distance >= vertex.distance * (1. - merge_tolerance);
  vertex = {arrival, source, vertex.state | Window_state::reached_flag};
  if(!is_unchanged)
    m_state.queue.push(Index(m_state.triangles->corner.size() + v), distance);
  return true;
}

// Relaxes along the edges of a vertex and emits windows to the region that no straight line through
// the vertex reaches.
void Window_propagator::finalize_vertex(Index v)
{
  const Surface_arrays& t = *m_state.triangles;
  m_state.vertices[v].state |= Window_state::finalized_flag;
  m_work += t.ring_begin[v + 1] - t.ring_begin[v];
  for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
  {
    relax_along_edge(t.ring[i], false);
    relax_along_edge(t.ring[i], true);
    if(m_state.vertices[v].corner == none)
      emit_window(t.ring[i]);
  }
  if(m_state.vertices[v].corner == none || !(*m_state.is_pseudo_source)[v])
    return;
  create_pseudosource_windows(v);
  // These windows leave the triangles around the vertex.
  if(m_goal && m_goal->collects_all())
    for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
      m_goal->meet_sources(t.ring[i] / 3, unfolded(t, t.ring[i] / 3)[t.ring[i] % 3],
                           m_state.vertices[v].distance, v);
}

void Window_propagator::relax_along_edge(Index corner, bool is_incoming)
{
  const Surface_arrays& t = *m_state.triangles;
  const Index v = t.corner[corner], h = is_incoming ? previous_halfedge(corner) : corner;
  const Index far_corner = is_incoming ? h : next_halfedge(corner);
  const double distance = m_state.vertices[v].distance + t.length[h];
  if(!(m_goal && m_goal->collects_all()) &&
     !(distance < m_state.vertices[t.corner[far_corner]].distance))
    return;
  const bool is_on_axis = is_incoming || t.twin[corner] != none;
  relax(t.corner[far_corner],
        {distance, is_on_axis ? Vec2{1., 0.} : corner_angle(t, far_corner),
         is_incoming || !is_on_axis ? far_corner : t.twin[corner], v},
        m_state.vertices[v].source, m_state.error(v));
}

// Moves the waiting windows of a halfedge that may be on a shortest path to m_state.windows, in the
// order along the halfedge.
void Window_propagator::collect_windows(Window_queue::Item item)
{
  const Surface_arrays& t = *m_state.triangles;
  const Index h = item.index;
  const double length = t.length[h], min_length = merge_tolerance * length;
  const double max_by_begin = max_useful_distance(t.corner[h]),
               max_by_end = max_useful_distance(t.corner[next_halfedge(h)]) + length;
  m_state.windows.resize(item.windows[0].size + item.windows[1].size + 1);
  m_work += item.windows[0].size + item.windows[1].size;
  Window* stack_top = m_state.windows.data(); // the first entry is a sentinel
  for(Window_list& list : item.windows)
  {
    const Window* const begin = m_state.pool.begin(list);
    for(const Window* w = begin; w != begin + list.size; ++w)
    {
      if(!(w->end - w->begin > min_length) ||
         is_too_long(*w, max_by_begin + w->end - w->offset, max_by_end - w->begin - w->offset))
        continue;
      stack_top[1] = *w;
      for(; stack_top != m_state.windows.data() &&
            !split_overlap(stack_top[0], stack_top[1], min_length);
          --stack_top)
        stack_top[0] = stack_top[1];
      if(stack_top[1].end - stack_top[1].begin > min_length)
        ++stack_top;
    }
    m_state.pool.release(list);
  }
  m_state.windows.resize(std::size_t(stack_top - m_state.windows.data()) + 1);
  if(!m_state.is_exact())
    merge_similar_windows(h);
  if(const Index block = h / Window_state::block_size; !m_state.is_crossed_block[block])
  {
    m_state.is_crossed_block[block] = true;
    m_state.crossed_blocks.push_back(block);
  }
  if(m_state.number_of_crossings[h] < max_untracked_crossings)
    ++m_state.number_of_crossings[h];
  else
    drop_dominated(h);
}

// Merges consecutive windows of one source, as far as the relative tolerance admits.
void Window_propagator::merge_similar_windows(Index h)
{
  const double min_length = merge_tolerance * m_state.triangles->length[h];
  std::vector<Window>& windows = m_state.windows;
  std::size_t last = 0; // windows 1 .. last are merged
  for(std::size_t i = 1; i < windows.size(); ++i)
  {
    Window w = windows[i];
    for(; last > 0 && m_state.source_of(windows[last].origin) == m_state.source_of(w.origin) &&
          merge_similar(windows[last], w, m_state.relative_tolerance, min_length);
        --last)
    {}
    windows[++last] = w;
  }
  windows.resize(last + 1);
}

// Drops the parts of windows that are dominated by windows that have crossed this halfedge before,
// and stores the others.
void Window_propagator::drop_dominated(Index h)
{
  std::vector<Window>&crossing = m_state.windows, &known = m_state.known_windows[h];
  const double min_length = merge_tolerance * m_state.triangles->length[h];
  m_work += crossing.size() * known.size();
  trim_all(crossing.begin() + 1, crossing, known.begin(), known.end(), min_length);
  // A stored window that is dominated now has no effect.
  trim_all(known.begin(), known, crossing.begin() + 1, crossing.end(), min_length);
  // Growth by doubling would need a quarter more memory on meshes of needles.
  if(const std::size_t size = known.size() + crossing.size() - 1; size > known.capacity())
    known.reserve(size + size / 8);
  known.insert(known.end(), crossing.begin() + 1, crossing.end());
}

// Returns the distance at a vertex beyond which no window is useful.
double Window_propagator::max_useful_distance(Index vertex) const
{
  const double max_here = m_state.vertices[vertex].distance * (1. + round_off_tolerance);
  return m_goal ? std::min(max_here, m_goal->max_useful_distance(vertex)) : max_here;
}

// Returns whether a window is farther everywhere than the path through one of the ends of the
// halfedge, or than the maximum distance.
bool Window_propagator::is_too_long(const Window& w, double max_by_begin, double max_by_end) const
{
  const double max_length = m_state.max_distance - w.offset;
  if(w.is_straight())
    return -w.end * w.source[0] > max_by_begin || -w.begin * w.source[0] > max_by_end ||
           std::min(-w.begin * w.source[0], -w.end * w.source[0]) > max_length;
  const double to_begin = w.begin - w.source[0], to_end = w.end - w.source[0],
               square = w.source[1] * w.source[1];
  if(std::min({max_by_begin, max_by_end, max_length}) < 0. ||
     to_end * to_end + square > max_by_begin * max_by_begin ||
     to_begin * to_begin + square > max_by_end * max_by_end)
    return true;
  const double offset_from_window = std::max({to_begin, -to_end, 0.});
  return offset_from_window * offset_from_window + square > max_length * max_length;
}

// Propagates the windows that wait at a halfedge through its triangle.
void Window_propagator::cross_triangle(const Window_queue::Item& item)
{
  const Surface_arrays& t = *m_state.triangles;
  const Index h = item.index;
  collect_windows(item);
  const Window* const windows = m_state.windows.data() + 1;
  const std::size_t n = m_state.windows.size() - 1;
  if(n == 0)
    return;
  const Index left = previous_halfedge(h);
  const Vec2 apex_point = apex(t, h);

  // Windows first .. last - 1 may reach the apex.
  std::size_t first = 0, last = n;
  while(first < n && side_of_apex_line(windows[first], windows[first].end, apex_point) < 0.)
    ++first;
  while(last > first &&
        side_of_apex_line(windows[last - 1], windows[last - 1].begin, apex_point) > 0.)
    --last;
  const Nearest_window nearest = find_nearest(h, apex_point, first, last);
  if(nearest.index == n)
    return;
  if(nearest.distance < m_state.vertices[t.corner[left]].distance && t.length[left] > 0.)
    relax_apex(h, apex_point, nearest);

  if(m_goal)
    m_goal->meet_sources_behind(h, m_state.windows);

  if(t.twin[left] != none && t.length[left] > 0. && last > 0)
    cross_to_left(h, apex_point, last, nearest);
  if(const Index right = next_halfedge(h);
     t.twin[right] != none && t.length[right] > 0. && first < n)
    cross_to_right(h, apex_point, first, nearest);
}

// Returns the window with the smallest distance at the apex, among first .. last - 1 and the two
// windows adjacent to them. The line of a window that does not see the apex bends at an end of the
// window. In a search for all paths, relaxes the apex by each of them.
Window_propagator::Nearest_window Window_propagator::find_nearest(Index h, const Vec2& apex_point,
                                                                  std::size_t first,
                                                                  std::size_t last)
{
  const Window* const windows = m_state.windows.data() + 1;
  const std::size_t n = m_state.windows.size() - 1;
  const bool relaxes_all =
      m_goal && m_goal->collects_all() && m_state.triangles->length[previous_halfedge(h)] > 0.;
  Nearest_window nearest = {n, infinity, 0., {1., 0.}};
  for(std::size_t i = first - (first > 0); i < last + (last < n); ++i)
  {
    const Window& w = windows[i];
    const double at_begin = side_of_apex_line(w, w.begin, apex_point),
                 at_end = side_of_apex_line(w, w.end, apex_point);
    double distance, position;
    Vec2 to_source;
    if(at_begin <= 0. && at_end >= 0.)
    {
      to_source = w.is_straight() ? w.source : w.source - apex_point;
      distance = w.offset + (w.is_straight() ? -dot(to_source, apex_point) : norm(to_source));
      position = at_end > at_begin ? w.begin + (w.end - w.begin) * (-at_begin / (at_end - at_begin))
                                   : w.begin;
    }
    else
    {
      position = at_begin > 0. ? w.begin : w.end;
      to_source = Vec2{position, 0.} - apex_point;
      distance = w.distance(position) + norm(to_source);
    }
    if(relaxes_all)
      relax_apex(h, apex_point, {i, distance, position, to_source});
    if(distance < nearest.distance)
      nearest = {i, distance, position, to_source};
  }
  return nearest;
}

void Window_propagator::relax_apex(Index h, const Vec2& apex_point, const Nearest_window& nearest)
{
  const Surface_arrays& t = *m_state.triangles;
  const Index left = previous_halfedge(h);
  const double base = t.length[h];
  const double size = norm(nearest.to_source);
  const Vec2 direction =
      size > 0. ? rotated_back((1. / size) * nearest.to_source, (-1. / t.length[left]) * apex_point)
                : Vec2{1., 0.};
  // A line that bends at an end of the halfedge has the vertex there as its origin.
  const Window& window = m_state.windows[nearest.index + 1];
  Index origin = window.origin;
  const bool has_bend = nearest.to_source[1] == -apex_point[1];
  if(has_bend && nearest.position <= merge_tolerance * base)
    origin = t.corner[h];
  else if(has_bend && nearest.position >= base * (1. - merge_tolerance))
    origin = t.corner[next_halfedge(h)];
  relax(t.corner[left], {nearest.distance, direction, left, origin}, m_state.source_of(origin),
        window.error());
}

// Enqueues the parts of the windows that leave through the left edge. Lines that cross the line of
// the nearest window are not shortest behind it and are dropped.
void Window_propagator::cross_to_left(Index h, Vec2 apex_point, std::size_t last,
                                      Nearest_window nearest)
{
  const Surface_arrays& t = *m_state.triangles;
  const Index left = previous_halfedge(h);
  const double left_length = t.length[left];
  const Window* const windows = m_state.windows.data() + 1;
  Window_list list = m_state.pool.allocate(last);
  Window* next_window = m_state.pool.begin(list);
  const Vec2 axis = (1. / left_length) * apex_point;
  for(std::size_t i = 0; i < last; ++i)
  {
    const Window& w = windows[i];
    const double at_begin = side_of_apex_line(w, w.begin, apex_point),
                 at_end = side_of_apex_line(w, w.end, apex_point);
    if(at_begin < 0. && !(i > nearest.index && w.begin >= nearest.position))
      *next_window++ = clip_through_left(w, at_begin, at_end, axis, left_length);
  }
  list.size = Index(next_window - m_state.pool.begin(list));
  enqueue(t.twin[left], 0, list);
}

void Window_propagator::cross_to_right(Index h, Vec2 apex_point, std::size_t first,
                                       Nearest_window nearest)
{
  const Surface_arrays& t = *m_state.triangles;
  const Index right = next_halfedge(h);
  const double base = t.length[h], right_length = t.length[right];
  const Window* const windows = m_state.windows.data() + 1;
  const std::size_t n = m_state.windows.size() - 1;
  Window_list list = m_state.pool.allocate(n - first);
  Window* next_window = m_state.pool.begin(list);
  const Vec2 axis = (1. / right_length) * Vec2{base - apex_point[0], apex_point[1]};
  for(std::size_t i = first; i < n; ++i)
  {
    const Window& w = windows[i];
    const double at_begin = side_of_apex_line(w, w.begin, apex_point),
                 at_end = side_of_apex_line(w, w.end, apex_point);
    if(at_end > 0. && !(i < nearest.index && w.end <= nearest.position))
      *next_window++ = mirror(
          clip_through_left(mirror(w, base), -at_end, -at_begin, axis, right_length), right_length);
  }
  list.size = Index(next_window - m_state.pool.begin(list));
  enqueue(t.twin[right], 1, list);
}

// Adds windows to those that wait at a halfedge, and releases an empty list.
void Window_propagator::enqueue(Index h, int list_index, Window_list list)
{
  const Surface_arrays& t = *m_state.triangles;
  if(list.size == 0)
  {
    list.size = 1;
    return m_state.pool.release(list);
  }
  Window_list& waiting = m_state.queue.push(
      h, std::min(m_state.vertices[t.corner[h]].distance,
                  m_state.vertices[t.corner[next_halfedge(h)]].distance))[std::size_t(list_index)];
  waiting = waiting.size > 0 ? m_state.pool.merge(waiting, list) : list;
}

void Window_propagator::enqueue(Index h, const Window& window)
{
  if(h == none)
    return;
  const Window_list list = m_state.pool.allocate(1);
  *m_state.pool.begin(list) = window;
  enqueue(h, 0, list);
}

} // namespace CGAL::Geodesic_processing::internal
