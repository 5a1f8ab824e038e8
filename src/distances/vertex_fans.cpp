// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/vertex_fans.h>

#include <cstddef>

namespace CGAL::Geodesic_processing::internal {

Vertex_fans build_vertex_fans(const Surface_arrays& t)
{
  const std::size_t n = t.number_of_vertices();
  Vertex_fans result;
  result.begin.resize(n + 1);
  result.edges.reserve(t.ring.size() + n);
  std::vector<Fan_edge> edges;
  for(Index vertex = 0; vertex < n; ++vertex)
  {
    result.begin[vertex] = static_cast<Index>(result.edges.size());
    edges.resize(2 * std::size_t(t.ring_begin[vertex + 1] - t.ring_begin[vertex]));
    const Fan_edge* const end = read_fan_edges(t, vertex, edges.data());
    result.edges.insert(result.edges.end(), static_cast<const Fan_edge*>(edges.data()), end);
  }
  result.begin[n] = static_cast<Index>(result.edges.size());
  return result;
}

std::shared_ptr<const Vertex_fans> shared_vertex_fans(const Surface_arrays& t)
{
  const std::lock_guard<std::mutex> lock(t.shared.mutex);
  std::shared_ptr<const Vertex_fans> result = t.shared.vertex_fans.lock();
  if(!result)
    t.shared.vertex_fans = result = std::make_shared<const Vertex_fans>(build_vertex_fans(t));
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
