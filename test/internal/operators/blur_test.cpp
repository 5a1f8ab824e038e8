// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/blur.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Of sums of some hundred numbers.
constexpr double rounding = 1e-12;

TEST(blur, spreads_what_is_at_a_place)
{
  const Glued_surface surface(square(40));
  const Operators o = operators(surface.t());
  const Vector mass = lumped_mass(o);
  const Index middle = 41 * 20 + 20;
  const double radius = 0.05;
  const Vector after =
      blurred(o, Vector::Unit(surface.size(), surface.site(middle)), radius / surface.scale());
  double sum = 0., square = 0.;
  for(Index i = 0; i < surface.size(); ++i)
  {
    const double part = mass[surface.site(i)] * after[surface.site(i)];
    EXPECT_GE(part, -rounding);
    sum += part;
    square += part * std::pow(surface.point(i)[0] - 0.5, 2.);
  }
  EXPECT_NEAR(sum, mass[surface.site(middle)], rounding);
  // The border, ten radii away, is hardly felt.
  EXPECT_NEAR(std::sqrt(square / sum), radius, 0.001 * radius);
}

TEST(blur, keeps_constants)
{
  const Glued_surface surface(shaken(icosphere(2), 0.03));
  const Vector one = Vector::Ones(surface.size());
  EXPECT_LT((blurred(operators(surface.t()), one, 0.3) - one).lpNorm<Eigen::Infinity>(), rounding);
}

} // namespace
