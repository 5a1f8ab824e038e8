// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_BINARY_NUMBERS_H
#define GEODESIC_PROGRAM_READERS_BINARY_NUMBERS_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace program {

struct Number_type
{
  char kind;        // i: signed integer, u: unsigned integer, f: floating point
  std::size_t size; // bytes
};

// Returns the first `size` bytes as an integer. They must exist.
inline std::uint64_t bits_at(std::string_view bytes, std::size_t size, bool big_endian)
{
  std::uint64_t bits = 0;
  for(std::size_t i = 0; i < size; ++i)
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[i])}
            << (8 * (big_endian ? size - 1 - i : i));
  return bits;
}

// Returns the value that the lowest 8 * type.size bits represent.
inline double to_value(std::uint64_t bits, Number_type type)
{
  if(type.kind == 'u')
    return static_cast<double>(bits);
  if(type.kind == 'i')
  {
    const unsigned unused = static_cast<unsigned>(64 - 8 * type.size);
    return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
  }
  if(type.size == 4)
  {
    const auto single_bits = static_cast<std::uint32_t>(bits);
    float single;
    std::memcpy(&single, &single_bits, sizeof single);
    return single;
  }
  double result;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_BINARY_NUMBERS_H
