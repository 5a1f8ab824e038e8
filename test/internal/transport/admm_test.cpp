// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/admm.h>

#include "Array_surface.h"
#include "random_values.h"

#include <gtest/gtest.h>

namespace admm_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Relative round-off error of sums of some hundred terms.
constexpr double round_off = 1e-9;

// Projection to the fields v + c w, c real.
struct Affine_line
{
  const Operators& o;
  Field v, w;

  Field operator()(const Field& x) const
  {
    Field result = v;
    double coefficient = 0.;
    for(std::size_t f = 0; f < v.size(); ++f)
      coefficient += o.area[f] * dot(x[f] - v[f], w[f]);
    coefficient /= inner_product(o, w, w);
    for(std::size_t f = 0; f < v.size(); ++f)
      result[f] = v[f] + coefficient * w[f];
    return result;
  }
  double cost(double c) const
  {
    double result = 0.;
    for(std::size_t f = 0; f < v.size(); ++f)
      result += o.area[f] * norm(v[f] + c * w[f]);
    return result;
  }
};

TEST(Admm, minimizes_length_on_affine_line)
{
  const Array_surface surface(jittered(icosphere(1), 0.1));
  const Operators o = operators(surface.t());
  for(const unsigned seed : {1u, 2u, 3u})
  {
    const Affine_line line = {o, random_field(o.number_of_triangles(), seed),
                              random_field(o.number_of_triangles(), seed + 10)};
    // The cost is convex. Golden section search finds c up to 1e-8.
    double low = -10., high = 10.;
    while(high - low > 1e-8)
    {
      const double a = low + 0.382 * (high - low), b = high - 0.382 * (high - low);
      (line.cost(a) < line.cost(b) ? high : low) = line.cost(a) < line.cost(b) ? b : a;
    }
    const double min_cost = line.cost(low);
    Admm admm(o, line);
    double upper = infinity, lower = 0.;
    for(unsigned i = 0; i < 100; ++i)
    {
      admm.advance(10);
      EXPECT_LE(admm.upper(), upper);
      EXPECT_GE(admm.lower(), lower);
      upper = admm.upper();
      lower = admm.lower();
      EXPECT_GE(upper, min_cost * (1. - round_off));
      EXPECT_LE(lower, min_cost * (1. + round_off));
    }
    EXPECT_LT(upper - lower, 1e-3 * upper); // the error is at most O(1 / steps)

    const Field &flow = admm.flow(), &dual_field = admm.dual_field();
    const Field projected_flow = line(flow);
    double cost = 0.;
    for(std::size_t f = 0; f < flow.size(); ++f)
    {
      EXPECT_NEAR(projected_flow[f][0], flow[f][0], round_off);
      EXPECT_NEAR(projected_flow[f][1], flow[f][1], round_off);
      EXPECT_LE(norm(dual_field[f]), 1. + round_off);
      cost += o.area[f] * norm(flow[f]);
    }
    EXPECT_NEAR(cost, upper, round_off * upper);
    EXPECT_NEAR(inner_product(o, dual_field, flow), lower, round_off * upper);
    EXPECT_NEAR(inner_product(o, dual_field, line.w), 0., round_off * upper);
  }
}

TEST(Admm, warm_start_continues)
{
  const Array_surface surface(jittered(icosphere(1), 0.1));
  const Operators o = operators(surface.t());
  const Affine_line line = {o, random_field(o.number_of_triangles(), 1),
                            random_field(o.number_of_triangles(), 2)};
  Admm first_solver(o, line);
  first_solver.advance(500);
  Admm second_solver(o, line, first_solver.state());
  second_solver.advance(10);
  EXPECT_LT(second_solver.upper() - second_solver.lower(),
            1.1 * (first_solver.upper() - first_solver.lower()));
  Admm cold_start(o, line);
  cold_start.advance(10);
  EXPECT_LT(second_solver.upper() - second_solver.lower(),
            0.1 * (cold_start.upper() - cold_start.lower()));
}

} // namespace admm_test
