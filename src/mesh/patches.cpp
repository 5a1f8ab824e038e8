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

// What is tidied can make its neighbours untidy; what is left after so many times stays.
constexpr int most_passes = 20;

double area(const Glued_triangles& t, Index triangle)
{
  const double* const length = &t.length[3 * std::size_t(triangle)];
  return twice_area(length[0], length[1], length[2]) / 2.;
}

// The patch behind a side, or none.
Index behind(const Glued_triangles& t, const std::vector<Index>& patch, Index side)
{
  return t.twin[side] == none ? none : patch[t.twin[side] / 3];
}

// What is to be looked at again: after a pass that is the surroundings of what it changed.
struct Untidy
{
  std::vector<bool> sites;   // #sites
  std::vector<bool> patches; // those that lost or got triangles

  Untidy(const Glued_triangles& t, const std::vector<Index>& patch)
      : sites(t.number_of_sites(), true)
  {
    Index size = 0;
    for(const Index label : patch)
      if(label != none)
        size = std::max(size, label + 1);
    patches.assign(size, true);
  }
};

// Gives some triangles of a patch to the one with which they have the most in common.  False where there
// is no other.
bool give_away(const Glued_triangles& t, std::vector<Index>& patch,
               const std::vector<Index>& triangles, Untidy& untidy)
{
  std::map<Index, double> common;
  for(const Index f : triangles)
    for(Index side = 3 * f; side < 3 * f + 3; ++side)
      if(const Index other = behind(t, patch, side); other != none && other != patch[f])
        common[other] += t.length[side];
  if(common.empty())
    return false;
  const auto best =
      std::max_element(common.begin(), common.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  for(const Index f : triangles)
  {
    untidy.patches[patch[f]] = true;
    patch[f] = best->first;
    for(Index corner = 3 * f; corner < 3 * f + 3; ++corner)
      untidy.sites[t.corner[corner]] = true;
  }
  untidy.patches[best->first] = true;
  return true;
}

struct Found
{
  Index triangle;
  Index seed; // by place
};

// The triangles of one patch that sides join to seeds in it, in the order of the number of sides between.
// seen: #triangles, for which this is the first call with `mark`
std::vector<Found> spread(const Glued_triangles& t, const std::vector<Index>& patch,
                          const std::vector<Index>& seeds, std::vector<Index>& seen, Index mark)
{
  std::vector<Found> found;
  const auto add = [&](Index triangle, Index seed)
  {
    seen[triangle] = mark;
    found.push_back({triangle, seed});
  };
  for(Index i = 0; i < seeds.size(); ++i)
    add(seeds[i], i);
  for(std::size_t k = 0; k < found.size(); ++k)
  {
    const auto [triangle, seed] = found[k];
    for(Index side = 3 * triangle; side < 3 * triangle + 3; ++side)
      if(behind(t, patch, side) == patch[triangle] && seen[t.twin[side] / 3] != mark)
        add(t.twin[side] / 3, seed);
  }
  return found;
}

// Gives away all pieces of patches but their largest ones.  True if there were some.
bool join_islands(const Glued_triangles& t, std::vector<Index>& patch, Untidy& untidy)
{
  const std::vector<bool> is_looked_at =
      std::exchange(untidy.patches, std::vector<bool>(untidy.patches.size(), false));
  std::vector<Index> seen(patch.size(), none);
  std::vector<std::vector<Index>> pieces;
  std::map<Index, std::pair<double, std::size_t>> largest; // of each patch: area, piece
  for(Index f = 0; f < patch.size(); ++f)
    if(patch[f] != none && is_looked_at[patch[f]] && seen[f] == none)
    {
      pieces.emplace_back();
      double sum = 0.;
      for(const Found& found : spread(t, patch, {f}, seen, patch[f]))
      {
        pieces.back().push_back(found.triangle);
        sum += area(t, found.triangle);
      }
      const std::pair<double, std::size_t> piece = {sum, pieces.size() - 1};
      const auto at = largest.try_emplace(patch[f], piece).first;
      if(sum > at->second.first)
        at->second = piece;
    }
  bool is_changed = false;
  for(std::size_t i = 0; i < pieces.size(); ++i)
    if(largest.at(patch[pieces[i].front()]).second != i)
      is_changed = give_away(t, patch, pieces[i], untidy) || is_changed;
  return is_changed;
}

// The corners of a site in runs whose triangles share sides and a patch, those of no patch left out.
struct Sectors
{
  std::vector<std::vector<Index>> corners;

  Sectors(const Glued_triangles& t, const std::vector<Index>& patch, Index site)
  {
    const auto is_joined = [&](Index corner, Index next)
    {
      // Counterclockwise the next corner begins with the side that ends this one.
      const Index side = previous_side(corner);
      return t.twin[side] == next && patch[corner / 3] == patch[next / 3];
    };
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      const Index corner = t.star[i];
      if(patch[corner / 3] == none)
        continue;
      if(corners.empty() || !is_joined(corners.back().back(), corner))
        corners.emplace_back();
      corners.back().push_back(corner);
    }
    // Where a fan closes its last run is the first one.
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

// The patch of all triangles around a site that are joined by sides, without a border; or none.
Index patch_all_around(const Glued_triangles& t, const std::vector<Index>& patch, Index site)
{
  const Index begin = t.first[site], end = t.first[site + 1];
  const Index result = begin == end ? none : patch[t.star[begin] / 3];
  for(Index i = begin; i < end && result != none; ++i)
  {
    const Index next = t.star[i + 1 < end ? i + 1 : begin];
    if(patch[next / 3] != result || t.twin[previous_side(t.star[i])] != next)
      return none;
  }
  return result;
}

// Leaves each patch one sector of each site, that with the most triangles.  True if there were more.
bool untie(const Glued_triangles& t, std::vector<Index>& patch, Untidy& untidy)
{
  bool is_changed = false;
  for(Index site = 0; site < t.number_of_sites(); ++site)
  {
    if(!untidy.sites[site])
      continue;
    untidy.sites[site] = false;
    Index first = none;
    bool has_several = false;
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      const Index label = patch[t.star[i] / 3];
      has_several = has_several || (first != none && label != first);
      first = label;
    }
    if(!has_several)
      continue;
    Sectors sectors(t, patch, site);
    std::map<Index, std::size_t> kept; // of each patch
    for(std::size_t i = 0; i < sectors.corners.size(); ++i)
    {
      const auto at = kept.try_emplace(patch[sectors.corners[i].front() / 3], i).first;
      if(sectors.corners[i].size() > sectors.corners[at->second].size())
        at->second = i;
    }
    for(std::size_t i = 0; i < sectors.corners.size(); ++i)
      if(kept.at(patch[sectors.corners[i].front() / 3]) != i)
      {
        std::vector<Index> triangles;
        for(const Index corner : sectors.corners[i])
          triangles.push_back(corner / 3);
        is_changed = give_away(t, patch, triangles, untidy) || is_changed;
        break; // as what the others are may have changed
      }
  }
  return is_changed;
}

} // namespace

std::vector<Index> patches(const Glued_triangles& t, const std::vector<double>& distances,
                           const std::vector<Index>& labels)
{
  std::vector<Index> patch(t.number_of_triangles(), none);
  for(Index f = 0; f < patch.size(); ++f)
  {
    const std::array sites = {t.corner[3 * f], t.corner[3 * f + 1], t.corner[3 * f + 2]};
    const std::array own = {labels[sites[0]], labels[sites[1]], labels[sites[2]]};
    if(own[0] == none || own[1] == none || own[2] == none)
      continue;
    const Index nearest = *std::min_element(
        sites.begin(), sites.end(), [&](Index a, Index b) { return distances[a] < distances[b]; });
    patch[f] = own[0] == own[1] || own[0] == own[2] ? own[0]
               : own[1] == own[2]                   ? own[1]
                                                    : labels[nearest];
  }
  return patch;
}

void tidy(const Glued_triangles& t, std::vector<Index>& patch)
{
  Untidy untidy(t, patch);
  for(int pass = 0; pass < most_passes; ++pass)
  {
    const bool had_islands = join_islands(t, patch, untidy), was_tied = untie(t, patch, untidy);
    if(!had_islands && !was_tied)
      return;
  }
}

std::vector<bool> are_discs(const Glued_triangles& t, const std::vector<Index>& patch,
                            Index number_of_patches)
{
  // By Euler's formula among what is in one piece and touches itself in no corner.
  std::vector<long long> euler(number_of_patches, 0);
  std::vector<Index> size(number_of_patches, 0);
  std::vector<bool> result(number_of_patches, true);
  for(Index f = 0; f < patch.size(); ++f)
    if(patch[f] != none)
    {
      ++euler[patch[f]];
      ++size[patch[f]];
      for(Index side = 3 * f; side < 3 * f + 3; ++side)
        if(behind(t, patch, side) != patch[f] || side < t.twin[side])
          --euler[patch[f]];
    }
  std::vector<Index> around; // of a site: a patch for each sector
  for(Index site = 0; site < t.number_of_sites(); ++site)
  {
    if(const Index only = patch_all_around(t, patch, site); only != none)
    {
      ++euler[only];
      continue;
    }
    around.clear();
    for(const auto& sector : Sectors(t, patch, site).corners)
      around.push_back(patch[sector.front() / 3]);
    std::sort(around.begin(), around.end());
    for(std::size_t i = 0; i < around.size(); ++i)
      if(i > 0 && around[i] == around[i - 1])
        result[around[i]] = false;
      else
        ++euler[around[i]];
  }
  std::vector<Index> seen(patch.size(), none);
  std::vector<bool> has_piece(number_of_patches, false);
  for(Index f = 0; f < patch.size(); ++f)
    if(patch[f] != none && seen[f] == none)
    {
      result[patch[f]] = result[patch[f]] && !has_piece[patch[f]];
      has_piece[patch[f]] = true;
      spread(t, patch, {f}, seen, patch[f]);
    }
  for(Index i = 0; i < number_of_patches; ++i)
    result[i] = size[i] < 2 || (result[i] && euler[i] == 1);
  return result;
}

std::vector<Index> halves(const Glued_triangles& t, Index first, Index second)
{
  std::vector<Index> patch(t.number_of_triangles(), 0), seen(patch.size(), none);
  for(const Found& found : spread(t, patch, {first, second}, seen, 0))
    seen[found.triangle] = found.seed;
  return seen;
}

std::array<Index, 2> ends(const Glued_triangles& t)
{
  const std::vector<Index> patch(t.number_of_triangles(), 0);
  std::vector<Index> seen(patch.size(), none);
  const Index first = spread(t, patch, {0}, seen, 0).back().triangle;
  return {first, spread(t, patch, {first}, seen, 1).back().triangle};
}

std::vector<Index> split_into_discs(const Glued_triangles& t, std::vector<Index>& patch,
                                    Index number_of_patches)
{
  const std::size_t given = number_of_patches;
  const auto relabel = [&](const std::vector<Found>& part)
  {
    for(const Found& found : part)
      if(found.seed == 0)
        patch[found.triangle] = number_of_patches;
    ++number_of_patches;
  };
  // Pieces first.
  std::vector<Index> seen(patch.size(), none);
  std::vector<bool> has_piece(given, false);
  for(Index f = 0; f < patch.size(); ++f)
    if(patch[f] != none && seen[f] == none)
    {
      const std::vector<Found> piece = spread(t, patch, {f}, seen, 0);
      if(has_piece[patch[f]])
        relabel(piece);
      else
        has_piece[patch[f]] = true;
    }
  for(;;)
  {
    std::vector<Index> some(number_of_patches, none);
    for(Index f = 0; f < patch.size(); ++f)
      if(patch[f] != none)
        some[patch[f]] = f;
    const std::vector<bool> is_disc = are_discs(t, patch, number_of_patches);
    if(std::find(is_disc.begin(), is_disc.end(), false) == is_disc.end())
      return {some.begin() + std::ptrdiff_t(given), some.end()};
    seen.assign(patch.size(), none);
    Index mark = 0;
    for(Index i = 0; i < is_disc.size(); ++i)
      if(!is_disc[i])
      {
        // What is nearer to one end than to the other.
        const Index end = spread(t, patch, {some[i]}, seen, mark++).back().triangle;
        const Index other = spread(t, patch, {end}, seen, mark++).back().triangle;
        relabel(spread(t, patch, {end, other}, seen, mark++));
      }
  }
}

} // namespace CGAL::Geodesic_processing::internal
