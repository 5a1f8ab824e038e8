// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_lle.h>

#include <CGAL/Geodesic_processing/distortion.h>
#include <CGAL/Geodesic_processing/exceptions.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"
#include "openmesh.h"
#include "rough_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace geodesic_lle_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using UV = std::array<double, 2>;

double uv_distance(const UV& p, const UV& q) { return std::hypot(p[0] - q[0], p[1] - q[1]); }

TEST(geodesic_lle, is_isometric_on_flat_disk)
{
  Mesh mesh = mesh_of(cone(64, 30, 2. * CGAL_PI)); // radius 30
  auto uv = vertex_map<UV>(mesh);
  const auto base =
      GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(std::size_t(100)));
  EXPECT_EQ(base.size(), 100u);
  double max_error = 0.;
  for(const Vertex v : mesh.vertices())
    for(const Vertex w : {Vertex(0), Vertex(700), Vertex(1900)})
      max_error = std::max(
          max_error, std::abs(uv_distance(uv[v], uv[w]) -
                              std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)))));
  EXPECT_LT(max_error, 1e-3 * 60.); // the required accuracy
  const auto distortion = GP::flattening_distortion(mesh, uv);
  EXPECT_EQ(distortion.number_of_flips, 0u);
}

TEST(geodesic_lle, is_isometric_on_square_at_all_scales)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Mesh mesh = mesh_of(scaled(square(30, 0.25), scale));
    auto uv = vertex_map<UV>(mesh);
    GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(std::size_t(100)));
    double max_error = 0.;
    for(const Vertex v : mesh.vertices())
      max_error = std::max(
          max_error,
          std::abs(uv_distance(uv[v], uv[Vertex(37)]) -
                   std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(Vertex(37))))));
    EXPECT_LT(max_error, 1e-4 * scale); // fronts are not exact at their limit
    EXPECT_EQ(GP::flattening_distortion(mesh, uv).number_of_flips, 0u);
  }
}

// Locally linear embedding alone reproduces a plane. Classical scaling alone does not, because
// chains of base points are longer than lines.
TEST(geodesic_lle, start_can_be_selected_without_rigid_steps)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Mesh mesh = mesh_of(scaled(square(30, 0.25), scale));
    auto uv = vertex_map<UV>(mesh);
    const auto error = [&](GP::Flattening_start start)
    {
      GP::geodesic_lle(mesh, uv,
                       GP::parameters::number_of_base_points(std::size_t(100))
                           .flattening_start(start)
                           .number_of_rigid_steps(std::size_t(0)));
      double result = 0.;
      for(const Vertex v : mesh.vertices())
        result = std::max(
            result,
            std::abs(uv_distance(uv[v], uv[Vertex(37)]) -
                     std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(Vertex(37))))));
      return result / scale;
    };
    const double lle = error(GP::Flattening_start::lle), mds = error(GP::Flattening_start::mds);
    EXPECT_LT(lle, 1e-4); // fronts are not exact at their limit
    EXPECT_GT(mds, 10. * lle);
    EXPECT_LT(mds, 0.01);                              // measured: 0.0031
    EXPECT_EQ(error(GP::Flattening_start::best), lle); // its energy is lower
  }
}

// With rigid steps, `best` is one of both.
TEST(geodesic_lle, best_start_is_one_of_both)
{
  Mesh mesh = mesh_of(part_of(icosphere(4), [](const Point& p) { return p[2] > 0.; }));
  auto uv = vertex_map<UV>(mesh);
  const auto images = [&]
  {
    std::vector<UV> result;
    for(const Vertex v : mesh.vertices())
      result.push_back(uv[v]);
    return result;
  };
  const auto flattened = [&](GP::Flattening_start start)
  {
    GP::geodesic_lle(mesh, uv, GP::parameters::flattening_start(start));
    return images();
  };
  const auto best = flattened(GP::Flattening_start::best),
             lle = flattened(GP::Flattening_start::lle), mds = flattened(GP::Flattening_start::mds);
  EXPECT_NE(lle, mds);
  EXPECT_TRUE(best == lle || best == mds);
  GP::geodesic_lle(mesh, uv);
  EXPECT_EQ(images(), best);
  GP::geodesic_lle(mesh, uv, GP::parameters::number_of_rigid_steps(std::size_t(30)));
  EXPECT_EQ(images(), best);
}

TEST(geodesic_lle, start_can_be_selected_on_clouds)
{
  const Surfels flat = flat_surfels(2000);
  std::vector<UV> uv(flat.size());
  GP::geodesic_lle(flat, CGAL::make_property_map(uv),
                   GP::parameters::number_of_base_points(std::size_t(60))
                       .flattening_start(GP::Flattening_start::lle)
                       .number_of_rigid_steps(std::size_t(0))
                       .point_map(Surfel_point_map())
                       .normal_map(Surfel_normal_map()));
  double max_error = 0.;
  for(std::size_t i = 0; i < flat.size(); ++i)
    max_error = std::max(max_error,
                         std::abs(uv_distance(uv[i], uv[0]) -
                                  std::sqrt(CGAL::squared_distance(flat[i].first, flat[0].first))));
  // Distances on clouds are accurate to a thousandth of the square's diagonal. Without rigid steps,
  // low eigenvectors amplify these errors. Measured: 0.018.
  EXPECT_LT(max_error, 0.03);
}

// Returns corridors two squares wide, separated by walls of one square and joined at alternating
// ends.
Mesh meander(std::size_t length, std::size_t number)
{
  const std::size_t height = 3 * number - 1;
  const Triangulation full_grid = grid(length, height,
                                       [&](double u, double v) {
                                         return Point{double(length) * u, double(height) * v, 0.};
                                       });
  Triangulation result{full_grid.points, {}};
  for(std::size_t i = 0; i < full_grid.corners.size(); i += 6)
  {
    const std::size_t column = i / 6 % length, row = i / 6 / length, wall = row / 3;
    const bool is_end = wall % 2 == 0 ? column + 2 >= length : column < 2;
    if(row % 3 != 2 || is_end)
      result.corners.insert(result.corners.end(), full_grid.corners.begin() + i,
                            full_grid.corners.begin() + i + 6);
  }
  return mesh_of(result);
}

TEST(geodesic_lle, uses_more_base_points_on_narrow_patch)
{
  Mesh mesh = meander(20, 40);
  auto uv = vertex_map<UV>(mesh);
  GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(std::size_t(200)));
  EXPECT_GT(GP::flattening_distortion(mesh, uv).number_of_flips, 0u);
  EXPECT_GT(GP::geodesic_lle(mesh, uv).size(), 200u);
  EXPECT_EQ(GP::flattening_distortion(mesh, uv).number_of_flips, 0u);
}

TEST(geodesic_lle, accepts_base_points_and_their_number)
{
  Mesh mesh = mesh_of(square(12, 0.2));
  auto uv = vertex_map<UV>(mesh);
  const std::vector<Vertex> given = {Vertex(0), Vertex(12), Vertex(80), Vertex(150), Vertex(168)};
  EXPECT_EQ(GP::geodesic_lle(
                mesh, uv, GP::parameters::base_points(given).number_of_neighbors(std::size_t(4))),
            given);
  EXPECT_EQ(GP::flattening_distortion(mesh, uv).number_of_flips, 0u);
  // At most all vertices are used, each of them once.
  const auto all =
      GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(std::size_t(1000)));
  EXPECT_EQ(std::set<Vertex>(all.begin(), all.end()).size(), all.size());
  EXPECT_EQ(all.size(), mesh.number_of_vertices());
}

TEST(geodesic_lle, handles_equidistant_neighbors)
{
  Mesh mesh = mesh_of(square(2));
  auto uv = vertex_map<UV>(mesh);
  std::vector<Vertex> boundary_vertices;
  for(const Vertex v : mesh.vertices())
    if(mesh.is_border(v))
      boundary_vertices.push_back(v);
  ASSERT_EQ(boundary_vertices.size(), 8u);
  GP::geodesic_lle(
      mesh, uv, GP::parameters::base_points(boundary_vertices).number_of_neighbors(std::size_t(3)));
  for(const Vertex v : mesh.vertices())
    EXPECT_TRUE(std::isfinite(uv[v][0]) && std::isfinite(uv[v][1]));
}

TEST(geodesic_lle, connects_groups_of_base_points)
{
  Mesh mesh = mesh_of(square(30, 0.2));
  auto uv = vertex_map<UV>(mesh);
  // Base points in two opposite corners, at some distance from each other.
  std::vector<Vertex> base;
  const auto add = [&](int row, int column)
  {
    for(const int i : {0, 3})
      for(const int j : {0, 3})
        base.push_back(Vertex(31 * (row + i) + column + j));
  };
  add(0, 0);
  add(27, 27);
  const auto flatten = [&](std::size_t neighbors)
  { GP::geodesic_lle(mesh, uv, GP::parameters::base_points(base).number_of_neighbors(neighbors)); };
  // The three nearest base points are in the same corner. The fourth nearest one is also known
  // and connects both corners.
  flatten(3);
  double max_error = 0.;
  for(const Vertex v : base)
    for(const Vertex w : base)
      max_error = std::max(
          max_error, std::abs(uv_distance(uv[v], uv[w]) -
                              std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)))));
  // The rigid fit stops before the few long-range links are satisfied exactly.
  EXPECT_LT(max_error, 0.02);
  // With eight base points per corner, all four known neighbors are in the same corner.
  add(0, 6);
  add(27, 21);
  EXPECT_THROW(flatten(3), GP::Invalid_argument_error);
  EXPECT_NO_THROW(flatten(6));
}

// Returns two dense squares that are joined by one long quad.
Triangulation dumbbell(std::size_t number, double length)
{
  Triangulation result = square(number);
  Triangulation second = square(number);
  for(Point& p : second.points)
    p[0] += 1. + length;
  const Index size = Index(result.points.size()), row = Index(number + 1);
  // The quad joins the middle edges of the facing sides.
  const Index a = row * Index(number / 2) + Index(number), b = size + row * Index(number / 2);
  result = disjoint_union(result, second);
  result.corners.insert(result.corners.end(), {a, b, b + row, a, b + row, a + row});
  return result;
}

TEST(geodesic_lle, default_number_of_neighbors_connects_groups)
{
  Mesh mesh = mesh_of(dumbbell(8, 20.));
  auto uv = vertex_map<UV>(mesh);
  for(const std::size_t number : {20u, 100u, 162u})
  {
    const auto np = GP::parameters::number_of_base_points(number);
    GP::geodesic_lle(mesh, uv, np);
    EXPECT_EQ(GP::flattening_distortion(mesh, uv).number_of_flips, 0u) << number;
  }
  // A given number is not increased by more than a quarter.
  EXPECT_THROW(GP::geodesic_lle(mesh, uv,
                                GP::parameters::number_of_base_points(std::size_t(162))
                                    .number_of_neighbors(std::size_t(10))),
               GP::Invalid_argument_error);
}

TEST(geodesic_lle, has_bounded_stretch_on_flat_annulus)
{
  Mesh mesh = mesh_of(annulus(48, 12, 1., 2.));
  auto uv = vertex_map<UV>(mesh);
  GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(std::size_t(100)));
  EXPECT_EQ(GP::flattening_distortion(mesh, uv).number_of_flips, 0u);
  for(const auto e : mesh.edges())
  {
    const Vertex v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
    // The required bound.
    EXPECT_LT(uv_distance(uv[v], uv[w]),
              2. * std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w))));
  }
}

TEST(geodesic_lle, throws_on_invalid_arguments)
{
  Mesh mesh = mesh_of(square(5, 0.2));
  auto uv = vertex_map<UV>(mesh);
  using GP::parameters::base_points;
  EXPECT_THROW(GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(std::size_t(2))),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(std::size_t(1001))),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_lle(mesh, uv, GP::parameters::number_of_neighbors(std::size_t(2))),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_lle(mesh, uv, base_points(std::vector<Vertex>{Vertex(1), Vertex(1)})),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_lle(mesh, uv, base_points(std::vector<Vertex>())),
               GP::Invalid_argument_error);
  Mesh empty;
  auto none = vertex_map<UV>(empty);
  EXPECT_THROW(GP::geodesic_lle(empty, none), GP::Invalid_argument_error);
  Triangulation above = square(5);
  for(Point& p : above.points)
    p[2] = 1.;
  Mesh two = mesh_of(disjoint_union(square(5), above));
  auto uv_of_two = vertex_map<UV>(two);
  EXPECT_THROW(GP::geodesic_lle(two, uv_of_two), GP::Unsupported_surface_error);
}

TEST(geodesic_lle, isolated_vertices_map_to_nan)
{
  Mesh mesh = mesh_of(square(8, 0.2));
  const Vertex isolated = mesh.add_vertex(Kernel::Point_3(5., 5., 5.));
  auto uv = vertex_map<UV>(mesh);
  GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(std::size_t(20)));
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(std::isnan(uv[v][0]), v == isolated);
}

TEST(geodesic_lle, can_be_cancelled)
{
  Mesh mesh = mesh_of(square(8, 0.2));
  auto uv = mesh.add_property_map<Vertex, UV>("v:uv", UV{7., 7.}).first;
  EXPECT_THROW(GP::geodesic_lle(mesh, uv,
                                GP::parameters::callback(
                                    std::function<bool(double)>([](double) { return false; }))),
               GP::Cancelled);
  EXPECT_EQ(uv[Vertex(3)], (UV{7., 7.}));
}

// Polyhedron_3 and OpenMesh meshes have no named property maps. Dynamic ones are used.
template <typename M>
void expect_same(const Triangulation& surface, const Mesh& mesh, const std::vector<UV>& expected)
{
  Numbered<M> other;
  fill(other, surface);
  auto uv = get(CGAL::dynamic_vertex_property_t<UV>(), other.mesh);
  GP::geodesic_lle(other.mesh, uv, GP::parameters::number_of_base_points(std::size_t(30)));
  for(const Vertex v : mesh.vertices())
    // The embedding of a square may be rotated, because its two eigenvectors share one eigenvalue.
    EXPECT_NEAR(uv_distance(get(uv, other.vertices[v]), get(uv, other.vertices[0])),
                uv_distance(expected[v], expected[0]), 1e-4); // fronts are not exact at their limit
}

TEST(geodesic_lle, is_independent_of_mesh_type)
{
  const Triangulation surface = square(9, 0.2);
  Mesh mesh = mesh_of(surface);
  auto uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
  GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(std::size_t(30)));
  std::vector<UV> expected;
  for(const Vertex v : mesh.vertices())
    expected.push_back({uv[v].x(), uv[v].y()});
  expect_same<CGAL::Polyhedron_3<Kernel>>(surface, mesh, expected);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  expect_same<OpenMesh::TriMesh_ArrayKernelT<>>(surface, mesh, expected);
#endif
}

TEST(geodesic_lle, flattens_clouds)
{
  const Surfels flat = flat_surfels(2000);
  CGAL::Point_set_3<Kernel::Point_3> cloud;
  cloud.add_normal_map();
  for(const auto& [point, normal] : flat)
    cloud.insert(point, normal);
  auto uv = cloud.add_property_map<UV>("uv").first;
  GP::geodesic_lle(cloud, uv, GP::parameters::number_of_base_points(std::size_t(60)));
  const auto first = *cloud.begin();
  double max_error = 0.;
  for(const auto& i : cloud)
    max_error = std::max(
        max_error, std::abs(uv_distance(uv[i], uv[first]) -
                            std::sqrt(CGAL::squared_distance(cloud.point(i), cloud.point(first)))));
  // Distances on clouds are accurate to a thousandth of the square's diagonal.
  EXPECT_LT(max_error, 2e-3);
}

TEST(geodesic_lle, isolated_surfels_map_to_nan)
{
  Surfels flat = flat_surfels(500);
  flat.push_back({{0.5, 0.5, 3.}, {0., 0., 1.}});
  // A point in the plane with a wrong normal.
  flat.push_back({{0.5, 0.51, 0.}, {1., 0., 0.}});
  std::vector<UV> uv(flat.size());
  GP::geodesic_lle(flat, CGAL::make_property_map(uv),
                   GP::parameters::number_of_base_points(std::size_t(30))
                       .point_map(Surfel_point_map())
                       .normal_map(Surfel_normal_map()));
  for(std::size_t i = 0; i < uv.size(); ++i)
    EXPECT_EQ(std::isnan(uv[i][0]), i >= 500) << i;
}

// Patches with little or no curvature, measured by the Gauss-Bonnet sum over interior vertices.
TEST(geodesic_lle, has_no_flips_on_gently_curved_patches)
{
  std::vector<std::pair<std::string, Mesh>> patches = {
      {"half of a sphere",
       mesh_of(part_of(icosphere(4), [](const Point& p) { return p[2] > 0.; }))},
      {"skin of an animal", mesh_of(part_of(animal(), [](const Point& p) { return p[2] > 0.8; }))},
      {"rolled sheet", mesh_of(rolled_sheet())}};
  add_models(patches, {"patches/hemisphere_2k.ply", "patches/disk_5k.ply",
                       "patches/alligator_3k.ply", "patches/cylinder_locally_refined_8k.ply"});
  for(auto& [name, mesh] : patches)
  {
    auto uv = vertex_map<UV>(mesh);
    GP::geodesic_lle(mesh, uv);
    EXPECT_EQ(GP::flattening_distortion(mesh, uv).number_of_flips, 0u) << name;
    for(const auto h : mesh.halfedges())
      EXPECT_LT(uv_distance(uv[mesh.source(h)], uv[mesh.target(h)]),
                2. * std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)),
                                                      mesh.point(mesh.target(h)))))
          << name;
  }
}

// The total curvature of both models is at least 4 pi. Their flattening has flips before
// unflipping.
TEST(geodesic_lle, unflips_few_inverted_faces)
{
  std::vector<std::pair<std::string, Mesh>> patches = {{"mushroom", mesh_of(mushroom())},
                                                       {"three peaks", mesh_of(three_peaks())}};
  add_models(patches, {"patches/mushroom_2k.off", "patches/three_peaks_2k.off"});
  for(auto& [name, mesh] : patches)
  {
    // With other numbers of base points, the linear maps of these models fold more faces than are
    // re-optimized.
    const std::size_t number = name == "mushroom" ? 220 : 270;
    auto uv = vertex_map<UV>(mesh);
    GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(number));
    EXPECT_EQ(GP::flattening_distortion(mesh, uv).number_of_flips, 0u) << name;
  }
}

} // namespace geodesic_lle_test
