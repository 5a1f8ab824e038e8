// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/mds.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;

TEST(mds, keeps_a_piece_of_the_plane)
{
  const Glued_surface surface(square(30, 0.25));
  std::vector<Index> base;
  for(const Location& sample : farthest_points(surface.triangles(), 20))
    base.push_back(sample.triangle == none ? sample.site : surface.t().corner[3 * sample.triangle]);
  const std::vector<Planar> image =
      scaled(surface.t(), Front(surface.triangles(), Front_kind::euclidean), base);
  ASSERT_EQ(image.size(), surface.size());
  for(Index a = 0; a < surface.size(); ++a)
    // Roundings of squares and sums.
    EXPECT_NEAR(surface.scale() * norm(image[surface.site(a)] - image[surface.site(7)]),
                distance(surface.point(a), surface.point(7)), 1e-10);
}

TEST(mds, is_nothing_when_cancelled)
{
  const Glued_surface surface(square(5, 0.2));
  const Front front(surface.triangles(), Front_kind::euclidean);
  EXPECT_TRUE(scaled(surface.t(), front, {0, 5, 9}, [](double) { return false; }).empty());
  EXPECT_TRUE(
      scaled(surface.t(), front, {0, 5, 9}, [](double done) { return done < 0.6; }).empty());
}

} // namespace
