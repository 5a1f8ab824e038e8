// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_diameter.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"
#include "rough_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_diameter_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Relative errors of exact distances are 2e-12.
constexpr double round_off = 1e-11;

TEST(geodesic_eccentricity, of_a_corner_is_the_diagonal)
{
  const Mesh mesh = mesh_of(square(8, 0.2));
  const auto eccentricity = GP::geodesic_eccentricity(mesh, Vertex(0));
  EXPECT_NEAR(eccentricity.value, std::sqrt(2.), round_off);
  EXPECT_EQ(eccentricity.farthest, Vertex(80));
  // Paths along edges are longer.
  EXPECT_GT(GP::geodesic_eccentricity<GP::Dijkstra>(mesh, Vertex(0)).value, eccentricity.value);
  // The distance from the nearest of all four corners.
  const std::vector<Vertex> corners = {Vertex(0), Vertex(8), Vertex(72), Vertex(80)};
  EXPECT_LT(GP::geodesic_eccentricity(mesh, corners).value, std::sqrt(0.5) + round_off);
}

TEST(geodesic_eccentricity, ignores_other_components)
{
  const Mesh mesh = mesh_of(disjoint_union(square(2), scaled(square(2), 9.)));
  EXPECT_NEAR(GP::geodesic_eccentricity(mesh, Vertex(0)).value, std::sqrt(2.), round_off);
}

TEST(geodesic_eccentricity, accepts_clouds)
{
  CGAL::Point_set_3<Kernel::Point_3> cloud;
  cloud.add_normal_map();
  for(const auto& [point, normal] : sphere_surfels(3))
    cloud.insert(point, normal);
  const auto eccentricity = GP::geodesic_eccentricity(cloud, *cloud.begin());
  // The antipodal point. The front on a cloud of 642 surfels is accurate to 1 %.
  EXPECT_NEAR(eccentricity.value, pi, 0.03);
  EXPECT_NEAR(std::sqrt(CGAL::squared_distance(cloud.point(*cloud.begin()),
                                               cloud.point(eccentricity.farthest))),
              2., 0.01);
}

TEST(geodesic_diameter, of_a_square_is_the_diagonal)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Mesh mesh = mesh_of(scaled(square(8, 0.2), scale));
    const auto diameter = GP::geodesic_diameter(mesh, GP::parameters::relative_tolerance(0.));
    EXPECT_TRUE(diameter.is_converged);
    EXPECT_NEAR(diameter.lower / scale, std::sqrt(2.), round_off);
    EXPECT_NEAR(diameter.upper / scale, std::sqrt(2.), round_off);
    EXPECT_NEAR(
        std::sqrt(CGAL::squared_distance(mesh.point(diameter.from), mesh.point(diameter.to))) /
            scale,
        std::sqrt(2.), round_off);
  }
}

TEST(geodesic_radius, of_a_square_is_half_of_the_diagonal)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    // Vertex 40 is in the center.
    const Mesh mesh = mesh_of(scaled(square(8), scale));
    const auto radius = GP::geodesic_radius(mesh, GP::parameters::relative_tolerance(0.));
    EXPECT_TRUE(radius.is_converged);
    EXPECT_EQ(radius.center, Vertex(40));
    EXPECT_NEAR(radius.lower / scale, std::sqrt(0.5), round_off);
    EXPECT_NEAR(radius.upper / scale, std::sqrt(0.5), round_off);
  }
}

// On a sphere all eccentricities are pi. Bounds from the covering radius of samples would need
// hundreds of samples for 1 %.
TEST(geodesic_diameter, of_a_sphere_takes_few_iterations)
{
  const auto diameter = GP::geodesic_diameter(mesh_of(icosphere(4)));
  EXPECT_TRUE(diameter.is_converged);
  // The distances on the inscribed polyhedron are shorter by O(h^2), at most 0.5 %.
  EXPECT_LT(diameter.lower, pi);
  EXPECT_GT(diameter.upper, 0.995 * pi);
  EXPECT_LE(diameter.upper, 1.01 * diameter.lower);
  EXPECT_LT(diameter.number_of_iterations, 30u);
}

std::vector<std::pair<std::string, Triangulation>> models()
{
  std::vector<std::pair<std::string, Triangulation>> result = {
      {"square", square(12, 0.24)},
      {"graded square", graded_square(10)},
      {"slit", rectangle_with_slit(8)},
      {"sphere", icosphere(2)},
      {"torus", torus(20, 10)},
      {"cylinder", cylinder(12, 8, 1., 3.)},
      {"annulus", annulus(20, 4, 1., 2.)},
      {"cone", cone(9, 6, 4.)},
      {"saddle", cone(10, 6, 8.)},
      {"double torus", double_torus(2)},
      {"knot", knot(60, 5)},
      {"animal", animal(2)},
      {"spool", spool(8)},
      {"blocks", blocks(3, 2, 2, [](int, int, int) { return true; })},
      {"jittered sphere", jittered(icosphere(2), 0.02)},
      {"two spheres", disjoint_union(icosphere(1), scaled(icosphere(2), 0.9))}};
  add_models(result, {"meshes/joint_221.off", "meshes/pig_468.off", "meshes/spool_649.off",
                      "meshes/pinion_650.off"});
  return result;
}

// An interval from farthest point samples would be [e, e + r] for the largest eccentricity e of the
// samples and their covering radius r. The bounds here are compared with all pairs of vertices.
TEST(geodesic_diameter, bounds_contain_the_largest_distance_of_all_pairs)
{
  for(const auto& [name, triangulation] : models())
  {
    SCOPED_TRACE(name);
    const Mesh mesh = mesh_of(triangulation);
    GP::Geodesic_distance_solver<Mesh> solver(mesh);
    double largest = 0., smallest = GP::internal::infinity;
    for(const Vertex from : mesh.vertices())
    {
      solver.compute(from);
      double eccentricity = 0.;
      for(const Vertex to : solver.reached())
        eccentricity = std::max(eccentricity, solver.distance(to));
      largest = std::max(largest, eccentricity);
      smallest = std::min(smallest, eccentricity);
    }
    const auto diameter = GP::geodesic_diameter(mesh);
    EXPECT_TRUE(diameter.is_converged);
    EXPECT_LE(diameter.lower, largest * (1. + round_off));
    EXPECT_GE(diameter.upper, largest * (1. - round_off));
    EXPECT_LE(diameter.upper, diameter.lower * (1.01 + round_off));
    if(name == "two spheres")
      continue; // The radius is that of the component with the larger radius.
    const auto radius = GP::geodesic_radius(mesh);
    EXPECT_LE(radius.lower, smallest * (1. + round_off));
    EXPECT_GE(radius.upper, smallest * (1. - round_off));
  }
}

TEST(geodesic_diameter, accepts_polyhedra_and_domains)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Numbered<Polyhedron> mesh;
  fill(mesh, square(6, 0.2));
  const auto np = GP::parameters::relative_tolerance(0.);
  const auto diameter = GP::geodesic_diameter(mesh.mesh, np);
  EXPECT_NEAR(diameter.lower, std::sqrt(2.), round_off);
  EXPECT_EQ(GP::geodesic_diameter(GP::make_domain(mesh.mesh), np).upper, diameter.upper);
  EXPECT_GT(GP::geodesic_radius(mesh.mesh).lower, 0.);
}

TEST(geodesic_diameter, throws_on_invalid_input)
{
  const Mesh mesh = mesh_of(square(2));
  const auto invalid = {GP::parameters::relative_tolerance(-1.),
                        GP::parameters::relative_tolerance(std::nan(""))};
  for(const auto& np : invalid)
  {
    EXPECT_THROW(GP::geodesic_diameter(mesh, np), GP::Invalid_argument_error);
    EXPECT_THROW(GP::geodesic_radius(mesh, np), GP::Invalid_argument_error);
  }
  EXPECT_THROW(GP::geodesic_diameter(mesh, GP::parameters::maximum_number_of_iterations(0)),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_diameter(mesh, GP::parameters::callback([](double) { return false; })),
               GP::Cancelled);
  EXPECT_THROW(GP::geodesic_diameter(Mesh()), GP::Unsupported_surface_error);
}

} // namespace geodesic_diameter_test
