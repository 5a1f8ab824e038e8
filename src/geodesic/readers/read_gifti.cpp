// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/Surface_file.h"
#include "readers/Xml.h"
#include "readers/append_polygon.h"
#include "readers/arrays.h"
#include "readers/base64.h"
#include "readers/decompress.h"
#include "readers/read_bytes.h"

#include <algorithm>
#include <utility>

namespace program {

namespace {

// Reads the arrays of points and triangles. Coordinates are not transformed to another space.
class Gifti_reader
{
public:
  Gifti_reader(std::string_view bytes, const std::string& name) : m_xml(bytes, name), m_name(name)
  {}

  Surface_file read()
  {
    bool is_gifti = false;
    Tag array; // the open data array
    while(const std::optional<Tag> tag = m_xml.next())
    {
      is_gifti = is_gifti || tag->name == "GIFTI";
      if(tag->name == "DataArray")
        array = *tag;
      else if(tag->name == "Data")
        read_data(array, *tag);
    }
    if(!is_gifti)
      fail(m_name, "it is not a GIFTI file");
    return std::move(m_surface);
  }

private:
  void read_data(const Tag& array, const Tag& data)
  {
    const std::string_view intent = array["Intent"];
    if(intent != "NIFTI_INTENT_POINTSET" && intent != "NIFTI_INTENT_TRIANGLE")
      return;
    std::string_view text;
    if(!data.is_self_closing)
    {
      if(!m_xml.next())
        fail(m_name, "a data array is truncated");
      text = m_xml.text();
    }
    const bool are_points = intent == "NIFTI_INTENT_POINTSET";
    if(std::exchange(are_points ? m_has_points : m_has_triangles, true))
      fail(m_name, "it has several surfaces, only one is supported");
    const std::vector<Point> rows = to_rows(array, text);
    if(are_points)
      m_surface.points = rows;
    else
      for(const Point& triangle : rows)
      {
        for(const double corner : triangle)
          append_corner(m_surface, corner);
        end_polygon(m_surface);
      }
  }

  // Returns the rows of an array with three columns.
  std::vector<Point> to_rows(const Tag& array, std::string_view text) const
  {
    const std::optional<long long> number = to_integer(array["Dim0"]);
    if(array["Dimensionality"] != "2" || array["Dim1"] != "3" || !number || *number < 0)
      fail(m_name, "its points or triangles are not an array with three columns");
    const std::size_t rows = static_cast<std::size_t>(*number);
    const std::vector<double> values = numbers(array, text, rows);
    if(values.size() % 3 != 0 || values.size() / 3 != rows)
      fail(m_name, "a data array has " + std::to_string(values.size()) + " numbers instead of " +
                       std::to_string(rows) + " rows of three");
    if(array["ArrayIndexingOrder"] != "ColumnMajorOrder")
      return to_points(values);
    std::vector<Point> result(rows);
    for(std::size_t i = 0; i < rows; ++i)
      result[i] = {values[i], values[i + rows], values[i + 2 * rows]};
    return result;
  }

  std::vector<double> numbers(const Tag& array, std::string_view text, std::size_t rows) const
  {
    const std::string_view encoding = array["Encoding"], byte_order = array["Endian"];
    // The second names were written by old versions of nibabel.
    const bool is_compressed = encoding == "GZipBase64Binary" || encoding == "GIFTI_ENCODING_B64GZ";
    const bool is_base64 =
        is_compressed || encoding == "Base64Binary" || encoding == "GIFTI_ENCODING_B64BIN";
    if(encoding == "ASCII" || encoding == "GIFTI_ENCODING_ASCII")
      return numbers_in_text(text, m_name);
    std::string bytes;
    if(is_base64)
    {
      const std::optional<std::string> decoded = from_base64(text);
      if(!decoded)
        fail(m_name, "a data array is not valid base64");
      bytes = is_compressed ? inflate(*decoded, m_name) : *decoded;
    }
    else if(encoding == "ExternalFileBinary" || encoding == "GIFTI_ENCODING_EXTBIN")
      bytes = external_bytes(array, rows);
    else
      fail(m_name, "the encoding '" + printable(encoding) + "' is unknown");
    return decode_numbers(bytes, type(array["DataType"]),
                          byte_order == "BigEndian" || byte_order == "GIFTI_ENDIAN_BIG");
  }

  // Returns the bytes of an array in another file.
  std::string external_bytes(const Tag& array, std::size_t rows) const
  {
    const Bytes file = read_referenced_bytes(m_name, std::string(array["ExternalFileName"]));
    const std::string_view bytes = file;
    const std::optional<long long> offset = to_integer(array["ExternalFileOffset"]);
    if(!offset || *offset < 0 || static_cast<unsigned long long>(*offset) > bytes.size())
      fail(m_name, "the offset of a data array is missing or out of range");
    const std::size_t max_rows = bytes.size() / 3;
    return std::string(bytes.substr(static_cast<std::size_t>(*offset),
                                    3 * type(array["DataType"]).size * std::min(rows, max_rows)));
  }

  Number_type type(std::string_view word) const
  {
    static const std::map<std::string_view, Number_type> types = {
        {"NIFTI_TYPE_INT8", {'i', 1}},    {"NIFTI_TYPE_UINT8", {'u', 1}},
        {"NIFTI_TYPE_INT16", {'i', 2}},   {"NIFTI_TYPE_UINT16", {'u', 2}},
        {"NIFTI_TYPE_INT32", {'i', 4}},   {"NIFTI_TYPE_UINT32", {'u', 4}},
        {"NIFTI_TYPE_INT64", {'i', 8}},   {"NIFTI_TYPE_UINT64", {'u', 8}},
        {"NIFTI_TYPE_FLOAT32", {'f', 4}}, {"NIFTI_TYPE_FLOAT64", {'f', 8}}};
    const auto found = types.find(word);
    if(found == types.end())
      fail(m_name, "the type '" + printable(word) + "' is unknown");
    return found->second;
  }

  Xml m_xml;
  std::string m_name;
  Surface_file m_surface;
  bool m_has_points = false, m_has_triangles = false;
};

} // namespace

Surface_file read_gifti(std::string_view bytes, const std::string& name)
{
  return Gifti_reader(bytes, name).read();
}

} // namespace program
