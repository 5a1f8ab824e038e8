// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_distances.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include "Array_surface.h"
#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace make_domain_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

TEST(Make_domain, returns_domain_matching_surface_type)
{
  const Mesh mesh = mesh_of(square(2));
  const Surfels cloud = flat_surfels(100);
  const auto of_mesh = GP::make_domain(mesh);
  const auto of_cloud = GP::make_domain(
      cloud, GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  EXPECT_TRUE((std::is_same_v<decltype(of_mesh), const GP::Mesh_domain<Mesh>>));
  EXPECT_TRUE((std::is_same_v<decltype(of_cloud), const GP::Surfel_domain<Surfels>>));
  // The domain of a domain is a copy that shares its arrays.
  EXPECT_EQ(GP::make_domain(of_mesh).triangles(), of_mesh.triangles());
  EXPECT_EQ(GP::make_domain(of_cloud).triangles(), of_cloud.triangles());
}

template <typename Method>
std::vector<double> distances_on(const Triangulation& surface, Index source)
{
  Mesh mesh = mesh_of(surface);
  auto map = vertex_map(mesh);
  GP::geodesic_distances<Method>(mesh, Vertex(source), map);
  return values(mesh, map);
}

// power_tolerance  the error of factors that are no powers of two
template <typename Method>
void expect_scaled(double power_tolerance)
{
  const Triangulation surface = jittered(icosphere(2), 0.05);
  const auto d = distances_on<Method>(surface, 7);
  for(const int exponent : {-530, -20, 1, 20, 530})
  {
    const auto e = distances_on<Method>(scaled(surface, std::ldexp(1., exponent)), 7);
    for(Index i = 0; i < d.size(); ++i)
      EXPECT_EQ(e[i], std::ldexp(d[i], exponent));
  }
  for(const double factor : {1e-160, 1e-30, 1e-6, 1e6, 1e30, 1e160})
  {
    const auto e = distances_on<Method>(scaled(surface, factor), 7);
    for(Index i = 0; i < d.size(); ++i)
      EXPECT_NEAR(e[i] / factor, d[i], power_tolerance);
  }
}

TEST(Make_domain, scaling_is_exact_for_powers_of_two)
{
  // Round-off errors of the coordinates. A linear solve amplifies them by its condition number.
  expect_scaled<GP::Dijkstra>(1e-13);
  expect_scaled<GP::Fast_marching>(1e-13);
  expect_scaled<GP::Euclidean_front>(1e-12);
  expect_scaled<GP::Heat>(1e-10);
}

TEST(Make_domain, distances_are_translation_invariant)
{
  // Coordinates are multiples of 2^-20, so adding 1e8 does not round them.
  Triangulation surface = jittered(icosphere(3), 0.03);
  for(Point& p : surface.points)
    for(double& x : p)
      x = std::round(std::ldexp(x, 20)) / std::ldexp(1., 20);
  Triangulation moved = surface;
  for(Point& p : moved.points)
  {
    p[0] += 1e8;
    p[1] -= 1e8;
  }
  // Lengths are equal up to round-off errors. The center of the bounding box may differ.
  const auto d = distances_on<GP::Euclidean_front>(surface, 7),
             e = distances_on<GP::Euclidean_front>(moved, 7);
  const double round_off = 1e-12; // of some tens of lengths
  EXPECT_LT(largest_error(e, [&](Index i) { return d[i]; }), round_off);
  const auto h = distances_on<GP::Heat>(surface, 7), g = distances_on<GP::Heat>(moved, 7);
  EXPECT_LT(largest_error(g, [&](Index i) { return h[i]; }), round_off);
}

// tolerance  the round-off errors of sums in another order
template <typename Method>
void expect_permuted(double tolerance)
{
  const Triangulation surface = jittered(icosphere(3), 0.03);
  std::vector<Index> permutation(surface.points.size()), face(surface.corners.size() / 3);
  std::iota(permutation.begin(), permutation.end(), 0);
  std::iota(face.begin(), face.end(), 0);
  std::mt19937 random(3);
  std::shuffle(permutation.begin(), permutation.end(), random);
  std::shuffle(face.begin(), face.end(), random);
  Triangulation permuted;
  permuted.points.resize(permutation.size());
  for(Index i = 0; i < permutation.size(); ++i)
    permuted.points[permutation[i]] = surface.points[i];
  for(const Index f : face)
    for(int k = 0, shift = int(random() % 3); k < 3; ++k)
      permuted.corners.push_back(permutation[surface.corners[3 * f + (k + shift) % 3]]);
  const auto d = distances_on<Method>(surface, 7),
             e = distances_on<Method>(permuted, permutation[7]);
  EXPECT_LT(largest_error(d, [&](Index i) { return e[permutation[i]]; }), tolerance);
}

TEST(Make_domain, is_independent_of_vertex_and_face_order)
{
  expect_permuted<GP::Dijkstra>(1e-13);
  expect_permuted<GP::Fast_marching>(1e-13);
  expect_permuted<GP::Euclidean_front>(1e-12);
  expect_permuted<GP::Heat>(1e-10); // the elimination order differs
}

TEST(Make_domain, accepts_boundary_components_and_degenerate_faces)
{
  // Boundary, two components, an isolated vertex, a pinched vertex and faces of zero area.
  Triangulation surface = disjoint_union(square(6, 0.24), tetrahedron());
  surface.points.push_back({9., 9., 9.});
  const Index pinched_vertex = 0, n = Index(surface.points.size());
  surface.points.insert(surface.points.end(), {{-1., 0., 0.}, {-1., -1., 0.}});
  surface.corners.insert(surface.corners.end(), {pinched_vertex, n, n + 1});
  surface.points[30] = surface.points[31];
  for(Index i = 8; i < 13; ++i)
    surface.points[i][1] = surface.points[8][1];
  Mesh mesh = mesh_of(surface);
  ASSERT_EQ(mesh.number_of_faces(), surface.corners.size() / 3);
  const auto domain = GP::make_domain(mesh);
  auto map = vertex_map(mesh);
  const auto expect = [&](int i, double d)
  {
    EXPECT_FALSE(std::isnan(d));
    // The square and the pinched triangle form one component.
    const bool is_reached = i < 49 || i > 53;
    EXPECT_EQ(d < infinity, is_reached) << "vertex " << i;
  };
  const auto check = [&]
  {
    const auto d = values(mesh, map);
    for(std::size_t i = 0; i < d.size(); ++i)
      expect(int(i), d[i]);
  };
  GP::geodesic_distances<GP::Dijkstra>(domain, Vertex(3), map);
  check();
  GP::geodesic_distances<GP::Fast_marching>(domain, Vertex(3), map);
  check();
  GP::geodesic_distances<GP::Euclidean_front>(domain, Vertex(3), map);
  check();
  GP::geodesic_distances<GP::Heat>(domain, Vertex(3), map);
  check();
}

} // namespace make_domain_test
