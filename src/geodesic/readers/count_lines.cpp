// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/count_lines.h"

#include <algorithm>

namespace program {

namespace {

// Counts the positions of a text that satisfy a condition, except the last one. The counters of a
// block have one byte, so that the compiler adds 16 at a time.
template <typename Condition>
std::size_t count_positions(std::string_view text, Condition condition)
{
  constexpr std::size_t block_size = 240; // at most 255
  std::size_t result = 0;
  for(std::size_t begin = 0; begin + 1 < text.size(); begin += block_size)
  {
    const char* const block = text.data() + begin;
    const std::size_t size = std::min(block_size, text.size() - 1 - begin);
    unsigned char count = 0;
    for(std::size_t i = 0; i < size; ++i)
      count = static_cast<unsigned char>(count + condition(block + i));
    result += count;
  }
  return result;
}

} // namespace

std::size_t number_of_lines(std::string_view text)
{
  return count_positions(text, [](const char* c) { return *c == '\n'; }) + 1;
}

std::size_t max_number_of_lines(std::string_view text, std::size_t min_size)
{
  return std::min(number_of_lines(text), text.size() / min_size + 1);
}

std::size_t max_number_of_lines(std::string_view text, std::size_t min_size, char first)
{
  const std::size_t begins =
      count_positions(text, [first](const char* c) { return (c[0] == '\n') & (c[1] == first); });
  return std::min(begins, text.size() / min_size) + 1;
}

} // namespace program
