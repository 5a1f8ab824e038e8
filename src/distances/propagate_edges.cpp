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
  const auto relax_edge = [&](Index target, double gain)
  {
    if(distance + gain < front.vertices[target].distance)
      relax(front, target, {distance + gain, {1., 0.}, v, 0, 0.}, source);
  };
  if(front.kind == Front_kind::dijkstra)
    for_each_edge(*front.triangles, front.slowness.get(), v, relax_edge);
  else
    for_each_graph_edge(*front.triangles, front.slowness.get(), v, relax_edge);
}

} // namespace CGAL::Geodesic_processing::internal
