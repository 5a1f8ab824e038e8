// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/arithmetic_coding.h"

#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr std::uint32_t even_probability = 1u << 15;
constexpr std::uint16_t window_size = 60; // number of bits of the running mean

// Returns the last number of the lower part of the interval. Both parts are nonempty.
std::uint32_t split_interval(std::uint32_t low, std::uint32_t high, std::uint32_t probability)
{
  return low + std::uint32_t((std::uint64_t(high - low) * probability) >> 16);
}

bool have_equal_top_byte(std::uint32_t low, std::uint32_t high)
{
  return ((low ^ high) >> 24) == 0;
}

} // namespace

void Bit_model::update(bool bit)
{
  constexpr int min_probability = 64, max_probability = 65536 - 64;
  const int target = bit ? max_probability : min_probability;
  probability = std::uint16_t(probability + (target - int(probability)) / (number_of_bits + 2));
  if(number_of_bits < window_size)
    ++number_of_bits;
}

void Bit_encoder::put(bool bit, std::uint32_t probability)
{
  const std::uint32_t split = split_interval(m_low, m_high, probability);
  (bit ? m_high : m_low) = bit ? split : split + 1;
  while(have_equal_top_byte(m_low, m_high))
  {
    m_bytes.push_back(std::uint8_t(m_high >> 24));
    m_low <<= 8;
    m_high = (m_high << 8) | 0xff;
  }
}

void Bit_encoder::put(bool bit, Bit_model& model)
{
  put(bit, std::uint32_t(model.probability));
  model.update(bit);
}

void Bit_encoder::put(bool bit) { put(bit, even_probability); }

std::vector<std::uint8_t> Bit_encoder::finish()
{
  // The first bytes of both bounds differ, so this byte followed by zeros lies in the interval.
  m_bytes.push_back(std::uint8_t((m_low >> 24) + 1));
  return std::move(m_bytes);
}

Bit_decoder::Bit_decoder(const std::uint8_t* bytes, std::size_t size, bool is_complete)
    : m_next(bytes), m_end(bytes + size), m_is_complete(is_complete)
{
  for(int i = 0; i < 4; ++i)
    read_byte();
}

void Bit_decoder::read_byte()
{
  const bool has_byte = m_next != m_end;
  const std::uint32_t byte = has_byte ? *m_next++ : 0;
  m_min_code = (m_min_code << 8) | byte;
  m_max_code = (m_max_code << 8) | (has_byte || m_is_complete ? byte : 0xff);
}

bool Bit_decoder::get(std::uint32_t probability)
{
  const std::uint32_t split = split_interval(m_low, m_high, probability);
  const bool bit = m_min_code <= split;
  if(m_is_exhausted || bit != (m_max_code <= split))
  {
    m_is_exhausted = true;
    return false;
  }
  (bit ? m_high : m_low) = bit ? split : split + 1;
  while(have_equal_top_byte(m_low, m_high))
  {
    read_byte();
    m_low <<= 8;
    m_high = (m_high << 8) | 0xff;
  }
  return bit;
}

bool Bit_decoder::get(Bit_model& model)
{
  const bool bit = get(std::uint32_t(model.probability));
  model.update(bit);
  return bit;
}

bool Bit_decoder::get() { return get(even_probability); }

} // namespace CGAL::Geodesic_processing::internal
