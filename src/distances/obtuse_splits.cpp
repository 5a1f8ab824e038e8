// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/obtuse_splits.h>

#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "core/unfold.h"

#include <cmath>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Split = Obtuse_splits::Split;

// Unfolds triangles behind the edge opposite to a corner until one has a vertex that splits the
// corner into two acute angles. `angle` is (cos, sin) of the corner. The vertex is none if there is
// no such vertex within max_steps triangles.
Split find_splitting_vertex(const Surface_arrays& t, Index corner, const Vec2& angle)
{
  constexpr int max_steps = 20;
  const Vec2 a = {t.length[corner], 0.}, b = t.length[previous_halfedge(corner)] * angle;
  // The halfedge to be crossed; it runs from `begin` to `end`.
  Index h = next_halfedge(corner);
  Vec2 begin = a, end = b;
  for(int step = 0; step < max_steps; ++step)
  {
    h = t.twin[h]; // runs from end to begin
    if(h == none)
      break;
    const double length = t.length[h];
    if(length <= 0.)
      break;
    const Vec2 direction = (1. / length) * (begin - end);
    const Vec2 position = end + rotated(apex(t, h), direction);
    const bool is_acute_to_a = dot(a, position) > 0., is_acute_to_b = dot(b, position) > 0.;
    if(is_acute_to_a && is_acute_to_b && cross(a, position) > 0. && cross(position, b) > 0.)
      return {corner,
              t.corner[previous_halfedge(h)],
              norm(position),
              {t.length[corner], t.length[previous_halfedge(corner)]},
              {norm(a - position), norm(b - position)}};
    if(is_acute_to_a)
    {
      // The vertex is closer to a: the directions that split the angle are between it and end.
      begin = position;
      h = previous_halfedge(h);
    }
    else
    {
      end = position;
      h = next_halfedge(h);
    }
  }
  return {corner, none, 0., {0., 0.}, {0., 0.}};
}

// Appends the obtuse corners of a range that can be split, with the vertices that split them.
void find_splits(const Surface_arrays& t, std::size_t begin, std::size_t end,
                 std::vector<Split>& result)
{
  for(Index corner = static_cast<Index>(begin); corner < end; ++corner)
  {
    const double a = t.length[corner], b = t.length[previous_halfedge(corner)],
                 opposite = t.length[next_halfedge(corner)];
    // Right angles are common and need no split; the tolerance covers their round-off errors.
    if(!(opposite * opposite > a * a + b * b))
      continue;
    const Vec2 angle = angle_between(a, b, opposite);
    if(angle[0] >= -1e-12)
      continue;
    const Split split = find_splitting_vertex(t, corner, angle);
    if(split.vertex != none)
      result.push_back(split);
  }
}

// Returns the splits of blocks of consecutive corners.
std::vector<std::vector<Split>> find_splits(const Surface_arrays& t)
{
  constexpr std::size_t block_size = 1 << 14;
  std::vector<std::vector<Split>> result((t.corner.size() + block_size - 1) / block_size);
  for_each_block(t.corner.size(), block_size, t.number_of_threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 { find_splits(t, begin, end, result[block]); });
  return result;
}

// Calls visit(vertex, view) for the four views of each split.
template <typename Visitor>
void for_each_view(const Surface_arrays& t, const Obtuse_splits& s, const Visitor& visit)
{
  for(Index i = 0; i < s.splits.size(); ++i)
    for(const std::size_t half : {0, 1})
    {
      const Index corner = s.splits[i].corner, vertex = s.splits[i].vertex,
                  neighbor =
                      t.corner[half == 0 ? next_halfedge(corner) : previous_halfedge(corner)];
      visit(neighbor, Obtuse_splits::View{t.corner[corner], vertex, i, half, false});
      visit(vertex, Obtuse_splits::View{t.corner[corner], neighbor, i, half, true});
    }
}

} // namespace

Obtuse_splits split_obtuse_corners(const Surface_arrays& t)
{
  Obtuse_splits result;
  if(t.is_cloud())
    return result;
  std::vector<std::vector<Split>> blocks = find_splits(t);
  std::size_t number_of_splits = 0;
  for(const std::vector<Split>& block : blocks)
    number_of_splits += block.size();
  if(number_of_splits == 0)
    return result;
  const auto join_blocks = [&]
  {
    result.splits.reserve(number_of_splits);
    for(const std::vector<Split>& block : blocks)
      result.splits.insert(result.splits.end(), block.begin(), block.end());
    blocks = {};
  };
  const std::size_t n = t.number_of_vertices();
  const auto allocate_others = [&]
  {
    result.split_corner.assign(t.number_of_triangles(), 3);
    result.begin.assign(n + 1, 0);
    result.views.resize(4 * number_of_splits);
  };
  run_both(t.number_of_threads, join_blocks, allocate_others);

  for_each_index(number_of_splits, t.number_of_threads,
                 [&](std::size_t i)
                 {
                   const Index corner = result.splits[i].corner;
                   result.split_corner[corner / 3] = static_cast<std::uint8_t>(corner % 3);
                 });
  // Each thread reads all splits and visits the views of its own range of vertices.
  const auto for_each_view_of_ranges = [&](const auto& visit)
  {
    for_each_block(n, block_size_of_threads(n, t.number_of_threads), t.number_of_threads,
                   [&](std::size_t, std::size_t begin, std::size_t end)
                   {
                     for_each_view(t, result,
                                   [&](Index vertex, const Obtuse_splits::View& view)
                                   {
                                     if(vertex >= begin && vertex < end)
                                       visit(vertex, view);
                                   });
                   });
  };
  for_each_view_of_ranges([&](Index vertex, const Obtuse_splits::View&)
                          { ++result.begin[vertex]; });
  // The views of a vertex are stored from the last to the first, so that the end of each range
  // becomes its begin.
  std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
  for_each_view_of_ranges([&](Index vertex, const Obtuse_splits::View& view)
                          { result.views[--result.begin[vertex]] = view; });
  return result;
}

std::shared_ptr<const Obtuse_splits> shared_obtuse_splits(const Surface_arrays& t)
{
  const std::lock_guard<std::mutex> lock(t.shared.mutex);
  std::shared_ptr<const Obtuse_splits> result = t.shared.obtuse_splits.lock();
  if(!result)
    t.shared.obtuse_splits = result =
        std::make_shared<const Obtuse_splits>(split_obtuse_corners(t));
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
