// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include "Array_surface.h"
#include "meshes.h"
#include "rough_surfaces.h"

#include <gtest/gtest.h>

namespace windows_vs_chen_han {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Sequence_tree =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Surface_mesh>>;

// Compares exact distances by window propagation with CGAL's implementation of the algorithm of
// Chen and Han.
// tolerance  relative round-off errors
void expect_agreement(const Triangulation& shape, double tolerance)
{
  const Array_surface surface(shape);
  internal::Window_propagation windows(surface.triangles());
  Numbered<Surface_mesh> mesh;
  fill(mesh, shape);
  for(const Index source : {Index(0), surface.size() / 3, surface.size() / 2})
  {
    ASSERT_TRUE(windows.run({surface.source(source)}));
    const auto d = surface.distances(windows);
    Sequence_tree tree(mesh.mesh);
    tree.add_source_point(mesh.vertices[source]);
    for(Index i = 0; i < surface.size(); ++i)
    {
      const double other = tree.shortest_distance_to_source_points(mesh.vertices[i]).first;
      EXPECT_NEAR(d[i], other < 0. ? internal::infinity : other, tolerance * other);
    }
  }
}

// Accuracy of two implementations that unfold hundreds of triangles in different orders.
constexpr double unfolding_tolerance = 1e-9;

TEST(Windows_vs_chen_han, agree_on_closed_surfaces)
{
  expect_agreement(tetrahedron(), unfolding_tolerance);
  expect_agreement(icosphere(3), unfolding_tolerance);
  expect_agreement(jittered(icosphere(3), 0.05), unfolding_tolerance);
  Triangulation elongated_sphere = jittered(icosphere(3), 0.02);
  for(Point& p : elongated_sphere.points)
    p[2] *= 12.;
  expect_agreement(elongated_sphere, unfolding_tolerance);
}

TEST(Windows_vs_chen_han, agree_on_surfaces_with_boundary)
{
  for(const double height : {0.05, 0.3})
    expect_agreement(grid(
                         20, 20,
                         [=](double u, double v) {
                           return Point{u, v, height * std::sin(9. * u) * std::cos(8. * v)};
                         },
                         0.24),
                     unfolding_tolerance);
  expect_agreement(jittered(annulus(24, 8, 0.4, 1.), 0.03), unfolding_tolerance);
  expect_agreement(cone(10, 6, 9.), unfolding_tolerance);
  expect_agreement(jittered(cylinder(16, 10, 0.3, 1.), 0.02), unfolding_tolerance);
}

TEST(Windows_vs_chen_han, agree_on_spikes)
{
  // Windows wind around spikes whose height is up to a hundred times their width.
  for(const double height : {0.3, 3.})
    expect_agreement(grid(
                         16, 16,
                         [=](double u, double v) {
                           return Point{u, v, height * std::sin(1e5 * u + 3e4 * v)};
                         },
                         0.24),
                     unfolding_tolerance);
}

TEST(Windows_vs_chen_han, agree_on_scans_and_cad_models)
{
  std::vector<std::pair<std::string, Triangulation>> surfaces = {{"animal", animal(3)},
                                                                 {"spool", spool(60)}};
  add_models(surfaces, {"meshes/pig_468.off", "meshes/spool_649.off", "patches/patch_01_735.off"});
  for(const auto& [name, surface] : surfaces)
  {
    SCOPED_TRACE(name);
    expect_agreement(surface, unfolding_tolerance);
  }
  // With angles of half a degree, the height of a needle has seven fewer accurate digits.
  if(Triangulation joint; read_model("meshes/joint_221.off", joint))
    expect_agreement(joint, 1e-6);
}

} // namespace windows_vs_chen_han
