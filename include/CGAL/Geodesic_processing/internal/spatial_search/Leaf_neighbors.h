// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_LEAF_NEIGHBORS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_LEAF_NEIGHBORS_H

#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The nearest points of all points of a tree, leaf by leaf: those of one leaf are found among the points
// that lie in leaves near it, which are gathered once for all of them.  What Kd_tree::nearest() finds, in two
// thirds of its time on surfaces.  Keeps arrays from one leaf to the next: one for each thread.
class Leaf_neighbors
{
public:
  using Neighbor = Kd_tree::Neighbor;

  // Both stay with the caller.
  CGAL_GEODESIC_PROCESSING_EXPORT
  Leaf_neighbors(const std::vector<Kd_tree::Point>& points, const Kd_tree& tree, std::size_t k);

  // As many as each has: k, or all points if there are less.
  std::size_t size() const { return m_size; }

  // The end of the leaf of a point.
  Index leaf_end(Index point) const { return m_tree.leaf(point).second; }

  // Of points first .. last - 1 of one leaf: rows of size() neighbours, itself among them, nearest first,
  // ties by place.
  CGAL_GEODESIC_PROCESSING_EXPORT
  const std::vector<Neighbor>& find(Index first, Index last);

private:
  // Arrays of coordinates, and the place of each.
  struct Gathered_points
  {
    std::vector<double> x, y, z;
    std::vector<Index> index;

    void clear();
    void pad();
    void append(const std::vector<Kd_tree::Point>& points, std::pair<Index, Index> range);
  };

  std::size_t filter_and_rank(Index point, double bound, std::int64_t* rank);
  bool gather(Index first, Index last, double* bound, std::int64_t* rank);
  void find_in_tree(Index point, const Neighbor* previous, Neighbor* row);

  const std::vector<Kd_tree::Point>& m_points;
  const Kd_tree& m_tree;
  std::size_t m_size;
  Gathered_points m_gathered;
  std::vector<std::pair<Index, Index>> m_leaves;
  std::vector<double> m_candidate_distances;
  std::vector<Index> m_candidate_indices;
  std::vector<unsigned char> m_is_taken;
  std::vector<Neighbor> m_rows, m_row;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_LEAF_NEIGHBORS_H
