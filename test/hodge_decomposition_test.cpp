// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/hodge_decomposition.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hodge_decomposition_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Vector_3 = Kernel::Vector_3;

// Round-off errors of some hundred sums.
constexpr double round_off = 1e-9;

struct Decomposition
{
  Mesh mesh;
  Mesh::Property_map<Face, Vector_3> field, gradient, rotation, harmonic;

  explicit Decomposition(const Triangulation& shape) : mesh(mesh_of(shape))
  {
    const auto add = [&](const char* name)
    { return mesh.add_property_map<Face, Vector_3>(name, Vector_3(0., 0., 0.)).first; };
    field = add("f:field");
    gradient = add("f:gradient");
    rotation = add("f:rotation");
    harmonic = add("f:harmonic");
  }
  Vector_3 normal(Face f) const // length is twice the area
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

// On a sphere, the upward field is a gradient and the field around the axis is a rotation.
TEST(hodge_decomposition, separates_gradients_and_rotations)
{
  Decomposition upward(icosphere(3)), rotating(icosphere(3));
  for(const Face f : upward.mesh.faces())
  {
    upward.field[f] = Vector_3(0., 0., 1.); // the normal component is not part of the field
    const auto c = upward.center(f);
    rotating.field[f] = Vector_3(-c.y(), c.x(), 0.);
  }
  upward.decompose();
  EXPECT_LT(upward.size(upward.rotation), round_off);
  EXPECT_LT(upward.size(upward.harmonic), round_off);
  EXPECT_NEAR(upward.product(upward.gradient, upward.field),
              upward.product(upward.gradient, upward.gradient), round_off);
  EXPECT_NEAR(upward.size(upward.gradient), std::sqrt(8. * GP::internal::pi / 3.),
              0.05); // faces are flat
  rotating.decompose();
  // The field at a face center differs from that of the sphere by O(h^2), with edge length
  // h = 0.16.
  EXPECT_LT(rotating.size(rotating.gradient), 0.03 * rotating.size(rotating.field));
  EXPECT_LT(rotating.size(rotating.harmonic), round_off);
}

// A field around a torus has no divergence. On an open ring there are harmonic fields as well.
TEST(hodge_decomposition, finds_harmonic_fields)
{
  for(const Triangulation& shape :
      {torus(32, 16), cylinder(24, 8, 1., 1.), annulus(24, 6, 0.5, 1.)})
  {
    Decomposition decomposition(shape);
    for(const Face f : decomposition.mesh.faces())
    {
      const auto c = decomposition.center(f);
      const double squared_radius = c.x() * c.x() + c.y() * c.y();
      decomposition.field[f] = Vector_3(-c.y() / squared_radius, c.x() / squared_radius, 0.);
    }
    decomposition.decompose();
    // Faces span a twentieth of a turn.
    EXPECT_GT(decomposition.size(decomposition.harmonic),
              0.99 * decomposition.size(decomposition.field));
    EXPECT_LT(std::abs(decomposition.product(decomposition.gradient, decomposition.harmonic)),
              round_off);
    EXPECT_LT(std::abs(decomposition.product(decomposition.gradient, decomposition.rotation)),
              round_off);
    EXPECT_LT(std::abs(decomposition.product(decomposition.rotation, decomposition.harmonic)),
              round_off);
    for(const Face f : decomposition.mesh.faces())
    {
      const Vector_3 n =
          decomposition.normal(f) / std::sqrt(decomposition.normal(f).squared_length());
      const Vector_3 tangent = decomposition.field[f] - (decomposition.field[f] * n) * n;
      const Vector_3 residual = tangent - decomposition.gradient[f] - decomposition.rotation[f] -
                                decomposition.harmonic[f];
      EXPECT_LT(residual.squared_length(), round_off * round_off);
    }
  }
}

TEST(hodge_decomposition, throws_on_non_finite_field)
{
  Decomposition decomposition(icosphere(1));
  decomposition.field[Face(7)] = Vector_3(std::nan(""), 0., 0.);
  EXPECT_THROW(decomposition.decompose(), GP::Invalid_argument_error);
}

} // namespace hodge_decomposition_test
