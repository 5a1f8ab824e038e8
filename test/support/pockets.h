// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TEST_SUPPORT_POCKETS_H
#define TEST_SUPPORT_POCKETS_H

#include "Array_surface.h"

#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>

#include <cstddef>
#include <memory>
#include <random>
#include <vector>

namespace CGAL::Geodesic_processing::test {

// Opens edges of a closed surface and inserts a pocket of two triangles into each, so that two
// edges connect the same vertices. The new vertex of a pocket has two faces. Further pockets can be
// inserted into edges of pockets.
inline std::shared_ptr<const Surface_arrays> with_pockets(Triangulation surface, std::size_t number)
{
  std::vector<Index> twin = internal::twins_of_soup(surface.points.size(), surface.corners);
  std::mt19937 generator(0);
  for(std::size_t i = 0; i < number; ++i)
  {
    const Index h = Index(generator() % twin.size()), opposite = twin[h],
                vertex = Index(surface.points.size()), begin = Index(twin.size());
    const Index a = surface.corners[h], b = surface.corners[internal::next_halfedge(h)];
    Point& point = surface.points.emplace_back();
    for(std::size_t k = 0; k < 3; ++k)
      point[k] = 0.51 * (surface.points[a][k] + surface.points[b][k]);
    surface.corners.insert(surface.corners.end(), {a, b, vertex, b, a, vertex});
    twin.insert(twin.end(), {opposite, begin + 5, begin + 4, h, begin + 2, begin + 1});
    twin[opposite] = begin;
    twin[h] = begin + 3;
  }
  return std::make_shared<const Surface_arrays>(
      internal::build_mesh_arrays(surface.points, surface.corners, twin).arrays);
}

} // namespace CGAL::Geodesic_processing::test

#endif // TEST_SUPPORT_POCKETS_H
