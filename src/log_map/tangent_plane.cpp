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

Spatial vector_of(const Glued_triangles& t, Index side)
{
  return t.point[t.corner[next_side(side)]] - t.point[t.corner[side]];
}

// Twice the area, along the normal.
Spatial area_vector(const Glued_triangles& t, Index corner)
{
  return cross(vector_of(t, corner), -1. * vector_of(t, previous_side(corner)));
}

} // namespace

Spatial site_normal(const Glued_triangles& t, Index site)
{
  if(t.is_cloud())
    return t.normal[site];
  Spatial sum = {0., 0., 0.};
  for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    sum = sum + area_vector(t, t.star[i]);
  return unit(sum);
}

Tangent_plane::Tangent_plane(const Glued_triangles& t, const Location& at)
    : m_triangles(t), m_at(cleaned(t, at))
{
  const Index site = m_at.triangle == none ? m_at.site : site_of(t, m_at);
  if(t.is_cloud())
  {
    const Index nearest =
        site != none
            ? site
            : t.corner[3 * std::size_t(m_at.triangle) +
                       (std::max_element(m_at.barycentric.begin(), m_at.barycentric.end()) -
                        m_at.barycentric.begin())];
    m_point = m_at.triangle == none ? t.point[site] : scaled_coordinates(t, m_at);
    std::tie(m_x, m_y) = tangent_frame(t.normal[nearest]);
    return;
  }
  if(m_at.triangle == none)
    throw Invalid_argument_error("An isolated vertex has no tangent plane.");
  m_point = scaled_coordinates(t, m_at);
  std::vector<std::pair<double, Spatial>> sides; // polar angles and directions
  Spatial normal = {0., 0., 0.};
  if(site != none)
  {
    m_whole = 0.;
    normal = site_normal(t, site);
    bool is_border = false;
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      const Index corner = t.star[i];
      m_sides.emplace_back(corner, m_whole);
      sides.emplace_back(m_whole, vector_of(t, corner));
      m_whole += interior_angle(t, corner);
      if(t.twin[previous_side(corner)] == none)
      {
        is_border = true;
        sides.emplace_back(m_whole, -1. * vector_of(t, previous_side(corner)));
      }
    }
    // Around a needle's tip there may be no angle at all.
    const double stretch = m_whole > 0. ? 2. * pi / m_whole : 1.;
    m_stretch = is_border ? std::min(1., stretch) : stretch;
  }
  else if(Index side = side_of(m_at); side != none)
  {
    const Index twin = t.twin[side];
    const Index first = std::min(side, twin);
    m_sides.emplace_back(first, 0.);
    sides.emplace_back(0., vector_of(t, first));
    normal = area_vector(t, first);
    if(twin == none)
      m_whole = pi;
    else
    {
      m_sides.emplace_back(t.twin[first], pi);
      normal = normal + area_vector(t, t.twin[first]);
    }
  }
  else
  {
    sides.emplace_back(0., vector_of(t, 3 * m_at.triangle));
    normal = area_vector(t, 3 * m_at.triangle);
  }
  set_axes(sides, unit(normal));
}

// Turns a frame of the normal such that tangent angles agree with the sides' directions.
void Tangent_plane::set_axes(const std::vector<std::pair<double, Spatial>>& sides,
                             const Spatial& normal)
{
  const auto [u, v] = tangent_frame(normal == Spatial{0., 0., 0.} ? Spatial{0., 0., 1.} : normal);
  Planar sum = {0., 0.};
  for(const auto& [polar, direction] : sides)
  {
    const Planar seen = {dot(direction, u), dot(direction, v)};
    const double angle = tangent_angle(polar);
    sum = sum + turned_back(seen, {std::cos(angle), std::sin(angle)});
  }
  const double size = norm(sum);
  const Planar turn = size > 0. ? (1. / size) * sum : Planar{1., 0.};
  m_x = turn[0] * u + turn[1] * v;
  m_y = turn[0] * v - turn[1] * u;
}

double Tangent_plane::tangent_angle(const Spatial& direction) const
{
  const double along = std::hypot(dot(direction, m_x), dot(direction, m_y));
  // What a unit vector along the normal leaves in the plane is rounding.
  if(!(along > 1e-14 * norm(direction)) || !std::isfinite(along))
    throw Invalid_argument_error("A direction is zero, not finite, or normal to the surface.");
  return std::atan2(dot(direction, m_y), dot(direction, m_x));
}

Straightest_path Tangent_plane::straight(double tangent_angle, double length) const
{
  if(m_sides.empty())
    return straightest(m_triangles, m_at, tangent_angle, length);
  double polar = std::fmod(tangent_angle, 2. * pi);
  if(polar < 0.)
    polar += 2. * pi;
  polar /= m_stretch;
  if(polar > m_whole * (1. + 1e-12))
    return {{m_at}, 0., 0., Straightest_end::border};
  const auto sector =
      std::upper_bound(m_sides.begin() + 1, m_sides.end(), polar,
                       [](double angle, const auto& side) { return angle < side.second; }) -
      1;
  const Index triangle = sector->first / 3;
  const auto corners = unfolded(m_triangles, triangle);
  const Planar side = corners[next_side(sector->first) % 3] - corners[sector->first % 3];
  return straightest(m_triangles, {triangle, none, *seen_from(m_triangles, triangle, m_at)},
                     std::atan2(side[1], side[0]) + polar - sector->second, length);
}

} // namespace CGAL::Geodesic_processing::internal
