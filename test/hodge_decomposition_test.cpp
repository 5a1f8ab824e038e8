// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/hodge_decomposition.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Vector_3 = Kernel::Vector_3;

// Of some hundred sums.
constexpr double rounding = 1e-9;

struct Parts
{
  Mesh mesh;
  Mesh::Property_map<Face, Vector_3> field, gradient, rotation, harmonic;

  explicit Parts(const Triangulation& shape) : mesh(mesh_of(shape))
  {
    const auto add = [&](const char* name)
    { return mesh.add_property_map<Face, Vector_3>(name, Vector_3(0., 0., 0.)).first; };
    field = add("f:field");
    gradient = add("f:gradient");
    rotation = add("f:rotation");
    harmonic = add("f:harmonic");
  }
  Vector_3 normal(Face f) const // of twice the area
  {
    const auto h = mesh.halfedge(f);
    const auto &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
               &r = mesh.point(mesh.target(mesh.next(h)));
    return CGAL::cross_product(q - p, r - p);
  }
  Kernel::Point_3 center(Face f) const
  {
    const auto h = mesh.halfedge(f);
    return CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                          mesh.point(mesh.target(mesh.next(h))));
  }
  void decompose() { GP::hodge_decomposition(mesh, field, gradient, rotation, harmonic); }
  template <typename A, typename B>
  double product(const A& a, const B& b) const
  {
    double result = 0.;
    for(const Face f : mesh.faces())
      result += 0.5 * std::sqrt(normal(f).squared_length()) * (a[f] * b[f]);
    return result;
  }
  double size(const Mesh::Property_map<Face, Vector_3>& a) const
  {
    return std::sqrt(product(a, a));
  }
};

// The way up is a gradient, the way around the axis a rotation, on a sphere.
TEST(hodge_decomposition, knows_gradients_from_rotations)
{
  Parts up(icosphere(3)), around(icosphere(3));
  for(const Face f : up.mesh.faces())
  {
    up.field[f] = Vector_3(0., 0., 1.); // the normal part is none of the field's
    const auto c = up.center(f);
    around.field[f] = Vector_3(-c.y(), c.x(), 0.);
  }
  up.decompose();
  EXPECT_LT(up.size(up.rotation), rounding);
  EXPECT_LT(up.size(up.harmonic), rounding);
  EXPECT_NEAR(up.product(up.gradient, up.field), up.product(up.gradient, up.gradient), rounding);
  EXPECT_NEAR(up.size(up.gradient), std::sqrt(8. * GP::internal::pi / 3.), 0.05); // flat triangles
  around.decompose();
  // The field in the middle of a triangle is that of a sphere to the square of a side, 0.16.
  EXPECT_LT(around.size(around.gradient), 0.03 * around.size(around.field));
  EXPECT_LT(around.size(around.harmonic), rounding);
}

// Around a ring nothing begins or ends; in one that is open there are harmonic fields as well.
TEST(hodge_decomposition, finds_what_winds_around_holes)
{
  for(const Triangulation& shape :
      {torus(32, 16), cylinder(24, 8, 1., 1.), annulus(24, 6, 0.5, 1.)})
  {
    Parts parts(shape);
    for(const Face f : parts.mesh.faces())
    {
      const auto c = parts.center(f);
      const double square = c.x() * c.x() + c.y() * c.y();
      parts.field[f] = Vector_3(-c.y() / square, c.x() / square, 0.);
    }
    parts.decompose();
    // Triangles of twentieths of a turn.
    EXPECT_GT(parts.size(parts.harmonic), 0.99 * parts.size(parts.field));
    EXPECT_LT(std::abs(parts.product(parts.gradient, parts.harmonic)), rounding);
    EXPECT_LT(std::abs(parts.product(parts.gradient, parts.rotation)), rounding);
    EXPECT_LT(std::abs(parts.product(parts.rotation, parts.harmonic)), rounding);
    for(const Face f : parts.mesh.faces())
    {
      const Vector_3 n = parts.normal(f) / std::sqrt(parts.normal(f).squared_length());
      const Vector_3 tangent = parts.field[f] - (parts.field[f] * n) * n;
      const Vector_3 rest = tangent - parts.gradient[f] - parts.rotation[f] - parts.harmonic[f];
      EXPECT_LT(rest.squared_length(), rounding * rounding);
    }
  }
}

TEST(hodge_decomposition, refuses_what_is_not_finite)
{
  Parts parts(icosphere(1));
  parts.field[Face(7)] = Vector_3(std::nan(""), 0., 0.);
  EXPECT_THROW(parts.decompose(), GP::Invalid_argument_error);
}

} // namespace
