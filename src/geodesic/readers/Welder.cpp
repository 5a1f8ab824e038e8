// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Welder.h"

#include "readers/append_polygon.h"

#include <cstring>

namespace program {

std::uint32_t Welder::index(Point point)
{
  for(double& x : point)
    x += 0.; // -0 becomes 0
  const auto [entry, is_new] =
      m_index.try_emplace(point, to_index(static_cast<double>(m_surface.points.size())));
  if(is_new)
    m_surface.points.push_back(point);
  return entry->second;
}

std::size_t Welder::Hash::operator()(const Point& point) const
{
  std::uint64_t result = 0;
  for(const double x : point)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    // One step of splitmix64, because coordinates on a grid differ in few bits.
    result += bits + 0x9e3779b97f4a7c15u;
    result = (result ^ (result >> 30)) * 0xbf58476d1ce4e5b9u;
    result = (result ^ (result >> 27)) * 0x94d049bb133111ebu;
    result ^= result >> 31;
  }
  return static_cast<std::size_t>(result);
}

} // namespace program
