// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/smoothing.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "mesh/walk.h"

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// What is gone of the way to the centroid.
constexpr double way_to_centroid = 1.5;

// The size of the sum of the normals around a sample, in parts of their sizes: where it is less, at creases and tips,
// samples would be drawn away.  With 0.9 the first percentile of the angles is 0.8 degrees less in the mean of six
// models, and the RMS distance from them a fifteenth; as it is that is a tenth more than without smoothing.
constexpr double flattest_to_stay = 0.75;

} // namespace

Smoothing::Smoothing(const Glued_triangles& triangles, const std::vector<double>* slowness,
                     std::vector<Location> samples,
                     const std::vector<std::array<Index, 3>>& between_samples,
                     std::vector<bool> is_fixed, const std::vector<bool>& is_curve)
    : m_triangles(triangles), m_slowness(slowness), m_is_curve(is_curve),
      m_samples(std::move(samples)), m_is_fixed(std::move(is_fixed)),
      m_between_samples(m_samples.size(), between_samples)
{
  for(const Location& sample : m_samples)
    m_points.push_back(scaled_coordinates(m_triangles, sample));
  std::vector<bool> is_surrounded(m_samples.size(), false);
  for(const Index sample : m_between_samples.corner())
    is_surrounded[sample] = true;
  for(Index side = 0; side < m_between_samples.corner().size(); ++side)
    if(m_between_samples.twin()[side] == none)
      for(const Index end : {side, next_side(side)})
        is_surrounded[m_between_samples.corner()[end]] = false;
  for(std::size_t i = 0; i < m_samples.size(); ++i)
    m_is_fixed[i] = m_is_fixed[i] || !is_surrounded[i];
  flip();
}

void Smoothing::step()
{
  make_cells();
  for(Index i = 0; i < m_samples.size(); ++i)
  {
    const Cell& cell = m_cells[i];
    if(m_is_fixed[i] || !(cell.mass > 0.) || norm(cell.normal) < flattest_to_stay * cell.area)
      continue;
    const Spatial normal = unit(cell.normal), way = (1. / cell.mass) * cell.moment - m_points[i];
    const Location moved = walk_to_nearest(
        m_triangles, triangle_at(m_triangles, m_samples[i]),
        m_points[i] + way_to_centroid * (way - dot(way, normal) * normal),
        [](Index) { return true; }, [&](Index side) { return m_is_curve[side]; });
    if(moved.triangle == none)
      continue;
    m_samples[i] = cleaned(m_triangles, moved);
    m_points[i] = scaled_coordinates(m_triangles, m_samples[i]);
  }
  flip();
}

// As of cells on the surface: see triangle_masses().
double Smoothing::density(Index sample) const
{
  const Index triangle = triangle_at(m_triangles, m_samples[sample]);
  if(!m_slowness || triangle == none)
    return 1.;
  const double square = (*m_slowness)[triangle] * (*m_slowness)[triangle];
  return square * square;
}

void Smoothing::make_cells()
{
  m_cells.assign(m_samples.size(), Cell());
  const std::vector<Index>& corner = m_between_samples.corner();
  for(std::size_t c = 0; c < corner.size(); c += 3)
  {
    const std::array<Index, 3> samples = {corner[c], corner[c + 1], corner[c + 2]};
    divide(samples, m_slowness
                        ? (density(samples[0]) + density(samples[1]) + density(samples[2])) / 3.
                        : 1.);
  }
}

// Among its corners, each of which gets what is nearest to it.
void Smoothing::divide(const std::array<Index, 3>& samples, double density)
{
  const std::array<Spatial, 3> p = {m_points[samples[0]], m_points[samples[1]],
                                    m_points[samples[2]]};
  const std::array<Spatial, 3> way = {p[1] - p[0], p[2] - p[1], p[0] - p[2]}; // along each side
  const Spatial normal = cross(way[0], way[1]);
  const double area = norm(normal), mass = density * area;
  if(!(area > 0.))
    return;
  std::array<double, 3> square, product; // of each side, and of the two at each corner
  for(int k = 0; k < 3; ++k)
  {
    Cell& cell = m_cells[samples[k]];
    cell.area += area;
    cell.normal = cell.normal + normal;
    square[k] = dot(way[k], way[k]);
    product[k] = -dot(way[k], way[(k + 2) % 3]);
  }
  // A triangle, by its part of the area and the sum of its corners.
  const auto add = [&](int k, double part, const Spatial& corners)
  {
    Cell& cell = m_cells[samples[k]];
    cell.mass += part * mass;
    cell.moment = cell.moment + (part * mass / 3.) * corners;
  };
  const auto blunt = std::find_if(product.begin(), product.end(), [](double x) { return x <= 0.; });
  if(blunt == product.end())
  {
    // A quadrangle for each, in two triangles, about the centre of their circle.
    std::array<double, 3> share;
    for(int k = 0; k < 3; ++k)
      share[k] = square[(k + 1) % 3] * product[k];
    const double sum = share[0] + share[1] + share[2];
    for(double& s : share)
      s /= sum;
    const Spatial centre = share[0] * p[0] + share[1] * p[1] + share[2] * p[2];
    for(int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3, previous = (k + 2) % 3;
      add(k, 0.5 * share[previous], 1.5 * p[k] + 0.5 * p[next] + centre);
      add(k, 0.5 * share[next], 1.5 * p[k] + 0.5 * p[previous] + centre);
    }
    return;
  }
  // A triangle for each of the two others, up to the middle of their side to the blunt corner, and what they leave.
  const int at = int(blunt - product.begin()), next = (at + 1) % 3, previous = (at + 2) % 3;
  add(at, 1., p[0] + p[1] + p[2]);
  const auto cut = [&](int k, int other, double square_to_blunt)
  {
    const double along = 0.5 * square_to_blunt / product[k];
    const Spatial corners = 2.5 * p[k] + 0.5 * p[at] + along * (p[other] - p[k]);
    add(k, 0.5 * along, corners);
    add(at, -0.5 * along, corners);
  };
  cut(next, previous, square[at]);
  cut(previous, next, square[previous]);
}

// Once around each edge: what that leaves is for the next step.
void Smoothing::flip()
{
  Flippable_triangles& t = m_between_samples;
  for(Index side = 0; side < t.corner().size(); ++side)
  {
    const Index twin = t.twin()[side];
    if(twin == none || twin < side)
      continue;
    const Index x = t.corner()[side], y = t.corner()[twin], z = t.corner()[previous_side(side)],
                w = t.corner()[previous_side(twin)];
    if((m_is_fixed[x] && m_is_fixed[y]) || z == w)
      continue;
    const Spatial xz = m_points[x] - m_points[z], yz = m_points[y] - m_points[z],
                  xw = m_points[x] - m_points[w], yw = m_points[y] - m_points[w];
    const double at_z = dot(xz, yz), at_w = dot(xw, yw);
    if(at_z >= 0. && at_w >= 0.)
      continue;
    // Together the two angles are more than half a turn.
    if(at_z * norm(cross(xw, yw)) + at_w * norm(cross(xz, yz)) < 0. &&
       !t.is_joined(previous_side(side), w))
      t.flip(side);
  }
}

} // namespace CGAL::Geodesic_processing::internal
