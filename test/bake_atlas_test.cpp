// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/bake_atlas.h>

#include <CGAL/Geodesic_processing/texture_atlas.h>

#include <CGAL/boost/graph/generators.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bake_atlas_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using UV = std::array<double, 2>;

struct Baked
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Halfedge_index, UV> uv;
  GP::Texture_atlas atlas;
  std::size_t size = 256;
  std::vector<GP::Decal_color> texels;

  template <typename Color>
  Baked(const Triangulation& surface, std::size_t gutter, const Color& color)
      : mesh(mesh_of(surface)), uv(mesh.add_property_map<Mesh::Halfedge_index, UV>("h:uv").first)
  {
    atlas = GP::texture_atlas(mesh, 8, uv, GP::parameters::texture_size(size).gutter_width(gutter));
    texels = GP::bake_atlas(
        mesh, uv, [&](const auto& location) { return color(mesh, location); }, size,
        GP::parameters::gutter_width(gutter).background(GP::Decal_color{0., 0., 1., 1.}));
  }

  // Interpolates between the centers of four texels.
  GP::Decal_color lookup(const UV& texture_point) const
  {
    const double x = texture_point[0] * double(size) - 0.5,
                 y = texture_point[1] * double(size) - 0.5;
    const double i = std::floor(x), j = std::floor(y);
    GP::Decal_color result = {0., 0., 0., 0.};
    for(const int right : {0, 1})
      for(const int up : {0, 1})
      {
        const double weight = (right ? x - i : i + 1. - x) * (up ? y - j : j + 1. - y);
        for(std::size_t c = 0; c < 4; ++c)
          result[c] += weight * texels[std::size_t(j + up) * size + std::size_t(i + right)][c];
      }
    return result;
  }

  UV uv_of(const std::pair<Face, std::array<double, 3>>& location) const
  {
    const auto h = mesh.halfedge(location.first);
    const auto& b = location.second;
    const UV &p = uv[mesh.prev(h)], &q = uv[h], &r = uv[mesh.next(h)];
    return {b[0] * p[0] + b[1] * q[0] + b[2] * r[0], b[0] * p[1] + b[1] * q[1] + b[2] * r[1]};
  }
};

double height(const Mesh& mesh, const std::pair<Face, std::array<double, 3>>& location)
{
  auto h = mesh.halfedge(location.first);
  double result = 0.;
  for(const double weight : location.second)
  {
    result += weight * mesh.point(mesh.source(h)).z();
    h = mesh.next(h);
  }
  return result;
}

TEST(bake_atlas, background_is_not_sampled)
{
  for(const std::size_t gutter : {3u, 8u})
  {
    const Baked baked(torus(20, 10), gutter,
                      [](const Mesh&, const auto&) {
                        return GP::Decal_color{1., 0., 0., 1.};
                      });
    std::mt19937 random(1);
    for(int i = 0; i < 5000; ++i)
    {
      auto location = random_location_of(baked.mesh, random);
      if(i % 2 == 0) // points on edges, including seams
        location.second = {location.second[0], 1. - location.second[0], 0.};
      const GP::Decal_color color = baked.lookup(baked.uv_of(location));
      EXPECT_NEAR(color[0], 1., 1e-12); // a weighted mean of equal colors
      EXPECT_NEAR(color[2], 0., 1e-12);
    }
    // The decal was baked.
    EXPECT_GT(std::count(baked.texels.begin(), baked.texels.end(), GP::Decal_color{0., 0., 1., 1.}),
              100);
  }
}

TEST(bake_atlas, colors_match_surface_positions)
{
  const Baked baked(icosphere(3), 4,
                    [](const Mesh& mesh, const auto& location) {
                      return GP::Decal_color{height(mesh, location), 0., 0., 1.};
                    });
  ASSERT_TRUE(baked.atlas.is_injective());
  std::mt19937 random(2);
  double max_error = 0.;
  for(int i = 0; i < 5000; ++i)
  {
    const auto location = random_location_of(baked.mesh, random);
    max_error = std::max(
        max_error, std::abs(baked.lookup(baked.uv_of(location))[0] - height(baked.mesh, location)));
  }
  // The four texels show points within two texel diagonals. Charts shrink lengths by at most a
  // factor of two.
  EXPECT_LT(max_error, 2. * 2. * std::sqrt(2.) / baked.atlas.texels_per_length);
}

TEST(bake_atlas, throws_on_invalid_size)
{
  Mesh mesh = mesh_of(one_triangle());
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, UV>("h:uv").first;
  const auto white = [](const auto&) { return GP::Decal_color{1., 1., 1., 1.}; };
  EXPECT_THROW(GP::bake_atlas(mesh, uv, white, 0), GP::Invalid_argument_error);
  EXPECT_THROW(GP::bake_atlas(mesh, uv, white, 20000), GP::Invalid_argument_error);
}

TEST(bake_atlas, throws_on_non_triangular_faces)
{
  Mesh mesh;
  CGAL::make_quad(Kernel::Point_3(0., 0., 0.), Kernel::Point_3(1., 0., 0.),
                  Kernel::Point_3(1., 1., 0.), Kernel::Point_3(0., 1., 0.), mesh);
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, UV>("h:uv").first;
  EXPECT_THROW(GP::bake_atlas(
                   mesh, uv, [](const auto&) { return GP::Decal_color(); }, 16),
               GP::Unsupported_surface_error);
}

TEST(bake_atlas, accepts_domain)
{
  const auto color = [](const Mesh&, const auto& location) {
    return GP::Decal_color{location.second[0], location.second[1], location.second[2], 1.};
  };
  const Baked baked(icosphere(1), 4, color);
  const auto texels = GP::bake_atlas(
      GP::make_domain(baked.mesh), baked.uv,
      [&](const auto& location) { return color(baked.mesh, location); }, baked.size,
      GP::parameters::background(GP::Decal_color{0., 0., 1., 1.}));
  EXPECT_EQ(texels, baked.texels);
}

} // namespace bake_atlas_test
