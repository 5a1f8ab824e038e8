// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/hodge.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "operators/harmonic_fields.h"
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include "Array_surface.h"
#include "clouds.h"
#include "random_values.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

namespace hodge_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of the solutions of systems with some hundred unknowns.
constexpr double round_off = 1e-9;

std::vector<Field> harmonic_basis(const Array_surface& surface, const Operators& o)
{
  return harmonic_fields(surface.t(), o, Poisson_solver(o));
}

// Returns the dimension of the span of the projections of random fields. Their number is the
// dimension of all fields.
template <typename Projection>
Eigen::Index dimension(const Operators& o, const Projection& projection)
{
  const Eigen::Index n = 2 * Eigen::Index(o.number_of_triangles());
  Eigen::MatrixXd columns(n, n);
  for(Eigen::Index i = 0; i < n; ++i)
  {
    const Field field = projection(random_field(o.number_of_triangles(), unsigned(i)));
    for(std::size_t f = 0; f < field.size(); ++f)
      for(std::size_t k = 0; k < 2; ++k)
        columns(Eigen::Index(2 * f + k), i) = field[f][k];
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  // Round-off errors are far below this limit, and the entries of random fields far above.
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
          {double_torus(1), 4},
          {disjoint_union(torus(6, 4), cylinder(6, 2, 1., 1.)), 3}};
}

TEST(Hodge, components_are_orthogonal_and_sum_to_field)
{
  for(const auto& [surface, harmonic] : cases())
  {
    const Array_surface array_surface(surface);
    const Operators o = operators(array_surface.t());
    const Field field = random_field(o.number_of_triangles(), 7);
    const Hodge_components components_of_field =
        Hodge_solver(array_surface.t(), o).decompose(field);
    EXPECT_NEAR(inner_product(o, components_of_field.gradient, components_of_field.rotation), 0.,
                round_off);
    EXPECT_NEAR(inner_product(o, components_of_field.gradient, components_of_field.harmonic), 0.,
                round_off);
    EXPECT_NEAR(inner_product(o, components_of_field.rotation, components_of_field.harmonic), 0.,
                round_off);
    // The remainder after projection onto the harmonic fields must vanish.
    Field remainder = components_of_field.harmonic;
    for(const Field& basis : harmonic_basis(array_surface, o))
    {
      const double coefficient = inner_product(o, remainder, basis);
      for(std::size_t f = 0; f < remainder.size(); ++f)
        remainder[f] = remainder[f] - coefficient * basis[f];
    }
    EXPECT_NEAR(inner_product(o, remainder, remainder), 0., round_off);
  }
}

TEST(Hodge, projections_are_idempotent)
{
  const Array_surface surface(double_torus(1));
  const Operators o = operators(surface.t());
  const Operators edge_operators = crouzeix_raviart_operators(surface.t(), o);
  const Hodge_solver solver(surface.t(), o);
  const auto expect_same = [&](Field a, const Field& b)
  {
    for(std::size_t f = 0; f < a.size(); ++f)
      a[f] = a[f] - b[f];
    EXPECT_NEAR(inner_product(o, a, a), 0., round_off);
  };
  const Field gradients =
      gradient(o, Vector::LinSpaced(Eigen::Index(o.number_of_vertices), 0., 1.));
  expect_same(solver.decompose(gradients).gradient, gradients);
  const Field rotated = rotated_left(gradient(
      edge_operators, Vector::LinSpaced(Eigen::Index(edge_operators.number_of_vertices), 0., 1.)));
  expect_same(solver.decompose(rotated).rotation, rotated);
  for(const Field& field : harmonic_basis(surface, o))
    expect_same(solver.decompose(field).harmonic, field);
}

TEST(Hodge, component_dimensions_match_topology)
{
  for(const auto& [surface, harmonic] : cases())
  {
    const Array_surface array_surface(surface);
    const Surface_arrays& t = array_surface.t();
    const Operators o = operators(t);
    const Hodge_solver solver(t, o);
    const auto [component, number_of_components] = components(o);
    std::vector<bool> has_boundary(number_of_components, false);
    Eigen::Index inner_edges = 0, closed_components = 0;
    for(std::size_t h = 0; h < t.twin.size(); ++h)
    {
      inner_edges += t.twin[h] != none && h < t.twin[h];
      if(t.twin[h] == none)
        has_boundary[component[t.corner[h]]] = true;
    }
    for(const bool is_open : has_boundary)
      closed_components += !is_open;
    const auto gradients =
        dimension(o, [&](const Field& x) { return solver.decompose(x).gradient; });
    const auto rotations =
        dimension(o, [&](const Field& x) { return solver.decompose(x).rotation; });
    EXPECT_EQ(gradients, Eigen::Index(o.number_of_vertices - number_of_components));
    EXPECT_EQ(rotations, inner_edges - closed_components);
    EXPECT_EQ(dimension(o, [&](const Field& x) { return solver.decompose(x).harmonic; }), harmonic);
    EXPECT_EQ(gradients + rotations + harmonic, 2 * Eigen::Index(o.number_of_triangles()));
  }
}

TEST(Hodge, components_are_gradients_of_normalized_potentials)
{
  for(const auto& [surface, harmonic] : cases())
  {
    const Array_surface array_surface(surface);
    const Surface_arrays& t = array_surface.t();
    const Operators o = operators(t);
    const Field field = random_field(o.number_of_triangles(), 7);
    const Hodge_components found = Hodge_solver(t, o).decompose(field);
    const Field gradients = gradient(o, found.gradient_potential);
    // The gradients of the hat functions of edges are minus two times those of opposite corners.
    Field rotations(o.number_of_triangles(), Vec2{0., 0.});
    for(Index h = 0; h < t.corner.size(); ++h)
      rotations[h / 3] = rotations[h / 3] +
                         (-2. * found.rotation_potential[h]) * o.hat_gradient[previous_halfedge(h)];
    rotations = rotated_left(rotations);
    for(std::size_t f = 0; f < field.size(); ++f)
    {
      EXPECT_LT(norm(gradients[f] - found.gradient[f]), round_off);
      EXPECT_LT(norm(rotations[f] - found.rotation[f]), round_off);
    }
    const auto [component, number] = components(o);
    std::vector<double> integral(number, 0.), edge_integral(number, 0.);
    std::vector<bool> has_boundary(number, false);
    const Vector mass = lumped_mass(o);
    for(Index i = 0; i < component.size(); ++i)
      integral[component[i]] += mass[i] * found.gradient_potential[i];
    for(Index h = 0; h < t.corner.size(); ++h)
    {
      edge_integral[component[t.corner[h]]] += o.area[h / 3] / 3. * found.rotation_potential[h];
      if(t.twin[h] == none)
      {
        has_boundary[component[t.corner[h]]] = true;
        EXPECT_EQ(found.rotation_potential[h], 0.);
      }
      else
      {
        EXPECT_EQ(found.rotation_potential[h], found.rotation_potential[t.twin[h]]);
      }
    }
    for(std::size_t c = 0; c < number; ++c)
    {
      EXPECT_NEAR(integral[c], 0., round_off);
      if(!has_boundary[c])
      {
        EXPECT_NEAR(edge_integral[c], 0., round_off);
      }
    }
  }
}

// The residual of a projection is orthogonal to the space: to the rotated gradients of all hat
// functions of inner vertices.
TEST(Hodge, vertex_rotation_potential_is_the_closest_function)
{
  for(const auto& [surface, harmonic] : cases())
  {
    const Array_surface array_surface(surface);
    const Surface_arrays& t = array_surface.t();
    const Operators o = operators(t);
    const Field field = random_field(o.number_of_triangles(), 7);
    const Vector potential = vertex_rotation_potential(t, o, field);
    std::vector<bool> is_inner(o.number_of_vertices, true);
    for(Index h = 0; h < t.corner.size(); ++h)
      if(t.twin[h] == none)
        is_inner[t.corner[h]] = is_inner[t.corner[next_halfedge(h)]] = false;
    Field residual = rotated_left(gradient(o, potential));
    for(std::size_t f = 0; f < residual.size(); ++f)
      residual[f] = field[f] - residual[f];
    const Vector products = minus_divergence(o, rotated_right(residual));
    for(Index i = 0; i < is_inner.size(); ++i)
      EXPECT_NEAR(is_inner[i] ? products[i] : potential[i], 0., round_off);
  }
}

TEST(Hodge, throws_on_cloud)
{
  const Cloud cloud = octahedron_sphere(2);
  const Surfel_arrays sphere = build_surfel_arrays(cloud.points, cloud.normals);
  EXPECT_THROW(Hodge_solver(sphere.arrays, operators(sphere.arrays)), Unsupported_surface_error);
  EXPECT_THROW(vertex_rotation_potential(sphere.arrays, operators(sphere.arrays),
                                         Field(sphere.arrays.number_of_triangles())),
               Unsupported_surface_error);
}

// Two copies of a surfel have the mean of their fields, and a surfel without triangles has none.
TEST(gradient_and_remainder, represents_coincident_surfels_by_their_mean)
{
  Cloud cloud = square_cloud(12);
  std::vector<Vec3> field(cloud.size(), Vec3{1., 2., 0.});
  const std::size_t original = 40, copy = cloud.size(), outlier = copy + 1;
  cloud.add(cloud.points[original], cloud.normals[original]);
  cloud.add({0., 0., 50.}, {0., 0., 1.});
  field[original] = {0., 2., 0.};
  field.push_back({2., 2., 0.});
  field.push_back({3., 4., 5.});
  const Surfel_arrays surfels = build_surfel_arrays(cloud.points, cloud.normals);
  std::vector<Vec3> permuted(field.size());
  for(std::size_t i = 0; i < field.size(); ++i)
    permuted[surfels.internal_vertex[i]] = field[i];
  const Surfel_field_components result = gradient_and_remainder(surfels.arrays, permuted);
  for(std::size_t i = 0; i < outlier; ++i)
  {
    const Vec3 gradient = result.gradient[surfels.internal_vertex[i]],
               remainder = result.remainder[surfels.internal_vertex[i]];
    // The mean field is constant, hence the gradient of a linear function.
    EXPECT_LT(norm(gradient - Vec3{1., 2., 0.}), round_off);
    EXPECT_LT(norm(gradient + remainder - field[i]), round_off);
  }
  EXPECT_EQ(result.gradient[surfels.internal_vertex[outlier]], (Vec3{0., 0., 0.}));
  EXPECT_EQ(result.remainder[surfels.internal_vertex[outlier]], (Vec3{3., 4., 0.}));
}

TEST(gradient_and_remainder, throws_on_mesh)
{
  const Array_surface surface(tetrahedron());
  EXPECT_THROW(gradient_and_remainder(surface.t(), std::vector<Vec3>(4)),
               Unsupported_surface_error);
}

} // namespace hodge_test
