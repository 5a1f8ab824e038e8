// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/base_map.h>

#include <CGAL/Geodesic_processing/internal/mesh/curves.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include <CGAL/Geodesic_processing/internal/subdivision/subdivision.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

std::shared_ptr<const Base_mesh> base_of(const Glued_surface& surface, std::size_t number)
{
  Remeshing_goal goal;
  goal.number = number;
  return std::make_shared<const Base_mesh>(base_mesh(surface.triangles(), goal));
}

// A disc is one base face between three points of its border; nothing where that cannot be drawn.
std::shared_ptr<const Base_mesh> one_face(const Glued_surface& disc,
                                          const std::array<Index, 3>& points)
{
  std::vector<Location> samples;
  for(const Index i : points)
    samples.push_back(at_site(disc.t(), disc.site(i)));
  auto found = base_mesh(disc.t(), samples, {{0, 1, 2}}, border_and_sharp_sides(disc.t()));
  return found ? std::make_shared<const Base_mesh>(std::move(*found)) : nullptr;
}

constexpr std::array<Base_coordinates, 3> kinds = {
    Base_coordinates::heron, Base_coordinates::mean_value, Base_coordinates::uniform};

std::vector<Triangulation> surfaces()
{
  return {icosphere(3), torus(24, 16), double_ring(), shaken(square(16), 0.3, 2),
          annulus(24, 8, 1., 3.)};
}

TEST(Base_map, folds_no_triangle)
{
  for(const Triangulation& surface : surfaces())
  {
    const Glued_surface glued(surface);
    const auto base = base_of(glued, 40);
    for(const Base_coordinates kind : kinds)
    {
      const Base_map map(base, kind);
      EXPECT_EQ(map.folds(), 0u);
      std::vector<double> area(base->triangles.size(), 0.);
      for(std::size_t c = 0; c < map.coordinates().size(); c += 3)
      {
        const auto* b = &map.coordinates()[c];
        const double twice =
            (b[1][1] - b[0][1]) * (b[2][2] - b[0][2]) - (b[1][2] - b[0][2]) * (b[2][1] - b[0][1]);
        EXPECT_GT(twice, 0.);
        area[base->region[c / 3]] += twice;
      }
      // Images fill the base: together with their signs, that is to say one to one.
      for(const double twice : area)
        EXPECT_NEAR(twice, 1., 1e-12);
    }
  }
}

TEST(Base_map, is_continuous_across_edges)
{
  for(const Triangulation& surface : surfaces())
  {
    const Glued_surface glued(surface);
    const auto base = base_of(glued, 40);
    const Base_map map(base, Base_coordinates::heron);
    for(Index side = 0; side < base->fine.corner.size(); ++side)
    {
      const Index edge = base->edge_of_side[side], twin = base->fine.twin[side];
      if(edge == none || twin == none)
        continue;
      for(const auto& [mine, other] :
          {std::pair(side, next_side(twin)), std::pair(next_side(side), twin)})
      {
        // By base vertices: the same shares on both sides, exactly.
        std::map<Index, double> shares, other_shares;
        for(Index k = 0; k < 3; ++k)
        {
          const double a = map.coordinates()[mine][k], b = map.coordinates()[other][k];
          if(a != 0.)
            shares[base->triangles[base->region[mine / 3]][k]] = a;
          if(b != 0.)
            other_shares[base->triangles[base->region[other / 3]][k]] = b;
        }
        EXPECT_EQ(shares, other_shares);
        EXPECT_LE(shares.size(), 2u);
      }
    }
  }
}

TEST(Base_map, divides_edges_by_length)
{
  const Glued_surface surface(icosphere(3));
  const auto base = base_of(surface, 30);
  const Base_map map(base, Base_coordinates::heron);
  for(Index side = 0; side < base->fine.corner.size(); ++side)
  {
    const Index edge = base->edge_of_side[side];
    if(edge == none)
      continue;
    double whole = 0., part = 0.;
    const std::vector<Index>& path = base->path[edge];
    for(std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      const double piece = norm(base->fine.point[path[i + 1]] - base->fine.point[path[i]]);
      whole += piece;
      if(path[i] == base->fine.corner[side] || path[i + 1] == base->fine.corner[side])
        part = path[i] == base->fine.corner[side] ? part : whole;
    }
    const auto& f = base->triangles[base->region[side / 3]];
    const Index first = base->triangles[base->side[edge] / 3][base->side[edge] % 3];
    const std::size_t k = std::size_t(std::find(f.begin(), f.end(), first) - f.begin());
    EXPECT_NEAR(map.coordinates()[side][k], 1. - part / whole, 1e-13);
  }
}

// In the plane areas are those of Euclid, and the border is straight.
TEST(Base_map, of_a_planar_triangle_by_areas_is_affine)
{
  const Subdivision subdivision = subdivide({{0, 1, 2}}, 3, 4);
  const std::array<Point, 3> corner = {Point{0., 0., 0.}, Point{2., 0.3, 1.},
                                       Point{0.5, 1.7, -0.2}};
  Triangulation surface;
  for(const Base_place& place : base_places(subdivision))
  {
    surface.points.push_back({0., 0., 0.});
    for(std::size_t k = 0; k < 3; ++k)
      surface.points.back() = surface.points.back() + (place.coordinates[k] / 16.) * corner[k];
  }
  for(const Triangle& f : subdivision.finest().triangles)
    surface.corners.insert(surface.corners.end(), f.begin(), f.end());
  const Glued_surface glued(surface);
  const auto base = one_face(glued, {0, 1, 2});
  ASSERT_TRUE(base);
  const Base_map raw(base, Base_coordinates::heron, false);
  EXPECT_EQ(raw.folds(), 0u);
  for(std::size_t c = 0; c < raw.coordinates().size(); ++c)
  {
    Point p = {0., 0., 0.};
    for(std::size_t k = 0; k < 3; ++k)
      p = p + raw.coordinates()[c][k] * base->fine.point[base->site[k]];
    // Rounding of distances, which areas enlarge by no more than the base over the distance from an
    // edge, 64 where a side at the border is halved.
    EXPECT_LT(norm(p - base->fine.point[base->fine.corner[c]]), 64 * 1e-13);
  }
}

TEST(Base_map, goes_there_and_back)
{
  for(const Triangulation& surface : surfaces())
  {
    const Glued_surface glued(surface);
    const auto base = base_of(glued, 40);
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
        const Location there{Index(random() % glued.t().number_of_triangles()), none,
                             barycentric()};
        const Location back = map.inverse(map(there));
        // A hundred millionth of a side at worst, as images are no flatter.
        EXPECT_LT(norm(scaled_coordinates(glued.t(), there) - scaled_coordinates(glued.t(), back)),
                  1e-7);
        const Base_location place{Index(random() % base->triangles.size()), barycentric()};
        const Base_location found = map(map.inverse(place));
        ASSERT_EQ(found.triangle, place.triangle);
        for(std::size_t k = 0; k < 3; ++k)
          EXPECT_NEAR(found.barycentric[k], place.barycentric[k], 1e-7);
      }
    }
  }
}

TEST(Base_map, has_coordinates_where_all_angles_are_zero)
{
  Triangulation surface = {{{0., 0., 0.}}, {}};
  for(Index k = 0; k < 8; ++k)
  {
    surface.points.push_back({double(k + 1), 0., 0.});
    for(const Index corner : {Index(0), k + 1, (k + 1) % 8 + 1})
      surface.corners.push_back(corner);
  }
  const Glued_surface glued(surface);
  const auto base = one_face(glued, {1, 4, 6});
  ASSERT_TRUE(base);
  for(const Base_coordinates kind : kinds)
  {
    const Base_map map(base, kind, false);
    for(const auto& b : map.coordinates())
      EXPECT_NEAR(b[0] + b[1] + b[2], 1., 1e-12);
    EXPECT_EQ(Base_map(base, kind).folds(), 0u);
  }
}

// A tube of forty rings, closed at its end, whose image is the smaller the farther it is from the border.
TEST(Base_map, repairs_no_uniform_coordinates)
{
  Triangulation surface;
  constexpr Index rings = 40;
  for(Index i = 0; i < rings; ++i)
    for(const Point& p : {Point{1., 0., 0.}, Point{-0.5, 0.9, 0.}, Point{-0.5, -0.9, 0.}})
      surface.points.push_back({p[0], p[1], double(i)});
  for(Index i = 0; i + 1 < rings; ++i)
    for(Index k = 0; k < 3; ++k)
    {
      const Index a = 3 * i + k, b = 3 * i + (k + 1) % 3;
      surface.corners.insert(surface.corners.end(), {a, b, b + 3, a, b + 3, a + 3});
    }
  for(Index k = 3; k > 0; --k)
    surface.corners.push_back(3 * rings - k);
  const Glued_surface glued(surface);
  const auto base = one_face(glued, {0, 1, 2});
  ASSERT_TRUE(base);
  EXPECT_EQ(Base_map(base, Base_coordinates::mean_value).repaired(), 1u);
  EXPECT_EQ(Base_map(base, Base_coordinates::uniform).repaired(), 0u);
}

} // namespace
