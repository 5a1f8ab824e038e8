// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_coverage.h>

#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The 95th percentile of 60 numbers is exceeded or met by three.
constexpr std::size_t number_of_neighbors = 60, number_above_percentile = 3;
// What is drawn near by as much stays so when coordinates are rounded.
constexpr double clamping_ratio = 1. - 1e-6;

// The three largest of some numbers, largest first; fewer numbers than three count as the least.
class Largest_values
{
public:
  void add(double value)
  {
    for(double& slot : m_values)
      if(value > slot)
        std::swap(value, slot);
    ++m_count;
  }
  bool is_full() const { return m_count >= number_above_percentile; }
  double third() const { return m_values[std::min(m_count, number_above_percentile) - 1]; }

private:
  std::array<double, number_above_percentile> m_values = {-1., -1., -1.};
  std::size_t m_count = 0;
};

} // namespace

Surfel_coverage::Surfel_coverage(const Surfel_cloud& cloud, unsigned threads)
    : m_cloud(cloud), m_radius(cloud.number_of_vertices()),
      m_certain_radius(cloud.number_of_vertices())
{
  const Proximity_graph& graph = cloud.graph;
  for_each_block(
      m_radius.size(), surfel_block_size, threads,
      [&](std::size_t, std::size_t begin, std::size_t end)
      {
        for(std::size_t vertex = begin; vertex < end; ++vertex)
        {
          Largest_values largest;
          largest.add(cloud.spacing[vertex]);
          double certain_radius = 0.;
          for(Index e = graph.begin[vertex]; e < graph.begin[vertex + 1]; ++e)
          {
            const Index other = graph.target[e];
            const double length = norm(cloud.point[other] - cloud.point[vertex]);
            // Surfels beyond have not been counted.
            if(!(length <= cloud.search_radius[vertex]))
              continue;
            largest.add(cloud.spacing[other]);
            // From a point at a distance d of the site, no surfel up to here is farther than
            // d + length, within which no surfel is farther than 2 d + length from the
            // site: they are all among those seen, of which there are fewer than 60.
            if(largest.is_full())
              certain_radius =
                  std::max(certain_radius,
                           std::min(largest.third(), 0.5 * (cloud.search_radius[vertex] - length)));
          }
          m_radius[vertex] = clamping_ratio * largest.third();
          m_certain_radius[vertex] = certain_radius;
        }
      });
}

bool Surfel_coverage::is_covered(const Vec3& point, Index vertex) const
{
  if(norm(point - m_cloud.point[vertex]) <= m_certain_radius[vertex])
    return true;
  thread_local std::vector<Kd_tree::Neighbor> neighbors;
  m_cloud.tree.nearest(m_cloud.point, point, number_of_neighbors, neighbors);
  Largest_values largest;
  for(const Kd_tree::Neighbor& neighbor : neighbors)
    largest.add(m_cloud.spacing[neighbor.point]);
  return std::sqrt(neighbors.front().squared_distance) <= largest.third();
}

Vec3 Surfel_coverage::clamped_to_coverage(const Vec3& point, Index vertex) const
{
  if(is_covered(point, vertex))
    return point;
  vertex = m_cloud.tree.nearest(m_cloud.point, point);
  const Vec3 offset = point - m_cloud.point[vertex];
  // The surfel itself is near; each step comes a twentieth nearer to it.
  double fraction = std::min(1., m_radius[vertex] / norm(offset));
  for(int i = 0; i < 60; ++i, fraction *= 0.95)
  {
    const Vec3 candidate = m_cloud.point[vertex] + fraction * offset;
    if(is_covered(candidate, vertex))
      return candidate;
  }
  return m_cloud.point[vertex];
}

} // namespace CGAL::Geodesic_processing::internal
