// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_map/base_refinement.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Marks the edges of the faces that contain the base point or have a corner within the radius.
std::vector<bool> edges_around(const std::shared_ptr<const Surface_arrays>& triangles,
                               const Surface_location& base, double radius)
{
  const Surface_arrays& t = *triangles;
  std::vector<Index> faces = triangles_at(t, base);
  Front front(triangles, Front_kind::euclidean);
  Front_limits limits;
  limits.maximum_distance = radius;
  front.run({Front_source{{base}}}, limits);
  for(const Index vertex : front.reached())
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
      faces.push_back(t.ring[i] / 3);
  std::vector<bool> is_split(t.corner.size(), false);
  for(const Index face : faces)
    for(Index h = 3 * face; h < 3 * face + 3; ++h)
      if(t.length[h] > 8. * min_edge_length)
      {
        is_split[h] = true;
        if(t.twin[h] != none)
          is_split[t.twin[h]] = true;
      }
  return is_split;
}

// Fills the two arrays of vertices from the corners of the refinement.
void find_vertices(Base_refinement& result)
{
  const Refinement& refinement = result.refinement;
  const Surface_arrays &fine = *refinement.triangles, &coarse = *refinement.coarse;
  result.coarse_vertex.assign(fine.number_of_vertices(), none);
  result.fine_vertex.assign(coarse.number_of_vertices(), none);
  for(Index c = 0; c < fine.corner.size(); ++c)
    for(Index k = 0; k < 3; ++k)
      if(refinement.parent.empty() ? c % 3 == k : refinement.corners[c / 3][c % 3][k] == 1.)
      {
        const Index parent = refinement.parent.empty() ? c / 3 : refinement.parent[c / 3];
        const Index vertex = coarse.corner[3 * parent + k];
        result.coarse_vertex[fine.corner[c]] = vertex;
        result.fine_vertex[vertex] = fine.corner[c];
      }
}

} // namespace

Base_refinement refine_around_base(std::shared_ptr<const Surface_arrays> triangles,
                                   const Surface_location& base, double radius, double margin,
                                   std::size_t number_of_levels)
{
  // make_refinement() would separate the fans of a nonmanifold vertex, through which fronts pass.
  Base_refinement result{{triangles, triangles, {}, {}}, {}, {}};
  for(std::size_t level = 0; level < number_of_levels; ++level)
  {
    const Surface_location fine_base = to_fine(result.refinement, {base}).front();
    const double distance = (radius + std::ldexp(margin, -int(level))) / result.unit_size();
    result.refinement = split_edges(result.refinement,
                                    edges_around(result.refinement.triangles, fine_base, distance));
  }
  find_vertices(result);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
