// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/particular_fields.h>

#include "operators/eigenfunctions.h"
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include "Array_surface.h"
#include "clouds.h"
#include "random_values.h"

#include <gtest/gtest.h>

namespace particular_fields_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of the solutions of systems with some hundred unknowns.
constexpr double round_off = 1e-10;

constexpr Particular_field all_kinds[] = {Particular_field::gradient,
                                          Particular_field::raviart_thomas};

std::vector<Triangulation> surfaces()
{
  return {tetrahedron(),           square(8, 0.24),
          cylinder(12, 4, 1., 1.), torus(12, 8),
          double_torus(1),         jittered(icosphere(2), 0.03),
          annulus(16, 4, 0.5, 1.), cone(12, 6, 8.)};
}

// Returns four columns, each of which moves a unit mass between two vertices.
Masses some_masses(Index n)
{
  Masses result(n, 4);
  for(Index j = 0; j < 4; ++j)
  {
    result.insert(j, j) = -1.;
    result.coeffRef((j + 1) * (n - 1) / 4, j) += 1.;
  }
  return result;
}

// Spreads each mass over the incident triangles. Then a third of the mass of a triangle is moved to
// each corner.
Vector spread_masses(const Operators& o, const Vector& masses)
{
  const Vector ring_area = 3. * lumped_mass(o);
  Vector result = Vector::Zero(masses.size());
  for(std::size_t f = 0; f < o.number_of_triangles(); ++f)
    for(int k = 0; k < 3; ++k)
      for(int i = 0; i < 3; ++i)
        result[o.corner[3 * f + i]] +=
            masses[o.corner[3 * f + k]] * o.area[f] / ring_area[o.corner[3 * f + k]] / 3.;
  return result;
}

TEST(Particular_fields, accepts_masses_at_locations)
{
  const Array_surface surface(tetrahedron());
  const Surface_arrays& t = surface.t();
  const Matrix masses(masses_at(t, {{none, 2, {}}, {1, none, {0.5, 0., 0.5}}}));
  EXPECT_EQ(masses.col(0), Vector::Unit(4, 2));
  EXPECT_EQ(masses.col(1), 0.5 * Vector::Unit(4, t.corner[3]) + 0.5 * Vector::Unit(4, t.corner[5]));
}

TEST(Particular_fields, divergence_matches_masses)
{
  for(const Triangulation& shape : surfaces())
  {
    const Array_surface surface(shape);
    const Operators o = operators(surface.t());
    const Masses masses = some_masses(surface.size());
    for(const Particular_field kind : all_kinds)
    {
      const Particular_fields particular(surface.t(), o, kind);
      ASSERT_EQ(particular.kind(), kind);
      const Matrix fields = particular.fields(masses);
      for(Eigen::Index j = 0; j < masses.cols(); ++j)
      {
        const Vector exact = Matrix(masses).col(j);
        const Vector balanced = minus_divergence(o, as_field(o, fields.col(j)));
        const Vector expected =
            kind == Particular_field::gradient ? exact : spread_masses(o, exact);
        EXPECT_LT((balanced - expected).lpNorm<Eigen::Infinity>(), round_off);
        EXPECT_LT((particular.balanced(exact) - expected).lpNorm<Eigen::Infinity>(), round_off);
      }
    }
  }
}

TEST(Particular_fields, are_orthogonal_to_basis)
{
  for(const Triangulation& shape : surfaces())
  {
    const Array_surface surface(shape);
    const Operators o = operators(surface.t());
    Vector function = random_function(surface.size(), 1);
    const std::vector<bool> is_boundary = boundary_vertices(surface.t());
    for(std::size_t vertex = 0; vertex < is_boundary.size(); ++vertex)
      if(is_boundary[vertex])
        function[Eigen::Index(vertex)] = 0.;
    const Vector rotated = as_column(o, rotated_left(gradient(o, function)));
    for(const Particular_field kind : all_kinds)
    {
      const Particular_fields particular(surface.t(), o, kind);
      const Matrix fields = particular.fields(some_masses(surface.size()));
      EXPECT_LT((fields.transpose() * rotated).lpNorm<Eigen::Infinity>(),
                round_off * rotated.norm());
      const Matrix circulations = fields.transpose() * particular.harmonic_fields();
      EXPECT_TRUE(circulations.size() == 0 || circulations.cwiseAbs().maxCoeff() < round_off);
    }
  }
}

TEST(Particular_fields, fall_back_to_gradients)
{
  const Cloud cloud = octahedron_sphere(2);
  const Surfel_arrays sphere = build_surfel_arrays(cloud.points, cloud.normals);
  const Operators o = operators(sphere.arrays);
  const Particular_fields on_cloud(sphere.arrays, o, Particular_field::raviart_thomas);
  EXPECT_EQ(on_cloud.kind(), Particular_field::gradient);
  EXPECT_EQ(on_cloud.harmonic_fields().cols(), 0);

  // Two triangles with a common vertex.
  const Array_surface pinched(
      Triangulation{{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}},
                    {0, 1, 2, 0, 3, 4}});
  const Operators p = operators(pinched.t());
  EXPECT_EQ(Particular_fields(pinched.t(), p, Particular_field::raviart_thomas).kind(),
            Particular_field::gradient);
}

TEST(Particular_fields, without_gradients_is_divergence_free)
{
  const Array_surface surface(jittered(icosphere(2), 0.03));
  const Operators o = operators(surface.t());
  const Particular_fields particular(surface.t(), o, Particular_field::gradient);
  const Field field = random_field(o.number_of_triangles(), 1);
  const Matrix remainder = particular.without_gradients(as_column(o, field));
  EXPECT_LT(minus_divergence(o, as_field(o, remainder.col(0))).lpNorm<Eigen::Infinity>(),
            round_off);
  EXPECT_LT(
      particular.without_gradients(as_column(o, gradient(o, random_function(surface.size(), 2))))
          .norm(),
      round_off);
}

} // namespace particular_fields_test
