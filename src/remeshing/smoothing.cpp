// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/smoothing.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "mesh/locate_by_walking.h"

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Step length relative to the distance of the centroid.
constexpr double overrelaxation = 1.5;

// Minimum length of the sum of area-weighted normals around a sample, relative to the sum of their
// lengths. Below it, samples on creases and tips would drift away. On six models the RMS distance
// is a tenth larger than without smoothing. With 0.9, this distance is a fifteenth smaller, and the
// first percentile of the angles is 0.8 degrees smaller on average.
constexpr double min_flatness = 0.75;

// Splits an acute triangle into the Voronoi regions of its corners: quads around the circumcenter,
// added as two triangles each. add(k, fraction, corners) adds a triangle to the cell of corner k,
// given by its fraction of the area and the sum of its corners.
// squared_length: of each edge; dot_product: of the two edges at each corner
template <typename Add>
void split_acute(const std::array<Vec3, 3>& p, const std::array<double, 3>& squared_length,
                 const std::array<double, 3>& dot_product, const Add& add)
{
  std::array<double, 3> weight;
  for(int k = 0; k < 3; ++k)
    weight[k] = squared_length[(k + 1) % 3] * dot_product[k];
  const double sum = weight[0] + weight[1] + weight[2];
  for(double& s : weight)
    s /= sum;
  const Vec3 circumcenter = weight[0] * p[0] + weight[1] * p[1] + weight[2] * p[2];
  for(int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3, previous = (k + 2) % 3;
    add(k, 0.5 * weight[previous], 1.5 * p[k] + 0.5 * p[next] + circumcenter);
    add(k, 0.5 * weight[next], 1.5 * p[k] + 0.5 * p[previous] + circumcenter);
  }
}

// Splits an obtuse triangle. The regions of the two acute corners are triangles that are bounded by
// the bisectors of their edges to the obtuse corner. The rest is the region of the obtuse corner.
template <typename Add>
void split_obtuse(const std::array<Vec3, 3>& p, const std::array<double, 3>& squared_length,
                  const std::array<double, 3>& dot_product, int obtuse_corner, const Add& add)
{
  const int next = (obtuse_corner + 1) % 3, previous = (obtuse_corner + 2) % 3;
  add(obtuse_corner, 1., p[0] + p[1] + p[2]);
  const auto subtract_corner = [&](int k, int other, double squared_length_to_obtuse)
  {
    const double ratio = 0.5 * squared_length_to_obtuse / dot_product[k];
    const Vec3 corners = 2.5 * p[k] + 0.5 * p[obtuse_corner] + ratio * (p[other] - p[k]);
    add(k, 0.5 * ratio, corners);
    add(obtuse_corner, -0.5 * ratio, corners);
  };
  subtract_corner(next, previous, squared_length[obtuse_corner]);
  subtract_corner(previous, next, squared_length[previous]);
}

} // namespace

Smoothing::Smoothing(const Surface_arrays& triangles, const std::vector<double>* slowness,
                     std::vector<Surface_location> samples,
                     const std::vector<std::array<Index, 3>>& sample_triangles,
                     std::vector<bool> is_fixed, const std::vector<bool>& is_feature)
    : m_triangles(triangles), m_slowness(slowness), m_is_feature(is_feature),
      m_samples(std::move(samples)), m_is_fixed(std::move(is_fixed)),
      m_sample_triangles(m_samples.size(), sample_triangles)
{
  for(const Surface_location& sample : m_samples)
    m_points.push_back(scaled_coordinates(m_triangles, sample));
  std::vector<bool> is_surrounded(m_samples.size(), false);
  for(const Index sample : m_sample_triangles.corner())
    is_surrounded[sample] = true;
  for(Index h = 0; h < m_sample_triangles.corner().size(); ++h)
    if(m_sample_triangles.twin()[h] == none)
      for(const Index end : {h, next_halfedge(h)})
        is_surrounded[m_sample_triangles.corner()[end]] = false;
  for(std::size_t i = 0; i < m_samples.size(); ++i)
    m_is_fixed[i] = m_is_fixed[i] || !is_surrounded[i];
  flip();
}

void Smoothing::step()
{
  compute_cells();
  for(Index i = 0; i < m_samples.size(); ++i)
  {
    const Cell& cell = m_cells[i];
    if(m_is_fixed[i] || !(cell.mass > 0.) || norm(cell.normal) < min_flatness * cell.area)
      continue;
    const Vec3 normal = unit(cell.normal), offset = (1. / cell.mass) * cell.moment - m_points[i];
    const Surface_location moved = locate_by_walking(
        m_triangles, triangle_at(m_triangles, m_samples[i]),
        m_points[i] + overrelaxation * (offset - dot(offset, normal) * normal),
        [](Index) { return true; }, [&](Index h) { return m_is_feature[h]; });
    if(moved.triangle == none)
      continue;
    m_samples[i] = canonical(m_triangles, moved);
    m_points[i] = scaled_coordinates(m_triangles, m_samples[i]);
  }
  flip();
}

// Returns the mass density at a sample, the fourth power of the slowness as in triangle_masses().
double Smoothing::density(Index sample) const
{
  const Index triangle = triangle_at(m_triangles, m_samples[sample]);
  if(!m_slowness || triangle == none)
    return 1.;
  const double square = (*m_slowness)[triangle] * (*m_slowness)[triangle];
  return square * square;
}

void Smoothing::compute_cells()
{
  m_cells.assign(m_samples.size(), Cell());
  const std::vector<Index>& corner = m_sample_triangles.corner();
  for(std::size_t c = 0; c < corner.size(); c += 3)
  {
    const std::array<Index, 3> samples = {corner[c], corner[c + 1], corner[c + 2]};
    distribute(samples, m_slowness
                            ? (density(samples[0]) + density(samples[1]) + density(samples[2])) / 3.
                            : 1.);
  }
}

// Splits a triangle into the Voronoi regions of its corners, and adds mass and moment of each
// region to the cell of its sample.
void Smoothing::distribute(const std::array<Index, 3>& samples, double density)
{
  const std::array<Vec3, 3> p = {m_points[samples[0]], m_points[samples[1]], m_points[samples[2]]};
  const std::array<Vec3, 3> edge = {p[1] - p[0], p[2] - p[1], p[0] - p[2]};
  const Vec3 normal = cross(edge[0], edge[1]);
  const double area = norm(normal), mass = density * area;
  if(!(area > 0.))
    return;
  // Squared length of each edge, and dot product of the two edges at each corner.
  std::array<double, 3> squared_length, dot_product;
  for(int k = 0; k < 3; ++k)
  {
    Cell& cell = m_cells[samples[k]];
    cell.area += area;
    cell.normal = cell.normal + normal;
    squared_length[k] = dot(edge[k], edge[k]);
    dot_product[k] = -dot(edge[k], edge[(k + 2) % 3]);
  }
  const auto add = [&](int k, double fraction, const Vec3& corners)
  {
    Cell& cell = m_cells[samples[k]];
    cell.mass += fraction * mass;
    cell.moment = cell.moment + (fraction * mass / 3.) * corners;
  };
  const auto obtuse =
      std::find_if(dot_product.begin(), dot_product.end(), [](double x) { return x <= 0.; });
  if(obtuse == dot_product.end())
    split_acute(p, squared_length, dot_product, add);
  else
    split_obtuse(p, squared_length, dot_product, int(obtuse - dot_product.begin()), add);
}

// Tests each edge once, and flips it if it violates the Delaunay condition. Flips may invalidate
// other
// edges; these are left for the next step.
void Smoothing::flip()
{
  Flippable_triangles& t = m_sample_triangles;
  for(Index h = 0; h < t.corner().size(); ++h)
  {
    const Index twin = t.twin()[h];
    if(twin == none || twin < h)
      continue;
    const Index x = t.corner()[h], y = t.corner()[twin], z = t.corner()[previous_halfedge(h)],
                w = t.corner()[previous_halfedge(twin)];
    if((m_is_fixed[x] && m_is_fixed[y]) || z == w)
      continue;
    const Vec3 xz = m_points[x] - m_points[z], yz = m_points[y] - m_points[z],
               xw = m_points[x] - m_points[w], yw = m_points[y] - m_points[w];
    const double at_z = dot(xz, yz), at_w = dot(xw, yw);
    if(at_z >= 0. && at_w >= 0.)
      continue;
    // The two opposite angles sum to more than 180 degrees.
    if(at_z * norm(cross(xw, yw)) + at_w * norm(cross(xz, yz)) < 0. &&
       !t.is_adjacent(previous_halfedge(h), w))
      t.flip(h);
  }
}

} // namespace CGAL::Geodesic_processing::internal
