// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_updates.h"

#include "core/unfold.h"
#include "distances/front_relaxation.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

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

// Relaxes the vertices of split obtuse corners through the virtual triangles whose base ends at
// `v`.
void relax_split_corners(Front_state& front, Index v)
{
  const Obtuse_splits& s = *front.splits;
  const auto is_final = [&](Index vertex)
  { return (front.vertices[vertex].state & final_flag) != 0; };
  for(Index i = s.begin[v]; i < s.begin[v + 1]; ++i)
  {
    const Obtuse_splits::View& view = s.views[i];
    if(is_final(view.target) || !is_final(view.along))
      continue;
    const Obtuse_splits::Split& split = s.splits[view.split()];
    const std::size_t half = view.half();
    const double base = split.base[half], to_neighbor = split.to_neighbor[half];
    const Vec2 apex = view.is_from_splitting_vertex()
                          ? third_corner(base, split.length, to_neighbor)
                          : third_corner(base, to_neighbor, split.length);
    const Index neighbor = view.is_from_splitting_vertex() ? view.along : v;
    const double distance =
        planar_update(front, v, view.along, base, apex, front.slowness_in(split.corner / 3))
            .distance;
    if(distance < front.vertices[view.target].distance)
      relax(front, view.target, {distance, {1., 0.}, neighbor, 0, 0.}, front.sources[v]);
  }
}

} // namespace

void propagate_planar(Front_state& front, Index v)
{
  const Surface_arrays& t = *front.triangles;
  if(t.is_cloud())
    propagate_along_edges(front, v);
  const Front_vertex* const vertices = front.vertices.data();
  const auto is_final = [vertices](Index vertex)
  { return (vertices[vertex].state & final_flag) != 0; };
  const double distance = vertices[v].distance;
  const Index source = front.sources[v];

  constexpr Index max_degree = 64; // of almost all vertices, also on clouds
  std::array<Fan_edge, 2 * max_degree> few_edges;
  std::vector<Fan_edge> many_edges;
  const Fan_edge *first, *end;
  if(front.fans)
  {
    first = front.fans->edges.data() + front.fans->begin[v];
    end = front.fans->edges.data() + front.fans->begin[v + 1];
  }
  else
  {
    const Index degree = t.ring_begin[v + 1] - t.ring_begin[v];
    if(degree > max_degree)
      many_edges.resize(2 * std::size_t(degree));
    Fan_edge* const edges = degree > max_degree ? many_edges.data() : few_edges.data();
    first = edges;
    end = read_fan_edges(t, v, edges);
  }
  double slowness_before = infinity; // of the triangle before the edge
  for(const Fan_edge* edge = first; edge != end; ++edge)
  {
    const double slowness_after =
        edge->corner == none ? infinity : front.slowness_in(edge->corner / 3);
    if(!is_final(edge->vertex))
    {
      double best_distance = distance + std::min(slowness_before, slowness_after) * edge->length;
      Index predecessor = v;
      // Updates through a triangle from `v` and the far end of its other edge.
      const auto update_from_pair = [&](const Fan_edge& other, const Vec2& opening, double slowness)
      {
        const Planar_distance update =
            planar_update(front, v, other.vertex, other.length, edge->length * opening, slowness);
        if(update.distance < best_distance)
        {
          best_distance = update.distance;
          predecessor = update.is_closer_to_z ? other.vertex : v;
        }
      };
      if(slowness_after < infinity && is_final(edge[1].vertex) &&
         !front.splits->is_split(next_halfedge(edge->corner)))
        update_from_pair(edge[1], edge->opening, slowness_after);
      if(slowness_before < infinity && is_final(edge[-1].vertex) &&
         !front.splits->is_split(previous_halfedge(edge[-1].corner)))
        update_from_pair(edge[-1], edge[-1].opening, slowness_before);
      if(best_distance < vertices[edge->vertex].distance)
        relax(front, edge->vertex, {best_distance, {1., 0.}, predecessor, 0, 0.}, source);
    }
    slowness_before = slowness_after;
  }

  if(!front.splits->splits.empty())
    relax_split_corners(front, v);
}

} // namespace CGAL::Geodesic_processing::internal
