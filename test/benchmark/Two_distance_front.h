// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BENCHMARK_TWO_DISTANCE_FRONT_H
#define CGAL_GEODESIC_PROCESSING_BENCHMARK_TWO_DISTANCE_FRONT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "distances/circular_front.h"

#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace benchmarks {

// Computes distances from the circle through two distances only, for comparison (Reimers 2004). The
// source is unfolded into the plane of a triangle, at the known distances from two of its corners.
// The distance of the third corner is that of the unfolded source, if the straight line to it
// crosses the edge of both corners. Otherwise it is the distance along an edge.
//
// Vertices are visited in the order of their distances, and again if their distance decreases. The
// number of visits is not bounded.
class Two_distance_front
{
  using Index = CGAL::Geodesic_processing::internal::Index;

public:
  // Keeps a reference to the arrays of a mesh.
  explicit Two_distance_front(const CGAL::Geodesic_processing::internal::Surface_arrays& arrays)
      : m_arrays(arrays)
  {}

  void compute(Index source)
  {
    using namespace CGAL::Geodesic_processing::internal;
    m_distance.assign(m_arrays.number_of_vertices(), infinity);
    relax(source, 0.);
    while(!m_queue.empty())
    {
      const auto [distance, vertex] = m_queue.top();
      m_queue.pop();
      if(distance > m_distance[vertex])
        continue;
      for(Index i = m_arrays.ring_begin[vertex]; i < m_arrays.ring_begin[vertex + 1]; ++i)
      {
        const Index right = m_arrays.ring[i], left = previous_halfedge(right);
        relax(m_arrays.corner[next_halfedge(right)], distance + m_arrays.length[right]);
        relax(m_arrays.corner[left], distance + m_arrays.length[left]);
        cross(right);
        cross(left);
      }
    }
  }

  // Returns the distance of a vertex in the scale of the arrays; infinite if it is not reached.
  double distance(Index vertex) const { return m_distance[vertex]; }

private:
  // Relaxes the corner opposite to a halfedge by the circle through the distances at its ends.
  void cross(Index h)
  {
    using namespace CGAL::Geodesic_processing::internal;
    const double origin = m_distance[m_arrays.corner[h]],
                 end = m_distance[m_arrays.corner[next_halfedge(h)]];
    if(!(origin > 0. && origin < infinity && end < infinity))
      return;
    Circular_front circle{{0., -1.}, 1. / origin};
    double gain = 0.;
    Vec2 back;
    if(fit_source_direction(m_arrays.length[h], end - origin, circle) &&
       cross_edge(circle, m_arrays.length[h], apex(m_arrays, h), gain, back))
      relax(m_arrays.corner[previous_halfedge(h)], origin + gain);
  }

  void relax(Index vertex, double distance)
  {
    // Smaller improvements are round-off errors.
    constexpr double tolerance = 1e-12;
    if(!(distance < (1. - tolerance) * m_distance[vertex]))
      return;
    m_distance[vertex] = distance;
    m_queue.emplace(distance, vertex);
  }

  using Entry = std::pair<double, Index>;

  const CGAL::Geodesic_processing::internal::Surface_arrays& m_arrays;
  std::vector<double> m_distance; // #vertices
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

} // namespace benchmarks

#endif // CGAL_GEODESIC_PROCESSING_BENCHMARK_TWO_DISTANCE_FRONT_H
