// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/patches.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace patches_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Labels each triangle by the position of its centroid.
template <typename Label>
std::vector<Index> label_by_centroid(const Array_surface& surface, const Label& label)
{
  const Surface_arrays& t = surface.t();
  std::vector<Index> result;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const Point p = point_at(t, {f, none, {1. / 3., 1. / 3., 1. / 3.}});
    result.push_back(label(p));
  }
  return result;
}

TEST(Patches, label_is_majority_or_nearest_corner)
{
  const Array_surface surface(tetrahedron());
  const Surface_arrays& t = surface.t();
  const std::vector<double> distances = {0.3, 0.1, 0.2, 0.4};
  const auto label_of = [&](const std::vector<Index>& labels, const std::set<Index>& corners)
  {
    const std::vector<Index> patch = label_patches(t, distances, labels);
    for(Index f = 0; f < patch.size(); ++f)
      if(std::set<Index>{t.corner[3 * f], t.corner[3 * f + 1], t.corner[3 * f + 2]} == corners)
        return patch[f];
    return none;
  };
  EXPECT_EQ(label_of({5, 5, 7, 8}, {0, 1, 2}), 5u);
  EXPECT_EQ(label_of({5, 6, 5, 8}, {0, 1, 2}), 5u);
  EXPECT_EQ(label_of({6, 5, 5, 8}, {0, 1, 2}), 5u);
  EXPECT_EQ(label_of({5, 6, 7, 8}, {0, 1, 2}), 6u);
  EXPECT_EQ(label_of({5, 6, 7, 8}, {0, 2, 3}), 7u);
  EXPECT_EQ(label_of({5, none, 5, 8}, {0, 1, 2}), none);
}

TEST(Patches, disk_topology_is_detected)
{
  // Coordinates of the grid are multiples of 1/8.
  const Array_surface surface(square(8));
  const auto count = [&](const auto& label, Index number)
  {
    const std::vector<bool> is_disk =
        are_disks(surface.t(), label_by_centroid(surface, label), number);
    return std::vector<bool>(is_disk.begin(), is_disk.end());
  };
  // All triangles, and no triangle.
  EXPECT_EQ(count([](const Point&) { return Index(0); }, 1), std::vector<bool>({true}));
  EXPECT_EQ(count([](const Point&) { return none; }, 1), std::vector<bool>({true}));
  // A square block and the annulus around it.
  const auto is_in_center = [](double x) { return x > 0.25 && x < 0.75; };
  EXPECT_EQ(
      count([&](const Point& p) { return Index(is_in_center(p[0]) && is_in_center(p[1])); }, 2),
      std::vector<bool>({false, true}));
  // A stripe between two pieces of the other patch.
  EXPECT_EQ(count([&](const Point& p) { return Index(is_in_center(p[0])); }, 2),
            std::vector<bool>({false, true}));
  // Two blocks that meet only in a vertex.
  EXPECT_EQ(count([&](const Point& p) { return Index((p[0] > 0.5) == (p[1] > 0.5)); }, 2),
            std::vector<bool>({false, false}));

  // Closed surfaces and cylinders are not disks.
  for(const Triangulation& triangulation : {icosphere(2), torus(12, 6), cylinder(8, 5, 1., 3.)})
  {
    const Array_surface whole(triangulation);
    EXPECT_FALSE(
        are_disks(whole.t(), std::vector<Index>(whole.t().number_of_triangles(), 0), 1)[0]);
  }
  const Array_surface sphere(icosphere(2));
  const std::vector<bool> halves = are_disks(
      sphere.t(), label_by_centroid(sphere, [](const Point& p) { return Index(p[2] > 0.); }), 2);
  EXPECT_TRUE(halves[0] && halves[1]);
}

TEST(Patches, fragments_and_touching_sectors_merge_into_neighbors)
{
  const Array_surface surface(square(8));
  // Two halves, and in each a block of the other patch that is not connected to its half.
  std::vector<Index> patch = label_by_centroid(surface,
                                               [](const Point& p)
                                               {
                                                 const bool is_block = p[1] > 0.5 && p[1] < 0.625 &&
                                                                       std::abs(p[0] - 0.5) > 0.25;
                                                 return Index((p[0] > 0.5) != is_block);
                                               });
  merge_patch_fragments(surface.t(), patch);
  EXPECT_EQ(patch, label_by_centroid(surface, [](const Point& p) { return Index(p[0] > 0.5); }));

  // Four quarters and a block that touches one of them only in a vertex.
  const auto quarter = [](const Point& p) { return Index(p[0] > 0.5) + 2 * Index(p[1] > 0.5); };
  std::vector<Index> touching = label_by_centroid(
      surface, [&](const Point& p)
      { return p[0] > 0.5 && p[0] < 0.625 && p[1] > 0.375 && p[1] < 0.5 ? 2u : quarter(p); });
  EXPECT_FALSE(are_disks(surface.t(), touching, 4)[2]);
  merge_patch_fragments(surface.t(), touching);
  EXPECT_TRUE(are_disks(surface.t(), touching, 4)[2]);
  EXPECT_TRUE(are_disks(surface.t(), touching, 4)[1]);

  // Fragments without an adjacent patch keep their label.
  const Array_surface two_surfaces(disjoint_union(square(4), tetrahedron()));
  std::vector<Index> labels(two_surfaces.t().number_of_triangles(), 0);
  merge_patch_fragments(two_surfaces.t(), labels);
  EXPECT_EQ(labels, std::vector<Index>(labels.size(), 0));
}

TEST(Patches, random_labels_become_disks)
{
  std::mt19937 random(3);
  for(const Triangulation& mesh : {square(12), icosphere(3), torus(24, 12), cylinder(12, 9, 1., 3.),
                                   disjoint_union(torus(12, 6), square(3)), double_torus()})
  {
    const Array_surface surface(mesh);
    const Surface_arrays& t = surface.t();
    for(const Index number : {1u, 3u, 40u})
    {
      std::vector<Index> patch;
      for(Index f = 0; f < t.number_of_triangles(); ++f)
        patch.push_back(random() % number);
      merge_patch_fragments(t, patch);
      const std::vector<Index> before = patch;
      const std::vector<Index> representatives = split_into_disks(t, patch, number);
      const std::vector<bool> is_disk = are_disks(t, patch, Index(number + representatives.size()));
      EXPECT_EQ(std::count(is_disk.begin(), is_disk.end(), false), 0);
      for(std::size_t i = 0; i < representatives.size(); ++i)
        EXPECT_EQ(patch[representatives[i]], number + i);
      // Each new patch comes from one old patch.
      std::map<Index, std::set<Index>> origins;
      for(Index f = 0; f < patch.size(); ++f)
        origins[patch[f]].insert(before[f]);
      for(const auto& [label, from] : origins)
        EXPECT_EQ(from.size(), 1u) << label;
    }
  }
}

TEST(Patches, bisection_of_strip_is_balanced)
{
  const Array_surface surface(grid(16, 1, [](double s, double t) -> Point { return {s, t, 0.}; }));
  const Surface_arrays& t = surface.t();
  const auto [first, second] = farthest_triangle_pair(t);
  const auto centroid_x = [&](Index f)
  {
    double x = 0.;
    for(Index corner = 3 * f; corner < 3 * f + 3; ++corner)
      x += t.point[t.corner[corner]][0] / 3.;
    return x;
  };
  double low = centroid_x(0), high = low;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    low = std::min(low, centroid_x(f));
    high = std::max(high, centroid_x(f));
  }
  // Sums of some hundred areas.
  EXPECT_NEAR(std::abs(centroid_x(first) - centroid_x(second)), high - low, 1e-12);
  const std::vector<Index> half = bisect_patch(t, first, second);
  EXPECT_EQ(half[first], 0u);
  EXPECT_EQ(half[second], 1u);
  for(Index f = 0; f < half.size(); ++f)
    if(std::abs(centroid_x(f) - (low + high) / 2.) > 0.1 * (high - low))
    {
      EXPECT_EQ(half[f] == 0, std::abs(centroid_x(f) - centroid_x(first)) <
                                  std::abs(centroid_x(f) - centroid_x(second)));
    }
}

} // namespace patches_test
