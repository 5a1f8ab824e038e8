// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/splitting.h>

#include "Glued_surface.h"
#include "random_values.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Of some hundred sums.
constexpr double rounding = 1e-9;

// Fields that are v + c w with any number c.
struct Line
{
  const Operators& o;
  Field v, w;

  Field operator()(const Field& x) const
  {
    Field result = v;
    double along = 0.;
    for(std::size_t f = 0; f < v.size(); ++f)
      along += o.area[f] * dot(x[f] - v[f], w[f]);
    along /= inner_product(o, w, w);
    for(std::size_t f = 0; f < v.size(); ++f)
      result[f] = v[f] + along * w[f];
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

TEST(Splitting, finds_the_shortest_field_of_a_line)
{
  const Glued_surface surface(shaken(icosphere(1), 0.1));
  const Operators o = operators(surface.t());
  for(const unsigned seed : {1u, 2u, 3u})
  {
    const Line line = {o, random_field(o.number_of_triangles(), seed),
                       random_field(o.number_of_triangles(), seed + 10)};
    // The cost is convex: by golden section, to 1e-8 of c.
    double low = -10., high = 10.;
    while(high - low > 1e-8)
    {
      const double a = low + 0.382 * (high - low), b = high - 0.382 * (high - low);
      (line.cost(a) < line.cost(b) ? high : low) = line.cost(a) < line.cost(b) ? b : a;
    }
    const double least = line.cost(low);
    Splitting splitting(o, line);
    double upper = infinity, lower = 0.;
    for(unsigned i = 0; i < 100; ++i)
    {
      splitting.advance(10);
      EXPECT_LE(splitting.upper(), upper);
      EXPECT_GE(splitting.lower(), lower);
      upper = splitting.upper();
      lower = splitting.lower();
      EXPECT_GE(upper, least * (1. - rounding));
      EXPECT_LE(lower, least * (1. + rounding));
    }
    EXPECT_LT(upper - lower, 1e-3 * upper); // converges as one over the number of steps, or faster

    const Field &flow = splitting.flow(), &slope = splitting.slope();
    const Field again = line(flow);
    double cost = 0.;
    for(std::size_t f = 0; f < flow.size(); ++f)
    {
      EXPECT_NEAR(again[f][0], flow[f][0], rounding);
      EXPECT_NEAR(again[f][1], flow[f][1], rounding);
      EXPECT_LE(norm(slope[f]), 1. + rounding);
      cost += o.area[f] * norm(flow[f]);
    }
    EXPECT_NEAR(cost, upper, rounding * upper);
    EXPECT_NEAR(inner_product(o, slope, flow), lower, rounding * upper);
    EXPECT_NEAR(inner_product(o, slope, line.w), 0., rounding * upper);
  }
}

TEST(Splitting, goes_on_from_where_it_was)
{
  const Glued_surface surface(shaken(icosphere(1), 0.1));
  const Operators o = operators(surface.t());
  const Line line = {o, random_field(o.number_of_triangles(), 1),
                     random_field(o.number_of_triangles(), 2)};
  Splitting first(o, line);
  first.advance(500);
  Splitting second(o, line, first.state());
  second.advance(10);
  EXPECT_LT(second.upper() - second.lower(), 1.1 * (first.upper() - first.lower()));
  Splitting cold(o, line);
  cold.advance(10);
  EXPECT_LT(second.upper() - second.lower(), 0.1 * (cold.upper() - cold.lower()));
}

} // namespace
