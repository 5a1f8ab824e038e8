// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace program {

namespace {

// Returns the number of bytes before the lines that are copied.
std::size_t begin_of_last_lines(std::string_view text)
{
  if(text.size() < padding_of_numbers)
    return 0;
  const std::size_t line_end = text.rfind('\n', text.size() - padding_of_numbers);
  return line_end == std::string_view::npos ? 0 : line_end + 1;
}

} // namespace

Scanner::Scanner(std::string_view text, std::string name, char comment_mark, Separators separators)
    : m_begin(text.data()), m_last_lines(text.substr(begin_of_last_lines(text))),
      m_name(std::move(name))
{
  for(const char c : {' ', '\t', '\v', '\f'})
    kind(c) = Character::separator;
  if(separators == Separators::blanks_and_commas)
    kind(',') = kind(';') = Character::separator;
  for(const char c : {'\n', '\r'})
    kind(c) = Character::line_end;
  if(comment_mark != 0)
    kind(comment_mark) = Character::line_end;
  m_end = m_begin + text.size() - m_last_lines.size();
  m_last_lines += '\n';
  m_last_lines.append(padding_of_numbers, '\0');
  // No line has begun.
  m_position = &m_last_lines[m_last_lines.size() - padding_of_numbers - 1];
}

// Advances to the end of the line and behind it, unless it is the end of all lines.
void Scanner::skip_line()
{
  while(*m_position != '\n' && *m_position != '\r')
    ++m_position;
  if(m_position == m_end)
    return;
  const bool has_two_characters =
      m_position[0] == '\r' && m_position + 1 != m_end && m_position[1] == '\n';
  m_position += has_two_characters ? 2 : 1;
}

// Continues with the lines that are copied. Returns false if there are none, or if they are at
// their end.
bool Scanner::enter_last_lines()
{
  const char* const end = &m_last_lines[m_last_lines.size() - padding_of_numbers - 1];
  const bool is_entered = m_end == end;
  if(!is_entered)
    m_position = m_last_lines.data();
  m_end = end;
  return !is_entered && m_position != m_end;
}

bool Scanner::next_line()
{
  do
  {
    if(m_number == 0)
      m_position = m_begin;
    else
      skip_line();
    if(m_position == m_end && !enter_last_lines())
    {
      m_begin = m_position = m_end;
      return false;
    }
    ++m_number;
  } while(is_line_empty());
  return true;
}

bool Scanner::starts_with(std::string_view prefix) const
{
  return std::equal(prefix.begin(), prefix.end(), m_position);
}

std::string_view Scanner::word()
{
  skip_separators();
  const char* const begin = m_position;
  while(kind(*m_position) == Character::of_word)
    ++m_position;
  return {begin, static_cast<std::size_t>(m_position - begin)};
}

void Scanner::skip_line_without(char c)
{
  // Longer lines are rare, and a file without line feeds would be searched to its end.
  constexpr std::size_t max_size = 128;
  const std::string_view rest(m_position,
                              std::min(max_size, static_cast<std::size_t>(m_end - m_position)));
  const std::string_view line = rest.substr(0, rest.find('\n'));
  if(line.size() < rest.size() && line.find(c) == std::string_view::npos)
    m_position += std::min(line.size(), line.find('\r'));
}

std::string_view Scanner::next_word()
{
  while(is_line_empty())
    if(!next_line())
      return {};
  return word();
}

void Scanner::fail(const std::string& reason) const
{
  program::fail(m_name, "line " + std::to_string(m_number) + ": " + reason);
}

double Scanner::parse_number(std::string_view word) const
{
  if(word.empty())
    fail("a number is missing");
  const std::optional<double> value = to_number(word);
  if(!value)
    fail("'" + printable(word) + "' is not a number");
  return *value;
}

double Scanner::parse_coordinate(std::string_view word) const
{
  const double value = parse_number(word);
  if(!std::isfinite(value))
    fail("the coordinate '" + printable(word) + "' is not finite");
  return value;
}

long long Scanner::parse_integer(std::string_view word) const
{
  if(word.empty())
    fail("an integer is missing");
  const std::optional<long long> value = to_integer(word);
  if(!value)
    fail("'" + printable(word) + "' is not an integer");
  return *value;
}

std::optional<double> to_number(std::string_view word)
{
  if(word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
#ifdef __cpp_lib_to_chars
  double value = 0.;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if(word.empty() || stop != end || error == std::errc::invalid_argument)
    return std::nullopt;
  // std::from_chars does not distinguish overflow from underflow.
  if(error == std::errc::result_out_of_range)
    value = std::strtod(std::string(word).c_str(), nullptr);
  return value;
#else
  // Some standard libraries lack std::from_chars for floating-point numbers. std::strtod also
  // accepts hexadecimal numbers, spaces and a positive sign.
  const std::string text(word);
  if(text.empty() || text[0] == '+' || text.find_first_of("xX \t\n\v\f\r") != std::string::npos)
    return std::nullopt;
  char* stop = nullptr;
  const double value = std::strtod(text.c_str(), &stop);
  return stop == text.c_str() + text.size() ? std::optional<double>(value) : std::nullopt;
#endif
}

std::optional<long long> to_integer(std::string_view word)
{
  if(word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  long long value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if(word.empty() || stop != end || error != std::errc())
    return std::nullopt;
  return value;
}

void fail(const std::string& name, const std::string& reason)
{
  throw Input_error(name + ": " + reason + ".");
}

std::string printable(std::string_view word)
{
  std::string result;
  for(const char c : word.substr(0, 30))
    result += c >= ' ' && c <= '~' ? c : '?';
  return word.size() > 30 ? result + "..." : result;
}

} // namespace program
