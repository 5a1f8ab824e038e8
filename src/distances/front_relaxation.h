// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_RELAXATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_RELAXATION_H

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Front_state.h>
#include "core/prefetch.h"
#include "core/unfold.h"

#include <algorithm>
#include <cstddef>

namespace CGAL::Geodesic_processing::internal {

// Relaxation of vertices, shared by all update rules of a front.
//
// A Euclidean front may arrive at a final vertex later with a smaller distance. Then the vertex is
// corrected: it enters the queue again, and the vertices that were computed from it are
// invalidated.

// Flags of Front_vertex::state.
constexpr Index reached_flag = 1; // is in Front_state::reached
constexpr Index final_flag = 2;   // has left the queue
constexpr Index source_flag = 4;  // is on a source: propagates in all directions
// Was reached along an edge although the front arrives through a triangle: its direction is not
// reliable.
constexpr Index tentative_flag = 8;
constexpr Index straight_flag = 16; // its source is a segment: the front may be straight
constexpr Index arrival_flags = source_flag | tentative_flag | straight_flag;
// The higher bits count the corrections of a vertex.
constexpr Index correction_unit = 32;
// Most vertices need no correction, and few need more than ten. The bound ends cycles, in which
// vertices invalidate each other.
constexpr Index max_corrections = 64;

// A final vertex is corrected if its distance decreases by more than this fraction. A front that
// is fitted to an overestimated distance is too curved and yields underestimates, which no later
// relaxation repairs. On an irregular square, 1e-8 left errors of 2e-4; 1e-12 leaves round-off
// errors at the same cost.
constexpr double correction_tolerance = 1e-12;
// On a curved surface the front is not exact anyway. There descendants are invalidated only if the
// distance decreases by more than this fraction of an edge. The errors are the same; queries are
// 25 % faster on meshes in which half of the triangles are obtuse.
constexpr double invalidation_ratio = 1e-2;
// A vertex in the queue is relaxed only if its distance decreases by more than this fraction. The
// minimum of many values that differ by round-off errors is biased, increasingly with the distance.
constexpr double relaxation_tolerance = 1e-14;
// Bounds the number of invalidated vertices by this multiple of the reached ones. Scans need 0.2,
// most CAD models less. On some, cycles have no end; with four times this budget, queries took up
// to ten times as long, with the same errors. Beyond the budget a vertex is corrected a few times
// only and nothing is invalidated.
constexpr std::size_t max_invalidation_ratio = 1;
constexpr std::size_t min_invalidation_budget = 2000; // allowed in every query
constexpr Index max_corrections_over_budget = 8;

// The values that an update rule computes for a vertex.
struct Arrival
{
  double distance;
  Vec2 direction; // as Front_state::directions
  Index corner;   // as Front_vertex::corner
  Index flags;    // of arrival_flags
  double delay;   // added to the distance to yield the key in the queue
};

// Returns (cos, sin) of the angle of a corner on the triangles of the front.
inline Vec2 corner_angle(const Front_state& front, Index corner)
{
  return front.corner_angles ? (*front.corner_angles)[corner]
                             : corner_angle(*front.triangles, corner);
}

// Returns whether the budget of invalidations is not exhausted.
inline bool can_invalidate(const Front_state& front)
{
  return front.number_invalidated <=
         min_invalidation_budget + max_invalidation_ratio * front.reached.size();
}

// Returns whether the descendants of a final vertex whose distance decreases by `correction` must
// be invalidated.
CGAL_GEODESIC_PROCESSING_EXPORT
bool needs_invalidation(const Front_state& front, Index vertex, double correction);

// Returns a lower bound of the distance at a vertex: the offset plus the distance along the
// straight line to the only point source, or minus infinity.
inline double straight_bound(const Front_state& front, Index vertex)
{
  if(!front.point_source || !front.is_on_surface(vertex))
    return -infinity;
  return front.min_offset + straight_distance(front.surface->point[vertex], *front.point_source);
}

// Updates a vertex if the arrival is better than its values, and puts it into the queue. Returns
// whether the vertex was updated.
inline bool relax(Front_state& front, Index v, const Arrival& arrival, Index source)
{
  if(!front.improves_known_distance && !front.improves(v, arrival.distance))
    return false;
  // Without directions, only final vertices are used by update rules.
  if(arrival.distance > front.max_distance && !front.has_directions())
    return false;
  Front_vertex& vertex = front.vertices[v];
  double distance = arrival.distance;
  const bool is_final = vertex.state & final_flag;
  if(is_final)
  {
    const Index max_corrections_here =
        can_invalidate(front) ? max_corrections : max_corrections_over_budget;
    const double max_distance =
        vertex.distance - correction_tolerance * (vertex.distance - front.min_offset);
    if(!front.has_directions() || vertex.state >= max_corrections_here * correction_unit ||
       distance >= max_distance)
      return false;
    distance = std::max(distance, straight_bound(front, v));
    if(distance >= max_distance)
      return false;
    vertex.state += correction_unit;
    if(front.is_circular() && needs_invalidation(front, v, vertex.distance - distance))
      front.corrected_vertices.push_back(v);
  }
  else if(distance >= vertex.distance)
  {
    // The same distance replaces a tentative one: its direction can be trusted.
    const bool is_better = distance == vertex.distance && (vertex.state & tentative_flag) &&
                           !(arrival.flags & tentative_flag);
    if(!is_better)
      return false;
  }
  const bool is_reached = vertex.state & reached_flag;
  vertex.distance = distance;
  if(!front.directions.empty())
    front.directions[v] = arrival.direction;
  vertex.corner = arrival.corner;
  vertex.state = (vertex.state & ~arrival_flags) | arrival.flags | reached_flag;
  front.sources[v] = source;
  // The delay lets the front arrive through a triangle before a tentative vertex becomes final.
  if(is_reached)
    front.queue.push(v, distance + arrival.delay);
  else
  {
    front.reached.push_back(v);
    front.queue.insert(v, distance + arrival.delay);
    if(front.fans && front.is_planar())
      prefetch(&front.fans->begin[v]);
    else
    {
      prefetch(&front.triangles->ring_begin[v]);
      if(front.splits && !front.splits->begin.empty())
        prefetch(&front.splits->begin[v]);
    }
  }
  return true;
}

// Invalidates the vertices that were computed from triangles with a corrected corner, recursively,
// and puts the final vertices adjacent to them into the queue again.
void invalidate_descendants(Front_state& front);

// Returns whether a vertex that does not improve its known distance may improve that of an adjacent
// vertex.
bool may_improve_neighbors(const Front_state& front, Index vertex);

// Relaxes the far end of an edge with the length of the edge, on a mesh. The edge is the right one
// (the halfedge that leaves the corner) or the left one of a triangle, as seen from the vertex of
// its corner.
void relax_along_edge(Front_state& front, Index corner, bool is_left, Index flags);

// Relaxes all vertices adjacent to a vertex of a mesh with the lengths of the edges.
void relax_all_edges(Front_state& front, Index vertex, Index flags);

// Decreases the distances of a Euclidean front on a mesh to those along edges of the mesh: edges
// that are not in the intrinsic triangulation, and edges to the often corrected vertices.
// With known distances, also reaches the ends of the former edges of all vertices that improve
// theirs.
void bound_by_edges(Front_state& front, const std::vector<Index>& often_corrected);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_RELAXATION_H
