// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_KD_TREE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_KD_TREE_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A balanced kd-tree of points in space. The constructor sorts the points, such that node k of
// level d contains the points k n / 2^d .. (k + 1) n / 2^d - 1. So the tree only stores the
// bounding boxes of its nodes, about 9 bytes per point. Consecutive points are close to each
// other.
//
// The tree does not store the points. Each query must receive the array that the constructor
// sorted.
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

  // Builds the tree and sorts the points, which must be finite. Sets `order` (#points) to the
  // former index of each point. The result depends neither on the order of the input nor on the
  // number of threads; only coincident points keep their order. O(n log n).
  CGAL_GEODESIC_PROCESSING_EXPORT
  Kd_tree(std::vector<Point>& points, std::vector<Index>& order, unsigned number_of_threads = 1);

  std::size_t size() const { return m_size; }

  // Multiplies all boxes by a power of two. The caller must scale the points by the same factor.
  CGAL_GEODESIC_PROCESSING_EXPORT
  void scale(double factor);

  // Sets `result` to the k nearest points of the query, sorted by distance and then by index.
  // Ignores points whose squared distance exceeds `bound`, so the result can have fewer points.
  CGAL_GEODESIC_PROCESSING_EXPORT
  void nearest(const std::vector<Point>& points, const Point& query, std::size_t k,
               std::vector<Neighbor>& result, double bound = infinity) const;

  // Returns the nearest point of the query (the one with the smallest index if several are equally
  // close), or `none` if the tree is empty.
  CGAL_GEODESIC_PROCESSING_EXPORT
  Index nearest(const std::vector<Point>& points, const Point& query) const;

  // Sets `result` to all points at a squared distance of at most `squared_radius`, sorted by index.
  CGAL_GEODESIC_PROCESSING_EXPORT
  void within(const std::vector<Point>& points, const Point& query, double squared_radius,
              std::vector<Index>& result) const;

  // Returns the range [first, last) of the points in the leaf of a point.
  std::pair<Index, Index> leaf(Index point) const { return node(point, m_levels); }
  // Returns the range of the smallest node that contains a point and at least `size` points in all,
  // or of the root if no node is that large.
  CGAL_GEODESIC_PROCESSING_EXPORT
  std::pair<Index, Index> ancestor(Index point, std::size_t size) const;

  // Sets `result` to the ranges of all leaves whose box is within `squared_distance` of the
  // bounding box of the points first .. last - 1. Returns false, with an incomplete result, if
  // these leaves contain more than `max_number` points.
  CGAL_GEODESIC_PROCESSING_EXPORT
  bool leaves_near(const std::vector<Point>& points, Index first, Index last,
                   double squared_distance, std::size_t max_number,
                   std::vector<std::pair<Index, Index>>& result) const;

private:
  class Builder;

  struct Box
  {
    Point low, high;
  };

  // Products have 64 bits also where std::size_t has 32.
  std::size_t begin(std::size_t node, unsigned level) const
  {
    return std::size_t(std::uint64_t(node) * m_size >> level);
  }
  std::pair<Index, Index> node(Index point, unsigned level) const
  {
    const std::size_t node = std::size_t((((std::uint64_t(point) + 1) << level) - 1) / m_size);
    return {Index(begin(node, level)), Index(begin(node + 1, level))};
  }
  template <typename Visit>
  void visit_leaves(const Point& query, const double& bound, Visit&& visit) const;

  std::size_t m_size = 0;
  unsigned m_levels = 0;    // of inner nodes; a leaf contains at most 12 points
  std::vector<Box> m_boxes; // #nodes: the boxes of level d begin at 2^d - 1
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_KD_TREE_H
