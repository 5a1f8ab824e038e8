// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Scanner.h"
#include "io/Surface_file.h"
#include "io/append_polygon.h"

#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

namespace program {

namespace {

enum class Encoding
{
  ascii,
  little_endian,
  big_endian
};

struct Type
{
  char kind;        // i: signed integer, u: unsigned integer, f: floating point
  std::size_t size; // bytes
};

struct Property
{
  std::string name;
  Type type;
  std::optional<Type> count; // of lists only
};

struct Element
{
  std::string name;
  std::size_t count;
  std::vector<Property> properties;
};

struct Header
{
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
  std::size_t size = 0; // bytes, including the line feed after end_header
};

std::optional<Type> parse_type(std::string_view word)
{
  static const std::map<std::string_view, Type> types = {
      {"char", {'i', 1}},   {"int8", {'i', 1}},   {"uchar", {'u', 1}},  {"uint8", {'u', 1}},
      {"short", {'i', 2}},  {"int16", {'i', 2}},  {"ushort", {'u', 2}}, {"uint16", {'u', 2}},
      {"int", {'i', 4}},    {"int32", {'i', 4}},  {"uint", {'u', 4}},   {"uint32", {'u', 4}},
      {"int64", {'i', 8}},  {"uint64", {'u', 8}}, {"float", {'f', 4}},  {"float32", {'f', 4}},
      {"double", {'f', 8}}, {"float64", {'f', 8}}};
  const auto found = types.find(word);
  return found == types.end() ? std::nullopt : std::optional<Type>(found->second);
}

Header read_header(std::string_view bytes, const std::string& name)
{
  Header header;
  bool has_format = false;
  std::size_t position = 0;
  for(std::size_t number = 1; header.size == 0; ++number)
  {
    const std::size_t end = bytes.find('\n', position);
    if(end == std::string_view::npos)
      fail(name, "its header has no end");
    Scanner line(bytes.substr(position, end - position), name, 0);
    position = end + 1;
    if(!line.next_line())
      continue;
    const std::string_view word = line.word();
    const std::string line_prefix = "line " + std::to_string(number) + ": ";
    if(number == 1)
    {
      if(word != "ply")
        fail(name, "it is not a PLY file, its first line is not 'ply'");
    }
    else if(word == "format")
    {
      const std::string_view format = line.word();
      if(format == "ascii")
        header.encoding = Encoding::ascii;
      else if(format == "binary_little_endian")
        header.encoding = Encoding::little_endian;
      else if(format == "binary_big_endian")
        header.encoding = Encoding::big_endian;
      else
        fail(name, line_prefix + "the format '" + printable(format) + "' is unknown");
      has_format = true;
    }
    else if(word == "element")
    {
      const std::string_view element = line.word();
      const std::optional<long long> count = to_integer(line.word());
      if(element.empty() || !count || *count < 0)
        fail(name, line_prefix + "an element needs a name and a count");
      header.elements.push_back({std::string(element), static_cast<std::size_t>(*count), {}});
    }
    else if(word == "property")
    {
      if(header.elements.empty())
        fail(name, line_prefix + "a property stands before any element");
      Property property;
      std::string_view type = line.word();
      if(type == "list")
      {
        property.count = parse_type(line.word());
        if(!property.count || property.count->kind == 'f')
          fail(name, line_prefix + "the counts of a list are integers");
        type = line.word();
      }
      const std::optional<Type> value = parse_type(type);
      if(!value)
        fail(name, line_prefix + "the type '" + printable(type) + "' is unknown");
      property.type = *value;
      property.name = line.word();
      if(property.name.empty())
        fail(name, line_prefix + "a property has no name");
      header.elements.back().properties.push_back(property);
    }
    else if(word == "end_header")
      header.size = position;
    else if(word != "comment" && word != "obj_info")
      fail(name, line_prefix + "'" + printable(word) + "' does not belong in a header");
  }
  if(!has_format)
    fail(name, "its header names no format");
  return header;
}

// Reads the values of the body one by one, independent of the encoding.
class Body
{
public:
  Body(std::string_view bytes, Encoding encoding, const std::string& name)
      : m_bytes(bytes), m_encoding(encoding), m_name(name), m_text(bytes, name, 0)
  {}

  // Throws if the body is too short for the number of items in the header. This bounds the memory
  // that a header can request. A value in text needs at least one character and a separator.
  void expect(const Element& element)
  {
    double min_size = 0.;
    for(const Property& property : element.properties)
      min_size += m_encoding == Encoding::ascii ? 2.
                  : property.count              ? static_cast<double>(property.count->size)
                                                : static_cast<double>(property.type.size);
    const double available = static_cast<double>(m_bytes.size()) + 1.;
    if(min_size * static_cast<double>(element.count) > available)
      fail(m_name, "its header promises " + std::to_string(element.count) + " of '" +
                       printable(element.name) + "', more than the file holds");
  }

  double value(Type type)
  {
    if(m_encoding == Encoding::ascii)
    {
      const std::string_view word = m_text.next_word();
      if(word.empty())
        fail(m_name, "it ends too early");
      const std::optional<double> number = to_number(word);
      if(!number)
        fail(m_name, "'" + printable(word) + "' is not a number");
      return *number;
    }
    if(m_bytes.size() < type.size)
      fail(m_name, "it ends too early");
    unsigned char buffer[8] = {};
    for(std::size_t i = 0; i < type.size; ++i)
      buffer[m_encoding == Encoding::little_endian ? i : type.size - 1 - i] =
          static_cast<unsigned char>(m_bytes[i]);
    m_bytes.remove_prefix(type.size);
    std::uint64_t bits = 0;
    for(std::size_t i = 0; i < type.size; ++i)
      bits |= std::uint64_t{buffer[i]} << (8 * i);
    if(type.kind == 'u')
      return static_cast<double>(bits);
    if(type.kind == 'i')
    {
      const unsigned unused = static_cast<unsigned>(64 - 8 * type.size);
      return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
    }
    if(type.size == 4)
    {
      const auto single_bits = static_cast<std::uint32_t>(bits);
      float single;
      std::memcpy(&single, &single_bits, sizeof single);
      return single;
    }
    double result;
    std::memcpy(&result, &bits, sizeof result);
    return result;
  }

  void list(const Property& property, std::vector<double>& values)
  {
    const double count = value(*property.count);
    const double min_size =
        m_encoding == Encoding::ascii ? 1. : static_cast<double>(property.type.size);
    if(!(count >= 0. && std::floor(count) == count))
      fail(m_name, "the length of a list is not a natural number");
    if(count * min_size > static_cast<double>(m_bytes.size()))
      fail(m_name, "a list is longer than the file");
    values.resize(static_cast<std::size_t>(count));
    for(double& x : values)
      x = value(property.type);
  }

private:
  std::string_view m_bytes; // with the ascii encoding: the whole file, as an upper bound
  Encoding m_encoding;
  std::string m_name;
  Scanner m_text;
};

void read_vertices(Body& body, const Element& element, const std::string& name,
                   Surface_file& surface)
{
  surface.points.resize(element.count);

  // Destination of each property: a coordinate, a component of the normal, or a separate property.
  std::vector<double*> property_values(element.properties.size(), nullptr);
  std::vector<int> coordinate(element.properties.size(), -1),
      normal_component(element.properties.size(), -1);
  bool is_present[6] = {};
  static const char* const standard_names[] = {"x", "y", "z", "nx", "ny", "nz"};
  for(std::size_t p = 0; p < element.properties.size(); ++p)
  {
    const Property& property = element.properties[p];
    if(property.count)
      continue;
    int standard_index = -1;
    for(int k = 0; k < 6; ++k)
      if(property.name == standard_names[k])
        standard_index = k;
    if(standard_index >= 0 && !is_present[standard_index])
    {
      is_present[standard_index] = true;
      (standard_index < 3 ? coordinate : normal_component)[p] = standard_index % 3;
    }
    else if(standard_index < 0 && surface.properties.count(property.name) == 0)
    {
      std::vector<double>& values = surface.properties[property.name];
      values.resize(element.count);
      property_values[p] = values.data();
    }
  }
  if(!is_present[0] || !is_present[1] || !is_present[2])
    fail(name, "its vertices have no x, y and z");
  if(is_present[3] && is_present[4] && is_present[5])
    surface.normals.resize(element.count);

  std::vector<double> ignored;
  for(std::size_t i = 0; i < element.count; ++i)
    for(std::size_t p = 0; p < element.properties.size(); ++p)
    {
      if(element.properties[p].count)
      {
        body.list(element.properties[p], ignored);
        continue;
      }
      const double value = body.value(element.properties[p].type);
      if(coordinate[p] >= 0)
        surface.points[i][coordinate[p]] = value;
      else if(normal_component[p] >= 0 && !surface.normals.empty())
        surface.normals[i][normal_component[p]] = value;
      else if(property_values[p] != nullptr)
        property_values[p][i] = value;
    }
}

// Reads the edges. An edge with a missing endpoint is skipped.
void read_edges(Body& body, const Element& element, Surface_file& surface)
{
  std::vector<double> ignored;
  for(std::size_t i = 0; i < element.count; ++i)
  {
    std::optional<std::uint32_t> ends[2];
    for(const Property& property : element.properties)
      if(property.count)
        body.list(property, ignored);
      else
      {
        const double value = body.value(property.type);
        if(property.name == "vertex1" || property.name == "vertex2")
          ends[property.name == "vertex2"] = to_index(value);
      }
    if(ends[0] && ends[1])
      surface.edges.push_back({*ends[0], *ends[1]});
  }
}

void read_others(Body& body, const Element& element, Surface_file& surface)
{
  const bool is_face = element.name == "face", is_strip = element.name == "tristrips";
  std::vector<double> values;
  for(std::size_t i = 0; i < element.count; ++i)
    for(const Property& property : element.properties)
    {
      if(!property.count)
      {
        body.value(property.type);
        continue;
      }
      body.list(property, values);
      if(property.name != "vertex_indices" && property.name != "vertex_index")
        continue;
      if(is_face)
      {
        for(const double index : values)
          append_corner(surface, index);
        end_polygon(surface);
      }
      else if(is_strip)
        append_strip(surface, values);
    }
}

} // namespace

Surface_file read_ply(std::string_view bytes, const std::string& name)
{
  const Header header = read_header(bytes, name);
  Body body(bytes.substr(header.size), header.encoding, name);
  Surface_file surface;
  bool has_vertices = false;
  for(const Element& element : header.elements)
  {
    // Items without properties occupy no bytes, so their number cannot be validated.
    if(element.properties.empty())
      continue;
    body.expect(element);
    if(element.name == "vertex" && std::exchange(has_vertices, true))
      fail(name, "it has two elements 'vertex'");
    if(element.name == "vertex")
      read_vertices(body, element, name, surface);
    else if(element.name == "edge")
      read_edges(body, element, surface);
    else
      read_others(body, element, surface);
  }
  return surface;
}

} // namespace program
