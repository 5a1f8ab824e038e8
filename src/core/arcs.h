// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ARCS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ARCS_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Calls reach(target, length) for each arc of the graph that leaves a site, on a cloud; slowness: as in
// Front_limits, or null.  A speed belongs to triangles: of arcs that are no sides of one, those from a
// surfel to its copies need none.
template <typename Reach>
void for_each_arc_of_graph(const Glued_triangles& t, const std::vector<double>* slowness,
                           Index site, const Reach& reach)
{
  if(t.is_cloud())
    for(Index i = t.graph.first[site]; i < t.graph.first[site + 1]; ++i)
      if(!slowness || t.graph.length[i] == 0.)
        reach(t.graph.target[i], t.graph.length[i]);
}

// The same for all arcs that leave a site, most of them twice where they are sides of triangles.
template <typename Reach>
void for_each_arc(const Glued_triangles& t, const std::vector<double>* slowness, Index site,
                  const Reach& reach)
{
  for_each_arc_of_graph(t, slowness, site, reach);
  if(t.is_cloud() && !slowness)
    return;
  for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
  {
    const Index corner = t.star[i], previous = previous_side(corner);
    const double slow = slowness ? (*slowness)[corner / 3] : 1.;
    if(!(slow < infinity))
      continue;
    reach(t.corner[next_side(corner)], slow * t.length[corner]);
    reach(t.corner[previous], slow * t.length[previous]);
  }
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ARCS_H
