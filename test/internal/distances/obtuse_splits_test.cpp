// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/obtuse_splits.h>

#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace obtuse_splits_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(Obtuse_splits, split_obtuse_corners_into_acute_ones)
{
  // In the plane, unfolded vertices keep their positions.
  const Triangulation plane = grid(
      20, 20,
      [](double u, double v) {
        return Point{u, 0.3 * v, 0.};
      },
      0.24);
  const Array_surface surface(plane);
  const Surface_arrays& t = *surface.triangles();
  const Obtuse_splits s = split_obtuse_corners(t);
  const auto position_of = [&](Index vertex)
  { return surface.point(surface.caller_vertex(vertex)); };
  const double round_off = 1e-12; // of a few unfoldings
  const auto expect_length = [&](double length, Index v, Index w)
  { EXPECT_NEAR(surface.scale() * length, distance(position_of(v), position_of(w)), round_off); };
  ASSERT_GT(s.splits.size(), 100u);
  std::vector<bool> is_split(t.corner.size(), false);
  for(const Obtuse_splits::Split& split : s.splits)
  {
    is_split[split.corner] = true;
    EXPECT_LT(corner_angle(t, split.corner)[0], 0.);
    const Index corner_vertex = t.corner[split.corner],
                neighbors[2] = {t.corner[next_halfedge(split.corner)],
                                t.corner[previous_halfedge(split.corner)]};
    expect_length(split.length, corner_vertex, split.vertex);
    const Point x = position_of(corner_vertex), middle = position_of(split.vertex);
    for(const std::size_t half : {0, 1})
    {
      expect_length(split.to_neighbor[half], corner_vertex, neighbors[half]);
      expect_length(split.base[half], split.vertex, neighbors[half]);
      const Point a = position_of(neighbors[half]);
      EXPECT_GT(
          dot(Point{a[0] - x[0], a[1] - x[1], 0.}, Point{middle[0] - x[0], middle[1] - x[1], 0.}),
          0.);
    }
  }
  for(Index corner = 0; corner < t.corner.size(); ++corner)
  {
    EXPECT_EQ(s.is_split(corner), is_split[corner]);
    // No vertex splits a corner if the boundary or the limit of 20 triangles comes first.
    const Point p = position_of(t.corner[corner]);
    const bool is_inner = p[0] > 0.2 && p[0] < 0.8 && p[1] > 0.12 && p[1] < 0.18;
    EXPECT_TRUE(is_split[corner] || !is_inner || corner_angle(t, corner)[0] >= 0.);
  }
}

TEST(Obtuse_splits, are_seen_from_both_ends_of_both_bases)
{
  const Array_surface surface(grid(
      20, 20,
      [](double u, double v) {
        return Point{u, 0.3 * v, 0.};
      },
      0.24));
  const Surface_arrays& t = *surface.triangles();
  const Obtuse_splits s = split_obtuse_corners(t);
  ASSERT_EQ(s.views.size(), 4 * s.splits.size());
  std::vector<std::array<bool, 4>> is_seen(s.splits.size());
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    for(Index i = s.begin[vertex]; i < s.begin[vertex + 1]; ++i)
    {
      const Obtuse_splits::View& view = s.views[i];
      const Obtuse_splits::Split& split = s.splits[view.split()];
      const Index neighbor = t.corner[view.half() == 0 ? next_halfedge(split.corner)
                                                       : previous_halfedge(split.corner)];
      EXPECT_EQ(view.target, t.corner[split.corner]);
      EXPECT_EQ(vertex, view.is_from_splitting_vertex() ? split.vertex : neighbor);
      EXPECT_EQ(view.along, view.is_from_splitting_vertex() ? neighbor : split.vertex);
      bool& seen = is_seen[view.split()][view.half() + (view.is_from_splitting_vertex() ? 2 : 0)];
      EXPECT_FALSE(seen);
      seen = true;
    }
}

TEST(Obtuse_splits, need_obtuse_corners_and_triangles_behind_them)
{
  EXPECT_TRUE(split_obtuse_corners(*Array_surface(icosphere(2)).triangles()).splits.empty());
  // Right angles.
  EXPECT_TRUE(split_obtuse_corners(*Array_surface(square(20)).triangles()).splits.empty());
  const Triangulation obtuse = {{{0., 0., 0.}, {4., 0., 0.}, {2., 0.5, 0.}}, {0, 1, 2}};
  const Obtuse_splits s = split_obtuse_corners(*Array_surface(obtuse).triangles());
  EXPECT_TRUE(s.splits.empty());
  EXPECT_FALSE(s.is_split(2));
}

TEST(Obtuse_splits, do_not_depend_on_threads)
{
  const Array_surface surface(square(100, 0.2));
  Surface_arrays t = surface.t();
  const Obtuse_splits expected = split_obtuse_corners(t);
  EXPECT_GT(expected.splits.size(), 1000u);
  for(const unsigned number_of_threads : {2u, 5u})
  {
    t.number_of_threads = number_of_threads;
    const Obtuse_splits splits = split_obtuse_corners(t);
    ASSERT_EQ(splits.splits.size(), expected.splits.size());
    for(std::size_t i = 0; i < splits.splits.size(); ++i)
    {
      const Obtuse_splits::Split &split = splits.splits[i], &other = expected.splits[i];
      EXPECT_EQ(split.corner, other.corner);
      EXPECT_EQ(split.vertex, other.vertex);
      EXPECT_EQ(split.length, other.length);
      EXPECT_EQ(split.to_neighbor, other.to_neighbor);
      EXPECT_EQ(split.base, other.base);
    }
    EXPECT_EQ(splits.split_corner, expected.split_corner);
    EXPECT_EQ(splits.begin, expected.begin);
    ASSERT_EQ(splits.views.size(), expected.views.size());
    for(std::size_t i = 0; i < splits.views.size(); ++i)
    {
      const Obtuse_splits::View &view = splits.views[i], &other = expected.views[i];
      EXPECT_EQ(view.target, other.target);
      EXPECT_EQ(view.along, other.along);
      EXPECT_EQ(view.split(), other.split());
      EXPECT_EQ(view.half(), other.half());
      EXPECT_EQ(view.is_from_splitting_vertex(), other.is_from_splitting_vertex());
    }
  }
}

TEST(Obtuse_splits, are_shared_while_referenced)
{
  const Array_surface surface(square(4, 0.2));
  const auto splits = shared_obtuse_splits(surface.t());
  EXPECT_EQ(shared_obtuse_splits(surface.t()), splits);
  // Copies do not share, because their lengths may be changed.
  const Surface_arrays copy = surface.t();
  EXPECT_NE(shared_obtuse_splits(copy), splits);
  std::weak_ptr<const Obtuse_splits> unshared = shared_obtuse_splits(copy);
  EXPECT_TRUE(unshared.expired());
}

} // namespace obtuse_splits_test
