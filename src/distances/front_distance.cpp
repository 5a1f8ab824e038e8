// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_updates.h"

#include "core/unfold.h"
#include "distances/circular_front.h"
#include "distances/front_relaxation.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the distance at a point `p` of a triangle to the pieces of the sources in the triangle.
double distance_to_pieces(const Front_state& front, Index triangle,
                          const std::array<Vec2, 3>& corners, const Vec2& p)
{
  const double slowness = front.slowness_in(triangle);
  double result = infinity;
  for(auto piece =
          std::lower_bound(front.source_pieces.begin(), front.source_pieces.end(), triangle,
                           [](const auto&entry, Index f) { return entry.first < f; });
      piece != front.source_pieces.end() && piece->first == triangle; ++piece)
  {
    const Front_source& source = piece->second;
    bool is_inside = false;
    const Vec2 q = closest_point_on_segment(
        p, unfolded_point(corners, source.polyline[0].barycentric),
        unfolded_point(corners, source.polyline[1].barycentric), is_inside);
    result = std::min(result, source.offset + slowness * norm(p - q));
  }
  return result;
}

// Returns the distance at a point `p` of a triangle by the front that enters through an edge. The
// front is fitted at the begin of the halfedge or, if mirrored, at its end. Infinity if there is
// no such front.
double distance_through_edge(const Front_state& front, const std::array<Vec2, 3>& corners, Index h,
                             bool is_mirrored, const Vec2& p)
{
  const Surface_arrays& t = *front.triangles;
  const double slowness = front.slowness_in(h / 3);
  const Index from = is_mirrored ? next_halfedge(h) : h, along = is_mirrored ? h : next_halfedge(h);
  const Front_vertex& x = front.vertices[t.corner[from]];
  const Front_vertex& z = front.vertices[t.corner[along]];
  const double base = t.length[h];
  if(base == 0. || !(x.distance < infinity) || !(z.distance < infinity) ||
     front.sources[t.corner[from]] != front.sources[t.corner[along]])
    return infinity;
  const Vec2 axis = (1. / base) * (corners[along % 3] - corners[from % 3]);
  Vec2 y = rotated_back(p - corners[from % 3], axis);
  y[1] = std::abs(y[1]);
  const double difference = z.distance - x.distance;
  Circular_front circle;
  const bool is_planar = front.slowness || front.kind == Front_kind::planar;
  const bool is_flat = is_planar || ((x.state | z.state) & straight_flag);
  circle.curvature =
      is_flat ? 0. : 1. / std::max(x.distance - front.offset_at(t.corner[from]), base * 1e-12);
  if(is_planar || (x.state & (source_flag | tentative_flag)) ||
     !source_direction(front, from, is_mirrored, circle.source))
  {
    if(!fit_source_direction(base, difference / slowness, circle))
      return infinity;
  }
  else
    circle.curvature = fitted_curvature(circle.curvature, base, difference, circle.source[0],
                                        x.distance - front.offset_at(t.corner[from]));
  double gain;
  Vec2 backward;
  return cross_edge(circle, base, y, gain, backward) ? x.distance + slowness * gain : infinity;
}

} // namespace

double distance_in_front(const Front_state& front, Index triangle,
                         const std::array<double, 3>& barycentric)
{
  const Surface_arrays& t = *front.triangles;
  const double slowness = front.slowness_in(triangle);
  const auto corners = unfolded(t, triangle);
  const Vec2 p = unfolded_point(corners, barycentric);
  double result = distance_to_pieces(front, triangle, corners, p);
  for(Index k = 0; k < 3; ++k)
    result = std::min(result, front.vertices[t.corner[3 * triangle + k]].distance +
                                  slowness * norm(p - corners[k]));
  if(front.kind == Front_kind::dijkstra)
    return result;
  for(Index k = 0; k < 3; ++k)
    for(const bool is_mirrored : {false, true})
      result =
          std::min(result, distance_through_edge(front, corners, 3 * triangle + k, is_mirrored, p));
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
