// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Welder.h"

#include "readers/append_polygon.h"

#include <cstring>
#include <limits>

namespace program {

namespace {

constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

// Returns a number whose highest bits differ for points that differ in few bits.
std::uint64_t hash_of(const Point& point)
{
  constexpr std::uint64_t factors[] = {0x9e3779b97f4a7c15u, 0xbf58476d1ce4e5b9u,
                                       0x94d049bb133111ebu};
  std::uint64_t sum = 0;
  for(std::size_t k = 0; k < 3; ++k)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &point[k], sizeof bits);
    // The lowest bits of small integers and of floats are zero.
    sum += (bits ^ (bits >> 32)) * factors[k];
  }
  return (sum ^ (sum >> 32)) * factors[0];
}

} // namespace

Welder::Welder(Surface_file& surface, std::size_t expected_points) : m_surface(surface)
{
  unsigned log2_of_size = 10;
  while(std::size_t{1} << log2_of_size < 2 * expected_points)
    ++log2_of_size;
  resize(log2_of_size);
}

// Returns the slot of a vertex with these coordinates, or the empty slot where it must be inserted.
Welder::Slot& Welder::find(const Corner& corner)
{
  const auto low_hash = static_cast<std::uint32_t>(corner.hash);
  Slot* slot = &first_slot(corner.hash);
  while(slot->vertex != no_vertex &&
        (slot->hash != low_hash || m_surface.points[slot->vertex] != corner.point))
    slot = slot == &m_slots.back() ? m_slots.data() : slot + 1;
  return *slot;
}

void Welder::resize(unsigned log2_of_size)
{
  m_slots.assign(std::size_t{1} << log2_of_size, {no_vertex, 0});
  m_shift = 64 - log2_of_size;
  for(std::size_t i = 0; i < m_surface.points.size(); ++i)
  {
    const Corner corner = {m_surface.points[i], hash_of(m_surface.points[i])};
    find(corner) = {to_index(i), static_cast<std::uint32_t>(corner.hash)};
  }
}

// Grows the table until at least half of the slots stay empty.
void Welder::reserve(std::size_t number_of_new_points)
{
  if(2 * (m_surface.points.size() + number_of_new_points) > m_slots.size())
    resize(65 - m_shift);
}

Welder::Corner Welder::corner_at(const Point& point)
{
  const Point normalized = {point[0] + 0., point[1] + 0., point[2] + 0.}; // -0 becomes 0
  return {normalized, hash_of(normalized)};
}

std::uint32_t Welder::insert(const Corner& corner)
{
  Slot& slot = find(corner);
  if(slot.vertex == no_vertex)
  {
    slot = {to_index(m_surface.points.size()), static_cast<std::uint32_t>(corner.hash)};
    m_surface.points.push_back(corner.point);
  }
  return slot.vertex;
}

std::uint32_t Welder::index(const Point& point)
{
  reserve(1);
  return insert(corner_at(point));
}

void Welder::append_corner(const Point& point)
{
  const Corner corner = corner_at(point);
  __builtin_prefetch(&first_slot(corner.hash));
  m_new_corners[m_number_of_new_corners] = corner;
  if(++m_number_of_new_corners == m_new_corners.size())
    flush();
}

void Welder::flush()
{
  reserve(m_number_of_new_corners);
  for(std::size_t i = 0; i < m_number_of_new_corners; ++i)
    m_surface.corners.push_back(insert(m_new_corners[i]));
  m_number_of_new_corners = 0;
}

} // namespace program
