// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/Polar_frame.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Geodesic_processing::internal {

Polar_frame::Polar_frame(const Surface_arrays& t, const Surface_location& location)
    : m_triangles(&t), m_location(canonical(t, location)), m_vertex(vertex_of(t, m_location))
{
  if(m_location.triangle == none)
    return;
  if(m_vertex == none)
  {
    m_fans.push_back({});
    if(const Index h = halfedge_of(m_location); h != none)
    {
      m_axis = (t.twin[h] < h ? pi : 0.) - angle_of_halfedge(h);
      if(t.twin[h] == none)
        m_fans.back() = {0., pi, false};
    }
    return;
  }
  double angle = 0.;
  for(Index i = t.ring_begin[m_vertex]; i < t.ring_begin[m_vertex + 1];)
  {
    const Index first = t.ring[i];
    Direction_fan fan = {angle, 0., false};
    Index corner = first;
    for(bool is_same_fan = true; is_same_fan; ++i)
    {
      fan.angle += interior_angle(t, corner);
      corner = next_corner_ccw(t, corner);
      is_same_fan = corner != none && corner != first && i + 1 < t.ring_begin[m_vertex + 1];
    }
    fan.is_closed = corner == first;
    angle += fan.angle;
    m_fans.push_back(fan);
    m_first_corners.push_back(first);
  }
}

double Polar_frame::angle_of_halfedge(Index h) const
{
  const auto corners = unfolded(*m_triangles, h / 3);
  const Vec2 edge = corners[next_halfedge(h) % 3] - corners[h % 3];
  return std::atan2(edge[1], edge[0]);
}

double Polar_frame::polar_angle(double angle_in_triangle) const
{
  return angle_in_triangle + m_axis;
}

Straightest_path Polar_frame::path(double polar_angle, double length) const
{
  const Surface_arrays& t = *m_triangles;
  if(m_fans.empty() || m_first_corners.empty())
    return trace_straightest(t, m_location, polar_angle - m_axis, length);
  std::size_t i = 0;
  while(i + 1 < m_fans.size() && polar_angle >= m_fans[i + 1].begin)
    ++i;
  double angle = polar_angle - m_fans[i].begin;
  if(m_fans[i].is_closed)
    angle -= m_fans[i].angle * std::floor(angle / m_fans[i].angle);
  const Index first = m_first_corners[i];
  Index corner = first;
  for(double corner_angle = interior_angle(t, corner); angle > corner_angle;
      corner_angle = interior_angle(t, corner))
  {
    const Index next = next_corner_ccw(t, corner);
    if(next == none || next == first)
      break;
    angle -= corner_angle;
    corner = next;
  }
  return trace_straightest(t, {corner / 3, none, barycentric_at_corner(corner)},
                           angle_of_halfedge(corner) + std::min(angle, interior_angle(t, corner)),
                           length);
}

} // namespace CGAL::Geodesic_processing::internal
