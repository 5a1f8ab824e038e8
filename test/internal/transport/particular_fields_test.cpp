// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/particular_fields.h>

#include "operators/eigenfunctions.h"
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include "Glued_surface.h"
#include "clouds.h"
#include "random_values.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Of solutions of systems with some hundred unknowns.
constexpr double rounding = 1e-10;

constexpr Particular_field both[] = {Particular_field::gradient, Particular_field::raviart_thomas};

std::vector<Triangulation> surfaces()
{
  return {tetrahedron(),           square(8, 0.24),
          cylinder(12, 4, 1., 1.), torus(12, 8),
          double_ring(1),          shaken(icosphere(2), 0.03),
          annulus(16, 4, 0.5, 1.), cone(12, 6, 8.)};
}

// A unit from each of some sites to another one.
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

// Each mass, spread over the triangles around its site, and then a third of that to each corner.
Vector spread(const Operators& o, const Vector& masses)
{
  const Vector star = 3. * lumped_mass(o);
  Vector result = Vector::Zero(masses.size());
  for(std::size_t f = 0; f < o.number_of_triangles(); ++f)
    for(int k = 0; k < 3; ++k)
      for(int i = 0; i < 3; ++i)
        result[o.corner[3 * f + i]] +=
            masses[o.corner[3 * f + k]] * o.area[f] / star[o.corner[3 * f + k]] / 3.;
  return result;
}

TEST(Particular_fields, take_masses_at_locations)
{
  const Glued_surface surface(tetrahedron());
  const Glued_triangles& t = surface.t();
  const Matrix masses(masses_at(t, {{none, 2, {}}, {1, none, {0.5, 0., 0.5}}}));
  EXPECT_EQ(masses.col(0), Vector::Unit(4, 2));
  EXPECT_EQ(masses.col(1), 0.5 * Vector::Unit(4, t.corner[3]) + 0.5 * Vector::Unit(4, t.corner[5]));
}

TEST(Particular_fields, balance_their_masses)
{
  for(const Triangulation& shape : surfaces())
  {
    const Glued_surface surface(shape);
    const Operators o = operators(surface.t());
    const Masses masses = some_masses(surface.size());
    for(const Particular_field kind : both)
    {
      const Particular_fields particular(surface.t(), o, kind);
      ASSERT_EQ(particular.kind(), kind);
      const Matrix fields = particular.fields(masses);
      for(Eigen::Index j = 0; j < masses.cols(); ++j)
      {
        const Vector exact = Matrix(masses).col(j);
        const Vector balanced = divergence(o, as_field(o, fields.col(j)));
        const Vector expected = kind == Particular_field::gradient ? exact : spread(o, exact);
        EXPECT_LT((balanced - expected).lpNorm<Eigen::Infinity>(), rounding);
        EXPECT_LT((particular.balanced(exact) - expected).lpNorm<Eigen::Infinity>(), rounding);
      }
    }
  }
}

TEST(Particular_fields, have_no_part_that_is_sought)
{
  for(const Triangulation& shape : surfaces())
  {
    const Glued_surface surface(shape);
    const Operators o = operators(surface.t());
    Vector function = random_function(surface.size(), 1);
    const std::vector<bool> is_border = border_sites(surface.t());
    for(std::size_t site = 0; site < is_border.size(); ++site)
      if(is_border[site])
        function[Eigen::Index(site)] = 0.;
    const Vector turned = as_column(o, turned_left(gradient(o, function)));
    for(const Particular_field kind : both)
    {
      const Particular_fields particular(surface.t(), o, kind);
      const Matrix fields = particular.fields(some_masses(surface.size()));
      EXPECT_LT((fields.transpose() * turned).lpNorm<Eigen::Infinity>(), rounding * turned.norm());
      const Matrix around = fields.transpose() * particular.harmonic_fields();
      EXPECT_TRUE(around.size() == 0 || around.cwiseAbs().maxCoeff() < rounding);
    }
  }
}

TEST(Particular_fields, are_gradients_where_triangles_are_not_joined)
{
  const Cloud cloud = octahedron_sphere(2);
  const Glued_surfels sphere = glue_surfels(cloud.points, cloud.normals);
  const Operators o = operators(sphere.triangles);
  const Particular_fields on_cloud(sphere.triangles, o, Particular_field::raviart_thomas);
  EXPECT_EQ(on_cloud.kind(), Particular_field::gradient);
  EXPECT_EQ(on_cloud.harmonic_fields().cols(), 0);

  // Two triangles that meet in a point.
  const Glued_surface pinched(
      Triangulation{{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}},
                    {0, 1, 2, 0, 3, 4}});
  const Operators p = operators(pinched.t());
  EXPECT_EQ(Particular_fields(pinched.t(), p, Particular_field::raviart_thomas).kind(),
            Particular_field::gradient);
}

TEST(Particular_fields, lose_their_gradients)
{
  const Glued_surface surface(shaken(icosphere(2), 0.03));
  const Operators o = operators(surface.t());
  const Particular_fields particular(surface.t(), o, Particular_field::gradient);
  const Field field = random_field(o.number_of_triangles(), 1);
  const Matrix rest = particular.without_gradients(as_column(o, field));
  EXPECT_LT(divergence(o, as_field(o, rest.col(0))).lpNorm<Eigen::Infinity>(), rounding);
  EXPECT_LT(
      particular.without_gradients(as_column(o, gradient(o, random_function(surface.size(), 2))))
          .norm(),
      rounding);
}

} // namespace
