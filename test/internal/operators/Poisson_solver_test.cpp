// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/Poisson_solver.h>

#include "Array_surface.h"
#include "random_values.h"

#include <gtest/gtest.h>

namespace Poisson_solver_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors times the condition numbers of systems with a hundred unknowns.
constexpr double round_off = 1e-9;

// A sphere, a square, and an isolated vertex.
Triangulation two_components()
{
  Triangulation result = disjoint_union(icosphere(1), square(5, 0.2));
  result.points.push_back({3., 3., 3.});
  return result;
}

TEST(Poisson_solver, recovers_function_up_to_component_constants)
{
  const Operators o = operators(Array_surface(two_components()).t());
  const Vector function = random_function(o.number_of_vertices, 1);
  const Vector solution = Poisson_solver(o).solve(minus_divergence(o, gradient(o, function)));
  const auto [component, number] = components(o);
  ASSERT_EQ(number, 3u);
  std::vector<double> shift(number, infinity);
  for(std::size_t v = 0; v < component.size(); ++v)
  {
    double& component_shift = shift[component[v]];
    if(component_shift == infinity)
    {
      EXPECT_NEAR(solution[Eigen::Index(v)], 0., round_off); // pinned
      component_shift = function[Eigen::Index(v)];
    }
    EXPECT_NEAR(solution[Eigen::Index(v)] + component_shift, function[Eigen::Index(v)], round_off);
  }
}

TEST(Poisson_solver, constructors_agree)
{
  const Operators o = operators(Array_surface(two_components()).t());
  const Vector rhs = minus_divergence(o, random_field(o.number_of_triangles(), 2));
  const Vector expected = Poisson_solver(o).solve(rhs);
  const std::vector<Metric_tensor> identity(o.number_of_triangles(), Metric_tensor{1., 0., 1.});
  EXPECT_EQ(Poisson_solver(o, identity).solve(rhs), expected);
  const Laplacian laplacian(o);
  EXPECT_EQ(Poisson_solver(laplacian, laplacian.matrix(o)).solve(rhs), expected);
}

TEST(Poisson_solver, scales_with_inverse_tensor)
{
  const Operators o = operators(Array_surface(two_components()).t());
  const Vector rhs = minus_divergence(o, random_field(o.number_of_triangles(), 3));
  const std::vector<Metric_tensor> doubled(o.number_of_triangles(), Metric_tensor{2., 0., 2.});
  const Vector difference =
      2. * Poisson_solver(o, doubled).solve(rhs) - Poisson_solver(o).solve(rhs);
  EXPECT_LT(difference.lpNorm<Eigen::Infinity>(), round_off);
}

} // namespace Poisson_solver_test
