// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_OBTUSE_SPLITS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_OBTUSE_SPLITS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The obtuse corners of a mesh, each split by a vertex (Kimmel and Sethian 1998, section 3). The
// triangles behind the edge opposite to the corner are unfolded into the plane of the triangle
// until a vertex splits the obtuse angle into two acute ones. Each half is a virtual triangle: the
// corner, the splitting vertex, and one of the two neighbors of the corner in its triangle.
struct Obtuse_splits
{
  struct Split
  {
    Index corner;  // the obtuse corner
    Index vertex;  // the vertex that splits it
    double length; // between the two
    // The neighbors of the corner in its triangle, the next corner first: the lengths of the edges
    // to the corner, and the distances from the splitting vertex.
    Vec2 to_neighbor, base;
  };
  // One half of a split corner, as seen from one end of its base: from the neighbor of the corner,
  // or from the splitting vertex.
  struct Half
  {
    Index corner;   // the obtuse corner
    Index target;   // the vertex of that corner
    Index along;    // the other end of the base
    Index neighbor; // the end of the base that is the neighbor
    double base;    // length of the base
    Vec2 apex;      // position of the corner; the base runs along the first axis
  };
  // What identifies a half; see split_half.h.
  class View
  {
  public:
    View() = default;
    View(Index target_vertex, Index other_end, Index split, std::size_t half,
         bool is_from_splitting_vertex)
        : target(target_vertex), along(other_end),
          m_code(4 * split + 2 * (is_from_splitting_vertex ? 1 : 0) + Index(half))
    {}

    Index target; // the vertex of the obtuse corner
    Index along;  // the other end of the base

    Index split() const { return m_code / 4; }
    std::size_t half() const { return m_code % 2; } // 0: of the next corner
    bool is_from_splitting_vertex() const { return (m_code & 2) != 0; }

  private:
    Index m_code; // there are less than 2^30 triangles, and at most one split in each
  };

  std::vector<Split> splits; // sorted by corners
  // #vertices + 1: begin of the views of each vertex; empty without splits
  std::vector<Index> begin;
  std::vector<View> views; // 4 #splits
  // #triangles: which of the corners is split (0 to 2), or 3; empty without splits
  std::vector<std::uint8_t> split_corner;

  bool is_split(Index corner) const
  {
    return !split_corner.empty() && split_corner[corner / 3] == corner % 3;
  }
};

// Splits the obtuse corners of a mesh in O(#triangles) time; at most 20 triangles are unfolded for
// each corner. A cloud has no splits. Uses the number of threads of the arrays.
CGAL_GEODESIC_PROCESSING_EXPORT Obtuse_splits split_obtuse_corners(const Surface_arrays& triangles);

// Returns split_obtuse_corners(), computed once as long as any user holds the result. The triangles
// must not change afterwards. Thread-safe.
CGAL_GEODESIC_PROCESSING_EXPORT
std::shared_ptr<const Obtuse_splits> shared_obtuse_splits(const Surface_arrays& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_OBTUSE_SPLITS_H
