// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/Refined_surface.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/mesh/feature_polylines.h>

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Refined_surface::Refined_surface(const std::shared_ptr<const Surface_arrays>& triangles,
                                 const Remeshing_options& options)
    : m_coarse_slowness(options.slowness),
      m_is_coarse_feature(options.is_feature.empty() ? boundary_and_sharp_halfedges(*triangles)
                                                     : options.is_feature),
      m_has_features(std::find(m_is_coarse_feature.begin(), m_is_coarse_feature.end(), true) !=
                     m_is_coarse_feature.end())
{
  set_refinement(make_refinement(triangles));
}

bool Refined_surface::is_on_feature(const Surface_location& location) const
{
  const Surface_location clean = canonical(triangles(), location);
  if(const Index vertex = vertex_of(triangles(), clean); vertex != none)
    return m_is_feature_vertex[vertex];
  const Index h = halfedge_of(clean);
  return h != none && m_is_feature[h];
}

void Refined_surface::split(const std::vector<bool>& is_split)
{
  set_refinement(split_edges(m_refinement, is_split));
}

void Refined_surface::split_duplicate_faces()
{
  std::vector<bool> is_split(triangles().corner.size(), false);
  bool has_duplicates = false;
  for_each_vertex_of_two_faces(
      [&](Index h, Index other)
      {
        has_duplicates = true;
        for(Index k = 0; k < 3; ++k)
          for(const Index marked : {3 * (h / 3) + k, 3 * (other / 3) + k})
            mark_edge(triangles(), marked, is_split);
      });
  if(!has_duplicates)
    return;
  split(is_split);
  // Each of these vertices still has two faces, now smaller ones. No face has two such vertices.
  // The edge opposite to the vertex is split in both faces, so that it has four faces.
  is_split.assign(triangles().corner.size(), false);
  for_each_vertex_of_two_faces(
      [&](Index h, Index other)
      {
        mark_edge(triangles(), previous_halfedge(h), is_split);
        mark_edge(triangles(), next_halfedge(other), is_split);
      });
  split(is_split);
}

template <typename Visitor>
void Refined_surface::for_each_vertex_of_two_faces(const Visitor& visit) const
{
  const Surface_arrays& t = triangles();
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    const Index other = t.twin[h], next = t.twin[next_halfedge(h)];
    if(other != none && next != none && other / 3 == next / 3 && other / 3 != h / 3)
      visit(h, other);
  }
}

void Refined_surface::set_refinement(Refinement refinement)
{
  m_refinement = std::move(refinement);
  // If all vertices coincide, all distances are zero and no vertex is farthest. Unit lengths make
  // the distances positive.
  const std::vector<double>& length = triangles().length;
  if(std::all_of(length.begin(), length.end(), [](double l) { return l == 0.; }))
  {
    Surface_arrays uniform = triangles();
    std::fill(uniform.length.begin(), uniform.length.end(), 1.);
    m_refinement.triangles = std::make_shared<const Surface_arrays>(std::move(uniform));
  }
  m_is_feature.assign(triangles().corner.size(), false);
  m_is_feature_vertex.assign(triangles().number_of_vertices(), false);
  if(m_has_features)
    mark_features();
  m_slowness = m_coarse_slowness;
  if(m_slowness && !m_refinement.parent.empty())
  {
    std::vector<double> slownesses;
    for(const Index parent : m_refinement.parent)
      slownesses.push_back((*m_coarse_slowness)[parent]);
    m_slowness = std::make_shared<const std::vector<double>>(std::move(slownesses));
  }
}

void Refined_surface::mark_features()
{
  const std::vector<Index> coarse = coarse_halfedges(m_refinement);
  for(Index h = 0; h < coarse.size(); ++h)
    if(coarse[h] != none && m_is_coarse_feature[coarse[h]])
    {
      m_is_feature[h] = true;
      for(const Index corner : {h, next_halfedge(h)})
        m_is_feature_vertex[triangles().corner[corner]] = true;
    }
}

} // namespace CGAL::Geodesic_processing::internal
