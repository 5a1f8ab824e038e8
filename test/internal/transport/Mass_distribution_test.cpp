// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Mass_distribution.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Mass_distribution_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off error of sums of some hundred terms.
constexpr double round_off = 1e-12;

struct Plane
{
  Array_surface surface{square(6, 0.24)};
  std::vector<double> area = operators(surface.t()).area;

  Vector function(double (*f)(double, double)) const
  {
    Vector result(surface.size());
    for(Index i = 0; i < surface.size(); ++i)
      result[surface.vertex(i)] = f(surface.point(i)[0], surface.point(i)[1]);
    return result;
  }
  Vector at_vertices(const Mass_distribution& masses) const
  {
    return masses_at_vertices(surface.t(), area, masses);
  }
  Mass_distribution difference(const Mass_distribution& from, const Mass_distribution& to,
                               bool do_normalize = false) const
  {
    return internal::difference(surface.t(), area, from, to, do_normalize);
  }
};

Mass_distribution at(const Surface_location& location, double mass)
{
  Mass_distribution result;
  result.at_locations = {{location, mass}};
  return result;
}

double x(double x, double) { return x; }
double y(double, double y) { return y; }
double one(double, double) { return 1.; }

TEST(Mass_distribution, preserves_integrals_of_linear_functions)
{
  const Plane plane;
  const Vector along_x = plane.function(x), along_y = plane.function(y);
  const Surface_location location = plane.surface.in(17, {0.2, 0.5, 0.3});
  const Vector point = plane.at_vertices(at(location, 2.));
  EXPECT_NEAR(point.sum(), 2., round_off);
  const Index* corner = &plane.surface.t().corner[3 * location.triangle];
  for(const Vector& f : {along_x, along_y})
    EXPECT_NEAR(point.dot(f), 2. * (0.2 * f[corner[0]] + 0.5 * f[corner[1]] + 0.3 * f[corner[2]]),
                round_off);

  // Integrals over the unit square: x has 1/2, its square 1/3, and x y 1/4.
  Mass_distribution linear;
  linear.density = along_x;
  const Vector masses = plane.at_vertices(linear);
  EXPECT_NEAR(masses.sum(), 0.5, round_off);
  EXPECT_NEAR(masses.dot(along_x), 1. / 3., round_off);
  EXPECT_NEAR(masses.dot(along_y), 0.25, round_off);
}

TEST(Mass_distribution, sums_all_kinds)
{
  const Plane plane;
  Mass_distribution all = at(plane.surface.at(3), 2.);
  all.at_vertices = plane.function(x);
  all.density = plane.function(one);
  const Vector masses = plane.at_vertices(all);
  EXPECT_NEAR(masses.sum(), 2. + all.at_vertices.sum() + 1., round_off);
}

TEST(Mass_distribution, difference_is_target_minus_source)
{
  const Plane plane;
  const Mass_distribution from = at(plane.surface.at(3), 2.);
  Mass_distribution to;
  to.at_vertices = Vector::Zero(plane.surface.size());
  to.at_vertices[plane.surface.vertex(5)] = 2.;
  for(const bool do_normalize : {false, true})
  {
    const Vector moved = plane.at_vertices(plane.difference(from, to, do_normalize));
    const double mass = do_normalize ? 1. : 2.;
    EXPECT_EQ(moved[plane.surface.vertex(3)], -mass);
    EXPECT_EQ(moved[plane.surface.vertex(5)], mass);
    EXPECT_EQ(moved.lpNorm<1>(), 2. * mass);
  }
  // Normalization also scales densities.
  Mass_distribution uniform;
  uniform.density = 5. * plane.function(one);
  EXPECT_NEAR(plane.at_vertices(plane.difference(from, uniform, true)).sum(), 0., round_off);
}

TEST(Mass_distribution, throws_on_invalid_masses)
{
  const Plane plane;
  const Mass_distribution two = at(plane.surface.at(3), 2.), three = at(plane.surface.at(4), 3.);
  EXPECT_THROW(plane.difference(two, three), Invalid_argument_error);
  EXPECT_THROW(plane.difference(two, at(plane.surface.at(4), std::nan(""))),
               Invalid_argument_error);
  EXPECT_THROW(plane.difference(two, at(plane.surface.at(4), infinity)), Invalid_argument_error);
  EXPECT_THROW(plane.difference(two, at(plane.surface.at(4), -1.), true), Invalid_argument_error);
  EXPECT_THROW(plane.difference({}, {}, true), Invalid_argument_error);
  EXPECT_EQ(plane.at_vertices(plane.difference({}, {})).norm(), 0.);
}

} // namespace Mass_distribution_test
