// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/arithmetic_coding.h"

#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr std::uint32_t half = 1u << 15;
constexpr std::uint16_t memory = 60; // bits after which older ones fade

// Where the interval is cut; both parts keep something.
std::uint32_t cut(std::uint32_t low, std::uint32_t high, std::uint32_t probability)
{
  return low + std::uint32_t((std::uint64_t(high - low) * probability) >> 16);
}

bool starts_alike(std::uint32_t low, std::uint32_t high) { return ((low ^ high) >> 24) == 0; }

} // namespace

void Bit_model::learn(bool bit)
{
  constexpr int least = 64, most = 65536 - 64;
  const int target = bit ? most : least;
  probability = std::uint16_t(probability + (target - int(probability)) / (seen + 2));
  if(seen < memory)
    ++seen;
}

void Bit_encoder::put(bool bit, std::uint32_t probability)
{
  const std::uint32_t middle = cut(m_low, m_high, probability);
  (bit ? m_high : m_low) = bit ? middle : middle + 1;
  while(starts_alike(m_low, m_high))
  {
    m_bytes.push_back(std::uint8_t(m_high >> 24));
    m_low <<= 8;
    m_high = (m_high << 8) | 0xff;
  }
}

void Bit_encoder::put(bool bit, Bit_model& model)
{
  put(bit, std::uint32_t(model.probability));
  model.learn(bit);
}

void Bit_encoder::put(bool bit) { put(bit, half); }

std::vector<std::uint8_t> Bit_encoder::finish()
{
  // The first bytes differ: with zeros after it, this lies in the interval.
  m_bytes.push_back(std::uint8_t((m_low >> 24) + 1));
  return std::move(m_bytes);
}

Bit_decoder::Bit_decoder(const std::uint8_t* bytes, std::size_t size, bool is_whole)
    : m_next(bytes), m_end(bytes + size), m_is_whole(is_whole)
{
  for(int i = 0; i < 4; ++i)
    shift();
}

void Bit_decoder::shift()
{
  const bool is_known = m_next != m_end;
  const std::uint32_t byte = is_known ? *m_next++ : 0;
  m_least = (m_least << 8) | byte;
  m_most = (m_most << 8) | (is_known || m_is_whole ? byte : 0xff);
}

bool Bit_decoder::get(std::uint32_t probability)
{
  const std::uint32_t middle = cut(m_low, m_high, probability);
  const bool bit = m_least <= middle;
  if(m_is_exhausted || bit != (m_most <= middle))
  {
    m_is_exhausted = true;
    return false;
  }
  (bit ? m_high : m_low) = bit ? middle : middle + 1;
  while(starts_alike(m_low, m_high))
  {
    shift();
    m_low <<= 8;
    m_high = (m_high << 8) | 0xff;
  }
  return bit;
}

bool Bit_decoder::get(Bit_model& model)
{
  const bool bit = get(std::uint32_t(model.probability));
  model.learn(bit);
  return bit;
}

bool Bit_decoder::get() { return get(half); }

} // namespace CGAL::Geodesic_processing::internal
