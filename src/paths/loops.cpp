// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/loops.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>
#include "paths/shorten_loop.h"

#include <optional>

namespace CGAL::Geodesic_processing::internal {

Loop join_loop(const std::shared_ptr<const Surface_arrays>& triangles,
               const std::vector<Surface_location>& locations)
{
  if(locations.empty())
    throw Invalid_argument_error("The loop has no location.");
  Loop result;
  std::optional<Path_finder> finder;
  for(std::size_t i = 0; i < locations.size(); ++i)
  {
    const Surface_location &from = locations[i], &to = locations[(i + 1) % locations.size()];
    result.push_back(from);
    if(is_same_point(*triangles, from, to) || common_triangle(*triangles, from, to) != none)
      continue;
    if(!finder)
      finder.emplace(triangles);
    const std::vector<Surface_location> path = (*finder)(from, to);
    if(path.empty())
      return {};
    result.insert(result.end(), path.begin() + 1, path.end() - 1);
  }
  return result;
}

void shorten_loops(const Surface_arrays& triangles, std::vector<Loop>& loops)
{
  if(loops.empty())
    return;
  const Homotopy homotopy(triangles);
  for(Loop& loop : loops)
    loop = shorten_loop(triangles, homotopy, loop).locations;
}

void shorten_noncontractible_loops(const Surface_arrays& triangles, std::vector<Loop>& loops)
{
  for(Loop& loop : loops)
    loop = shorten_noncontractible_loop(triangles, loop).locations;
}

} // namespace CGAL::Geodesic_processing::internal
