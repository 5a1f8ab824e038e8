// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_PATH_CHECKS_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_PATH_CHECKS_H

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "paths/shorten_geodesic.h"

#include "triangulations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Checks of properties that every path must have, independent of the algorithm.

namespace CGAL::Geodesic_processing::test {

// Expects that a path joins two locations and that consecutive locations are different and in a
// common triangle.
inline void expect_path_on_surface(const Surface_arrays& t,
                                   const std::vector<Surface_location>& path,
                                   const Surface_location& from, const Surface_location& to)
{
  using namespace internal;
  ASSERT_FALSE(path.empty());
  for(const Surface_location& location : path)
  {
    double sum = 0.;
    for(const double b : location.barycentric)
    {
      EXPECT_GE(b, 0.);
      sum += b;
    }
    EXPECT_NEAR(sum, 1., 1e-15 * 4); // a few round-off errors
  }
  EXPECT_TRUE(is_same_point(t, path.front(), canonical(t, from)));
  EXPECT_TRUE(is_same_point(t, path.back(), canonical(t, to)));
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    EXPECT_FALSE(is_same_point(t, path[i], path[i + 1])) << "location " << i;
    EXPECT_NE(common_triangle(t, path[i], path[i + 1]), none) << "location " << i;
  }
}

// Expects left and right angles of at least pi at each vertex that the path touches.
// tolerance  the error of these angles
inline void expect_locally_shortest(const internal::Locally_shortest_path& path, double tolerance)
{
  for(const internal::Touched_vertex& touched : path.touched_vertices)
    EXPECT_GE(std::min(touched.left_angle, touched.right_angle), pi - tolerance)
        << "at location " << touched.location_index << " of " << path.locations.size();
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_PATH_CHECKS_H
