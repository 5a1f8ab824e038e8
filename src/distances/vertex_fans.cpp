// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/vertex_fans.h>

#include "core/unfold.h"
#include "distances/split_half.h"

#include <cstddef>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Vertex_fans::Edge::Edge(const Fan_edge& edge, const Surface_arrays& t, const Obtuse_splits& s)
    : vertex(edge.vertex), length(edge.length), opening{1., 0.}, m_code(none)
{
  if(edge.corner == none)
    return;
  opening = corner_angle(t, edge.corner);
  m_code = 4 * (edge.corner / 3) + (s.is_split(next_halfedge(edge.corner)) ? 1 : 0) +
           (s.is_split(previous_halfedge(edge.corner)) ? 2 : 0);
}

Vertex_fans build_vertex_fans(const Surface_arrays& t, const Obtuse_splits& s)
{
  const std::size_t n = t.number_of_vertices();
  Vertex_fans result;
  result.begin.resize(n + 1);
  result.edges.reserve(t.ring.size() + n);
  result.splits.reserve(s.views.size());
  std::vector<Fan_edge> edges;
  for(Index vertex = 0; vertex < n; ++vertex)
  {
    edges.resize(2 * std::size_t(t.ring_begin[vertex + 1] - t.ring_begin[vertex]));
    const Fan_edge* const end = read_fan_edges(t, vertex, edges.data());
    for(const Fan_edge* edge = edges.data(); edge != end; ++edge)
      result.edges.emplace_back(*edge, t, s);
    if(!s.views.empty())
      for(Index i = s.begin[vertex]; i < s.begin[vertex + 1]; ++i)
        result.splits.push_back(split_half(s, vertex, s.views[i]));
    result.begin[vertex + 1] = {static_cast<Index>(result.edges.size()),
                                static_cast<Index>(result.splits.size())};
  }
  return result;
}

std::shared_ptr<const Vertex_fans> shared_vertex_fans(const Surface_arrays& t)
{
  const std::shared_ptr<const Obtuse_splits> splits = shared_obtuse_splits(t);
  const std::lock_guard<std::mutex> lock(t.shared.mutex);
  std::shared_ptr<const Vertex_fans> result = t.shared.vertex_fans.lock();
  if(!result)
    t.shared.vertex_fans = result =
        std::make_shared<const Vertex_fans>(build_vertex_fans(t, *splits));
  return result;
}

std::shared_ptr<const std::vector<Vec2>> shared_corner_angles(const Surface_arrays& t)
{
  const std::lock_guard<std::mutex> lock(t.shared.mutex);
  std::shared_ptr<const std::vector<Vec2>> result = t.shared.corner_angles.lock();
  if(!result)
  {
    std::vector<Vec2> angles(t.corner.size());
    for(Index corner = 0; corner < angles.size(); ++corner)
      angles[corner] = corner_angle(t, corner);
    t.shared.corner_angles = result = std::make_shared<const std::vector<Vec2>>(std::move(angles));
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
