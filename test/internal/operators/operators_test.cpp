// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>
#include "core/unfold.h"

#include "Glued_surface.h"
#include "clouds.h"
#include "random_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Sums of some thousand terms of a size about one.
constexpr double rounding = 1e-11;

double total_area(const Operators& o) { return std::accumulate(o.area.begin(), o.area.end(), 0.); }

// Two squares that share a point, of which one has a triangle without area, and a sphere.
Triangulation mixture()
{
  Triangulation pinched = square(3);
  Triangulation other = square(4, 0.2);
  for(Point& p : other.points)
    p = {-p[0], -p[1], p[2]};
  pinched = apart(pinched, other);
  for(Index& corner : pinched.corners)
    if(corner == 16)
      corner = 0;
  pinched.points[5] = {1. / 6., 0., 0.}; // between points 0 and 1
  return apart(pinched, icosphere(1));
}

std::vector<Triangulation> surfaces()
{
  return {one_triangle(), tetrahedron(),  square(5, 0.2), cylinder(12, 4, 1., 1.),
          torus(12, 8),   double_ring(1), mixture()};
}

TEST(Operators, differentiate_linear_functions_of_the_plane)
{
  const Glued_surface surface(square(6, 0.24));
  const Operators o = operators(surface.t());
  EXPECT_NEAR(total_area(o) * surface.scale() * surface.scale(), 1., rounding);
  Vector function(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
    function[surface.site(i)] = (3. * surface.point(i)[0] + 4. * surface.point(i)[1] - 1.);
  for(const Planar& vector : gradient(o, function))
    EXPECT_NEAR(norm(vector), 5. * surface.scale(), rounding);
  EXPECT_NEAR(std::sqrt(inner_product(o, gradient(o, function), gradient(o, function))), 5.,
              rounding);
}

// A gradient is what changes by measured length: half where lengths are twice as long, and nothing where nothing
// passes.
TEST(Operators, measure_lengths)
{
  const Glued_surface surface(square(6, 0.24));
  const std::size_t n = surface.t().number_of_triangles();
  std::vector<Tensor> measure(n, Tensor{2., 0., 2.});
  measure[7] = {infinity, 0., infinity};
  const Operators plain = operators(surface.t(), Flat_triangles::raised);
  const Operators measured = measured_operators(surface.t(), measure);
  const Vector function = random_function(surface.size(), 1);
  const Field slope = gradient(plain, function), half = gradient(measured, function);
  for(std::size_t f = 0; f < n; ++f)
  {
    const bool is_open = f != 7;
    EXPECT_EQ(measured.area[f], is_open ? plain.area[f] : 0.);
    EXPECT_LT(norm(half[f] + (is_open ? -0.5 : 0.) * slope[f]), rounding);
  }
  EXPECT_EQ(measured_operators(surface.t(), {}).area, plain.area);
  // The inverse of a tensor undoes its product.
  const Tensor tensor = {3., 1., 2.};
  const Planar p = product(inverse(tensor), product(tensor, {0.3, -0.7}));
  EXPECT_NEAR(p[0], 0.3, rounding);
  EXPECT_NEAR(p[1], -0.7, rounding);
}

TEST(Operators, know_hat_functions)
{
  const Glued_surface surface(shaken(icosphere(2), 0.03));
  const Operators o = operators(surface.t());
  for(Index f = 0; f < o.number_of_triangles(); ++f)
  {
    const auto place = unfolded(surface.t(), f);
    for(Index k = 0; k < 3; ++k)
      for(Index j = 0; j < 3; ++j) // falls by one from its corner to the others
        EXPECT_NEAR(dot(o.hat[3 * f + k], place[k] - place[j]), k == j ? 0. : 1., rounding);
  }
}

TEST(Operators, divergence_is_the_transpose_of_the_gradient)
{
  for(const Triangulation& surface : surfaces())
  {
    const Operators o = operators(Glued_surface(surface).t());
    const Vector function = random_function(o.number_of_sites, 1);
    const Field field = random_field(o.number_of_triangles(), 2);
    const Vector flux = divergence(o, field);
    EXPECT_NEAR(function.dot(flux), inner_product(o, gradient(o, function), field), rounding);
    EXPECT_NEAR(flux.sum(), 0., rounding);
    // A turn preserves products, and two of them are a reflection.
    EXPECT_NEAR(inner_product(o, turned_left(field), field), 0., rounding);
    EXPECT_NEAR(inner_product(o, turned_left(turned_left(field)), field),
                -inner_product(o, field, field), rounding);
  }
}

TEST(Operators, rotated_gradients_have_no_divergence)
{
  for(const Triangulation& surface : {icosphere(2), torus(12, 8), double_ring(1)})
  {
    const Operators o = operators(Glued_surface(surface).t());
    const Field field = turned_left(gradient(o, random_function(o.number_of_sites, 3)));
    EXPECT_LT(divergence(o, field).lpNorm<Eigen::Infinity>(), rounding);
  }
}

TEST(Operators, mass_is_area)
{
  for(const Triangulation& surface : surfaces())
  {
    const Operators o = operators(Glued_surface(surface).t());
    EXPECT_NEAR(lumped_mass(o).sum(), total_area(o), rounding);
  }
}

TEST(Operators, laplacian_is_divergence_of_gradient)
{
  for(const Triangulation& surface : surfaces())
  {
    const Operators o = operators(Glued_surface(surface).t());
    // Two tensors in turns, one not isotropic.
    std::vector<Tensor> tensors(o.number_of_triangles(), Tensor{2., 0.5, 1.});
    for(std::size_t f = 0; f < tensors.size(); f += 2)
      tensors[f] = {1., 0., 1.};
    const Laplacian laplacian(o);
    Sparse_matrix matrix = laplacian.matrix(o);
    laplacian.assemble(o, tensors, matrix);

    Vector function = random_function(o.number_of_sites, 4);
    Field field = gradient(o, function);
    for(std::size_t f = 0; f < field.size(); ++f)
      field[f] = {tensors[f][0] * field[f][0] + tensors[f][1] * field[f][1],
                  tensors[f][1] * field[f][0] + tensors[f][2] * field[f][1]};
    const Vector product = matrix.selfadjointView<Eigen::Lower>() * function;
    EXPECT_NEAR((product - divergence(o, field)).norm() / product.norm(), 0., rounding);
    laplacian.hold(matrix);
    const Sparse_solver solver(matrix);
    // The same up to a constant for each component, of which the first site is held at zero.
    const Vector solution = solver.solve(product);
    const auto [component, number] = components(o);
    std::vector<double> constant(number, infinity);
    for(Index site = 0; site < component.size(); ++site)
    {
      double& shift = constant[component[site]];
      if(shift == infinity)
        shift = function[site];
      EXPECT_NEAR(solution[site] + shift, function[site], 1e-9); // rounding times the condition
    }
  }
}

TEST(Operators, knows_components)
{
  const Operators o = operators(Glued_surface(mixture()).t());
  const auto [component, number] = components(o);
  // The two squares that meet in a point, the sphere, and the point that this left over.
  EXPECT_EQ(number, 3u);
  for(std::size_t c = 0; c < o.corner.size(); ++c)
    EXPECT_EQ(component[o.corner[c]], component[o.corner[c - c % 3]]);
}

TEST(Operators, leave_out_triangles_without_area)
{
  Triangulation surface = square(4);
  surface.points[6] = surface.points[7] = surface.points[8];
  surface = apart(surface, {{{0., 0., 0.}, {1., 0., 0.}, {2., 0., 0.}}, {0, 1, 2}});
  const Glued_surface glued_surface(surface);
  const Operators o = operators(glued_surface.t());
  EXPECT_EQ(o.area[glued_surface.triangle(32)], 0.);
  const Vector function = random_function(o.number_of_sites, 5);
  for(const Planar& vector : gradient(o, function))
    EXPECT_TRUE(std::isfinite(norm(vector)));
  EXPECT_EQ(gradient(o, function)[glued_surface.triangle(32)], (Planar{0., 0.}));
  EXPECT_TRUE(std::isfinite(Laplacian(o).matrix(o).norm()));
  EXPECT_EQ(components(o).second, 4u); // the square, and the three points of the flat triangle
}

TEST(Operators, weigh_the_triangles_of_a_cloud)
{
  const Cloud cloud = octahedron_sphere(4);
  const Glued_surfels sphere = glue_surfels(cloud.points, cloud.normals);
  const Operators o = operators(sphere.triangles);
  const double scale = sphere.triangles.scale;
  // The polyhedron's area is less than the sphere's by about h^2 / 4, h = 0.1.
  EXPECT_NEAR(total_area(o) * scale * scale, 4. * pi, 0.01 * 4. * pi);
  EXPECT_NEAR(lumped_mass(o).sum(), total_area(o), rounding);
}

TEST(operators, mean_lengths_are_those_of_the_triangles_around)
{
  const Glued_triangles t = glued(tetrahedron()).triangles;
  Field field(4, Planar{0., 0.});
  field[0] = {3., 4.};
  field[1] = {0., 1.};
  const Vector lengths = mean_lengths(t, field);
  for(Index site = 0; site < 4; ++site)
  {
    double sum = 0.; // of equal areas
    for(Index c = 0; c < 6; ++c)
      if(t.corner[c] == site)
        sum += c < 3 ? 5. : 1.;
    EXPECT_NEAR(lengths[site], sum / 3., 1e-15 * 8); // a few roundings
  }
}

} // namespace
