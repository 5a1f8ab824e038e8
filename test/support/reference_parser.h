// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the declarations that Doxygen documents from headers in the format of clang-format.
#ifndef GEODESIC_PROCESSING_TEST_REFERENCE_PARSER_H
#define GEODESIC_PROCESSING_TEST_REFERENCE_PARSER_H

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <istream>
#include <string>
#include <vector>

namespace reference_test {

struct Declaration
{
  std::string documentation, text; // the text ends before the body
  std::string body;                // of a member function defined in its class
};

struct Class
{
  std::string documentation, name;
  std::vector<Declaration> members; // the public member functions
  std::vector<Declaration> data;    // the public data members
};

struct Header
{
  std::vector<Declaration> functions; // documented functions at the top level
  std::vector<Class> classes;         // documented classes at the top level
  bool has_citation = false;          // whether its documentation cites a publication
};

inline bool starts_with(const std::string& text, const std::string& prefix)
{
  return text.compare(0, prefix.size(), prefix) == 0;
}

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// Reads lines without directives and without the branches that Doxygen does not see.
inline std::vector<std::string> visible_lines(std::istream& in)
{
  std::vector<std::string> result;
  std::vector<bool> is_hidden; // of each open condition
  for(std::string line; std::getline(in, line);)
  {
    if(starts_with(line, "#if"))
      is_hidden.push_back(starts_with(line, "#ifndef DOXYGEN_RUNNING"));
    else if(starts_with(line, "#else"))
      is_hidden.back() = false; // no #else follows an #ifdef of Doxygen
    else if(starts_with(line, "#endif"))
      is_hidden.pop_back();
    else if(!starts_with(line, "#") &&
            std::find(is_hidden.begin(), is_hidden.end(), true) == is_hidden.end())
      result.push_back(line);
  }
  return result;
}

// Returns the end of a declaration: a semicolon, a brace or a colon outside of all brackets.
inline std::size_t end_of_declaration(const std::string& text)
{
  int depth = 0;
  for(std::size_t i = 0; i < text.size(); ++i)
  {
    const char c = text[i];
    depth += c == '(' || c == '<' ? 1 : c == ')' || c == '>' ? -1 : 0;
    if(depth == 0 && (c == ';' || c == '{' || (c == ':' && text.compare(i - 1, 3, " : ") == 0)))
      return i;
  }
  return std::string::npos;
}

// Joins lines from a position until the declaration ends, and moves the position to its last line.
inline std::string declaration_at(const std::vector<std::string>& lines, std::size_t& position)
{
  std::string text;
  for(;; ++position)
  {
    const std::string& line = lines[position];
    const std::string part = line.substr(std::min(line.size(), line.find_first_not_of(' ')));
    text += (text.empty() || text.back() == '(' ? "" : " ") + part;
    if(const std::size_t end = end_of_declaration(text); end != std::string::npos)
      return text.substr(0, end);
    if(position + 1 == lines.size())
      return text;
  }
}

// Returns the text after the template parameters of a declaration.
inline std::string without_template(const std::string& text)
{
  if(!starts_with(text, "template <"))
    return text;
  int depth = 0;
  for(std::size_t i = 0; i < text.size(); ++i)
  {
    depth += text[i] == '<' ? 1 : text[i] == '>' ? -1 : 0;
    if(text[i] == '>' && depth == 0)
      return text.substr(std::min(text.size(), i + 2));
  }
  return {};
}

inline bool is_type(const std::string& text)
{
  const std::vector<std::string> words = {"struct ", "class ",         "enum ",      "using ",
                                          "friend ", "static_assert(", "namespace ", "extern "};
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& word)
                     { return starts_with(without_template(text), word); });
}

// Returns whether a declaration has a bracket outside of template arguments and before any value.
inline bool is_function(const std::string& text)
{
  int depth = 0;
  if(contains(text, " operator"))
    return true;
  for(const char c : without_template(text))
  {
    depth += c == '<' ? 1 : c == '>' ? -1 : 0;
    if(depth == 0 && (c == '(' || c == '='))
      return c == '(' && !is_type(text);
  }
  return false;
}

// Reads the public members of a class whose body begins at a position.
inline void read_members(const std::vector<std::string>& lines, std::size_t& position,
                         bool is_public, Class& result)
{
  std::string documentation;
  bool is_omitted = false; // from the reference
  for(; position < lines.size() && !starts_with(lines[position], "};"); ++position)
  {
    const std::string& line = lines[position];
    if(contains(line, "public:") || contains(line, "private:") || contains(line, "protected:"))
      is_public = contains(line, "public:");
    if(contains(line, "/// \\cond INTERNAL"))
      is_omitted = true;
    if(contains(line, "/// \\endcond"))
      is_omitted = false;
    if(starts_with(line, "  ///") && !contains(line, "/// @{"))
    {
      documentation += line.substr(2) + '\n';
      continue;
    }
    if(line.size() > 2 && starts_with(line, "  ") &&
       (std::isalpha(static_cast<unsigned char>(line[2])) != 0 || line[2] == '~'))
    {
      Declaration member{documentation, declaration_at(lines, position), {}};
      if(const std::size_t comment = lines[position].find("///<"); comment != std::string::npos)
        member.documentation += lines[position].substr(comment);
      member.body = lines[position] + '\n';
      while(position + 1 < lines.size() &&
            (starts_with(lines[position + 1], "   ") || starts_with(lines[position + 1], "  {") ||
             starts_with(lines[position + 1], "  }")))
        member.body += lines[++position] + '\n';
      if(is_public && !is_omitted && is_function(member.text))
        result.members.push_back(std::move(member));
      else if(is_public && !is_omitted && !is_type(member.text))
        result.data.push_back(std::move(member));
    }
    documentation.clear();
  }
}

inline Header read_header(std::istream& in)
{
  Header result;
  const std::vector<std::string> lines = visible_lines(in);
  std::string documentation;
  bool is_internal = false;
  for(std::size_t i = 0; i < lines.size(); ++i)
  {
    const std::string& line = lines[i];
    if(line == "namespace internal {" || line == "} // namespace internal")
      is_internal = starts_with(line, "namespace");
    result.has_citation = result.has_citation || contains(line, "\\cgalCite{");
    if(starts_with(line, "///"))
    {
      documentation += line + '\n';
      continue;
    }
    if(!documentation.empty() && !is_internal && !line.empty())
    {
      const std::string text = declaration_at(lines, i), type = without_template(text);
      if(starts_with(type, "struct ") || starts_with(type, "class "))
      {
        const std::string name = type.substr(type.find(' ') + 1);
        Class found{documentation, name.substr(0, name.find(' ')), {}, {}};
        const std::size_t begin = i;
        if(!contains(lines[i], ";"))
          read_members(lines, ++i, starts_with(type, "struct "), found);
        result.classes.push_back(std::move(found));
        for(std::size_t k = begin; k < std::min(i, lines.size()); ++k)
          result.has_citation = result.has_citation || contains(lines[k], "\\cgalCite{");
      }
      else if(is_function(text))
        result.functions.push_back({documentation, text, {}});
    }
    documentation.clear();
  }
  return result;
}

} // namespace reference_test

#endif // GEODESIC_PROCESSING_TEST_REFERENCE_PARSER_H
