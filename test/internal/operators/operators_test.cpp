// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>
#include "core/unfold.h"

#include "Array_surface.h"
#include "clouds.h"
#include "random_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace operators_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of sums of some thousand terms of order one.
constexpr double round_off = 1e-11;

double total_area(const Operators& o) { return std::accumulate(o.area.begin(), o.area.end(), 0.); }

// Returns two squares that share a vertex, and a sphere. One of the squares has a degenerate
// triangle.
Triangulation mixed_surface()
{
  Triangulation pinched = square(3);
  Triangulation other = square(4, 0.2);
  for(Point& p : other.points)
    p = {-p[0], -p[1], p[2]};
  pinched = disjoint_union(pinched, other);
  for(Index& corner : pinched.corners)
    if(corner == 16)
      corner = 0;
  pinched.points[5] = {1. / 6., 0., 0.}; // collinear with points 0 and 1
  return disjoint_union(pinched, icosphere(1));
}

std::vector<Triangulation> surfaces()
{
  return {one_triangle(), tetrahedron(),   square(5, 0.2), cylinder(12, 4, 1., 1.),
          torus(12, 8),   double_torus(1), mixed_surface()};
}

TEST(Operators, gradient_of_linear_function_is_exact)
{
  const Array_surface surface(square(6, 0.24));
  const Operators o = operators(surface.t());
  EXPECT_NEAR(total_area(o) * surface.scale() * surface.scale(), 1., round_off);
  Vector function(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
    function[surface.vertex(i)] = (3. * surface.point(i)[0] + 4. * surface.point(i)[1] - 1.);
  for(const Vec2& vector : gradient(o, function))
    EXPECT_NEAR(norm(vector), 5. * surface.scale(), round_off);
  EXPECT_NEAR(std::sqrt(inner_product(o, gradient(o, function), gradient(o, function))), 5.,
              round_off);
}

// If the metric doubles all lengths, a gradient has half its length. In a blocked triangle it
// vanishes.
TEST(Operators, metric_scales_gradients)
{
  const Array_surface surface(square(6, 0.24));
  const std::size_t n = surface.t().number_of_triangles();
  std::vector<Metric_tensor> metric(n, Metric_tensor{2., 0., 2.});
  metric[7] = {infinity, 0., infinity};
  const Operators plain = operators(surface.t(), Degenerate_triangles::thickened);
  const Operators scaled = metric_operators(surface.t(), metric);
  const Vector function = random_function(surface.size(), 1);
  const Field slope = gradient(plain, function), scaled_slope = gradient(scaled, function);
  for(std::size_t f = 0; f < n; ++f)
  {
    const bool is_open = f != 7;
    EXPECT_EQ(scaled.area[f], is_open ? plain.area[f] : 0.);
    EXPECT_LT(norm(scaled_slope[f] + (is_open ? -0.5 : 0.) * slope[f]), round_off);
  }
  EXPECT_EQ(metric_operators(surface.t(), {}).area, plain.area);
  // inverse() must be the inverse of product().
  const Metric_tensor tensor = {3., 1., 2.};
  const Vec2 p = product(inverse(tensor), product(tensor, {0.3, -0.7}));
  EXPECT_NEAR(p[0], 0.3, round_off);
  EXPECT_NEAR(p[1], -0.7, round_off);
}

TEST(Operators, hat_gradients_match_hat_functions)
{
  const Array_surface surface(jittered(icosphere(2), 0.03));
  const Operators o = operators(surface.t());
  for(Index f = 0; f < o.number_of_triangles(); ++f)
  {
    const auto corners = unfolded(surface.t(), f);
    for(Index k = 0; k < 3; ++k)
      for(Index j = 0; j < 3; ++j) // the hat function falls from 1 at its corner to 0 at the others
        EXPECT_NEAR(dot(o.hat_gradient[3 * f + k], corners[k] - corners[j]), k == j ? 0. : 1.,
                    round_off);
  }
}

TEST(Operators, divergence_is_transpose_of_gradient)
{
  for(const Triangulation& surface : surfaces())
  {
    const Operators o = operators(Array_surface(surface).t());
    const Vector function = random_function(o.number_of_vertices, 1);
    const Field field = random_field(o.number_of_triangles(), 2);
    const Vector flux = minus_divergence(o, field);
    EXPECT_NEAR(function.dot(flux), inner_product(o, gradient(o, function), field), round_off);
    EXPECT_NEAR(flux.sum(), 0., round_off);
    // A rotation preserves inner products. Two rotations by 90 degrees change the sign.
    EXPECT_NEAR(inner_product(o, rotated_left(field), field), 0., round_off);
    EXPECT_EQ(rotated_right(field), rotated_left(rotated_left(rotated_left(field))));
    EXPECT_NEAR(inner_product(o, rotated_left(rotated_left(field)), field),
                -inner_product(o, field, field), round_off);
    EXPECT_EQ(rotated_right(rotated_left(field)), field);
  }
}

TEST(Operators, rotated_gradients_are_divergence_free)
{
  for(const Triangulation& surface : {icosphere(2), torus(12, 8), double_torus(1)})
  {
    const Operators o = operators(Array_surface(surface).t());
    const Field field = rotated_left(gradient(o, random_function(o.number_of_vertices, 3)));
    EXPECT_LT(minus_divergence(o, field).lpNorm<Eigen::Infinity>(), round_off);
  }
}

TEST(Operators, lumped_mass_sums_to_area)
{
  for(const Triangulation& surface : surfaces())
  {
    const Operators o = operators(Array_surface(surface).t());
    EXPECT_NEAR(lumped_mass(o).sum(), total_area(o), round_off);
  }
}

TEST(Operators, laplacian_is_divergence_of_gradient)
{
  for(const Triangulation& surface : surfaces())
  {
    const Operators o = operators(Array_surface(surface).t());
    // Use two tensors in alternate triangles; one is anisotropic.
    std::vector<Metric_tensor> tensors(o.number_of_triangles(), Metric_tensor{2., 0.5, 1.});
    for(std::size_t f = 0; f < tensors.size(); f += 2)
      tensors[f] = {1., 0., 1.};
    const Laplacian laplacian(o);
    Sparse_matrix matrix = laplacian.matrix(o);
    laplacian.assemble(o, tensors, matrix);

    Vector function = random_function(o.number_of_vertices, 4);
    Field field = gradient(o, function);
    for(std::size_t f = 0; f < field.size(); ++f)
      field[f] = {tensors[f][0] * field[f][0] + tensors[f][1] * field[f][1],
                  tensors[f][1] * field[f][0] + tensors[f][2] * field[f][1]};
    const Vector product = matrix.selfadjointView<Eigen::Lower>() * function;
    EXPECT_NEAR((product - minus_divergence(o, field)).norm() / product.norm(), 0., round_off);
    laplacian.pin(matrix);
    const Sparse_solver solver(matrix);
    // The solution must be equal up to a constant for each component, whose first vertex is pinned.
    const Vector solution = solver.solve(product);
    const auto [component, number_of_components] = components(o);
    std::vector<double> shift_of_component(number_of_components, infinity);
    for(Index vertex = 0; vertex < component.size(); ++vertex)
    {
      double& shift = shift_of_component[component[vertex]];
      if(shift == infinity)
        shift = function[vertex];
      // round-off error times the condition number
      EXPECT_NEAR(solution[vertex] + shift, function[vertex], 1e-9);
    }
  }
}

TEST(Operators, finds_components)
{
  const Operators o = operators(Array_surface(mixed_surface()).t());
  const auto [component, number_of_components] = components(o);
  // The two squares with a common vertex, the sphere, and one isolated vertex.
  EXPECT_EQ(number_of_components, 3u);
  for(std::size_t c = 0; c < o.corner.size(); ++c)
    EXPECT_EQ(component[o.corner[c]], component[o.corner[c - c % 3]]);
}

TEST(Operators, skips_degenerate_triangles)
{
  Triangulation surface = square(4);
  surface.points[6] = surface.points[7] = surface.points[8];
  surface = disjoint_union(surface, {{{0., 0., 0.}, {1., 0., 0.}, {2., 0., 0.}}, {0, 1, 2}});
  const Array_surface array_surface(surface);
  const Operators o = operators(array_surface.t());
  EXPECT_EQ(o.area[array_surface.triangle(32)], 0.);
  const Vector function = random_function(o.number_of_vertices, 5);
  for(const Vec2& vector : gradient(o, function))
    EXPECT_TRUE(std::isfinite(norm(vector)));
  EXPECT_EQ(gradient(o, function)[array_surface.triangle(32)], (Vec2{0., 0.}));
  EXPECT_TRUE(std::isfinite(Laplacian(o).matrix(o).norm()));
  // the square, and three isolated vertices of the degenerate triangle
  EXPECT_EQ(components(o).second, 4u);
}

TEST(Operators, cloud_area_approximates_surface_area)
{
  const Cloud cloud = octahedron_sphere(4);
  const Surfel_arrays sphere = build_surfel_arrays(cloud.points, cloud.normals);
  const Operators o = operators(sphere.arrays);
  const double scale = sphere.arrays.scale;
  // The area of the inscribed polyhedron is smaller by a relative error of about h^2 / 4, h = 0.1.
  EXPECT_NEAR(total_area(o) * scale * scale, 4. * pi, 0.01 * 4. * pi);
  EXPECT_NEAR(lumped_mass(o).sum(), total_area(o), round_off);
}

TEST(Operators, mean_magnitudes_average_incident_triangles)
{
  const Surface_arrays t = arrays_of(tetrahedron()).arrays;
  Field field(4, Vec2{0., 0.});
  field[0] = {3., 4.};
  field[1] = {0., 1.};
  const Vector lengths = mean_magnitudes(t, field);
  for(Index vertex = 0; vertex < 4; ++vertex)
  {
    double sum = 0.; // all triangles have the same area
    for(Index c = 0; c < 6; ++c)
      if(t.corner[c] == vertex)
        sum += c < 3 ? 5. : 1.;
    EXPECT_NEAR(lengths[vertex], sum / 3., 1e-15 * 8); // round-off errors of a few operations
  }
}

} // namespace operators_test
