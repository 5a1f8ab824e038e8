// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/orient_triangles.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns which triangles to flip for a consistent orientation. If no consistent orientation
// exists, splits the edges that contradict it.
std::vector<bool> choose_flips(const std::vector<Index>& corners, std::vector<Index>& opposites,
                               Soup_report& report)
{
  const std::size_t number_of_triangles = corners.size() / 3;
  std::vector<bool> flip(number_of_triangles, false), seen(number_of_triangles, false);
  std::vector<Index> component;
  for(Index start = 0; start < number_of_triangles; ++start)
  {
    if(seen[start])
      continue;
    ++report.number_of_components;
    component.assign(1, start);
    seen[start] = true;
    std::size_t flipped = 0;
    for(std::size_t i = 0; i < component.size(); ++i)
    {
      const Index f = component[i];
      flipped += flip[f] ? 1 : 0;
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Index t = opposites[h];
        if(t == none)
          continue;
        const Index g = t / 3;
        // Halfedges with the same source have the same direction, so one of the two triangles must
        // be flipped.
        const bool should_flip = flip[f] != (corners[h] == corners[t]);
        if(!seen[g])
        {
          seen[g] = true;
          flip[g] = should_flip;
          component.push_back(g);
        }
        else if(flip[g] != should_flip)
        {
          opposites[h] = opposites[t] = none;
          ++report.number_of_split_edges;
        }
      }
    }
    const bool flip_all = 2 * flipped > component.size();
    if(flip_all)
      for(const Index f : component)
        flip[f] = !flip[f];
    report.number_of_reversed_triangles += flip_all ? component.size() - flipped : flipped;
  }
  return flip;
}

// Counts the boundary cycles. Returns the number of boundary halfedges.
std::size_t count_boundary_cycles(const std::vector<Index>& twins, Soup_report& report)
{
  std::size_t number_of_boundary_halfedges = 0;
  std::vector<bool> seen(twins.size(), false);
  for(Index begin = 0; begin < twins.size(); ++begin)
  {
    if(twins[begin] != none)
      continue;
    ++number_of_boundary_halfedges;
    if(seen[begin])
      continue;
    ++report.number_of_boundary_cycles;
    for(Index h = begin; !seen[h];)
    {
      seen[h] = true;
      for(h = next_halfedge(h); twins[h] != none;)
        h = next_halfedge(twins[h]);
    }
  }
  return number_of_boundary_halfedges;
}

} // namespace

std::vector<Index> orient_triangles(std::vector<Index>& corners, std::vector<Index> opposites,
                                    Soup_report& report)
{
  const std::vector<bool> flip = choose_flips(corners, opposites, report);
  if(report.number_of_reversed_triangles == 0)
    return opposites;

  // Swapping the last two corners swaps the first and the last halfedge.
  const auto new_index = [&flip](Index h)
  { return h == none || !flip[h / 3] ? h : 3 * (h / 3) + (2 - h % 3); };
  std::vector<Index> twins(corners.size());
  for(Index h = 0; h < corners.size(); ++h)
    twins[new_index(h)] = new_index(opposites[h]);
  for(std::size_t f = 0; f < flip.size(); ++f)
    if(flip[f])
      std::swap(corners[3 * f + 1], corners[3 * f + 2]);
  return twins;
}

std::size_t count_fans(std::size_t number_of_points, const std::vector<Index>& corners,
                       const std::vector<Index>& twins, Soup_report& report)
{
  std::size_t number_of_fans = 0;
  std::vector<std::uint8_t> fans(number_of_points, 0);
  std::vector<bool> seen(corners.size(), false);
  for(Index c = 0; c < corners.size(); ++c)
  {
    if(seen[c])
      continue;
    // Circulates clockwise to the boundary or once around, then counterclockwise over the whole
    // fan.
    Index start = c;
    while(twins[start] != none && next_halfedge(twins[start]) != c)
      start = next_halfedge(twins[start]);
    for(Index d = start;;)
    {
      seen[d] = true;
      const Index before = previous_halfedge(d);
      if(twins[before] == none || twins[before] == start)
        break;
      d = twins[before];
    }
    ++number_of_fans;
    std::uint8_t& count = fans[corners[c]];
    count = static_cast<std::uint8_t>(std::min(count + 1, 2));
  }
  report.number_of_nonmanifold_points =
      static_cast<std::size_t>(std::count(fans.begin(), fans.end(), 2));
  return number_of_fans;
}

std::size_t count_components(const std::vector<Index>& twins)
{
  // Union-find. Adjacent triangles are mostly close to each other in memory.
  const Index number_of_triangles = static_cast<Index>(twins.size() / 3);
  std::vector<Index> parent(number_of_triangles);
  std::iota(parent.begin(), parent.end(), Index(0));
  const auto root_of = [&](Index f)
  {
    while(parent[f] != f)
      f = parent[f] = parent[parent[f]];
    return f;
  };
  std::size_t result = number_of_triangles;
  for(Index f = 0; f < number_of_triangles; ++f)
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(twins[h] < h) // not none
      {
        const Index a = root_of(f), b = root_of(twins[h] / 3);
        if(a != b)
        {
          parent[std::max(a, b)] = std::min(a, b);
          --result;
        }
      }
  return result;
}

void measure_topology(std::size_t number_of_fans, const std::vector<Index>& twins,
                      Soup_report& report)
{
  const std::size_t number_of_boundary_halfedges = count_boundary_cycles(twins, report),
                    number_of_triangles = twins.size() / 3,
                    number_of_edges = (twins.size() + number_of_boundary_halfedges) / 2;
  // Euler's formula: #vertices - #edges + #triangles = 2 #components - 2 genus - #boundary cycles.
  report.genus = (2 * report.number_of_components + number_of_edges -
                  report.number_of_boundary_cycles - number_of_fans - number_of_triangles) /
                 2;
}

} // namespace CGAL::Geodesic_processing::internal
