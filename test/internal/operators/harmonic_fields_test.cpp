// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/harmonic_fields.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include "Array_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

namespace harmonic_fields_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of the solutions of systems with some hundred unknowns.
constexpr double round_off = 1e-10;

std::vector<Field> harmonic_basis(const Array_surface& surface, const Operators& o)
{
  return harmonic_fields(surface.t(), o, Poisson_solver(o));
}

// Returns a square grid without the cells whose two indices are odd.
Triangulation perforated_square(std::size_t n)
{
  Triangulation result = square(n), kept = result;
  kept.corners.clear();
  for(std::size_t f = 0; f < result.corners.size(); f += 3)
  {
    const std::size_t cell = f / 6, i = cell % n, j = cell / n;
    if(i % 2 == 0 || j % 2 == 0)
      kept.corners.insert(kept.corners.end(), &result.corners[f], &result.corners[f] + 3);
  }
  return kept;
}

// Returns a strip of which two opposite corners are one vertex. The loop passes through this
// nonmanifold vertex.
Triangulation pinched_loop()
{
  Triangulation result = grid(6, 1, [](double u, double v) { return Point{u, 0.1 * v, 0.}; });
  for(Index& corner : result.corners)
    if(corner == 13)
      corner = 0;
  return result;
}

TEST(Harmonic_fields, dimension_matches_topology)
{
  struct Case
  {
    Triangulation surface;
    std::size_t expected_number;
  };
  const std::vector<Case> cases = {
      {icosphere(2), 0},
      {square(5), 0},
      {one_triangle(), 0},
      {cylinder(12, 4, 1., 1.), 1},
      {torus(12, 8), 2},
      {double_torus(1), 4},
      {perforated_square(5), 4},
      {perforated_square(7), 9},
      {pinched_loop(), 1},
      {disjoint_union(torus(12, 8), disjoint_union(perforated_square(5), icosphere(1))), 6}};
  for(const auto& [surface, expected_number] : cases)
  {
    const Array_surface array_surface(surface);
    const Operators o = operators(array_surface.t());
    const std::vector<Field> fields = harmonic_basis(array_surface, o);
    ASSERT_EQ(fields.size(), expected_number);
    EXPECT_EQ(number_of_harmonic_fields(array_surface.t()), expected_number);
    for(std::size_t i = 0; i < expected_number; ++i)
    {
      EXPECT_LT(minus_divergence(o, fields[i]).lpNorm<Eigen::Infinity>(), round_off);
      for(std::size_t j = 0; j <= i; ++j)
        EXPECT_NEAR(inner_product(o, fields[i], fields[j]), i == j ? 1. : 0., round_off);
    }
  }
}

TEST(Harmonic_fields, has_constant_magnitude_on_cylinder)
{
  const Array_surface surface(cylinder(12, 4, 1., 1.));
  const Operators o = operators(surface.t());
  const Field field = harmonic_basis(surface, o).front();
  for(const Vec2& vector : field)
    EXPECT_NEAR(norm(vector), norm(field[0]), round_off);
}

TEST(Harmonic_fields, throws_on_cloud)
{
  const Cloud cloud = octahedron_sphere(2);
  const Surfel_arrays sphere = build_surfel_arrays(cloud.points, cloud.normals);
  const Operators o = operators(sphere.arrays);
  EXPECT_THROW(harmonic_fields(sphere.arrays, o, Poisson_solver(o)), Unsupported_surface_error);
}

} // namespace harmonic_fields_test
