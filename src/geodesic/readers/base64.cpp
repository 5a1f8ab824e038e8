// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/base64.h"

#include <cstdint>

namespace program {

namespace {

constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

} // namespace

std::string to_base64(std::string_view bytes)
{
  std::string text;
  text.reserve(base64_length(bytes.size()));
  for(std::size_t i = 0; i < bytes.size(); i += 3)
  {
    std::uint32_t group = 0;
    for(std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for(std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

std::optional<std::string> from_base64(std::string_view text)
{
  std::string bytes;
  std::uint32_t group = 0;
  unsigned count = 0, padding = 0;
  for(const char c : text)
  {
    if(c == ' ' || c == '\n' || c == '\r' || c == '\t')
      continue;
    const std::size_t digit = digits.find(c);
    if(c == '=')
      ++padding;
    else if(digit == std::string_view::npos || padding != 0)
      return std::nullopt;
    group = group << 6 | (c == '=' ? 0u : static_cast<std::uint32_t>(digit));
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
