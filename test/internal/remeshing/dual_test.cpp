// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/dual.h"

#include <CGAL/Geodesic_processing/internal/sampling/voronoi.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Voronoi voronoi(const Glued_surface& surface, const std::vector<Location>& seeds)
{
  std::vector<internal::Source> sources;
  for(const Location& seed : seeds)
    sources.push_back({{seed}, 0., Index(sources.size())});
  return Voronoi(surface.triangles(), Front(surface.triangles(), Front_kind::euclidean), sources,
                 Index(seeds.size()));
}

Dual dual_of(const Glued_surface& surface, const std::vector<Location>& seeds)
{
  return dual(surface.t(), voronoi(surface, seeds).labels(), Index(seeds.size()));
}

// Triangles of cells as a surface: each side at most once in each direction.  Its Euler characteristic
// and the number of sides at its border.
std::pair<std::ptrdiff_t, std::size_t> shape_of(const Dual& dual)
{
  std::set<std::pair<Index, Index>> sides;
  std::set<Index> cells;
  for(const auto& f : dual.triangles)
    for(int k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(sides.insert({f[k], f[(k + 1) % 3]}).second);
      cells.insert(f[k]);
    }
  std::size_t edges = 0, border = 0;
  for(const auto& [a, b] : sides)
  {
    const bool has_twin = sides.count({b, a}) > 0;
    edges += !has_twin || a < b;
    border += !has_twin;
  }
  return {std::ptrdiff_t(cells.size() + dual.triangles.size()) - std::ptrdiff_t(edges), border};
}

TEST(Dual, of_many_samples_is_a_surface_like_the_mesh)
{
  struct Case
  {
    Triangulation surface;
    std::ptrdiff_t characteristic;
    bool has_border;
  };
  for(const auto& [triangulation, characteristic, has_border] :
      std::vector<Case>{{icosphere(4), 2, false},
                        {torus(80, 40), 0, false},
                        {square(40, 0.2), 1, true},
                        {annulus(80, 20, 0.5, 1.), 0, true}})
  {
    const Glued_surface surface(triangulation);
    // Samples are added while a check fails, as a remeshing would do; uniform ones soon pass it.
    std::size_t number = 100;
    Dual found = dual_of(surface, farthest_points(surface.triangles(), number));
    while(!found.is_closed_ball() && number < 160)
      found = dual_of(surface, farthest_points(surface.triangles(), ++number));
    ASSERT_TRUE(found.is_closed_ball());
    const auto [shape, border] = shape_of(found);
    EXPECT_EQ(shape, characteristic);
    EXPECT_EQ(border > 0, has_border);
  }
}

TEST(Dual, says_what_is_wrong_with_few_samples)
{
  const Triangulation sphere = icosphere(3);
  const Glued_surface surface(sphere);
  const auto nearest = [&](const Point& p)
  {
    Index result = 0;
    for(Index i = 1; i < surface.size(); ++i)
      if(distance(sphere.points[i], p) < distance(sphere.points[result], p))
        result = i;
    return surface.at(result);
  };
  // One cell is all of the sphere; two share a loop; three meet at two places.
  const Dual one = dual_of(surface, {nearest({0., 0., 1.})});
  EXPECT_EQ(one.no_discs, (std::vector<Index>{0}));
  EXPECT_TRUE(one.triangles.empty());

  const Dual two = dual_of(surface, {nearest({0., 0., 1.}), nearest({0., 0., -1.})});
  EXPECT_TRUE(two.no_discs.empty());
  EXPECT_EQ(two.torn_arcs, (std::vector<std::array<Index, 2>>{{0, 1}}));

  const Dual three = dual_of(
      surface, {nearest({1., 0., 0.}), nearest({-0.5, 0.9, 0.}), nearest({-0.5, -0.9, 0.})});
  EXPECT_TRUE(three.no_discs.empty());
  EXPECT_TRUE(three.torn_arcs.empty());
  EXPECT_EQ(three.triangles.size(), 2u);
  EXPECT_EQ(three.repeated_places, (std::vector<std::array<Index, 3>>{{0, 1, 2}}));
  EXPECT_FALSE(three.is_closed_ball());

  const Dual four = dual_of(surface, {nearest({1., 1., 1.}), nearest({1., -1., -1.}),
                                      nearest({-1., 1., -1.}), nearest({-1., -1., 1.})});
  EXPECT_TRUE(four.is_closed_ball());
  EXPECT_EQ(shape_of(four), (std::pair<std::ptrdiff_t, std::size_t>(2, 0)));
}

TEST(Dual, sees_curves_that_two_cells_cross_twice)
{
  const Glued_surface surface(square(8));
  const Dual whole = dual_of(surface, {surface.at(9 * 4 + 2), surface.at(9 * 4 + 6)});
  EXPECT_EQ(whole.torn_curves, (std::vector<std::array<Index, 2>>{{0, 1}})); // of the border
  const Glued_triangles& t = surface.t();
  std::vector<bool> is_curve(t.corner.size(), false);
  const auto add = [&](Index i, Index j)
  {
    for(Index side = 0; side < t.corner.size(); ++side)
      if(const std::pair ends(t.corner[side], t.corner[next_side(side)]);
         ends == std::pair(surface.site(i), surface.site(j)) ||
         ends == std::pair(surface.site(j), surface.site(i)))
        is_curve[side] = true;
  };
  std::vector<Index> labels(t.number_of_sites());
  for(Index j = 0; j <= 8; ++j)
    for(Index i = 0; i <= 8; ++i)
      labels[surface.site(9 * j + i)] = i < 4 ? 0 : 1;
  add(9 * 3 + 3, 9 * 3 + 4);
  EXPECT_TRUE(dual(t, labels, 2, is_curve).torn_curves.empty());
  add(9 * 5 + 3, 9 * 5 + 4);
  EXPECT_EQ(dual(t, labels, 2, is_curve).torn_curves, (std::vector<std::array<Index, 2>>{{0, 1}}));
}

TEST(Dual, sees_rings_and_borders)
{
  // On a long tube cells of a few samples are rings, and the ends' cells have whole borders.
  const Glued_surface tube(cylinder(24, 60, 0.2, 5.));
  const Index middle = 30 * 24;
  const Dual rings = dual_of(tube, {tube.at(3), tube.at(middle + 3), tube.at(60 * 24 + 3)});
  EXPECT_EQ(rings.no_discs, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(rings.torn_borders, (std::vector<Index>{0, 2}));
  EXPECT_EQ(rings.torn_arcs, (std::vector<std::array<Index, 2>>{{0, 1}, {1, 2}}));

  // A strip: the middle cell meets the border twice.
  const Glued_surface strip(grid(60, 6, [](double u, double v) { return Point{10. * u, v, 0.}; }));
  const Dual strips =
      dual_of(strip, {strip.at(3 * 61), strip.at(3 * 61 + 30), strip.at(3 * 61 + 60)});
  EXPECT_TRUE(strips.no_discs.empty());
  EXPECT_EQ(strips.torn_borders, (std::vector<Index>{1}));
  // No third cell is where two meet.
  EXPECT_EQ(strips.torn_arcs, (std::vector<std::array<Index, 2>>{{0, 1}, {1, 2}}));
  const Dual two = dual_of(strip, {strip.at(3 * 61), strip.at(3 * 61 + 60)});
  EXPECT_TRUE(two.torn_borders.empty());
  EXPECT_EQ(two.torn_arcs, (std::vector<std::array<Index, 2>>{{0, 1}}));

  // A seed that is nearest to no site.
  const Glued_surface plane(square(4));
  const Dual hidden = dual_of(plane, {plane.at(12), plane.at(12)});
  EXPECT_EQ(hidden.no_discs, (std::vector<Index>{1}));
}

} // namespace
