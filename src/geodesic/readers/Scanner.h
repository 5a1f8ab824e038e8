// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_SCANNER_H
#define GEODESIC_PROGRAM_READERS_SCANNER_H

#include "readers/Input_error.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace program {

// Iterates over the lines of a text and over the words of a line. Error messages contain the line
// number.
class Scanner
{
public:
  // The rest of a line after comment_mark is skipped. If it is 0, the format has no comments.
  Scanner(std::string_view bytes, std::string name, char comment_mark)
      : m_rest(bytes), m_name(std::move(name)), m_comment_mark(comment_mark)
  {}

  // Advances to the next line that contains a word. Returns false at the end of the text. Lines
  // end with a line feed, a carriage return, or both.
  bool next_line();

  // Returns the next word of the line, or an empty word at its end. Words are separated by blanks
  // and tabs and, if `splits_at_commas` is set, by commas and semicolons.
  std::string_view word();
  bool splits_at_commas = false;

  // Returns the next word of this or a later line, or an empty word at the end of the text.
  std::string_view next_word();

  std::string_view rest_of_line() const { return m_line; }
  bool is_line_empty();

  // Throws Input_error: "NAME, line N: REASON."
  [[noreturn]] void fail(const std::string& reason) const;

  double parse_number(std::string_view word) const;     // fails if it is not a number
  double parse_coordinate(std::string_view word) const; // fails if it is not finite
  long long parse_integer(std::string_view word) const; // fails if it is not an integer

private:
  bool is_separator(char c) const;
  void skip_separators();

  std::string_view m_rest;
  std::string_view m_line;
  std::string m_name;
  char m_comment_mark;
  std::size_t m_number = 0;
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
