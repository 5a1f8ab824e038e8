// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Divided_mesh.h"

#include "core/unfold.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Barycentric coordinates of samples below are zero, but next to curves only what is rounding.
constexpr double snapping = 0.01, rounding = 1e-12;

} // namespace

std::array<double, 3> coordinates_in_part(const std::array<std::array<double, 3>, 3>& corner,
                                          const std::array<double, 3>& p)
{
  using Barycentric = std::array<double, 3>;
  // Exactly zero along all three sides of the triangle: along two the differences are.
  const auto twice = [](const Barycentric& a, const Barycentric& b, const Barycentric& c)
  {
    return a[0] == 0. && b[0] == 0. && c[0] == 0.
               ? 0.
               : (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
  };
  const double whole = twice(corner[0], corner[1], corner[2]);
  if(!(whole > 0.))
    return {-infinity, -infinity, -infinity};
  return {twice(p, corner[1], corner[2]) / whole, twice(corner[0], p, corner[2]) / whole,
          twice(corner[0], corner[1], p) / whole};
}

Divided_mesh::Divided_mesh(const Glued_triangles& coarse, const std::vector<bool>& is_curve)
    : m_coarse(coarse)
{
  m_t.corner = coarse.corner;
  m_t.twin = coarse.twin;
  m_t.point = coarse.point;
  m_t.scale = coarse.scale;
  m_t.origin = coarse.origin;
  m_whole.resize(coarse.number_of_triangles());
  std::iota(m_whole.begin(), m_whole.end(), Index(0));
  m_label.assign(coarse.corner.size(), none);
  for(Index side = 0; side < m_label.size(); ++side)
    if(is_curve[side])
      m_label[side] = curve;
  for(Index site = 0; site < coarse.number_of_sites(); ++site)
    m_location.push_back(at_site(coarse, site));
  m_corner_of.assign(coarse.number_of_sites(), none);
  take_apart_pinched_sites();
}

double Divided_mesh::angle_at(Index corner) const
{
  const Spatial &p = m_t.point[source(corner)], u = m_t.point[target(corner)] - p,
                v = m_t.point[apex(corner)] - p;
  return std::atan2(norm(cross(u, v)), dot(u, v));
}

std::array<double, 3> Divided_mesh::barycentric(Index face, Index site) const
{
  return *seen_from(m_coarse, m_whole[face], m_location[site]);
}

std::vector<Index> Divided_mesh::corners_around(Index site) const
{
  std::vector<Index> result;
  const Index begin = m_corner_of[site];
  if(begin == none)
    return result;
  Index first = begin;
  for(Index right = turn_right(m_t, begin); right != none && right != begin;
      right = turn_right(m_t, right))
    first = right;
  if(turn_right(m_t, first) != none)
    first = begin;
  for(Index corner = first; corner != none && (result.empty() || corner != first);
      corner = turn_left(m_t, corner))
    result.push_back(corner);
  return result;
}

std::vector<Index> Divided_mesh::sides_around(Index site) const
{
  std::vector<Index> result = corners_around(site);
  if(!result.empty() && m_t.twin[previous_side(result.back())] == none)
    result.push_back(previous_side(result.back()));
  return result;
}

void Divided_mesh::set_label(Index side, Index label)
{
  m_label[side] = label;
  if(m_t.twin[side] != none)
    m_label[m_t.twin[side]] = label;
}

Index Divided_mesh::split_side(Index side, double share)
{
  const Index twin = m_t.twin[side], u = source(side), v = target(side);
  const Barycentric from = barycentric(side / 3, u), to = barycentric(side / 3, v);
  Location place{m_whole[side / 3], none, {}};
  for(std::size_t k = 0; k < 3; ++k)
    place.barycentric[k] = (1. - share) * from[k] + share * to[k];
  const Index p =
      add_site((1. - share) * m_t.point[u] + share * m_t.point[v], cleaned(m_coarse, place));
  const Index part = halve(side, p);
  if(twin != none)
  {
    const Index other = halve(twin, p);
    glue(side, other);
    glue(part, twin);
  }
  else
    m_t.twin[part] = none;
  m_corner_of[p] = next_side(side);
  return p;
}

Index Divided_mesh::insert(const Location& sample)
{
  Index best = none;
  double most = -infinity;
  Barycentric inside = {};
  const auto look_into = [&](Index f)
  {
    const Barycentric b = coordinates_in(f, sample.barycentric);
    const double least = std::min({b[0], b[1], b[2]});
    if(least > most)
    {
      most = least;
      best = f;
      inside = b;
    }
  };
  look_into(sample.triangle);
  if(const auto parts = m_parts.find(sample.triangle); parts != m_parts.end())
    for(const Index part : parts->second)
      look_into(part);

  // Those near a side or a site go there, but nowhere where they would change sides of a curve.
  for(Index k = 0; k < 3; ++k)
  {
    const Index side = 3 * best + (k + 1) % 3;
    const bool is_curve = m_label[side] != none || touches_curve(source(side)) ||
                          touches_curve(target(side)) || m_t.twin[side] == none;
    if(inside[k] < (is_curve ? rounding : snapping))
      inside[k] = 0.;
  }
  const double sum = inside[0] + inside[1] + inside[2];
  for(Index k = 0; k < 3; ++k)
    if(inside[k] == sum)
      if(const Index site = m_t.corner[3 * best + k]; !is_taken(site))
        return take(site);
  for(Index k = 0; k < 3; ++k)
    if(inside[k] == 0.)
    {
      const Index side = 3 * best + (k + 1) % 3;
      const double share = inside[(k + 2) % 3] / sum;
      return take(split_side(side, std::clamp(share, margin, 1. - margin)));
    }
  return take(split_triangle(best, {inside[0] / sum, inside[1] / sum, inside[2] / sum}));
}

// Each fan of a site that has several gets a site of its own.
void Divided_mesh::take_apart_pinched_sites()
{
  std::vector<bool> is_seen(m_t.corner.size(), false);
  for(Index corner = 0; corner < m_t.corner.size(); ++corner)
  {
    if(is_seen[corner])
      continue;
    Index site = m_t.corner[corner];
    if(m_corner_of[site] != none)
    {
      const Index copy = Index(m_location.size());
      m_location.push_back({corner / 3, none, at_corner(corner)});
      m_t.point.push_back(m_t.point[site]);
      m_corner_of.push_back(none);
      site = copy;
    }
    m_corner_of[site] = corner;
    Index turned = corner;
    do
    {
      is_seen[turned] = true;
      m_t.corner[turned] = site;
      turned = turn_left(m_t, turned);
    } while(turned != none && turned != corner);
    if(turned == none)
      for(turned = turn_right(m_t, corner); turned != none; turned = turn_right(m_t, turned))
      {
        is_seen[turned] = true;
        m_t.corner[turned] = site;
      }
  }
}

bool Divided_mesh::touches_curve(Index site) const
{
  const std::vector<Index> sides = sides_around(site);
  return std::any_of(sides.begin(), sides.end(), [&](Index s) { return m_label[s] != none; });
}

Index Divided_mesh::take(Index site)
{
  if(m_is_taken.size() <= site)
    m_is_taken.resize(std::size_t(site) + 1, false);
  m_is_taken[site] = true;
  return site;
}

void Divided_mesh::glue(Index side, Index twin)
{
  m_t.twin[side] = twin;
  m_t.twin[twin] = side;
}

Index Divided_mesh::add_site(const Spatial& point, const Location& location)
{
  m_t.point.push_back(point);
  m_location.push_back(location);
  m_corner_of.push_back(none);
  return Index(m_location.size() - 1);
}

Index Divided_mesh::add_triangle(Index whole)
{
  const Index f = Index(m_t.number_of_triangles());
  m_t.corner.resize(m_t.corner.size() + 3);
  m_t.twin.resize(m_t.corner.size(), none);
  m_label.resize(m_t.corner.size(), none);
  m_whole.push_back(whole);
  m_parts[whole].push_back(f);
  return f;
}

// Moves the side of a triangle into another one, with its twin and label.
void Divided_mesh::move(Index from, Index to)
{
  m_label[to] = m_label[from];
  m_t.twin[to] = m_t.twin[from];
  if(m_t.twin[to] != none)
    m_t.twin[m_t.twin[to]] = to;
}

// Of u v w makes u p w and, new, p v w, whose side p v is returned, not yet glued.
Index Divided_mesh::halve(Index side, Index p)
{
  const Index next = next_side(side), u_to_v = m_label[side];
  const Index part = 3 * add_triangle(m_whole[side / 3]);
  const Index v = m_t.corner[next], w = m_t.corner[previous_side(side)];
  m_t.corner[part] = p;
  m_t.corner[part + 1] = v;
  m_t.corner[part + 2] = w;
  m_t.corner[next] = p;
  move(next, part + 1);
  m_label[part] = u_to_v;
  m_label[part + 2] = m_label[next] = none;
  glue(next, part + 2);
  if(m_corner_of[v] == next)
    m_corner_of[v] = part + 1;
  return part;
}

Index Divided_mesh::split_triangle(Index f, const Barycentric& b)
{
  Spatial point = {0., 0., 0.};
  Location place{m_whole[f], none, {0., 0., 0.}};
  for(Index k = 0; k < 3; ++k)
  {
    point = point + b[k] * m_t.point[m_t.corner[3 * f + k]];
    const Barycentric corner = barycentric(f, m_t.corner[3 * f + k]);
    for(std::size_t j = 0; j < 3; ++j)
      place.barycentric[j] += b[k] * corner[j];
  }
  const Index p = add_site(point, cleaned(m_coarse, place));
  const Index second = 3 * add_triangle(m_whole[f]), third = 3 * add_triangle(m_whole[f]);
  const Index x = m_t.corner[3 * f], y = m_t.corner[3 * f + 1], z = m_t.corner[3 * f + 2];
  const std::array<Index, 3> yzp = {y, z, p}, zxp = {z, x, p};
  std::copy(yzp.begin(), yzp.end(), m_t.corner.begin() + second);
  std::copy(zxp.begin(), zxp.end(), m_t.corner.begin() + third);
  move(3 * f + 1, second);
  move(3 * f + 2, third);
  m_t.corner[3 * f + 2] = p;
  m_label[3 * f + 1] = m_label[3 * f + 2] = none;
  glue(3 * f + 1, second + 2);
  glue(second + 1, third + 2);
  glue(third + 1, 3 * f + 2);
  m_corner_of[p] = 3 * f + 2;
  if(m_corner_of[z] == 3 * f + 2)
    m_corner_of[z] = second + 1;
  return p;
}

// Of a place in the mesh, in a part of its triangle.
std::array<double, 3> Divided_mesh::coordinates_in(Index f, const Barycentric& b) const
{
  std::array<Barycentric, 3> corner;
  for(Index k = 0; k < 3; ++k)
    corner[k] = barycentric(f, m_t.corner[3 * f + k]);
  return coordinates_in_part(corner, b);
}

} // namespace CGAL::Geodesic_processing::internal
