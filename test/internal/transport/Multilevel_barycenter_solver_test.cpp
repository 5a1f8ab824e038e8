// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Multilevel_barycenter_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace Multilevel_barycenter_solver_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Relative round-off error of sums of some hundred terms.
constexpr double round_off = 1e-9;

Mass_distribution at(const Surface_location& location, double mass = 1.)
{
  Mass_distribution result;
  result.at_locations = {{location, mass}};
  return result;
}

// In the plane, the cost is the sum of the squared distances to the midpoint on every level.
TEST(Multilevel_barycenter_solver, cost_is_exact_in_refined_plane)
{
  const Index n = 12;
  const Array_surface surface(scaled(square(n, 0.2), 3.));
  const Index from = 2 * (n + 1) + 3, to = 10 * (n + 1) + 9;
  const double exact = 0.5 * std::pow(test::distance(surface.point(from), surface.point(to)), 2);
  for(const unsigned refinements : {0u, 1u, 2u})
  {
    const Multilevel_barycenter_solver solver(surface.triangles(), refinements);
    const Barycenter_result found =
        solver.solve({at(surface.at(from)), at(surface.at(to))}, {1., 1.});
    EXPECT_TRUE(found.is_converged);
    EXPECT_LE(found.lower, exact * (1. + round_off));
    EXPECT_GE(found.upper, exact * (1. - round_off));
    ASSERT_EQ(found.masses.size(), Eigen::Index(surface.size()));
    EXPECT_GE(found.masses.minCoeff(), 0.);
    EXPECT_NEAR(found.masses.sum(), 1., round_off);
    EXPECT_NEAR(found.distances[0] * found.distances[0] + found.distances[1] * found.distances[1],
                found.upper, round_off * exact);
  }
}

// A metric that doubles lengths quadruples squared distances.
TEST(Multilevel_barycenter_solver, respects_metric)
{
  const Index n = 12;
  const Array_surface surface(square(n, 0.2));
  const Surface_location from = surface.at(2 * (n + 1) + 2), to = surface.at(10 * (n + 1) + 9);
  const double squared_half_distance =
      0.5 *
      std::pow(test::distance(surface.point(2 * (n + 1) + 2), surface.point(10 * (n + 1) + 9)), 2);
  const std::vector<Metric_tensor> doubled_metric(surface.t().number_of_triangles(),
                                                  Metric_tensor{2., 0., 2.});
  const Barycenter_result found =
      Multilevel_barycenter_solver(surface.triangles(), 1, doubled_metric)
          .solve({at(from), at(to)}, {1., 1.});
  EXPECT_LE(found.lower, 4. * squared_half_distance * (1. + round_off));
  EXPECT_GE(found.upper, 4. * squared_half_distance * (1. - round_off));
}

TEST(Multilevel_barycenter_solver, normalizes_masses)
{
  const Array_surface surface(icosphere(2));
  const Multilevel_barycenter_solver solver(surface.triangles());
  const Barycenter_result unit = solver.solve({at(surface.at(0)), at(surface.at(90))}, {1., 1.});
  const std::vector<Mass_distribution> unequal_masses = {at(surface.at(0), 2.),
                                                         at(surface.at(90), 5.)};
  EXPECT_NEAR(solver.solve(unequal_masses, {1., 1.}, true).value, unit.value, round_off);
  EXPECT_THROW(solver.solve(unequal_masses, {1., 1.}), Invalid_argument_error);
  EXPECT_THROW(solver.solve({at(surface.at(0), 0.)}, {1.}, true), Invalid_argument_error);
  EXPECT_THROW(solver.solve({at(surface.at(0), infinity)}, {1.}, true), Invalid_argument_error);
}

TEST(Multilevel_barycenter_solver, throws_on_too_many_refinements)
{
  const Array_surface surface(tetrahedron());
  EXPECT_THROW(Multilevel_barycenter_solver(surface.triangles(), 20), Unsupported_surface_error);
}

} // namespace Multilevel_barycenter_solver_test
