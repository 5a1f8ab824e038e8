// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_SCANNER_H
#define GEODESIC_PROGRAM_IO_SCANNER_H

#include "io/errors.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace program {

// Walks over text line by line and over the words of a line; knows where it is.
class Scanner
{
public:
  // comment_mark: what follows it on a line is skipped; 0 where the format has no comments.
  Scanner(std::string_view bytes, std::string name, char comment_mark)
      : m_rest(bytes), m_name(std::move(name)), m_comment_mark(comment_mark)
  {}

  // Goes to the next line that holds a word; false at the end of the text.
  // Lines end with a line feed, a carriage return, or both.
  bool next_line();

  // The next word of the line, empty at its end.  Blanks and tabs separate words, and commas and
  // semicolons where `commas` is set.
  std::string_view word();
  bool splits_at_commas = false;

  // The next word anywhere, empty at the end of the text.
  std::string_view next_word();

  std::string_view rest_of_line() const { return m_line; }
  bool is_line_empty();

  // Throws Input_error: "NAME, line N: REASON."
  [[noreturn]] void fail(const std::string& reason) const;

  double parse_number(std::string_view word) const;     // fails when it is not a number
  double parse_coordinate(std::string_view word) const; // fails when it is not finite either
  long long parse_integer(std::string_view word) const; // fails when it is not an integer

private:
  void skip_separators();

  std::string_view m_rest;
  std::string_view m_line;
  std::string m_name;
  char m_comment_mark;
  std::size_t m_number = 0;
};

// The whole of `word` as a number, locale or not; accepts nan and inf, a leading +, and numbers
// beyond the range of double, which become 0 or inf.
std::optional<double> to_number(std::string_view word);
std::optional<long long> to_integer(std::string_view word);

[[noreturn]] void fail(const std::string& name, const std::string& reason);

// At most 30 printable characters of a word, for sentences.
std::string printable(std::string_view word);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_SCANNER_H
