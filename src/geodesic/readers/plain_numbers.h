// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_PLAIN_NUMBERS_H
#define GEODESIC_PROGRAM_READERS_PLAIN_NUMBERS_H

#include "readers/binary_numbers.h"

#include <limits>

namespace program {

// The functions of this file read up to 8 bytes behind the word that they parse. These bytes must
// exist.
constexpr std::size_t padding_of_numbers = 8;

// A sequence of decimal digits, as a number modulo 2^64.
struct Digits
{
  std::uint64_t value = 0;
  const char* end; // of the digits
};

// Appends the digits that begin at digits.end, 8 at a time.
inline void append_digits(Digits& digits)
{
  static constexpr std::uint64_t powers[] = {1,      10,      100,      1000,     10000,
                                             100000, 1000000, 10000000, 100000000};
  for(;;)
  {
    // Digits become bytes of at most 9. Adding 0x76 sets the highest bit of all other bytes.
    std::uint64_t bytes = bits_at({digits.end, 8}, 8, false) ^ 0x3030303030303030u;
    const std::uint64_t others = ((bytes + 0x7676767676767676u) | bytes) & 0x8080808080808080u;
    const int count = others == 0 ? 8 : __builtin_ctzll(others) / 8;
    if(count == 0)
      return;
    // Digits are moved behind leading zeros. Then digits, pairs and quadruples are joined.
    bytes <<= 8 * (8 - count);
    bytes = (bytes * (1 + (10 << 8))) >> 8 & 0x00ff00ff00ff00ffu;
    bytes = (bytes * (1 + (100 << 16))) >> 16 & 0x0000ffff0000ffffu;
    bytes = (bytes * (1 + (std::uint64_t{10000} << 32))) >> 32;
    digits.value = powers[count] * digits.value + bytes;
    digits.end += count;
    if(count < 8)
      return;
  }
}

// Computes the double that is nearest to an integer times a power of ten. Returns false if this
// needs more than one operation of exact numbers (Clinger 1990).
inline bool scale_by_power_of_ten(std::uint64_t integer, int power, double& value)
{
  static constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                      1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                      1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr int max_power = 22;
  if(power < -max_power || power > max_power)
    return false;
  if(integer <= std::uint64_t{1} << 53)
  {
    const double exact = static_cast<double>(integer);
    value = power < 0 ? exact / powers[-power] : exact * powers[power];
    return true;
  }
  // With 64 bits of precision, the integer is exact too. Rounding the result again to 53 bits is
  // wrong only if its last 11 bits are exactly one half.
  if constexpr(std::numeric_limits<long double>::digits == 64)
  {
    const long double exact = static_cast<long double>(integer);
    const long double scaled = power < 0 ? exact / powers[-power] : exact * powers[power];
    std::uint64_t mantissa;
    std::memcpy(&mantissa, &scaled, sizeof mantissa);
    value = static_cast<double>(scaled);
    return (mantissa & 0x7ff) != 0x400;
  }
  return false;
}

// Parses a word such as -12.5e-3, and returns the end of the number. Returns null if it is not a
// number, or if the nearest double is found by the general parser only.
inline const char* parse_plain_number(const char* word, double& value)
{
  constexpr std::ptrdiff_t max_digits = 19; // less than 2^64
  const bool is_negative = *word == '-';
  const char* const begin = word + (is_negative ? 1 : 0);
  Digits digits = {0, begin};
  append_digits(digits);
  std::ptrdiff_t count = digits.end - begin;
  std::ptrdiff_t power = 0;
  if(*digits.end == '.')
  {
    const char* const fraction = ++digits.end;
    append_digits(digits);
    power = fraction - digits.end;
    count -= power;
  }
  if(count == 0)
    return nullptr;
  for(const char* c = begin; count > max_digits && (*c == '0' || *c == '.'); ++c)
    count -= *c == '0' ? 1 : 0;
  if(count > max_digits)
    return nullptr;
  if(*digits.end == 'e' || *digits.end == 'E')
  {
    const bool is_small = digits.end[1] == '-', has_sign = is_small || digits.end[1] == '+';
    const char* const exponent_begin = digits.end + (has_sign ? 2 : 1);
    Digits exponent = {0, exponent_begin};
    append_digits(exponent);
    digits.end = exponent.end;
    if(exponent.end == exponent_begin || exponent.end > exponent_begin + 3)
      return nullptr;
    const auto size = static_cast<std::ptrdiff_t>(exponent.value);
    power += is_small ? -size : size;
  }
  if(!scale_by_power_of_ten(digits.value, static_cast<int>(power), value))
    return nullptr;
  if(is_negative)
    value = -value;
  return digits.end;
}

// Parses at most 18 digits, without a sign, and returns their end. Returns null if there are none
// or more.
inline const char* parse_plain_integer(const char* word, long long& value)
{
  constexpr std::ptrdiff_t max_digits = 18;
  Digits digits = {0, word};
  append_digits(digits);
  value = static_cast<long long>(digits.value);
  return digits.end == word || digits.end - word > max_digits ? nullptr : digits.end;
}

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_PLAIN_NUMBERS_H
