// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_FARTHEST_VERTICES_H
#define GEODESIC_PROGRAM_FARTHEST_VERTICES_H

#include "queries.h"

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace program {

// Vertices that lie in a triangle, or surfels.  Each is as far as can be from those before it; where
// some part is not reached, in that.  Fewer than asked for when no vertex is left at a distance.
template <typename Solver>
std::vector<std::size_t> farthest_vertices(Solver& solver, std::size_t number, Job& job)
{
  using Surface_type = typename Solver::Domain::Surface;
  const Surface& surface = job.surface();
  const auto progress = job.progress("farthest vertices");
  // The distance to the nearest one chosen; none where nothing is to be chosen.
  std::vector<double> cover(surface.file.points.size(),
                            surface.is_mesh() ? 0. : std::numeric_limits<double>::infinity());
  for(const std::uint32_t corner : surface.file.corners)
    cover[corner] = std::numeric_limits<double>::infinity();
  // The first one at random, so that another seed gives another choice.
  std::mt19937 random(job.seed());
  std::size_t next = random() % cover.size();
  while(cover[next] == 0.)
    next = (next + 1) % cover.size();

  std::vector<std::size_t> chosen;
  for(double radius = cover[next]; chosen.size() < number && radius > 0.; radius = cover[next])
  {
    chosen.push_back(next);
    // Beyond the radius every vertex has a nearer one.
    solver.compute(site<Surface_type>(next), GP::parameters::maximum_distance(radius));
    for(const auto& reached : solver.reached())
    {
      double& distance = cover[static_cast<std::size_t>(reached)];
      distance = std::min(distance, solver.distance(reached));
    }
    cover[next] = 0.;
    next = static_cast<std::size_t>(std::max_element(cover.begin(), cover.end()) - cover.begin());
    if(progress)
      progress(static_cast<double>(chosen.size()) / static_cast<double>(number));
  }
  return chosen;
}

} // namespace program

#endif // GEODESIC_PROGRAM_FARTHEST_VERTICES_H
