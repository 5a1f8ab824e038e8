// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/dual.h"

#include <CGAL/Geodesic_processing/internal/sampling/voronoi.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <set>

namespace dual_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Voronoi_diagram voronoi(const Array_surface& surface, const std::vector<Surface_location>& seeds)
{
  std::vector<internal::Front_source> sources;
  for(const Surface_location& seed : seeds)
    sources.push_back({{seed}, 0., Index(sources.size())});
  return Voronoi_diagram(surface.triangles(), Front(surface.triangles(), Front_kind::euclidean),
                         sources, Index(seeds.size()));
}

Dual dual_of(const Array_surface& surface, const std::vector<Surface_location>& seeds)
{
  return dual(surface.t(), voronoi(surface, seeds).labels(), Index(seeds.size()));
}

// Returns the Euler characteristic and the number of boundary edges of dual triangles. Expects that
// each directed edge occurs at most once.
std::pair<std::ptrdiff_t, std::size_t> euler_characteristic_and_boundary(const Dual& dual)
{
  std::set<std::pair<Index, Index>> halfedges;
  std::set<Index> cells;
  for(const auto& f : dual.triangles)
    for(int k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(halfedges.insert({f[k], f[(k + 1) % 3]}).second);
      cells.insert(f[k]);
    }
  std::size_t edges = 0, number_of_boundary_edges = 0;
  for(const auto& [a, b] : halfedges)
  {
    const bool has_twin = halfedges.count({b, a}) > 0;
    edges += !has_twin || a < b;
    number_of_boundary_edges += !has_twin;
  }
  return {std::ptrdiff_t(cells.size() + dual.triangles.size()) - std::ptrdiff_t(edges),
          number_of_boundary_edges};
}

TEST(Dual, dense_samples_preserve_topology)
{
  struct Case
  {
    Triangulation surface;
    std::ptrdiff_t characteristic;
    bool has_boundary;
  };
  for(const auto& [triangulation, characteristic, has_boundary] :
      std::vector<Case>{{icosphere(4), 2, false},
                        {torus(80, 40), 0, false},
                        {square(40, 0.2), 1, true},
                        {annulus(80, 20, 0.5, 1.), 0, true}})
  {
    const Array_surface surface(triangulation);
    // Farthest samples are added until the dual is valid, as in a remeshing.
    std::size_t number = 100;
    Dual found = dual_of(surface, farthest_points(surface.triangles(), number));
    while(!found.is_closed_ball() && number < 160)
      found = dual_of(surface, farthest_points(surface.triangles(), ++number));
    ASSERT_TRUE(found.is_closed_ball());
    const auto [shape, number_of_boundary_edges] = euler_characteristic_and_boundary(found);
    EXPECT_EQ(shape, characteristic);
    EXPECT_EQ(number_of_boundary_edges > 0, has_boundary);
  }
}

TEST(Dual, reports_violations_for_few_samples)
{
  const Triangulation sphere = icosphere(3);
  const Array_surface surface(sphere);
  const auto nearest = [&](const Point& p)
  {
    Index result = 0;
    for(Index i = 1; i < surface.size(); ++i)
      if(distance(sphere.points[i], p) < distance(sphere.points[result], p))
        result = i;
    return surface.at(result);
  };
  // On a sphere, one cell is no disk, two cells share a closed curve, and three meet at two points.
  const Dual one = dual_of(surface, {nearest({0., 0., 1.})});
  EXPECT_EQ(one.non_disks, (std::vector<Index>{0}));
  EXPECT_TRUE(one.triangles.empty());

  const Dual two = dual_of(surface, {nearest({0., 0., 1.}), nearest({0., 0., -1.})});
  EXPECT_TRUE(two.non_disks.empty());
  EXPECT_EQ(two.disconnected_interfaces, (std::vector<std::array<Index, 2>>{{0, 1}}));

  const Dual three = dual_of(
      surface, {nearest({1., 0., 0.}), nearest({-0.5, 0.9, 0.}), nearest({-0.5, -0.9, 0.})});
  EXPECT_TRUE(three.non_disks.empty());
  EXPECT_TRUE(three.disconnected_interfaces.empty());
  EXPECT_EQ(three.triangles.size(), 2u);
  EXPECT_EQ(three.repeated_triple_points, (std::vector<std::array<Index, 3>>{{0, 1, 2}}));
  EXPECT_FALSE(three.is_closed_ball());

  const Dual four = dual_of(surface, {nearest({1., 1., 1.}), nearest({1., -1., -1.}),
                                      nearest({-1., 1., -1.}), nearest({-1., -1., 1.})});
  EXPECT_TRUE(four.is_closed_ball());
  EXPECT_EQ(euler_characteristic_and_boundary(four),
            (std::pair<std::ptrdiff_t, std::size_t>(2, 0)));
}

TEST(Dual, detects_repeated_crossings_of_a_feature)
{
  const Array_surface surface(square(8));
  const Dual whole = dual_of(surface, {surface.at(9 * 4 + 2), surface.at(9 * 4 + 6)});
  EXPECT_EQ(whole.repeated_boundary_crossings,
            (std::vector<std::array<Index, 2>>{{0, 1}})); // crossings of the boundary
  const Surface_arrays& t = surface.t();
  std::vector<bool> is_feature(t.corner.size(), false);
  const auto add = [&](Index i, Index j)
  {
    for(Index h = 0; h < t.corner.size(); ++h)
      if(const std::pair ends(t.corner[h], t.corner[next_halfedge(h)]);
         ends == std::pair(surface.vertex(i), surface.vertex(j)) ||
         ends == std::pair(surface.vertex(j), surface.vertex(i)))
        is_feature[h] = true;
  };
  std::vector<Index> labels(t.number_of_vertices());
  for(Index j = 0; j <= 8; ++j)
    for(Index i = 0; i <= 8; ++i)
      labels[surface.vertex(9 * j + i)] = i < 4 ? 0 : 1;
  add(9 * 3 + 3, 9 * 3 + 4);
  EXPECT_TRUE(dual(t, labels, 2, is_feature).repeated_boundary_crossings.empty());
  add(9 * 5 + 3, 9 * 5 + 4);
  EXPECT_EQ(dual(t, labels, 2, is_feature).repeated_boundary_crossings,
            (std::vector<std::array<Index, 2>>{{0, 1}}));
}

TEST(Dual, detects_annular_cells_and_split_boundaries)
{
  // On a long tube the cells of a few samples are annuli. Those at the ends contain entire boundary
  // cycles.
  const Array_surface tube(cylinder(24, 60, 0.2, 5.));
  const Index central_ring = 30 * 24;
  const Dual rings = dual_of(tube, {tube.at(3), tube.at(central_ring + 3), tube.at(60 * 24 + 3)});
  EXPECT_EQ(rings.non_disks, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(rings.disconnected_boundaries, (std::vector<Index>{0, 2}));
  EXPECT_EQ(rings.disconnected_interfaces, (std::vector<std::array<Index, 2>>{{0, 1}, {1, 2}}));

  // On a strip, the central cell meets the boundary in two arcs.
  const Array_surface strip(grid(60, 6, [](double u, double v) { return Point{10. * u, v, 0.}; }));
  const Dual strips =
      dual_of(strip, {strip.at(3 * 61), strip.at(3 * 61 + 30), strip.at(3 * 61 + 60)});
  EXPECT_TRUE(strips.non_disks.empty());
  EXPECT_EQ(strips.disconnected_boundaries, (std::vector<Index>{1}));
  // The bisectors do not end at third cells.
  EXPECT_EQ(strips.disconnected_interfaces, (std::vector<std::array<Index, 2>>{{0, 1}, {1, 2}}));
  const Dual two = dual_of(strip, {strip.at(3 * 61), strip.at(3 * 61 + 60)});
  EXPECT_TRUE(two.disconnected_boundaries.empty());
  EXPECT_EQ(two.disconnected_interfaces, (std::vector<std::array<Index, 2>>{{0, 1}}));

  // The third cell contains no vertex.
  const Array_surface plane(square(4));
  const Dual hidden = dual_of(plane, {plane.at(12), plane.at(12)});
  EXPECT_EQ(hidden.non_disks, (std::vector<Index>{1}));
}

} // namespace dual_test
