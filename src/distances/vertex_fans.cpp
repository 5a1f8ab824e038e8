// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/vertex_fans.h>

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "core/unfold.h"

#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// An obtuse corner and the vertex behind its opposite edge that splits it.
struct Splitting_vertex
{
  Index corner;
  Index vertex;  // none if no vertex within max_steps triangles splits the corner
  double length; // from the corner to that vertex
  // The distances from that vertex to the other corners of the triangle, the next corner first.
  Vec2 base;
};

// Unfolds triangles behind the edge opposite to a corner until one has a vertex that splits the
// corner into two acute angles. `angle` is (cos, sin) of the corner.
Splitting_vertex find_splitting_vertex(const Surface_arrays& t, Index corner, const Vec2& angle)
{
  constexpr int max_steps = 20;
  const Vec2 a = {t.length[corner], 0.}, b = t.length[previous_halfedge(corner)] * angle;
  // The halfedge to be crossed; it runs from `begin` to `end`.
  Index h = next_halfedge(corner);
  Vec2 begin = a, end = b;
  for(int step = 0; step < max_steps; ++step)
  {
    h = t.twin[h]; // runs from end to begin
    if(h == none)
      break;
    const double length = t.length[h];
    if(length <= 0.)
      break;
    const Vec2 direction = (1. / length) * (begin - end);
    const Vec2 position = end + rotated(apex(t, h), direction);
    const bool is_acute_to_a = dot(a, position) > 0., is_acute_to_b = dot(b, position) > 0.;
    if(is_acute_to_a && is_acute_to_b && cross(a, position) > 0. && cross(position, b) > 0.)
      return {corner,
              t.corner[previous_halfedge(h)],
              norm(position),
              {norm(a - position), norm(b - position)}};
    if(is_acute_to_a)
    {
      // The vertex is closer to a: the directions that split the angle are between it and end.
      begin = position;
      h = previous_halfedge(h);
    }
    else
    {
      end = position;
      h = next_halfedge(h);
    }
  }
  return {corner, none, 0., {0., 0.}};
}

// Tolerance for an angle sum of 2 pi. The errors of single precision coordinates are smaller.
constexpr double flat_angle_tolerance = 1e-6;

// Appends the fan edges of all vertices.
void add_edges(const Surface_arrays& t, Vertex_fans& s)
{
  const Index n = static_cast<Index>(t.number_of_vertices());
  s.begin.resize(n + 1);
  s.edges.reserve(t.ring.size() + n);
  for(Index vertex = 0; vertex < n; ++vertex)
  {
    s.begin[vertex] = {static_cast<Index>(s.edges.size()), 0, t.ring_begin[vertex]};
    std::size_t fan_begin = s.edges.size();
    Vec2 total_turn = {1., 0.}; // rotation by the angles of the fan so far
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    {
      const Index corner = t.ring[i], next = next_halfedge(corner),
                  previous = previous_halfedge(corner);
      s.edges.push_back({t.corner[next], Vertex_fans::Fan_edge::has_triangle, t.length[corner],
                         corner_angle(t, corner)});
      total_turn = rotated(total_turn, s.edges.back().opening);
      const Index next_corner = t.twin.empty() ? none : next_corner_ccw(t, corner);
      if(next_corner != none && i + 1 < t.ring_begin[vertex + 1] && next_corner == t.ring[i + 1])
        continue;
      s.edges.push_back({t.corner[previous], 0, t.length[previous], {1., 0.}});
      if(next_corner != none)
      {
        s.edges[fan_begin].flags |= Vertex_fans::Fan_edge::is_repeated;
        s.edges.back().flags |= Vertex_fans::Fan_edge::is_repeated;
        if(std::abs(total_turn[0] - 1.) + std::abs(total_turn[1]) > flat_angle_tolerance)
          s.edges[s.begin[vertex].edge].flags |= Vertex_fans::Fan_edge::is_curved;
      }
      total_turn = {1., 0.};
      fan_begin = s.edges.size();
    }
  }
  s.begin[n] = {static_cast<Index>(s.edges.size()), 0, t.ring_begin[n]};
}

// Returns the obtuse corners that can be split, with the vertices that split them.
std::vector<Splitting_vertex> find_splitting_vertices(const Surface_arrays& t)
{
  std::vector<Splitting_vertex> result;
  for(Index corner = 0; corner < t.corner.size(); ++corner)
  {
    const double a = t.length[corner], b = t.length[previous_halfedge(corner)],
                 opposite = t.length[next_halfedge(corner)];
    // Right angles are common and need no split; the tolerance covers their round-off errors.
    if(!(opposite * opposite > a * a + b * b))
      continue;
    const Vec2 angle = angle_between(a, b, opposite);
    if(angle[0] >= -1e-12)
      continue;
    const Splitting_vertex splitting = find_splitting_vertex(t, corner, angle);
    if(splitting.vertex != none)
      result.push_back(splitting);
  }
  return result;
}

// Appends the splits of all obtuse corners, in CSR format, and sets the flags of their fan edges.
void add_splits(const Surface_arrays& t, Vertex_fans& s)
{
  const std::vector<Splitting_vertex> splitting_vertices = find_splitting_vertices(t);
  // Each split corner has two halves, each seen from both ends of its base.
  const auto for_each_half = [&](const auto& visit)
  {
    for(const Splitting_vertex& splitting : splitting_vertices)
    {
      const Index corners[2] = {next_halfedge(splitting.corner),
                                previous_halfedge(splitting.corner)};
      const double lengths[2] = {t.length[splitting.corner], t.length[corners[1]]};
      for(const int k : {0, 1})
      {
        const Index neighbor = t.corner[corners[k]];
        visit(splitting, neighbor, splitting.vertex, neighbor, splitting.base[k], lengths[k],
              splitting.length);
        visit(splitting, splitting.vertex, neighbor, neighbor, splitting.base[k], splitting.length,
              lengths[k]);
      }
      s.edges[fan_position(t, s, t.corner[corners[0]], corners[0]).edge].flags |=
          Vertex_fans::Fan_edge::is_next_obtuse_split;
      s.edges[fan_position(t, s, t.corner[corners[1]], corners[1]).edge].flags |=
          Vertex_fans::Fan_edge::is_obtuse_split;
    }
  };
  for_each_half([&](const Splitting_vertex&, Index vertex, Index, Index, double, double, double)
                { ++s.begin[vertex + 1].split; });
  for(std::size_t vertex = 1; vertex < s.begin.size(); ++vertex)
    s.begin[vertex].split += s.begin[vertex - 1].split;
  s.splits.resize(s.begin.back().split);
  std::vector<Index> split_end;
  split_end.reserve(s.begin.size());
  for(const Vertex_fans::Offsets& first : s.begin)
    split_end.push_back(first.split);
  for_each_half(
      [&](const Splitting_vertex& splitting, Index vertex, Index along, Index neighbor, double base,
          double to_vertex, double to_along)
      {
        s.splits[split_end[vertex]++] = {splitting.corner,
                                         t.corner[splitting.corner],
                                         along,
                                         neighbor,
                                         base,
                                         third_corner(base, to_vertex, to_along)};
      });
}

} // namespace

Vertex_fans build_vertex_fans(const Surface_arrays& t, bool with_splits)
{
  Vertex_fans result;
  add_edges(t, result);
  if(with_splits && !t.is_cloud())
    add_splits(t, result);
  return result;
}

std::shared_ptr<const Vertex_fans> shared_vertex_fans(const Surface_arrays& t, bool with_splits)
{
  const std::lock_guard<std::mutex> lock(t.shared.mutex);
  std::weak_ptr<const Vertex_fans>& cached = t.shared.vertex_fans[with_splits ? 1 : 0];
  std::shared_ptr<const Vertex_fans> result = cached.lock();
  if(!result)
    cached = result = std::make_shared<const Vertex_fans>(build_vertex_fans(t, with_splits));
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
