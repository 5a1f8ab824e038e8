// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_TORUS_GEODESIC_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_TORUS_GEODESIC_H

#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <cmath>

namespace CGAL::Geodesic_processing::test {

// The torus around the z-axis with radii 1 and `tube`, at the angles u around the axis and v around
// the tube.
struct Torus
{
  double tube = 0.4;

  internal::Vec3 point(double u, double v) const
  {
    const double radius = 1. + tube * std::cos(v);
    return {radius * std::cos(u), radius * std::sin(u), tube * std::sin(v)};
  }
  // The unit tangents in the directions of increasing u and v.
  static internal::Vec3 tangent_u(double u) { return {-std::sin(u), std::cos(u), 0.}; }
  static internal::Vec3 tangent_v(double u, double v)
  {
    return {-std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v)};
  }
  static internal::Vec3 normal(double u, double v)
  {
    return {std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)};
  }

  // Returns the endpoint of the geodesic from (u, v) at an angle to the circles of constant v.
  // Solves the geodesic equation by the method of Runge and Kutta in 10,000 steps: the error is of
  // the order of round-off.
  internal::Vec3 geodesic(double u, double v, double angle, double length) const
  {
    using State = std::array<double, 4>; // u, v and their derivatives
    const auto derivative = [&](const State& s) -> State
    {
      const double radius = 1. + tube * std::cos(s[1]), sine = std::sin(s[1]);
      return {s[2], s[3], 2. * tube * sine / radius * s[2] * s[3],
              -radius * sine / tube * s[2] * s[2]};
    };
    const auto sum = [](State s, double factor, const State& d)
    {
      for(int k = 0; k < 4; ++k)
        s[k] += factor * d[k];
      return s;
    };
    State s = {u, v, std::cos(angle) / (1. + tube * std::cos(v)), std::sin(angle) / tube};
    constexpr int number_of_steps = 10000;
    const double h = length / number_of_steps;
    for(int i = 0; i < number_of_steps; ++i)
    {
      const State a = derivative(s), b = derivative(sum(s, 0.5 * h, a)),
                  c = derivative(sum(s, 0.5 * h, b)), d = derivative(sum(s, h, c));
      s = sum(sum(sum(sum(s, h / 6., a), h / 3., b), h / 3., c), h / 6., d);
    }
    return point(s[0], s[1]);
  }
};

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_TORUS_GEODESIC_H
