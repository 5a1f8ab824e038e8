// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_map/Planar_quasi_newton.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Planar_quasi_newton_test {

using namespace CGAL::Geodesic_processing::internal;

constexpr double round_off = 1e-12;

// Multiplies by the matrix (a b; b d).
Vec2 product(double a, double b, double d, const Vec2& v)
{
  return {a * v[0] + b * v[1], b * v[0] + d * v[1]};
}

TEST(Planar_quasi_newton, satisfies_the_secant_equation)
{
  Planar_quasi_newton model;
  EXPECT_TRUE(model.is_identity());
  const Vec2 step = {0.3, -0.1};
  const Vec2 change = product(0.5, 0.1, 0.9, step);
  model.update(step, change);
  EXPECT_LT(norm(model.step(change) - step), round_off);
  model.reset();
  EXPECT_TRUE(model.is_identity());
}

TEST(Planar_quasi_newton, minimizes_quadratic_functions_in_few_steps)
{
  const auto gradient = [](const Vec2& x) { return product(0.2, 0.1, 1.3, x); };
  Planar_quasi_newton model;
  Vec2 x = {1., 2.};
  for(int i = 0; i < 12; ++i)
  {
    const Vec2 step = model.step(-1. * gradient(x));
    model.update(step, gradient(x + step) - gradient(x));
    x = x + step;
  }
  EXPECT_LT(norm(x), 1e-8); // superlinear convergence: the gradient method has the rate 0.8
}

TEST(Planar_quasi_newton, rotates_with_the_axes)
{
  Planar_quasi_newton model, rotated_model;
  const Vec2 rotation = {std::cos(0.7), std::sin(0.7)}, step = {0.3, -0.1}, change = {0.1, 0.2},
             gradient = {1., 2.};
  model.update(step, change);
  rotated_model.update(rotated(step, rotation), rotated(change, rotation));
  model.rotate(rotation);
  EXPECT_LT(norm(model.step(gradient) - rotated_model.step(gradient)), round_off);
}

TEST(Planar_quasi_newton, remains_positive_definite)
{
  Planar_quasi_newton model;
  for(const Vec2& change : {Vec2{-1., 0.}, Vec2{0., -3.}, Vec2{-1., -1.}})
  {
    model.update({0.5, 0.2}, change);
    for(const Vec2& gradient : {Vec2{1., 0.}, Vec2{0., 1.}, Vec2{-1., 1.}})
      EXPECT_GT(dot(gradient, model.step(gradient)), 0.);
  }
}

} // namespace Planar_quasi_newton_test
