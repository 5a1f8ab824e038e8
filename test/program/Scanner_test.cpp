// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/count_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace Scanner_test {

using program::Scanner;

// The words of a line, and its number.
struct Line
{
  std::size_t number;
  std::vector<std::string> words;
};

bool operator==(const Line& l, const Line& m) { return l.number == m.number && l.words == m.words; }

// Returns the lines that contain words, found character by character.
std::vector<Line> expected_lines(const std::string& text, char comment_mark, bool has_commas)
{
  std::vector<Line> result;
  std::size_t number = 0;
  for(std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    std::string line = text.substr(begin, end - begin);
    begin = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
    ++number;
    if(comment_mark != 0)
      line = line.substr(0, line.find(comment_mark));
    std::vector<std::string> words(1);
    for(const char c : line)
      if(std::string(has_commas ? " \t\v\f,;" : " \t\v\f").find(c) != std::string::npos)
        words.emplace_back();
      else
        words.back() += c;
    words.erase(std::remove(words.begin(), words.end(), ""), words.end());
    if(!words.empty())
      result.push_back({number, words});
  }
  return result;
}

std::size_t line_number(const Scanner& scanner)
{
  try
  {
    scanner.fail("");
  }
  catch(const program::Input_error& error)
  {
    return std::stoul(std::string(error.what()).substr(std::string("name, line ").size()));
  }
}

// Text in a buffer without a byte behind it, so that a sanitizer finds reads behind the end
std::vector<char> exact_buffer(const std::string& text) { return {text.begin(), text.end()}; }

TEST(Scanner, words_and_line_numbers_equal_those_of_a_simple_splitter)
{
  std::mt19937 random(1);
  const std::string characters = "\n\r\n ,;#\t12.-ex\n ";
  for(int i = 0; i < 20000; ++i)
  {
    std::string text;
    for(unsigned size = random() % 60; size > 0; --size)
      text += characters[random() % characters.size()];
    const std::vector<char> bytes = exact_buffer(text);
    const char comment_mark = i % 2 == 0 ? '#' : '\0';
    const bool has_commas = i % 3 == 0;
    Scanner scanner({bytes.data(), bytes.size()}, "name", comment_mark,
                    has_commas ? Scanner::Separators::blanks_and_commas
                               : Scanner::Separators::blanks);
    std::vector<Line> lines;
    while(scanner.next_line())
    {
      lines.push_back({line_number(scanner), {}});
      while(!scanner.is_line_empty())
        lines.back().words.emplace_back(scanner.word());
    }
    ASSERT_TRUE(lines == expected_lines(text, comment_mark, has_commas)) << text;
    ASSERT_FALSE(scanner.next_line());
    ASSERT_EQ(scanner.next_word(), "");
  }
}

TEST(Scanner, skips_only_lines_without_the_character)
{
  std::mt19937 random(1);
  const std::string characters = "\n\r\n \t12.-ex\n ";
  int number_of_skipped = 0, number_of_read = 0;
  for(int i = 0; i < 20000; ++i)
  {
    std::string text;
    for(unsigned size = random() % 200; size > 0; --size)
      text += characters[random() % (i % 2 == 0 ? 14 : 4)];
    const std::vector<char> bytes = exact_buffer(text);
    Scanner scanner({bytes.data(), bytes.size()}, "name", 0);
    for(const Line& line : expected_lines(text, 0, false))
    {
      ASSERT_TRUE(scanner.next_line()) << text;
      ASSERT_EQ(line_number(scanner), line.number) << text;
      std::size_t first = 0;
      if(random() % 2 == 0)
      {
        EXPECT_EQ(scanner.word(), line.words[first++]);
      }
      scanner.skip_line_without('x');
      std::vector<std::string> words;
      while(!scanner.is_line_empty())
        words.emplace_back(scanner.word());
      const std::vector<std::string> expected(line.words.begin() + first, line.words.end());
      if(words == expected)
      {
        ++number_of_read;
        continue;
      }
      ASSERT_TRUE(words.empty()) << text;
      ++number_of_skipped;
      for(const std::string& word : expected)
        ASSERT_EQ(word.find('x'), std::string::npos) << text;
    }
    ASSERT_FALSE(scanner.next_line());
  }
  EXPECT_GT(number_of_skipped, 1000);
  EXPECT_GT(number_of_read, 1000);
}

TEST(Scanner, takes_only_whole_words_as_numbers)
{
  const std::vector<char> bytes = exact_buffer("12 -3.5e1,7x 1/2 nan\n 4 5");
  Scanner scanner({bytes.data(), bytes.size()}, "name", 0, Scanner::Separators::blanks_and_commas);
  long long integer = 0;
  double number = 0.;
  EXPECT_FALSE(scanner.take_plain_number(number)); // No line has begun.
  ASSERT_TRUE(scanner.next_line());
  EXPECT_TRUE(scanner.take_plain_integer(integer));
  EXPECT_EQ(integer, 12);
  EXPECT_FALSE(scanner.take_plain_integer(integer));
  EXPECT_TRUE(scanner.take_plain_number(number));
  EXPECT_EQ(number, -35.);
  EXPECT_FALSE(scanner.take_plain_number(number));
  EXPECT_EQ(scanner.word(), "7x");
  EXPECT_FALSE(scanner.take_plain_integer(integer));
  EXPECT_EQ(scanner.word(), "1/2");
  EXPECT_TRUE(scanner.starts_with(" nan"));
  EXPECT_FALSE(scanner.starts_with(" nan 4"));
  EXPECT_TRUE(std::isnan(scanner.number()));
  EXPECT_TRUE(scanner.is_line_empty());
  EXPECT_THROW(scanner.number(), program::Input_error);
  ASSERT_TRUE(scanner.next_line());
  EXPECT_EQ(scanner.coordinate(), 4.);
  EXPECT_EQ(scanner.integer(), 5);
  EXPECT_FALSE(scanner.next_line());
}

TEST(Count_lines, bounds_the_number_of_lines)
{
  std::string text;
  for(int i = 0; i < 300; ++i)
    text += "v 1\nf 1 2 3\n";
  EXPECT_EQ(program::max_number_of_lines(text, 1), 600u);
  EXPECT_EQ(program::max_number_of_lines(text, 1, 'v'), 300u);
  EXPECT_EQ(program::max_number_of_lines(text, 1, 'f'), 301u);
  EXPECT_EQ(program::max_number_of_lines(text, 8), text.size() / 8 + 1);
  EXPECT_EQ(program::max_number_of_lines("", 1), 1u);
}

} // namespace Scanner_test
