// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/Surface_file.h"
#include "readers/Xml.h"
#include "readers/append_polygon.h"
#include "readers/arrays.h"
#include "readers/base64.h"
#include "readers/decompress.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace program {

namespace {

// Encoding of the data arrays of a file.
struct Storage
{
  bool big_endian = false;
  std::size_t header_size = 4; // bytes of an integer in the header of an array
  std::string_view compressor; // empty if the arrays are not compressed
  std::string_view appended;   // the bytes after the underscore
  bool is_appended_raw = true;
};

Number_type parse_type(std::string_view type, const std::string& name)
{
  const char kind = type.substr(0, 5) == "Float" ? 'f' : type.substr(0, 4) == "UInt" ? 'u' : 'i';
  const std::string_view width = type.substr(kind == 'f'                  ? 5
                                             : kind == 'u'                ? 4
                                             : type.substr(0, 3) == "Int" ? 3
                                                                          : 0);
  const std::size_t size = width == "8"    ? 1
                           : width == "16" ? 2
                           : width == "32" ? 4
                           : width == "64" ? 8
                                           : 0;
  if(size == 0 || (kind == 'f' && size < 4))
    fail(name, "the type '" + printable(type) + "' is unknown");
  return {kind, size};
}

// Returns the integer at an index of the header of a data array.
std::uint64_t header_at(std::string_view bytes, std::size_t index, const Storage& storage,
                        const std::string& name)
{
  if(bytes.size() / storage.header_size <= index)
    fail(name, "a data array is truncated");
  return bits_at(bytes.substr(index * storage.header_size), storage.header_size,
                 storage.big_endian);
}

// The header of a compressed data array: the number of blocks, the length of each block, the length
// of the last block (0 if it has the same length), and the compressed lengths.
struct Compressed_header
{
  std::vector<std::size_t> lengths;            // of each block
  std::vector<std::size_t> compressed_lengths; // of each block
  std::size_t size = 0;                        // bytes of this header
  std::size_t compressed_size = 0;             // sum of the compressed lengths
};

// Returns the number of bytes of the header of a compressed data array.
std::size_t compressed_header_size(std::string_view bytes, std::size_t available,
                                   const Storage& storage, const std::string& name)
{
  const std::uint64_t number = header_at(bytes, 0, storage, name);
  if(number > available / storage.header_size)
    fail(name, "a data array is truncated");
  return number == 0 ? storage.header_size
                     : (3 + static_cast<std::size_t>(number)) * storage.header_size;
}

Compressed_header read_compressed_header(std::string_view bytes, const Storage& storage,
                                         const std::string& name)
{
  Compressed_header result;
  result.size = compressed_header_size(bytes, bytes.size(), storage, name);
  const std::size_t number = result.size / storage.header_size;
  for(std::size_t i = 3; i < number; ++i)
  {
    const std::uint64_t last = header_at(bytes, 2, storage, name);
    const bool is_partial = i + 1 == number && last > 0;
    result.lengths.push_back(
        static_cast<std::size_t>(is_partial ? last : header_at(bytes, 1, storage, name)));
    const std::uint64_t length = header_at(bytes, i, storage, name);
    if(length > (std::numeric_limits<std::uint32_t>::max)())
      fail(name, "a data array is truncated");
    result.compressed_lengths.push_back(static_cast<std::size_t>(length));
    result.compressed_size += static_cast<std::size_t>(length);
  }
  return result;
}

// Decompresses the blocks of a data array.
std::string decompress_blocks(std::string_view bytes, const Storage& storage,
                              const std::string& name)
{
  std::string result;
  if(bytes.empty())
    return result;
  const Compressed_header header = read_compressed_header(bytes, storage, name);
  bytes.remove_prefix(header.size);
  for(std::size_t i = 0; i < header.lengths.size(); ++i)
  {
    const std::size_t length = header.compressed_lengths[i];
    if(length > bytes.size())
      fail(name, "a data array is truncated");
    const std::string_view block = bytes.substr(0, length);
    result += storage.compressor == "vtkLZ4DataCompressor"
                  ? decompress_lz4(block, header.lengths[i], name)
                  : inflate(block, name);
    bytes.remove_prefix(length);
  }
  return result;
}

// Returns the data of a block, which is preceded by its length in bytes.
std::string_view read_block(std::string_view bytes, const Storage& storage, const std::string& name)
{
  if(bytes.empty())
    return {};
  const std::uint64_t length = header_at(bytes, 0, storage, name);
  bytes.remove_prefix(storage.header_size);
  if(length > bytes.size())
    fail(name, "a data array is truncated");
  return bytes.substr(0, static_cast<std::size_t>(length));
}

// Decodes the bytes of a data array with its header.
std::vector<double> numbers_in_bytes(std::string_view bytes, std::string_view type,
                                     const Storage& storage, const std::string& name)
{
  if(storage.compressor.empty())
    return decode_numbers(read_block(bytes, storage, name), parse_type(type, name),
                          storage.big_endian);
  return decode_numbers(decompress_blocks(bytes, storage, name), parse_type(type, name),
                        storage.big_endian);
}

// Decodes a base64 block. VTK encodes the length together with the data, or separately with
// padding.
std::vector<double> numbers_in_base64(std::string_view text, std::string_view type,
                                      const Storage& storage, const std::string& name)
{
  const std::optional<std::string> bytes = from_base64(text);
  if(!bytes)
    fail(name, "a data array is not valid base64");
  return numbers_in_bytes(*bytes, type, storage, name);
}

// Returns the first bytes of a base64 text.
std::string decode_header(std::string_view text, std::size_t size, const std::string& name)
{
  const std::optional<std::string> bytes = from_base64(text.substr(0, base64_length(size)));
  if(!bytes || bytes->size() < size)
    fail(name, "a data array is not valid base64");
  return *bytes;
}

// Returns the length of a base64 text that begins with the header of a data array. Other arrays
// follow it. The header of compressed data is encoded separately. If that of other data ends with
// padding, it is separate as well.
std::size_t encoded_length(std::string_view text, const Storage& storage, const std::string& name)
{
  const std::string first = decode_header(text, storage.header_size, name);
  if(!storage.compressor.empty())
  {
    const std::size_t size = compressed_header_size(first, text.size(), storage, name);
    const Compressed_header header =
        read_compressed_header(decode_header(text, size, name), storage, name);
    return base64_length(size) + base64_length(header.compressed_size);
  }
  const std::uint64_t length = header_at(first, 0, storage, name);
  if(length > text.size())
    fail(name, "a data array is truncated");
  const std::size_t data_size = static_cast<std::size_t>(length);
  const std::size_t header_length = base64_length(storage.header_size);
  return text[header_length - 1] == '=' ? header_length + base64_length(data_size)
                                        : base64_length(storage.header_size + data_size);
}

std::vector<double> appended_numbers(const Tag& tag, const Storage& storage,
                                     const std::string& name)
{
  const std::optional<long long> offset = to_integer(tag["offset"]);
  if(!offset || *offset < 0 || static_cast<std::size_t>(*offset) > storage.appended.size())
    fail(name, "the offset of a data array is missing or out of range");
  const std::string_view bytes = storage.appended.substr(static_cast<std::size_t>(*offset));
  if(storage.is_appended_raw)
    return numbers_in_bytes(bytes, tag["type"], storage, name);
  return numbers_in_base64(bytes.substr(0, encoded_length(bytes, storage, name)), tag["type"],
                           storage, name);
}

std::vector<double> read_array(const Tag& tag, std::string_view text, const Storage& storage,
                               const std::string& name)
{
  const std::string_view format = tag["format"];
  if(format == "ascii" || format.empty())
    return numbers_in_text(text, name);
  // The header of the file names a compressor even if all arrays are text.
  if(!storage.compressor.empty() && storage.compressor != "vtkZLibDataCompressor" &&
     storage.compressor != "vtkLZ4DataCompressor")
    fail(name, "the compressor '" + printable(storage.compressor) + "' is not supported");
  if(format == "binary")
    return numbers_in_base64(text, tag["type"], storage, name);
  if(format != "appended")
    fail(name, "the format '" + printable(format) + "' of a data array is unknown");
  return appended_numbers(tag, storage, name);
}

using Arrays = std::map<std::string, std::vector<double>>;

const std::vector<double>& require_array(const Arrays& arrays, const std::string& key,
                                         const std::string& name)
{
  const auto found = arrays.find(key);
  if(found == arrays.end())
    fail(name, "its cells have no data array '" + key + "'");
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
      fail(name, "the offsets of its cells are not sorted or out of range");
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

// Moves the appended data from `bytes` to `storage`. They may contain text that resembles tags.
void remove_appended_data(std::string_view& bytes, Storage& storage, const std::string& name)
{
  const std::size_t begin = bytes.find("<AppendedData");
  if(begin == std::string_view::npos)
    return;
  Xml appended(bytes.substr(begin), name);
  const std::optional<Tag> tag = appended.next();
  storage.is_appended_raw = (*tag)["encoding"] != "base64";
  const std::size_t underscore = appended.rest().find('_');
  if(underscore != std::string_view::npos)
    storage.appended = appended.rest().substr(underscore + 1);
  bytes = bytes.substr(0, begin);
}

bool is_section(std::string_view tag)
{
  static constexpr std::string_view sections[] = {"Points", "Polys", "Strips",   "PointData",
                                                  "Verts",  "Lines", "CellData", "FieldData"};
  return std::find(std::begin(sections), std::end(sections), tag) != std::end(sections);
}

class Vtp_reader
{
public:
  Vtp_reader(std::string_view bytes, Storage storage, const std::string& name)
      : m_xml(bytes, name), m_storage(storage), m_name(name)
  {}

  Surface_file read()
  {
    while(const std::optional<Tag> tag = m_xml.next())
      read_tag(*tag);
    if(!m_is_vtp)
      fail(m_name, "it is not a VTP file");
    append_cells(m_surface, m_cells["Polys"], false, m_name);
    append_cells(m_surface, m_cells["Strips"], true, m_name);
    check_sizes();
    return std::move(m_surface);
  }

private:
  void read_tag(const Tag& tag)
  {
    if(tag.name == "VTKFile")
      read_file_attributes(tag);
    else if(tag.name == "Piece" && ++m_number_of_pieces > 1)
      fail(m_name, "it has several pieces, only one is supported");
    else if(is_section(tag.name))
      m_section = tag.is_self_closing ? "" : std::string(tag.name);
    else if(tag.name == "/" + m_section)
      m_section.clear();
    else if(tag.name == "DataArray" && (m_section == "Points" || m_section == "Polys" ||
                                        m_section == "Strips" || m_section == "PointData"))
      read_data_array(tag);
  }

  void read_file_attributes(const Tag& tag)
  {
    m_is_vtp = tag["type"] == "PolyData";
    m_storage.big_endian = tag["byte_order"] == "BigEndian";
    m_storage.header_size = tag["header_type"] == "UInt64" ? 8 : 4;
    m_storage.compressor = tag["compressor"];
  }

  void read_data_array(const Tag& tag)
  {
    std::string_view text;
    if(!tag.is_self_closing)
    {
      m_xml.next();
      text = m_xml.text();
    }
    if(tag["type"] == "String")
      return; // the codes of characters are no values of points
    const std::string key(tag["Name"]);
    const std::string_view components = tag["NumberOfComponents"];
    const auto numbers = [&] { return read_array(tag, text, m_storage, m_name); };
    if(m_section == "Polys" || m_section == "Strips")
      m_cells[m_section][key] = numbers();
    else if(m_section == "Points")
      set_points(numbers());
    else if(components.empty() || components == "1")
      m_surface.properties[key] = numbers();
    else if(components == "3" && key == "Normals")
      m_surface.normals = to_points(numbers());
  }

  void set_points(const std::vector<double>& numbers)
  {
    if(numbers.size() % 3 != 0)
      fail(m_name, "its points do not have three coordinates each");
    m_surface.points = to_points(numbers);
  }

  void check_sizes() const
  {
    if(!m_surface.normals.empty() && m_surface.normals.size() != m_surface.points.size())
      fail(m_name, "the number of normals differs from the number of points");
    for(const auto& [key, values] : m_surface.properties)
      if(values.size() != m_surface.points.size())
        fail(m_name,
             "the number of values of '" + printable(key) + "' differs from the number of points");
  }

  Xml m_xml;
  Storage m_storage;
  std::string m_name;
  Surface_file m_surface;
  bool m_is_vtp = false;
  int m_number_of_pieces = 0;
  std::string m_section; // the open section, or an empty text
  std::map<std::string, Arrays> m_cells;
};

} // namespace

Surface_file read_vtp(std::string_view bytes, const std::string& name)
{
  Storage storage;
  remove_appended_data(bytes, storage, name);
  return Vtp_reader(bytes, storage, name).read();
}

} // namespace program
