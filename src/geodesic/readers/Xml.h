// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_XML_H
#define GEODESIC_PROGRAM_READERS_XML_H

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace program {

struct Tag
{
  std::string_view name; // with a slash if it is a closing tag
  std::map<std::string_view, std::string_view> attributes;
  bool is_self_closing = false; // <Tag/>

  // Returns the value of an attribute, or an empty text if the tag has none of this name.
  std::string_view operator[](std::string_view attribute) const;
};

// A parser for the subset of XML in VTP and GIFTI files: tags with quoted attributes, and text
// between them. Comments, declarations and CDATA sections are skipped.
class Xml
{
public:
  Xml(std::string_view bytes, std::string name) : m_rest(bytes), m_name(std::move(name)) {}

  // Returns the next tag, or std::nullopt at the end. text() returns the text before the tag.
  // Throws Input_error.
  std::optional<Tag> next();

  std::string_view text() const { return m_text; }
  std::string_view rest() const { return m_rest; }

private:
  Tag tag(std::string_view content);

  std::string_view m_rest;
  std::string_view m_text;
  std::string m_name;
};

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_XML_H
