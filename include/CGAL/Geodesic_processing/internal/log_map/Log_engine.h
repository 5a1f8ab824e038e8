// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_LOG_ENGINE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_LOG_ENGINE_H

#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/log_map/log_map.h>
#include <CGAL/Geodesic_processing/internal/log_map/tangent_plane.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Log_map_options
{
  double maximum_distance = infinity;
  double stencil_length = 0.; // 0: as the engine finds best
  std::size_t stencil_size = 8;
};

inline std::vector<Front_source> point_source(const Surface_location& at)
{
  return {Front_source{{at}}};
}

// Tangent vectors by the gradient of squared distances, whatever engine measures these.
template <typename Engine>
class Gradient_engine
{
public:
  explicit Gradient_engine(std::shared_ptr<const Surface_arrays> triangles)
      : m_triangles(triangles), m_engine(std::move(triangles))
  {}

  // Calls visit(site, tangent vector) for all sites up to the maximum distance.
  template <typename Visit>
  void run(const Tangent_plane& plane, const Log_map_options& options, Visit visit)
  {
    const Surface_arrays& t = *m_triangles;
    Front_limits limits;
    limits.maximum_distance = options.maximum_distance;
    m_engine.run(point_source(plane.location()), limits);
    const std::vector<Index> vertices = m_engine.reached();
    std::vector<double> distances;
    for(const Index v : vertices)
      distances.push_back(m_engine.distance(v));

    const double length = options.stencil_length > 0.
                              ? options.stencil_length
                              : stencil_length_ratio(plane) * mean_edge_length(t, plane.location());
    const Stencil stencil = make_stencil(plane, vertices, distances, length, options.stencil_size);
    const std::size_t size = stencil.locations.size();
    limits.maximum_distance += length;
    std::vector<double> stencil_distances(vertices.size() * size);
    for(std::size_t j = 0; j < size; ++j)
    {
      m_engine.run(point_source(stencil.locations[j]), limits);
      for(std::size_t i = 0; i < vertices.size(); ++i)
        stencil_distances[i * size + j] = m_engine.distance(vertices[i]);
    }
    const Log_map_fit fit(stencil.vectors);
    for(std::size_t i = 0; i < vertices.size(); ++i)
      visit(vertices[i], fit(distances[i], stencil_distances.data() + i * size));
  }

private:
  // In mean lengths of the sides around.  A longer stencil averages the errors of fronts, but sees bends;
  // what is best grows more slowly than the sides are short: as one over the root of their bend.  On a
  // sphere of 10,000 vertices tangent vectors are then off by 0.044 %, with 0.6 sides by 0.11 %; on the
  // armadillo of 26,000, a rough mesh, directions by 0.92 and 0.87 degrees in the median, and by 1.4
  // with twice the length.  On a cloud it must reach surfels in all directions.
  double stencil_length_ratio(const Tangent_plane& plane) const
  {
    if(m_triangles->is_cloud())
      return 2.5;
    return std::clamp(0.35 / std::sqrt(mean_normal_angle(*m_triangles, plane.location())), 0.6, 4.);
  }

  Stencil make_stencil(const Tangent_plane& plane, const std::vector<Index>& vertices,
                       const std::vector<double>& distances, double length, std::size_t size)
  {
    if(!m_triangles->is_cloud())
      return straightest_stencil(plane, length, size);
    m_distance.resize(m_triangles->number_of_vertices(), infinity);
    for(std::size_t i = 0; i < vertices.size(); ++i)
      m_distance[vertices[i]] = distances[i];
    return vertex_stencil(*m_triangles, plane, vertices, m_distance, length, size);
  }

  std::shared_ptr<const Surface_arrays> m_triangles;
  Engine m_engine;
  std::vector<double>
      m_distance; // #sites, on a cloud: of the last run, those of others before left
};

// Tangent vectors of shortest paths on a mesh.
class Exact_log_engine
{
public:
  explicit Exact_log_engine(std::shared_ptr<const Surface_arrays> triangles)
      : m_windows(std::move(triangles))
  {}

  template <typename Visit>
  void run(const Tangent_plane& plane, const Log_map_options& options, Visit visit)
  {
    Front_limits limits;
    limits.maximum_distance = options.maximum_distance;
    m_windows.run(point_source(plane.location()), limits);
    for(const Index v : m_windows.reached())
    {
      const double angle = plane.tangent_angle(m_windows.polar_angle_of_departure(v));
      visit(v, m_windows.distance(v) * Vec2{std::cos(angle), std::sin(angle)});
    }
  }

private:
  Window_propagation m_windows;
};

// Sums of steps along shortest chains of arcs.
class Discrete_exponential_engine
{
public:
  explicit Discrete_exponential_engine(std::shared_ptr<const Surface_arrays> triangles)
      : m_triangles(triangles), m_front(std::move(triangles), Front_kind::dijkstra),
        m_vectors(m_triangles->number_of_vertices())
  {}

  template <typename Visit>
  void run(const Tangent_plane& plane, const Log_map_options& options, Visit visit)
  {
    Front_limits limits;
    limits.maximum_distance = options.maximum_distance;
    m_front.run(point_source(plane.location()), limits);
    for(const Index v : m_front.reached())
      m_vectors[v] = {std::numeric_limits<double>::quiet_NaN(), 0.};
    for(const Index v : m_front.reached())
    {
      accumulate_steps(plane, v);
      visit(v, m_vectors[v]);
    }
  }

private:
  void accumulate_steps(const Tangent_plane& plane, Index v)
  {
    const Surface_arrays& t = *m_triangles;
    std::vector<Index> path; // back to the first one that is known
    for(; v != none && std::isnan(m_vectors[v][0]); v = m_front.predecessor(v))
      path.push_back(v);
    for(; !path.empty(); path.pop_back())
    {
      const Index next = path.back();
      m_vectors[next] = v == none
                            ? transported_step(plane, plane.normal(), t.point[next] - plane.point())
                            : m_vectors[v] + transported_step(plane, vertex_normal(t, v),
                                                              t.point[next] - t.point[v]);
      v = next;
    }
  }

  std::shared_ptr<const Surface_arrays> m_triangles;
  Front m_front;
  std::vector<Vec2> m_vectors; // #sites, of the last run
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_LOG_ENGINE_H
