// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks that the reference of each public function is complete.
#include <gtest/gtest.h>

#include "reference_parser.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>

namespace reference_test {

using Names = std::vector<std::string>;

// Returns the identifiers that follow a word.
Names identifiers_after(const std::string& word, const std::string& text)
{
  Names result;
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
Names split_at_commas(const std::string& text)
{
  Names result(1);
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

// Returns the position of the bracket that opens the parameters of a function.
std::size_t begin_of_parameters(const std::string& text)
{
  std::size_t result = text.rfind(')');
  for(int depth = 1; depth > 0;)
    depth += text[--result] == ')' ? 1 : text[result] == '(' ? -1 : 0;
  return result;
}

Names parameters_of(const std::string& text)
{
  Names result;
  const std::size_t begin = begin_of_parameters(text) + 1;
  for(const std::string& parameter : split_at_commas(text.substr(begin, text.rfind(')') - begin)))
    if(const std::string name = name_of(parameter); !name.empty())
      result.push_back(name);
  return result;
}

Names template_parameters_of(const std::string& text)
{
  Names result;
  const std::string rest = without_template(text);
  for(const std::string& name :
      identifiers_after("typename ", text.substr(0, text.size() - rest.size())))
    if(name != "NamedParameters" && !name.empty())
      result.push_back(name);
  return result;
}

// Returns the name of a function with the type that it returns.
std::string type_and_name_of(const std::string& text)
{
  const std::string rest = without_template(text);
  return rest.substr(0, begin_of_parameters(rest));
}

std::string function_name_of(const std::string& text)
{
  const std::string result = type_and_name_of(text);
  return result.substr(result.rfind(' ') + 1);
}

// Returns the names that Doxygen reads after each use of a command, separated by commas.
std::set<std::string> names_after(const std::string& command, const std::string& documentation)
{
  std::set<std::string> result;
  for(std::size_t i = documentation.find(command); i != std::string::npos;
      i = documentation.find(command, i + 1))
  {
    std::istringstream words(documentation.substr(i + command.size()));
    for(std::string word; words >> word;)
    {
      const bool is_last = word.back() != ',';
      result.insert(is_last ? word : word.substr(0, word.size() - 1));
      if(is_last)
        break;
    }
  }
  return result;
}

// Returns the sentences of a documentation that belong to no command.
std::string sentences_of(const std::string& documentation)
{
  std::string result;
  std::istringstream lines(documentation);
  bool is_command = false;
  for(std::string line; std::getline(lines, line);)
  {
    const std::string text = line.size() > 4 ? line.substr(4) : std::string();
    if(starts_with(text, "\\ingroup"))
      continue;
    if(text.empty())
      is_command = false;
    else if(text[0] == '\\' && !starts_with(text, "\\f$") && !starts_with(text, "\\cgalCite"))
      is_command = true;
    if(!is_command && !text.empty())
      result += text + ' ';
  }
  return result;
}

bool states_time(const std::string& documentation)
{
  const std::string sentences = sentences_of(documentation);
  const Names times = {"O(", "Takes ", "takes ", " take ", "he time", "Propagates "};
  return std::any_of(times.begin(), times.end(),
                     [&](const std::string& time) { return contains(sentences, time); });
}

// Returns whether a class states the time of all members, or of all that state none.
bool states_time_of_members(const Class& c)
{
  const std::string sentences = sentences_of(c.documentation);
  return contains(sentences, "embers that do not state their time take ") ||
         contains(sentences, "All members take ");
}

// Returns the parts that both kinds of functions need: members can name their parameters in the
// sentences, free functions only by commands.
Names missing_names(const Declaration& declaration, bool is_member)
{
  Names result;
  const auto check = [&](const std::string& command, const Names& names)
  {
    const std::set<std::string> found = names_after(command + " ", declaration.documentation);
    for(const std::string& name : names)
      if(found.count(name) == 0 &&
         !(is_member && contains(sentences_of(declaration.documentation), '`' + name + '`')))
        result.push_back(command + ' ' + name);
  };
  check("\\tparam", template_parameters_of(declaration.text));
  check("\\param", parameters_of(declaration.text));
  const std::string sentences = sentences_of(declaration.documentation);
  if(sentences.empty())
    result.push_back("sentence");
  const std::string name = type_and_name_of(declaration.text);
  const bool is_constructor =
      std::none_of(name.begin(), name.end(), [](char c) { return c == ' '; });
  if(!starts_with(name, "void ") && !starts_with(name, "explicit ") && !is_constructor &&
     !contains(declaration.documentation, "\\returns ") &&
     !(is_member && (starts_with(sentences, "Returns ") || starts_with(sentences, "returns "))))
    result.push_back("\\returns");
  return result;
}

Names missing_parts_of_member(const Declaration& member, const Class& c)
{
  if(member.documentation.empty())
    return {"documentation"};
  Names result = missing_names(member, true);
  if(!states_time(member.documentation) && !states_time_of_members(c))
    result.push_back("complexity");
  // Functions of the library that throw errors of the user. Named exceptions need the command.
  const Names throwing = {"throw ",
                          "check_",
                          "domain.inner(",
                          "domain.inner_vertex(",
                          "locate(",
                          "internal::location(",
                          "internal::locations(",
                          "internal::sources(",
                          "internal::masses(",
                          "internal::spatial(",
                          "read_throwing_callback("};
  const bool may_throw =
      std::any_of(throwing.begin(), throwing.end(),
                  [&](const std::string& part) { return contains(member.body, part); });
  const std::string sentences = sentences_of(member.documentation);
  if((may_throw || contains(sentences, "hrows ") || contains(sentences, "_error")) &&
     !contains(member.documentation, "\\throws "))
    result.push_back("\\throws");
  return result;
}

// Functions that throw nothing, except if memory is exhausted, and the reason.
const std::map<std::string, std::string> functions_without_exceptions = {
    {"border_sources(", "reads connectivity only"},
    {"composite_decal(", "reads and writes the property map only"},
    {"face_distortion(", "the map of a degenerate face is infinite or NaN"},
    {"make_domain(const Mesh_domain<", "copies the domain"},
    {"make_domain(const Soup_domain<", "copies the domain"},
    {"make_domain(const Surfel_domain<", "copies the domain"},
    {"mass_density(", "stores the map; the function that reads it throws"}};

// Functions without a publication, and the reason.
const std::map<std::string, std::string> functions_without_reference = {
    {"border_sources(", "follows the halfedges of the boundary"},
    {"bake_atlas(", "calls a function for each texel"},
    {"composite_decal(", "calls a function for each vertex"},
    {"bake_decals(", "calls functions for each texel"},
    {"face_distortion(", "computes singular values; the measures have references"},
    {"surface_distortion(", "sums measures, which have references"},
    {"flattening_distortion(", "sums measures, which have references"},
    {"geodesic_barycenter(", "sums distances, whose methods have references"},
    {"geodesic_distance_matrix(", "computes distances, whose methods have references"},
    {"geodesic_eccentricity(", "compares distances, whose methods have references"},
    {"geodesic_distance_derivatives(", "differentiates the length of a polyline"},
    {"sparse_geodesic_distance_matrix(", "computes distances, whose methods have references"},
    {"geodesic_voronoi_diagram(", "compares distances, whose methods have references"},
    {"geodesic_voronoi_cells(", "splits faces by geodesic_voronoi_diagram()"},
    {"locate_on_surface(", "searches a bounding volume hierarchy"},
    {"make_domain(", "reads the surface"},
    {"merge_distance_matrices(", "joins files"},
    {"mass_density(", "stores the map"}};

bool is_listed(const std::map<std::string, std::string>& list, const std::string& text)
{
  return std::any_of(list.begin(), list.end(),
                     [&](const auto& item) { return contains(text, ' ' + item.first); });
}

Names missing_parts_of_function(const Declaration& function)
{
  Names result = missing_names(function, false);
  if(!states_time(function.documentation))
    result.push_back("complexity");
  if(!contains(function.documentation, "\\throws ") &&
     !is_listed(functions_without_exceptions, function.text))
    result.push_back("\\throws");
  // A map that is read must have a value for each key.
  if((contains(function.documentation, "`ReadablePropertyMap`") ||
      contains(function.documentation, "`ReadWritePropertyMap`")) &&
     !contains(function.documentation, "\\pre "))
    result.push_back("\\pre");
  return result;
}

// Returns whether a function, or another one that its sentences name, has a publication.
bool has_reference(const Declaration& function, const std::string& file,
                   const std::map<std::string, Header>& headers)
{
  if(headers.at(file).has_citation || is_listed(functions_without_reference, function.text))
    return true;
  const std::string sentences = sentences_of(function.documentation);
  for(const auto& [other_file, header] : headers)
  {
    Names names;
    for(const Declaration& other : header.functions)
      names.push_back(function_name_of(other.text));
    for(const Class& c : header.classes)
      names.push_back(c.name);
    if(header.has_citation && std::any_of(names.begin(), names.end(),
                                          [&](const std::string& name)
                                          {
                                            return contains(sentences, '`' + name + '`') ||
                                                   contains(sentences, '`' + name + "()") ||
                                                   contains(sentences, '`' + name + "::");
                                          }))
      return true;
  }
  return false;
}

std::map<std::string, Header> public_headers()
{
  std::map<std::string, Header> result;
  const std::filesystem::path root = GEODESIC_PROCESSING_SOURCE;
  for(const auto& entry :
      std::filesystem::directory_iterator(root / "include/CGAL/Geodesic_processing"))
    if(entry.is_regular_file() && entry.path().filename() != "parameters.h")
    {
      std::ifstream in(entry.path());
      result[entry.path().filename()] = read_header(in);
    }
  return result;
}

// Returns the missing parts of the only function of a header.
Names missing_parts_in(const std::string& text)
{
  std::istringstream in(text);
  const Header header = read_header(in);
  EXPECT_EQ(header.functions.size(), 1u);
  return missing_parts_of_function(header.functions.at(0));
}

// Returns the missing parts of all public members of the only class of a header.
Names missing_parts_of_members_in(const std::string& class_documentation, const std::string& body)
{
  std::istringstream in(class_documentation +
                        "template <typename T>\nclass C : public B\n{\npublic:\n" + body + "};\n");
  const Header header = read_header(in);
  EXPECT_EQ(header.classes.size(), 1u);
  Names result;
  for(const Declaration& member : header.classes.at(0).members)
    for(const std::string& part : missing_parts_of_member(member, header.classes[0]))
      result.push_back(part);
  return result;
}

// Removes the only line that contains a text.
std::string without(const std::string& line, const std::string& text)
{
  const std::size_t found = text.find(line), begin = text.rfind('\n', found) + 1;
  EXPECT_NE(found, std::string::npos) << line;
  return text.substr(0, begin) + text.substr(text.find('\n', found) + 1);
}

TEST(Reference, each_missing_part_of_a_function_is_found)
{
  const std::string text = "/// \\ingroup A\n"
                           "///\n"
                           "/// Computes b. O(n).\n"
                           "///\n"
                           "/// \\tparam T a model of `ReadablePropertyMap`\n"
                           "/// \\param a, b numbers\n"
                           "/// \\pre Each key has a value.\n"
                           "/// \\returns a number\n"
                           "/// \\throws nothing\n"
                           "template <typename T, typename NamedParameters = D<T>>\n"
                           "std::pair<int, T> f(const T& a,\n"
                           "                    int b = g(1, 2))\n"
                           "{\n"
                           "  return h(c);\n"
                           "}\n";
  EXPECT_EQ(missing_parts_in(text), Names());
  EXPECT_EQ(missing_parts_in(without("Computes", text)), Names({"sentence", "complexity"}));
  EXPECT_EQ(missing_parts_in(without("\\tparam", text)), Names({"\\tparam T"}));
  EXPECT_EQ(missing_parts_in(without("\\param", text)), Names({"\\param a", "\\param b"}));
  EXPECT_EQ(missing_parts_in(without("\\pre", text)), Names({"\\pre"}));
  EXPECT_EQ(missing_parts_in(without("\\returns", text)), Names({"\\returns"}));
  EXPECT_EQ(missing_parts_in(without("\\throws", text)), Names({"\\throws"}));
}

TEST(Reference, each_missing_part_of_a_member_is_found)
{
  const std::string c = "/// Stores b. Members that do not state their time take O(1) time.\n";
  const std::string text = "  /// Constructs it from `b`.\n"
                           "  explicit C(int b)\n"
                           "      : m_b(b)\n"
                           "  {}\n"
                           "\n"
                           "  /// Returns `a`.\n"
                           "  /// \\throws Error if a is negative\n"
                           "  template <typename NamedParameters>\n"
                           "  int f(int a) const\n"
                           "  {\n"
                           "    check_sign(a);\n"
                           "  }\n";
  EXPECT_EQ(missing_parts_of_members_in(c, text), Names());
  EXPECT_EQ(missing_parts_of_members_in("/// Stores b.\n", text),
            Names({"complexity", "complexity"}));
  EXPECT_EQ(missing_parts_of_members_in(c, without("Constructs", text)), Names({"documentation"}));
  EXPECT_EQ(missing_parts_of_members_in(c, without("Returns", text)),
            Names({"\\param a", "sentence", "\\returns"}));
  EXPECT_EQ(missing_parts_of_members_in(c, without("\\throws", text)), Names({"\\throws"}));
  EXPECT_EQ(missing_parts_of_members_in(c, "  int g() { return 1; }\n"), Names({"documentation"}));
  EXPECT_EQ(missing_parts_of_members_in(c, "  // A comment.\n"
                                           "  C& operator<(const C& c)\n"
                                           "  {\n"
                                           "  }\n"),
            Names({"documentation"}));
}

TEST(Reference, members_outside_of_the_reference_are_ignored)
{
  const std::string text = "  std::function<bool(double)> callback = g();\n"
                           "  using D = decltype(f());\n"
                           "#ifndef DOXYGEN_RUNNING\n"
                           "  int g();\n"
                           "#endif\n"
                           "  /// \\cond INTERNAL\n"
                           "  int h();\n"
                           "  /// \\endcond\n"
                           "private:\n"
                           "  int i();\n";
  EXPECT_EQ(missing_parts_of_members_in("/// A class.\n", text), Names());
  EXPECT_EQ(missing_parts_of_members_in("/// A class.\n", text + "public:\n  int j();\n"),
            Names({"documentation"}));
}

TEST(Reference, functions_are_completely_documented)
{
  std::size_t number_of_functions = 0;
  const std::map<std::string, Header> headers = public_headers();
  for(const auto& [file, header] : headers)
    for(const Declaration& function : header.functions)
    {
      ++number_of_functions;
      Names missing = missing_parts_of_function(function);
      if(!has_reference(function, file, headers))
        missing.push_back("reference");
      for(const std::string& part : missing)
        ADD_FAILURE() << file << ": " << part << " is missing of\n" << function.text;
    }
  EXPECT_GE(number_of_functions, 55u);
}

TEST(Reference, members_are_completely_documented)
{
  std::size_t number_of_members = 0;
  for(const auto& [file, header] : public_headers())
    for(const Class& c : header.classes)
      for(const Declaration& member : c.members)
      {
        ++number_of_members;
        for(const std::string& part : missing_parts_of_member(member, c))
          ADD_FAILURE() << file << ": " << part << " is missing of\n" << member.text;
      }
  EXPECT_GE(number_of_members, 160u);
}

// A declaration of two names would leave one of them without documentation.
bool declares_one_name(const std::string& declaration)
{
  return split_at_commas(declaration.substr(0, declaration.find('='))).size() == 1 &&
         split_at_commas(declaration.substr(declaration.find_last_of('}') + 1)).size() == 1;
}

TEST(Reference, data_members_are_documented)
{
  std::size_t number_of_members = 0;
  for(const auto& [file, header] : public_headers())
    for(const Class& c : header.classes)
      for(const Declaration& member : c.data)
      {
        ++number_of_members;
        EXPECT_NE(member.documentation, "") << file << ": " << c.name << ": " << member.text;
        EXPECT_TRUE(declares_one_name(member.text)) << file << ": " << member.text;
      }
  EXPECT_GE(number_of_members, 60u);
}

} // namespace reference_test
