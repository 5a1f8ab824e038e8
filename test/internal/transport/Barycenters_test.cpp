// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Barycenters.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Of the sums of some hundred numbers.
constexpr double rounding = 1e-9;

Mass_distribution at(const Location& location, double mass = 1.)
{
  Mass_distribution result;
  result.at_locations = {{location, mass}};
  return result;
}

// Whatever is divided, in the plane the squares of the distances from the middle.
TEST(Barycenters, cost_the_same_when_the_plane_is_refined)
{
  const Index n = 12;
  const Glued_surface surface(scaled(square(n, 0.2), 3.));
  const Index from = 2 * (n + 1) + 3, to = 10 * (n + 1) + 9;
  const double exact = 0.5 * std::pow(test::distance(surface.point(from), surface.point(to)), 2);
  for(const unsigned refinements : {0u, 1u, 2u})
  {
    const Barycenters kernel(surface.triangles(), refinements);
    const Barycenter found = kernel.solve({at(surface.at(from)), at(surface.at(to))}, {1., 1.});
    EXPECT_TRUE(found.converged);
    EXPECT_LE(found.lower, exact * (1. + rounding));
    EXPECT_GE(found.upper, exact * (1. - rounding));
    ASSERT_EQ(found.masses.size(), Eigen::Index(surface.size()));
    EXPECT_GE(found.masses.minCoeff(), 0.);
    EXPECT_NEAR(found.masses.sum(), 1., rounding);
    EXPECT_NEAR(found.distances[0] * found.distances[0] + found.distances[1] * found.distances[1],
                found.upper, rounding * exact);
  }
}

// Twice as long along one axis: four times the square.
TEST(Barycenters, measure_lengths_as_they_are_told)
{
  const Index n = 12;
  const Glued_surface surface(square(n, 0.2));
  const Location from = surface.at(2 * (n + 1) + 2), to = surface.at(10 * (n + 1) + 9);
  const double square =
      0.5 *
      std::pow(test::distance(surface.point(2 * (n + 1) + 2), surface.point(10 * (n + 1) + 9)), 2);
  const std::vector<Tensor> twice(surface.t().number_of_triangles(), Tensor{2., 0., 2.});
  const Barycenter found =
      Barycenters(surface.triangles(), 1, twice).solve({at(from), at(to)}, {1., 1.});
  EXPECT_LE(found.lower, 4. * square * (1. + rounding));
  EXPECT_GE(found.upper, 4. * square * (1. - rounding));
}

TEST(Barycenters, scales_masses_on_request)
{
  const Glued_surface surface(icosphere(2));
  const Barycenters kernel(surface.triangles());
  const Barycenter unit = kernel.solve({at(surface.at(0)), at(surface.at(90))}, {1., 1.});
  const std::vector<Mass_distribution> heavy = {at(surface.at(0), 2.), at(surface.at(90), 5.)};
  EXPECT_NEAR(kernel.solve(heavy, {1., 1.}, true).value, unit.value, rounding);
  EXPECT_THROW(kernel.solve(heavy, {1., 1.}), Invalid_argument_error);
  EXPECT_THROW(kernel.solve({at(surface.at(0), 0.)}, {1.}, true), Invalid_argument_error);
  EXPECT_THROW(kernel.solve({at(surface.at(0), infinity)}, {1.}, true), Invalid_argument_error);
}

TEST(Barycenters, refuses_what_is_too_large)
{
  const Glued_surface surface(tetrahedron());
  EXPECT_THROW(Barycenters(surface.triangles(), 20), Unsupported_surface_error);
}

} // namespace
