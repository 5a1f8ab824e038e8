// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Split_mesh.h"

#include "core/unfold.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Smaller barycentric coordinates of samples are set to zero. Next to feature edges, only
// round-off errors are, so that no sample changes sides.
constexpr double snap_tolerance = 0.01, roundoff_tolerance = 1e-12;

} // namespace

std::size_t dominant_coordinate(const std::array<std::array<double, 3>, 3>& corner)
{
  std::array<double, 3> smallest;
  for(std::size_t k = 0; k < 3; ++k)
    smallest[k] = std::min({corner[0][k], corner[1][k], corner[2][k]});
  return std::size_t(std::max_element(smallest.begin(), smallest.end()) - smallest.begin());
}

std::array<double, 3> subtriangle_coordinates(const std::array<std::array<double, 3>, 3>& corner,
                                              const std::array<double, 3>& p)
{
  using Barycentric = std::array<double, 3>;
  const std::size_t k = dominant_coordinate(corner), i = (k + 1) % 3, j = (k + 2) % 3;
  // Exactly zero if the points are on one edge of the coarse triangle. For two of the edges a
  // factor of both products is zero; for the third this must be tested.
  const auto twice_area = [=](const Barycentric& a, const Barycentric& b, const Barycentric& c)
  {
    return a[k] == 0. && b[k] == 0. && c[k] == 0.
               ? 0.
               : (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
  };
  const double total_area = twice_area(corner[0], corner[1], corner[2]);
  if(!(total_area > 0.))
    return {-infinity, -infinity, -infinity};
  return {twice_area(p, corner[1], corner[2]) / total_area,
          twice_area(corner[0], p, corner[2]) / total_area,
          twice_area(corner[0], corner[1], p) / total_area};
}

Split_mesh::Split_mesh(const Surface_arrays& coarse, const std::vector<bool>& is_curve)
    : m_coarse(coarse)
{
  m_arrays.corner = coarse.corner;
  m_arrays.twin = coarse.twin;
  m_arrays.point = coarse.point;
  m_arrays.scale = coarse.scale;
  m_arrays.origin = coarse.origin;
  m_coarse_triangle.resize(coarse.number_of_triangles());
  std::iota(m_coarse_triangle.begin(), m_coarse_triangle.end(), Index(0));
  m_label.assign(coarse.corner.size(), none);
  for(Index h = 0; h < m_label.size(); ++h)
    if(is_curve[h])
      m_label[h] = curve_label;
  for(Index vertex = 0; vertex < coarse.number_of_vertices(); ++vertex)
    m_location.push_back(vertex_location(coarse, vertex));
  m_corner_of.assign(coarse.number_of_vertices(), none);
  split_nonmanifold_vertices();
}

double Split_mesh::angle_at(Index corner) const
{
  const Vec3 &p = m_arrays.point[source(corner)], u = m_arrays.point[target(corner)] - p,
             v = m_arrays.point[apex(corner)] - p;
  return std::atan2(norm(cross(u, v)), dot(u, v));
}

std::array<double, 3> Split_mesh::barycentric(Index face, Index vertex) const
{
  return *barycentric_in(m_coarse, m_coarse_triangle[face], m_location[vertex]);
}

std::vector<Index> Split_mesh::corners_around(Index vertex) const
{
  std::vector<Index> result;
  const Index begin = m_corner_of[vertex];
  if(begin == none)
    return result;
  Index first = begin;
  for(Index previous = next_corner_cw(m_arrays, begin); previous != none && previous != begin;
      previous = next_corner_cw(m_arrays, previous))
    first = previous;
  if(next_corner_cw(m_arrays, first) != none)
    first = begin;
  for(Index corner = first; corner != none && (result.empty() || corner != first);
      corner = next_corner_ccw(m_arrays, corner))
    result.push_back(corner);
  return result;
}

std::vector<Index> Split_mesh::halfedges_around(Index vertex) const
{
  std::vector<Index> result = corners_around(vertex);
  if(!result.empty() && m_arrays.twin[previous_halfedge(result.back())] == none)
    result.push_back(previous_halfedge(result.back()));
  return result;
}

void Split_mesh::set_label(Index h, Index label)
{
  m_label[h] = label;
  if(m_arrays.twin[h] != none)
    m_label[m_arrays.twin[h]] = label;
}

Index Split_mesh::split_edge(Index h, double fraction)
{
  const Index twin = m_arrays.twin[h], u = source(h), v = target(h);
  const Barycentric from = barycentric(h / 3, u), to = barycentric(h / 3, v);
  Surface_location location{m_coarse_triangle[h / 3], none, {}};
  for(std::size_t k = 0; k < 3; ++k)
    location.barycentric[k] = (1. - fraction) * from[k] + fraction * to[k];
  const Index p = add_vertex((1. - fraction) * m_arrays.point[u] + fraction * m_arrays.point[v],
                             canonical(m_coarse, location));
  const Index new_h = split_halfedge(h, p);
  if(twin != none)
  {
    const Index other = split_halfedge(twin, p);
    set_twins(h, other);
    set_twins(new_h, twin);
  }
  else
    m_arrays.twin[new_h] = none;
  m_corner_of[p] = next_halfedge(h);
  return p;
}

Index Split_mesh::insert(const Surface_location& sample)
{
  Index best = none;
  double largest_minimum = -infinity;
  Barycentric barycentric_inside = {};
  const auto consider = [&](Index f)
  {
    const Barycentric b = coordinates_in_subtriangle(f, sample.barycentric);
    const double minimum = std::min({b[0], b[1], b[2]});
    if(minimum > largest_minimum)
    {
      largest_minimum = minimum;
      best = f;
      barycentric_inside = b;
    }
  };
  consider(sample.triangle);
  if(const auto subtriangles = m_subtriangles.find(sample.triangle);
     subtriangles != m_subtriangles.end())
    for(const Index subtriangle : subtriangles->second)
      consider(subtriangle);

  // Snaps the sample to a close edge or vertex, but never across a feature edge.
  for(Index k = 0; k < 3; ++k)
  {
    const Index h = 3 * best + (k + 1) % 3;
    const bool is_curve = m_label[h] != none || is_on_curve(source(h)) || is_on_curve(target(h)) ||
                          m_arrays.twin[h] == none;
    if(barycentric_inside[k] < (is_curve ? roundoff_tolerance : snap_tolerance))
      barycentric_inside[k] = 0.;
  }
  const double sum = barycentric_inside[0] + barycentric_inside[1] + barycentric_inside[2];
  for(Index k = 0; k < 3; ++k)
    if(barycentric_inside[k] == sum)
      if(const Index vertex = m_arrays.corner[3 * best + k]; !is_sample(vertex))
        return mark_sample(vertex);
  for(Index k = 0; k < 3; ++k)
    if(barycentric_inside[k] == 0.)
    {
      const Index h = 3 * best + (k + 1) % 3;
      const double fraction = barycentric_inside[(k + 2) % 3] / sum;
      return mark_sample(
          split_edge(h, std::clamp(fraction, min_split_fraction, 1. - min_split_fraction)));
    }
  return mark_sample(split_triangle(best, {barycentric_inside[0] / sum, barycentric_inside[1] / sum,
                                           barycentric_inside[2] / sum}));
}

// A nonmanifold vertex keeps its first fan; each other fan gets a new vertex.
void Split_mesh::split_nonmanifold_vertices()
{
  std::vector<bool> is_seen(m_arrays.corner.size(), false);
  for(Index corner = 0; corner < m_arrays.corner.size(); ++corner)
  {
    if(is_seen[corner])
      continue;
    Index vertex = m_arrays.corner[corner];
    if(m_corner_of[vertex] != none)
    {
      const Index new_vertex = Index(m_location.size());
      m_location.push_back({corner / 3, none, barycentric_at_corner(corner)});
      m_arrays.point.push_back(m_arrays.point[vertex]);
      m_corner_of.push_back(none);
      vertex = new_vertex;
    }
    m_corner_of[vertex] = corner;
    Index c = corner;
    do
    {
      is_seen[c] = true;
      m_arrays.corner[c] = vertex;
      c = next_corner_ccw(m_arrays, c);
    } while(c != none && c != corner);
    if(c == none)
      for(c = next_corner_cw(m_arrays, corner); c != none; c = next_corner_cw(m_arrays, c))
      {
        is_seen[c] = true;
        m_arrays.corner[c] = vertex;
      }
  }
}

bool Split_mesh::is_on_curve(Index vertex) const
{
  const std::vector<Index> halfedges = halfedges_around(vertex);
  return std::any_of(halfedges.begin(), halfedges.end(),
                     [&](Index s) { return m_label[s] != none; });
}

Index Split_mesh::mark_sample(Index vertex)
{
  if(m_is_sample.size() <= vertex)
    m_is_sample.resize(std::size_t(vertex) + 1, false);
  m_is_sample[vertex] = true;
  return vertex;
}

void Split_mesh::set_twins(Index h, Index twin)
{
  m_arrays.twin[h] = twin;
  m_arrays.twin[twin] = h;
}

Index Split_mesh::add_vertex(const Vec3& point, const Surface_location& location)
{
  m_arrays.point.push_back(point);
  m_location.push_back(location);
  m_corner_of.push_back(none);
  return Index(m_location.size() - 1);
}

Index Split_mesh::add_triangle(Index coarse_triangle)
{
  const Index f = Index(m_arrays.number_of_triangles());
  m_arrays.corner.resize(m_arrays.corner.size() + 3);
  m_arrays.twin.resize(m_arrays.corner.size(), none);
  m_label.resize(m_arrays.corner.size(), none);
  m_coarse_triangle.push_back(coarse_triangle);
  m_subtriangles[coarse_triangle].push_back(f);
  return f;
}

// Moves a halfedge with its twin and label to another index.
void Split_mesh::move_halfedge(Index from, Index to)
{
  m_label[to] = m_label[from];
  m_arrays.twin[to] = m_arrays.twin[from];
  if(m_arrays.twin[to] != none)
    m_arrays.twin[m_arrays.twin[to]] = to;
}

// Replaces uvw, with h = uv, by upw and a new triangle pvw. Returns the halfedge pv, whose twin is
// not yet set.
Index Split_mesh::split_halfedge(Index h, Index p)
{
  const Index next = next_halfedge(h), u_to_v = m_label[h];
  const Index new_h = 3 * add_triangle(m_coarse_triangle[h / 3]);
  const Index v = m_arrays.corner[next], w = m_arrays.corner[previous_halfedge(h)];
  m_arrays.corner[new_h] = p;
  m_arrays.corner[new_h + 1] = v;
  m_arrays.corner[new_h + 2] = w;
  m_arrays.corner[next] = p;
  move_halfedge(next, new_h + 1);
  m_label[new_h] = u_to_v;
  m_label[new_h + 2] = m_label[next] = none;
  set_twins(next, new_h + 2);
  if(m_corner_of[v] == next)
    m_corner_of[v] = new_h + 1;
  return new_h;
}

// Inserts a vertex p with barycentric coordinates b into the triangle xyz = f and returns it. The
// triangle becomes xyp; yzp and zxp are new.
Index Split_mesh::split_triangle(Index f, const Barycentric& b)
{
  Vec3 point = {0., 0., 0.};
  Surface_location location{m_coarse_triangle[f], none, {0., 0., 0.}};
  for(Index k = 0; k < 3; ++k)
  {
    point = point + b[k] * m_arrays.point[m_arrays.corner[3 * f + k]];
    const Barycentric corner = barycentric(f, m_arrays.corner[3 * f + k]);
    for(std::size_t j = 0; j < 3; ++j)
      location.barycentric[j] += b[k] * corner[j];
  }
  const Index p = add_vertex(point, canonical(m_coarse, location));
  const Index second = 3 * add_triangle(m_coarse_triangle[f]),
              third = 3 * add_triangle(m_coarse_triangle[f]);
  const Index x = m_arrays.corner[3 * f], y = m_arrays.corner[3 * f + 1],
              z = m_arrays.corner[3 * f + 2];
  const std::array<Index, 3> yzp = {y, z, p}, zxp = {z, x, p};
  std::copy(yzp.begin(), yzp.end(), m_arrays.corner.begin() + second);
  std::copy(zxp.begin(), zxp.end(), m_arrays.corner.begin() + third);
  move_halfedge(3 * f + 1, second);
  move_halfedge(3 * f + 2, third);
  m_arrays.corner[3 * f + 2] = p;
  m_label[3 * f + 1] = m_label[3 * f + 2] = none;
  set_twins(3 * f + 1, second + 2);
  set_twins(second + 1, third + 2);
  set_twins(third + 1, 3 * f + 2);
  m_corner_of[p] = 3 * f + 2;
  if(m_corner_of[z] == 3 * f + 2)
    m_corner_of[z] = second + 1;
  return p;
}

// Returns the coordinates, with respect to triangle f, of a location of its coarse triangle.
std::array<double, 3> Split_mesh::coordinates_in_subtriangle(Index f, const Barycentric& b) const
{
  std::array<Barycentric, 3> corner;
  for(Index k = 0; k < 3; ++k)
    corner[k] = barycentric(f, m_arrays.corner[3 * f + k]);
  return subtriangle_coordinates(corner, b);
}

} // namespace CGAL::Geodesic_processing::internal
