// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_EDGES_OF_SOUP_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_EDGES_OF_SOUP_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Calls visit(edge) for each edge of a triangle soup, that is, for each pair of points that
// halfedges join in either direction. edge is a vector of the halfedges of the edge, in increasing
// order. O(n) if the vertices have bounded degree.
template <typename Visitor>
void for_each_edge_of_soup(std::size_t number_of_points, const std::vector<Index>& corners,
                           Visitor visit)
{
  // Sorts the halfedges into buckets by their smaller vertex. The buckets are short. An element
  // has the larger vertex in its upper half and the halfedge in its lower half.
  const auto smaller_end = [&](Index h) { return std::min(corners[h], corners[next_halfedge(h)]); };
  const auto larger_end = [&](Index h) { return std::max(corners[h], corners[next_halfedge(h)]); };
  std::vector<Index> bucket_end(number_of_points + 1, 0);
  std::vector<std::uint64_t> elements(corners.size());
  for(Index h = 0; h < corners.size(); ++h)
    ++bucket_end[smaller_end(h) + 1];
  std::partial_sum(bucket_end.begin(), bucket_end.end(), bucket_end.begin());
  for(Index h = 0; h < corners.size(); ++h)
    elements[bucket_end[smaller_end(h)]++] = std::uint64_t(larger_end(h)) << 32 | h;

  std::vector<Index> edge;
  auto begin = elements.begin();
  for(std::size_t v = 0; v < number_of_points; ++v)
  {
    const auto end = elements.begin() + bucket_end[v];
    std::sort(begin, end);
    while(begin != end)
    {
      const std::uint64_t other_end = *begin >> 32;
      for(edge.clear(); begin != end && *begin >> 32 == other_end; ++begin)
        edge.push_back(static_cast<Index>(*begin));
      visit(static_cast<const std::vector<Index>&>(edge));
    }
  }
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_EDGES_OF_SOUP_H
