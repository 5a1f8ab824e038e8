// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_updates.h"

#include "core/unfold.h"
#include "distances/front_relaxation.h"
#include "distances/split_half.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

bool is_final(const Front_state& front, Index vertex)
{
  return (front.vertices[vertex].state & final_flag) != 0;
}

// The distance at the third corner of a triangle.
struct Planar_distance
{
  double distance = infinity;
  bool is_closer_to_z = false; // the front arrives closer to z than to x
};

// Computes the distance at `apex` by the straight front through the distances of x and z. The base
// runs from x along the first axis to z. Infinity if the distances have different sources, or if
// the ray to the apex does not cross the base.
Planar_distance planar_update(const Front_state& front, Index x, Index z, double base,
                              const Vec2& apex, double slowness)
{
  if(!front.have_same_source(x, z))
    return {};
  const double distance_at_x = front.vertices[x].distance, travel_time = slowness * base;
  const double slope = (front.vertices[z].distance - distance_at_x) / travel_time;
  if(!(std::abs(slope) < 1.) || !(travel_time < infinity))
    return {};
  const Straight_front straight_front(base, slope, apex);
  return {distance_at_x + slowness * straight_front.delay, straight_front.is_closer_to_end};
}

// Relaxes the vertex of a split obtuse corner through one of its two virtual triangles, whose base
// runs from `v` to `along`.
void relax_split_corner(Front_state& front, Index v, const Obtuse_splits::Half& split)
{
  const double distance = planar_update(front, v, split.along, split.base, split.apex,
                                        front.slowness_in(split.corner / 3))
                              .distance;
  if(distance < front.vertices[split.target].distance)
    relax(front, split.target, {distance, {1., 0.}, split.neighbor, 0, 0.}, front.sources[v]);
}

// What a front reads around a vertex: from the triangles, or from stored fans. A corner is computed
// only if it is used, because two of three are not.
struct Read_fans
{
  using Edge = Fan_edge;

  bool has_triangle(const Edge& edge) const { return edge.corner != none; }
  Index triangle(const Edge& edge) const { return edge.corner / 3; }
  Vec2 opening(const Edge& edge) const { return corner_angle(t, edge.corner); }
  bool is_split(const Edge& edge) const { return s.is_split(next_halfedge(edge.corner)); }
  bool is_next_split(const Edge& edge) const { return s.is_split(previous_halfedge(edge.corner)); }

  const Surface_arrays& t;
  const Obtuse_splits& s;
};

struct Stored_fans
{
  using Edge = Vertex_fans::Edge;

  bool has_triangle(const Edge& edge) const { return edge.has_triangle(); }
  Index triangle(const Edge& edge) const { return edge.triangle(); }
  Vec2 opening(const Edge& edge) const { return edge.opening; }
  bool is_split(const Edge& edge) const { return edge.is_split(); }
  bool is_next_split(const Edge& edge) const { return edge.is_next_split(); }
};

// Relaxes the far ends of the edges that leave `v`.
template <typename Fans>
void relax_fan(Front_state& front, Index v, const Fans& fans, const typename Fans::Edge* edge,
               const typename Fans::Edge* end)
{
  using Edge = typename Fans::Edge;
  const Front_vertex* const vertices = front.vertices.data();
  const double distance = vertices[v].distance;
  const Index source = front.sources[v];
  double slowness_before = infinity; // of the triangle before the edge
  for(; edge != end; ++edge)
  {
    const double slowness_after =
        fans.has_triangle(*edge) ? front.slowness_in(fans.triangle(*edge)) : infinity;
    if(!is_final(front, edge->vertex))
    {
      double best_distance = distance + std::min(slowness_before, slowness_after) * edge->length;
      Index predecessor = v;
      // Updates through a triangle from `v` and the far end of its other edge.
      const auto update_from_pair = [&](const Edge& other, const Vec2& opening, double slowness)
      {
        const Planar_distance update =
            planar_update(front, v, other.vertex, other.length, edge->length * opening, slowness);
        if(update.distance < best_distance)
        {
          best_distance = update.distance;
          predecessor = update.is_closer_to_z ? other.vertex : v;
        }
      };
      if(slowness_after < infinity && is_final(front, edge[1].vertex) && !fans.is_split(*edge))
        update_from_pair(edge[1], fans.opening(*edge), slowness_after);
      if(slowness_before < infinity && is_final(front, edge[-1].vertex) &&
         !fans.is_next_split(edge[-1]))
        update_from_pair(edge[-1], fans.opening(edge[-1]), slowness_before);
      if(best_distance < vertices[edge->vertex].distance)
        relax(front, edge->vertex, {best_distance, {1., 0.}, predecessor, 0, 0.}, source);
    }
    slowness_before = slowness_after;
  }
}

void propagate_planar_with_stored_fans(Front_state& front, Index v)
{
  const Vertex_fans& s = *front.fans;
  const Vertex_fans::Offsets begin = s.begin[v], end = s.begin[v + 1];
  relax_fan(front, v, Stored_fans{}, s.edges.data() + begin.edge, s.edges.data() + end.edge);
  for(Index i = begin.split; i < end.split; ++i)
    if(const Obtuse_splits::Half& split = s.splits[i];
       !is_final(front, split.target) && is_final(front, split.along))
      relax_split_corner(front, v, split);
}

} // namespace

void propagate_planar(Front_state& front, Index v)
{
  const Surface_arrays& t = *front.triangles;
  if(t.is_cloud())
    propagate_along_edges(front, v);
  if(front.fans)
    return propagate_planar_with_stored_fans(front, v);

  constexpr Index max_degree = 64; // of almost all vertices, also on clouds
  std::array<Fan_edge, 2 * max_degree> few_edges;
  std::vector<Fan_edge> many_edges;
  const Index degree = t.ring_begin[v + 1] - t.ring_begin[v];
  if(degree > max_degree)
    many_edges.resize(2 * std::size_t(degree));
  Fan_edge* const edges = degree > max_degree ? many_edges.data() : few_edges.data();
  const Obtuse_splits& s = *front.splits;
  relax_fan(front, v, Read_fans{t, s}, edges, read_fan_edges(t, v, edges));

  if(s.splits.empty())
    return;
  for(Index i = s.begin[v]; i < s.begin[v + 1]; ++i)
    if(const Obtuse_splits::View& view = s.views[i];
       !is_final(front, view.target) && is_final(front, view.along))
      relax_split_corner(front, v, split_half(s, v, view));
}

} // namespace CGAL::Geodesic_processing::internal
