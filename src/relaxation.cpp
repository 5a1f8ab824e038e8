// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/relaxation.h>

#include <CGAL/Geodesic_processing/internal/centroids.h>
#include <CGAL/Geodesic_processing/internal/path_locations.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// What is gone of the way to the centroid, and of the last step besides.  After ten steps of 5,000
// samples of scans the mean of the least angles is 51.5 degrees, 50.4 with 1.5 and no momentum; from
// 1.5 to 2 and from 0.5 to 0.8 it differs by half a degree at most.
constexpr double way_to_centroid = 1.8;
constexpr double momentum = 0.7;

// Samples that start one front together, neighbours: what they reach stays in a cache, where a front of
// all of them is everywhere at the same time.
constexpr std::size_t samples_of_a_front = 64;

} // namespace

Relaxation::Relaxation(std::shared_ptr<const Glued_triangles> triangles, Front& front,
                       std::shared_ptr<const std::vector<double>> slowness,
                       std::vector<Location> samples, std::vector<bool> is_fixed)
    : m_triangles(std::move(triangles)), m_front(front), m_samples(std::move(samples)),
      m_is_fixed(std::move(is_fixed)), m_moves(m_samples.size(), Spatial{0., 0., 0.}),
      m_distances(m_triangles->number_of_sites(), infinity),
      m_labels(m_triangles->number_of_sites(), none)
{
  m_limits.slowness = std::move(slowness);
  std::vector<Source> sources;
  for(const Location& sample : m_samples)
    sources.push_back({{sample}, 0., 0});
  m_front.run(sources, m_limits);
  for(const Index site : m_front.reached())
  {
    m_distances[site] = m_front.distance(site);
    m_labels[site] = m_front.source(site);
  }
}

void Relaxation::step(bool is_last)
{
  const Glued_triangles& t = *m_triangles;
  for(Spatial& move : m_moves)
    move = (is_last ? 0. : momentum) * move;
  const std::vector<Location> moved = centroids(t, m_labels, m_samples, m_limits.slowness.get(),
                                                is_last ? 1. : way_to_centroid, m_moves);
  for(std::size_t i = 0; i < m_samples.size(); ++i)
    if(!m_is_fixed[i])
    {
      m_moves[i] = scaled_coordinates(t, moved[i]) - scaled_coordinates(t, m_samples[i]);
      m_samples[i] = moved[i];
    }
  if(!is_last)
    update_cells();
}

// A sample that moves takes the sites of its cell no farther away than by its move: from there fronts
// go on only where they are nearer.
void Relaxation::update_cells()
{
  const Glued_triangles& t = *m_triangles;
  // A chord is shorter than the way along the surface, but not by half.
  std::vector<double> late(m_samples.size(), 0.);
  for(std::size_t i = 0; i < late.size(); ++i)
    if(const double move = norm(m_moves[i]); move > 0.)
      late[i] =
          2. * move * (m_limits.slowness ? (*m_limits.slowness)[triangle_at(t, m_samples[i])] : 1.);
  for(Index site = 0; site < m_labels.size(); ++site)
    if(m_labels[site] != none)
      m_distances[site] += late[m_labels[site]];

  // Triangles that are neighbours have near numbers.
  std::vector<std::pair<Index, Index>> order;
  for(Index i = 0; i < m_samples.size(); ++i)
    order.emplace_back(triangle_at(t, m_samples[i]), i);
  std::sort(order.begin(), order.end());
  m_limits.known = &m_distances;
  std::vector<Source> sources;
  for(std::size_t begin = 0; begin < order.size(); begin += samples_of_a_front)
  {
    const std::size_t end = std::min(order.size(), begin + samples_of_a_front);
    sources.clear();
    for(std::size_t i = begin; i < end; ++i)
      sources.push_back({{m_samples[order[i].second]}, 0., 0});
    m_front.run(sources, m_limits);
    for(const Index site : m_front.reached())
      if(const double distance = m_front.distance(site); distance < m_distances[site])
      {
        m_distances[site] = distance;
        m_labels[site] = order[begin + m_front.source(site)].second;
      }
  }
}

} // namespace CGAL::Geodesic_processing::internal
