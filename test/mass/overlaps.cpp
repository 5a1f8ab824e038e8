// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlaps.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace mass_test {

namespace {

// Returns whether the line of an edge of `a` separates the interior of `a` from that of `b`. Both
// triangles are counterclockwise.
bool is_separated_by_edge(const Triangle_2& a, const Triangle_2& b)
{
  for(std::size_t k = 0; k < 3; ++k)
  {
    bool is_separated = true;
    for(const Kernel::Point_2& p : b)
      is_separated = is_separated && CGAL::orientation(a[k], a[(k + 1) % 3], p) != CGAL::LEFT_TURN;
    if(is_separated)
      return true;
  }
  return false;
}

} // namespace

bool is_not_ccw(const Triangle_2& triangle)
{
  return CGAL::orientation(triangle[0], triangle[1], triangle[2]) != CGAL::LEFT_TURN;
}

std::optional<std::pair<std::size_t, std::size_t>>
find_overlap(const std::vector<Triangle_2>& triangles)
{
  using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const Triangle_2*>;
  std::vector<Box> boxes;
  for(const Triangle_2& triangle : triangles)
    boxes.emplace_back(CGAL::bbox_2(triangle.begin(), triangle.end()), &triangle);
  std::optional<std::pair<std::size_t, std::size_t>> result;
  // The interiors of two convex polygons are disjoint if and only if the line of an edge of one of
  // them separates them.
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                [&](const Box& a, const Box& b)
                                {
                                  if(!result && !is_separated_by_edge(*a.handle(), *b.handle()) &&
                                     !is_separated_by_edge(*b.handle(), *a.handle()))
                                    result =
                                        std::minmax<std::size_t>(a.handle() - triangles.data(),
                                                                 b.handle() - triangles.data());
                                });
  return result;
}

} // namespace mass_test
