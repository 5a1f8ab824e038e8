// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/feature_distance.h>

#include <CGAL/Geodesic_processing/geodesic_distances.h>

#include <CGAL/Point_set_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Never above the exact distance, and in the mean below by no more than a hundredth of the largest one.
template <typename Feature>
void expect_below_exact(Mesh& mesh, const Feature& feature)
{
  auto found = vertex_map(mesh), exact = mesh.add_property_map<Vertex, double>("v:exact").first;
  const GP::Earth_movers_cost cost = GP::feature_distance(mesh, feature, found);
  EXPECT_TRUE(cost.converged);
  GP::geodesic_distances<GP::Exact>(mesh, feature, exact);
  double largest = 0., loss = 0.;
  for(const Vertex v : vertices(mesh))
  {
    EXPECT_LE(found[v], exact[v] * (1. + 1e-9)); // rounding
    EXPECT_GE(found[v], 0.);
    largest = std::max(largest, exact[v]);
    loss += (exact[v] - found[v]) / double(num_vertices(mesh));
  }
  EXPECT_LT(loss, 0.01 * largest);
}

TEST(Feature_distance, is_that_of_curves_and_borders)
{
  Mesh plane = mesh_of(square(20, 0.24));
  std::vector<GP::Source<Mesh>> border;
  GP::border_sources(plane, std::back_inserter(border));
  expect_below_exact(plane, border);

  Mesh ring = mesh_of(torus(60, 30)); // of rings of 30 vertices
  std::vector<Vertex> curve;
  for(Mesh::size_type i = 0; i < 30; ++i)
    curve.push_back(Vertex(i));
  expect_below_exact(ring, curve);
}

// On an interval with features at 0 and 0.3: fixed masses there would make it wrong by 0.3.
TEST(Feature_distance, has_no_offsets)
{
  Mesh mesh = mesh_of(square(20));
  std::vector<Vertex> lines;
  for(Mesh::size_type row = 0; row <= 20; ++row)
    for(const Mesh::size_type column : {0, 6})
      lines.push_back(Vertex(21 * row + column));
  auto found = vertex_map(mesh);
  GP::feature_distance(mesh, lines, found, GP::parameters::tolerance(1e-5));
  for(const Vertex v : vertices(mesh))
  {
    const double x = mesh.point(v).x();
    EXPECT_NEAR(found[v], std::min(x, std::abs(x - 0.3)),
                2e-3); // of a mean of 0.19, the gap's room
  }
}

TEST(Feature_distance, is_that_of_clouds)
{
  const Surfels surfels = sphere_surfels(4);
  CGAL::Point_set_3<Kernel::Point_3> cloud(true);
  for(const auto& [point, normal] : surfels)
    cloud.insert(point, normal);
  auto found = cloud.add_property_map<double>("distance", 0.).first;
  GP::feature_distance(cloud, *cloud.begin(), found);
  double loss = 0.;
  for(const auto& i : cloud)
    loss += (2. * std::asin(0.5 * std::sqrt(CGAL::squared_distance(cloud.point(*cloud.begin()),
                                                                   cloud.point(i)))) -
             found[i]) /
            double(cloud.size());
  // A part of a side, 0.06, around the point.
  EXPECT_LT(std::abs(loss), 0.03);
}

TEST(Feature_distance, is_infinite_where_no_way_leads)
{
  Mesh mesh = mesh_of(apart(square(4), square(4)));
  const Vertex alone = mesh.add_vertex(Kernel::Point_3(0., 0., 9.));
  auto found = vertex_map(mesh);
  EXPECT_TRUE(GP::feature_distance(mesh, Vertex(0), found).converged);
  EXPECT_NEAR(found[Vertex(4)], 1., 0.05); // a part of a side
  EXPECT_EQ(found[Vertex(30)], infinity);
  EXPECT_EQ(found[alone], infinity);
  GP::feature_distance(mesh, std::vector<Vertex>{Vertex(0), Vertex(25), alone}, found);
  EXPECT_NEAR(found[Vertex(29)], 1., 0.05);
  EXPECT_EQ(found[alone], 0.);
  // Behind a wall.
  Mesh plane = mesh_of(square(4));
  const auto speed = plane.add_property_map<Vertex, double>("speed", 1.).first;
  for(Mesh::size_type row = 0; row < 5; ++row)
    for(const Mesh::size_type column : {1, 2})
      speed[Vertex(5 * row + column)] = 0.;
  auto behind = vertex_map(plane);
  GP::feature_distance(plane, Vertex(0), behind, GP::parameters::speed_map(speed));
  EXPECT_EQ(behind[Vertex(4)], infinity);
}

} // namespace
