// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/decompress.h"

#include "readers/Surface_file.h"
#include "readers/base64.h"
#include "io/errors.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>

#include <zlib.h>

namespace decompress_test {

using program::Surface_file;

const std::string tetrahedron_off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                    "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

// Compresses by zlib, with 15 window bits, or as a gzip file with 31.
std::string compressed(const std::string& bytes, int window_bits = 15)
{
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, window_bits, 9, Z_DEFAULT_STRATEGY), Z_OK);
  std::string result(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

// Returns the error message of a call, or an empty text if it succeeds.
template <typename Call>
std::string error_of(const Call& call)
{
  try
  {
    call();
    return {};
  }
  catch(const program::Input_error& error)
  {
    return error.what();
  }
}

// Bytes that do not compress well, so that they fill several chunks of the decompression.
std::string mixed_bytes(std::size_t size)
{
  std::string result;
  std::uint32_t state = 1;
  while(result.size() < size)
  {
    state = state * 1664525u + 1013904223u;
    result.append(1 + state % 3, static_cast<char>(state >> 24));
  }
  result.resize(size);
  return result;
}

TEST(Decompress, inflates_zlib_and_gzip)
{
  for(const std::size_t size : {0, 1, 1000, 5000000})
  {
    const std::string bytes = mixed_bytes(size);
    EXPECT_TRUE(program::inflate(compressed(bytes), "") == bytes) << size;
    EXPECT_TRUE(program::inflate(compressed(bytes, 31), "") == bytes) << size;
  }
  EXPECT_EQ(program::inflate(compressed("first, ", 31) + compressed("second", 31), ""),
            "first, second");
}

TEST(Decompress, rejects_truncated_invalid_and_expanding_data)
{
  const std::string bytes = compressed(mixed_bytes(3000));
  for(std::size_t i = 0; i < bytes.size(); i += 7)
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "name: its compressed data are truncated",
                        error_of([&] { program::inflate(bytes.substr(0, i), "name"); }));
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "its compressed data are invalid",
                      error_of([&] { program::inflate("not compressed", "name"); }));
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "its compressed data are invalid",
                      error_of([&] { program::inflate(bytes + "rest", "name"); }));
  EXPECT_PRED_FORMAT2(
      testing::IsSubstring, "expand to more than 1,000 times their length",
      error_of([&] { program::inflate(compressed(std::string(50000000, '\0')), "name"); }));
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "name: its ",
                      error_of([&] { program::decompress_lz4("x", 100, "name"); }));
}

TEST(Decompress, surface_files_can_be_compressed_by_gzip)
{
  const std::string name = testing::TempDir() + "decompress_test.off.GZ";
  std::ofstream(name, std::ios::binary) << compressed(tetrahedron_off, 31);
  const Surface_file surface = program::read_surface_file(name);
  EXPECT_EQ(surface.points, program::read_off(tetrahedron_off, "").points);
  EXPECT_EQ(surface.corners, program::read_off(tetrahedron_off, "").corners);
  std::ofstream(name, std::ios::binary) << tetrahedron_off;
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "decompress_test.off.GZ: its compressed data",
                      error_of([&] { program::read_surface_file(name); }));
}

// ------------------------------------------------------------------------------------------- VTP

// How VTK stores an array.
struct Encoding
{
  std::string format; // binary, raw or base64
  std::size_t header_size;
  std::size_t block_size;
};

template <typename Number>
std::string bytes_of(const std::vector<Number>& numbers)
{
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

// Returns an array as VTK stores it: the header and the compressed blocks.
std::string encoded(const std::string& bytes, const Encoding& encoding)
{
  std::vector<std::uint64_t> numbers = {0, encoding.block_size, bytes.size() % encoding.block_size};
  std::string blocks;
  for(std::size_t i = 0; i < bytes.size(); i += encoding.block_size)
  {
    const std::string block = compressed(bytes.substr(i, encoding.block_size));
    numbers.push_back(block.size());
    ++numbers[0];
    blocks += block;
  }
  if(bytes.empty())
    numbers.resize(1);
  const std::string header =
      encoding.header_size == 8
          ? bytes_of(numbers)
          : bytes_of(std::vector<std::uint32_t>(numbers.begin(), numbers.end()));
  return encoding.format == "raw" ? header + blocks
                                  : program::to_base64(header) + program::to_base64(blocks);
}

// Returns a VTP file of the tetrahedron.
std::string compressed_vtp(const Encoding& encoding)
{
  std::string appended;
  const auto array = [&](const std::string& attributes, const std::string& bytes)
  {
    const std::string data = encoded(bytes, encoding), begin = "<DataArray " + attributes;
    if(encoding.format == "binary")
      return begin + " format=\"binary\">\n" + data + "\n</DataArray>";
    const std::string offset = std::to_string(appended.size());
    appended += data;
    return begin + " format=\"appended\" offset=\"" + offset + "\"/>";
  };
  const std::vector<float> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<std::int64_t> corners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3},
                                  offsets = {3, 6, 9, 12};
  std::string text = "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" header_type=\"UInt" +
                     std::to_string(8 * encoding.header_size) +
                     "\" compressor=\"vtkZLibDataCompressor\"><PolyData><Piece><Points>";
  text += array("type=\"Float32\" NumberOfComponents=\"3\"", bytes_of(points));
  text += "</Points><Strips>" + array("type=\"Int64\" Name=\"connectivity\"", "") +
          array("type=\"Int64\" Name=\"offsets\"", "") + "</Strips><Polys>" +
          array("type=\"Int64\" Name=\"connectivity\"", bytes_of(corners)) +
          array("type=\"Int64\" Name=\"offsets\"", bytes_of(offsets)) +
          "</Polys></Piece></PolyData>";
  if(encoding.format != "binary")
    text += "<AppendedData encoding=\"" + encoding.format + "\">_" + appended + "</AppendedData>";
  return text + "</VTKFile>";
}

TEST(Decompress, reads_all_encodings_of_compressed_vtp)
{
  const Surface_file expected = program::read_off(tetrahedron_off, "");
  for(const char* const format : {"binary", "raw", "base64"})
    for(const std::size_t header_size : {4, 8})
      for(const std::size_t block_size : {7, 24, 32768})
      {
        const Surface_file surface =
            program::read_vtp(compressed_vtp({format, header_size, block_size}), "");
        EXPECT_EQ(surface.points, expected.points);
        EXPECT_EQ(surface.corners, expected.corners);
        EXPECT_EQ(surface.polygon_begin, expected.polygon_begin);
      }
}

TEST(Decompress, compressor_is_ignored_for_text)
{
  const std::string text = "compressor=\"vtkLZMADataCompressor\"><Points><DataArray format=\"";
  const Surface_file surface = program::read_vtp(
      "<VTKFile type=\"PolyData\" " + text + "ascii\">0 0 1</DataArray></Points></VTKFile>", "");
  EXPECT_EQ(surface.points, (std::vector<program::Point>{{0, 0, 1}}));
  EXPECT_PRED_FORMAT2(testing::IsSubstring,
                      "the compressor 'vtkLZMADataCompressor' is not supported",
                      error_of(
                          [&]
                          {
                            program::read_vtp("<VTKFile type=\"PolyData\" " + text +
                                                  "binary\">AAAA</DataArray></Points></VTKFile>",
                                              "");
                          }));
}

TEST(Decompress, truncated_vtp_is_rejected)
{
  for(const char* const format : {"binary", "raw", "base64"})
  {
    const std::string bytes = compressed_vtp({format, 4, 24});
    // The file without its last tags is complete. A file that ends between two arrays is valid.
    const std::size_t end = bytes.rfind(std::string(format) == "binary" ? "</Poly" : "</App");
    for(std::size_t i = bytes.find("<Points>") + 10; i < end; i += 5)
    {
      const std::string error =
          error_of([&] { program::check(program::read_vtp(bytes.substr(0, i), "name"), "name"); });
      // The text before, after and between arrays consists of tags and line feeds.
      const bool is_in_array =
          bytes[i - 1] != '>' && bytes[i - 1] != '\n' && bytes[i] != '<' && bytes[i] != '\n';
      EXPECT_TRUE(error.substr(0, 6) == "name: " || (error.empty() && !is_in_array))
          << format << ' ' << i << ' ' << error;
    }
  }
}

} // namespace decompress_test
