// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/fuzzy_geodesic.h>

#include <CGAL/Point_set_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fuzzy_geodesic_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Round-off errors of sums of two distances.
constexpr double round_off = 1e-9;

// In the plane, a Gaussian density moves as a whole. Halfway, the flow has the profile of the
// density.
TEST(fuzzy_geodesic, width_matches_gaussian_densities)
{
  Mesh mesh = mesh_of(square(60));
  const auto vertex_at = [](unsigned i, unsigned j) { return Vertex(61 * j + i); };
  auto likelihood = vertex_map(mesh);
  const double width = 0.07;
  const GP::Earth_movers_cost cost = GP::fuzzy_geodesic(mesh, vertex_at(15, 30), vertex_at(45, 30),
                                                        likelihood, GP::parameters::width(width));
  EXPECT_NEAR(cost.value, 0.5, 0.001); // duality gap; fronts are exact in the plane
  double largest = 0.;
  for(const Vertex v : mesh.vertices())
  {
    EXPECT_GE(likelihood[v], 0.);
    largest = std::max(largest, likelihood[v]);
  }
  EXPECT_EQ(largest, 1.);
  for(unsigned j = 20; j <= 40; ++j)
  {
    const double y = (double(j) - 30.) / 60. / width;
    // The cost of the flow exceeds the optimum by at most 0.1 %.
    EXPECT_NEAR(likelihood[vertex_at(30, j)], std::exp(-0.5 * y * y), 0.05);
  }
  // The density is exp(-22) six widths beside the path, and exp(-4.8) three widths behind its end.
  // The flow adds the gap.
  EXPECT_LT(likelihood[vertex_at(30, 2)], 1e-3);
  EXPECT_LT(likelihood[vertex_at(2, 30)], 0.01);
}

// If two paths have equal lengths, both are likely. If one is shorter, only that one is likely.
TEST(fuzzy_geodesic, distinguishes_paths_around_hole)
{
  Mesh mesh = mesh_of(cylinder(48, 20, 1., 2.));
  const auto vertex_at = [](unsigned column, unsigned ring) { return Vertex(48 * ring + column); };
  auto likelihood = vertex_map(mesh), by_distances = vertex_map(mesh);
  GP::fuzzy_geodesic(mesh, vertex_at(0, 10), vertex_at(24, 10), likelihood);
  GP::fuzzy_geodesic_by_distances<GP::Exact>(mesh, vertex_at(0, 10), vertex_at(24, 10),
                                             by_distances);
  // Any division between the two paths costs the same. The interior point method halves the mass.
  EXPECT_NEAR(likelihood[vertex_at(12, 10)], likelihood[vertex_at(36, 10)], 0.01);
  EXPECT_GT(likelihood[vertex_at(12, 10)], 0.4);
  EXPECT_NEAR(by_distances[vertex_at(12, 10)], 1., round_off);
  GP::fuzzy_geodesic(mesh, vertex_at(0, 10), vertex_at(18, 10), likelihood);
  GP::fuzzy_geodesic_by_distances<GP::Exact>(mesh, vertex_at(0, 10), vertex_at(18, 10),
                                             by_distances);
  EXPECT_GT(likelihood[vertex_at(9, 10)], 0.5);
  // The path around the other side is longer by two thirds. Only the gap of 0.1 % allows a flow
  // there; measured are 0.1 %.
  EXPECT_LT(likelihood[vertex_at(33, 10)], 0.01);
  EXPECT_NEAR(by_distances[vertex_at(9, 10)], 1., round_off);
  // The detour is more than ten widths long.
  EXPECT_LT(by_distances[vertex_at(33, 10)], 1e-4);
}

TEST(fuzzy_geodesic, by_distances_measures_detour)
{
  Mesh mesh = mesh_of(square(20, 0.2));
  const Vertex p(70), q(300);
  auto likelihood = vertex_map(mesh);
  GP::fuzzy_geodesic_by_distances<GP::Exact>(mesh, p, q, likelihood, GP::parameters::width(0.1));
  const auto length = [&](Vertex a, Vertex b)
  { return std::sqrt(CGAL::squared_distance(mesh.point(a), mesh.point(b))); };
  for(const Vertex v : mesh.vertices())
    EXPECT_NEAR(likelihood[v], std::exp(-(length(p, v) + length(v, q) - length(p, q)) / 0.1),
                round_off); // round-off errors
}

TEST(fuzzy_geodesic, accepts_point_sets)
{
  const Surfels surfels = sphere_surfels(4);
  using Cloud = CGAL::Point_set_3<Kernel::Point_3>;
  Cloud cloud(true);
  for(const auto& [point, normal] : surfels)
    cloud.insert(point, normal);
  auto likelihood = cloud.add_property_map<double>("likelihood").first;
  const Cloud::Index p(3), q(900);
  const auto a = cloud.point(p), b = cloud.point(q);
  const auto middle = CGAL::midpoint(a, b) - CGAL::ORIGIN;
  const auto expect_ridge_along_geodesic = [&](double min_likelihood)
  {
    for(const auto& i : cloud)
    {
      const auto x = cloud.point(i) - CGAL::ORIGIN;
      const double cosine = x * middle / std::sqrt(middle * middle);
      if(cosine > 0.995)
      {
        EXPECT_GT(likelihood[i], min_likelihood);
      }
      if(cosine < -0.5)
      {
        // The detour is many widths long, and only the gap of 0.1 % allows a flow there.
        EXPECT_LT(likelihood[i], 0.01);
      }
    }
  };
  const double width = 0.15; // two edge lengths
  GP::fuzzy_geodesic(cloud, p, q, likelihood, GP::parameters::width(width));
  expect_ridge_along_geodesic(0.5); // within 0.1 of the path
  GP::fuzzy_geodesic_by_distances(cloud, p, q, likelihood, GP::parameters::width(width));
  expect_ridge_along_geodesic(0.8);
}

TEST(fuzzy_geodesic, throws_if_not_connected)
{
  Mesh mesh = mesh_of(disjoint_union(square(4), square(4)));
  auto likelihood = vertex_map(mesh);
  EXPECT_THROW(GP::fuzzy_geodesic(mesh, Vertex(3), Vertex(3), likelihood),
               GP::Invalid_argument_error);
  EXPECT_NO_THROW(
      GP::fuzzy_geodesic(mesh, Vertex(3), Vertex(3), likelihood, GP::parameters::width(0.2)));
  EXPECT_EQ(likelihood[Vertex(3)], 0.);
  EXPECT_THROW(GP::fuzzy_geodesic(mesh, Vertex(3), Vertex(30), likelihood),
               GP::Invalid_argument_error);
  for(const double width : {0., -1., std::nan("")})
  {
    EXPECT_THROW(
        GP::fuzzy_geodesic(mesh, Vertex(3), Vertex(8), likelihood, GP::parameters::width(width)),
        GP::Invalid_argument_error);
    EXPECT_THROW(GP::fuzzy_geodesic_by_distances(mesh, Vertex(3), Vertex(8), likelihood,
                                                 GP::parameters::width(width)),
                 GP::Invalid_argument_error);
  }
}

} // namespace fuzzy_geodesic_test
