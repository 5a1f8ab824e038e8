// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/relaxation.h"

#include "sampling/centroids.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Step length relative to the distance of the centroid, and fraction of the last step that is
// added. For 5,000 samples of scans, the mean of the minimum angles after ten steps is 51.5
// degrees. With 1.5 and no momentum it is 50.4 degrees. For 1.5 to 2 and 0.5 to 0.8 it varies by at
// most 0.5 degrees.
constexpr double overrelaxation = 1.8;
constexpr double momentum = 0.7;

// Minimum cosine of the angle between the normals of a vertex and of the sample of its cell.
// Without it, vertices on the opposite surface of a thin part would join the cell.
constexpr double min_normal_cosine = -0.5;

// Returns the normal of a triangle with twice its area as length.
Vec3 area_normal(const Surface_arrays& t, Index triangle)
{
  const Index* const corner = &t.corner[3 * std::size_t(triangle)];
  const Vec3& p = t.point[corner[0]];
  return cross(t.point[corner[1]] - p, t.point[corner[2]] - p);
}

} // namespace

Relaxation::Relaxation(std::shared_ptr<const Surface_arrays> triangles,
                       std::shared_ptr<const std::vector<double>> slowness,
                       std::vector<Surface_location> samples, std::vector<Index> labels,
                       std::vector<bool> is_fixed)
    : m_triangles(std::move(triangles)), m_slowness(std::move(slowness)),
      m_samples(std::move(samples)), m_labels(std::move(labels)), m_is_fixed(std::move(is_fixed)),
      m_displacements(m_samples.size(), Vec3{0., 0., 0.}),
      m_masses(triangle_masses(*m_triangles, m_slowness.get())),
      m_normals(m_triangles->number_of_vertices(), Vec3{0., 0., 0.})
{
  const Surface_arrays& t = *m_triangles;
  for(Index corner = 0; corner < t.corner.size(); ++corner)
    m_normals[t.corner[corner]] = m_normals[t.corner[corner]] + area_normal(t, corner / 3);
  for(Vec3& normal : m_normals)
    normal = unit(normal);
  const auto is_passable = [&](Index h)
  { return h != none && (!m_slowness || (*m_slowness)[h / 3] < infinity); };
  for(Index h = 0; h < t.corner.size(); ++h)
    if(const Index twin = t.twin[h]; h < twin && (is_passable(h) || is_passable(twin)))
      m_growth_edges.push_back({t.corner[h], t.corner[next_halfedge(h)]});
}

void Relaxation::step(bool is_last)
{
  const Surface_arrays& t = *m_triangles;
  for(Vec3& displacement : m_displacements)
    displacement = (is_last ? 0. : momentum) * displacement;
  const std::vector<Surface_location> moved =
      centroids(t, m_masses, m_labels, m_samples, m_slowness.get(),
                {is_last ? 1. : overrelaxation, &m_displacements});
  for(std::size_t i = 0; i < m_samples.size(); ++i)
    if(!m_is_fixed[i])
    {
      m_displacements[i] = scaled_coordinates(t, moved[i]) - scaled_coordinates(t, m_samples[i]);
      m_samples[i] = moved[i];
    }
  if(!is_last)
    update_cells();
}

// Assigns vertices to adjacent cells with a closer sample. Labels propagate along edges in two
// sweeps, as in a distance transform.
void Relaxation::update_cells()
{
  const Surface_arrays& t = *m_triangles;
  struct Center
  {
    Vec3 point, normal;
  };
  std::vector<Center> centers;
  for(const Surface_location& sample : m_samples)
  {
    const Index triangle = triangle_at(t, sample);
    centers.push_back({scaled_coordinates(t, sample),
                       triangle == none ? Vec3{0., 0., 0.} : unit(area_normal(t, triangle))});
  }
  const auto squared_distance = [&](Index vertex, Index label)
  {
    const Vec3 offset = t.point[vertex] - centers[label].point;
    return dot(offset, offset);
  };
  std::vector<double> squared_distances(m_labels.size(), infinity);
  for(Index vertex = 0; vertex < m_labels.size(); ++vertex)
    if(m_labels[vertex] != none)
      squared_distances[vertex] = squared_distance(vertex, m_labels[vertex]);

  const auto try_label = [&](Index vertex, Index label)
  {
    if(label == none || label == m_labels[vertex])
      return;
    const double candidate = squared_distance(vertex, label);
    if(candidate < squared_distances[vertex] &&
       dot(m_normals[vertex], centers[label].normal) > min_normal_cosine)
    {
      squared_distances[vertex] = candidate;
      m_labels[vertex] = label;
    }
  };
  // A cell that has lost all its vertices regains those of the triangle that contains its sample.
  for(Index i = 0; i < m_samples.size(); ++i)
    if(const Index triangle = triangle_at(t, m_samples[i]); triangle != none)
      for(Index k = 0; k < 3; ++k)
        try_label(t.corner[3 * triangle + k], i);
  const auto update_edge = [&](const std::array<Index, 2>& ends)
  {
    const Index a = m_labels[ends[0]], b = m_labels[ends[1]];
    if(a == b)
      return;
    try_label(ends[0], b);
    try_label(ends[1], a);
  };
  // The second sweep in reverse order propagates labels in the opposite direction.
  std::for_each(m_growth_edges.begin(), m_growth_edges.end(), update_edge);
  std::for_each(m_growth_edges.rbegin(), m_growth_edges.rend(), update_edge);
}

} // namespace CGAL::Geodesic_processing::internal
