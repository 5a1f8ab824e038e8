// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace program {

namespace {

constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::uint8_t no_digit = 64;

// Returns the values of all characters.
constexpr std::array<std::uint8_t, 256> values_of_digits()
{
  std::array<std::uint8_t, 256> values{};
  for(std::uint8_t& value : values)
    value = no_digit;
  for(std::size_t i = 0; i < digits.size(); ++i)
    values[static_cast<unsigned char>(digits[i])] = static_cast<std::uint8_t>(i);
  return values;
}

} // namespace

std::string to_base64(std::string_view bytes)
{
  std::string text(base64_length(bytes.size()), '=');
  char* digit = text.data();
  while(!bytes.empty())
  {
    const std::size_t size = std::min<std::size_t>(bytes.size(), 3);
    std::uint32_t group = 0;
    for(std::size_t k = 0; k < size; ++k)
      group |= std::uint32_t{static_cast<unsigned char>(bytes[k])} << (16 - 8 * k);
    for(std::size_t k = 0; k < size + 1; ++k)
      digit[k] = digits[group >> (18 - 6 * k) & 63u];
    digit += 4;
    bytes.remove_prefix(size);
  }
  return text;
}

std::optional<std::string> from_base64(std::string_view text)
{
  static constexpr std::array<std::uint8_t, 256> values = values_of_digits();
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t group = 0;
  unsigned count = 0, padding = 0;
  for(const char c : text)
  {
    if(c == ' ' || c == '\n' || c == '\r' || c == '\t')
      continue;
    const std::uint8_t digit = values[static_cast<unsigned char>(c)];
    if(c == '=')
      ++padding;
    else if(digit == no_digit || padding != 0)
      return std::nullopt;
    group = group << 6 | (c == '=' ? 0u : std::uint32_t{digit});
    if(++count == 4)
    {
      if(padding > 2)
        return std::nullopt;
      for(unsigned k = 0; k < 3 - padding; ++k)
        bytes += static_cast<char>(group >> (16 - 8 * k) & 255u);
      group = count = padding = 0;
    }
  }
  if(count != 0)
    return std::nullopt;
  return bytes;
}

} // namespace program
