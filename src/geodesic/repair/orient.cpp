// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/repair.h"

#include <algorithm>
#include <utility>

namespace program {

namespace {

constexpr std::uint32_t next_halfedge(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }

// Returns, for each halfedge, the other halfedge between the same two vertices, in either
// direction. The result is no_halfedge unless exactly two halfedges exist. Counts edges with more
// than two halfedges. Size: #halfedges.
std::vector<std::uint32_t> opposite_halfedges(const std::vector<std::uint32_t>& corners,
                                              std::size_t& number_of_nonmanifold_edges)
{
  std::vector<std::pair<std::uint64_t, std::uint32_t>> halfedges(corners.size());
  for(std::uint32_t h = 0; h < corners.size(); ++h)
  {
    const auto [low, high] = std::minmax(corners[h], corners[next_halfedge(h)]);
    halfedges[h] = {std::uint64_t{low} << 32 | high, h};
  }
  std::sort(halfedges.begin(), halfedges.end());
  std::vector<std::uint32_t> result(corners.size(), no_halfedge);
  for(std::size_t i = 0, j; i < halfedges.size(); i = j)
  {
    for(j = i + 1; j < halfedges.size() && halfedges[j].first == halfedges[i].first; ++j)
      ;
    if(j == i + 2)
    {
      result[halfedges[i].second] = halfedges[i + 1].second;
      result[halfedges[i + 1].second] = halfedges[i].second;
    }
    else if(j > i + 2)
      ++number_of_nonmanifold_edges;
  }
  return result;
}

// Returns which triangles to flip for a consistent orientation. If no consistent orientation
// exists, the contradicting edges are cut.
std::vector<bool> choose_flips(const std::vector<std::uint32_t>& corners,
                               Connectivity& connectivity)
{
  const std::size_t triangles = corners.size() / 3;
  std::vector<bool> flip(triangles, false), seen(triangles, false);
  std::vector<std::uint32_t> component;
  for(std::uint32_t start = 0; start < triangles; ++start)
  {
    if(seen[start])
      continue;
    ++connectivity.number_of_components;
    component.assign(1, start);
    seen[start] = true;
    std::size_t flipped = 0;
    for(std::size_t i = 0; i < component.size(); ++i)
    {
      const std::uint32_t f = component[i];
      flipped += flip[f] ? 1 : 0;
      for(std::uint32_t h = 3 * f; h < 3 * f + 3; ++h)
      {
        const std::uint32_t t = connectivity.twins[h];
        if(t == no_halfedge)
          continue;
        const std::uint32_t g = t / 3;
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
          connectivity.twins[h] = connectivity.twins[t] = no_halfedge;
          ++connectivity.number_of_cut_edges;
        }
      }
    }
    const bool flip_all = 2 * flipped > component.size();
    if(flip_all)
      for(const std::uint32_t f : component)
        flip[f] = !flip[f];
    connectivity.number_of_flipped_faces += flip_all ? component.size() - flipped : flipped;
  }
  return flip;
}

void count_fans(const std::vector<std::uint32_t>& corners, std::size_t number_of_points,
                Connectivity& connectivity)
{
  std::vector<std::uint8_t> fans(number_of_points, 0);
  std::vector<bool> seen(corners.size(), false);
  for(std::uint32_t c = 0; c < corners.size(); ++c)
  {
    if(seen[c])
      continue;
    // Circulates clockwise to the boundary or once around, then counterclockwise over the whole
    // fan.
    std::uint32_t start = c;
    while(connectivity.twins[start] != no_halfedge && next_halfedge(connectivity.twins[start]) != c)
      start = next_halfedge(connectivity.twins[start]);
    for(std::uint32_t d = start;;)
    {
      seen[d] = true;
      const std::uint32_t before = d % 3 == 0 ? d + 2 : d - 1;
      if(connectivity.twins[before] == no_halfedge || connectivity.twins[before] == start)
        break;
      d = connectivity.twins[before];
    }
    ++connectivity.number_of_fans;
    std::uint8_t& count = fans[corners[c]];
    count = static_cast<std::uint8_t>(std::min(count + 1, 2));
  }
  connectivity.number_of_nonmanifold_vertices =
      static_cast<std::size_t>(std::count(fans.begin(), fans.end(), 2));
}

void count_boundary_loops(Connectivity& connectivity)
{
  std::vector<bool> seen(connectivity.twins.size(), false);
  for(std::uint32_t begin = 0; begin < connectivity.twins.size(); ++begin)
  {
    if(connectivity.twins[begin] != no_halfedge || seen[begin])
      continue;
    ++connectivity.number_of_boundary_loops;
    for(std::uint32_t h = begin; !seen[h];)
    {
      seen[h] = true;
      for(h = next_halfedge(h); connectivity.twins[h] != no_halfedge;)
        h = next_halfedge(connectivity.twins[h]);
    }
  }
}

} // namespace

long long Connectivity::genus(std::size_t triangles) const
{
  std::size_t number_of_boundary_halfedges = 0;
  for(const std::uint32_t twin : twins)
    number_of_boundary_halfedges += twin == no_halfedge ? 1 : 0;
  const auto to_signed = [](std::size_t n) { return static_cast<long long>(n); };
  const long long number_of_edges =
      (3 * to_signed(triangles) + to_signed(number_of_boundary_halfedges)) / 2;
  const long long euler_characteristic =
      to_signed(number_of_fans) - number_of_edges + to_signed(triangles);
  return (2 * to_signed(number_of_components) - to_signed(number_of_boundary_loops) -
          euler_characteristic) /
         2;
}

Connectivity orient(Surface_file& surface)
{
  Connectivity connectivity;
  std::vector<std::uint32_t>& corners = surface.corners;
  connectivity.twins = opposite_halfedges(corners, connectivity.number_of_cut_edges);
  const std::vector<bool> flip = choose_flips(corners, connectivity);

  // Swapping the last two corners swaps the first and the last halfedge.
  const auto new_index = [&flip](std::uint32_t h)
  { return h == no_halfedge || !flip[h / 3] ? h : 3 * (h / 3) + (2 - h % 3); };
  std::vector<std::uint32_t> twins(corners.size());
  for(std::uint32_t h = 0; h < corners.size(); ++h)
    twins[new_index(h)] = new_index(connectivity.twins[h]);
  connectivity.twins = std::move(twins);
  for(std::size_t f = 0; f < flip.size(); ++f)
    if(flip[f])
      std::swap(corners[3 * f + 1], corners[3 * f + 2]);

  count_fans(corners, surface.points.size(), connectivity);
  count_boundary_loops(connectivity);
  return connectivity;
}

} // namespace program
