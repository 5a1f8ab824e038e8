// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Xml.h"

#include "readers/Scanner.h"

#include <algorithm>

namespace program {

namespace {

constexpr std::string_view whitespace = " \t\r\n";

bool starts_with(std::string_view text, std::string_view prefix)
{
  return text.substr(0, prefix.size()) == prefix;
}

} // namespace

std::string_view Tag::operator[](std::string_view attribute) const
{
  const auto found = attributes.find(attribute);
  return found == attributes.end() ? std::string_view() : found->second;
}

std::optional<Tag> Xml::next()
{
  for(;;)
  {
    const std::size_t begin = m_rest.find('<');
    m_text = m_rest.substr(0, begin);
    if(begin == std::string_view::npos)
      return std::nullopt;
    m_rest.remove_prefix(begin);
    // Comments and CDATA sections can contain '>'.
    const std::string_view closing = starts_with(m_rest, "<!--")        ? "-->"
                                     : starts_with(m_rest, "<![CDATA[") ? "]]>"
                                                                        : ">";
    const std::size_t end = m_rest.find(closing);
    if(end == std::string_view::npos)
      fail(m_name, "a tag has no closing '>'");
    const std::string_view content = m_rest.substr(1, end - 1);
    m_rest.remove_prefix(end + closing.size());
    if(!content.empty() && content[0] != '?' && content[0] != '!')
      return tag(content);
  }
}

Tag Xml::tag(std::string_view content)
{
  Tag result;
  if(content.back() == '/' && content.size() > 1)
  {
    result.is_self_closing = true;
    content.remove_suffix(1);
  }
  const std::size_t end = content.find_first_of(whitespace);
  result.name = content.substr(0, end);
  while(end != std::string_view::npos)
  {
    const std::size_t equals = content.find('=');
    if(equals == std::string_view::npos)
      break;
    std::string_view key = content.substr(0, equals);
    key.remove_prefix(std::min(key.size(), key.find_last_of(whitespace, equals) + 1));
    content.remove_prefix(equals + 1);
    const char quote = content.empty() ? ' ' : content[0];
    const std::size_t close =
        quote == '"' || quote == '\'' ? content.find(quote, 1) : std::string_view::npos;
    if(close == std::string_view::npos)
      fail(m_name, "the value of an attribute is not quoted");
    result.attributes[key] = content.substr(1, close - 1);
    content.remove_prefix(close + 1);
  }
  return result;
}

} // namespace program
