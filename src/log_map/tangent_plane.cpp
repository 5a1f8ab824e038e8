// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/tangent_plane.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace CGAL::Geodesic_processing::internal {

namespace {

Vec3 edge_vector(const Surface_arrays& t, Index h)
{
  return t.point[t.corner[next_halfedge(h)]] - t.point[t.corner[h]];
}

// Returns the normal of a corner's triangle, whose length is twice the area.
Vec3 area_vector(const Surface_arrays& t, Index corner)
{
  return cross(edge_vector(t, corner), -1. * edge_vector(t, previous_halfedge(corner)));
}

} // namespace

Vec3 vertex_normal(const Surface_arrays& t, Index vertex)
{
  if(t.is_cloud())
    return t.normal[vertex];
  Vec3 sum = {0., 0., 0.};
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    sum = sum + area_vector(t, t.ring[i]);
  return unit(sum);
}

Tangent_plane::Tangent_plane(const Surface_arrays& t, const Surface_location& location)
    : m_triangles(t), m_location(canonical(t, location))
{
  const Index vertex = m_location.triangle == none ? m_location.vertex : vertex_of(t, m_location);
  if(t.is_cloud())
  {
    initialize_on_cloud(vertex);
    return;
  }
  if(m_location.triangle == none)
    throw Invalid_argument_error("An isolated vertex has no tangent plane.");
  m_point = scaled_coordinates(t, m_location);
  if(vertex != none)
    initialize_at_vertex(vertex);
  else if(const Index h = halfedge_of(m_location); h != none)
    initialize_on_edge(h);
  else
    set_axes({{0., edge_vector(t, 3 * m_location.triangle)}},
             unit(area_vector(t, 3 * m_location.triangle)));
}

void Tangent_plane::initialize_on_cloud(Index vertex)
{
  const Surface_arrays& t = m_triangles;
  const Index nearest = vertex != none ? vertex
                                       : t.corner[3 * std::size_t(m_location.triangle) +
                                                  (std::max_element(m_location.barycentric.begin(),
                                                                    m_location.barycentric.end()) -
                                                   m_location.barycentric.begin())];
  m_point = m_location.triangle == none ? t.point[vertex] : scaled_coordinates(t, m_location);
  std::tie(m_x, m_y) = tangent_frame(t.normal[nearest]);
}

void Tangent_plane::initialize_at_vertex(Index vertex)
{
  const Surface_arrays& t = m_triangles;
  std::vector<std::pair<double, Vec3>> directions;
  m_total_polar_angle = 0.;
  bool is_on_boundary = false;
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
  {
    const Index corner = t.ring[i];
    m_sectors.emplace_back(corner, m_total_polar_angle);
    directions.emplace_back(m_total_polar_angle, edge_vector(t, corner));
    m_total_polar_angle += interior_angle(t, corner);
    if(t.twin[previous_halfedge(corner)] == none)
    {
      is_on_boundary = true;
      directions.emplace_back(m_total_polar_angle, -1. * edge_vector(t, previous_halfedge(corner)));
    }
  }
  // The total angle can be zero at the tip of a degenerate triangle.
  const double angle_scale = m_total_polar_angle > 0. ? 2. * pi / m_total_polar_angle : 1.;
  m_angle_scale = is_on_boundary ? std::min(1., angle_scale) : angle_scale;
  set_axes(directions, unit(vertex_normal(t, vertex)));
}

void Tangent_plane::initialize_on_edge(Index h)
{
  const Surface_arrays& t = m_triangles;
  const Index twin = t.twin[h];
  const Index first_halfedge = std::min(h, twin);
  m_sectors.emplace_back(first_halfedge, 0.);
  Vec3 normal = area_vector(t, first_halfedge);
  if(twin == none)
    m_total_polar_angle = pi;
  else
  {
    m_sectors.emplace_back(t.twin[first_halfedge], pi);
    normal = normal + area_vector(t, t.twin[first_halfedge]);
  }
  set_axes({{0., edge_vector(t, first_halfedge)}}, unit(normal));
}

// Sets the axes in the plane of a normal such that the angles of projected directions agree with
// their tangent angles on average.
//
// directions  polar angles and vectors in space
void Tangent_plane::set_axes(const std::vector<std::pair<double, Vec3>>& directions,
                             const Vec3& normal)
{
  const auto [u, v] = tangent_frame(normal == Vec3{0., 0., 0.} ? Vec3{0., 0., 1.} : normal);
  Vec2 sum = {0., 0.};
  for(const auto& [polar, direction] : directions)
  {
    const Vec2 projected = {dot(direction, u), dot(direction, v)};
    const double angle = tangent_angle(polar);
    sum = sum + rotated_back(projected, {std::cos(angle), std::sin(angle)});
  }
  const double size = norm(sum);
  const Vec2 rotation = size > 0. ? (1. / size) * sum : Vec2{1., 0.};
  m_x = rotation[0] * u + rotation[1] * v;
  m_y = rotation[0] * v - rotation[1] * u;
}

double Tangent_plane::tangent_angle(const Vec3& direction) const
{
  const double tangential_length = std::hypot(dot(direction, m_x), dot(direction, m_y));
  // The projection of a unit normal vector consists of round-off errors.
  if(!(tangential_length > 1e-14 * norm(direction)) || !std::isfinite(tangential_length))
    throw Invalid_argument_error("A direction is zero, not finite, or normal to the surface.");
  return std::atan2(dot(direction, m_y), dot(direction, m_x));
}

Straightest_path Tangent_plane::straightest_path(double tangent_angle, double length) const
{
  if(m_sectors.empty())
    return trace_straightest(m_triangles, m_location, tangent_angle, length);
  double polar = std::fmod(tangent_angle, 2. * pi);
  if(polar < 0.)
    polar += 2. * pi;
  polar /= m_angle_scale;
  if(polar > m_total_polar_angle * (1. + 1e-12))
    return {{m_location}, 0., 0., Straightest_path_end::boundary};
  const auto sector = std::upper_bound(m_sectors.begin() + 1, m_sectors.end(), polar,
                                       [](double angle, const auto& candidate)
                                       { return angle < candidate.second; }) -
                      1;
  const Index triangle = sector->first / 3;
  const auto corners = unfolded(m_triangles, triangle);
  const Vec2 edge = corners[next_halfedge(sector->first) % 3] - corners[sector->first % 3];
  return trace_straightest(m_triangles,
                           {triangle, none, *barycentric_in(m_triangles, triangle, m_location)},
                           std::atan2(edge[1], edge[0]) + polar - sector->second, length);
}

} // namespace CGAL::Geodesic_processing::internal
