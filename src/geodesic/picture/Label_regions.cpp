// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/Label_regions.h"

#include "readers/vectors.h"

#include <algorithm>

namespace program {

Label_regions::Label_regions(const std::vector<Point>& points,
                             const std::vector<std::uint32_t>& corners,
                             const std::vector<long long>& labels)
    : m_number_of_points(points.size())
{
  m_mesh.points = points;
  for(std::size_t i = 0; i + 2 < corners.size(); i += 3)
    split_triangle({corners[i], corners[i + 1], corners[i + 2]}, labels);
  smooth_boundaries();
}

std::vector<std::vector<Point>> Label_regions::boundaries() const
{
  std::vector<std::vector<Point>> result;
  for(const auto& [p, q] : m_boundaries)
    result.push_back({m_mesh.points[p], m_mesh.points[q]});
  return result;
}

void Label_regions::split_triangle(Triangle c, const std::vector<long long>& labels)
{
  const auto label = [&](std::size_t k) { return labels[c[k]]; };
  if(label(0) == label(1) && label(1) == label(2))
    return add({c[0], c[1], c[2]}, label(0));
  if(label(0) != label(1) && label(1) != label(2) && label(2) != label(0))
  {
    const Triangle p = {edge_point(c[0], c[1]), edge_point(c[1], c[2]), edge_point(c[2], c[0])};
    const auto center = static_cast<std::uint32_t>(m_mesh.points.size());
    m_mesh.points.push_back({0., 0., 0.});
    m_point_edges.push_back({c[0], c[0]});
    for(std::size_t k = 0; k < 3; ++k)
    {
      add({c[k], p[k], center}, label(k));
      add({c[k], center, p[(k + 2) % 3]}, label(k));
      m_boundaries.emplace_back(p[k], center);
    }
    m_centers.push_back(center);
    update_center(center, p);
    m_center_corners.push_back(p);
    return;
  }
  // One corner differs from the other two; rotate it to the front.
  while(label(1) != label(2))
    std::rotate(c.begin(), c.begin() + 1, c.end());
  const std::uint32_t p = edge_point(c[0], c[1]), q = edge_point(c[2], c[0]);
  add({c[0], p, q}, label(0));
  add({p, c[1], c[2]}, label(1));
  add({p, c[2], q}, label(1));
  m_boundaries.emplace_back(p, q);
}

void Label_regions::add(const Triangle& corners, long long label)
{
  m_mesh.corners.insert(m_mesh.corners.end(), corners.begin(), corners.end());
  m_mesh.colors.push_back(color_of_label(label));
}

std::uint32_t Label_regions::edge_point(std::uint32_t a, std::uint32_t b)
{
  const auto [low, high] = std::minmax(a, b);
  const auto [entry, is_new] =
      m_edge_points.try_emplace({low, high}, static_cast<std::uint32_t>(m_mesh.points.size()));
  if(is_new)
  {
    const Point midpoint = 0.5 * (m_mesh.points[low] + m_mesh.points[high]);
    m_mesh.points.push_back(midpoint);
    m_point_edges.push_back({low, high});
  }
  return entry->second;
}

void Label_regions::update_center(std::uint32_t middle, const Triangle& p)
{
  m_mesh.points[middle] =
      (1. / 3.) * (m_mesh.points[p[0]] + m_mesh.points[p[1]] + m_mesh.points[p[2]]);
}

// Boundaries through edge midpoints are jagged. Each cut point is therefore moved along its
// edge, to the projection of the average of its neighbors on the boundary.
void Label_regions::smooth_boundaries()
{
  const std::size_t number_of_cuts = m_point_edges.size();
  std::vector<Point> sum(number_of_cuts);
  std::vector<double> count(number_of_cuts);
  for(int iteration = 0; iteration < 30; ++iteration)
  {
    std::fill(sum.begin(), sum.end(), Point{0., 0., 0.});
    std::fill(count.begin(), count.end(), 0.);
    for(const auto& [p, q] : m_boundaries)
    {
      sum[p - m_number_of_points] = sum[p - m_number_of_points] + m_mesh.points[q];
      sum[q - m_number_of_points] = sum[q - m_number_of_points] + m_mesh.points[p];
      count[p - m_number_of_points] += 1.;
      count[q - m_number_of_points] += 1.;
    }
    for(std::size_t i = 0; i < number_of_cuts; ++i)
    {
      const Point &a = m_mesh.points[m_point_edges[i][0]], &b = m_mesh.points[m_point_edges[i][1]];
      const Point edge = b - a, offset = (1. / std::max(count[i], 1.)) * sum[i] - a;
      const double squared_length = edge[0] * edge[0] + edge[1] * edge[1] + edge[2] * edge[2];
      // Boundary endpoints are fixed, and centers follow the cut points around them.
      if(count[i] < 2. || squared_length == 0.)
        continue;
      const double t =
          (offset[0] * edge[0] + offset[1] * edge[1] + offset[2] * edge[2]) / squared_length;
      m_mesh.points[m_number_of_points + i] = a + std::clamp(t, 0.03, 0.97) * edge;
    }
    for(std::size_t i = 0; i < m_centers.size(); ++i)
      update_center(m_centers[i], m_center_corners[i]);
  }
}

} // namespace program
