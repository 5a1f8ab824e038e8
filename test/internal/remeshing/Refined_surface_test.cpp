// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/Refined_surface.h"

#include "core/unfold.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

namespace Refined_surface_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

std::vector<bool> all_edges(const Refined_surface& surface)
{
  return std::vector<bool>(surface.triangles().corner.size(), true);
}

TEST(Refined_surface, split_keeps_features)
{
  const Array_surface arrays(square(4));
  Refined_surface surface(arrays.triangles(), {});
  ASSERT_TRUE(surface.has_features());
  for(int round = 0; round < 3; ++round)
  {
    // The boundary of a square of n x n quads has 4 n edges and as many vertices.
    const auto& is_feature = surface.is_feature();
    EXPECT_EQ(std::count(is_feature.begin(), is_feature.end(), true), 16 << round);
    const auto& is_vertex = surface.is_feature_vertex();
    EXPECT_EQ(std::count(is_vertex.begin(), is_vertex.end(), true), 16 << round);
    surface.split(all_edges(surface));
  }
}

TEST(Refined_surface, split_keeps_lengths_and_slowness)
{
  const Array_surface arrays(square(4));
  Remeshing_options options;
  std::vector<double> slowness;
  for(Index f = 0; f < arrays.t().number_of_triangles(); ++f)
    slowness.push_back(1. + f);
  options.slowness = std::make_shared<const std::vector<double>>(slowness);
  Refined_surface surface(arrays.triangles(), options);
  surface.split(all_edges(surface));
  const std::vector<Index>& parent = surface.refinement().parent;
  ASSERT_EQ(parent.size(), 4 * slowness.size());
  double min_length = infinity, min_coarse_length = infinity;
  for(const double length : surface.triangles().length)
    min_length = std::min(min_length, surface.unit_size() * length);
  for(const double length : surface.coarse().length)
    min_coarse_length = std::min(min_coarse_length, length);
  EXPECT_NEAR(min_length, 0.5 * min_coarse_length, 1e-15); // round-off
  for(Index f = 0; f < parent.size(); ++f)
    EXPECT_EQ(surface.slowness(f), slowness[parent[f]]);
}

TEST(Refined_surface, is_on_feature_holds_on_boundary_only)
{
  const Array_surface arrays(square(4));
  const Refined_surface surface(arrays.triangles(), {});
  for(Index i = 0; i < arrays.size(); ++i)
  {
    const Point& p = arrays.point(i);
    EXPECT_EQ(surface.is_on_feature(arrays.at(i)),
              p[0] == 0. || p[0] == 1. || p[1] == 0. || p[1] == 1.);
  }
  for(Index h = 0; h < arrays.t().corner.size(); ++h)
    EXPECT_EQ(surface.is_on_feature({h / 3, none, barycentric_on_halfedge(h, 0.5)}),
              arrays.t().twin[h] == none);
  EXPECT_FALSE(surface.is_on_feature(arrays.in(0, {0.25, 0.25, 0.5})));
}

TEST(Refined_surface, split_duplicate_faces_separates_two_faces_with_the_same_vertices)
{
  Triangulation lens = one_triangle();
  lens.corners.insert(lens.corners.end(), {0, 2, 1});
  const Array_surface arrays(lens);
  Refined_surface surface(arrays.triangles(), {});
  surface.split_duplicate_faces();
  const Surface_arrays& t = surface.triangles();
  std::set<std::set<Index>> faces;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    faces.insert({t.corner[3 * f], t.corner[3 * f + 1], t.corner[3 * f + 2]});
  EXPECT_EQ(faces.size(), t.number_of_triangles());
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    EXPECT_GE(t.ring_begin[vertex + 1] - t.ring_begin[vertex], 3u);
  // A mesh without duplicates is not changed.
  const Array_surface plane(square(4));
  Refined_surface unchanged(plane.triangles(), {});
  unchanged.split_duplicate_faces();
  EXPECT_TRUE(unchanged.refinement().parent.empty());
}

TEST(Refined_surface, coinciding_vertices_have_unit_edge_lengths)
{
  Triangulation point = icosphere(0);
  for(Point& p : point.points)
    p = {1., 2., 3.};
  const Array_surface arrays(point);
  const Refined_surface surface(arrays.triangles(), {});
  for(const double length : surface.triangles().length)
    EXPECT_EQ(length, 1.);
}

} // namespace Refined_surface_test
