// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/diffusion.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

namespace diffusion_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of sums of some hundred numbers.
constexpr double round_off = 1e-12;

TEST(diffusion, has_requested_standard_deviation)
{
  const Array_surface surface(square(40));
  const Operators o = operators(surface.t());
  const Vector mass = lumped_mass(o);
  const Index center = 41 * 20 + 20;
  const double radius = 0.05;
  const Vector diffused_function =
      diffused(o, Vector::Unit(surface.size(), surface.vertex(center)), radius / surface.scale());
  double sum = 0., second_moment = 0.;
  for(Index i = 0; i < surface.size(); ++i)
  {
    const double vertex_mass = mass[surface.vertex(i)] * diffused_function[surface.vertex(i)];
    EXPECT_GE(vertex_mass, -round_off);
    sum += vertex_mass;
    second_moment += vertex_mass * std::pow(surface.point(i)[0] - 0.5, 2.);
  }
  EXPECT_NEAR(sum, mass[surface.vertex(center)], round_off);
  // The boundary is ten standard deviations away: its effect is far below the tolerance.
  EXPECT_NEAR(std::sqrt(second_moment / sum), radius, 0.001 * radius);
}

TEST(diffusion, preserves_constants)
{
  const Array_surface surface(jittered(icosphere(2), 0.03));
  const Vector one = Vector::Ones(surface.size());
  EXPECT_LT((diffused(operators(surface.t()), one, 0.3) - one).lpNorm<Eigen::Infinity>(),
            round_off);
}

} // namespace diffusion_test
