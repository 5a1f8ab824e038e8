// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Window_propagator.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

void Window_propagator::start(const std::vector<Front_source>& sources)
{
  const Surface_arrays& t = *m_state.triangles;
  m_state.source_pieces.clear();
  for(Index i = 0; i < sources.size(); ++i)
  {
    const std::vector<Surface_location>& polyline = sources[i].polyline;
    const double offset = sources[i].offset - m_state.min_offset;
    for(const Surface_location& location : polyline)
      start_at_point(location, i, offset);
    for(std::size_t k = 1; k < polyline.size(); ++k)
      for(const Index triangle : triangles_at(t, polyline[k - 1]))
        if(const auto p = barycentric_in(t, triangle, polyline[k - 1]),
           q = barycentric_in(t, triangle, polyline[k]);
           p && q)
        {
          m_state.source_pieces.push_back({triangle, i, *p, *q, offset});
          start_along(m_state.source_pieces.back());
        }
  }
  m_state.pieces_by_triangle.clear();
  for(Index i = 0; i < m_state.source_pieces.size(); ++i)
    m_state.pieces_by_triangle.emplace_back(m_state.source_pieces[i].triangle, i);
  std::sort(m_state.pieces_by_triangle.begin(), m_state.pieces_by_triangle.end());
}

void Window_propagator::start_at_point(const Surface_location& location, Index source,
                                       double offset)
{
  const Surface_arrays& t = *m_state.triangles;
  if(const Index vertex = vertex_of(t, location); vertex != none)
  {
    relax(vertex, {offset, {1., 0.}, none, vertex}, source);
    return;
  }
  for(const Index triangle : triangles_at(t, location))
  {
    const auto barycentric = *barycentric_in(t, triangle, location);
    const Index origin = Index(m_state.vertices.size() + m_state.source_pieces.size());
    m_state.source_pieces.push_back({triangle, source, barycentric, barycentric, offset});
    const auto corners = unfolded(t, triangle);
    const Vec2 p = unfolded_point(corners, barycentric);
    for(Index k = 0; k < 3; ++k)
    {
      const Index h = 3 * triangle + k;
      const double length = t.length[h];
      if(!(length > 0.))
        continue;
      const Vec2 axis = (1. / length) * (corners[(k + 1) % 3] - corners[k]);
      const Vec2 to_point = p - corners[k];
      const double gain = norm(to_point);
      relax(t.corner[h],
            {offset + gain, gain > 0. ? rotated_back((1. / gain) * to_point, axis) : Vec2{1., 0.},
             h, origin},
            source);
      // In the coordinates of the twin.
      const Vec2 local_point = rotated_back(to_point, axis);
      if(barycentric[(k + 2) % 3] > 0.)
        enqueue(t.twin[h], {{length - local_point[0], std::min(0., -local_point[1])},
                            offset,
                            0.,
                            length,
                            origin,
                            0.f});
    }
  }
}

// Enqueues straight windows on both sides of a segment and relaxes the corners of its triangle.
void Window_propagator::start_along(const Source_piece& piece)
{
  const Surface_arrays& t = *m_state.triangles;
  const Index origin = Index(m_state.vertices.size() + m_state.source_pieces.size() - 1);
  const auto corners = unfolded(t, piece.triangle);
  const Vec2 p = unfolded_point(corners, piece.begin), q = unfolded_point(corners, piece.end);
  const double size = norm(q - p);
  if(!(size > 0.))
    return;
  const Vec2 along = (1. / size) * (q - p);
  for(Index k = 0; k < 3; ++k)
  {
    const Index h = 3 * piece.triangle + k;
    const double length = t.length[h];
    if(!(length > 0.))
      continue;
    const Vec2 axis = (1. / length) * (corners[(k + 1) % 3] - corners[k]);
    // The corner and the direction of the edge, in coordinates along the segment and across it.
    const Vec2 corner = rotated_back(corners[k] - p, along),
               edge_direction = rotated_back(axis, along);
    if(corner[0] >= 0. && corner[0] <= size)
    {
      const Vec2 direction = {0., corner[1] > 0. ? -1. : 1.};
      relax(t.corner[h],
            {piece.offset + std::abs(corner[1]), rotated_back(rotated(direction, along), axis), h,
             origin},
            piece.source);
    }
    if(t.twin[h] == none || (piece.begin[(k + 2) % 3] == 0. && piece.end[(k + 2) % 3] == 0.))
      continue;
    for(const double sign : {1., -1.})
    {
      // The interval of the edge with 0 <= x <= size and sign y >= 0.
      double begin = 0., end = length;
      const auto clip = [&](double value, double slope_of_value) // value + slope position >= 0
      {
        if(slope_of_value > 0.)
          begin = std::max(begin, -value / slope_of_value);
        else if(slope_of_value < 0.)
          end = std::min(end, -value / slope_of_value);
        else if(value < 0.)
          end = -1.;
      };
      clip(corner[0], edge_direction[0]);
      clip(size - corner[0], -edge_direction[0]);
      clip(sign * corner[1], sign * edge_direction[1]);
      const Vec2 backward = rotated_back(rotated({0., -sign}, along), axis);
      if(begin < end && backward[1] > 0.) // it leaves the triangle
        enqueue(t.twin[h], {{-backward[0], -backward[1]},
                            piece.offset + sign * (corner[1] + length * edge_direction[1]),
                            length - end,
                            length - begin,
                            origin,
                            -0.f});
    }
  }
}

} // namespace CGAL::Geodesic_processing::internal
