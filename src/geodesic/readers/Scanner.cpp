// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"

#include "readers/plain_numbers.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace program {

namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

// Returns the position of the first character that satisfies a condition, or the
// size of the text. Faster than the search of std::string_view for one of several characters.
template <typename Condition>
std::size_t find_first(std::string_view text, Condition condition)
{
  const char *const begin = text.data(), *const end = begin + text.size();
  const char* c = begin;
  while(c != end && !condition(*c))
    ++c;
  return static_cast<std::size_t>(c - begin);
}

} // namespace

bool Scanner::is_separator(char c) const
{
  return c == ' ' || c == '\t' || c == '\v' || c == '\f' ||
         (splits_at_commas && (c == ',' || c == ';'));
}

bool Scanner::next_line()
{
  while(!m_rest.empty())
  {
    const std::size_t end = find_first(m_rest, is_line_end);
    m_line = m_rest.substr(0, end);
    if(end == m_rest.size())
      m_rest = {};
    else
      m_rest.remove_prefix(end + (m_rest.substr(end, 2) == "\r\n" ? 2 : 1));
    ++m_number;
    if(m_comment_mark != 0)
      m_line = m_line.substr(0, m_line.find(m_comment_mark));
    if(!is_line_empty())
      return true;
  }
  m_line = {};
  return false;
}

void Scanner::skip_separators()
{
  m_line.remove_prefix(find_first(m_line, [this](char c) { return !is_separator(c); }));
}

bool Scanner::is_line_empty()
{
  skip_separators();
  return m_line.empty();
}

std::string_view Scanner::word()
{
  skip_separators();
  const std::size_t end = find_first(m_line, [this](char c) { return is_separator(c); });
  const std::string_view result = m_line.substr(0, end);
  m_line.remove_prefix(result.size());
  return result;
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
  if(const std::optional<double> value = plain_number(word))
    return value;
  if(word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  double value = 0.;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if(word.empty() || stop != end || error == std::errc::invalid_argument)
    return std::nullopt;
  // std::from_chars does not distinguish overflow from underflow.
  if(error == std::errc::result_out_of_range)
    value = std::strtod(std::string(word).c_str(), nullptr);
  return value;
}

std::optional<long long> to_integer(std::string_view word)
{
  if(const std::optional<long long> value = plain_integer(word))
    return value;
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
