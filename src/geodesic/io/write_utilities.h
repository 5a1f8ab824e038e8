// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_WRITE_UTILITIES_H
#define GEODESIC_PROGRAM_IO_WRITE_UTILITIES_H

#include "io/Output_file.h"
#include "readers/Surface_file.h"

#include <charconv>
#include <cstring>

namespace program {

// Appends the bytes of a value in little-endian order.
template <typename Value>
void append_little_endian(std::string& bytes, Value value)
{
  static_assert(sizeof(Value) <= sizeof(std::uint64_t));
  std::uint64_t bits = 0;
  if constexpr(std::is_floating_point_v<Value>)
  {
    static_assert(sizeof(Value) == sizeof bits);
    std::memcpy(&bits, &value, sizeof value);
  }
  else
    bits = static_cast<std::uint64_t>(value);
  char buffer[sizeof(Value)];
  for(std::size_t i = 0; i < sizeof(Value); ++i)
    buffer[i] = static_cast<char>(bits >> (8 * i) & 255u);
  bytes.append(buffer, sizeof buffer);
}

inline void append_index(std::string& text, std::size_t index)
{
  char buffer[20];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, index).ptr);
}

template <std::size_t N>
void append_numbers(std::string& text, const std::array<double, N>& numbers)
{
  for(const double x : numbers)
  {
    text += ' ';
    append_number(text, x);
  }
}

// Converts the name of a property to a single word.
inline std::string to_identifier(std::string name)
{
  for(char& c : name)
    if(c <= ' ' || c > '~' || c == '"' || c == '<' || c == '>' || c == '&' || c == '\'')
      c = '_';
  return name.empty() ? "_" : name;
}

} // namespace program

#endif // GEODESIC_PROGRAM_IO_WRITE_UTILITIES_H
