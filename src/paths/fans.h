// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_FANS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_FANS_H

#include "core/unfold.h"

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The fans of triangles of a mesh: a nonmanifold vertex has several, any other vertex has one.
struct Fans
{
  std::vector<Index> fan;          // #corners
  std::vector<Index> first_corner; // #fans: the clockwise first corner at the boundary

  Index size() const { return Index(first_corner.size()); }
  bool is_at_boundary(const Surface_arrays& t, Index i) const
  {
    return t.twin[first_corner[i]] == none;
  }
  // Calls visit(corner) for the corners of a fan in counterclockwise order.
  template <typename Visitor>
  void for_each_corner(const Surface_arrays& t, Index i, const Visitor& visit) const
  {
    Index corner = first_corner[i];
    do
    {
      visit(corner);
      corner = next_corner_ccw(t, corner);
    } while(corner != none && corner != first_corner[i]);
  }
};

// O(n)
inline Fans fans(const Surface_arrays& t)
{
  Fans result;
  result.fan.assign(t.corner.size(), none);
  for(Index corner = 0; corner < t.corner.size(); ++corner)
  {
    if(result.fan[corner] != none)
      continue;
    Index first = corner;
    for(Index next = next_corner_cw(t, corner); next != none; next = next_corner_cw(t, next))
    {
      if(next == corner) // not at the boundary
      {
        first = corner;
        break;
      }
      first = next;
    }
    const Index i = result.size();
    result.first_corner.push_back(first);
    result.for_each_corner(t, i, [&](Index c) { result.fan[c] = i; });
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_FANS_H
