// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/base_mesh.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/mesh/feature_polylines.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include "Array_surface.h"
#include "topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace base_mesh_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Base_mesh base_of(const Array_surface& surface, std::size_t number, double sharp_angle = 360.)
{
  Remeshing_options options;
  options.number_of_samples = number;
  options.is_feature = boundary_and_sharp_halfedges(surface.t(), sharp_angle);
  return build_base_mesh(surface.triangles(), options);
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

// Expects all invariants of the connectivity of a base mesh.
void expect_is_base(const Array_surface& surface, const Base_mesh& base)
{
  const Surface_arrays& fine = base.fine;
  const Topology topology_of_mesh = topology(surface.t().corner);
  EXPECT_EQ(topology(corners_of(base)), topology_of_mesh);
  EXPECT_EQ(topology(fine.corner), topology_of_mesh);

  // Each fine triangle lies in its parent, and the areas of the fine triangles sum to that of the
  // mesh.
  double area = 0., divided_area = 0.;
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
      // Round-off errors of sums of a few products in [0, 2).
      EXPECT_LT(norm(p[k] - scaled_coordinates(surface.t(), {base.parent[f], none, b})), 1e-14);
      EXPECT_GE(std::min({b[0], b[1], b[2]}), 0.);
    }
    divided_area += norm(cross(p[1] - p[0], p[2] - p[0]));
    ASSERT_LT(base.region[f], base.triangles.size());
  }
  EXPECT_NEAR(divided_area, area, 1e-12 * area); // sums of some thousand areas; measured are 1e-14

  // Adjacent regions are separated by labeled edges, and all edges of each path are labeled.
  std::vector<std::size_t> halfedges(base.path.size(), 0);
  for(Index h = 0; h < fine.corner.size(); ++h)
  {
    const Index edge = base.edge_of_halfedge[h], twin = fine.twin[h];
    if(twin != none)
    {
      EXPECT_EQ(edge, base.edge_of_halfedge[twin]);
    }
    if(edge == none)
    {
      ASSERT_NE(twin, none);
      EXPECT_EQ(base.region[h / 3], base.region[twin / 3]);
      continue;
    }
    halfedges[edge] += twin == none ? 2 : 1;
    const Index* region_edges = &base.edge[3 * std::size_t(base.region[h / 3])];
    EXPECT_NE(std::find(region_edges, region_edges + 3, edge), region_edges + 3);
  }
  std::set<Index> on_edges;
  std::size_t interior = 0;
  for(Index edge = 0; edge < base.path.size(); ++edge)
  {
    const std::vector<Index>& path = base.path[edge];
    ASSERT_GE(path.size(), 2u);
    EXPECT_EQ(halfedges[edge], 2 * (path.size() - 1));
    const Index h = base.halfedge[edge];
    EXPECT_EQ(path.front(), base.vertex[base.triangles[h / 3][h % 3]]);
    EXPECT_EQ(path.back(), base.vertex[base.triangles[h / 3][next_halfedge(h) % 3]]);
    on_edges.insert(path.begin(), path.end());
    interior += path.size() - 2;
  }
  // Paths meet at base vertices only.
  EXPECT_EQ(on_edges.size(), interior + base.vertex.size());

  // Each region is a disk.
  for(Index f = 0; f < base.triangles.size(); ++f)
  {
    std::vector<Index> corners;
    for(Index triangle = 0; triangle < base.region.size(); ++triangle)
      if(base.region[triangle] == f)
        for(Index k = 0; k < 3; ++k)
          corners.push_back(fine.corner[3 * triangle + k]);
    EXPECT_EQ(topology(corners), (Topology{true, {{1, 1}}})) << f;
  }
}

TEST(Base_mesh, edges_on_sphere_are_near_geodesic)
{
  const Array_surface surface(icosphere(3));
  const Base_mesh base = base_of(surface, 60);
  EXPECT_EQ(base.vertex.size(), 60u);
  expect_is_base(surface, base);
  double sum = 0., shortest = 0.;
  for(Index edge = 0; edge < base.path.size(); ++edge)
  {
    const Index h = base.halfedge[edge];
    Window_propagation windows(surface.triangles());
    windows.run({{{base.samples[base.triangles[h / 3][h % 3]]}, 0., 0}});
    const double exact =
        windows.distance(base.samples[base.triangles[h / 3][next_halfedge(h) % 3]]);
    // Samples within 1/100 of a triangle height of an edge or vertex are moved onto it. Paths keep
    // 1/200 of an edge from vertices and other paths.
    EXPECT_GT(length_of(base, edge), exact - 0.05);
    EXPECT_LT(length_of(base, edge), 1.05 * exact + 0.05);
    sum += length_of(base, edge);
    shortest += exact;
  }
  // Few paths are not shortest, and these are longer by the square of the displacement, (1/200)^2.
  EXPECT_NEAR(sum, shortest, 1e-4 * shortest);
}

TEST(Base_mesh, preserves_topology)
{
  for(const Triangulation& surface :
      {torus(24, 16), double_torus(), jittered(square(16), 0.3, 2), annulus(24, 8, 1., 3.),
       disjoint_union(icosphere(2), torus(18, 12))})
  {
    const Array_surface arrays(surface);
    for(const std::size_t number : {std::size_t(0), std::size_t(40)})
      expect_is_base(arrays, base_of(arrays, number));
  }
}

TEST(Base_mesh, can_be_finer_than_input)
{
  for(const Triangulation& surface : {tetrahedron(), one_triangle(), icosphere(0)})
  {
    const Array_surface arrays(surface);
    const Base_mesh base = base_of(arrays, 50);
    EXPECT_GE(base.vertex.size(), 50u);
    expect_is_base(arrays, base);
  }
}

TEST(Base_mesh, follows_boundary_and_sharp_edges)
{
  const Array_surface surface(blocks(6, 6, 6, [](int, int, int) { return true; }));
  const Base_mesh base = base_of(surface, 60, 60.);
  expect_is_base(surface, base);
  const std::vector<bool> is_sharp = boundary_and_sharp_halfedges(surface.t(), 60.);
  // Each fine edge on a sharp edge of the mesh belongs to a base edge.
  std::size_t found = 0;
  for(Index h = 0; h < base.fine.corner.size(); ++h)
  {
    const auto &b = base.barycentric[h], &c = base.barycentric[next_halfedge(h)];
    for(Index k = 0; k < 3; ++k)
      if(b[k] == 0. && c[k] == 0. && is_sharp[3 * base.parent[h / 3] + (k + 1) % 3])
      {
        EXPECT_NE(base.edge_of_halfedge[h], none);
        ++found;
      }
  }
  EXPECT_GE(found, 2u * 12u * 6u);
}

TEST(Base_mesh, follows_arbitrary_features)
{
  // Random edges form closed curves with two samples, dangling ends and nearly touching polylines.
  // All of them must be preserved.
  for(const int percent : {2, 10, 30})
    for(const Triangulation& points : {jittered(icosphere(2), 0.05, 1), torus(18, 12)})
    {
      const Array_surface surface(points);
      std::mt19937 random(1);
      Remeshing_options options;
      options.number_of_samples = 30;
      options.is_feature = boundary_and_sharp_halfedges(surface.t());
      for(Index h = 0; h < options.is_feature.size(); ++h)
        if(h < surface.t().twin[h])
          options.is_feature[h] = options.is_feature[surface.t().twin[h]] =
              int(random() % 100) < percent;
      const Base_mesh base = build_base_mesh(surface.triangles(), options);
      expect_is_base(surface, base);
      double feature_length = 0., traced_length = 0.;
      for(Index h = 0; h < options.is_feature.size(); ++h)
        if(options.is_feature[h])
          feature_length += norm(surface.t().point[surface.t().corner[next_halfedge(h)]] -
                                 surface.t().point[surface.t().corner[h]]);
      for(Index h = 0; h < base.fine.corner.size(); ++h)
        for(Index k = 0; k < 3 && base.edge_of_halfedge[h] != none; ++k)
          if(base.barycentric[h][k] == 0. && base.barycentric[next_halfedge(h)][k] == 0. &&
             options.is_feature[3 * base.parent[h / 3] + (k + 1) % 3])
            traced_length += norm(base.fine.point[base.fine.corner[next_halfedge(h)]] -
                                  base.fine.point[base.fine.corner[h]]);
      // Sums of some hundred lengths; measured are 1e-15.
      EXPECT_NEAR(traced_length, feature_length, 1e-12 * feature_length);
    }
}

TEST(Base_mesh, finds_paths_around_handles)
{
  // On stretched triangles, short paths often pass a handle on the wrong side.
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
      const Array_surface arrays(surface);
      const Base_mesh base = base_of(arrays, number);
      expect_is_base(arrays, base);
      // An unlabeled edge between two vertices of one path would make any map degenerate.
      std::vector<std::set<Index>> edges(base.fine.point.size());
      for(Index edge = 0; edge < base.path.size(); ++edge)
        for(const Index vertex : base.path[edge])
          edges[vertex].insert(edge);
      for(Index h = 0; h < base.fine.corner.size(); ++h)
      {
        if(base.edge_of_halfedge[h] != none)
          continue;
        const auto &at = edges[base.fine.corner[h]],
                   &next = edges[base.fine.corner[next_halfedge(h)]];
        EXPECT_TRUE(std::none_of(at.begin(), at.end(), [&](Index e) { return next.count(e) > 0; }));
      }
    }
}

TEST(Base_mesh, is_scale_invariant)
{
  const Triangulation surface = jittered(torus(24, 16), 0.02, 3);
  const Base_mesh base = base_of(Array_surface(surface), 50);
  for(const double factor : {0x1p-20, 0x1p20})
  {
    const Base_mesh other = base_of(Array_surface(scaled(surface, factor)), 50);
    EXPECT_EQ(other.triangles, base.triangles);
    EXPECT_EQ(other.path, base.path);
    EXPECT_EQ(other.barycentric, base.barycentric);
  }
}

TEST(Base_mesh, handles_needles)
{
  // Edge lengths have a ratio of 1 to 1000.
  const Array_surface surface(grid(60, 8,
                                   [](double x, double y) {
                                     return Point{x, 150. * y, 0.};
                                   }));
  expect_is_base(surface, base_of(surface, 30));
}

TEST(Base_mesh, is_empty_when_cancelled)
{
  const Array_surface surface(icosphere(2));
  Remeshing_options options;
  options.number_of_samples = 20;
  options.callback = [](double) { return false; };
  EXPECT_FALSE(build_base_mesh(surface.triangles(), options).is_finished);
}

} // namespace base_mesh_test
