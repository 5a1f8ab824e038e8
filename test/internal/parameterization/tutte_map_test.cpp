// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/parameterization/symmetric_dirichlet.h>
#include <CGAL/Geodesic_processing/internal/parameterization/tutte_map.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tutte_map_test {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;
using CGAL::Geodesic_processing::Unsupported_surface_error;

TEST(tutte_map, has_no_flips)
{
  const Triangulation dome = grid(
      20, 20,
      [](double s, double t) -> Point
      {
        const double x = 2. * s - 1., y = 2. * t - 1.;
        return {x, y, 1.5 * std::exp(-3. * (x * x + y * y))};
      },
      0.2);
  for(const Triangulation& surface :
      {square(20, 0.25), dome, annulus(24, 6, 1., 2.), one_triangle()})
  {
    const Array_surface arrays(surface);
    check_is_disk(arrays.t());
    EXPECT_EQ(number_of_flips(arrays.t(), tutte_map(arrays.t())), 0u);
  }
}

TEST(tutte_map, throws_if_not_a_disk)
{
  const Triangulation piece = square(3);
  Triangulation above = piece;
  for(Point& p : above.points)
    p[2] += 1.;
  for(const Triangulation& surface :
      {icosphere(1), torus(8, 6), disjoint_union(piece, above), Triangulation{}})
    EXPECT_THROW(check_is_disk(Array_surface(surface).t()), Unsupported_surface_error);
  // A torus without one triangle has a boundary and a handle.
  Triangulation handle = torus(8, 6);
  handle.corners.resize(handle.corners.size() - 3);
  EXPECT_THROW(check_is_disk(Array_surface(handle).t()), Unsupported_surface_error);
}

TEST(tutte_map, longest_boundary_loop_is_first)
{
  const Array_surface surface(annulus(24, 6, 1., 2.));
  const auto loops = boundary_loops(surface.t());
  ASSERT_EQ(loops.size(), 2u);
  const auto radius = [&](Index h) { return norm(surface.t().point[surface.t().corner[h]]); };
  EXPECT_GT(radius(loops[0][0]), radius(loops[1][0]));
}

} // namespace tutte_map_test
