// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/hodge.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "operators/harmonic_fields.h"
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include "Glued_surface.h"
#include "clouds.h"
#include "random_values.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Of solutions of systems with some hundred unknowns.
constexpr double rounding = 1e-9;

std::vector<Field> harmonic_basis(const Glued_surface& surface, const Operators& o)
{
  const Laplacian laplacian(o);
  Sparse_matrix matrix = laplacian.matrix(o);
  laplacian.hold(matrix);
  return harmonic_fields(surface.t(), o, Sparse_solver(matrix));
}

// How many dimensions the images of many random fields span.
template <typename Part>
Eigen::Index dimension(const Operators& o, const Part& part)
{
  const Eigen::Index n = 2 * Eigen::Index(o.number_of_triangles());
  Eigen::MatrixXd columns(n, n);
  for(Eigen::Index i = 0; i < n; ++i)
  {
    const Field field = part(random_field(o.number_of_triangles(), unsigned(i)));
    for(std::size_t f = 0; f < field.size(); ++f)
      for(std::size_t k = 0; k < 2; ++k)
        columns(Eigen::Index(2 * f + k), i) = field[f][k];
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  // Far above what rounding leaves of zero, far below what random fields have.
  return (qr.matrixQR().diagonal().array().abs() > 1e-7).count();
}

struct Case
{
  Triangulation surface;
  Eigen::Index harmonic;
};

std::vector<Case> cases()
{
  return {{tetrahedron(), 0},
          {square(4, 0.2), 0},
          {one_triangle(), 0},
          {torus(6, 4), 2},
          {cylinder(6, 2, 1., 1.), 1},
          {double_ring(1), 4},
          {apart(torus(6, 4), cylinder(6, 2, 1., 1.)), 3}};
}

TEST(Hodge, parts_are_orthogonal_and_sum_to_the_field)
{
  for(const auto& [surface, harmonic] : cases())
  {
    const Glued_surface glued_surface(surface);
    const Operators o = operators(glued_surface.t());
    const Field field = random_field(o.number_of_triangles(), 7);
    const Hodge_parts parts = Hodge_solver(glued_surface.t(), o).decompose(field);
    EXPECT_NEAR(inner_product(o, parts.gradient, parts.rotation), 0., rounding);
    EXPECT_NEAR(inner_product(o, parts.gradient, parts.harmonic), 0., rounding);
    EXPECT_NEAR(inner_product(o, parts.rotation, parts.harmonic), 0., rounding);
    // What is left is a sum of harmonic fields.
    Field rest = parts.harmonic;
    for(const Field& basis : harmonic_basis(glued_surface, o))
    {
      const double share = inner_product(o, rest, basis);
      for(std::size_t f = 0; f < rest.size(); ++f)
        rest[f] = rest[f] - share * basis[f];
    }
    EXPECT_NEAR(inner_product(o, rest, rest), 0., rounding);
  }
}

TEST(Hodge, leaves_gradients_turned_ones_and_harmonic_fields_as_they_are)
{
  const Glued_surface surface(double_ring(1));
  const Operators o = operators(surface.t());
  const Operators sides = operators_of_sides(surface.t(), o);
  const Hodge_solver solver(surface.t(), o);
  const auto expect_same = [&](Field a, const Field& b)
  {
    for(std::size_t f = 0; f < a.size(); ++f)
      a[f] = a[f] - b[f];
    EXPECT_NEAR(inner_product(o, a, a), 0., rounding);
  };
  const Field gradients = gradient(o, Vector::LinSpaced(Eigen::Index(o.number_of_sites), 0., 1.));
  expect_same(solver.decompose(gradients).gradient, gradients);
  const Field turned =
      turned_left(gradient(sides, Vector::LinSpaced(Eigen::Index(sides.number_of_sites), 0., 1.)));
  expect_same(solver.decompose(turned).rotation, turned);
  for(const Field& field : harmonic_basis(surface, o))
    expect_same(solver.decompose(field).harmonic, field);
}

TEST(Hodge, has_the_dimensions_of_the_theory)
{
  for(const auto& [surface, harmonic] : cases())
  {
    const Glued_surface glued_surface(surface);
    const Glued_triangles& t = glued_surface.t();
    const Operators o = operators(t);
    const Hodge_solver solver(t, o);
    const auto [component, number] = components(o);
    std::vector<bool> has_border(number, false);
    Eigen::Index inner = 0, closed = 0;
    for(std::size_t side = 0; side < t.twin.size(); ++side)
    {
      inner += t.twin[side] != none && side < t.twin[side];
      if(t.twin[side] == none)
        has_border[component[t.corner[side]]] = true;
    }
    for(const bool border : has_border)
      closed += !border;
    const auto gradients =
        dimension(o, [&](const Field& x) { return solver.decompose(x).gradient; });
    const auto rotations =
        dimension(o, [&](const Field& x) { return solver.decompose(x).rotation; });
    EXPECT_EQ(gradients, Eigen::Index(o.number_of_sites - number));
    EXPECT_EQ(rotations, inner - closed);
    EXPECT_EQ(dimension(o, [&](const Field& x) { return solver.decompose(x).harmonic; }), harmonic);
    EXPECT_EQ(gradients + rotations + harmonic, 2 * Eigen::Index(o.number_of_triangles()));
  }
}

TEST(Hodge, is_of_meshes)
{
  const Cloud cloud = octahedron_sphere(2);
  const Glued_surfels sphere = glue_surfels(cloud.points, cloud.normals);
  EXPECT_THROW(Hodge_solver(sphere.triangles, operators(sphere.triangles)),
               Unsupported_surface_error);
}

} // namespace
