// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_coverage.h>

#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The third largest of 60 numbers is their 95th percentile.
constexpr std::size_t coverage_neighbors = 60, number_above_percentile = 3;
// Clamped points remain covered despite round-off errors.
constexpr double clamping_ratio = 1. - 1e-6;
// On random samples of a sphere, the first step suffices.
constexpr int max_clamping_steps = 20;

// The three largest numbers of a sequence.
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
  // Returns the third largest number, or the smallest one if there are fewer than three.
  double third() const { return m_values[std::min(m_count, number_above_percentile) - 1]; }

private:
  std::array<double, number_above_percentile> m_values = {-1., -1., -1.};
  std::size_t m_count = 0;
};

} // namespace

Surfel_coverage::Surfel_coverage(const Surfel_cloud& cloud, unsigned number_of_threads)
    : m_cloud(cloud), m_radius(cloud.number_of_vertices()),
      m_certain_radius(cloud.number_of_vertices()), m_wide_radius(cloud.number_of_vertices())
{
  const Proximity_graph& graph = cloud.graph;
  for_each_block(
      m_radius.size(), surfel_block_size, number_of_threads,
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
            // Beyond the search radius, there can be surfels that are not neighbors.
            if(!(length <= cloud.search_radius[vertex]))
              continue;
            largest.add(cloud.spacing[other]);
            // Let p be a point at the distance d of the vertex. The surfels counted so far are
            // within d + length of p. All surfels within d + length of p are within 2 d + length
            // of the vertex. If 2 d + length is at most the search radius, there are fewer than 60
            // of them. So the 60 nearest surfels of p include the counted ones, whose third
            // largest spacing is a lower bound of the percentile at p.
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

Surfel_coverage::Nearest_surfel Surfel_coverage::nearest_surfel(const Vec3& point) const
{
  thread_local std::vector<Kd_tree::Neighbor> neighbors;
  m_cloud.tree.nearest(m_cloud.point, point, coverage_neighbors, neighbors);
  Largest_values largest;
  for(const Kd_tree::Neighbor& neighbor : neighbors)
    largest.add(m_cloud.spacing[neighbor.point]);
  return {neighbors.front().point, std::sqrt(neighbors.front().squared_distance), largest.third()};
}

// Returns a distance up to which all points around a vertex are covered. Threads that compute it at
// the same time compute the same number.
double Surfel_coverage::wide_radius(Index vertex) const
{
  const double known = m_wide_radius[vertex].load(std::memory_order_relaxed);
  if(known > 0.)
    return known;
  thread_local std::vector<Kd_tree::Neighbor> neighbors;
  m_cloud.tree.nearest(m_cloud.point, m_cloud.point[vertex], coverage_neighbors, neighbors);
  const double last_distance = std::sqrt(neighbors.back().squared_distance);
  Largest_values largest;
  double result = m_certain_radius[vertex];
  for(const Kd_tree::Neighbor& neighbor : neighbors)
  {
    largest.add(m_cloud.spacing[neighbor.point]);
    // As for m_certain_radius. If there are fewer than 60 surfels, each point has the same ones.
    if(largest.is_full())
      result =
          std::max(result, std::min(largest.third(),
                                    0.5 * (last_distance - std::sqrt(neighbor.squared_distance))));
  }
  m_wide_radius[vertex].store(result, std::memory_order_relaxed);
  return result;
}

bool Surfel_coverage::is_covered(const Vec3& point, Index vertex) const
{
  const double distance = norm(point - m_cloud.point[vertex]);
  if(distance <= m_certain_radius[vertex] || distance <= wide_radius(vertex))
    return true;
  const Nearest_surfel nearest = nearest_surfel(point);
  return nearest.distance <= nearest.max_distance;
}

Vec3 Surfel_coverage::clamped_to_coverage(const Vec3& point, Index vertex) const
{
  if(is_covered(point, vertex))
    return point;
  Nearest_surfel nearest = nearest_surfel(point);
  const Vec3 center = m_cloud.point[nearest.vertex];
  Vec3 candidate = point;
  // The percentile is piecewise constant. In most cases, its value at the point is its value at the
  // first candidate. On the segment, the nearest surfel does not change.
  for(int i = 0; i < max_clamping_steps && nearest.distance > nearest.max_distance; ++i)
  {
    candidate =
        center + clamping_ratio * nearest.max_distance / nearest.distance * (candidate - center);
    nearest = nearest_surfel(candidate);
  }
  return nearest.distance <= nearest.max_distance ? candidate : center;
}

} // namespace CGAL::Geodesic_processing::internal
