// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Welder.h"

#include "readers/append_polygon.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace program {

namespace {

constexpr std::uint32_t empty_slot = std::numeric_limits<std::uint32_t>::max();

std::uint64_t hash(const Point& point)
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
  return result;
}

} // namespace

std::size_t Welder::slot(const Point& point) const
{
  const std::size_t mask = m_slots.size() - 1;
  std::size_t result = hash(point) & mask;
  while(m_slots[result] != empty_slot && m_surface.points[m_slots[result]] != point)
    result = (result + 1) & mask;
  return result;
}

void Welder::grow()
{
  constexpr std::size_t min_size = 1024;
  m_slots.assign(std::max(min_size, 2 * m_slots.size()), empty_slot);
  for(std::size_t i = 0; i < m_surface.points.size(); ++i)
    m_slots[slot(m_surface.points[i])] = static_cast<std::uint32_t>(i);
}

std::uint32_t Welder::index(Point point)
{
  for(double& x : point)
    x += 0.; // -0 becomes 0
  if(2 * (m_surface.points.size() + 1) > m_slots.size())
    grow();
  std::uint32_t& index = m_slots[slot(point)];
  if(index == empty_slot)
  {
    index = to_index(static_cast<double>(m_surface.points.size()));
    m_surface.points.push_back(point);
  }
  return index;
}

} // namespace program
