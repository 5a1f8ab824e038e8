// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks that the reference of each public function is complete.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace reference_test {

// A documented declaration at the top level of a header.
struct Declaration
{
  std::string documentation, text; // the text ends before its body
};

bool starts_with(const std::string& text, const std::string& prefix)
{
  return text.compare(0, prefix.size(), prefix) == 0;
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

std::vector<Declaration> declarations_of(const std::filesystem::path& header)
{
  std::ifstream in(header);
  std::vector<Declaration> result;
  std::string documentation;
  bool is_internal = false;
  for(std::string line; std::getline(in, line);)
  {
    if(line == "namespace internal {" || line == "} // namespace internal")
      is_internal = starts_with(line, "namespace");
    if(starts_with(line, "///"))
    {
      documentation += line + '\n';
      continue;
    }
    if(!documentation.empty() && !is_internal && !line.empty())
    {
      std::string text = line;
      while(!contains(line, "{") && !contains(line, ";") && std::getline(in, line))
        text += (text.back() == '(' ? "" : " ") +
                line.substr(std::min(line.size(), line.find_first_not_of(' ')));
      result.push_back({documentation, text.substr(0, text.find_first_of("{;"))});
    }
    documentation.clear();
  }
  return result;
}

// Returns the identifiers that follow a word.
std::vector<std::string> identifiers_after(const std::string& word, const std::string& text)
{
  std::vector<std::string> result;
  for(std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i))
  {
    i += word.size();
    const auto end = std::find_if_not(
        text.begin() + std::ptrdiff_t(i), text.end(),
        [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; });
    result.emplace_back(text.begin() + std::ptrdiff_t(i), end);
  }
  return result;
}

// Splits a text at commas that are not in brackets.
std::vector<std::string> split_at_commas(const std::string& text)
{
  std::vector<std::string> result(1);
  int depth = 0;
  for(const char c : text)
  {
    depth += c == '<' || c == '(' ? 1 : c == '>' || c == ')' ? -1 : 0;
    if(c == ',' && depth == 0)
      result.emplace_back();
    else
      result.back() += c;
  }
  return result;
}

// Returns the name of a parameter: the last word before its default, or an empty text.
std::string name_of(std::string parameter)
{
  parameter = parameter.substr(0, parameter.find('='));
  while(!parameter.empty() && parameter.back() == ' ')
    parameter.pop_back();
  const std::size_t begin = parameter.find_last_of(" &*");
  return begin == std::string::npos || parameter.back() == '&' ? std::string()
                                                               : parameter.substr(begin + 1);
}

// Returns whether a command of Doxygen documents a name; one command can document several names.
bool documents(const std::string& documentation, const std::string& command,
               const std::string& name)
{
  for(std::size_t i = documentation.find(command); i != std::string::npos;
      i = documentation.find(command, i + 1))
  {
    std::string list = documentation.substr(i + command.size(), 100);
    for(std::string word; !list.empty();)
    {
      list.erase(0, std::min(list.size(), list.find_first_not_of(' ')));
      word = list.substr(0, list.find_first_of(" \n"));
      list.erase(0, word.size());
      const bool is_last = word.empty() || word.back() != ',';
      if(!is_last)
        word.pop_back();
      if(word == name)
        return true;
      if(is_last)
        break;
    }
  }
  return false;
}

std::vector<std::string> missing_parts(const Declaration& declaration)
{
  const std::string &documentation = declaration.documentation, &text = declaration.text;
  std::vector<std::string> result;
  std::size_t begin = 0; // of the type that the function returns
  if(starts_with(text, "template <"))
  {
    int depth = 0;
    begin = std::size_t(std::find_if(text.begin(), text.end(),
                                     [&](char c)
                                     {
                                       depth += c == '<' ? 1 : c == '>' ? -1 : 0;
                                       return c == '>' && depth == 0;
                                     }) -
                        text.begin()) +
            1;
    for(const std::string& name : identifiers_after("typename ", text.substr(0, begin)))
      if(name != "NamedParameters" && !documents(documentation, "\\tparam ", name))
        result.push_back("\\tparam " + name);
  }
  const std::size_t end = text.rfind(')');
  std::size_t open = end;
  for(int depth = 1; depth > 0;)
    depth += text[--open] == ')' ? 1 : text[open] == '(' ? -1 : 0;
  for(const std::string& parameter : split_at_commas(text.substr(open + 1, end - open - 1)))
    if(const std::string name = name_of(parameter);
       !name.empty() && !documents(documentation, "\\param ", name))
      result.push_back("\\param " + name);
  if(!contains(text.substr(begin, open - begin), "void ") && !contains(documentation, "\\returns "))
    result.push_back("\\returns");
  const std::vector<std::string> times = {"O(",    "time",       "Takes",
                                          "takes", "factorizes", "Propagates"};
  if(std::none_of(times.begin(), times.end(),
                  [&](const std::string& time) { return contains(documentation, time); }))
    result.push_back("complexity");
  return result;
}

TEST(Reference, functions_are_completely_documented)
{
  std::size_t number_of_functions = 0;
  const std::filesystem::path root = GEODESIC_PROCESSING_SOURCE;
  for(const auto& entry :
      std::filesystem::directory_iterator(root / "include/CGAL/Geodesic_processing"))
    if(entry.is_regular_file() && entry.path().filename() != "parameters.h")
      for(const Declaration& declaration : declarations_of(entry.path()))
      {
        const std::vector<std::string> types = {"struct ", "class ", "enum ", "using ", "#"};
        const std::size_t name = declaration.text.find('(');
        if(name == std::string::npos ||
           std::any_of(types.begin(), types.end(),
                       [&](const std::string& type)
                       { return contains(declaration.text.substr(0, name), type); }))
          continue;
        ++number_of_functions;
        for(const std::string& part : missing_parts(declaration))
          ADD_FAILURE() << entry.path().filename() << ": " << part << " is missing of\n"
                        << declaration.text;
      }
  EXPECT_GE(number_of_functions, 50u);
}

} // namespace reference_test
