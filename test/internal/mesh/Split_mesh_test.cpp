// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Split_mesh.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"
#include "topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace Split_mesh_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

std::vector<bool> no_curve(const Surface_arrays& t)
{
  return std::vector<bool>(t.corner.size(), false);
}

double area(const Surface_arrays& t)
{
  double result = 0.;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const auto& p = t.point[t.corner[3 * f]];
    result += 0.5 * norm(cross(t.point[t.corner[3 * f + 1]] - p, t.point[t.corner[3 * f + 2]] - p));
  }
  return result;
}

void expect_subdivides(const Split_mesh& mesh, const Surface_arrays& coarse)
{
  const Surface_arrays& t = mesh.triangles();
  EXPECT_EQ(topology(t.corner), topology(coarse.corner));
  EXPECT_NEAR(area(t), area(coarse), 1e-12 * area(coarse)); // sums of some hundred areas
  std::vector<std::set<Index>> corners(t.point.size());
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    corners[t.corner[h]].insert(h);
    const auto b = mesh.barycentric(h / 3, t.corner[h]);
    // Round-off errors of sums of a few products in [0, 2).
    EXPECT_LT(norm(t.point[t.corner[h]] -
                   scaled_coordinates(coarse, {mesh.coarse_triangles()[h / 3], none, b})),
              1e-14);
    if(const Index twin = t.twin[h]; twin != none)
    {
      EXPECT_EQ(t.twin[twin], h);
      EXPECT_EQ(mesh.source(twin), mesh.target(h));
      EXPECT_EQ(mesh.source(h), mesh.target(twin));
      EXPECT_EQ(mesh.labels()[twin], mesh.labels()[h]);
    }
  }
  for(Index vertex = 0; vertex < t.point.size(); ++vertex)
  {
    const std::vector<Index> around = mesh.corners_around(vertex);
    EXPECT_EQ(std::set<Index>(around.begin(), around.end()), corners[vertex]);
    for(std::size_t i = 0; i + 1 < around.size(); ++i)
      EXPECT_EQ(around[i + 1], t.twin[previous_halfedge(around[i])]);
    const bool is_inside = !around.empty() && t.twin[around.front()] != none;
    EXPECT_EQ(mesh.halfedges_around(vertex).size(),
              around.size() + (around.empty() || is_inside ? 0u : 1u));
  }
}

TEST(Split_mesh, coordinates_in_small_subtriangles_at_a_corner_are_accurate)
{
  const double d = 1e-20;
  for(std::size_t k = 0; k < 3; ++k)
  {
    const auto at = [=](double x, double y)
    {
      std::array<double, 3> b;
      b[k] = 1. - d * (x + y);
      b[(k + 1) % 3] = d * x;
      b[(k + 2) % 3] = d * y;
      return b;
    };
    const auto found = subtriangle_coordinates({at(1., 1.), at(3., 1.), at(1., 3.)}, at(2., 1.5));
    EXPECT_NEAR(found[0], 0.25, 1e-15); // round-off errors
    EXPECT_NEAR(found[1], 0.5, 1e-15);
    EXPECT_NEAR(found[2], 0.25, 1e-15);
  }
}

TEST(Split_mesh, splits_keep_surface)
{
  for(const Triangulation& surface :
      {icosphere(1), annulus(12, 3, 1., 2.), torus(7, 5), tetrahedron(), one_triangle(),
       disjoint_union(icosphere(0), tetrahedron())})
  {
    const Array_surface arrays(surface);
    Split_mesh mesh(arrays.t(), no_curve(arrays.t()));
    std::mt19937 random(1);
    for(int i = 0; i < 60; ++i)
      if(i % 2 == 0)
        mesh.insert(random_location(arrays.t(), random));
      else
        mesh.split_edge(Index(random() % mesh.triangles().corner.size()),
                        0.1 + 0.8 * double(random() % 1000) / 1000.);
    expect_subdivides(mesh, arrays.t());
  }
}

TEST(Split_mesh, splits_keep_length_of_labeled_edges)
{
  const Array_surface surface(torus(7, 5));
  std::vector<bool> is_curve = no_curve(surface.t());
  for(const Index h : {Index(0), Index(10), Index(23)})
    is_curve[h] = is_curve[surface.t().twin[h]] = true;
  Split_mesh mesh(surface.t(), is_curve);
  const auto length = [&](Index label)
  {
    double result = 0.;
    for(Index h = 0; h < mesh.labels().size(); ++h)
      if(mesh.labels()[h] == label)
        result += mesh.length(h);
    return result;
  };
  mesh.set_label(10, 7);
  const double curve_length = length(Split_mesh::curve_label), labeled_length = length(7);
  EXPECT_GT(labeled_length, 0.);
  for(Index i = 0; i < 200; ++i)
    mesh.split_edge(7 * i % Index(mesh.triangles().corner.size()), 0.4);
  // Round-off errors of sums of at most some dozens of lengths.
  EXPECT_NEAR(length(Split_mesh::curve_label), curve_length, 1e-13 * curve_length);
  EXPECT_NEAR(length(7), labeled_length, 1e-13 * labeled_length);
}

TEST(Split_mesh, nonmanifold_vertices_are_split)
{
  const Triangulation bow_tie = {
      {{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.}, {-1., 0., 0.}, {-1., -1., 0.}},
      {0, 1, 2, 0, 3, 4}};
  const Array_surface surface(bow_tie);
  const Split_mesh mesh(surface.t(), no_curve(surface.t()));
  EXPECT_EQ(mesh.triangles().point.size(), 6u);
  EXPECT_EQ(topology(mesh.triangles().corner), (Topology{true, {{1, 1}, {1, 1}}}));
  EXPECT_TRUE(is_same_point(surface.t(), mesh.locations()[5], surface.at(0)));
}

TEST(Split_mesh, sample_snaps_to_close_vertex_once)
{
  const Array_surface surface(icosphere(1));
  Split_mesh mesh(surface.t(), no_curve(surface.t()));
  const Surface_location near_corner = surface.in(0, {0.995, 0.003, 0.002});
  const Index corner = surface.t().corner[3 * near_corner.triangle],
              n = surface.t().number_of_vertices();
  EXPECT_EQ(mesh.insert(near_corner), corner);
  EXPECT_EQ(mesh.insert(near_corner), n);
  EXPECT_EQ(mesh.insert(surface.in(0, {0.3, 0.3, 0.4})), n + 1);
  expect_subdivides(mesh, surface.t());
}

TEST(Split_mesh, samples_do_not_cross_curves)
{
  const Array_surface surface(icosphere(1));
  std::vector<bool> is_curve = no_curve(surface.t());
  const Index h = 3 * surface.triangle(0);
  is_curve[h] = is_curve[surface.t().twin[h]] = true;
  Split_mesh mesh(surface.t(), is_curve);
  const Index vertex = mesh.insert({surface.triangle(0), none, {0.499, 0.499, 0.002}});
  for(const Index h : mesh.halfedges_around(vertex))
    EXPECT_EQ(mesh.labels()[h], none);
  expect_subdivides(mesh, surface.t());
}

TEST(Split_mesh, samples_on_curve_split_curve_edges)
{
  const Array_surface surface(one_triangle());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.1, 0.9);
  for(Index k = 0; k < 3; ++k)
  {
    std::vector<bool> is_curve = no_curve(surface.t());
    is_curve[k] = true;
    Split_mesh mesh(surface.t(), is_curve);
    mesh.split_edge((k + 1) % 3, 1e-6); // leaves a triangle of small height over the feature edge
    const auto halfedges_on_curve = [&]
    { return std::count(mesh.labels().begin(), mesh.labels().end(), Split_mesh::curve_label); };
    for(int i = 1; i < 30; ++i)
    {
      mesh.insert(surface.on(0, int(k), uniform(random)));
      EXPECT_EQ(halfedges_on_curve(), 1 + i);
    }
  }
}

} // namespace Split_mesh_test
