// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/base_mesh.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/mesh/curves.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>

#include "Glued_surface.h"
#include "topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Base_mesh base_of(const Glued_surface& surface, std::size_t number, double sharp_angle = 360.)
{
  Remeshing_goal goal;
  goal.number = number;
  goal.is_curve = border_and_sharp_sides(surface.t(), sharp_angle);
  return base_mesh(surface.triangles(), goal);
}

std::vector<Index> corners_of(const Base_mesh& base)
{
  std::vector<Index> result;
  for(const auto& f : base.triangles)
    result.insert(result.end(), f.begin(), f.end());
  return result;
}

double length_of(const Base_mesh& base, Index edge)
{
  double result = 0.;
  const std::vector<Index>& path = base.path[edge];
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
    result += norm(base.fine.point[path[i + 1]] - base.fine.point[path[i]]);
  return result;
}

// All that a base mesh promises about gluing, from its arrays alone.
void expect_is_base(const Glued_surface& surface, const Base_mesh& base)
{
  const Glued_triangles& fine = base.fine;
  const Topology whole = topology(surface.t().corner);
  EXPECT_EQ(topology(corners_of(base)), whole);
  EXPECT_EQ(topology(fine.corner), whole);

  // Each part lies in its triangle, and parts fill it: areas add up.
  double area = 0., parts = 0.;
  for(Index f = 0; f < surface.t().number_of_triangles(); ++f)
  {
    std::array<Point, 3> p;
    for(Index k = 0; k < 3; ++k)
      p[k] = surface.t().point[surface.t().corner[3 * f + k]];
    area += norm(cross(p[1] - p[0], p[2] - p[0]));
  }
  std::vector<std::set<Index>> inside(base.triangles.size());
  for(Index f = 0; f < fine.number_of_triangles(); ++f)
  {
    std::array<Point, 3> p;
    for(Index k = 0; k < 3; ++k)
    {
      const auto& b = base.barycentric[3 * f + k];
      p[k] = fine.point[fine.corner[3 * f + k]];
      // Sums of a few products in [0, 2).
      EXPECT_LT(norm(p[k] - scaled_coordinates(surface.t(), {base.whole[f], none, b})), 1e-14);
      EXPECT_GE(std::min({b[0], b[1], b[2]}), 0.);
    }
    parts += norm(cross(p[1] - p[0], p[2] - p[0]));
    ASSERT_LT(base.region[f], base.triangles.size());
  }
  EXPECT_NEAR(parts, area, 1e-12 * area);

  // Regions are apart but for their edges, and all sides of a path are there.
  std::vector<std::size_t> sides(base.path.size(), 0);
  for(Index side = 0; side < fine.corner.size(); ++side)
  {
    const Index edge = base.edge_of_side[side], twin = fine.twin[side];
    if(twin != none)
    {
      EXPECT_EQ(edge, base.edge_of_side[twin]);
    }
    if(edge == none)
    {
      ASSERT_NE(twin, none);
      EXPECT_EQ(base.region[side / 3], base.region[twin / 3]);
      continue;
    }
    sides[edge] += twin == none ? 2 : 1;
    const Index* around = &base.edge[3 * std::size_t(base.region[side / 3])];
    EXPECT_NE(std::find(around, around + 3, edge), around + 3);
  }
  std::set<Index> on_edges;
  std::size_t interior = 0;
  for(Index edge = 0; edge < base.path.size(); ++edge)
  {
    const std::vector<Index>& path = base.path[edge];
    ASSERT_GE(path.size(), 2u);
    EXPECT_EQ(sides[edge], 2 * (path.size() - 1));
    const Index side = base.side[edge];
    EXPECT_EQ(path.front(), base.site[base.triangles[side / 3][side % 3]]);
    EXPECT_EQ(path.back(), base.site[base.triangles[side / 3][next_side(side) % 3]]);
    on_edges.insert(path.begin(), path.end());
    interior += path.size() - 2;
  }
  // No two edges meet but at base vertices.
  EXPECT_EQ(on_edges.size(), interior + base.site.size());

  // Each region is a disc.
  for(Index f = 0; f < base.triangles.size(); ++f)
  {
    std::vector<Index> corners;
    for(Index part = 0; part < base.region.size(); ++part)
      if(base.region[part] == f)
        for(Index k = 0; k < 3; ++k)
          corners.push_back(fine.corner[3 * part + k]);
    EXPECT_EQ(topology(corners), (Topology{true, {{1, 1}}})) << f;
  }
}

TEST(Base_mesh, of_a_sphere_has_its_edges_along_geodesics)
{
  const Glued_surface surface(icosphere(3));
  const Base_mesh base = base_of(surface, 60);
  EXPECT_EQ(base.site.size(), 60u);
  expect_is_base(surface, base);
  double sum = 0., shortest = 0.;
  for(Index edge = 0; edge < base.path.size(); ++edge)
  {
    const Index side = base.side[edge];
    Window_propagation windows(surface.triangles());
    windows.run({{{base.samples[base.triangles[side / 3][side % 3]]}, 0., 0}});
    const double exact =
        windows.distance(base.samples[base.triangles[side / 3][next_side(side) % 3]]);
    // Samples go to a side or a site that is nearer than a hundredth of a height, and paths keep off
    // sites and one another by two-hundredths of sides.
    EXPECT_GT(length_of(base, edge), exact - 0.05);
    EXPECT_LT(length_of(base, edge), 1.05 * exact + 0.05);
    sum += length_of(base, edge);
    shortest += exact;
  }
  EXPECT_NEAR(sum, shortest, 0.005 * shortest);
}

TEST(Base_mesh, has_the_topology_of_the_mesh)
{
  for(const Triangulation& surface : {torus(24, 16), double_ring(), shaken(square(16), 0.3, 2),
                                      annulus(24, 8, 1., 3.), apart(icosphere(2), torus(18, 12))})
  {
    const Glued_surface glued(surface);
    for(const std::size_t number : {std::size_t(0), std::size_t(40)})
      expect_is_base(glued, base_of(glued, number));
  }
}

TEST(Base_mesh, of_few_triangles_divides_each_many_times)
{
  for(const Triangulation& surface : {tetrahedron(), one_triangle(), icosphere(0)})
  {
    const Glued_surface glued(surface);
    const Base_mesh base = base_of(glued, 50);
    EXPECT_GE(base.site.size(), 50u);
    expect_is_base(glued, base);
  }
}

TEST(Base_mesh, follows_borders_and_sharp_edges_exactly)
{
  const Glued_surface surface(blocks(6, 6, 6, [](int, int, int) { return true; }));
  const Base_mesh base = base_of(surface, 60, 60.);
  expect_is_base(surface, base);
  const std::vector<bool> is_sharp = border_and_sharp_sides(surface.t(), 60.);
  // Each side on a sharp one of the mesh is a part of a base edge.
  std::size_t found = 0;
  for(Index side = 0; side < base.fine.corner.size(); ++side)
  {
    const auto &b = base.barycentric[side], &c = base.barycentric[next_side(side)];
    for(Index k = 0; k < 3; ++k)
      if(b[k] == 0. && c[k] == 0. && is_sharp[3 * base.whole[side / 3] + (k + 1) % 3])
      {
        EXPECT_NE(base.edge_of_side[side], none);
        ++found;
      }
  }
  EXPECT_GE(found, 2u * 12u * 6u);
}

TEST(Base_mesh, follows_any_web_of_curves)
{
  // Loops of two samples, ends, and places where curves almost meet: kept they are all the same.
  for(const int percent : {2, 10, 30})
    for(const Triangulation& points : {shaken(icosphere(2), 0.05, 1), torus(18, 12)})
    {
      const Glued_surface surface(points);
      std::mt19937 random(1);
      Remeshing_goal goal;
      goal.number = 30;
      goal.is_curve = border_and_sharp_sides(surface.t());
      for(Index side = 0; side < goal.is_curve.size(); ++side)
        if(side < surface.t().twin[side])
          goal.is_curve[side] = goal.is_curve[surface.t().twin[side]] =
              int(random() % 100) < percent;
      const Base_mesh base = base_mesh(surface.triangles(), goal);
      expect_is_base(surface, base);
      double curves = 0., drawn = 0.;
      for(Index side = 0; side < goal.is_curve.size(); ++side)
        if(goal.is_curve[side])
          curves += norm(surface.t().point[surface.t().corner[next_side(side)]] -
                         surface.t().point[surface.t().corner[side]]);
      for(Index side = 0; side < base.fine.corner.size(); ++side)
        for(Index k = 0; k < 3 && base.edge_of_side[side] != none; ++k)
          if(base.barycentric[side][k] == 0. && base.barycentric[next_side(side)][k] == 0. &&
             goal.is_curve[3 * base.whole[side / 3] + (k + 1) % 3])
            drawn += norm(base.fine.point[base.fine.corner[next_side(side)]] -
                          base.fine.point[base.fine.corner[side]]);
      EXPECT_NEAR(drawn, curves, 1e-12 * curves);
    }
}

TEST(Base_mesh, finds_ways_around_handles)
{
  // On long triangles a short path is soon on the wrong side of a handle.
  const auto stretched = [](Triangulation surface, double x, double y)
  {
    for(Point& p : surface.points)
    {
      p[0] *= x;
      p[1] *= y;
    }
    return surface;
  };
  const auto sponge =
      blocks(5, 5, 5, [](int x, int y, int z) { return x % 2 + y % 2 + z % 2 < 2; });
  for(const Triangulation& surface :
      {stretched(torus(4, 3), 1., 10.), stretched(torus(4, 8), 1., 10.),
       stretched(torus(6, 5), 1., 10.), stretched(sponge, 10., 1.)})
    for(const std::size_t number : {std::size_t(30), std::size_t(50)})
    {
      const Glued_surface glued(surface);
      const Base_mesh base = base_of(glued, number);
      expect_is_base(glued, base);
      // Sides that join two sites of one edge would fold any map.
      std::vector<std::set<Index>> edges(base.fine.point.size());
      for(Index edge = 0; edge < base.path.size(); ++edge)
        for(const Index site : base.path[edge])
          edges[site].insert(edge);
      for(Index side = 0; side < base.fine.corner.size(); ++side)
      {
        if(base.edge_of_side[side] != none)
          continue;
        const auto &at = edges[base.fine.corner[side]],
                   &next = edges[base.fine.corner[next_side(side)]];
        EXPECT_TRUE(std::none_of(at.begin(), at.end(), [&](Index e) { return next.count(e) > 0; }));
      }
    }
}

TEST(Base_mesh, of_any_scale_is_the_same)
{
  const Triangulation surface = shaken(torus(24, 16), 0.02, 3);
  const Base_mesh base = base_of(Glued_surface(surface), 50);
  for(const double factor : {0x1p-20, 0x1p20})
  {
    const Base_mesh other = base_of(Glued_surface(scaled(surface, factor)), 50);
    EXPECT_EQ(other.triangles, base.triangles);
    EXPECT_EQ(other.path, base.path);
    EXPECT_EQ(other.barycentric, base.barycentric);
  }
}

TEST(Base_mesh, survives_needles)
{
  // Sides of one to a thousand.
  const Glued_surface surface(grid(60, 8,
                                   [](double x, double y) {
                                     return Point{x, 150. * y, 0.};
                                   }));
  expect_is_base(surface, base_of(surface, 30));
}

TEST(Base_mesh, is_empty_when_cancelled)
{
  const Glued_surface surface(icosphere(2));
  Remeshing_goal goal;
  goal.number = 20;
  goal.callback = [](double) { return false; };
  EXPECT_FALSE(base_mesh(surface.triangles(), goal).is_finished);
}

} // namespace
