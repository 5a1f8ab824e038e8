// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/shorten_geodesic.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"
#include "paths/triangle_strip.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Angles that differ from pi by less than this are treated as pi. Cutting such a corner with legs
// a and b shortens the path by less than 1e-18 (a + b).
constexpr double angle_tolerance = 1e-9;

// A point at which the path may bend, and the straight segment that starts there.
struct Path_vertex
{
  Surface_location location; // an endpoint of the path, or a vertex
  Index vertex = none;
  Index previous = none, next = none;

  // The strip to the next path vertex. Its edges contain neither of the two.
  Strip strip;
  double length = 0.;

  // At a vertex: the directions to the next and to the previous path vertex. Each is given by the
  // corner of its triangle and the angle from that corner's halfedge: its cosine and its sine times
  // a positive factor.
  Index corner_out = none, corner_in = none;
  Vec2 angle_out = {1., 0.}, angle_in = {1., 0.};

  bool is_queued = false; // whether it is in the queue of shorten_locally()
};

class Geodesic_shortener
{
public:
  explicit Geodesic_shortener(const Surface_arrays& t) : t(t) {}

  Locally_shortest_path operator()(const std::vector<Surface_location>& path);
  // For a closed path.
  Locally_shortest_path shorten_closed(const std::vector<Surface_location>& path, bool& is_geodesic)
  {
    initialize(path);
    return shorten_closed(is_geodesic);
  }
  // For a strip from a location to itself.
  Locally_shortest_path shorten_closed(const Surface_location& base, const Strip& strip,
                                       bool& is_geodesic)
  {
    m_begin = new_path_vertex(base);
    m_end = new_path_vertex(base);
    insert_shortest_path(strip, m_begin, m_end);
    merge_duplicates(m_begin, m_end);
    return shorten_closed(is_geodesic);
  }

private:
  void initialize(const std::vector<Surface_location>& path);
  void shorten();
  Locally_shortest_path shorten_closed(bool& is_geodesic);
  bool shorten_globally();
  bool shorten_locally(Index first, Index last);
  Index middle() const;
  bool move_base();
  bool remove(Index path_vertex);
  bool touches_vertex() const { return m_path_vertices[m_begin].next != m_end; }
  void compute_angles_at_base(double& left, double& right);
  bool shorten_around(Index& first, Index& last);
  Locally_shortest_path make_result();

  Index new_path_vertex(const Surface_location& location);
  void release(Index path_vertex);
  void link(Index a, Index b);
  double insert_shortest_path(Strip strip, Index first, Index last);
  void merge_duplicates(Index first, Index last);
  bool reroute_around(Strip& strip, Index first, Index last) const;
  void unfold(const Strip& strip, const Surface_location& begin, const Surface_location& end);
  void update_length_and_angles(Index path_vertex);
  bool update_edge(Index path_vertex);
  void update_segment(Index path_vertex);
  Index corner_at(const Surface_location& location, Index triangle) const;
  void compute_angles(Index path_vertex, double& left, double& right,
                      bool is_limited = false) const;

  const Surface_arrays& t;
  std::deque<Path_vertex> m_path_vertices; // a linked list; front() is the first one
  std::vector<Index> m_free_indices;
  Index m_begin = none, m_end = none;
  std::size_t m_number_of_visited_halfedges = 0;

  // Buffers for the strip that is processed
  Unfolded_strip m_unfolded;
  Funnel m_funnel;
};

// --------------------------------------------------------------------------------------- angles

// Angles are vectors: the cosine and the sine, times a positive factor. Sums of angles are products
// of complex numbers, because an arctangent for each angle takes longer than all other steps.

// Returns the angle from p to q; zero if one of them is zero. An angle outside of [0, full_angle]
// is set to the closest end.
Vec2 clamped_angle_between(const Vec2& p, const Vec2& q, const Vec2& full_angle)
{
  const Vec2 angle = rotated_back(q, p);
  if(angle[1] < 0. || (angle[0] == 0. && angle[1] == 0.))
    return {1., 0.};
  return cross(full_angle, angle) > 0. ? full_angle : angle;
}

// A sum of angles in [0, pi].
class Angle_sum
{
public:
  void add(const Vec2& angle)
  {
    m_remainder = rotated(m_remainder, angle);
    if(m_remainder[1] < 0. || (m_remainder[1] == 0. && m_remainder[0] < 0.))
    {
      m_remainder = -1. * m_remainder;
      m_half_turns += pi;
    }
  }
  double half_turns() const { return m_half_turns; } // in radians, at most the sum
  double value() const { return m_half_turns + std::atan2(m_remainder[1], m_remainder[0]); }

private:
  double m_half_turns = 0.;
  Vec2 m_remainder = {1., 0.}; // in [0, pi)
};

// Unfolds a strip to m_unfolded and counts the work.
void Geodesic_shortener::unfold(const Strip& strip, const Surface_location& begin,
                                const Surface_location& end)
{
  m_number_of_visited_halfedges += strip.halfedges.size() + 1;
  m_unfolded.unfold(t, strip, begin, end);
}

// Returns the corner of a triangle at which a location lies, or `none`.
Index Geodesic_shortener::corner_at(const Surface_location& location, Index triangle) const
{
  const auto barycentric = barycentric_in(t, triangle, location);
  for(Index k = 0; k < 3; ++k)
    if((*barycentric)[k] == 1.)
      return 3 * triangle + k;
  return none;
}

// Computes the length of the segment that starts at a path vertex, and its directions at both ends.
// The segment's strip is unfolded to m_unfolded.
void Geodesic_shortener::update_length_and_angles(Index index)
{
  Path_vertex& from = m_path_vertices[index];
  Path_vertex& to = m_path_vertices[from.next];
  const Strip& strip = from.strip;
  const Unfolded_strip& u = m_unfolded;
  from.length = norm(u.end);
  if(from.vertex != none)
    from.corner_out = corner_at(from.location, strip.triangle);
  if(to.vertex != none)
    to.corner_in = corner_at(to.location, strip.last_triangle(t));

  // The vectors of the halfedges from which the angles are measured
  Vec2 first_leg = u.first_leg, last_leg = u.last_leg;
  if(strip.halfedges.empty())
  {
    const auto corners = unfolded(t, strip.triangle);
    const auto halfedge_vector = [&](Index h) {
      return h == none ? Vec2{0., 0.} : corners[next_halfedge(h) % 3] - corners[h % 3];
    };
    first_leg = halfedge_vector(from.corner_out);
    last_leg = halfedge_vector(to.corner_in);
  }
  if(from.vertex != none)
    from.angle_out = clamped_angle_between(first_leg, u.end, cosine_and_sine(t, from.corner_out));
  if(to.vertex != none)
    to.angle_in = clamped_angle_between(last_leg, -1. * u.end, cosine_and_sine(t, to.corner_in));
}

// Computes the same without unfolding if the segment is an edge: its angles are zero or those of
// the triangle, without round-off errors. Otherwise, returns false.
bool Geodesic_shortener::update_edge(Index index)
{
  Path_vertex& from = m_path_vertices[index];
  Path_vertex& to = m_path_vertices[from.next];
  if(!from.strip.halfedges.empty() || from.vertex == none || to.vertex == none)
    return false;
  const Index corner_out = corner_at(from.location, from.strip.triangle),
              corner_in = corner_at(to.location, from.strip.triangle);
  if(corner_out == corner_in)
    return false;
  const bool is_halfedge = corner_in == next_halfedge(corner_out);
  from.corner_out = corner_out;
  to.corner_in = corner_in;
  from.length = t.length[is_halfedge ? corner_out : corner_in];
  from.angle_out = is_halfedge ? Vec2{1., 0.} : cosine_and_sine(t, corner_out);
  to.angle_in = is_halfedge ? cosine_and_sine(t, corner_in) : Vec2{1., 0.};
  return true;
}

// Computes the same for a segment that is not unfolded.
void Geodesic_shortener::update_segment(Index index)
{
  const Path_vertex& from = m_path_vertices[index];
  if(update_edge(index))
    return;
  unfold(from.strip, from.location, m_path_vertices[from.next].location);
  update_length_and_angles(index);
}

// -------------------------------------------------------------------------------- path vertices

Index Geodesic_shortener::new_path_vertex(const Surface_location& location)
{
  Index index;
  if(m_free_indices.empty())
  {
    index = static_cast<Index>(m_path_vertices.size());
    m_path_vertices.emplace_back();
  }
  else
  {
    index = m_free_indices.back();
    m_free_indices.pop_back();
    m_path_vertices[index] = Path_vertex();
  }
  m_path_vertices[index].location = location;
  m_path_vertices[index].vertex = vertex_of(t, location);
  return index;
}

void Geodesic_shortener::release(Index path_vertex)
{
  m_path_vertices[path_vertex].is_queued = false;
  m_free_indices.push_back(path_vertex);
}

void Geodesic_shortener::link(Index a, Index b)
{
  m_path_vertices[a].next = b;
  m_path_vertices[b].previous = a;
}

// Computes the total angles on the left and on the right of the path at a vertex. If `is_limited`,
// an angle above pi may be replaced by a smaller one that is at least pi.
void Geodesic_shortener::compute_angles(Index index, double& left, double& right,
                                        bool is_limited) const
{
  const Path_vertex& path_vertex = m_path_vertices[index];
  const Index corner_in = path_vertex.corner_in, corner_out = path_vertex.corner_out;
  const Vec2 &angle_in = path_vertex.angle_in, &angle_out = path_vertex.angle_out;
  // The right angle is counterclockwise from the direction to the previous path vertex to that to
  // the next one.
  const auto sum_angles = [&](bool counterclockwise)
  {
    Angle_sum total;
    total.add(counterclockwise ? rotated_back(cosine_and_sine(t, corner_in), angle_in) : angle_in);
    for(Index corner = corner_in;;)
    {
      corner = counterclockwise ? next_corner_ccw(t, corner) : next_corner_cw(t, corner);
      if(corner == none)
        return infinity;
      const Vec2 full_angle = cosine_and_sine(t, corner);
      if(corner == corner_out)
      {
        total.add(counterclockwise ? angle_out : rotated_back(full_angle, angle_out));
        return total.value();
      }
      if(corner == corner_in)
        return infinity; // the outgoing direction is in another fan of a nonmanifold vertex
      total.add(full_angle);
      if(is_limited && total.half_turns() > 0.)
        return total.half_turns();
    }
  };
  const double sine = cross(angle_in, angle_out);
  const double angle_difference =
      corner_in == corner_out ? std::atan2(std::abs(sine), dot(angle_in, angle_out)) : 0.;
  right = corner_in == corner_out && sine >= 0. ? angle_difference : sum_angles(true);
  left = corner_in == corner_out && sine <= 0. ? angle_difference : sum_angles(false);
}

// Extends a strip that ends at path vertex `first` such that it passes the path vertices from
// `first` to `last` and ends with the strip of `last`. It passes them on the side with the smaller
// total angle. Returns false if both angles are at least pi. The path vertices are at the same
// point in space and are treated as one: pi is subtracted for each connection between two of them.
bool Geodesic_shortener::reroute_around(Strip& strip, Index first, Index last) const
{
  double left = 0., right = 0.;
  for(Index index = first;; index = m_path_vertices[index].next)
  {
    double left_angle, right_angle;
    compute_angles(index, left_angle, right_angle, first == last);
    left += left_angle;
    right += right_angle;
    if(index == last)
      break;
    left -= pi;
    right -= pi;
  }
  if(!(std::min(left, right) < pi - angle_tolerance))
    return false;
  const bool counterclockwise = right <= left;
  for(Index index = first;; index = m_path_vertices[index].next)
  {
    const Path_vertex& path_vertex = m_path_vertices[index];
    const double sine = cross(path_vertex.angle_in, path_vertex.angle_out);
    Index corner = path_vertex.corner_in;
    if(corner != path_vertex.corner_out || (counterclockwise ? sine < 0. : sine > 0.))
      do
      {
        strip.append(t, counterclockwise ? previous_halfedge(corner) : corner);
        corner = counterclockwise ? next_corner_ccw(t, corner) : next_corner_cw(t, corner);
      } while(corner != path_vertex.corner_out);
    for(const Index h : path_vertex.strip.halfedges)
      strip.append(t, h);
    if(index == last)
      return true;
  }
}

// Replaces the path between two path vertices by the shortest path in a strip. Returns its length.
double Geodesic_shortener::insert_shortest_path(Strip strip, Index first, Index last)
{
  strip.trim(t, m_path_vertices[first].location, m_path_vertices[last].location);
  if(strip.halfedges.empty())
  {
    m_path_vertices[first].strip = std::move(strip);
    link(first, last);
    update_segment(first);
    return m_path_vertices[first].length;
  }
  unfold(strip, m_path_vertices[first].location, m_path_vertices[last].location);

  // The current bend is incident to the edges begin, ..., end - 1 of the strip. The path vertices
  // `first` and `last` are incident to no edge.
  const auto& halfedges = strip.halfedges;
  std::size_t begin = 0, end = 0;
  Index from = first;
  const auto fill_segment = [&](std::size_t next_begin)
  {
    Strip& segment = m_path_vertices[from].strip;
    segment.halfedges.clear();
    if(end <= next_begin)
    {
      segment.triangle = end == 0 ? strip.triangle : t.twin[halfedges[end - 1]] / 3;
      segment.halfedges.assign(halfedges.begin() + end, halfedges.begin() + next_begin);
    }
    else // both are endpoints of the same edge
      segment.triangle = halfedges[std::max(begin, next_begin)] / 3;
  };
  const std::vector<Bend>& bends = m_funnel.find_bends(t, strip, m_unfolded);
  if(bends.empty())
  {
    m_path_vertices[first].strip = std::move(strip);
    link(first, last);
    update_length_and_angles(first);
    return m_path_vertices[first].length;
  }
  for(const Bend& bend : bends)
  {
    Surface_location location;
    location.triangle = halfedges[bend.strip_index] / 3;
    location.barycentric = barycentric_at_corner(
        bend.is_left ? next_halfedge(halfedges[bend.strip_index]) : halfedges[bend.strip_index]);
    const Index path_vertex = new_path_vertex(location);
    fill_segment(bend.strip_index);
    link(from, path_vertex);
    from = path_vertex;
    begin = bend.strip_index;
    end = begin + 1;
    while(end < halfedges.size() &&
          (halfedges[end] == previous_halfedge(t.twin[halfedges[end - 1]])) == bend.is_left)
      ++end;
  }
  fill_segment(halfedges.size());
  link(from, last);

  double length = 0.;
  for(Index path_vertex = first; path_vertex != last;
      path_vertex = m_path_vertices[path_vertex].next)
  {
    Path_vertex& segment = m_path_vertices[path_vertex];
    segment.strip.trim(t, segment.location, m_path_vertices[segment.next].location);
    update_segment(path_vertex);
    length += segment.length;
  }
  return length;
}

// Merges consecutive path vertices at the same vertex, from `first` to `last`.
void Geodesic_shortener::merge_duplicates(Index first, Index last)
{
  for(Index index = first; index != last;)
  {
    Path_vertex& path_vertex = m_path_vertices[index];
    const Index next = path_vertex.next;
    Path_vertex& successor = m_path_vertices[next];
    if(path_vertex.vertex == none || path_vertex.vertex != successor.vertex ||
       !path_vertex.strip.halfedges.empty())
      index = next;
    else if(next != m_end)
    {
      path_vertex.strip = std::move(successor.strip);
      path_vertex.length = successor.length;
      path_vertex.corner_out = successor.corner_out;
      path_vertex.angle_out = successor.angle_out;
      link(index, successor.next);
      release(next);
      if(next == last)
        return;
    }
    else if(index != m_begin)
    {
      successor.corner_in = path_vertex.corner_in;
      successor.angle_in = path_vertex.angle_in;
      link(path_vertex.previous, next);
      release(index);
      return;
    }
    else
      return;
  }
}

// ---------------------------------------------------------------------------------------- paths

// Converts the input to strips between the vertices that it passes, and shortens it in each strip.
void Geodesic_shortener::initialize(const std::vector<Surface_location>& input)
{
  std::vector<Surface_location> path;
  for(const Surface_location& location : input)
  {
    const Surface_location location_in_path = canonical(t, location);
    if(path.empty() || !is_same_point(t, path.back(), location_in_path))
      path.push_back(location_in_path);
  }
  m_begin = new_path_vertex(path.front());
  Index path_vertex = m_begin;
  Strip strip;
  Index triangle = none;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const Index next_triangle = common_triangle(t, path[i], path[i + 1]);
    if(next_triangle == none)
      throw Invalid_argument_error(
          "Two consecutive locations of a path are not in a common triangle.");
    if(i == 0)
      strip.triangle = next_triangle;
    else if(next_triangle != triangle)
    {
      if(vertex_of(t, path[i]) != none)
      {
        const Index next = new_path_vertex(path[i]);
        insert_shortest_path(std::move(strip), path_vertex, next);
        path_vertex = next;
        strip = Strip();
        strip.triangle = next_triangle;
      }
      else
      {
        const Index h = halfedge_of(path[i]);
        strip.append(t, h / 3 == triangle ? h : t.twin[h]);
      }
    }
    triangle = next_triangle;
  }
  if(path.size() == 1)
    return;
  m_end = new_path_vertex(path.back());
  insert_shortest_path(std::move(strip), path_vertex, m_end);
  merge_duplicates(m_begin, m_end);
}

// Reroutes the path around all touched vertices with an angle below pi at once, so that strips
// become long. Returns false if there is no such vertex.
bool Geodesic_shortener::shorten_globally()
{
  bool is_changed = false;
  std::vector<Index> replaced_vertices;
  for(Index first = m_begin; first != m_end;)
  {
    Strip strip = m_path_vertices[first].strip;
    replaced_vertices.clear();
    Index last = m_path_vertices[first].next;
    while(last != m_end && reroute_around(strip, last, last))
    {
      replaced_vertices.push_back(last);
      last = m_path_vertices[last].next;
    }
    if(!replaced_vertices.empty())
    {
      is_changed = true;
      insert_shortest_path(std::move(strip), first, last);
      std::for_each(replaced_vertices.begin(), replaced_vertices.end(),
                    [&](Index path_vertex) { release(path_vertex); });
    }
    first = last;
  }
  merge_duplicates(m_begin, m_end);
  return is_changed;
}

// Reroutes the path around the path vertices between two others. Extends the range until it holds
// all path vertices at the same points. Returns false, and leaves the path as it is, if this does
// not shorten it.
bool Geodesic_shortener::shorten_around(Index& first, Index& last)
{
  while(first != m_begin && m_path_vertices[first].length == 0.)
    first = m_path_vertices[first].previous;
  while(last != m_end && m_path_vertices[m_path_vertices[last].previous].length == 0.)
    last = m_path_vertices[last].next;
  const Index cluster_begin = m_path_vertices[first].next,
              cluster_end = m_path_vertices[last].previous;
  Strip strip = m_path_vertices[first].strip;
  if(!reroute_around(strip, cluster_begin, cluster_end))
    return false;

  const Path_vertex saved_first = m_path_vertices[first], saved_last = m_path_vertices[last];
  double length = m_path_vertices[first].length;
  for(Index path_vertex = cluster_begin; path_vertex != last;
      path_vertex = m_path_vertices[path_vertex].next)
    length += m_path_vertices[path_vertex].length;
  if(insert_shortest_path(std::move(strip), first, last) < length)
  {
    for(Index path_vertex = cluster_begin;; path_vertex = m_path_vertices[path_vertex].next)
    {
      release(path_vertex);
      if(path_vertex == cluster_end)
        break;
    }
    return true;
  }
  // The gain is below round-off errors.
  for(Index path_vertex = m_path_vertices[first].next; path_vertex != last;
      path_vertex = m_path_vertices[path_vertex].next)
    release(path_vertex);
  m_path_vertices[first] = saved_first;
  m_path_vertices[last] = saved_last;
  return false;
}

// Reroutes the path around one touched vertex after the other until all angles are at least pi.
// Begins with the vertices from `first` to `last`. Returns whether the path has changed.
bool Geodesic_shortener::shorten_locally(Index first, Index last)
{
  std::deque<Index> queue;
  bool is_changed = false;
  const auto enqueue = [&](Index index)
  {
    if(index != m_begin && index != m_end && !m_path_vertices[index].is_queued)
    {
      m_path_vertices[index].is_queued = true;
      queue.push_back(index);
    }
  };
  const auto enqueue_range = [&](Index begin, Index end)
  {
    for(Index path_vertex = begin;; path_vertex = m_path_vertices[path_vertex].next)
    {
      enqueue(path_vertex);
      if(path_vertex == end)
        break;
    }
  };
  std::size_t size = 0;
  for(Index path_vertex = m_begin; path_vertex != m_end;
      path_vertex = m_path_vertices[path_vertex].next)
    size += m_path_vertices[path_vertex].strip.halfedges.size() + 1;
  enqueue_range(first, last);
  // Each rerouting shortens the path, so that the loop terminates. The limit is for surfaces on
  // which each shortens it by almost nothing.
  const std::size_t work_limit = m_number_of_visited_halfedges + 10000000 + 1000 * size;
  while(!queue.empty() && m_number_of_visited_halfedges < work_limit)
  {
    const Index index = queue.front();
    queue.pop_front();
    if(!m_path_vertices[index].is_queued)
      continue; // it has been merged or replaced since it was queued
    m_path_vertices[index].is_queued = false;
    first = m_path_vertices[index].previous;
    last = m_path_vertices[index].next;
    if(!shorten_around(first, last))
      continue;
    is_changed = true;
    enqueue_range(first, last);
    merge_duplicates(first, last);
  }
  return is_changed;
}

// ------------------------------------------------------------------------------------ closed paths

// Returns the touched vertex in the middle of the path.
Index Geodesic_shortener::middle() const
{
  double length = 0.;
  for(Index i = m_begin; i != m_end; i = m_path_vertices[i].next)
    length += m_path_vertices[i].length;
  double position = m_path_vertices[m_begin].length, best = infinity;
  Index result = none;
  for(Index i = m_path_vertices[m_begin].next; i != m_end; i = m_path_vertices[i].next)
  {
    const double distance = std::abs(position - 0.5 * length);
    if(distance < best)
    {
      best = distance;
      result = i;
    }
    position += m_path_vertices[i].length;
  }
  return result;
}

// Cuts the closed path open at the touched vertex in the middle, and shortens it at the previous
// base. Returns whether the path has changed.
bool Geodesic_shortener::move_base()
{
  const Index new_end = middle();
  // Joins the ends.
  const Index base = m_begin;
  m_path_vertices[base].corner_in = m_path_vertices[m_end].corner_in;
  m_path_vertices[base].angle_in = m_path_vertices[m_end].angle_in;
  link(m_path_vertices[m_end].previous, base);
  release(m_end);
  // Splits the new base.
  const Index new_begin = new_path_vertex(m_path_vertices[new_end].location);
  Path_vertex &begin = m_path_vertices[new_begin], &end = m_path_vertices[new_end];
  begin.strip = std::move(end.strip);
  begin.length = end.length;
  begin.corner_out = end.corner_out;
  begin.angle_out = end.angle_out;
  link(new_begin, end.next);
  m_begin = new_begin;
  m_end = new_end;
  return m_path_vertices[base].vertex == none ? remove(base) : shorten_locally(base, base);
}

// Removes a path vertex that is not at a vertex, and shortens the path. Returns true.
bool Geodesic_shortener::remove(Index index)
{
  const Path_vertex& removed = m_path_vertices[index];
  const Index first = removed.previous, last = removed.next;
  Strip strip = m_path_vertices[first].strip;
  if(strip.last_triangle(t) != removed.strip.triangle)
  {
    const Index h = halfedge_of(removed.location);
    strip.append(t, h / 3 == strip.last_triangle(t) ? h : t.twin[h]);
  }
  for(const Index h : removed.strip.halfedges)
    strip.append(t, h);
  insert_shortest_path(std::move(strip), first, last);
  release(index);
  merge_duplicates(first, last);
  shorten_locally(m_begin, m_end);
  return true;
}

// Computes the angles of the closed path at its base, which is a vertex.
void Geodesic_shortener::compute_angles_at_base(double& left, double& right)
{
  const Index joined = new_path_vertex(m_path_vertices[m_begin].location);
  Path_vertex& path_vertex = m_path_vertices[joined];
  path_vertex.corner_out = m_path_vertices[m_begin].corner_out;
  path_vertex.angle_out = m_path_vertices[m_begin].angle_out;
  path_vertex.corner_in = m_path_vertices[m_end].corner_in;
  path_vertex.angle_in = m_path_vertices[m_end].angle_in;
  compute_angles(joined, left, right);
  release(joined);
}

Locally_shortest_path Geodesic_shortener::shorten_closed(bool& is_geodesic)
{
  if(m_end == none)
  {
    is_geodesic = true;
    return make_result();
  }
  shorten();
  is_geodesic = false;
  while(touches_vertex() && !is_geodesic)
    is_geodesic = !move_base();
  Locally_shortest_path result = make_result();
  if(m_path_vertices[m_begin].vertex != none && result.locations.size() > 1)
  {
    Touched_vertex base{0, 0., 0.};
    compute_angles_at_base(base.left_angle, base.right_angle);
    is_geodesic =
        is_geodesic || std::min(base.left_angle, base.right_angle) >= pi - angle_tolerance;
    result.touched_vertices.insert(result.touched_vertices.begin(), base);
  }
  return result;
}

// ---------------------------------------------------------------------------------------- results

// Returns the path with its points on crossed edges.
Locally_shortest_path Geodesic_shortener::make_result()
{
  Locally_shortest_path result;
  const auto add = [&](const Surface_location& location)
  {
    if(result.locations.empty() || !is_same_point(t, result.locations.back(), location))
      result.locations.push_back(location);
  };
  if(m_end == none)
    return {{m_path_vertices[m_begin].location}, 0., {}};
  for(Index index = m_begin; index != m_end; index = m_path_vertices[index].next)
  {
    const Path_vertex& path_vertex = m_path_vertices[index];
    add(path_vertex.location);
    if(index != m_begin)
    {
      Touched_vertex touched{result.locations.size() - 1, 0., 0.};
      compute_angles(index, touched.left_angle, touched.right_angle);
      result.touched_vertices.push_back(touched);
    }
    result.length += path_vertex.length;
    unfold(path_vertex.strip, path_vertex.location, m_path_vertices[path_vertex.next].location);
    for(std::size_t i = 0; i < path_vertex.strip.halfedges.size(); ++i)
    {
      // The fraction of the edge, from its right to its left endpoint.
      const double right = -cross(m_unfolded.end, m_unfolded.right[i]);
      const double left = cross(m_unfolded.end, m_unfolded.left[i]);
      double fraction = right / (left + right);
      if(!(left + right > 0.)) // the path runs along the edge, or has length zero
        fraction = norm(m_unfolded.right[i]) <= norm(m_unfolded.left[i]) ? 0. : 1.;
      fraction = std::clamp(fraction, 0., 1.);
      Surface_location location;
      location.triangle = path_vertex.strip.halfedges[i] / 3;
      location.barycentric = barycentric_on_halfedge(path_vertex.strip.halfedges[i], fraction);
      add(location);
    }
  }
  add(m_path_vertices[m_end].location);
  return result;
}

Locally_shortest_path Geodesic_shortener::operator()(const std::vector<Surface_location>& path)
{
  initialize(path);
  if(m_end != none)
    shorten();
  return make_result();
}

void Geodesic_shortener::shorten()
{
  // Global steps are cheaper while most touched vertices are rerouted. Local steps are cheaper for
  // the last ones. With at most 64 global steps, 405 loops on 19 meshes took 0.087 s, with at most
  // 16 steps 0.092 s, and with at most 8 steps 0.104 s.
  for(int i = 0; i < 64 && shorten_globally(); ++i)
    ;
  shorten_locally(m_begin, m_end);
}

// Checks the arguments of the functions.
void check_path(const Surface_arrays& t, const std::vector<Surface_location>& path)
{
  if(path.empty())
    throw Invalid_argument_error("The path has no location.");
  if(t.is_cloud())
    throw Unsupported_surface_error(
        "Shortening a path requires a mesh, because the triangles of a cloud are not connected.");
}

} // namespace

Locally_shortest_path shorten_geodesic(const Surface_arrays& t,
                                       const std::vector<Surface_location>& path)
{
  check_path(t, path);
  return Geodesic_shortener(t)(path);
}

Locally_shortest_path shorten_closed_geodesic(const Surface_arrays& t,
                                              const std::vector<Surface_location>& path,
                                              bool& is_geodesic)
{
  check_path(t, path);
  return Geodesic_shortener(t).shorten_closed(path, is_geodesic);
}

Locally_shortest_path shorten_closed_geodesic(const Surface_arrays& t, const Surface_location& base,
                                              const Strip& strip, bool& is_geodesic)
{
  return Geodesic_shortener(t).shorten_closed(base, strip, is_geodesic);
}

} // namespace CGAL::Geodesic_processing::internal
