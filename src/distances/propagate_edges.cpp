// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_updates.h"

#include "core/edges.h"
#include "distances/front_relaxation.h"

namespace CGAL::Geodesic_processing::internal {

void propagate_along_edges(Front_state& front, Index v)
{
  const double distance = front.vertices[v].distance;
  const Index source = front.sources[v];
  const Surface_arrays& t = *front.triangles;
  const auto relax_edge = [&](Index target, double gain)
  {
    if(distance + gain < front.vertices[target].distance)
      relax(front, target, {distance + gain, {1., 0.}, v, 0, 0.}, source);
  };
  if(t.is_cloud() && !front.slowness)
  {
    // The vertices that are closer are final: the lengths of their edges need not be computed.
    for(Index i = t.graph.begin[v]; i < t.graph.begin[v + 1]; ++i)
      if(distance < front.vertices[t.graph.target[i]].distance)
        relax_edge(t.graph.target[i], graph_edge_length(t, v, i));
  }
  else if(front.kind == Front_kind::dijkstra)
    for_each_edge(t, front.slowness.get(), v, relax_edge);
  else
    for_each_graph_edge(t, front.slowness.get(), v, relax_edge);
}

} // namespace CGAL::Geodesic_processing::internal
