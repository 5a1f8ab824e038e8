// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/repair.h"

#include <algorithm>
#include <utility>

namespace program {

namespace {

constexpr std::uint32_t next_side(std::uint32_t s) { return s % 3 == 2 ? s - 2 : s + 1; }

// #sides: the only other side that joins the same two vertices, whichever way it runs.
// Counts the edges with more than two sides in `crowded`.
std::vector<std::uint32_t> neighbours(const std::vector<std::uint32_t>& corners,
                                      std::size_t& crowded)
{
  std::vector<std::pair<std::uint64_t, std::uint32_t>> sides(corners.size());
  for(std::uint32_t s = 0; s < corners.size(); ++s)
  {
    const auto [low, high] = std::minmax(corners[s], corners[next_side(s)]);
    sides[s] = {std::uint64_t{low} << 32 | high, s};
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::uint32_t> result(corners.size(), no_side);
  for(std::size_t i = 0, j; i < sides.size(); i = j)
  {
    for(j = i + 1; j < sides.size() && sides[j].first == sides[i].first; ++j)
      ;
    if(j == i + 2)
    {
      result[sides[i].second] = sides[i + 1].second;
      result[sides[i + 1].second] = sides[i].second;
    }
    else if(j > i + 2)
      ++crowded;
  }
  return result;
}

// Which triangles to turn round.  Leaves open the edges where that contradicts itself.
std::vector<bool> choose_flips(const std::vector<std::uint32_t>& corners, Gluing& gluing)
{
  const std::size_t triangles = corners.size() / 3;
  std::vector<bool> flip(triangles, false), seen(triangles, false);
  std::vector<std::uint32_t> component;
  for(std::uint32_t start = 0; start < triangles; ++start)
  {
    if(seen[start])
      continue;
    ++gluing.components;
    component.assign(1, start);
    seen[start] = true;
    std::size_t flipped = 0;
    for(std::size_t i = 0; i < component.size(); ++i)
    {
      const std::uint32_t f = component[i];
      flipped += flip[f] ? 1 : 0;
      for(std::uint32_t s = 3 * f; s < 3 * f + 3; ++s)
      {
        const std::uint32_t t = gluing.twins[s];
        if(t == no_side)
          continue;
        const std::uint32_t g = t / 3;
        // Sides that start at the same vertex run the same way: one triangle must turn.
        const bool wanted = flip[f] != (corners[s] == corners[t]);
        if(!seen[g])
        {
          seen[g] = true;
          flip[g] = wanted;
          component.push_back(g);
        }
        else if(flip[g] != wanted)
        {
          gluing.twins[s] = gluing.twins[t] = no_side;
          ++gluing.cut;
        }
      }
    }
    const bool turn_all = 2 * flipped > component.size();
    if(turn_all)
      for(const std::uint32_t f : component)
        flip[f] = !flip[f];
    gluing.flipped += turn_all ? component.size() - flipped : flipped;
  }
  return flip;
}

void count_fans(const std::vector<std::uint32_t>& corners, std::size_t points, Gluing& gluing)
{
  std::vector<std::uint8_t> fans(points, 0);
  std::vector<bool> seen(corners.size(), false);
  for(std::uint32_t c = 0; c < corners.size(); ++c)
  {
    if(seen[c])
      continue;
    // Clockwise to the border or once around, then counterclockwise over the whole fan.
    std::uint32_t start = c;
    while(gluing.twins[start] != no_side && next_side(gluing.twins[start]) != c)
      start = next_side(gluing.twins[start]);
    for(std::uint32_t d = start;;)
    {
      seen[d] = true;
      const std::uint32_t before = d % 3 == 0 ? d + 2 : d - 1;
      if(gluing.twins[before] == no_side || gluing.twins[before] == start)
        break;
      d = gluing.twins[before];
    }
    ++gluing.fans;
    std::uint8_t& count = fans[corners[c]];
    count = static_cast<std::uint8_t>(std::min(count + 1, 2));
  }
  gluing.pinched = static_cast<std::size_t>(std::count(fans.begin(), fans.end(), 2));
}

void count_boundary_loops(Gluing& gluing)
{
  std::vector<bool> seen(gluing.twins.size(), false);
  for(std::uint32_t begin = 0; begin < gluing.twins.size(); ++begin)
  {
    if(gluing.twins[begin] != no_side || seen[begin])
      continue;
    ++gluing.boundary_loops;
    for(std::uint32_t s = begin; !seen[s];)
    {
      seen[s] = true;
      for(s = next_side(s); gluing.twins[s] != no_side;)
        s = next_side(gluing.twins[s]);
    }
  }
}

} // namespace

long long Gluing::genus(std::size_t triangles) const
{
  std::size_t border = 0;
  for(const std::uint32_t twin : twins)
    border += twin == no_side ? 1 : 0;
  const auto number = [](std::size_t n) { return static_cast<long long>(n); };
  const long long edges = (3 * number(triangles) + number(border)) / 2;
  const long long euler = number(fans) - edges + number(triangles);
  return (2 * number(components) - number(boundary_loops) - euler) / 2;
}

Gluing orient(Surface_file& surface)
{
  Gluing gluing;
  std::vector<std::uint32_t>& corners = surface.corners;
  gluing.twins = neighbours(corners, gluing.cut);
  const std::vector<bool> flip = choose_flips(corners, gluing);

  // Exchanging the last two corners exchanges the first and the last side.
  const auto renamed = [&flip](std::uint32_t s)
  { return s == no_side || !flip[s / 3] ? s : 3 * (s / 3) + (2 - s % 3); };
  std::vector<std::uint32_t> twins(corners.size());
  for(std::uint32_t s = 0; s < corners.size(); ++s)
    twins[renamed(s)] = renamed(gluing.twins[s]);
  gluing.twins = std::move(twins);
  for(std::size_t f = 0; f < flip.size(); ++f)
    if(flip[f])
      std::swap(corners[3 * f + 1], corners[3 * f + 2]);

  count_fans(corners, surface.points.size(), gluing);
  count_boundary_loops(gluing);
  return gluing;
}

} // namespace program
