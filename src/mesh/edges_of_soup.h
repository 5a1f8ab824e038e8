// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_EDGES_OF_SOUP_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_EDGES_OF_SOUP_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Calls visit(begin, end) for each edge of a triangle soup, that is, for each pair of points that
// halfedges join in either direction.  begin and end are pointers to the halfedges of the edge, in
// increasing order.  O(n) if the vertices have bounded degree.
template <typename Visitor>
void for_each_edge_of_soup(std::size_t number_of_points, const std::vector<Index>& corners,
                           Visitor visit)
{
  // Sorts the halfedges into buckets by their smaller vertex.  The buckets are short.
  const auto smaller_end = [&](Index h) { return std::min(corners[h], corners[next_halfedge(h)]); };
  const auto larger_end = [&](Index h) { return std::max(corners[h], corners[next_halfedge(h)]); };
  std::vector<Index> bucket_end(number_of_points + 1, 0), halfedges(corners.size());
  for(Index h = 0; h < corners.size(); ++h)
    ++bucket_end[smaller_end(h) + 1];
  std::partial_sum(bucket_end.begin(), bucket_end.end(), bucket_end.begin());
  for(Index h = 0; h < corners.size(); ++h)
    halfedges[bucket_end[smaller_end(h)]++] = h;

  Index* begin = halfedges.data();
  for(std::size_t v = 0; v < number_of_points; ++v)
  {
    Index* const end = halfedges.data() + bucket_end[v];
    std::sort(begin, end,
              [&](Index a, Index b)
              { return std::make_pair(larger_end(a), a) < std::make_pair(larger_end(b), b); });
    while(begin != end)
    {
      const Index* const edge_end =
          std::find_if(begin, end, [&](Index h) { return larger_end(h) != larger_end(*begin); });
      visit(static_cast<const Index*>(begin), edge_end);
      begin += edge_end - begin;
    }
  }
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_EDGES_OF_SOUP_H
