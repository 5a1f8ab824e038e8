// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/mds.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mds_test {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;

TEST(mds, is_isometric_on_planar_patch)
{
  const Array_surface surface(square(30, 0.25));
  std::vector<Index> base;
  for(const Surface_location& sample : farthest_points(surface.triangles(), 20))
    base.push_back(sample.triangle == none ? sample.vertex
                                           : surface.t().corner[3 * sample.triangle]);
  const std::vector<Vec2> image =
      landmark_mds(surface.t(), Front(surface.triangles(), Front_kind::euclidean), base);
  ASSERT_EQ(image.size(), surface.size());
  for(Index a = 0; a < surface.size(); ++a)
    // Round-off errors of squares and sums.
    EXPECT_NEAR(surface.scale() * norm(image[surface.vertex(a)] - image[surface.vertex(7)]),
                distance(surface.point(a), surface.point(7)), 1e-10);
}

TEST(mds, is_empty_when_cancelled)
{
  const Array_surface surface(square(5, 0.2));
  const Front front(surface.triangles(), Front_kind::euclidean);
  EXPECT_TRUE(landmark_mds(surface.t(), front, {0, 5, 9}, [](double) { return false; }).empty());
  EXPECT_TRUE(
      landmark_mds(surface.t(), front, {0, 5, 9}, [](double done) { return done < 0.6; }).empty());
}

} // namespace mds_test
