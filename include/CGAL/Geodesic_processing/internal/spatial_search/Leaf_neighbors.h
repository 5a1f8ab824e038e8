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

// Computes the k nearest neighbors of all points of a tree, one leaf at a time. The points of
// nearby leaves are gathered once for all points of a leaf. The results equal those of
// Kd_tree::nearest(). If the points are samples of a surface, the search takes two thirds of the
// time.
//
// An object reuses its arrays. Use one object per thread.
class Leaf_neighbors
{
public:
  using Neighbor = Kd_tree::Neighbor;

  // Keeps references to the points and the tree.
  CGAL_GEODESIC_PROCESSING_EXPORT
  Leaf_neighbors(const std::vector<Kd_tree::Point>& points, const Kd_tree& tree, std::size_t k);

  // Returns the number of neighbors of each point: the minimum of k and the number of points.
  std::size_t size() const { return m_size; }

  // Returns the index after the last point in the leaf of a point.
  Index leaf_end(Index point) const { return m_tree.leaf(point).second; }

  // Returns a row of size() neighbors for each of the points first .. last - 1, which must belong
  // to one leaf. A row is sorted by distance and then by index; it includes the point itself.
  CGAL_GEODESIC_PROCESSING_EXPORT
  const std::vector<Neighbor>& find(Index first, Index last);

private:
  // The coordinates and the index of each gathered point.
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
