// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/tags.h>

#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

namespace tags_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Returns the distance along the diagonal of a square, which distinguishes the methods.
template <typename Method>
double distance_across_square()
{
  static const Array_surface surface(square(20));
  internal::Distance_engine engine(internal::distance_method<Method>(), surface.triangles());
  engine.run({surface.source(20)});
  return surface.distances(engine)[20 * 21]; // from (1,0) to (0,1), across all face diagonals
}

TEST(Tags, select_methods_with_expected_errors)
{
  EXPECT_NEAR(distance_across_square<Dijkstra>(), 2.,
              1e-12); // the sum of two edge lengths, 41 % too long
  EXPECT_NEAR(distance_across_square<Euclidean_front>(), std::sqrt(2.), 1e-9);
  EXPECT_NEAR(distance_across_square<Exact>(), std::sqrt(2.), 1e-12); // sums of twenty lengths
  // First order: an edge length of 1/20.
  EXPECT_NEAR(distance_across_square<Fast_marching>(), std::sqrt(2.), 1.1 / 20.);
  EXPECT_GT(distance_across_square<Fast_marching>(), std::sqrt(2.) + 1e-6);
  // Depends on the time step, which is the squared edge length. Measured: 0.037.
  EXPECT_NEAR(distance_across_square<Heat>(), std::sqrt(2.), 0.06);
}

} // namespace tags_test
