// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_vicinity.h>

#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The 95th percentile of 60 numbers is exceeded or met by three.
constexpr std::size_t around = 60, exceeding = 3;
// What is drawn near by as much stays so when coordinates are rounded.
constexpr double within = 1. - 1e-6;

// The three largest of some numbers, largest first; fewer numbers than three count as the least.
class Largest
{
public:
  void add(double value)
  {
    for(double& place : m_values)
      if(value > place)
        std::swap(value, place);
    ++m_number;
  }
  bool is_full() const { return m_number >= exceeding; }
  double third() const { return m_values[std::min(m_number, exceeding) - 1]; }

private:
  std::array<double, exceeding> m_values = {-1., -1., -1.};
  std::size_t m_number = 0;
};

} // namespace

Surfel_vicinity::Surfel_vicinity(const Surfel_cloud& cloud, unsigned threads)
    : m_cloud(cloud), m_reach(cloud.number_of_sites()), m_sure(cloud.number_of_sites())
{
  const Site_graph& graph = cloud.graph;
  for_each_block(m_reach.size(), surfel_block, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(std::size_t site = begin; site < end; ++site)
                   {
                     Largest largest;
                     largest.add(cloud.spacing[site]);
                     double sure = 0.;
                     for(Index arc = graph.first[site]; arc < graph.first[site + 1]; ++arc)
                     {
                       const Index other = graph.target[arc];
                       const double length = norm(cloud.point[other] - cloud.point[site]);
                       // Surfels beyond have not been counted.
                       if(!(length <= cloud.seen[site]))
                         continue;
                       largest.add(cloud.spacing[other]);
                       // From a point at a distance d of the site, no surfel up to here is farther than
                       // d + length, within which no surfel is farther than 2 d + length from the
                       // site: they are all among those seen, of which there are fewer than 60.
                       if(largest.is_full())
                         sure = std::max(
                             sure, std::min(largest.third(), 0.5 * (cloud.seen[site] - length)));
                     }
                     m_reach[site] = within * largest.third();
                     m_sure[site] = sure;
                   }
                 });
}

bool Surfel_vicinity::is_near(const Spatial& point, Index site) const
{
  if(norm(point - m_cloud.point[site]) <= m_sure[site])
    return true;
  thread_local std::vector<Kd_tree::Neighbor> near;
  m_cloud.tree.nearest(m_cloud.point, point, around, near);
  Largest largest;
  for(const Kd_tree::Neighbor& neighbor : near)
    largest.add(m_cloud.spacing[neighbor.point]);
  return std::sqrt(near.front().squared_distance) <= largest.third();
}

Spatial Surfel_vicinity::drawn_near(const Spatial& point, Index site) const
{
  if(is_near(point, site))
    return point;
  site = m_cloud.tree.nearest(m_cloud.point, point);
  const Spatial way = point - m_cloud.point[site];
  // The surfel itself is near; each step comes a twentieth nearer to it.
  double share = std::min(1., m_reach[site] / norm(way));
  for(int i = 0; i < 60; ++i, share *= 0.95)
  {
    const Spatial nearer = m_cloud.point[site] + share * way;
    if(is_near(nearer, site))
      return nearer;
  }
  return m_cloud.point[site];
}

} // namespace CGAL::Geodesic_processing::internal
