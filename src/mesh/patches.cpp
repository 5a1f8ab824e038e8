// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/patches.h"

#include "core/unfold.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Each pass can create new fragments in adjacent patches; those after the last pass remain.
constexpr int max_passes = 20;

double area(const Surface_arrays& t, Index triangle)
{
  const double* const length = &t.length[3 * std::size_t(triangle)];
  return twice_area(length[0], length[1], length[2]) / 2.;
}

// Returns the patch on the other side of a halfedge, or none.
Index patch_across(const Surface_arrays& t, const std::vector<Index>& patch, Index h)
{
  return t.twin[h] == none ? none : patch[t.twin[h] / 3];
}

// The vertices and patches that must be examined: in later passes, only those near changes of the
// previous pass.
struct Modified_flags
{
  std::vector<bool> vertices; // #vertices
  std::vector<bool> patches;  // patches that lost or gained triangles

  Modified_flags(const Surface_arrays& t, const std::vector<Index>& patch)
      : vertices(t.number_of_vertices(), true)
  {
    Index size = 0;
    for(const Index label : patch)
      if(label != none)
        size = std::max(size, label + 1);
    patches.assign(size, true);
  }
};

// Moves triangles of one patch to the adjacent patch with the longest common boundary. Returns
// false if there is no adjacent patch.
bool merge_into_neighbor(const Surface_arrays& t, std::vector<Index>& patch,
                         const std::vector<Index>& triangles, Modified_flags& modified)
{
  std::map<Index, double> shared_length;
  for(const Index f : triangles)
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(const Index other = patch_across(t, patch, h); other != none && other != patch[f])
        shared_length[other] += t.length[h];
  if(shared_length.empty())
    return false;
  const auto best =
      std::max_element(shared_length.begin(), shared_length.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  for(const Index f : triangles)
  {
    modified.patches[patch[f]] = true;
    patch[f] = best->first;
    for(Index corner = 3 * f; corner < 3 * f + 3; ++corner)
      modified.vertices[t.corner[corner]] = true;
  }
  modified.patches[best->first] = true;
  return true;
}

struct Reached_triangle
{
  Index triangle;
  Index seed; // index in `seeds`
};

// Returns the triangles of a patch that are connected to the seeds, in breadth-first order, each
// with the seed that reached it first. All seeds must be in one patch.
//
// seen: #triangles, set to `visit_mark` for each result; no element may have this value before
std::vector<Reached_triangle> reach_from_seeds(const Surface_arrays& t,
                                               const std::vector<Index>& patch,
                                               const std::vector<Index>& seeds,
                                               std::vector<Index>& seen, Index visit_mark)
{
  std::vector<Reached_triangle> found;
  const auto add = [&](Index triangle, Index seed)
  {
    seen[triangle] = visit_mark;
    found.push_back({triangle, seed});
  };
  for(Index i = 0; i < seeds.size(); ++i)
    add(seeds[i], i);
  for(std::size_t k = 0; k < found.size(); ++k)
  {
    const auto [triangle, seed] = found[k];
    for(Index h = 3 * triangle; h < 3 * triangle + 3; ++h)
      if(patch_across(t, patch, h) == patch[triangle] && seen[t.twin[h] / 3] != visit_mark)
        add(t.twin[h] / 3, seed);
  }
  return found;
}

// Merges all connected pieces of a patch except its largest into adjacent patches. Returns whether
// there were any.
bool merge_small_pieces(const Surface_arrays& t, std::vector<Index>& patch,
                        Modified_flags& modified)
{
  const std::vector<bool> is_modified =
      std::exchange(modified.patches, std::vector<bool>(modified.patches.size(), false));
  std::vector<Index> seen(patch.size(), none);
  std::vector<std::vector<Index>> pieces;
  // of each patch: area and index of the piece
  std::map<Index, std::pair<double, std::size_t>> largest_piece;
  for(Index f = 0; f < patch.size(); ++f)
    if(patch[f] != none && is_modified[patch[f]] && seen[f] == none)
    {
      pieces.emplace_back();
      double sum = 0.;
      for(const Reached_triangle& found : reach_from_seeds(t, patch, {f}, seen, patch[f]))
      {
        pieces.back().push_back(found.triangle);
        sum += area(t, found.triangle);
      }
      const std::pair<double, std::size_t> piece = {sum, pieces.size() - 1};
      const auto entry = largest_piece.try_emplace(patch[f], piece).first;
      if(sum > entry->second.first)
        entry->second = piece;
    }
  bool has_changed = false;
  for(std::size_t i = 0; i < pieces.size(); ++i)
    if(largest_piece.at(patch[pieces[i].front()]).second != i)
      has_changed = merge_into_neighbor(t, patch, pieces[i], modified) || has_changed;
  return has_changed;
}

// The corners of a vertex, grouped into sectors: maximal runs of adjacent triangles of the same
// patch. Triangles without a patch are omitted.
struct Sectors
{
  std::vector<std::vector<Index>> corners;

  Sectors(const Surface_arrays& t, const std::vector<Index>& patch, Index vertex)
  {
    const auto is_joined = [&](Index corner, Index next)
    {
      // The next corner begins with the twin of the last halfedge of this one.
      const Index h = previous_halfedge(corner);
      return t.twin[h] == next && patch[corner / 3] == patch[next / 3];
    };
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    {
      const Index corner = t.ring[i];
      if(patch[corner / 3] == none)
        continue;
      if(corners.empty() || !is_joined(corners.back().back(), corner))
        corners.emplace_back();
      corners.back().push_back(corner);
    }
    // In a closed fan, the last run can continue in the first.
    for(std::size_t first = 0; first < corners.size(); ++first)
      for(std::size_t last = first + 1; last < corners.size(); ++last)
        if(is_joined(corners[last].back(), corners[first].front()))
        {
          corners[last].insert(corners[last].end(), corners[first].begin(), corners[first].end());
          std::swap(corners[first], corners[last]);
          corners.erase(corners.begin() + std::ptrdiff_t(last));
          --last;
        }
  }
};

// Returns the patch of an interior vertex all of whose triangles are in this patch, otherwise none.
Index enclosing_patch(const Surface_arrays& t, const std::vector<Index>& patch, Index vertex)
{
  const Index begin = t.ring_begin[vertex], end = t.ring_begin[vertex + 1];
  const Index result = begin == end ? none : patch[t.ring[begin] / 3];
  for(Index i = begin; i < end && result != none; ++i)
  {
    const Index next = t.ring[i + 1 < end ? i + 1 : begin];
    if(patch[next / 3] != result || t.twin[previous_halfedge(t.ring[i])] != next)
      return none;
  }
  return result;
}

// Keeps the largest sector of each patch at each vertex and merges one of the others into an
// adjacent patch. Returns whether there were any.
bool separate_touching_sectors(const Surface_arrays& t, std::vector<Index>& patch,
                               Modified_flags& modified)
{
  bool has_changed = false;
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
  {
    if(!modified.vertices[vertex])
      continue;
    modified.vertices[vertex] = false;
    Index first = none;
    bool has_several_patches = false;
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    {
      const Index label = patch[t.ring[i] / 3];
      has_several_patches = has_several_patches || (first != none && label != first);
      first = label;
    }
    if(!has_several_patches)
      continue;
    Sectors sectors(t, patch, vertex);
    std::map<Index, std::size_t> largest_sector; // of each patch
    for(std::size_t i = 0; i < sectors.corners.size(); ++i)
    {
      const auto entry = largest_sector.try_emplace(patch[sectors.corners[i].front() / 3], i).first;
      if(sectors.corners[i].size() > sectors.corners[entry->second].size())
        entry->second = i;
    }
    for(std::size_t i = 0; i < sectors.corners.size(); ++i)
      if(largest_sector.at(patch[sectors.corners[i].front() / 3]) != i)
      {
        std::vector<Index> triangles;
        for(const Index corner : sectors.corners[i])
          triangles.push_back(corner / 3);
        has_changed = merge_into_neighbor(t, patch, triangles, modified) || has_changed;
        break; // the other sectors may have changed
      }
  }
  return has_changed;
}

} // namespace

std::vector<Index> label_patches(const Surface_arrays& t, const std::vector<double>& distances,
                                 const std::vector<Index>& labels)
{
  std::vector<Index> patch(t.number_of_triangles(), none);
  for(Index f = 0; f < patch.size(); ++f)
  {
    const std::array vertices = {t.corner[3 * f], t.corner[3 * f + 1], t.corner[3 * f + 2]};
    const std::array corner_labels = {labels[vertices[0]], labels[vertices[1]],
                                      labels[vertices[2]]};
    if(corner_labels[0] == none || corner_labels[1] == none || corner_labels[2] == none)
      continue;
    const Index nearest =
        *std::min_element(vertices.begin(), vertices.end(),
                          [&](Index a, Index b) { return distances[a] < distances[b]; });
    patch[f] = corner_labels[0] == corner_labels[1] || corner_labels[0] == corner_labels[2]
                   ? corner_labels[0]
               : corner_labels[1] == corner_labels[2] ? corner_labels[1]
                                                      : labels[nearest];
  }
  return patch;
}

void merge_patch_fragments(const Surface_arrays& t, std::vector<Index>& patch)
{
  Modified_flags modified(t, patch);
  for(int pass = 0; pass < max_passes; ++pass)
  {
    const bool had_pieces = merge_small_pieces(t, patch, modified),
               had_touching_sectors = separate_touching_sectors(t, patch, modified);
    if(!had_pieces && !had_touching_sectors)
      return;
  }
}

std::vector<bool> are_disks(const Surface_arrays& t, const std::vector<Index>& patch,
                            Index number_of_patches)
{
  // Euler's formula for patches that are connected and do not touch themselves in a vertex: the
  // characteristic of a disk is 1.
  std::vector<long long> euler(number_of_patches, 0);
  std::vector<Index> size(number_of_patches, 0);
  std::vector<bool> result(number_of_patches, true);
  for(Index f = 0; f < patch.size(); ++f)
    if(patch[f] != none)
    {
      ++euler[patch[f]];
      ++size[patch[f]];
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(patch_across(t, patch, h) != patch[f] || h < t.twin[h])
          --euler[patch[f]];
    }
  std::vector<Index> sector_patches; // the patch of each sector of a vertex
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
  {
    if(const Index enclosing = enclosing_patch(t, patch, vertex); enclosing != none)
    {
      ++euler[enclosing];
      continue;
    }
    sector_patches.clear();
    for(const auto& sector : Sectors(t, patch, vertex).corners)
      sector_patches.push_back(patch[sector.front() / 3]);
    std::sort(sector_patches.begin(), sector_patches.end());
    for(std::size_t i = 0; i < sector_patches.size(); ++i)
      if(i > 0 && sector_patches[i] == sector_patches[i - 1])
        result[sector_patches[i]] = false;
      else
        ++euler[sector_patches[i]];
  }
  std::vector<Index> seen(patch.size(), none);
  std::vector<bool> has_piece(number_of_patches, false);
  for(Index f = 0; f < patch.size(); ++f)
    if(patch[f] != none && seen[f] == none)
    {
      result[patch[f]] = result[patch[f]] && !has_piece[patch[f]];
      has_piece[patch[f]] = true;
      reach_from_seeds(t, patch, {f}, seen, patch[f]);
    }
  for(Index i = 0; i < number_of_patches; ++i)
    result[i] = size[i] < 2 || (result[i] && euler[i] == 1);
  return result;
}

std::vector<Index> bisect_patch(const Surface_arrays& t, Index first, Index second)
{
  std::vector<Index> patch(t.number_of_triangles(), 0), seen(patch.size(), none);
  for(const Reached_triangle& found : reach_from_seeds(t, patch, {first, second}, seen, 0))
    seen[found.triangle] = found.seed;
  return seen;
}

std::array<Index, 2> farthest_triangle_pair(const Surface_arrays& t)
{
  const std::vector<Index> patch(t.number_of_triangles(), 0);
  std::vector<Index> seen(patch.size(), none);
  const Index first = reach_from_seeds(t, patch, {0}, seen, 0).back().triangle;
  return {first, reach_from_seeds(t, patch, {first}, seen, 1).back().triangle};
}

std::vector<Index> split_into_disks(const Surface_arrays& t, std::vector<Index>& patch,
                                    Index number_of_patches)
{
  const std::size_t number_given = number_of_patches;
  const auto relabel = [&](const std::vector<Reached_triangle>& triangles)
  {
    for(const Reached_triangle& found : triangles)
      if(found.seed == 0)
        patch[found.triangle] = number_of_patches;
    ++number_of_patches;
  };
  // First, connected pieces become patches.
  std::vector<Index> seen(patch.size(), none);
  std::vector<bool> has_piece(number_given, false);
  for(Index f = 0; f < patch.size(); ++f)
    if(patch[f] != none && seen[f] == none)
    {
      const std::vector<Reached_triangle> piece = reach_from_seeds(t, patch, {f}, seen, 0);
      if(has_piece[patch[f]])
        relabel(piece);
      else
        has_piece[patch[f]] = true;
    }
  for(;;)
  {
    std::vector<Index> representative(number_of_patches, none);
    for(Index f = 0; f < patch.size(); ++f)
      if(patch[f] != none)
        representative[patch[f]] = f;
    const std::vector<bool> is_disk = are_disks(t, patch, number_of_patches);
    if(std::find(is_disk.begin(), is_disk.end(), false) == is_disk.end())
      return {representative.begin() + std::ptrdiff_t(number_given), representative.end()};
    seen.assign(patch.size(), none);
    Index visit_mark = 0;
    for(Index i = 0; i < is_disk.size(); ++i)
      if(!is_disk[i])
      {
        // Bisects the patch between two triangles that are far apart.
        const Index end =
            reach_from_seeds(t, patch, {representative[i]}, seen, visit_mark++).back().triangle;
        const Index other = reach_from_seeds(t, patch, {end}, seen, visit_mark++).back().triangle;
        relabel(reach_from_seeds(t, patch, {end, other}, seen, visit_mark++));
      }
  }
}

} // namespace CGAL::Geodesic_processing::internal
