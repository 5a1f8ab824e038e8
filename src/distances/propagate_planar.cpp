// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_updates.h"

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
  const Vertex_fans& s = *front.fans;
  const auto is_final = [&](Index vertex)
  { return (front.vertices[vertex].state & final_flag) != 0; };
  for(Index i = s.begin[v].split; i < s.begin[v + 1].split; ++i)
  {
    const Vertex_fans::Split& split = s.splits[i];
    if(is_final(split.target) || !is_final(split.along))
      continue;
    const double distance = planar_update(front, v, split.along, split.base, split.apex,
                                          front.slowness_in(split.corner / 3))
                                .distance;
    if(distance < front.vertices[split.target].distance)
      relax(front, split.target, {distance, {1., 0.}, split.neighbor, 0, 0.}, front.sources[v]);
  }
}

} // namespace

void propagate_planar(Front_state& front, Index v)
{
  const Surface_arrays& t = *front.triangles;
  const Vertex_fans& s = *front.fans;
  if(t.is_cloud())
    propagate_along_edges(front, v);
  const Front_vertex* const vertices = front.vertices.data();
  const auto is_final = [vertices](Index vertex)
  { return (vertices[vertex].state & final_flag) != 0; };
  const double distance = vertices[v].distance;
  const Index source = front.sources[v];

  // The one-ring lists the triangles in the order of the fan edges.
  const Index* triangle = front.slowness ? t.ring.data() + t.ring_begin[v] : nullptr;
  double slowness_before = infinity; // of the triangle before the fan edge
  const Vertex_fans::Fan_edge* const end = s.edges.data() + s.begin[v + 1].edge;
  for(const Vertex_fans::Fan_edge* edge = s.edges.data() + s.begin[v].edge; edge != end; ++edge)
  {
    double slowness_after = infinity;
    if(edge->flags & Vertex_fans::Fan_edge::has_triangle)
      slowness_after = front.slowness ? (*front.slowness)[*triangle++ / 3] : 1.;
    if(!is_final(edge->vertex))
    {
      double best_distance = distance + std::min(slowness_before, slowness_after) * edge->length;
      Index predecessor = v;
      const auto update_from_pair =
          [&](const Vertex_fans::Fan_edge& other, const Vec2& opening, double slowness)
      {
        const Planar_distance update =
            planar_update(front, v, other.vertex, other.length, edge->length * opening, slowness);
        if(update.distance < best_distance)
        {
          best_distance = update.distance;
          predecessor = update.is_closer_to_z ? other.vertex : v;
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
        relax(front, edge->vertex, {best_distance, {1., 0.}, predecessor, 0, 0.}, source);
    }
    slowness_before = slowness_after;
  }

  relax_split_corners(front, v);
}

} // namespace CGAL::Geodesic_processing::internal
