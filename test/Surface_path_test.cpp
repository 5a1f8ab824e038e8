// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/geodesic_path.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "meshes.h"

#include <gtest/gtest.h>

namespace Surface_path_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

void expect_paths(const Triangulation& shape, double scale)
{
  const Triangulation surface = scaled(shape, scale);
  Numbered<Surface_mesh> mesh;
  fill(mesh, surface);
  const auto domain = make_domain(mesh.mesh);
  const double rounding = 1e-12 * scale; // sums of some tens of lengths
  for(std::size_t from = 1; from < mesh.vertices.size(); from += 23)
  {
    const auto path = geodesic_path(domain, mesh.vertices[from], mesh.vertices[0]);
    ASSERT_FALSE(path.empty());
    ASSERT_EQ(path.points.size(), path.locations.size());
    EXPECT_LT(distance(to_array(path.points.front()), surface.points[from]), rounding);
    EXPECT_LT(distance(to_array(path.points.back()), surface.points[0]), rounding);
    double length = 0.;
    for(std::size_t i = 0; i < path.points.size(); ++i)
    {
      EXPECT_LT(distance(to_array(path.points[i]), point_of(mesh.mesh, path.locations[i])),
                rounding);
      double sum = 0.;
      for(const double b : path.locations[i].second)
      {
        EXPECT_GE(b, 0.);
        sum += b;
      }
      EXPECT_NEAR(sum, 1., 1e-15 * 4); // a few round-off errors
      if(i == 0)
        continue;
      const double step = distance(to_array(path.points[i - 1]), to_array(path.points[i]));
      EXPECT_GT(step, 0.) << "a point comes twice";
      length += step;
    }
    EXPECT_NEAR(path.length, length, rounding);
    // The front errs by some tenths of a percent, and by more behind bumps. A path is at least as
    // long as the exact surface distance.
    EXPECT_NEAR(path.front_distance, path.length, 0.03 * path.length);
  }
}

TEST(Surface_path, is_consistent_at_any_scale)
{
  for(const double scale : {1., 1e-8, 1e8})
    expect_paths(jittered(icosphere(3), 0.02), scale);
}

TEST(Surface_path, is_straight_in_plane)
{
  const Triangulation plane = square(12, 0.2);
  Numbered<Surface_mesh> mesh;
  fill(mesh, plane);
  const auto path = geodesic_path(mesh.mesh, mesh.vertices[168], mesh.vertices[0]);
  EXPECT_NEAR(path.length, std::sqrt(2.), 1e-12);        // a sum of some tens of lengths
  EXPECT_NEAR(path.front_distance, std::sqrt(2.), 1e-7); // round-off error of the front
}

TEST(Surface_path, is_empty_between_components)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, disjoint_union(tetrahedron(), square(2)));
  const auto path = geodesic_path(mesh.mesh, mesh.vertices[6], mesh.vertices[0]);
  EXPECT_TRUE(path.empty());
  EXPECT_EQ(path.length, 0.);
  EXPECT_EQ(path.front_distance, internal::infinity);
}

} // namespace Surface_path_test
