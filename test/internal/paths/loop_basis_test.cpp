// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/loop_basis.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"
#include "closed_forms.h"

#include <gtest/gtest.h>

namespace loop_basis_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(loop_basis, periods_have_determinant_one)
{
  struct Case
  {
    Triangulation surface;
    std::size_t expected_number;
  };
  const auto comb = [](int i, int j, int) { return j != 1 || i % 2 == 0; };
  const std::vector<Case> cases = {
      {icosphere(2), 0},
      {square(5), 0},
      {one_triangle(), 0},
      {cylinder(3, 1, 1., 1.), 1},
      {cylinder(12, 4, 1., 1.), 1},
      {torus(3, 3), 2},
      {torus(12, 8), 2},
      {double_torus(1), 4},
      {blocks(9, 3, 1, comb), 8},
      {rectangle_with_slit(8), 0},
      {disjoint_union(torus(12, 8), disjoint_union(cylinder(12, 4, 1., 1.), icosphere(1))), 3}};
  for(const auto& [triangulation, expected_number] : cases)
  {
    const Array_surface surface(triangulation);
    const auto loops = loop_basis(surface.t());
    EXPECT_EQ(loops.size(), expected_number);
    const auto forms = closed_forms(surface.t());
    ASSERT_EQ(forms.size(), expected_number);
    // Determinants of integers of this size have round-off errors far below one.
    EXPECT_NEAR(std::abs(determinant_of_periods(surface.t(), forms, loops)), 1., 1e-6);
    for(const auto& loop : loops)
      for(std::size_t i = 0; i < loop.size(); ++i)
        EXPECT_NE(common_triangle(surface.t(), loop[i], loop[(i + 1) % loop.size()]), none);
  }
}

TEST(loop_basis, is_shortest_around_tube_of_torus)
{
  const Index n = 60, m = 12;
  const Array_surface surface(torus(n, m));
  const auto loops = loop_basis(surface.t());
  ASSERT_EQ(loops.size(), 2u);
  // A meridian is a regular polygon with m edges.
  std::vector<Surface_location> closed = loops[0];
  closed.push_back(closed.front());
  EXPECT_NEAR(path_length(surface.t(), closed) * surface.scale(), 0.8 * m * std::sin(pi / m),
              1e-12);
}

} // namespace loop_basis_test
