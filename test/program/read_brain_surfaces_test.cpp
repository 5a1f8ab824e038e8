// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Input_error.h"
#include "readers/Surface_file.h"
#include "readers/base64.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include <zlib.h>

// Tests of the readers of GIFTI and FreeSurfer surfaces
namespace read_brain_surfaces_test {

namespace fs = std::filesystem;
using program::Point;
using program::Reader;
using program::Surface_file;

const std::vector<double> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1},
                          corners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};

void expect_tetrahedron(const Surface_file& surface)
{
  EXPECT_EQ(surface.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}));
  EXPECT_EQ(surface.polygon_begin, (std::vector<std::size_t>{0, 3, 6, 9, 12}));
}

std::string error_of(Reader read, const std::string& bytes)
{
  try
  {
    program::check(read(bytes, "name"), "name");
    return {};
  }
  catch(const program::Input_error& error)
  {
    return error.what();
  }
}

void expect_error(Reader read, const std::string& bytes, const std::string& text)
{
  EXPECT_PRED_FORMAT2(testing::IsSubstring, text, error_of(read, bytes));
}

// Appends the lowest `size` bytes of an integer.
void append(std::string& bytes, std::uint64_t bits, std::size_t size, bool big_endian)
{
  for(std::size_t i = 0; i < size; ++i)
    bytes += static_cast<char>(bits >> (8 * (big_endian ? size - 1 - i : i)) & 255u);
}

template <typename Number>
std::string bytes_of(const std::vector<double>& values, bool big_endian)
{
  std::string result;
  for(const double value : values)
  {
    const auto number = static_cast<Number>(value);
    std::conditional_t<sizeof(Number) == 8, std::uint64_t,
                       std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint8_t>>
        bits;
    std::memcpy(&bits, &number, sizeof number);
    append(result, bits, sizeof number, big_endian);
  }
  return result;
}

std::string bytes_of(const std::vector<double>& values, const std::string& type, bool big_endian)
{
  return type == "FLOAT32"   ? bytes_of<float>(values, big_endian)
         : type == "FLOAT64" ? bytes_of<double>(values, big_endian)
         : type == "INT32"   ? bytes_of<std::int32_t>(values, big_endian)
                             : bytes_of<std::uint8_t>(values, big_endian);
}

std::string compressed(const std::string& bytes)
{
  std::string result(compressBound(static_cast<uLong>(bytes.size())), '\0');
  uLongf size = static_cast<uLongf>(result.size());
  EXPECT_EQ(compress(reinterpret_cast<Bytef*>(result.data()), &size,
                     reinterpret_cast<const Bytef*>(bytes.data()),
                     static_cast<uLong>(bytes.size())),
            Z_OK);
  result.resize(size);
  return result;
}

struct Encoding
{
  std::string name = "ASCII", order = "RowMajorOrder", point_type = "FLOAT32",
              corner_type = "INT32";
  bool big_endian = false;
};

std::string gifti_array(const std::vector<double>& rows, const std::string& intent,
                        const std::string& type, const Encoding& encoding)
{
  std::vector<double> values;
  const std::size_t n = rows.size() / 3;
  for(std::size_t i = 0; i < rows.size(); ++i)
    values.push_back(rows[encoding.order == "RowMajorOrder" ? i : i % n * 3 + i / n]);
  std::string data;
  if(encoding.name == "ASCII")
    for(const double value : values)
      data += std::to_string(value) + '\n';
  else
  {
    const std::string bytes = bytes_of(values, type, encoding.big_endian);
    data = program::to_base64(encoding.name == "Base64Binary" ? bytes : compressed(bytes));
  }
  return "<DataArray Intent=\"NIFTI_INTENT_" + intent + "\" DataType=\"NIFTI_TYPE_" + type +
         "\" ArrayIndexingOrder=\"" + encoding.order + "\" Dimensionality=\"2\" Dim0=\"" +
         std::to_string(n) + "\" Dim1=\"3\" Encoding=\"" + encoding.name + "\" Endian=\"" +
         (encoding.big_endian ? "BigEndian" : "LittleEndian") +
         "\"><MetaData><MD><Name><![CDATA[<Data>]]></Name></MD></MetaData><Data>" + data +
         "</Data></DataArray>";
}

std::string gifti(const Encoding& encoding)
{
  return "<?xml version=\"1.0\"?><!DOCTYPE GIFTI SYSTEM \"gifti.dtd\"><GIFTI Version=\"1.0\">" +
         gifti_array({7, 8, 9}, "SHAPE", "FLOAT32", Encoding()) +
         gifti_array(corners, "TRIANGLE", encoding.corner_type, encoding) +
         gifti_array(points, "POINTSET", encoding.point_type, encoding) + "</GIFTI>";
}

TEST(Read_gifti, reads_all_encodings)
{
  for(const char* const name : {"ASCII", "Base64Binary", "GZipBase64Binary"})
    for(const char* const order : {"RowMajorOrder", "ColumnMajorOrder"})
      for(const char* const point_type : {"FLOAT32", "FLOAT64"})
        for(const char* const corner_type : {"INT32", "UINT8"})
          for(const bool big_endian : {false, true})
            expect_tetrahedron(
                program::read_gifti(gifti({name, order, point_type, corner_type, big_endian}), ""));
}

TEST(Read_gifti, reads_arrays_in_another_file)
{
  const fs::path folder = fs::path(testing::TempDir()) / "read_gifti_test";
  fs::create_directories(folder);
  std::ofstream(folder / "a.dat", std::ios::binary)
      << "12345" << bytes_of(points, "FLOAT32", true) << bytes_of(corners, "INT32", true);
  const auto write = [&](const std::string& file, const std::string& offset)
  {
    const std::string begin = "<DataArray Dimensionality=\"2\" Dim0=\"4\" Dim1=\"3\" "
                              "Encoding=\"ExternalFileBinary\" Endian=\"BigEndian\" "
                              "ExternalFileName=\"" +
                              file + "\" ExternalFileOffset=";
    return "<GIFTI>" + begin + '"' + offset +
           "\" Intent=\"NIFTI_INTENT_POINTSET\" DataType=\"NIFTI_TYPE_FLOAT32\"><Data/>"
           "</DataArray>" +
           begin +
           "\"53\" Intent=\"NIFTI_INTENT_TRIANGLE\" DataType=\"NIFTI_TYPE_INT32\"><Data></Data>"
           "</DataArray></GIFTI>";
  };
  const std::string name = (folder / "a.gii").string();
  expect_tetrahedron(program::read_gifti(write("a.dat", "5"), name));
  EXPECT_THROW(program::read_gifti(write("a.dat", "70"), name), program::Input_error);
  EXPECT_THROW(program::read_gifti(write("a.dat", "9999"), name), program::Input_error);
  EXPECT_THROW(program::read_gifti(write("a.dat", "-1"), name), program::Input_error);
  EXPECT_THROW(program::read_gifti(write("../a.dat", "5"), name), program::Input_error);
  fs::remove_all(folder);
}

TEST(Read_gifti, reports_errors)
{
  const Reader read = program::read_gifti;
  const std::string text = gifti({});
  const auto replaced = [&](const std::string& from, const std::string& to)
  {
    std::string result = text;
    return result.replace(result.rfind(from), from.size(), to); // of the points
  };
  expect_error(read, "<VTKFile>", "not a GIFTI file");
  expect_error(read, "<GIFTI></GIFTI>", "no points");
  expect_error(read, replaced("Dim1=\"3\"", "Dim1=\"2\""), "array with three columns");
  expect_error(read, replaced("Dim0=\"4\"", "Dim0=\"5\""), "12 numbers instead of 5 rows");
  expect_error(read, replaced("Dim0=\"4\"", "Dim0=\"9223372036854775807\""), "12 numbers");
  expect_error(read, replaced("ASCII", "Base85"), "the encoding 'Base85' is unknown");
  expect_error(read, replaced("ASCII", "Base64Binary"), "not valid base64");
  expect_error(read, replaced("</GIFTI>", "") + gifti_array(points, "POINTSET", "FLOAT32", {}),
               "several surfaces");
  Encoding binary;
  binary.name = "Base64Binary";
  binary.point_type = "COMPLEX64";
  expect_error(read, gifti(binary), "the type 'NIFTI_TYPE_COMPLEX64' is unknown");
}

TEST(Read_gifti, truncated_files_are_rejected)
{
  for(const char* const name : {"ASCII", "Base64Binary", "GZipBase64Binary"})
  {
    Encoding encoding;
    encoding.name = name;
    const std::string bytes = gifti(encoding);
    for(std::size_t i = 0; i < bytes.rfind("</Data>"); ++i)
      EXPECT_EQ(error_of(program::read_gifti, bytes.substr(0, i)).substr(0, 6), "name: ") << i;
  }
}

// Returns a big-endian FreeSurfer file: the magic number, a text, the counts, points and corners.
std::string freesurfer(const std::string& begin, std::size_t count_size,
                       const std::string& point_bytes, const std::vector<double>& indices)
{
  std::string bytes = begin;
  append(bytes, 4, count_size, true);
  append(bytes, indices.size() / (count_size == 3 ? 4 : 3), count_size, true);
  bytes += point_bytes;
  for(const double index : indices)
    append(bytes, static_cast<std::uint64_t>(index), count_size, true);
  return bytes;
}

std::string freesurfer_triangles()
{
  return freesurfer("\xff\xff\xfe"
                    "created by a test\n\n",
                    4, bytes_of(points, "FLOAT32", true), corners);
}

TEST(Read_freesurfer, reads_triangles_by_content)
{
  const std::string name = testing::TempDir() + "read_freesurfer_test.pial";
  std::ofstream(name, std::ios::binary) << freesurfer_triangles() << "more tags";
  expect_tetrahedron(program::read_surface_file(name));
  fs::remove(name);
}

TEST(Read_freesurfer, splits_quads)
{
  std::string short_points;
  for(const double x : points)
    append(short_points, static_cast<std::uint64_t>(100. * x), 2, true);
  const std::vector<std::uint32_t> expected = {0, 1, 3, 2, 3, 1, 1, 0, 2, 1, 2, 3};
  for(const std::string& bytes :
      {freesurfer("\xff\xff\xff", 3, short_points, {0, 1, 2, 3, 1, 0, 2, 3}),
       freesurfer("\xff\xff\xfd", 3, bytes_of(points, "FLOAT32", true), {0, 1, 2, 3, 1, 0, 2, 3})})
  {
    const Surface_file surface = program::read_freesurfer(bytes, "");
    EXPECT_EQ(surface.points, program::read_freesurfer(freesurfer_triangles(), "").points);
    EXPECT_EQ(surface.corners, expected);
  }
}

TEST(Read_freesurfer, rejects_truncated_files_and_wrong_counts)
{
  const Reader read = program::read_freesurfer;
  for(const std::string& bytes :
      {freesurfer_triangles(),
       freesurfer("\xff\xff\xfd", 3, bytes_of(points, "FLOAT32", true), {0, 1, 2, 3, 1, 0, 2, 3})})
    for(std::size_t i = 0; i < bytes.size(); ++i)
      EXPECT_EQ(error_of(read, bytes.substr(0, i)).substr(0, 6), "name: ") << i;
  expect_error(read, "OFF", "not a FreeSurfer surface");
  expect_error(read, "\xff\xff\xfe\n\n\x7f\xff\xff\xff\x7f\xff\xff\xff", "too short");
  expect_error(read, "\xff\xff\xfe\n\n\xff\xff\xff\xff\x7f\xff\xff\xff", "a count is negative");
  std::string bytes = freesurfer_triangles();
  bytes.back() = 4;
  expect_error(read, bytes, "a face refers to vertex 4");
}

} // namespace read_brain_surfaces_test
