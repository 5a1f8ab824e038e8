// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/decal.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"
#include "openmesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace decal_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Vector_3 = Kernel::Vector_3;
using GP::Decal_color;
using GP::Decal_coordinates;

template <typename TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
corners_of(typename boost::graph_traits<TriangleMesh>::face_descriptor face,
           const TriangleMesh& mesh)
{
  const auto h = halfedge(face, mesh);
  return {source(h, mesh), target(h, mesh), target(next(h, mesh), mesh)};
}

// Returns all data of a decal for comparison.
template <typename Surface>
auto flattened(const GP::Decal<Surface>& decal)
{
  std::vector<double> result;
  for(const auto& [vertex, uv] : decal.vertices)
    result.insert(result.end(), {double(std::size_t(vertex)), uv[0], uv[1]});
  for(const auto& [face, uvs] : decal.faces)
  {
    result.push_back(double(std::size_t(face)));
    for(const auto& uv : uvs)
      result.insert(result.end(), uv.begin(), uv.end());
  }
  return result;
}

// Checks a decal on a planar mesh: the UV coordinates of all corners and the set of faces. The set
// must contain exactly the faces that intersect the rectangle. Sample points may miss a face with
// a tiny intersection.
void expect_flat(const Mesh& mesh, const GP::Decal<Mesh>& decal, double width, double height)
{
  const auto uv_of = [&](const Vector_3& offset) -> Decal_coordinates {
    return {0.5 + offset * decal.frame.u / width, 0.5 + offset * decal.frame.v / height};
  };
  const auto offset_to = [&](Vertex v) { return mesh.point(v) - decal.frame.origin; };
  const auto expect_at = [&](Vertex v, const Decal_coordinates& uv)
  {
    // Logarithmic_map is exact to 1e-12 of the extent on a plane. The tolerance is relative to the
    // width.
    EXPECT_NEAR(uv[0], uv_of(offset_to(v))[0], 1e-11);
    EXPECT_NEAR(uv[1], uv_of(offset_to(v))[1], 1e-11);
  };
  const auto is_inside = [](const Decal_coordinates& uv)
  { return uv[0] > 0. && uv[0] < 1. && uv[1] > 0. && uv[1] < 1.; };

  std::set<Face> covered;
  for(const auto& [face, uvs] : decal.faces)
  {
    EXPECT_TRUE(covered.insert(face).second);
    for(std::size_t k = 0; k < 3; ++k)
      expect_at(corners_of(face, mesh)[k], uvs[k]);
  }
  for(const auto& [vertex, uv] : decal.vertices)
    expect_at(vertex, uv);
  std::size_t inside = 0, number_certain = 0;
  for(const Vertex v : mesh.vertices())
    inside += is_inside(uv_of(offset_to(v)));
  EXPECT_EQ(inside, decal.vertices.size());
  for(const Face f : mesh.faces())
  {
    const auto corners = corners_of(f, mesh);
    const int steps = 30;
    bool has_point = false;
    for(int i = 0; i <= steps; ++i)
      for(int j = 0; i + j <= steps; ++j)
        has_point =
            has_point || is_inside(uv_of((double(i) / steps) * offset_to(corners[0]) +
                                         (double(j) / steps) * offset_to(corners[1]) +
                                         (1. - double(i + j) / steps) * offset_to(corners[2])));
    number_certain += has_point;
    if(has_point)
    {
      EXPECT_EQ(covered.count(f), 1u);
    }
  }
  EXPECT_LE(number_certain, covered.size());
  EXPECT_GE(number_certain + 3, covered.size());
}

TEST(decal, is_exact_on_a_plane)
{
  for(const double factor : {1., 1e-6, 1e6})
  {
    const Mesh mesh = mesh_of(scaled(square(20, 0.25), factor));
    const double width = 0.4 * factor, height = 0.25 * factor;
    const auto decal =
        GP::Decal_placer<Mesh>(mesh).place(location_of(417, {0.2, 0.3, 0.5}), width, height,
                                           GP::parameters::up_direction(Vector_3(1., 2., 5.)));
    EXPECT_NEAR(decal.frame.v * Vector_3(1., 2., 0.), std::sqrt(5.), 1e-12); // round-off errors
    EXPECT_GT(decal.faces.size(), 50u);
    expect_flat(mesh, decal, width, height);
  }
}

TEST(decal, covers_faces_larger_than_those_at_center)
{
  // Columns are 5e-5 to 0.6 wide, and rows are 0.04 high. The size of the faces
  // near the center does not tell how far away the corners of the last columns are.
  Triangulation surface = square(24);
  for(auto& p : surface.points)
    p[0] = std::pow(1.5, 24. * p[0]) * 1e-4;
  const Mesh mesh = mesh_of(surface);
  const auto decal = GP::Decal_placer<Mesh>(mesh).place(
      Vertex(25 * 12 + 12), 2., 0.1, GP::parameters::up_direction(Vector_3(0., 1., 0.)));
  expect_flat(mesh, decal, 2., 0.1);
  double farthest = 0.;
  for(const auto& [face, uvs] : decal.faces)
    for(const auto& uv : uvs)
      farthest = std::max(farthest, uv[0]);
  EXPECT_GT(farthest, 1.03); // exceeds the rectangle by more than the longest edge
}

TEST(decal, preserves_distances_and_directions_on_a_sphere)
{
  const Mesh mesh = mesh_of(icosphere(5));
  GP::Decal_placer<Mesh> placer(mesh);
  const double width = 1., height = 0.6;
  const auto decal =
      placer.place(Vertex(77), width, height, GP::parameters::up_direction(Vector_3(0., 0., 1.)));
  const auto tangent = [&](Vertex vertex)
  {
    const Vector_3 to = mesh.point(vertex) - CGAL::ORIGIN, base = decal.frame.origin - CGAL::ORIGIN;
    const double u = to * decal.frame.u, v = to * decal.frame.v, size = std::hypot(u, v);
    const double angle = std::atan2(size, to * base);
    return size > 0. ? Decal_coordinates{angle * u / size, angle * v / size}
                     : Decal_coordinates{0., 0.};
  };
  // Tangent vectors of length at most 0.6 err by 0.1 % in the mean. The maximum error is a few
  // times as large.
  const double tolerance = 0.004;
  std::set<Face> covered;
  for(const auto& [face, uvs] : decal.faces)
  {
    covered.insert(face);
    for(std::size_t k = 0; k < 3; ++k)
    {
      const auto expected = tangent(corners_of(face, mesh)[k]);
      EXPECT_NEAR((uvs[k][0] - 0.5) * width, expected[0], tolerance);
      EXPECT_NEAR((uvs[k][1] - 0.5) * height, expected[1], tolerance);
    }
  }
  // If a face has a corner inside the rectangle by more than the tolerance, it must be covered. If
  // a face lies on one side of the rectangle, it must not be covered.
  std::size_t number_certain = 0;
  for(const Face f : mesh.faces())
  {
    bool has_corner = false, is_on_one_side = false;
    for(const int c : {0, 1})
    {
      const double half_size = (c == 0 ? width : height) / 2.;
      double low = 1e9, high = -1e9;
      for(const Vertex v : corners_of(f, mesh))
      {
        low = std::min(low, tangent(v)[c]);
        high = std::max(high, tangent(v)[c]);
      }
      is_on_one_side =
          is_on_one_side || low > half_size + tolerance || high < -half_size - tolerance;
    }
    for(const Vertex v : corners_of(f, mesh))
      has_corner = has_corner || (std::abs(tangent(v)[0]) < width / 2. - tolerance &&
                                  std::abs(tangent(v)[1]) < height / 2. - tolerance);
    if(has_corner)
    {
      ++number_certain;
      EXPECT_EQ(covered.count(f), 1u);
    }
    if(is_on_one_side)
    {
      EXPECT_EQ(covered.count(f), 0u);
    }
  }
  EXPECT_GT(number_certain, 500u);
}

TEST(decal, placer_is_reusable)
{
  const Mesh mesh = mesh_of(icosphere(4));
  GP::Decal_placer<Mesh> placer(mesh);
  for(const int vertex : {0, 100, 2000, 7})
  {
    GP::Decal_placer<Mesh> fresh(placer.domain());
    const double size = vertex == 100 ? 2. : 0.3;
    const auto np = GP::parameters::up_direction(Vector_3(0.1, 0.2, 1.));
    EXPECT_EQ(flattened(placer.place(Vertex(vertex), size, 0.5, np)),
              flattened(fresh.place(Vertex(vertex), size, 0.5, np)));
  }
}

TEST(decal, may_be_smaller_than_a_face)
{
  const Mesh mesh = mesh_of(square(4));
  GP::Decal_placer<Mesh> placer(mesh);
  const auto small = placer.place(location_of(9, {0.3, 0.3, 0.4}), 1e-3, 1e-3);
  ASSERT_EQ(small.faces.size(), 1u);
  EXPECT_EQ(small.faces[0].face, Face(9));
  EXPECT_TRUE(small.vertices.empty());
  // At an edge midpoint and at a vertex.
  EXPECT_EQ(placer.place(location_of(9, {0.5, 0., 0.5}), 1e-3, 1e-3).faces.size(), 2u);
  EXPECT_EQ(placer.place(Vertex(12), 1e-3, 1e-3).faces.size(), degree(Vertex(12), mesh));
}

TEST(decal, ends_at_boundary)
{
  const Mesh mesh = mesh_of(square(10));
  GP::Decal_placer<Mesh> placer(mesh);
  // The decal covers the whole square as seen from its corner.
  EXPECT_EQ(placer.place(Vertex(0), 5., 5.).faces.size(), num_faces(mesh));
  EXPECT_EQ(placer.place(Vertex(0), 5., 5.).vertices.size(), num_vertices(mesh));
}

TEST(decal, has_seam_behind_a_cylinder)
{
  // The decal is as wide as two and a half turns, and ten rows of faces high.
  const Mesh mesh = mesh_of(cylinder(60, 30, 1., 6.));
  GP::Decal_placer<Mesh, GP::Exact> placer(mesh);
  const double width = 16., side = 2. * CGAL_PI / 60.;
  const auto decal =
      placer.place(Vertex(60 * 15), width, 2., GP::parameters::up_direction(Vector_3(0., 0., 1.)));
  std::set<Face> covered;
  for(const auto& [face, uvs] : decal.faces)
  {
    covered.insert(face);
    for(const auto& uv : uvs) // faces at the seam exceed it by a fraction of their size
      EXPECT_LE(std::abs(uv[0] - 0.5) * width, CGAL_PI + side);
    for(int k = 0; k < 3; ++k) // no face is stretched over the seam
      EXPECT_LT(std::abs(uvs[k][0] - uvs[(k + 1) % 3][0]) * width, 1.01 * side);
  }
  EXPECT_GE(covered.size(), 10u * 2u * 60u); // no hole
}

TEST(decal, composites_colors)
{
  Mesh mesh = mesh_of(square(10));
  GP::Decal_placer<Mesh> placer(mesh);
  const auto left_half_green = [](const Decal_coordinates& p) {
    return p[0] < 0.5 ? Decal_color{0., 1., 0., 1.} : Decal_color{0., 0., 0., 0.};
  };
  const auto half_blue = [](const Decal_coordinates&) { return Decal_color{0., 0., 1., 0.5}; };
  const auto up = GP::parameters::up_direction(Vector_3(0., 1., 0.));
  const auto large = placer.place(Vertex(60), 0.5, 0.5, up),
             small = placer.place(Vertex(60), 0.3, 0.3, up);

  auto colors = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color", CGAL::IO::red()).first;
  GP::composite_decal(large, left_half_green, colors);
  GP::composite_decal(small, half_blue, colors);
  auto exact = mesh.add_property_map<Vertex, Decal_color>("v:rgba", {1., 0., 0., 1.}).first;
  GP::composite_decal(large, left_half_green, exact);
  GP::composite_decal(small, half_blue, exact);
  for(const Vertex v : mesh.vertices())
  {
    const double x = mesh.point(v).x() - 0.5, y = mesh.point(v).y() - 0.5;
    const bool is_in_large = std::max(std::abs(x), std::abs(y)) < 0.26,
               is_in_small = std::max(std::abs(x), std::abs(y)) < 0.16;
    Decal_color expected = {1., 0., 0., 1.};
    if(is_in_large && x < -0.05)
      expected = {0., 1., 0., 1.};
    if(std::abs(x) < 0.05)
      continue; // round-off errors decide if a vertex on the center line is left of it
    if(is_in_small)
      for(int c = 0; c < 3; ++c)
        expected[c] = 0.5 * expected[c] + (c == 2 ? 0.5 : 0.);
    for(int c = 0; c < 4; ++c)
    {
      EXPECT_NEAR(exact[v][c], expected[c], 1e-15);      // round-off errors
      EXPECT_NEAR(colors[v][c], 255. * expected[c], 1.); // one byte of error for two images
    }
  }
}

TEST(decal, baked_texture_matches_images)
{
  const Mesh mesh = mesh_of(icosphere(3));
  GP::Decal_placer<Mesh> placer(mesh);
  // Linear images are reproduced exactly by interpolation between texels.
  const auto ramp = [](const Decal_coordinates& p) { return Decal_color{p[0], p[1], 0., 1.}; };
  const auto glass = [](const Decal_coordinates&) { return Decal_color{0., 0., 1., 0.25}; };
  const std::vector<GP::Decal_layer<Mesh>> layers = {{placer.place(Vertex(0), 0.8, 0.8), ramp},
                                                     {placer.place(Vertex(20), 0.7, 0.5), glass}};
  const auto texture =
      GP::bake_decals(layers, 6, GP::parameters::background(GP::Decal_color{0.5, 0.5, 0.5, 1.}));
  ASSERT_EQ(texture.texels.size(), texture.width * texture.height);
  const auto at = [&](const Decal_coordinates& uv)
  {
    const double x = uv[0] * double(texture.width) - 0.5 + 1e-9,
                 y = uv[1] * double(texture.height) - 0.5 + 1e-9;
    return texture.texels[std::size_t(y) * texture.width + std::size_t(x)];
  };
  EXPECT_EQ(at(texture.background), (Decal_color{0.5, 0.5, 0.5, 1.}));
  std::set<Face> covered;
  for(const auto& [face, corners] : texture.faces)
  {
    EXPECT_TRUE(covered.insert(face).second);
    for(std::size_t k = 0; k < 3; ++k)
    {
      Decal_color expected = {0.5, 0.5, 0.5, 1.};
      bool is_sure = true;
      for(const auto& layer : layers)
        for(const auto& decal_face : layer.decal.faces)
          if(decal_face.face == face)
          {
            const auto& p = decal_face.coordinates[k];
            const double beyond = std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5)) - 0.5;
            is_sure = is_sure && std::abs(beyond) > 1e-9;
            if(beyond < 0.)
              expected = GP::internal::blend_over(layer.image(p), expected);
          }
      if(is_sure)
      {
        for(int c = 0; c < 4; ++c)
          EXPECT_NEAR(at(corners[k])[c], expected[c],
                      1e-12); // round-off errors: corners are texel centers
      }
    }
  }
  std::set<Face> any_covered;
  for(const auto& layer : layers)
    for(const auto& decal_face : layer.decal.faces)
      any_covered.insert(decal_face.face);
  EXPECT_EQ(covered, any_covered);
  EXPECT_LT(any_covered.size(),
            layers[0].decal.faces.size() + layers[1].decal.faces.size()); // the decals overlap
  EXPECT_THROW(GP::bake_decals(layers, 0), GP::Invalid_argument_error);
  EXPECT_EQ(GP::bake_decals<Mesh>({}, 3).faces.size(), 0u);
}

// Returns the numbers of faces, vertices and baked faces of one decal, for any mesh type.
template <typename TriangleMesh>
std::array<std::size_t, 3> counts_on_sphere()
{
  Numbered<TriangleMesh> sphere;
  fill(sphere, icosphere(3));
  const auto decal =
      GP::Decal_placer<TriangleMesh>(sphere.mesh)
          .place(sphere.vertices[5], 0.83, 0.47, // no boundary of the decal lies along an edge
                 GP::parameters::up_direction(
                     typename GP::Decal_placer<TriangleMesh>::Domain::Vector_3(0.1f, 0.3f, 1.f)));
  const GP::Decal_image red = [](const Decal_coordinates&) { return Decal_color{1., 0., 0., 1.}; };
  return {decal.faces.size(), decal.vertices.size(),
          GP::bake_decals<TriangleMesh>({{decal, red}}, 2).faces.size()};
}

TEST(decal, supports_all_mesh_types)
{
  const auto counts = counts_on_sphere<Mesh>();
  EXPECT_GT(counts[0], 20u);
  EXPECT_EQ(counts[2], counts[0]);
  EXPECT_EQ(counts_on_sphere<CGAL::Polyhedron_3<Kernel>>(), counts);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  EXPECT_EQ(counts_on_sphere<OpenMesh::TriMesh_ArrayKernelT<>>(), counts);
#endif
}

TEST(decal, covers_surfels_of_a_cloud)
{
  CGAL::Point_set_3<Kernel::Point_3> cloud;
  cloud.add_normal_map();
  for(int i = 0; i <= 20; ++i)
    for(int j = 0; j <= 20; ++j)
      cloud.insert(Kernel::Point_3(0.05 * i, 0.05 * j, 0.), Vector_3(0., 0., 1.));
  auto colors = cloud.add_property_map<std::array<double, 3>>("rgb", {1., 1., 1.}).first;
  GP::Decal_placer<CGAL::Point_set_3<Kernel::Point_3>> placer(cloud);
  const auto decal = placer.place(*(cloud.begin() + 10 * 21 + 10), 0.44, 0.28,
                                  GP::parameters::up_direction(Vector_3(0., 1., 0.)));
  EXPECT_EQ(decal.vertices.size(), 9u * 5u);
  for(const auto& [surfel, uv] : decal.vertices)
  {
    // Fronts on clouds use chords. The error is at most 1 % of the distance.
    EXPECT_NEAR((uv[0] - 0.5) * 0.44, cloud.point(surfel).x() - 0.5, 0.003);
    EXPECT_NEAR((uv[1] - 0.5) * 0.28, cloud.point(surfel).y() - 0.5, 0.003);
  }
  GP::composite_decal(
      decal,
      [](const Decal_coordinates&) {
        return Decal_color{1., 0., 0., 0.5};
      },
      colors);
  std::size_t painted = 0;
  for(const auto& surfel : cloud)
    painted += colors[surfel] == std::array<double, 3>{1., 0.5, 0.5};
  EXPECT_EQ(painted, decal.vertices.size());
}

TEST(decal, throws_on_invalid_input)
{
  const Mesh mesh = mesh_of(square(3));
  GP::Decal_placer<Mesh> placer(mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  for(const double invalid : {0., -1., nan, infinite})
  {
    EXPECT_THROW(placer.place(Vertex(5), invalid, 1.), GP::Invalid_argument_error);
    EXPECT_THROW(placer.place(Vertex(5), 1., invalid), GP::Invalid_argument_error);
  }
  EXPECT_THROW(placer.place(Vertex(99), 1., 1.), GP::Invalid_argument_error);
  EXPECT_THROW(placer.place(Vertex(5), 1., 1., GP::parameters::up_direction(Vector_3(0., 0., 1.))),
               GP::Invalid_argument_error);
}

} // namespace decal_test
