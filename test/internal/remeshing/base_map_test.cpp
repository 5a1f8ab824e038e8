// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/base_map.h>

#include <CGAL/Geodesic_processing/internal/mesh/feature_polylines.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/subdivision/subdivision.h>

#include "Array_surface.h"
#include "pockets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>

namespace base_map_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

std::shared_ptr<const Base_mesh> base_of(const Array_surface& surface, std::size_t number)
{
  Remeshing_options options;
  options.number_of_samples = number;
  return std::make_shared<const Base_mesh>(build_base_mesh(surface.triangles(), options));
}

// Returns the base mesh of a disk with a single triangle, whose corners are the given boundary
// points; null if its edges cannot be traced.
std::shared_ptr<const Base_mesh> one_face(const Array_surface& disk,
                                          const std::array<Index, 3>& points)
{
  std::vector<Surface_location> samples;
  for(const Index i : points)
    samples.push_back(vertex_location(disk.t(), disk.vertex(i)));
  auto found =
      build_base_mesh(disk.t(), samples, {{0, 1, 2}}, boundary_and_sharp_halfedges(disk.t()));
  return found ? std::make_shared<const Base_mesh>(std::move(*found)) : nullptr;
}

constexpr std::array<Base_coordinates, 3> kinds = {
    Base_coordinates::heron, Base_coordinates::mean_value, Base_coordinates::uniform};

std::vector<Triangulation> surfaces()
{
  return {icosphere(3), torus(24, 16), double_torus(), jittered(square(16), 0.3, 2),
          annulus(24, 8, 1., 3.)};
}

TEST(Base_map, has_no_folded_triangles)
{
  for(const Triangulation& surface : surfaces())
  {
    const Array_surface arrays(surface);
    const auto base = base_of(arrays, 40);
    for(const Base_coordinates kind : kinds)
    {
      const Base_map map(base, kind);
      EXPECT_EQ(map.number_of_flips(), 0u);
      std::vector<double> area(base->triangles.size(), 0.);
      for(std::size_t c = 0; c < map.coordinates().size(); c += 3)
      {
        const auto* b = &map.coordinates()[c];
        const double twice =
            (b[1][1] - b[0][1]) * (b[2][2] - b[0][2]) - (b[1][2] - b[0][2]) * (b[2][1] - b[0][1]);
        EXPECT_GT(twice, 0.);
        area[base->region[c / 3]] += twice;
      }
      // The images cover each base triangle. As they are positively oriented, the map is bijective.
      for(const double twice : area)
        EXPECT_NEAR(twice, 1., 1e-12);
    }
  }
}

// A pocket between two edges of the same vertices has no image with straight edges, unless one of
// the edges is split.
TEST(Base_map, has_no_folded_triangles_in_pockets)
{
  for(const std::size_t number_of_pockets : {1u, 10u, 40u})
  {
    const auto surface = with_pockets(icosphere(2), number_of_pockets);
    Remeshing_options options;
    options.number_of_samples = 30;
    const auto base = std::make_shared<const Base_mesh>(build_base_mesh(surface, options));
    for(const Base_coordinates kind : kinds)
    {
      const Base_map map(base, kind);
      EXPECT_EQ(map.number_of_flips(), 0u) << number_of_pockets << " pockets";
    }
  }
}

// A triangle with a thin tube close to corner `k`. The images of the rings of the tube are much
// closer to the corner than the round-off error of one.
TEST(Base_map, has_no_folded_triangles_in_a_tube_at_a_corner)
{
  const double d = 1e-9;
  const Index number_of_rings = 12;
  Triangulation surface;
  surface.points = {{0., 0., 0.}, {d, 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {0., d, 0.}};
  surface.corners = {1, 2, 3, 1, 3, 4};
  std::array<Index, 3> ring = {0, 1, 4};
  for(Index i = 0; i < number_of_rings; ++i)
  {
    const Index next = Index(surface.points.size());
    for(const auto& [x, y] : {std::pair(0.2, 0.2), std::pair(0.5, 0.2), std::pair(0.2, 0.5)})
      surface.points.push_back({x * d, y * d, double(i) * d});
    for(Index j = 0; j < 3; ++j)
    {
      const Index a = ring[j], b = ring[(j + 1) % 3], c = next + j, e = next + (j + 1) % 3;
      surface.corners.insert(surface.corners.end(), {a, b, e, a, e, c});
    }
    ring = {next, next + 1, next + 2};
  }
  surface.corners.insert(surface.corners.end(), {ring[0], ring[1], ring[2]});
  const Array_surface disk(surface);
  for(const std::array<Index, 3>& corners :
      {std::array<Index, 3>{0, 2, 3}, std::array<Index, 3>{3, 0, 2}, std::array<Index, 3>{2, 3, 0}})
  {
    const auto base = one_face(disk, corners);
    ASSERT_TRUE(base);
    for(const Base_coordinates kind : kinds)
    {
      const Base_map map(base, kind);
      EXPECT_EQ(map.number_of_flips(), 0u);
      for(std::size_t k = 0; k < 3; ++k)
      {
        std::array<double, 3> b = {0., 0., 0.};
        b[k] = 1.;
        const Vec3 p = scaled_coordinates(disk.t(), map.inverse({0, b})),
                   q = scaled_coordinates(disk.t(),
                                          vertex_location(disk.t(), disk.vertex(corners[k])));
        EXPECT_LT(norm(p - q), 1e-8); // ten times the width of the tube
      }
    }
  }
}

TEST(Base_map, is_continuous_across_edges)
{
  for(const Triangulation& surface : surfaces())
  {
    const Array_surface arrays(surface);
    const auto base = base_of(arrays, 40);
    const Base_map map(base, Base_coordinates::heron);
    for(Index h = 0; h < base->fine.corner.size(); ++h)
    {
      const Index edge = base->edge_of_halfedge[h], twin = base->fine.twin[h];
      if(edge == none || twin == none)
        continue;
      for(const auto& [own, other] :
          {std::pair(h, next_halfedge(twin)), std::pair(next_halfedge(h), twin)})
      {
        // Coordinates by base vertex must be equal in both base triangles, bit by bit.
        std::map<Index, double> weights, other_weights;
        for(Index k = 0; k < 3; ++k)
        {
          const double a = map.coordinates()[own][k], b = map.coordinates()[other][k];
          if(a != 0.)
            weights[base->triangles[base->region[own / 3]][k]] = a;
          if(b != 0.)
            other_weights[base->triangles[base->region[other / 3]][k]] = b;
        }
        EXPECT_EQ(weights, other_weights);
        EXPECT_LE(weights.size(), 2u);
      }
    }
  }
}

TEST(Base_map, edge_coordinates_follow_arc_length)
{
  const Array_surface surface(icosphere(3));
  const auto base = base_of(surface, 30);
  const Base_map map(base, Base_coordinates::heron);
  for(Index h = 0; h < base->fine.corner.size(); ++h)
  {
    const Index edge = base->edge_of_halfedge[h];
    if(edge == none)
      continue;
    double total_length = 0., partial_length = 0.;
    const std::vector<Index>& path = base->path[edge];
    for(std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      const double segment_length = norm(base->fine.point[path[i + 1]] - base->fine.point[path[i]]);
      total_length += segment_length;
      if(path[i] == base->fine.corner[h] || path[i + 1] == base->fine.corner[h])
        partial_length = path[i] == base->fine.corner[h] ? partial_length : total_length;
    }
    const auto& f = base->triangles[base->region[h / 3]];
    const Index first = base->triangles[base->halfedge[edge] / 3][base->halfedge[edge] % 3];
    const std::size_t k = std::size_t(std::find(f.begin(), f.end(), first) - f.begin());
    EXPECT_NEAR(map.coordinates()[h][k], 1. - partial_length / total_length,
                1e-13); // sums of up to some tens of lengths
  }
}

// In the plane geodesic distances are Euclidean, and edges are straight.
TEST(Base_map, heron_coordinates_of_planar_triangle_are_affine)
{
  const Subdivision subdivision = subdivide({{0, 1, 2}}, 3, 4);
  const std::array<Point, 3> corner = {Point{0., 0., 0.}, Point{2., 0.3, 1.},
                                       Point{0.5, 1.7, -0.2}};
  Triangulation surface;
  for(const Coarse_location& location : coarse_locations(subdivision))
  {
    surface.points.push_back({0., 0., 0.});
    for(std::size_t k = 0; k < 3; ++k)
      surface.points.back() = surface.points.back() + (location.coordinates[k] / 16.) * corner[k];
  }
  for(const Triangle& f : subdivision.finest().triangles)
    surface.corners.insert(surface.corners.end(), f.begin(), f.end());
  const Array_surface arrays(surface);
  const auto base = one_face(arrays, {0, 1, 2});
  ASSERT_TRUE(base);
  const Base_map raw(base, Base_coordinates::heron, false);
  EXPECT_EQ(raw.number_of_flips(), 0u);
  for(std::size_t c = 0; c < raw.coordinates().size(); ++c)
  {
    Point p = {0., 0., 0.};
    for(std::size_t k = 0; k < 3; ++k)
      p = p + raw.coordinates()[c][k] * base->fine.point[base->vertex[k]];
    // Round-off errors of distances. Areas amplify them by at most the size of the base triangle
    // divided by the distance of a vertex from the edge, which is 64 if a boundary edge is split.
    EXPECT_LT(norm(p - base->fine.point[base->fine.corner[c]]), 64 * 1e-13);
  }
}

TEST(Base_map, round_trip_is_identity)
{
  for(const Triangulation& surface : surfaces())
  {
    const Array_surface arrays(surface);
    const auto base = base_of(arrays, 40);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0., 1.);
    const auto barycentric = [&]() -> std::array<double, 3>
    {
      const double x = std::sqrt(uniform(random)), y = uniform(random);
      return {1. - x, x * (1. - y), x * y};
    };
    for(const Base_coordinates kind : kinds)
    {
      const Base_map map(base, kind);
      for(int i = 0; i < 1000; ++i)
      {
        const Surface_location location{Index(random() % arrays.t().number_of_triangles()), none,
                                        barycentric()};
        const Surface_location round_trip = map.inverse(map(location));
        // At most 1e-8 edge lengths: flatter images are repaired.
        EXPECT_LT(norm(scaled_coordinates(arrays.t(), location) -
                       scaled_coordinates(arrays.t(), round_trip)),
                  1e-7);
        const Base_location base_location{Index(random() % base->triangles.size()), barycentric()};
        const Base_location found = map(map.inverse(base_location));
        ASSERT_EQ(found.triangle, base_location.triangle);
        // Measured are 2e-13.
        for(std::size_t k = 0; k < 3; ++k)
          EXPECT_NEAR(found.barycentric[k], base_location.barycentric[k], 1e-11);
      }
    }
  }
}

TEST(Base_map, handles_zero_angles)
{
  Triangulation surface = {{{0., 0., 0.}}, {}};
  for(Index k = 0; k < 8; ++k)
  {
    surface.points.push_back({double(k + 1), 0., 0.});
    for(const Index corner : {Index(0), k + 1, (k + 1) % 8 + 1})
      surface.corners.push_back(corner);
  }
  const Array_surface arrays(surface);
  const auto base = one_face(arrays, {1, 4, 6});
  ASSERT_TRUE(base);
  for(const Base_coordinates kind : kinds)
  {
    const Base_map map(base, kind, false);
    for(const auto& b : map.coordinates())
      EXPECT_NEAR(b[0] + b[1] + b[2], 1., 1e-15); // the round-off errors of two additions
    EXPECT_EQ(Base_map(base, kind).number_of_flips(), 0u);
  }
}

// A tube of rings, closed at one end. In convex combinations, the size of the images decreases
// exponentially with the distance from the boundary.
Triangulation closed_tube(Index rings, Index size)
{
  Triangulation surface;
  for(Index i = 0; i < rings; ++i)
    for(Index k = 0; k < size; ++k)
    {
      const double angle = 2. * pi * k / size;
      surface.points.push_back({std::cos(angle), std::sin(angle), double(i)});
    }
  for(Index i = 0; i + 1 < rings; ++i)
    for(Index k = 0; k < size; ++k)
    {
      const Index a = size * i + k, b = size * i + (k + 1) % size;
      surface.corners.insert(surface.corners.end(), {a, b, b + size, a, b + size, a + size});
    }
  surface.points.push_back({0., 0., double(rings)});
  for(Index k = 0; k < size; ++k)
    surface.corners.insert(
        surface.corners.end(),
        {size * (rings - 1) + k, size * (rings - 1) + (k + 1) % size, size * rings});
  return surface;
}

TEST(Base_map, does_not_repair_uniform_coordinates)
{
  const Array_surface arrays(closed_tube(40, 3));
  const auto base = one_face(arrays, {0, 1, 2});
  ASSERT_TRUE(base);
  EXPECT_EQ(Base_map(base, Base_coordinates::mean_value).number_of_repaired_regions(), 1u);
  EXPECT_EQ(Base_map(base, Base_coordinates::uniform).number_of_repaired_regions(), 0u);
}

TEST(Base_map, samples_are_added_where_triangles_are_inverted)
{
  const Array_surface arrays(closed_tube(60, 6));
  Remeshing_options options;
  options.number_of_samples = 3;
  for(const Index i : {0, 2, 4})
    options.first_samples.push_back(vertex_location(arrays.t(), arrays.vertex(i)));
  const auto base = std::make_shared<const Base_mesh>(build_base_mesh(arrays.triangles(), options));
  for(const Base_coordinates kind : kinds)
  {
    const Base_map without(base, kind);
    EXPECT_GT(without.number_of_flips(), 0u);
    EXPECT_EQ(without.centers_of_inverted_regions().size(), 1u);
    const auto with = build_base_map(arrays.triangles(), options, kind);
    EXPECT_EQ(with->number_of_flips(), 0u);
    EXPECT_GT(with->base().samples.size(), base->samples.size());
    for(std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(with->base().samples[i].vertex, options.first_samples[i].vertex);
  }
}

} // namespace base_map_test
