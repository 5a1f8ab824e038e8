// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include "core/edges.h"
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "core/prefetch.h"
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// State of a site.
constexpr Index reached_flag = 1; // it is among the reached
constexpr Index final_flag = 2;   // it has left the queue
constexpr Index source_flag = 4;  // it lies on a source: its front leaves in all directions
constexpr Index tentative_flag =
    8; // it was reached along a side although the front came otherwise:
       //   its direction is not to be trusted
constexpr Index straight_flag = 16; // its source is a segment: the front may be a straight line
constexpr Index arrival_flags = source_flag | tentative_flag | straight_flag;
constexpr Index correction_unit = 32;
constexpr Index max_corrections = 4096; // most sites need none, in webs of needles some need
    //   thousands; a bound for inputs that contradict themselves

// A final site is corrected, and what others took from it is taken back, when its distance falls by
// more than this fraction: a front fitted to a distance too long bends too much, and gives what later
// offers cannot undo, distances too short.  On an irregular square 1e-8 left errors of 2e-4 where
// 1e-12 leaves rounding, at the same cost.
constexpr double correction_tolerance = 1e-12;
// On a curved surface, where a front errs anyway, that is done only when it falls by more than this
// fraction of a side: the same errors, and a quarter faster where half of the triangles are obtuse.
constexpr double invalidation_ratio = 1e-2;
// A neighbour that spread before this site had a distance spreads once more into the triangle between when it
// is nearer, by more than this fraction of the side, than the front of this site makes it.  On the side of a
// cube blown up to a sphere distances were off by up to 2.8 %, 0.04 % in the mean; with this fraction by 0.20 and
// 0.007 %, with 1e-2 by 0.44 and 0.013 %, with none by 0.20 and 0.0066 %.
constexpr double reentry_ratio = 1e-3;
// A spoke that leaves the source's line by more than this sine, beyond a half turn, lies in the shadow
// of its site: the front gets there another way.
constexpr double shadow_tolerance = -1e-12;
// Offers to a site that waits count when they are smaller by more than this fraction: the least of many
// that differ by their roundings is too small, and the more so the farther the front goes.
constexpr double relaxation_tolerance = 1e-14;
// What is taken back in all, as a multiple of the sites reached: scans need 0.2, webs of needles one,
// and where sheets of needles fold over each other (a lantern of Schwarz) it has no end.  From there
// on a site is corrected a few times only.
constexpr std::size_t max_invalidation_ratio = 4;
constexpr std::size_t min_invalidation_budget = 20000; // which every query may, small ones too
constexpr Index max_corrections_over_budget = 8;

// The circular front that passes a site x at the origin and is seen at y, behind the side that runs
// from x along the first axis for `length`.
struct Circular_front
{
  Vec2 source;      // unit vector from x to where the front comes from; second coordinate <= 0
  double curvature; // of the front at x
};

// The distance gained from x to y, and the unit vector at y back to the source.  False when the
// straight line from the source does not cross the side.
bool cross_edge(const Circular_front& circle, double length, const Vec2& y, double& gain,
                Vec2& back)
{
  const Vec2 backward = circle.source - circle.curvature * y;
  if(backward[1] >= 0.)
    return false;
  const double scaled_crossing =
      y[0] * backward[1] - y[1] * backward[0]; // along the side, times b[1] < 0
  if(scaled_crossing > 0. || scaled_crossing < length * backward[1])
    return false;
  const double length_of_backward = norm(backward);
  // |y - r u| - r with r = 1 / curvature, which stays exact for straight fronts.
  gain = (dot(y, y) * circle.curvature - 2. * dot(y, circle.source)) / (length_of_backward + 1.);
  back = (1. / length_of_backward) * backward;
  return true;
}

// Sets the source's direction of a circle of known curvature that gains `difference` along a side of
// this length; false when there is none.
bool fit_source_direction(double length, double difference, Circular_front& circle)
{
  const double cosine = -difference / length + 0.5 * circle.curvature * (length - difference) *
                                                   (length + difference) / length;
  if(!(std::abs(cosine) <= 1.))
    return false;
  circle.source = {cosine, -std::sqrt((1. - cosine) * (1. + cosine))};
  return true;
}

// By how much more a front gains along a side of this length than a circle of this curvature does, where
// `cosine` is that of the angle between side and source.
double excess_gain(double curvature, double length, double difference, double cosine)
{
  return difference + length * cosine -
         0.5 * curvature * (length - difference) * (length + difference);
}

// The curvature at x of the circle that has the source's direction at x and gains `difference`
// along a side of this length, or `least` where that is more.  With d = difference, l = length, c =
// cosine of the angle between side and source, |l e - r u| = r + d gives
// 1 / r = 2 (d + l c) / (l^2 - d^2).  What it exceeds `least` by counts only beyond the rounding of
// distances of this size: taken as it is, rounding only ever bends, and grows along the way (1e-10
// after 300 sides of a flat square, instead of 1e-15).
double fitted_curvature(double min_curvature, double length, double difference, double cosine,
                        double distance)
{
  const double denominator = (length - difference) * (length + difference);
  const double excess_of_straight_front = difference + length * cosine;
  const bool is_larger =
      denominator > 0. && excess_gain(min_curvature, length, difference, cosine) > 1e-11 * distance;
  return is_larger ? 2. * excess_of_straight_front / denominator : min_curvature;
}

// A vector perpendicular to the unit vector `from`, turned with it the short way to the line of the
// unit vector `to`: across a sharp edge this unfolds, where a projection would bend it to the edge.
Vec3 rotated_between(const Vec3& v, const Vec3& from, const Vec3& to)
{
  const double cosine = dot(from, to);
  const Vec3 axis = cosine < 0. ? -1. * to : to;
  return v - (dot(v, axis) / (1. + std::abs(cosine))) * (from + axis);
}

// The sites of targets, and how far past each the front must be before it is final: by the longest
// side around it, as no triangle can then give it a smaller distance.
std::vector<std::pair<Index, double>>
finalization_delays(const Surface_arrays& t, const std::vector<Surface_location>& targets)
{
  std::vector<std::pair<Index, double>> result;
  for(const Surface_location& target : targets)
    for(int k = 0; k < (target.triangle == none ? 1 : 3); ++k)
    {
      const Index vertex =
          target.triangle == none ? target.vertex : t.corner[3 * target.triangle + k];
      double max_edge_length = 0.;
      for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
        for(const Index h : {t.ring[i], next_halfedge(t.ring[i]), previous_halfedge(t.ring[i])})
          max_edge_length = std::max(max_edge_length, t.length[h]);
      result.emplace_back(vertex, max_edge_length);
    }
  return result;
}

} // namespace

// What comes to a site.
struct Front::Arrival
{
  double distance;
  Vec2 direction;
  Index corner;
  Index flags;
  double delay; // how much later than its distance it leaves the queue
};

Front::Front(std::shared_ptr<const Surface_arrays> triangles, Front_kind kind)
    : m_triangles(std::move(triangles)), m_kind(kind),
      m_vertices(m_triangles->number_of_vertices()),
      m_sources(m_triangles->number_of_vertices(), none), m_queue(m_triangles->number_of_vertices())
{
  if(kind == Front_kind::planar || (kind == Front_kind::euclidean && !m_triangles->is_cloud()))
    m_fans = shared_vertex_fans(*m_triangles, kind == Front_kind::planar);
  if(kind == Front_kind::euclidean)
    m_directions.resize(m_vertices.size());
  if(kind == Front_kind::euclidean && m_triangles->is_cloud())
    m_components =
        std::make_shared<const std::vector<Index>>(triangle_components(*m_triangles).first);
}

bool Front::run(const std::vector<Front_source>& sources, const Front_limits& limits)
{
  const Surface_arrays& t = *m_triangles;
  for(const Index vertex : m_reached)
  {
    m_vertices[vertex] = Vertex_data{};
    m_sources[vertex] = none;
  }
  m_reached.clear();
  m_queue.clear();
  m_corrected_vertices.clear();
  m_number_invalidated = 0;
  m_max_distance = limits.maximum_distance;
  m_slowness = limits.slowness;
  m_known_distance = limits.known_distance;
  m_improves_known_distance = true;
  // A Euclidean front with speeds is a planar one.
  if(m_slowness && m_kind == Front_kind::euclidean && !m_has_splits)
  {
    m_fans = shared_vertex_fans(t, true);
    m_has_splits = true;
  }
  initialize(sources);

  std::vector<std::pair<Index, double>> targets = finalization_delays(t, limits.targets);
  const bool has_targets = !targets.empty();

  bool is_finished = true;
  for(std::size_t number_of_visits = 0; !m_queue.empty(); ++number_of_visits)
  {
    const Vertex_queue::Entry entry = m_queue.front();
    // Sites that wait leave the queue late: those behind may be nearer than this one.
    const double distance = m_vertices[entry.vertex].distance;
    if(distance > limits.maximum_distance || distance == infinity)
    {
      m_queue.pop();
      continue;
    }
    while(!targets.empty() &&
          m_vertices[targets.back().first].distance + targets.back().second < entry.key)
      targets.pop_back();
    if(has_targets && targets.empty())
      break;
    if(limits.callback && number_of_visits % 4096 == 0 &&
       !limits.callback(std::min(1., double(number_of_visits) / double(m_vertices.size()))))
    {
      is_finished = false;
      break;
    }
    m_queue.pop();
    // What comes next is mostly known already: what lies around it is on its way while this one spreads.
    if(!m_queue.empty())
    {
      prefetch_around(m_queue.front().vertex);
      if(m_known_distance)
        prefetch(m_known_distance->data() + m_queue.front().vertex);
    }
    Vertex_data& vertex = m_vertices[entry.vertex];
    vertex.state |= final_flag;
    m_improves_known_distance =
        !m_known_distance ||
        (m_kind != Front_kind::dijkstra && vertex.distance < (*m_known_distance)[entry.vertex]);
    if(!m_improves_known_distance && !may_improve_neighbors(entry.vertex))
      continue;
    switch(m_kind)
    {
    case Front_kind::dijkstra:
      propagate_along_edges(entry.vertex);
      break;
    case Front_kind::planar:
      propagate_planar(entry.vertex);
      break;
    case Front_kind::euclidean:
      if(m_slowness)
        propagate_planar(entry.vertex);
      else if(t.is_cloud())
        propagate_on_cloud(entry.vertex);
      else
        propagate_euclidean(entry.vertex);
      break;
    }
    if(!m_corrected_vertices.empty())
      invalidate_descendants();
  }

  // Sites that never left the queue were not reached.
  const auto is_not_final = [&](Index vertex)
  {
    if(m_vertices[vertex].state & final_flag)
      return false;
    m_vertices[vertex] = Vertex_data{};
    m_sources[vertex] = none;
    return true;
  };
  m_reached.erase(std::remove_if(m_reached.begin(), m_reached.end(), is_not_final),
                  m_reached.end());
  m_queue.clear();
  return is_finished;
}

void Front::prefetch_around(Index vertex) const
{
  if(!m_fans)
    return prefetch(m_triangles->ring.data() + m_triangles->ring_begin[vertex]);
  const Vertex_fans::Offsets& first = m_fans->begin[vertex];
  // Lines of memory: four hold the spokes of a site of six neighbours, two hold three splits.  They may
  // lie behind what there is, where no pointer leads.
  const auto prefetch_lines = [](const void* address, std::uintptr_t number_of_lines)
  {
    for(std::uintptr_t line = 0; line < number_of_lines; ++line)
      prefetch(
          reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(address) + 64 * line));
  };
  prefetch_lines(m_fans->edges.data() + first.edge, 4);
  if(m_directions.empty())
    return prefetch_lines(m_fans->splits.data() + first.split, 2);
  prefetch(m_triangles->ring.data() + first.ring);
  prefetch(&m_directions[vertex]);
}

void Front::initialize(const std::vector<Front_source>& sources)
{
  const Surface_arrays& t = *m_triangles;
  m_source_pieces.clear();
  m_has_single_source = sources.size() == 1;
  m_offsets.clear();
  for(const Front_source& source : sources)
    m_offsets.push_back(source.offset);
  m_min_offset = infinity;
  for(const Front_source& source : sources)
    m_min_offset = std::min(m_min_offset, source.offset);
  for(Index i = 0; i < sources.size(); ++i)
  {
    const std::vector<Surface_location>& polyline = sources[i].polyline;
    if(polyline.size() == 1)
    {
      for(const Index triangle : triangles_at(t, polyline[0]))
        initialize_triangle(triangle, polyline[0], polyline[0], sources[i].offset, i);
      if(const Index vertex = vertex_of(t, polyline[0]); vertex != none)
        initialize_vertex(vertex, sources[i].offset, 0, i);
    }
    for(std::size_t k = 1; k < polyline.size(); ++k)
      for(const Index triangle : triangles_at(t, polyline[k - 1]))
        initialize_triangle(triangle, polyline[k - 1], polyline[k], sources[i].offset, i);
  }
  std::sort(m_source_pieces.begin(), m_source_pieces.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
}

void Front::initialize_vertex(Index vertex, double distance, Index flags, Index source)
{
  relax(vertex, {distance, {1., 0.}, none, source_flag | flags, 0.}, source);
}

// Gives the corners of a triangle their distances to the part of a source that lies in it.
void Front::initialize_triangle(Index triangle, const Surface_location& begin,
                                const Surface_location& end, double offset, Index source)
{
  const Surface_arrays& t = *m_triangles;
  const auto p = barycentric_in(t, triangle, begin), q = barycentric_in(t, triangle, end);
  if(!p || !q)
    return;
  const Surface_location local_begin = {triangle, none, *p}, local_end = {triangle, none, *q};
  const double slowness = m_slowness ? (*m_slowness)[triangle] : 1.;
  const auto corners = unfolded(t, triangle);
  // A segment sends a straight front out; past its ends the fitted curvature bends it.
  const Vec2 at_begin = unfolded_point(corners, *p), at_end = unfolded_point(corners, *q);
  const Index straight = norm(at_end - at_begin) > 0. ? straight_flag : 0;
  // What comes from a corner is told by the corner's distance.
  if(straight || corner_of(local_begin) == none)
    m_source_pieces.push_back({triangle, {{local_begin, local_end}, offset, source}});
  for(Index k = 0; k < 3; ++k)
  {
    const Index corner = 3 * triangle + k, vertex = t.corner[corner];
    bool is_inside = false;
    const Vec2 nearest = closest_point_on_segment(corners[k], at_begin, at_end, is_inside);
    const Vec2 to_nearest = nearest - corners[k];
    const double length = norm(to_nearest);
    if(length == 0.)
      initialize_vertex(vertex, offset, straight, source);
    else if(slowness < infinity)
    {
      // Without directions, and on a cloud, the predecessor: where the nearest point is a site.
      const bool stores_corner = has_directions() && !t.is_cloud();
      const Index nearest_vertex =
          is_inside ? none : vertex_of(t, nearest == at_begin ? local_begin : local_end);
      relax(vertex,
            {offset + slowness * length,
             in_corner_frame((1. / length) * to_nearest, corners, corner),
             stores_corner ? corner : nearest_vertex, straight, 0.},
            source);
    }
  }
}

// A unit vector of a triangle's layout, as the site at one of its corners keeps it.
Vec2 Front::in_corner_frame(const Vec2& vector, const std::array<Vec2, 3>& corners,
                            Index corner) const
{
  const Surface_arrays& t = *m_triangles;
  const Vec2 edge = corners[next_halfedge(corner) % 3] - corners[corner % 3];
  const double length = norm(edge);
  if(length == 0.)
    return {1., 0.};
  const Vec2 result = rotated_back(vector, (1. / length) * edge);
  if(!t.is_cloud())
    return result;
  const Vec3 origin = t.point[t.corner[corner]];
  const Vec3 axis_1 = unit(t.point[t.corner[next_halfedge(corner)]] - origin);
  const Vec3 third = t.point[t.corner[previous_halfedge(corner)]] - origin;
  const Vec3 axis_2 = unit(third - dot(third, axis_1) * axis_1);
  return tangent_coordinates(t.corner[corner], result[0] * axis_1 + result[1] * axis_2);
}

bool Front::relax(Index v, const Arrival& arrival, Index source)
{
  if(!m_improves_known_distance && !(arrival.distance < (*m_known_distance)[v]))
    return false;
  // Without directions nobody asks for what is not final.
  if(arrival.distance > m_max_distance && !has_directions())
    return false;
  Vertex_data& vertex = m_vertices[v];
  const bool is_final = vertex.state & final_flag;
  if(is_final)
  {
    const Index max_corrections_here =
        can_invalidate() ? max_corrections : max_corrections_over_budget;
    if(!has_directions() || vertex.state >= max_corrections_here * correction_unit ||
       arrival.distance >=
           vertex.distance - correction_tolerance * (vertex.distance - m_min_offset))
      return false;
    vertex.state += correction_unit;
    if(m_fans && needs_invalidation(v, vertex.distance - arrival.distance))
      m_corrected_vertices.push_back(v);
  }
  else if(arrival.distance >= vertex.distance)
  {
    // The same way, but now known to be the front's own.
    const bool is_better = arrival.distance == vertex.distance && (vertex.state & tentative_flag) &&
                           !(arrival.flags & tentative_flag);
    if(!is_better)
      return false;
  }
  const bool is_reached = vertex.state & reached_flag;
  vertex.distance = arrival.distance;
  if(!m_directions.empty())
    m_directions[v] = arrival.direction;
  vertex.corner = arrival.corner;
  vertex.state = (vertex.state & ~arrival_flags) | arrival.flags | reached_flag;
  m_sources[v] = source;
  // A site that knows no direction yet waits as long as the front may take along the side, so that
  // what comes through a triangle, as it should, comes first.
  if(is_reached)
    m_queue.push(v, arrival.distance + arrival.delay);
  else
  {
    m_reached.push_back(v);
    m_queue.insert(v, arrival.distance + arrival.delay);
    if(m_fans)
      prefetch(&m_fans->begin[v]);
  }
  return true;
}

// Whether a site that does not improve what is known has a neighbour where its front still may.
bool Front::may_improve_neighbors(Index vertex) const
{
  if(!m_fans)
    return true;
  const double distance = m_vertices[vertex].distance;
  for(Index i = m_fans->begin[vertex].edge; i < m_fans->begin[vertex + 1].edge; ++i)
    if(const Index end = m_fans->edges[i].vertex;
       distance < (*m_known_distance)[end] && distance < m_vertices[end].distance)
      return true;
  return false;
}

bool Front::can_invalidate() const
{
  return m_number_invalidated <=
         min_invalidation_budget + max_invalidation_ratio * m_reached.size();
}

bool Front::needs_invalidation(Index vertex, double correction) const
{
  const Vertex_fans::Fan_edge& edge = m_fans->edges[m_fans->begin[vertex].edge];
  return !(edge.flags & Vertex_fans::Fan_edge::is_curved) ||
         correction > invalidation_ratio * edge.length;
}

// Forgets what came through triangles with a corrected corner, and so on, and lets those around
// that are final spread once more.
void Front::invalidate_descendants()
{
  const Surface_arrays& t = *m_triangles;
  const Vertex_fans& s = *m_fans;
  if(!can_invalidate())
    return m_corrected_vertices.clear();
  std::vector<Index> invalidated;
  const auto invalidate_around = [&](Index from)
  {
    for(Index i = s.begin[from].edge; i < s.begin[from + 1].edge; ++i)
    {
      const Index v = s.edges[i].vertex;
      Vertex_data& vertex = m_vertices[v];
      if(vertex.distance == infinity || (vertex.state & source_flag) || vertex.corner == none ||
         (t.corner[next_halfedge(vertex.corner)] != from &&
          t.corner[previous_halfedge(vertex.corner)] != from))
        continue;
      vertex.distance = infinity;
      vertex.state &= ~(final_flag | arrival_flags);
      invalidated.push_back(v);
    }
  };
  for(const Index vertex : m_corrected_vertices)
    invalidate_around(vertex);
  m_corrected_vertices.clear();
  for(std::size_t i = 0; i < invalidated.size(); ++i)
    invalidate_around(invalidated[i]);
  m_number_invalidated += invalidated.size();
  for(const Index vertex : invalidated)
    for(Index i = s.begin[vertex].edge; i < s.begin[vertex + 1].edge; ++i)
      if(const Index end = s.edges[i].vertex; m_vertices[end].state & final_flag)
        m_queue.push(end, m_vertices[end].distance);
}

// Offers the far end of a spoke what the site gives along it.
void Front::relax_along_edge(Index vertex, const Fan_position& position, Index flags)
{
  const Surface_arrays& t = *m_triangles;
  const Vertex_fans::Fan_edge& edge = m_fans->edges[position.edge];
  const double distance = m_vertices[vertex].distance + edge.length;
  if(!(distance <= m_vertices[edge.vertex].distance))
    return;
  // At the far end the side leaves its corner in the triangle before the spoke; at a border, it
  // arrives at the corner in the triangle after it.
  Arrival arrival = {distance, {1., 0.}, none, flags, flags & tentative_flag ? edge.length : 0.};
  const bool has_before = position.edge > m_fans->begin[vertex].edge &&
                          ((&edge)[-1].flags & Vertex_fans::Fan_edge::has_triangle);
  if(has_before)
    arrival.corner = previous_halfedge(t.ring[position.ring - 1]);
  else if(const Index corner = t.ring[position.ring]; t.twin[corner] != none)
    arrival.corner = t.twin[corner];
  else
  {
    arrival.corner = next_halfedge(corner);
    arrival.direction = corner_angle(t, arrival.corner);
  }
  relax(edge.vertex, arrival, m_sources[vertex]);
}

void Front::relax_all_edges(Index vertex, Index flags)
{
  Fan_position position = {m_fans->begin[vertex].edge, m_fans->begin[vertex].ring};
  for(; position.edge < m_fans->begin[vertex + 1].edge; ++position.edge)
  {
    relax_along_edge(vertex, position, flags);
    if(m_fans->edges[position.edge].flags & Vertex_fans::Fan_edge::has_triangle)
      ++position.ring;
  }
}

void Front::propagate_along_edges(Index v)
{
  const double distance = m_vertices[v].distance;
  const Index source = m_sources[v];
  const auto relax_edge = [&](Index target, double gain)
  {
    if(distance + gain < m_vertices[target].distance)
      relax(target, {distance + gain, {1., 0.}, v, 0, 0.}, source);
  };
  if(m_kind == Front_kind::dijkstra)
    for_each_edge(*m_triangles, m_slowness.get(), v, relax_edge);
  else
    for_each_graph_edge(*m_triangles, m_slowness.get(), v, relax_edge);
}

// Kimmel and Sethian 1998: the front crosses a triangle as a straight line, from two sites that are
// final to a third that is not.
void Front::propagate_planar(Index v)
{
  const Surface_arrays& t = *m_triangles;
  const Vertex_fans& s = *m_fans;
  if(t.is_cloud())
    propagate_along_edges(v);
  const Vertex_data* const vertices = m_vertices.data();
  const auto is_final = [vertices](Index vertex)
  { return (vertices[vertex].state & final_flag) != 0; };
  const double distance = vertices[v].distance;
  const Index source = m_sources[v];

  // The star holds the triangles that the spokes have, in the same order.
  const Index* triangle = m_slowness ? t.ring.data() + t.ring_begin[v] : nullptr;
  double slowness_before = infinity; // slowness of the triangle before the spoke
  const Vertex_fans::Fan_edge* const end = s.edges.data() + s.begin[v + 1].edge;
  for(const Vertex_fans::Fan_edge* edge = s.edges.data() + s.begin[v].edge; edge != end; ++edge)
  {
    double slowness_after = infinity;
    if(edge->flags & Vertex_fans::Fan_edge::has_triangle)
      slowness_after = m_slowness ? (*m_slowness)[*triangle++ / 3] : 1.;
    if(!is_final(edge->vertex))
    {
      double best_distance = distance + std::min(slowness_before, slowness_after) * edge->length;
      Index predecessor = v;
      const auto update_from_pair =
          [&](const Vertex_fans::Fan_edge& other, const Vec2& opening, double slowness)
      {
        bool is_nearer_to_other;
        const double new_distance = planar_update(
            v, other.vertex, other.length, edge->length * opening, slowness, is_nearer_to_other);
        if(new_distance < best_distance)
        {
          best_distance = new_distance;
          predecessor = is_nearer_to_other ? other.vertex : v;
        }
      };
      if(slowness_after < infinity && !(edge->flags & Vertex_fans::Fan_edge::is_obtuse_split) &&
         is_final(edge[1].vertex))
        update_from_pair(edge[1], edge->opening, slowness_after);
      if(slowness_before < infinity &&
         !(edge[-1].flags & Vertex_fans::Fan_edge::is_next_obtuse_split) &&
         is_final(edge[-1].vertex))
        update_from_pair(edge[-1], edge[-1].opening, slowness_before);
      if(best_distance < vertices[edge->vertex].distance)
        relax(edge->vertex, {best_distance, {1., 0.}, predecessor, 0, 0.}, source);
    }
    slowness_before = slowness_after;
  }

  for(Index i = s.begin[v].split; i < s.begin[v + 1].split; ++i)
  {
    const Vertex_fans::Split& split = s.splits[i];
    if(is_final(split.target) || !is_final(split.along))
      continue;
    bool is_nearer_to_along;
    const double slowness = m_slowness ? (*m_slowness)[split.corner / 3] : 1.;
    const double new_distance =
        planar_update(v, split.along, split.base, split.apex, slowness, is_nearer_to_along);
    if(new_distance < m_vertices[split.target].distance)
      relax(split.target, {new_distance, {1., 0.}, split.neighbor, 0, 0.}, source);
  }
}

// What a straight front that passes x and z gives a site that lies at `apex` when the base, of this
// length, runs from x along the first axis to z; infinity when it does not come through between them.
double Front::planar_update(Index x, Index z, double base, const Vec2& apex, double slowness,
                            bool& is_nearer_to_z) const
{
  if(!have_same_source(x, z))
    return infinity;
  const double distance_at_x = m_vertices[x].distance, travel_time = slowness * base;
  const double slope = (m_vertices[z].distance - distance_at_x) / travel_time;
  if(!(std::abs(slope) < 1.) || !(travel_time < infinity))
    return infinity;
  const Straight_front front(base, slope, apex);
  is_nearer_to_z = front.is_closer_to_end;
  return distance_at_x + slowness * front.delay;
}

void Front::propagate_euclidean(Index v)
{
  const Index state = m_vertices[v].state;
  if(state & source_flag)
    return relax_all_edges(v, state & straight_flag);
  if(state & tentative_flag)
    return propagate_without_direction(v);
  // In the shadow of a saddle, behind a border, and in the other fans of a pinched site the site is a
  // source of its own.
  if(!propagate_around(v))
    relax_all_edges(v, state & straight_flag);
}

// A site hands on its front through the triangles that see it come: from the triangle that it came
// through, both ways around the site, as long as the source lies within a half turn of the side
// that is crossed.  Whether that is all around it.
bool Front::propagate_around(Index v)
{
  const Vertex_fans& s = *m_fans;
  const Vertex_data& from = m_vertices[v];
  const Index straight = from.state & straight_flag;
  const Vec2 direction = m_directions[v];
  const double min_curvature = 1. / (from.distance - offset_at(v));
  // Triangles are known by the spokes that they follow; those of the fan are begin .. end - 1.
  const Fan_position entry = fan_position(*m_triangles, s, v, from.corner);
  Index begin = entry.edge, end = entry.edge + 1;
  while(begin > s.begin[v].edge && (s.edges[begin - 1].flags & Vertex_fans::Fan_edge::has_triangle))
    --begin;
  while(s.edges[end].flags & Vertex_fans::Fan_edge::has_triangle)
    ++end;
  const bool is_closed = s.edges[end].flags & Vertex_fans::Fan_edge::is_repeated;
  const bool is_only_fan = end - begin == s.begin[v + 1].ring - s.begin[v].ring;
  const auto position_of = [&](Index edge) {
    return Fan_position{edge, entry.ring + edge - entry.edge};
  };
  const auto opening = [&](Index triangle) -> const Vec2& { return s.edges[triangle].opening; };
  // A lit side whose end no triangle reaches gets the side's own length, but no direction.
  const Index tentative_flags = tentative_flag | straight;
  relax_along_edge(v, position_of(entry.edge), tentative_flags);
  relax_along_edge(v, position_of(entry.edge + 1), tentative_flags);

  // Counterclockwise; `angle` is the one between the source and the side about to be crossed.
  Index number_of_triangles = 1, left = entry.edge;
  Vec2 angle = rotated_back(opening(left), direction);
  angle[1] = std::max(angle[1], 0.);
  for(;;)
  {
    if(++left == end)
    {
      if(!is_closed)
        break;
      left = begin;
    }
    if(left == entry.edge)
      return is_only_fan;
    const Vec2& opening_angle = opening(left);
    const Vec2 next_angle = rotated(angle, opening_angle);
    if(next_angle[1] >= shadow_tolerance)
      update_circular(v, position_of(left), false, opening_angle, angle, min_curvature);
    ++number_of_triangles;
    angle = next_angle;
    if(angle[1] < 0.)
      break;
    relax_along_edge(v, position_of(left + 1), tentative_flags);
  }

  // Clockwise, until it meets the other way.
  angle = {direction[0], std::max(direction[1], 0.)};
  for(Index right = entry.edge;;)
  {
    if(right == begin)
    {
      if(!is_closed)
        break;
      right = end;
    }
    --right;
    const Vec2& opening_angle = opening(right);
    const Vec2 next_angle = rotated(angle, opening_angle);
    if(next_angle[1] >= shadow_tolerance)
      update_circular(v, position_of(right), true, opening_angle, angle, min_curvature);
    angle = next_angle;
    if(angle[1] >= 0.)
      relax_along_edge(v, position_of(right), tentative_flags);
    if(right == left)
      return is_only_fan && number_of_triangles == end - begin;
    ++number_of_triangles;
    if(angle[1] < 0.)
      break;
  }

  return false;
}

// Offers the end of a triangle's far side what a circular front gives it that crosses the side
// nearer to the source: the triangle's right one or, mirrored, its left one, as the site sees them.
void Front::update_circular(Index v, const Fan_position& position, bool is_mirrored,
                            const Vec2& opening, const Vec2& angle, double min_curvature)
{
  const Vertex_fans::Fan_edge* const right = &m_fans->edges[position.edge];
  const Vertex_fans::Fan_edge &near = right[is_mirrored ? 1 : 0], &far = right[is_mirrored ? 0 : 1];
  const Vertex_data& x = m_vertices[v];
  const Vertex_data& z = m_vertices[near.vertex];
  // A distance still waiting along a side, too long, would bend the circle far too much.
  const bool is_tentative = (z.state & (tentative_flag | final_flag)) == tentative_flag;
  if(!(z.distance < infinity) || is_tentative)
    return;
  const double base = near.length;
  const Vec2 y = far.length * opening;
  // A front on a polyhedron bends at least as much as one that has come straight all the way, and so
  // gains at least as much: |y - r u| - r with r = 1 / curvature.
  const Index flags = (x.state | z.state) & straight_flag;
  double curvature = flags ? 0. : min_curvature;
  const Vec2 source = {angle[0], -angle[1]};
  const Vertex_data& target = m_vertices[far.vertex];
  double max_gain = target.distance - x.distance; // that is worth it
  if(!(target.state & tentative_flag) && target.distance < infinity)
    max_gain -= (target.state & final_flag ? correction_tolerance : relaxation_tolerance) *
                (target.distance - m_min_offset);
  if(curvature * (far.length - max_gain) * (far.length + max_gain) >=
     2. * (max_gain + dot(y, source)))
    return;
  // Fronts of two sources are never mixed.
  bool has_nearer_neighbor = false;
  if(have_same_source(v, near.vertex))
  {
    const double difference = z.distance - x.distance;
    has_nearer_neighbor =
        excess_gain(curvature, base, difference, angle[0]) < -reentry_ratio * base &&
        (z.state & (final_flag | source_flag | tentative_flag)) == final_flag;
    curvature = fitted_curvature(curvature, base, difference, angle[0], x.distance - offset_at(v));
  }
  double gain;
  Vec2 backward;
  if(!cross_edge({source, curvature}, base, y, gain, backward))
    return;
  const double distance = x.distance + gain;
  if(!(distance < m_vertices[far.vertex].distance))
    return;
  // From the plane in which the crossed side lies on the first axis to the corner of the target.
  Vec2 direction;
  if(is_mirrored)
  {
    const Vec2 edge = Vec2{base, 0.} - y;
    const double size = norm(edge);
    if(size == 0.)
      return;
    direction = rotated_back(backward, (1. / size) * edge);
    direction[1] = -direction[1];
  }
  else
    direction = rotated_back(backward, {-opening[0], -opening[1]});
  const Index corner = m_triangles->ring[position.ring];
  const Index arrival_corner = is_mirrored ? next_halfedge(corner) : previous_halfedge(corner);
  const bool is_accepted =
      relax(far.vertex, {distance, direction, arrival_corner, flags, 0.}, m_sources[v]);
  // Once more from there: a front came to it past the other side of a vertex where the surface bends like a
  // sphere.  That ends, as nothing is taken twice.
  if(is_accepted && has_nearer_neighbor && was_reached_after(v, near.vertex))
    update_from(is_mirrored ? previous_halfedge(corner) : next_halfedge(corner), !is_mirrored);
}

// Whether a site was reached by one that has spread after this neighbour did.
bool Front::was_reached_after(Index vertex, Index neighbor) const
{
  const Surface_arrays& t = *m_triangles;
  const Index corner = m_vertices[vertex].corner;
  const auto is_later = [&](Index other)
  { return m_vertices[t.corner[other]].distance > m_vertices[neighbor].distance; };
  return is_later(next_halfedge(corner)) || is_later(previous_halfedge(corner));
}

// Through the triangle of a corner, from its site.
void Front::update_from(Index corner, bool is_mirrored)
{
  const Surface_arrays& t = *m_triangles;
  const Index vertex = t.corner[corner];
  Vec2 source;
  if(!source_direction(corner, is_mirrored, source))
    return;
  const Fan_position position = fan_position(t, *m_fans, vertex, corner);
  update_circular(vertex, position, is_mirrored, m_fans->edges[position.edge].opening,
                  {source[0], -source[1]}, 1. / (m_vertices[vertex].distance - offset_at(vertex)));
}

// Without a direction: the circle, or the straight line, that its distance and that of a neighbour
// determine (Reimers 2004).
void Front::propagate_without_direction(Index v)
{
  const Vertex_fans& s = *m_fans;
  const Vertex_data from = m_vertices[v];
  relax_all_edges(v, tentative_flag | (from.state & straight_flag));
  const double curvature = 1. / (from.distance - offset_at(v));
  Fan_position position = {s.begin[v].edge, s.begin[v].ring};
  for(; position.edge < s.begin[v + 1].edge; ++position.edge)
  {
    const Vertex_fans::Fan_edge& right = s.edges[position.edge];
    if(!(right.flags & Vertex_fans::Fan_edge::has_triangle))
      continue;
    const Vertex_fans::Fan_edge& left = (&right)[1];
    for(const bool is_mirrored : {false, true})
    {
      const Vertex_fans::Fan_edge& near = is_mirrored ? left : right;
      Circular_front circle{
          {1., 0.}, (from.state | m_vertices[near.vertex].state) & straight_flag ? 0. : curvature};
      if(m_sources[near.vertex] == m_sources[v] &&
         fit_source_direction(near.length, m_vertices[near.vertex].distance - from.distance,
                              circle))
        update_circular(v, position, is_mirrored, right.opening,
                        {circle.source[0], -circle.source[1]}, curvature);
    }
    ++position.ring;
  }
}

// Surfels know their directions in space: a triangle unfolds by a projection to its plane.
void Front::propagate_on_cloud(Index v)
{
  const Surface_arrays& t = *m_triangles;
  const Vertex_data from = m_vertices[v];
  const auto [axis_1, axis_2] = tangent_frame(t.normal[v]);
  const Vec3 source = m_directions[v][0] * axis_1 + m_directions[v][1] * axis_2;
  const bool is_origin = from.state & source_flag, is_tentative = from.state & tentative_flag;
  const auto relax_edge = [&](Index target, double length)
  {
    const double distance = from.distance + length;
    if(!(distance <= m_vertices[target].distance))
      return;
    const Vec3 backward = t.point[v] - t.point[target];
    // Whoever gets no more than a side's length knows no direction, and waits.
    const Index straight = from.state & straight_flag;
    Index flags = is_origin && !straight ? 0 : tentative_flag | straight;
    // A copy is the same place.
    if(length == 0.)
      flags = from.state & arrival_flags;
    relax(target,
          {distance, tangent_coordinates(target, backward), v, flags,
           flags & tentative_flag ? length : 0.},
          m_sources[v]);
  };
  // Where there are triangles the front passes them and their sides only: longer arcs would cut
  // off what comes through triangles.  Between islands there is nothing else.
  for(Index i = t.graph.begin[v]; i < t.graph.begin[v + 1]; ++i)
    if((*m_components)[v] != (*m_components)[t.graph.target[i]])
      relax_edge(t.graph.target[i], t.graph.length[i]);
  for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
  {
    const Index corner = t.ring[i], previous_corner = previous_halfedge(corner);
    relax_edge(t.corner[next_halfedge(corner)], t.length[corner]);
    relax_edge(t.corner[previous_corner], t.length[previous_corner]);
  }
  if(is_origin)
    return;
  for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
  {
    const Index corner = t.ring[i];
    const Index ends[2] = {t.corner[next_halfedge(corner)], t.corner[previous_halfedge(corner)]};
    for(const int k : {0, 1})
      update_on_cloud(v, is_tentative ? nullptr : &source, ends[k], ends[1 - k]);
  }
}

// As update_circular(), with coordinates in the plane of the triangle; without a source's direction as
// propagate_without_direction().
void Front::update_on_cloud(Index from, const Vec3* source, Index along, Index target)
{
  const Surface_arrays& t = *m_triangles;
  const Vertex_data& x = m_vertices[from];
  const Vertex_data& z = m_vertices[along];
  const bool is_tentative = (z.state & (tentative_flag | final_flag)) == tentative_flag;
  if(!(z.distance < infinity) || is_tentative)
    return;
  const Vec3 base_edge = t.point[along] - t.point[from],
             to_target = t.point[target] - t.point[from];
  const double base = norm(base_edge);
  if(base == 0.)
    return;
  const Vec3 axis_1 = (1. / base) * base_edge;
  const double y_0 = dot(to_target, axis_1);
  const Vec3 perpendicular = to_target - y_0 * axis_1;
  const double y_1 = norm(perpendicular);
  if(y_1 == 0.)
    return;
  const Vec3 axis_2 = (1. / y_1) * perpendicular;
  const Vec3 plane_normal = cross(axis_1, axis_2);

  const bool is_same = have_same_source(from, along);
  const double difference = z.distance - x.distance;
  const Index flags = (x.state | z.state) & straight_flag;
  Circular_front circle;
  circle.curvature = flags ? 0. : 1. / (x.distance - offset_at(from));
  if(source)
  {
    const Vec3 unfolded_source = rotated_between(*source, t.normal[from], plane_normal);
    const Vec2 projected = {dot(unfolded_source, axis_1), dot(unfolded_source, axis_2)};
    const double size = norm(projected);
    if(size == 0. || projected[1] > 0.)
      return;
    circle.source = (1. / size) * projected;
    if(is_same)
      circle.curvature = fitted_curvature(circle.curvature, base, difference, circle.source[0],
                                          x.distance - offset_at(from));
  }
  else if(!is_same || !fit_source_direction(base, difference, circle))
    return;
  double gain;
  Vec2 backward;
  if(!cross_edge(circle, base, {y_0, y_1}, gain, backward))
    return;
  const double distance = x.distance + gain;
  // A predecessor is nearer to the source than the target: else two sites could be each other's.
  const bool is_from_nearer = x.distance < distance;
  const bool is_along_nearer = is_same && z.distance < distance;
  if(!(distance < m_vertices[target].distance) || !(is_from_nearer || is_along_nearer))
    return;
  const bool comes_from_along =
      is_along_nearer && (!is_from_nearer || std::abs(y_0) >= std::abs(base - y_0));
  relax(target,
        {distance,
         tangent_coordinates(target, rotated_between(backward[0] * axis_1 + backward[1] * axis_2,
                                                     plane_normal, t.normal[target])),
         comes_from_along ? along : from, flags, 0.},
        m_sources[from]);
}

// A direction in space as coordinates in the tangent plane of a surfel.
Vec2 Front::tangent_coordinates(Index vertex, const Vec3& direction) const
{
  const auto [axis_1, axis_2] = tangent_frame(m_triangles->normal[vertex]);
  const Vec2 result = {dot(direction, axis_1), dot(direction, axis_2)};
  const double size = norm(result);
  return size > 0. ? (1. / size) * result : Vec2{1., 0.};
}

Index Front::predecessor(Index v) const
{
  const Surface_arrays& t = *m_triangles;
  const Vertex_data& vertex = m_vertices[v];
  if(!(vertex.distance < infinity) || (vertex.state & source_flag) || vertex.corner == none)
    return none;
  if(!has_directions() || t.is_cloud())
    return vertex.corner;
  const Index next = t.corner[next_halfedge(vertex.corner)],
              previous = t.corner[previous_halfedge(vertex.corner)];
  // The side nearer to the source's direction, if its far end is nearer at all.
  const Vec2 direction_from_next = rotated_back(corner_angle(t, vertex.corner), m_directions[v]);
  const bool is_next = m_directions[v][0] >= direction_from_next[0];
  for(const Index candidate : {is_next ? next : previous, is_next ? previous : next})
    if(m_vertices[candidate].distance < vertex.distance && m_sources[candidate] == m_sources[v])
      return candidate;
  return none;
}

double Front::distance(const Surface_location& location) const
{
  if(const Index vertex = vertex_of(*m_triangles, location); vertex != none)
    return m_vertices[vertex].distance;
  // On a side the front comes through either triangle.
  double result = infinity;
  for(const Index triangle : triangles_at(*m_triangles, location))
    result =
        std::min(result, distance_at(triangle, *barycentric_in(*m_triangles, triangle, location)));
  return result <= m_max_distance ? result : infinity;
}

// The distance of a place in a triangle, as the front comes through it.
double Front::distance_at(Index triangle, const std::array<double, 3>& barycentric) const
{
  const Surface_arrays& t = *m_triangles;
  const double slowness = m_slowness ? (*m_slowness)[triangle] : 1.;
  const auto corners = unfolded(t, triangle);
  const Vec2 p = unfolded_point(corners, barycentric);
  double result = infinity;
  for(auto piece = std::lower_bound(m_source_pieces.begin(), m_source_pieces.end(), triangle,
                                    [](const auto&entry, Index f) { return entry.first < f; });
      piece != m_source_pieces.end() && piece->first == triangle; ++piece)
  {
    const Front_source& source = piece->second;
    bool is_inside = false;
    const Vec2 q = closest_point_on_segment(
        p, unfolded_point(corners, source.polyline[0].barycentric),
        unfolded_point(corners, source.polyline[1].barycentric), is_inside);
    result = std::min(result, source.offset + slowness * norm(p - q));
  }
  for(Index k = 0; k < 3; ++k)
    result = std::min(result, m_vertices[t.corner[3 * triangle + k]].distance +
                                  slowness * norm(p - corners[k]));
  if(m_kind == Front_kind::dijkstra)
    return result;
  // The front that enters through each side.
  for(Index k = 0; k < 3; ++k)
    for(const bool is_mirrored : {false, true})
    {
      const Index h = 3 * triangle + k, from = is_mirrored ? next_halfedge(h) : h,
                  along = is_mirrored ? h : next_halfedge(h);
      const Vertex_data& x = m_vertices[t.corner[from]];
      const Vertex_data& z = m_vertices[t.corner[along]];
      const double base = t.length[h];
      if(base == 0. || !(x.distance < infinity) || !(z.distance < infinity) ||
         m_sources[t.corner[from]] != m_sources[t.corner[along]])
        continue;
      const Vec2 axis = (1. / base) * (corners[along % 3] - corners[from % 3]);
      Vec2 y = rotated_back(p - corners[from % 3], axis);
      y[1] = std::abs(y[1]);
      const double difference = z.distance - x.distance;
      Circular_front circle;
      const bool is_planar = m_slowness || m_kind == Front_kind::planar;
      const bool is_flat = is_planar || ((x.state | z.state) & straight_flag);
      circle.curvature =
          is_flat ? 0. : 1. / std::max(x.distance - offset_at(t.corner[from]), base * 1e-12);
      if(is_planar || (x.state & (source_flag | tentative_flag)) ||
         !source_direction(from, is_mirrored, circle.source))
      {
        if(!fit_source_direction(base, difference / slowness, circle))
          continue;
      }
      else
        circle.curvature = fitted_curvature(circle.curvature, base, difference, circle.source[0],
                                            x.distance - offset_at(t.corner[from]));
      double gain;
      Vec2 backward;
      if(cross_edge(circle, base, y, gain, backward))
        result = std::min(result, x.distance + slowness * gain);
    }
  return result;
}

// The direction to the source at a site, turned around it into the triangle of a corner and seen
// from the side that leaves the corner or, mirrored, arrives there; false in its shadow.
bool Front::source_direction(Index corner, bool is_mirrored, Vec2& source) const
{
  const Surface_arrays& t = *m_triangles;
  const Vertex_data& vertex = m_vertices[t.corner[corner]];
  const Vec2 direction = m_directions[t.corner[corner]];
  if(t.is_cloud() || vertex.corner == none || vertex.corner == corner)
    return false;
  Vec2 angle = is_mirrored ? direction : rotated_back(corner_angle(t, vertex.corner), direction);
  angle[1] = std::max(angle[1], 0.);
  for(Index rotated_corner = is_mirrored ? next_corner_cw(t, vertex.corner)
                                         : next_corner_ccw(t, vertex.corner);
      rotated_corner != none && rotated_corner != vertex.corner;
      rotated_corner = is_mirrored ? next_corner_cw(t, rotated_corner)
                                   : next_corner_ccw(t, rotated_corner))
  {
    if(rotated_corner == corner)
    {
      source = {angle[0], -angle[1]};
      return true;
    }
    angle = rotated(angle, corner_angle(t, rotated_corner));
    if(angle[1] < 0.)
      break;
  }
  return false;
}

} // namespace CGAL::Geodesic_processing::internal
