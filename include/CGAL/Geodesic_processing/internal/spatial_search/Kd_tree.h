// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_KD_TREE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_KD_TREE_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A balanced kd-tree over points that lie in the tree's own order, so that it consists of boxes
// alone: node k of level d holds the points k n / 2^d .. (k+1) n / 2^d - 1.  That order is also a
// locality order.  About 9 bytes per point; the points stay with the caller, who hands in the same
// array to each query.
class Kd_tree
{
public:
  using Point = std::array<double, 3>;

  struct Neighbor
  {
    double squared_distance;
    Index point;

    friend bool operator<(const Neighbor& a, const Neighbor& b)
    {
      return a.squared_distance < b.squared_distance ||
             (a.squared_distance == b.squared_distance && a.point < b.point);
    }
  };

  Kd_tree() = default;

  // Puts finite points into the tree's order, which depends on their coordinates alone; only
  // coincident points keep the order of the input.  `order` receives the former place of each.
  // O(n log n).
  CGAL_GEODESIC_PROCESSING_EXPORT
  Kd_tree(std::vector<Point>& points, std::vector<Index>& order, unsigned threads = 1);

  std::size_t size() const { return m_size; }

  // Follows points whose coordinates the caller multiplies by a power of two.
  CGAL_GEODESIC_PROCESSING_EXPORT
  void scale(double factor);

  // The at most k points nearest to the query, nearest first, ties by place.  `bound` is a squared
  // distance beyond which points do not matter.
  CGAL_GEODESIC_PROCESSING_EXPORT
  void nearest(const std::vector<Point>& points, const Point& query, std::size_t k,
               std::vector<Neighbor>& result, double bound = infinity) const;

  // The point nearest to the query, ties by place; none in an empty tree.
  CGAL_GEODESIC_PROCESSING_EXPORT
  Index nearest(const std::vector<Point>& points, const Point& query) const;

  // All points at a squared distance of at most `squared_radius`, in their order.
  CGAL_GEODESIC_PROCESSING_EXPORT
  void within(const std::vector<Point>& points, const Point& query, double squared_radius,
              std::vector<Index>& result) const;

  // The points of the leaf of a point, and of the smallest node with at least that many, or of all.
  std::pair<Index, Index> leaf(Index point) const { return node(point, m_levels); }
  CGAL_GEODESIC_PROCESSING_EXPORT
  std::pair<Index, Index> ancestor(Index point, std::size_t size) const;

  // The leaves, one after another, with all points not farther than that from the box of some points that
  // follow each other.  False when these have more than `most` points in all.
  CGAL_GEODESIC_PROCESSING_EXPORT
  bool leaves_near(const std::vector<Point>& points, Index first, Index last,
                   double squared_distance, std::size_t max_number,
                   std::vector<std::pair<Index, Index>>& result) const;

private:
  struct Box
  {
    Point low, high;
  };

  std::size_t begin(std::size_t node, unsigned level) const { return node * m_size >> level; }
  std::pair<Index, Index> node(Index point, unsigned level) const
  {
    const std::size_t node = (((std::size_t(point) + 1) << level) - 1) / m_size;
    return {Index(begin(node, level)), Index(begin(node + 1, level))};
  }
  template <typename Visit>
  void visit_leaves(const Point& query, const double& bound, Visit&& visit) const;

  std::size_t m_size = 0;
  unsigned m_levels = 0;    // of inner nodes; the leaves hold at most 12 points
  std::vector<Box> m_boxes; // those of level d begin at 2^d - 1
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_KD_TREE_H
