// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/harmonic_fields.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include "Glued_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Of solutions of systems with some hundred unknowns.
constexpr double rounding = 1e-10;

std::vector<Field> fields_of(const Glued_surface& surface, const Operators& o)
{
  const Laplacian laplacian(o);
  Sparse_matrix matrix = laplacian.matrix(o);
  laplacian.hold(matrix);
  return harmonic_fields(surface.t(), o, Sparse_solver(matrix));
}

// A square whose inner cells are left out where both numbers are odd.
Triangulation sieve(std::size_t n)
{
  Triangulation result = square(n), rest = result;
  rest.corners.clear();
  for(std::size_t f = 0; f < result.corners.size(); f += 3)
  {
    const std::size_t cell = f / 6, i = cell % n, j = cell / n;
    if(i % 2 == 0 || j % 2 == 0)
      rest.corners.insert(rest.corners.end(), &result.corners[f], &result.corners[f] + 3);
  }
  return rest;
}

// A strip of which two opposite corners are one: a loop through a point.
Triangulation pinched_loop()
{
  Triangulation result = grid(6, 1, [](double u, double v) { return Point{u, 0.1 * v, 0.}; });
  for(Index& corner : result.corners)
    if(corner == 13)
      corner = 0;
  return result;
}

TEST(Harmonic_fields, are_as_many_as_handles_and_loops_ask_for)
{
  struct Case
  {
    Triangulation surface;
    std::size_t number;
  };
  const std::vector<Case> cases = {
      {icosphere(2), 0},   {square(5), 0},
      {one_triangle(), 0}, {cylinder(12, 4, 1., 1.), 1},
      {torus(12, 8), 2},   {double_ring(1), 4},
      {sieve(5), 4},       {sieve(7), 9},
      {pinched_loop(), 1}, {apart(torus(12, 8), apart(sieve(5), icosphere(1))), 6}};
  for(const auto& [surface, number] : cases)
  {
    const Glued_surface glued_surface(surface);
    const Operators o = operators(glued_surface.t());
    const std::vector<Field> fields = fields_of(glued_surface, o);
    ASSERT_EQ(fields.size(), number);
    EXPECT_EQ(number_of_harmonic_fields(glued_surface.t()), number);
    for(std::size_t i = 0; i < number; ++i)
    {
      EXPECT_LT(divergence(o, fields[i]).lpNorm<Eigen::Infinity>(), rounding);
      for(std::size_t j = 0; j <= i; ++j)
        EXPECT_NEAR(inner_product(o, fields[i], fields[j]), i == j ? 1. : 0., rounding);
    }
  }
}

TEST(Harmonic_fields, go_around_a_cylinder_evenly)
{
  const Glued_surface surface(cylinder(12, 4, 1., 1.));
  const Operators o = operators(surface.t());
  const Field field = fields_of(surface, o).front();
  for(const Planar& vector : field)
    EXPECT_NEAR(norm(vector), norm(field[0]), rounding);
}

TEST(Harmonic_fields, are_none_of_clouds)
{
  const Cloud cloud = octahedron_sphere(2);
  const Glued_surfels sphere = glue_surfels(cloud.points, cloud.normals);
  const Operators o = operators(sphere.triangles);
  const Laplacian laplacian(o);
  Sparse_matrix matrix = laplacian.matrix(o);
  laplacian.hold(matrix);
  EXPECT_THROW(harmonic_fields(sphere.triangles, o, Sparse_solver(matrix)),
               Unsupported_surface_error);
}

} // namespace
