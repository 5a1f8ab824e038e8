// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/Surface_file.h"
#include "readers/append_polygon.h"
#include "readers/binary_numbers.h"
#include "readers/parse_chunks.h"

#include <algorithm>
#include <cmath>
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

struct Property
{
  std::string name;
  Number_type type;
  std::optional<Number_type> count; // of lists only
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

std::optional<Number_type> parse_type(std::string_view word)
{
  static const std::map<std::string_view, Number_type> types = {
      {"char", {'i', 1}},   {"int8", {'i', 1}},   {"uchar", {'u', 1}},  {"uint8", {'u', 1}},
      {"short", {'i', 2}},  {"int16", {'i', 2}},  {"ushort", {'u', 2}}, {"uint16", {'u', 2}},
      {"int", {'i', 4}},    {"int32", {'i', 4}},  {"uint", {'u', 4}},   {"uint32", {'u', 4}},
      {"int64", {'i', 8}},  {"uint64", {'u', 8}}, {"float", {'f', 4}},  {"float32", {'f', 4}},
      {"double", {'f', 8}}, {"float64", {'f', 8}}};
  const auto found = types.find(word);
  return found == types.end() ? std::nullopt : std::optional<Number_type>(found->second);
}

class Header_reader
{
public:
  Header_reader(std::string_view bytes, const std::string& name) : m_bytes(bytes), m_name(name) {}

  Header read()
  {
    std::size_t position = 0;
    for(m_line_number = 1; m_header.size == 0; ++m_line_number)
    {
      const std::size_t end = m_bytes.find('\n', position);
      if(end == std::string_view::npos)
        program::fail(m_name, "its header does not end with 'end_header'");
      Scanner line(m_bytes.substr(position, end - position), m_name, 0);
      position = end + 1;
      if(line.next_line())
        read_line(line, position);
    }
    if(!m_has_format)
      program::fail(m_name, "its header has no format");
    return std::move(m_header);
  }

private:
  [[noreturn]] void fail(const std::string& reason) const
  {
    program::fail(m_name, "line " + std::to_string(m_line_number) + ": " + reason);
  }

  // line_end: the position after the line.
  void read_line(Scanner& line, std::size_t line_end)
  {
    const std::string_view word = line.word();
    if(m_line_number == 1)
    {
      if(word != "ply")
        program::fail(m_name, "it is not a PLY file, its first line is not 'ply'");
    }
    else if(word == "format")
      read_format(line);
    else if(word == "element")
      read_element(line);
    else if(word == "property")
      read_property(line);
    else if(word == "end_header")
      m_header.size = line_end;
    else if(word != "comment" && word != "obj_info")
      fail("'" + printable(word) + "' is not a keyword of the header");
  }

  void read_format(Scanner& line)
  {
    const std::string_view format = line.word();
    if(format == "ascii")
      m_header.encoding = Encoding::ascii;
    else if(format == "binary_little_endian")
      m_header.encoding = Encoding::little_endian;
    else if(format == "binary_big_endian")
      m_header.encoding = Encoding::big_endian;
    else
      fail("the format '" + printable(format) + "' is unknown");
    m_has_format = true;
  }

  void read_element(Scanner& line)
  {
    const std::string_view element = line.word();
    const std::optional<long long> count = to_integer(line.word());
    if(element.empty() || !count || *count < 0)
      fail("an element needs a name and a count");
    m_header.elements.push_back({std::string(element), static_cast<std::size_t>(*count), {}});
  }

  void read_property(Scanner& line)
  {
    if(m_header.elements.empty())
      fail("a property precedes the first element");
    Property property;
    std::string_view type = line.word();
    if(type == "list")
    {
      property.count = parse_type(line.word());
      if(!property.count || property.count->kind == 'f')
        fail("the length of a list must have an integer type");
      type = line.word();
    }
    const std::optional<Number_type> value = parse_type(type);
    if(!value)
      fail("the type '" + printable(type) + "' is unknown");
    property.type = *value;
    property.name = line.word();
    if(property.name.empty())
      fail("a property has no name");
    m_header.elements.back().properties.push_back(property);
  }

  std::string_view m_bytes;
  std::string m_name;
  Header m_header;
  bool m_has_format = false;
  std::size_t m_line_number = 1;
};

// Reads the values of the body, or of a chunk of it, one by one, independent of the encoding.
class Body
{
public:
  // is_chunk: whether it is a chunk of text in which each item must be one line
  Body(std::string_view bytes, Encoding encoding, const std::string& name, bool is_chunk = false)
      : m_bytes(bytes), m_encoding(encoding), m_name(name), m_text(bytes, name, 0),
        m_is_chunk(is_chunk)
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
      fail(m_name, "its header declares " + std::to_string(element.count) + " elements '" +
                       printable(element.name) + "', but the file is too short for them");
  }

  double value(Number_type type)
  {
    if(m_encoding == Encoding::ascii)
      return text_value();
    if(m_bytes.size() < type.size)
      fail(m_name, "it ends unexpectedly");
    const std::uint64_t bits = bits_at(m_bytes, type.size, m_encoding == Encoding::big_endian);
    m_bytes.remove_prefix(type.size);
    return to_value(bits, type);
  }

  void list(const Property& property, std::vector<double>& values)
  {
    values.resize(list_size(property));
    for(double& x : values)
      x = value(property.type);
  }

  // Appends the polygon whose corners are the values of a list.
  void polygon(const Property& property, Surface_file& surface)
  {
    for(std::size_t size = list_size(property); size > 0; --size)
      if(long long index; take_integer(index))
        append_corner(surface, index);
      else
        append_corner(surface, value(property.type));
    end_polygon(surface);
  }

  std::size_t list_size(const Property& property)
  {
    long long integer;
    const double count =
        take_integer(integer) ? static_cast<double>(integer) : value(*property.count);
    const double min_size =
        m_encoding == Encoding::ascii ? 1. : static_cast<double>(property.type.size);
    if(!(count >= 0. && std::floor(count) == count))
      fail(m_name, "the length of a list is not a nonnegative integer");
    if(count * min_size > static_cast<double>(m_bytes.size()))
      fail(m_name, "a list is longer than the file");
    return static_cast<std::size_t>(count);
  }

  // Returns the next bytes of a binary body and advances behind them.
  std::string_view take(std::size_t size)
  {
    if(m_bytes.size() < size)
      fail(m_name, "it ends unexpectedly");
    const std::string_view result = m_bytes.substr(0, size);
    m_bytes.remove_prefix(size);
    return result;
  }

  // Appends the triangles that follow each other, at most max_count, if each is stored as a byte 3
  // and three 32-bit indices in little-endian order. Returns their number.
  std::size_t take_triangles(std::size_t max_count, bool is_signed, Surface_file& surface)
  {
    constexpr std::size_t size = 13;
    std::size_t count = 0;
    for(; count < max_count && m_bytes.size() >= size && m_bytes[0] == 3; ++count)
    {
      for(std::size_t k = 0; k < 3; ++k)
      {
        const auto index = static_cast<std::uint32_t>(bits_at(m_bytes.substr(1 + 4 * k), 4, false));
        const bool is_negative = is_signed && index >> 31 != 0;
        surface.corners.push_back(is_negative ? to_index(-1.) : index);
      }
      end_polygon(surface);
      m_bytes.remove_prefix(size);
    }
    return count;
  }

  // Ends an item. In a chunk, throws if the items so far were not one line each.
  void end_item()
  {
    if(m_is_chunk && (m_text.line_number() != ++m_number_of_items || !m_text.is_line_empty()))
      fail(m_name, "an item is not one line");
  }

  // Advances to the next line of a text. Returns false at its end.
  bool next_line() { return m_text.next_line(); }

  std::size_t size() const { return m_bytes.size(); }

  Encoding encoding() const { return m_encoding; }

private:
  // Reads the next value if it is an integer in text, which is parsed faster than a number.
  // Otherwise, value() returns it.
  bool take_integer(long long& integer)
  {
    if(m_encoding != Encoding::ascii)
      return false;
    if(m_text.is_line_empty())
      m_text.next_line();
    return m_text.take_plain_integer(integer);
  }

  double text_value()
  {
    if(m_text.is_line_empty() && !m_text.next_line())
      fail(m_name, "it ends unexpectedly");
    double plain;
    if(m_text.take_plain_number(plain))
      return plain;
    const std::string_view word = m_text.word();
    const std::optional<double> number = to_number(word);
    if(!number)
      fail(m_name, "'" + printable(word) + "' is not a number");
    return *number;
  }

  std::string_view m_bytes; // with the ascii encoding: the whole file, as an upper bound
  Encoding m_encoding;
  std::string m_name;
  Scanner m_text;
  bool m_is_chunk;
  std::size_t m_number_of_items = 0;
};

// The destination of each property of a vertex: a coordinate, a component of the normal, or a
// separate property of the surface. Lists and repeated names have none.
struct Vertex_properties
{
  std::vector<int> coordinate, normal_component; // #properties: -1 if it is none
  std::vector<double*> values;                   // #properties: nullptr if it is none
};

// Resizes the arrays of the surface and returns the destinations in them.
Vertex_properties prepare_vertices(const Element& element, const std::string& name,
                                   Surface_file& surface)
{
  surface.points.resize(element.count);
  const std::size_t n = element.properties.size();
  Vertex_properties result = {std::vector<int>(n, -1), std::vector<int>(n, -1),
                              std::vector<double*>(n, nullptr)};
  bool is_present[6] = {};
  static const char* const standard_names[] = {"x", "y", "z", "nx", "ny", "nz"};
  for(std::size_t p = 0; p < n; ++p)
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
      (standard_index < 3 ? result.coordinate : result.normal_component)[p] = standard_index % 3;
    }
    else if(standard_index < 0 && surface.properties.count(property.name) == 0)
    {
      std::vector<double>& values = surface.properties[property.name];
      values.resize(element.count);
      result.values[p] = values.data();
    }
  }
  if(!is_present[0] || !is_present[1] || !is_present[2])
    fail(name, "its vertices do not have the properties x, y and z");
  if(is_present[3] && is_present[4] && is_present[5])
    surface.normals.resize(element.count);
  return result;
}

// A column of numbers in a table of bytes, and its destination.
struct Column
{
  std::size_t offset; // of the first number
  Number_type type;
  double* values;
  std::size_t step; // between consecutive values
};

// Copies some rows of a column. The size of the numbers is a constant, for the compiler.
//
// row_size: bytes of a row
template <std::size_t size>
void copy_rows(std::string_view bytes, std::size_t row_size, bool big_endian, const Column& column,
               std::size_t begin, std::size_t end)
{
  const Number_type type = {column.type.kind, size};
  for(std::size_t i = begin; i < end; ++i)
    column.values[i * column.step] =
        to_value(bits_at(bytes.substr(i * row_size + column.offset, size), size, big_endian), type);
}

// Reads vertices in binary encoding without lists. Their rows have the same size.
void read_rows(Body& body, const Element& element, const Vertex_properties& destination,
               Surface_file& surface)
{
  std::vector<Column> columns;
  std::size_t row_size = 0;
  for(std::size_t p = 0; p < element.properties.size(); ++p)
  {
    const Number_type type = element.properties[p].type;
    const int coordinate = destination.coordinate[p], component = destination.normal_component[p];
    if(element.count > 0 && coordinate >= 0)
      columns.push_back({row_size, type, &surface.points[0][std::size_t(coordinate)], 3});
    else if(component >= 0 && !surface.normals.empty())
      columns.push_back({row_size, type, &surface.normals[0][std::size_t(component)], 3});
    else if(destination.values[p] != nullptr)
      columns.push_back({row_size, type, destination.values[p], 1});
    row_size += type.size;
  }
  const std::string_view bytes = body.take(element.count * row_size);
  const bool big_endian = body.encoding() == Encoding::big_endian;
  // A block of rows is in the cache while its columns are copied.
  constexpr std::size_t block_size = 512;
  for(std::size_t begin = 0; begin < element.count; begin += block_size)
  {
    const std::size_t end = std::min(element.count, begin + block_size);
    for(const Column& column : columns)
      switch(column.type.size)
      {
      case 1:
        copy_rows<1>(bytes, row_size, big_endian, column, begin, end);
        break;
      case 2:
        copy_rows<2>(bytes, row_size, big_endian, column, begin, end);
        break;
      case 4:
        copy_rows<4>(bytes, row_size, big_endian, column, begin, end);
        break;
      default:
        copy_rows<8>(bytes, row_size, big_endian, column, begin, end);
      }
  }
}

// Returns whether the items have no lists, so that they have the same size in binary encoding.
bool has_rows(const Element& element)
{
  return std::none_of(element.properties.begin(), element.properties.end(),
                      [](const Property& property) { return property.count.has_value(); });
}

// The items begin, ..., end - 1 of an element.
struct Item_range
{
  std::size_t begin, end;
};

void read_vertices(Body& body, const Element& element, const Vertex_properties& destination,
                   const Item_range& range, Surface_file& surface)
{
  std::vector<double> ignored;
  for(std::size_t i = range.begin; i < range.end; ++i)
  {
    for(std::size_t p = 0; p < element.properties.size(); ++p)
    {
      if(element.properties[p].count)
      {
        body.list(element.properties[p], ignored);
        continue;
      }
      const double value = body.value(element.properties[p].type);
      const int coordinate = destination.coordinate[p], component = destination.normal_component[p];
      if(coordinate >= 0)
        surface.points[i][static_cast<std::size_t>(coordinate)] = value;
      else if(component >= 0 && !surface.normals.empty())
        surface.normals[i][static_cast<std::size_t>(component)] = value;
      else if(destination.values[p] != nullptr)
        destination.values[p][i] = value;
    }
    body.end_item();
  }
}

// Appends the edges. An edge with a missing endpoint is skipped.
void read_edges(Body& body, const Element& element, const Item_range& range, Surface_file& surface)
{
  std::vector<double> ignored;
  for(std::size_t i = range.begin; i < range.end; ++i)
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
    body.end_item();
  }
}

bool is_corner_list(const Property& property)
{
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

// Appends the polygons of faces and triangle strips. Skips items of unknown elements.
void read_others(Body& body, const Element& element, const Item_range& range, Surface_file& surface)
{
  const bool is_face = element.name == "face", is_strip = element.name == "tristrips";
  const Property& first = element.properties[0];
  const bool has_triangles = is_face && element.properties.size() == 1 && is_corner_list(first) &&
                             body.encoding() == Encoding::little_endian && first.count->size == 1 &&
                             first.type.size == 4 && first.type.kind != 'f';
  std::vector<bool> has_corners; // #properties
  for(const Property& property : element.properties)
    has_corners.push_back(is_corner_list(property));
  std::vector<double> values;
  for(std::size_t i = range.begin; i < range.end; ++i)
  {
    if(has_triangles)
      i += body.take_triangles(range.end - i, first.type.kind == 'i', surface);
    if(i == range.end)
      break;
    for(std::size_t p = 0; p < has_corners.size(); ++p)
    {
      const Property& property = element.properties[p];
      if(!property.count)
      {
        body.value(property.type);
        continue;
      }
      if(is_face && has_corners[p])
      {
        body.polygon(property, surface);
        continue;
      }
      body.list(property, values);
      if(is_strip && has_corners[p])
        append_strip(surface, values);
    }
    body.end_item();
  }
}

// Reads some items. Writes the values of vertices, and appends edges and polygons to another
// surface.
void read_items(Body& body, const Element& element, const Vertex_properties& destination,
                const Item_range& range, Surface_file& vertices, Surface_file& others)
{
  if(element.name == "vertex")
    read_vertices(body, element, destination, range, vertices);
  else if(element.name == "edge")
    read_edges(body, element, range, others);
  else
    read_others(body, element, range, others);
}

// Reads an element that has properties.
void read_element(Body& body, const Element& element, const std::string& name,
                  Surface_file& surface)
{
  body.expect(element);
  Vertex_properties destination;
  if(element.name == "vertex")
  {
    destination = prepare_vertices(element, name, surface);
    if(body.encoding() != Encoding::ascii && has_rows(element))
      return read_rows(body, element, destination, surface);
  }
  if(element.name == "face")
  {
    surface.corners.reserve(std::min(3 * element.count, body.size()));
    surface.polygon_begin.reserve(element.count + 1);
  }
  read_items(body, element, destination, {0, element.count}, surface, surface);
}

// Returns the elements whose items occupy bytes. The number of the others cannot be validated.
std::vector<Element> elements_with_properties(const Header& header)
{
  std::vector<Element> result;
  for(const Element& element : header.elements)
    if(!element.properties.empty())
      result.push_back(element);
  return result;
}

// Reads all elements. Vertices must not be declared twice.
void read_elements(Body& body, const std::vector<Element>& elements, const std::string& name,
                   Surface_file& surface)
{
  bool has_vertices = false;
  for(const Element& element : elements)
  {
    if(element.name == "vertex" && std::exchange(has_vertices, true))
    {
      body.expect(element);
      fail(name, "the element 'vertex' is declared twice");
    }
    read_element(body, element, name, surface);
  }
}

} // namespace

Surface_file read_ply(std::string_view bytes, const std::string& name)
{
  const Header header = Header_reader(bytes, name).read();
  Body body(bytes.substr(header.size), header.encoding, name);
  Surface_file surface;
  read_elements(body, elements_with_properties(header), name, surface);
  return surface;
}

namespace {

// Reads the chunks of a text if each item is one line. Returns false if it is not.
bool read_text_in_parallel(std::string_view text, const std::vector<Element>& elements,
                           const std::string& name, unsigned number_of_threads,
                           Surface_file& surface)
{
  const std::vector<std::string_view> chunks =
      split_lines(text, number_of_chunks(text.size(), number_of_threads));
  if(chunks.size() < 2)
    return false;
  Body body(text, Encoding::ascii, name);
  Vertex_properties destination;
  std::size_t number_of_items = 0;
  bool has_vertices = false;
  for(const Element& element : elements)
  {
    body.expect(element);
    number_of_items += element.count;
    if(element.name != "vertex")
      continue;
    if(std::exchange(has_vertices, true))
      return false;
    destination = prepare_vertices(element, name, surface);
  }
  const std::vector<std::size_t> lines = first_lines(chunks, number_of_threads);
  if(lines.back() < number_of_items)
    return false;
  std::vector<Surface_file> others(chunks.size());
  const auto read_chunk = [&](std::size_t chunk)
  {
    Body chunk_body(chunks[chunk], Encoding::ascii, name, true);
    const std::size_t begin = std::min(lines[chunk], number_of_items),
                      end = std::min(lines[chunk + 1], number_of_items);
    std::size_t first = 0; // item of the element
    for(const Element& element : elements)
    {
      const Item_range range = {std::max(begin, first) - first,
                                std::clamp(end, first, first + element.count) - first};
      read_items(chunk_body, element, destination, range, surface, others[chunk]);
      first += element.count;
    }
    return end == number_of_items || !chunk_body.next_line();
  };
  if(!parse_chunks(chunks.size(), number_of_threads, read_chunk))
    return false;
  append_chunks(surface, others);
  return true;
}

// Reads the vertices and at the same time the other elements, if the vertices come first and their
// size is known. Returns false if it is not.
bool read_binary_in_parallel(std::string_view bytes, Encoding encoding,
                             const std::vector<Element>& elements, const std::string& name,
                             unsigned number_of_threads, Surface_file& surface)
{
  if(number_of_chunks(bytes.size(), number_of_threads) < 2 || elements[0].name != "vertex" ||
     !has_rows(elements[0]))
    return false;
  std::size_t row_size = 0;
  for(const Property& property : elements[0].properties)
    row_size += property.type.size;
  if(elements[0].count > bytes.size() / row_size)
    return false;
  const std::vector<Element> other_elements(elements.begin() + 1, elements.end());
  if(std::any_of(other_elements.begin(), other_elements.end(),
                 [](const Element& element) { return element.name == "vertex"; }))
    return false;
  Surface_file others;
  const auto read_chunk = [&](std::size_t chunk)
  {
    Body body(chunk == 0 ? bytes : bytes.substr(elements[0].count * row_size), encoding, name);
    if(chunk == 0)
      read_element(body, elements[0], name, surface);
    else
      read_elements(body, other_elements, name, others);
    return true;
  };
  if(!parse_chunks(2, number_of_threads, read_chunk))
    return false;
  surface.corners = std::move(others.corners);
  surface.polygon_begin = std::move(others.polygon_begin);
  surface.edges = std::move(others.edges);
  return true;
}

} // namespace

Surface_file read_ply_in_parallel(std::string_view bytes, const std::string& name,
                                  unsigned number_of_threads)
{
  const Header header = Header_reader(bytes, name).read();
  const std::string_view body = bytes.substr(header.size);
  const std::vector<Element> elements = elements_with_properties(header);
  try
  {
    Surface_file surface;
    if(!elements.empty() &&
       (header.encoding == Encoding::ascii
            ? read_text_in_parallel(body, elements, name, number_of_threads, surface)
            : read_binary_in_parallel(body, header.encoding, elements, name, number_of_threads,
                                      surface)))
      return surface;
  }
  catch(const Input_error&) // read_ply() throws the first error.
  {}
  return read_ply(bytes, name);
}

} // namespace program
