// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_PLAIN_NUMBERS_H
#define GEODESIC_PROGRAM_READERS_PLAIN_NUMBERS_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace program {

// The decimal digits at the begin of a word, as a number.
struct Digits
{
  std::uint64_t value = 0;
  std::size_t count = 0; // of digits; the value is exact up to 19
};

// Reads digits from `position` on and moves it behind them.
inline void read_digits(std::string_view word, std::size_t& position, Digits& digits)
{
  for(; position < word.size() && word[position] >= '0' && word[position] <= '9'; ++position)
  {
    digits.value = 10 * digits.value + static_cast<std::uint64_t>(word[position] - '0');
    ++digits.count;
  }
}

// Converts a word such as -12.5e-3 if one division or multiplication of exact numbers yields the
// nearest double (Clinger 1990): if its digits are an integer of at most 2^53 and the power of ten
// is at most 10^22. Otherwise returns nothing, also for words that are no numbers.
inline std::optional<double> plain_number(std::string_view word)
{
  constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                               1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                               1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr int max_power = 22;
  constexpr std::size_t max_digits = 19;
  std::size_t position = !word.empty() && word[0] == '-' ? 1 : 0;
  const bool is_negative = position == 1;
  Digits digits;
  read_digits(word, position, digits);
  int power = 0;
  if(position < word.size() && word[position] == '.')
  {
    const std::size_t number_of_integer_digits = digits.count;
    read_digits(word, ++position, digits);
    if(digits.count > max_digits)
      return std::nullopt;
    power = -static_cast<int>(digits.count - number_of_integer_digits);
  }
  if(digits.count == 0 || digits.count > max_digits || digits.value > std::uint64_t{1} << 53)
    return std::nullopt;
  if(position < word.size() && (word[position] == 'e' || word[position] == 'E'))
  {
    ++position;
    const bool has_sign =
        position < word.size() && (word[position] == '-' || word[position] == '+');
    const bool is_small = has_sign && word[position] == '-';
    position += has_sign ? 1 : 0;
    Digits exponent;
    read_digits(word, position, exponent);
    if(exponent.count == 0 || exponent.count > 3)
      return std::nullopt;
    power += is_small ? -static_cast<int>(exponent.value) : static_cast<int>(exponent.value);
  }
  if(position != word.size() || power < -max_power || power > max_power)
    return std::nullopt;
  const double integer = static_cast<double>(digits.value);
  const double value = power < 0 ? integer / powers[-power] : integer * powers[power];
  return is_negative ? -value : value;
}

// Converts a word of at most 18 digits, without a sign. Otherwise returns nothing.
inline std::optional<long long> plain_integer(std::string_view word)
{
  Digits digits;
  std::size_t position = 0;
  read_digits(word, position, digits);
  if(position != word.size() || digits.count == 0 || digits.count > 18)
    return std::nullopt;
  return static_cast<long long>(digits.value);
}

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_PLAIN_NUMBERS_H
