// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/semi_regular.h>

#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include "Array_surface.h"
#include "topology.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace semi_regular_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Base_map map_of(const Array_surface& surface, std::size_t number)
{
  Remeshing_options options;
  options.number_of_samples = number;
  return Base_map(std::make_shared<const Base_mesh>(build_base_mesh(surface.triangles(), options)),
                  Base_coordinates::heron);
}

TEST(Semi_regular_mesh, vertices_lie_on_the_mesh_at_each_level)
{
  const Array_surface sphere(icosphere(3));
  const Base_map map = map_of(sphere, 30);
  const Semi_regular_mesh mesh = build_semi_regular_mesh(map, sphere.t(), 3);
  const std::size_t faces = map.base().triangles.size();
  EXPECT_EQ(mesh.triangles.size(), 64 * faces);
  EXPECT_EQ(mesh.number_of_vertices.size(), 4u);
  EXPECT_EQ(mesh.points.size(), mesh.number_of_vertices.back());
  for(const Point& p : mesh.points)
  {
    // The faces of the icosphere are at least 0.995 from its center.
    EXPECT_GT(norm(p), 0.99);
    EXPECT_LT(norm(p), 1. + 1e-12);
  }
  std::vector<Index> corners;
  for(const Triangle& f : mesh.triangles)
    corners.insert(corners.end(), f.begin(), f.end());
  EXPECT_EQ(topology(corners), topology(sphere.t().corner));
  const Semi_regular_mesh coarser = build_semi_regular_mesh(map, sphere.t(), 2);
  EXPECT_TRUE(std::equal(coarser.points.begin(), coarser.points.end(), mesh.points.begin()));
}

TEST(Semi_regular_mesh, stops_at_maximum_deviation)
{
  const Array_surface sphere(icosphere(3));
  const Base_map map = map_of(sphere, 30);
  const double scale = sphere.scale();
  std::size_t last = 0;
  for(const double deviation : {10., 0.1, 0.02})
  {
    const Semi_regular_mesh mesh = build_semi_regular_mesh(map, sphere.t(), 6, deviation / scale);
    EXPECT_GE(mesh.number_of_vertices.size(), last);
    last = mesh.number_of_vertices.size();
    EXPECT_LT(last, 7u);
    // Each vertex of the sphere is close to the point with its coordinates, so that the faces are
    // close to the sphere, too.
    for(const Triangle& f : mesh.triangles)
      EXPECT_GT(norm((1. / 3.) * (mesh.points[f[0]] + mesh.points[f[1]] + mesh.points[f[2]])),
                1. - 2. * deviation - 0.01);
  }
  EXPECT_GT(last, 1u);
}

TEST(Semi_regular_mesh, has_quad_faces)
{
  const Array_surface surface(torus(24, 16));
  const Base_map map = map_of(surface, 40);
  const Semi_regular_mesh mesh = build_semi_regular_quads(map, surface.t(), 2);
  EXPECT_EQ(mesh.quads.size(), 3 * 16 * map.base().triangles.size());
  EXPECT_TRUE(mesh.triangles.empty());
  // A closed quad mesh of genus one has as many vertices as faces.
  EXPECT_EQ(mesh.points.size(), mesh.quads.size());
}

TEST(Semi_regular_mesh, uses_no_more_levels_than_needed)
{
  const Array_surface sphere(icosphere(3));
  const Base_map map = map_of(sphere, 30);
  const Semi_regular_mesh mesh =
      build_semi_regular_mesh(map, sphere.t(), 20, 100. / sphere.scale());
  EXPECT_EQ(mesh.number_of_vertices.size(), 1u);
  EXPECT_EQ(mesh.triangles, map.base().triangles);
  EXPECT_GT(mesh.deviation, 0.);
  // If the number of levels is too small, the remaining deviation is reported.
  EXPECT_GT(build_semi_regular_mesh(map, sphere.t(), 1, 1e-9 / sphere.scale()).deviation, 1e-9);
}

} // namespace semi_regular_test
