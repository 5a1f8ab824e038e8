// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/plain_numbers.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <random>
#include <string>

namespace plain_numbers_test {

// Returns the value of a whole word, or nothing if it is left to the general parser.
template <typename Value>
std::optional<Value> parse(const char* (*parser)(const char*, Value&), const std::string& word)
{
  const std::string padded = word + '\n' + std::string(program::padding_of_numbers, '7');
  Value value;
  const char* const end = parser(padded.data(), value);
  return end == padded.data() + word.size() ? std::optional<Value>(value) : std::nullopt;
}

std::optional<double> plain_number(const std::string& word)
{
  return parse(program::parse_plain_number, word);
}

std::optional<long long> plain_integer(const std::string& word)
{
  return parse(program::parse_plain_integer, word);
}

// Returns a random word: mostly a decimal number, sometimes with a character too many.
std::string random_word(std::mt19937& random)
{
  const auto digits = [&](unsigned max_count)
  {
    std::string text;
    for(unsigned i = random() % (max_count + 1); i > 0; --i)
      text += static_cast<char>('0' + random() % 10);
    return text;
  };
  std::string word = random() % 3 == 0 ? "-" : "";
  word += digits(random() % 4 == 0 ? 22 : 8);
  if(random() % 4 != 0)
    word += "." + digits(random() % 4 == 0 ? 22 : 8);
  if(random() % 3 == 0)
    word += std::string(random() % 2 == 0 ? "e" : "E") +
            (random() % 3 == 0   ? "-"
             : random() % 2 == 0 ? "+"
                                 : "") +
            digits(3);
  if(random() % 20 == 0)
    word += "x";
  return word;
}

TEST(Plain_numbers, AgreeWithTheStandardLibrary)
{
  std::mt19937 random(1);
  int number_of_plain_numbers = 0;
  for(int i = 0; i < 200000; ++i)
  {
    const std::string word = random_word(random);
    const std::optional<double> value = plain_number(word);
    if(!value)
      continue;
    ++number_of_plain_numbers;
    char* end = nullptr;
    const double expected = std::strtod(word.c_str(), &end);
    ASSERT_EQ(*end, '\0') << word;
    ASSERT_EQ(*value, expected) << word;
    ASSERT_EQ(std::signbit(*value), std::signbit(expected)) << word;
  }
  EXPECT_GT(number_of_plain_numbers, 10000); // otherwise hardly any number is compared
}

TEST(Plain_numbers, ShortestFormsOfDoublesAreReadBack)
{
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> exponent(-4., 9.);
  int number_of_plain_numbers = 0;
  for(int i = 0; i < 200000; ++i)
  {
    const double expected = std::pow(10., exponent(random));
    char word[32];
    *std::to_chars(word, word + sizeof word - 1, expected).ptr = '\0';
    const std::optional<double> value = plain_number(word);
    number_of_plain_numbers += value.has_value() ? 1 : 0;
    ASSERT_EQ(value.value_or(expected), expected) << word;
  }
  if(std::numeric_limits<long double>::digits == 64)
  {
    EXPECT_GT(number_of_plain_numbers, 190000);
  }
}

// Exactly between two doubles, and close to it
TEST(Plain_numbers, TiesAreRoundedCorrectly)
{
  for(const char* word :
      {"9007199254740993", "9007199254740995", "900719925474099.3", "900719925474099.25",
       "900719925474099.3125", "4503599627370497.5", "4503599627370497.499", "4503599627370498.5",
       "4503599627370498.501", "18014398509481985", "18014398509481986", "18014398509481987",
       "1.000000000000000111", "1.00000000000000011", "9223372036854775807e3"})
    if(const std::optional<double> value = plain_number(word))
    {
      EXPECT_EQ(*value, std::strtod(word, nullptr)) << word;
    }
}

TEST(Plain_numbers, WordsThatAreNoNumbersAreLeftToTheGeneralParser)
{
  for(const char* word : {"",      "-",
                          ".",     "-.",
                          "e5",    "1e",
                          "1e+",   "+1",
                          "1 ",    " 1",
                          "1x",    "0x1",
                          "nan",   "inf",
                          "--1",   "1.2.3",
                          "1e5.0", "12345678901234567890",
                          "1e23",  "9007199254740993"})
    EXPECT_FALSE(plain_number(word).has_value()) << word;
  for(const char* word : {"", "-1", "+1", "1.", "1x", " 1", "1234567890123456789"})
    EXPECT_FALSE(plain_integer(word).has_value()) << word;
}

TEST(Plain_numbers, LimitsOfTheExactRangeAreRead)
{
  EXPECT_EQ(plain_number("9007199254740992"), 9007199254740992.); // 2^53
  EXPECT_EQ(plain_number("1e22"), 1e22);
  EXPECT_EQ(plain_number("1e-22"), 1e-22);
  EXPECT_EQ(plain_number("5."), 5.);
  EXPECT_EQ(plain_number(".5"), .5);
  EXPECT_EQ(plain_number("00000000000000000000012.5"), 12.5); // zeros before 19 digits
  EXPECT_EQ(plain_number("0.0000000000000000000001"), 1e-22);
  EXPECT_EQ(plain_integer("999999999999999999"), 999999999999999999ll);
}

} // namespace plain_numbers_test
