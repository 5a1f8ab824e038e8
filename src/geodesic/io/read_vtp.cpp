// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Scanner.h"
#include "io/Surface_file.h"
#include "io/append_polygon.h"
#include "io/base64.h"

#include <cmath>
#include <cstring>

namespace program {

namespace {

struct Tag
{
  std::string_view name; // with a slash if it is a closing tag
  std::map<std::string_view, std::string_view> attributes;
  bool is_self_closing = false; // <Tag/>

  std::string_view operator[](std::string_view attribute) const
  {
    const auto found = attributes.find(attribute);
    return found == attributes.end() ? std::string_view() : found->second;
  }
};

constexpr std::string_view whitespace = " \t\r\n";

// A parser for the subset of XML that VTK writes: tags with quoted attributes, and text between
// them.
class Xml
{
public:
  Xml(std::string_view bytes, const std::string& name) : m_rest(bytes), m_name(name) {}

  // Returns the next tag, or std::nullopt at the end. text() returns the text before the tag.
  std::optional<Tag> next()
  {
    for(;;)
    {
      const std::size_t begin = m_rest.find('<');
      m_text = m_rest.substr(0, begin);
      if(begin == std::string_view::npos)
        return std::nullopt;
      m_rest.remove_prefix(begin);
      const bool is_comment = m_rest.substr(0, 4) == "<!--";
      const std::size_t end = m_rest.find(is_comment ? "-->" : ">");
      if(end == std::string_view::npos)
        fail(m_name, "a tag has no end");
      const std::string_view content = m_rest.substr(1, end - 1);
      m_rest.remove_prefix(end + (is_comment ? 3 : 1));
      if(!is_comment && !content.empty() && content[0] != '?' && content[0] != '!')
        return tag(content);
    }
  }

  std::string_view text() const { return m_text; }
  std::string_view rest() const { return m_rest; }

private:
  Tag tag(std::string_view content)
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
        fail(m_name, "an attribute has no quotes");
      result.attributes[key] = content.substr(1, close - 1);
      content.remove_prefix(close + 1);
    }
    return result;
  }

  std::string_view m_rest;
  std::string_view m_text;
  std::string m_name;
};

// Encoding of the data arrays of a file.
struct Storage
{
  bool big_endian = false;
  std::size_t header_size = 4;
  std::string_view appended; // the bytes after the underscore
  bool is_appended_raw = true;
};

std::uint64_t bits_at(std::string_view bytes, std::size_t size, bool big_endian)
{
  std::uint64_t bits = 0;
  for(std::size_t i = 0; i < size; ++i)
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[i])}
            << (8 * (big_endian ? size - 1 - i : i));
  return bits;
}

std::vector<double> decode_numbers(std::string_view bytes, std::string_view type,
                                   const Storage& storage, const std::string& name)
{
  const bool is_float = type.substr(0, 5) == "Float", is_unsigned = type.substr(0, 4) == "UInt";
  const std::string_view width = type.substr(is_float                     ? 5
                                             : is_unsigned                ? 4
                                             : type.substr(0, 3) == "Int" ? 3
                                                                          : 0);
  const std::size_t size = width == "8"    ? 1
                           : width == "16" ? 2
                           : width == "32" ? 4
                           : width == "64" ? 8
                                           : 0;
  if(size == 0 || (is_float && size < 4))
    fail(name, "the type '" + printable(type) + "' is unknown");
  std::vector<double> numbers(bytes.size() / size);
  for(std::size_t i = 0; i < numbers.size(); ++i)
  {
    const std::uint64_t bits = bits_at(bytes.substr(i * size), size, storage.big_endian);
    if(is_float && size == 4)
    {
      const auto single_bits = static_cast<std::uint32_t>(bits);
      float single;
      std::memcpy(&single, &single_bits, sizeof single);
      numbers[i] = single;
    }
    else if(is_float)
      std::memcpy(&numbers[i], &bits, sizeof bits);
    else if(is_unsigned)
      numbers[i] = static_cast<double>(bits);
    else
    {
      const unsigned unused = static_cast<unsigned>(64 - 8 * size);
      numbers[i] = static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
    }
  }
  return numbers;
}

// Returns the data of a block, which is preceded by its length in bytes.
std::string_view read_block(std::string_view bytes, const Storage& storage, const std::string& name)
{
  if(bytes.empty())
    return {};
  if(bytes.size() < storage.header_size)
    fail(name, "a data array ends too early");
  const std::uint64_t length = bits_at(bytes, storage.header_size, storage.big_endian);
  bytes.remove_prefix(storage.header_size);
  if(length > bytes.size())
    fail(name, "a data array ends too early");
  return bytes.substr(0, static_cast<std::size_t>(length));
}

// Decodes a base64 block. VTK encodes the length together with the data, or separately with
// padding.
std::vector<double> numbers_in_base64(std::string_view text, std::string_view type,
                                      const Storage& storage, const std::string& name)
{
  const std::optional<std::string> bytes = from_base64(text);
  if(!bytes)
    fail(name, "a data array is not base64");
  return decode_numbers(read_block(*bytes, storage, name), type, storage, name);
}

std::vector<double> read_array(const Tag& tag, std::string_view text, const Storage& storage,
                               const std::string& name)
{
  const std::string_view format = tag["format"], type = tag["type"];
  if(format == "ascii" || format.empty())
  {
    std::vector<double> numbers;
    Scanner scanner(text, name, 0);
    for(std::string_view word = scanner.next_word(); !word.empty(); word = scanner.next_word())
    {
      const std::optional<double> number = to_number(word);
      if(!number)
        fail(name, "'" + printable(word) + "' is not a number");
      numbers.push_back(*number);
    }
    return numbers;
  }
  if(format == "binary")
    return numbers_in_base64(text, type, storage, name);
  if(format != "appended")
    fail(name, "the format '" + printable(format) + "' of a data array is unknown");
  const std::optional<long long> offset = to_integer(tag["offset"]);
  if(!offset || *offset < 0 || static_cast<std::size_t>(*offset) > storage.appended.size())
    fail(name, "a data array has no offset within the file");
  const std::string_view bytes = storage.appended.substr(static_cast<std::size_t>(*offset));
  if(storage.is_appended_raw)
    return decode_numbers(read_block(bytes, storage, name), type, storage, name);
  // Encoded blocks are concatenated, so the length of this block is decoded first.
  const std::size_t digits = (storage.header_size + 2) / 3 * 4;
  const std::optional<std::string> header = from_base64(bytes.substr(0, digits));
  if(!header || header->size() < storage.header_size)
    fail(name, "a data array is not base64");
  const std::uint64_t length = bits_at(*header, storage.header_size, storage.big_endian);
  if(length > bytes.size())
    fail(name, "a data array ends too early");
  const std::size_t encoded_length =
      (static_cast<std::size_t>(length) + storage.header_size + 2) / 3 * 4;
  return numbers_in_base64(bytes.substr(0, encoded_length), type, storage, name);
}

using Arrays = std::map<std::string, std::vector<double>>;

const std::vector<double>& require_array(const Arrays& arrays, const std::string& key,
                                         const std::string& name)
{
  const auto found = arrays.find(key);
  if(found == arrays.end())
    fail(name, "its cells have no '" + key + "'");
  return found->second;
}

void append_cells(Surface_file& surface, const Arrays& arrays, bool are_strips,
                  const std::string& name)
{
  if(arrays.empty())
    return;
  const std::vector<double>& corners = require_array(arrays, "connectivity", name);
  std::size_t begin = 0;
  for(const double offset : require_array(arrays, "offsets", name))
  {
    if(!(offset >= static_cast<double>(begin) && offset <= static_cast<double>(corners.size())))
      fail(name, "the offsets of its cells do not fit");
    const auto end = static_cast<std::size_t>(offset);
    const std::vector<double> cell(corners.begin() + static_cast<std::ptrdiff_t>(begin),
                                   corners.begin() + static_cast<std::ptrdiff_t>(end));
    begin = end;
    if(are_strips)
    {
      append_strip(surface, cell);
      continue;
    }
    for(const double corner : cell)
      append_corner(surface, corner);
    end_polygon(surface);
  }
}

std::vector<Point> to_points(const std::vector<double>& numbers)
{
  std::vector<Point> points(numbers.size() / 3);
  for(std::size_t i = 0; i < points.size(); ++i)
    points[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  return points;
}

} // namespace

Surface_file read_vtp(std::string_view bytes, const std::string& name)
{
  Storage storage;
  // Appended bytes may contain text that resembles tags, so they are removed first.
  if(const std::size_t begin = bytes.find("<AppendedData"); begin != std::string_view::npos)
  {
    Xml appended(bytes.substr(begin), name);
    const std::optional<Tag> tag = appended.next();
    storage.is_appended_raw = (*tag)["encoding"] != "base64";
    const std::size_t underscore = appended.rest().find('_');
    if(underscore != std::string_view::npos)
      storage.appended = appended.rest().substr(underscore + 1);
    bytes = bytes.substr(0, begin);
  }

  Surface_file surface;
  Xml xml(bytes, name);
  bool is_vtp = false;
  int pieces = 0;
  std::string section;
  std::map<std::string, Arrays> cells;
  while(const std::optional<Tag> tag = xml.next())
  {
    if(tag->name == "VTKFile")
    {
      is_vtp = (*tag)["type"] == "PolyData";
      storage.big_endian = (*tag)["byte_order"] == "BigEndian";
      storage.header_size = (*tag)["header_type"] == "UInt64" ? 8 : 4;
      if(!(*tag)["compressor"].empty())
        fail(name, "it is a compressed VTP file, only uncompressed ones are read");
    }
    else if(tag->name == "Piece" && ++pieces > 1)
      fail(name, "it has several pieces, only one is read");
    else if(tag->name == "Points" || tag->name == "Polys" || tag->name == "Strips" ||
            tag->name == "PointData" || tag->name == "Verts" || tag->name == "Lines" ||
            tag->name == "CellData" || tag->name == "FieldData")
      section = tag->is_self_closing ? "" : std::string(tag->name);
    else if(tag->name == "/" + section)
      section.clear();
    else if(tag->name == "DataArray" && (section == "Points" || section == "Polys" ||
                                         section == "Strips" || section == "PointData"))
    {
      const Tag array = *tag;
      std::string_view text;
      if(!array.is_self_closing)
      {
        xml.next();
        text = xml.text();
      }
      const std::string key(array["Name"]);
      const std::string_view components = array["NumberOfComponents"];
      if(section == "Polys" || section == "Strips")
        cells[section][key] = read_array(array, text, storage, name);
      else if(section == "Points")
      {
        const std::vector<double> numbers = read_array(array, text, storage, name);
        if(numbers.size() % 3 != 0)
          fail(name, "its points have not three coordinates each");
        surface.points = to_points(numbers);
      }
      else if(components.empty() || components == "1")
        surface.properties[key] = read_array(array, text, storage, name);
      else if(components == "3" && key == "Normals")
        surface.normals = to_points(read_array(array, text, storage, name));
    }
  }
  if(!is_vtp)
    fail(name, "it is not a VTP file");
  append_cells(surface, cells["Polys"], false, name);
  append_cells(surface, cells["Strips"], true, name);
  if(!surface.normals.empty() && surface.normals.size() != surface.points.size())
    fail(name, "it has not as many normals as points");
  for(const auto& [key, values] : surface.properties)
    if(values.size() != surface.points.size())
      fail(name, "it has not as many values of '" + printable(key) + "' as points");
  return surface;
}

} // namespace program
