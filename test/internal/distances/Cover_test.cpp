// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Cover.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <set>

namespace cover_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Grows a cover by layers of triangles.
Cover grown_cover(const Surface_arrays& t, const Homotopy& homotopy, int number_of_layers)
{
  Cover cover(t, homotopy, 0);
  for(int layer = 0; layer < number_of_layers; ++layer)
    for(Index h = 3 * cover.size(); h-- > 0;)
      if(cover.is_open(h))
        cover.add_across(h);
  return cover;
}

// Returns the Euler characteristic of the copies.
int euler_characteristic(const Surface_arrays& t)
{
  int number_of_edges = 0;
  for(Index h = 0; h < t.corner.size(); ++h)
    number_of_edges += t.twin[h] == none || h < t.twin[h] ? 1 : 0;
  return int(t.number_of_vertices()) - number_of_edges + int(t.number_of_triangles());
}

TEST(Cover, is_mesh_if_all_loops_are_contractible)
{
  const Array_surface surface(icosphere(2));
  const Homotopy homotopy(surface.t());
  const Cover cover = grown_cover(surface.t(), homotopy, 100);
  double factor;
  const auto arrays = cover.arrays(factor);
  EXPECT_EQ(cover.size(), surface.t().number_of_triangles());
  EXPECT_EQ(arrays->number_of_vertices(), surface.t().number_of_vertices());
  EXPECT_EQ(factor, 1.);
}

// A disk in the universal cover has no handle. All copies of a triangle have different words.
TEST(Cover, has_no_handles)
{
  for(const Triangulation& triangulation : {torus(5, 4), double_torus(1), cylinder(4, 3, 1., 1.)})
  {
    const Array_surface surface(triangulation);
    const Surface_arrays& t = surface.t();
    const Homotopy homotopy(t);
    const Cover cover = grown_cover(t, homotopy, 14);
    EXPECT_GT(cover.size(), 2 * t.number_of_triangles());
    double factor;
    const auto arrays = cover.arrays(factor);
    // Holes of the layers can only reduce it.
    EXPECT_LE(euler_characteristic(*arrays), 1);
    for(Index copy = 0; copy < cover.size(); ++copy)
      for(const Index other : cover.copies(cover.triangle(copy)))
        EXPECT_EQ(homotopy.is_equal(cover.word(copy), cover.word(other)), copy == other);
    for(Index h = 0; h < 3 * cover.size(); ++h)
    {
      EXPECT_EQ(factor * arrays->length[h], t.length[cover.base(h)]);
      if(arrays->twin[h] != none)
      {
        EXPECT_EQ(cover.base(arrays->twin[h]), t.twin[cover.base(h)]);
      }
    }
  }
}

} // namespace cover_test
