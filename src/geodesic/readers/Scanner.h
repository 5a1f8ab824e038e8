// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_SCANNER_H
#define GEODESIC_PROGRAM_READERS_SCANNER_H

#include "readers/Input_error.h"
#include "readers/plain_numbers.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace program {

// Iterates over the lines of a text and over the words of a line. Error messages contain the line
// number.
//
// No function compares its position with the end of the text: each line ends with a line feed. The
// last lines are copied, because they can lack it, and because numbers are parsed 8 bytes at a
// time.
class Scanner
{
public:
  enum class Separators
  {
    blanks,           // and tabs
    blanks_and_commas // and semicolons
  };

  // Keeps a view of the text. The rest of a line after comment_mark is skipped. If it is 0, the
  // format has no comments.
  Scanner(std::string_view text, std::string name, char comment_mark,
          Separators separators = Separators::blanks);
  Scanner(const Scanner&) = delete;
  Scanner& operator=(const Scanner&) = delete;

  // Advances to the next line that contains a word. Returns false at the end of the text. Lines
  // end with a line feed, a carriage return, or both.
  bool next_line();

  // Returns whether the line has no more words.
  bool is_line_empty()
  {
    skip_separators();
    return is_line_end(*m_position);
  }

  // Returns whether the rest of the line begins with a prefix, which contains no line end.
  bool starts_with(std::string_view prefix) const;

  // Returns the next word of the line, or an empty word at its end.
  std::string_view word();

  // Skips the rest of the line if it does not contain a character. May also do nothing. Faster than to
  // read the words of the line.
  void skip_line_without(char c);

  // Returns the next word of this or a later line, or an empty word at the end of the text.
  std::string_view next_word();

  // Advances behind the next word of the line and returns true if it is a number, or an integer
  // without sign, that is parsed fast. Otherwise, word() returns it.
  bool take_plain_number(double& value) { return take(parse_plain_number, value); }
  bool take_plain_integer(long long& value) { return take(parse_plain_integer, value); }

  // Returns the value of the next word of the line. Fails as the function that parses a word.
  double number()
  {
    double value;
    return take_plain_number(value) ? value : parse_number(word());
  }
  double coordinate()
  {
    double value;
    return take_plain_number(value) ? value : parse_coordinate(word());
  }
  long long integer()
  {
    long long value;
    return take_plain_integer(value) ? value : parse_integer(word());
  }

  // Returns the number of the line, from 1.
  std::size_t line_number() const { return m_number; }

  // Throws Input_error: "NAME, line N: REASON."
  [[noreturn]] void fail(const std::string& reason) const;

  double parse_number(std::string_view word) const;     // fails if it is not a number
  double parse_coordinate(std::string_view word) const; // fails if it is not finite
  long long parse_integer(std::string_view word) const; // fails if it is not an integer

private:
  enum class Character : unsigned char
  {
    of_word,
    separator,
    line_end // or comment mark
  };

  Character& kind(char c) { return m_kinds[static_cast<unsigned char>(c)]; }
  bool is_separator(char c) { return kind(c) == Character::separator; }
  bool is_line_end(char c) { return kind(c) == Character::line_end; }

  void skip_separators()
  {
    while(is_separator(*m_position))
      ++m_position;
  }

  template <typename Value>
  bool take(const char* (*parse)(const char*, Value&), Value& value)
  {
    skip_separators();
    const char* const end = parse(m_position, value);
    if(end == nullptr || kind(*end) == Character::of_word)
      return false;
    m_position = end;
    return true;
  }

  void skip_line();
  bool enter_last_lines();

  std::array<Character, 256> m_kinds{}; // of all characters
  const char* m_position;               // in the line
  const char* m_end;        // of the lines that are not copied, later of the copied lines
  const char* m_begin;      // of the text
  std::string m_last_lines; // and a line feed and padding
  std::size_t m_number = 0; // of the line
  std::string m_name;
};

// Converts the whole word to a number, independent of the locale. Accepts nan, inf and a leading
// +. Numbers that exceed the range of double become 0 or infinite.
std::optional<double> to_number(std::string_view word);
std::optional<long long> to_integer(std::string_view word);

[[noreturn]] void fail(const std::string& name, const std::string& reason);

// Returns at most 30 printable characters of a word, for error messages.
std::string printable(std::string_view word);

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_SCANNER_H
