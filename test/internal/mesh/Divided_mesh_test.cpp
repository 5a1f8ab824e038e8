// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Divided_mesh.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Glued_surface.h"
#include "topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

std::vector<bool> no_curve(const Glued_triangles& t)
{
  return std::vector<bool>(t.corner.size(), false);
}

double area(const Glued_triangles& t)
{
  double result = 0.;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const auto& p = t.point[t.corner[3 * f]];
    result += 0.5 * norm(cross(t.point[t.corner[3 * f + 1]] - p, t.point[t.corner[3 * f + 2]] - p));
  }
  return result;
}

void expect_divides(const Divided_mesh& mesh, const Glued_triangles& coarse)
{
  const Glued_triangles& t = mesh.triangles();
  EXPECT_EQ(topology(t.corner), topology(coarse.corner));
  EXPECT_NEAR(area(t), area(coarse), 1e-12 * area(coarse));
  std::vector<std::set<Index>> corners(t.point.size());
  for(Index side = 0; side < t.corner.size(); ++side)
  {
    corners[t.corner[side]].insert(side);
    const auto b = mesh.barycentric(side / 3, t.corner[side]);
    // Sums of a few products in [0, 2).
    EXPECT_LT(norm(t.point[t.corner[side]] -
                   scaled_coordinates(coarse, {mesh.wholes()[side / 3], none, b})),
              1e-14);
    if(const Index twin = t.twin[side]; twin != none)
    {
      EXPECT_EQ(t.twin[twin], side);
      EXPECT_EQ(mesh.source(twin), mesh.target(side));
      EXPECT_EQ(mesh.source(side), mesh.target(twin));
      EXPECT_EQ(mesh.labels()[twin], mesh.labels()[side]);
    }
  }
  for(Index site = 0; site < t.point.size(); ++site)
  {
    const std::vector<Index> around = mesh.corners_around(site);
    EXPECT_EQ(std::set<Index>(around.begin(), around.end()), corners[site]);
    for(std::size_t i = 0; i + 1 < around.size(); ++i)
      EXPECT_EQ(around[i + 1], t.twin[previous_side(around[i])]);
    const bool is_inside = !around.empty() && t.twin[around.front()] != none;
    EXPECT_EQ(mesh.sides_around(site).size(),
              around.size() + (around.empty() || is_inside ? 0u : 1u));
  }
}

TEST(Divided_mesh, is_the_same_surface_after_any_cuts)
{
  for(const Triangulation& surface :
      {icosphere(1), annulus(12, 3, 1., 2.), torus(7, 5), tetrahedron(), one_triangle(),
       apart(icosphere(0), tetrahedron())})
  {
    const Glued_surface glued(surface);
    Divided_mesh mesh(glued.t(), no_curve(glued.t()));
    std::mt19937 random(1);
    for(int i = 0; i < 60; ++i)
      if(i % 2 == 0)
        mesh.insert(random_location(glued.t(), random));
      else
        mesh.split_side(Index(random() % mesh.triangles().corner.size()),
                        0.1 + 0.8 * double(random() % 1000) / 1000.);
    expect_divides(mesh, glued.t());
  }
}

TEST(Divided_mesh, lines_keep_their_length)
{
  const Glued_surface surface(torus(7, 5));
  std::vector<bool> is_curve = no_curve(surface.t());
  for(const Index side : {Index(0), Index(10), Index(23)})
    is_curve[side] = is_curve[surface.t().twin[side]] = true;
  Divided_mesh mesh(surface.t(), is_curve);
  const auto length = [&](Index label)
  {
    double result = 0.;
    for(Index side = 0; side < mesh.labels().size(); ++side)
      if(mesh.labels()[side] == label)
        result += mesh.length(side);
    return result;
  };
  mesh.set_label(10, 7);
  const double curves = length(Divided_mesh::curve), line = length(7);
  EXPECT_GT(line, 0.);
  for(Index i = 0; i < 200; ++i)
    mesh.split_side(7 * i % Index(mesh.triangles().corner.size()), 0.4);
  // Sums of at most some dozens of parts.
  EXPECT_NEAR(length(Divided_mesh::curve), curves, 1e-13 * curves);
  EXPECT_NEAR(length(7), line, 1e-13 * line);
}

TEST(Divided_mesh, fans_that_meet_in_a_site_are_taken_apart)
{
  const Triangulation bow = {
      {{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.}, {-1., 0., 0.}, {-1., -1., 0.}},
      {0, 1, 2, 0, 3, 4}};
  const Glued_surface surface(bow);
  const Divided_mesh mesh(surface.t(), no_curve(surface.t()));
  EXPECT_EQ(mesh.triangles().point.size(), 6u);
  EXPECT_EQ(topology(mesh.triangles().corner), (Topology{true, {{1, 1}, {1, 1}}}));
  EXPECT_TRUE(is_same_point(surface.t(), mesh.locations()[5], surface.at(0)));
}

TEST(Divided_mesh, samples_go_to_a_near_site_once)
{
  const Glued_surface surface(icosphere(1));
  Divided_mesh mesh(surface.t(), no_curve(surface.t()));
  const Location near = surface.in(0, {0.995, 0.003, 0.002});
  const Index corner = surface.t().corner[3 * near.triangle], n = surface.t().number_of_sites();
  EXPECT_EQ(mesh.insert(near), corner);
  EXPECT_EQ(mesh.insert(near), n);
  EXPECT_EQ(mesh.insert(surface.in(0, {0.3, 0.3, 0.4})), n + 1);
  expect_divides(mesh, surface.t());
}

TEST(Divided_mesh, samples_stay_on_their_side_of_a_curve)
{
  const Glued_surface surface(icosphere(1));
  std::vector<bool> is_curve = no_curve(surface.t());
  const Index side = 3 * surface.triangle(0);
  is_curve[side] = is_curve[surface.t().twin[side]] = true;
  Divided_mesh mesh(surface.t(), is_curve);
  const Index site = mesh.insert({surface.triangle(0), none, {0.499, 0.499, 0.002}});
  for(const Index around : mesh.sides_around(site))
    EXPECT_EQ(mesh.labels()[around], none);
  expect_divides(mesh, surface.t());
}

TEST(Divided_mesh, samples_on_a_curve_stay_there)
{
  const Glued_surface surface(one_triangle());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.1, 0.9);
  for(Index k = 0; k < 3; ++k)
  {
    std::vector<bool> is_curve = no_curve(surface.t());
    is_curve[k] = true;
    Divided_mesh mesh(surface.t(), is_curve);
    mesh.split_side((k + 1) % 3, 1e-6); // which leaves little height over the curve
    const auto sides_on_curve = [&]
    { return std::count(mesh.labels().begin(), mesh.labels().end(), Divided_mesh::curve); };
    for(int i = 1; i < 30; ++i)
    {
      mesh.insert(surface.on(0, int(k), uniform(random)));
      EXPECT_EQ(sides_on_curve(), 1 + i);
    }
  }
}

} // namespace
