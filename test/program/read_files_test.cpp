// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/Surface.h"
#include "io/errors.h"
#include "io/read_gpw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

namespace read_files_test {

using program::Reader;
using program::Surface_file;

// Returns the reader's error message, or an empty string if the reader accepts the bytes.
std::string error_message(Reader read, const std::string& bytes)
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
  EXPECT_PRED_FORMAT2(testing::IsSubstring, text, error_message(read, bytes));
}

const std::string tetrahedron_off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                    "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

const std::string ply_header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                               "property float y\nproperty float z\n";

void expect_tetrahedron(const Surface_file& surface)
{
  EXPECT_EQ(surface.points,
            (std::vector<program::Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}));
  EXPECT_EQ(surface.polygon_begin, (std::vector<std::size_t>{0, 3, 6, 9, 12}));
}

TEST(Read_off, reads_tetrahedron) { expect_tetrahedron(program::read_off(tetrahedron_off, "")); }

TEST(Read_off, accepts_crlf_comments_and_blank_lines)
{
  std::string bytes = "# first\n\n" + tetrahedron_off + "# last";
  for(std::size_t i = 0; (i = bytes.find('\n', i)) != std::string::npos; i += 2)
    bytes.replace(i, 1, "\r\n");
  expect_tetrahedron(program::read_off(bytes, ""));
}

TEST(Read_off, accepts_commas)
{
  std::string bytes = tetrahedron_off;
  for(std::size_t i = 8; (i = bytes.find(' ', i)) != std::string::npos; i += 2)
    bytes.replace(i, 1, ", ");
  expect_tetrahedron(program::read_off(bytes, ""));
}

TEST(Read_off, reads_normals_and_homogeneous_coordinates)
{
  const Surface_file surface = program::read_off("CN4OFF 1 0 0\n2 4 6 2  0 0 3  255 0 0 255\n", "");
  EXPECT_EQ(surface.points[0], (program::Point{1, 2, 3}));
  EXPECT_EQ(surface.normals[0], (program::Point{0, 0, 3}));
}

TEST(Read_off, reports_errors)
{
  const Reader read = program::read_off;
  expect_error(read, "OFF BINARY\n1 0 0\n", "binary");
  expect_error(read, "GIF89a\n", "not an OFF file");
  expect_error(read, "nOFF\n4\n1 0 0\n", "three dimensions");
  expect_error(read, "OFF\n1000000000000 0 0\n0 0 0\n", "file is too short");
  expect_error(read, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
               "vertex 3, but the number of vertices is 3");
  expect_error(read, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "vertex -1");
  expect_error(read, "OFF\n1 0 0\n0 nan 0\n", "line 3: the coordinate 'nan'");
  expect_error(read, "OFF\n1 0 0\n0 1e999 0\n", "not finite");
  expect_error(read, "OFF\n0 0 0\n", "no points");
  expect_error(read, tetrahedron_off.substr(0, tetrahedron_off.size() - 8),
               "it ends after 3 of 4 faces");
}

TEST(Read_ply, reads_ascii_with_lists_and_unknown_elements)
{
  const Surface_file surface = program::read_ply(
      ply_header + "property double speed\nproperty list uchar int extra\n"
                   "element material 2\nproperty int a\nproperty list int int b\n"
                   "element face 1\nproperty int c\nproperty list uchar int vertex_index\n"
                   "end_header\n0 0 0 1.5 0\n1 0 0 2.5 2 8 9\n0 1 0 inf 1 7\n"
                   "5 1 1\n6 0\n4 3 2 0 1\n",
      "");
  EXPECT_EQ(surface.points[1], (program::Point{1, 0, 0}));
  EXPECT_EQ(surface.properties.at("speed"), (std::vector<double>{1.5, 2.5, INFINITY}));
  EXPECT_EQ(surface.properties.size(), 1u);
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{2, 0, 1}));
}

TEST(Read_ply, reads_indices_in_any_notation)
{
  const std::string header = ply_header +
                             "element face 2\nproperty list uchar int vertex_index\nend_header\n"
                             "0 0 0\n1 0 0\n0 1 0\n";
  constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();
  // In the last two texts, values are not in the lines of their faces.
  for(const char* const faces :
      {"3 2 0 1\n3 -1 4294967296 1\n", "3.0 2.0 +0 1e0\n+3 -1 99999999999999999999 1.0\n",
       "3\n2\n\n0 1 3 -1\n9999999999 1", "3 2 0 1 3 -1 1e300 1"})
  {
    const Surface_file surface = program::read_ply(header + faces, "");
    EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{2, 0, 1, no_vertex, no_vertex, 1}));
    EXPECT_EQ(surface.polygon_begin, (std::vector<std::size_t>{0, 3, 6}));
  }
  for(const char* const faces : {"3 2 0 1\n3 0 1", "3 2 0 1\n", "3 2 0 1\n-3 0 1 2\n",
                                 "3 2 0 1\n2.5 0 1 2\n", "3 2 0 1\n3 0 1 x\n"})
    EXPECT_NE(error_message(program::read_ply, header + faces), "");
}

TEST(Read_ply, reads_all_types_in_both_byte_orders)
{
  const std::string header = "element vertex 1\nproperty double x\nproperty float y\n"
                             "property char z\nproperty uchar a\nproperty short b\n"
                             "property ushort c\nproperty int d\nproperty uint e\nend_header\n";
  // 1.0 as a double, -2.0 as a float, -3, 200, -300, 60000, -70000, 3000000000
  const std::vector<std::string> values = {std::string("\x3f\xf0\0\0\0\0\0\0", 8),
                                           std::string("\xc0\0\0\0", 4),
                                           "\xfd",
                                           "\xc8",
                                           "\xfe\xd4",
                                           "\xea\x60",
                                           "\xff\xfe\xee\x90",
                                           std::string("\xb2\xd0\x5e\0", 4)};
  std::string big, little;
  for(const std::string& value : values)
  {
    big += value;
    little += std::string(value.rbegin(), value.rend());
  }
  for(const Surface_file& surface :
      {program::read_ply("ply\nformat binary_big_endian 1.0\n" + header + big, ""),
       program::read_ply("ply\nformat binary_little_endian 1.0\n" + header + little, "")})
  {
    EXPECT_EQ(surface.points[0], (program::Point{1, -2, -3}));
    EXPECT_EQ(surface.properties.at("a")[0], 200);
    EXPECT_EQ(surface.properties.at("b")[0], -300);
    EXPECT_EQ(surface.properties.at("c")[0], 60000);
    EXPECT_EQ(surface.properties.at("d")[0], -70000);
    EXPECT_EQ(surface.properties.at("e")[0], 3000000000.);
  }
}

TEST(Read_ply, reads_triangle_strips)
{
  const Surface_file surface =
      program::read_ply(ply_header + "element tristrips 1\nproperty list int int vertex_indices\n"
                                     "end_header\n0 0 0\n1 0 0\n0 1 0\n8 0 1 2 0 -1 2 1 0\n",
                        "");
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 0, 2, 1, 0}));
}

TEST(Read_ply, reads_edges)
{
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(program::read_ply(ply_header +
                                  "element edge 2\nproperty int vertex2\n"
                                  "property float length\nproperty int vertex1\n"
                                  "end_header\n" +
                                  body + "0 1.5 2\n1 1 0\n",
                              "")
                .edges,
            (std::vector<std::array<std::uint32_t, 2>>{{2, 0}, {0, 1}}));
  // Edges with other properties are ignored.
  EXPECT_TRUE(program::read_ply(ply_header +
                                    "element edge 1\nproperty int v0\nproperty int v1\n"
                                    "end_header\n" +
                                    body + "0 1\n",
                                "")
                  .edges.empty());
  for(const char* const end : {"3", "-1", "nan", "1e30"})
    expect_error(program::read_ply,
                 ply_header +
                     "element edge 1\nproperty int vertex1\n"
                     "property int vertex2\nend_header\n" +
                     body + "0 " + end + '\n',
                 "an edge refers to vertex");
}

TEST(Read_ply, reports_errors)
{
  const Reader read = program::read_ply;
  const std::string binary = "ply\nformat binary_little_endian 1.0\n";
  expect_error(read, "plyer\n", "not a PLY file");
  expect_error(read, ply_header, "does not end with 'end_header'");
  expect_error(read, "ply\nend_header\n", "no format");
  expect_error(read, "ply\nformat ascii 1.0\nend_header\n", "no points");
  expect_error(read, ply_header + "end_header\n0 0 0\n", "file is too short");
  expect_error(read, ply_header + "end_header\n0.000 0 0 1 1 1 22 nan\n", "it ends unexpectedly");
  expect_error(read, ply_header + "end_header\n0 0 0 1 1 1 2 nan 2\n", "not finite");
  expect_error(read, ply_header + "end_header\n0 0 0 1 1 1 2 two 2\n", "'two' is not a number");
  expect_error(read,
               binary + "element vertex 99999999999\nproperty float x\n"
                        "property float y\nproperty float z\nend_header\n",
               "file is too short");
  expect_error(read,
               binary + "element face 1\nproperty list int int vertex_indices\n"
                        "end_header\n\xff\xff\xff\x7f",
               "longer than the file");
  expect_error(read,
               binary + "element vertex 1\nproperty float x\nproperty list float "
                        "int y\nend_header\n",
               "length of a list");
  expect_error(read,
               ply_header + "element face 1\nproperty list uchar int vertex_indices\n"
                            "end_header\n0 0 0 1 0 0 0 1 0 3 0 1 9\n",
               "vertex 9, but the number of vertices is 3");
}

TEST(Read_obj, reads_slashes_negative_indices_and_polygons)
{
  const Surface_file surface = program::read_obj("# c\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nvt 0 0\nv 1 1 "
                                                 "0\nv 0 1 0\nf 1/1/1 2//1 3/1 4\nf -4 -3 \\\n-2\n",
                                                 "");
  EXPECT_EQ(surface.points.size(), 4u);
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 0, 1, 2}));
  EXPECT_EQ(surface.polygon_begin, (std::vector<std::size_t>{0, 4, 7}));
}

TEST(Read_obj, first_face_defines_texture_coordinates)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  const std::string texture_coordinates = "vt 0 0\nvt 1 0 0\nvt 0.5\nvt 0.25 1\n";
  using Texture_coordinates = std::vector<std::array<double, 2>>;
  EXPECT_EQ(
      program::read_obj(points + texture_coordinates + "f 1/1 2/2 3/3\nf 3/-4 2/1 4/-1/7\n", "").uv,
      (Texture_coordinates{{0., 0.}, {1., 0.}, {0.5, 0.}, {0.25, 1.}}));
  // If a corner has no valid texture coordinates, none are read.
  for(const char* const faces :
      {"f 1/1 2/2 3\n", "f 1/1 2/2 3/9\n", "f 1/1 2/2 3/-9\n", "f 1 2 3\n", "f 1/1 2/2 3//1\n",
       "f 1/1 2/2 3/x\n", "f 1/1 2/2 3/0\n", ""})
    EXPECT_TRUE(program::read_obj(points + texture_coordinates + faces, "").uv.empty()) << faces;
}

TEST(Read_obj, reads_vertex_colors)
{
  using Values = std::vector<double>;
  const auto properties = [](const std::string& text)
  { return program::read_obj(text + "f 1 2 3\n", "").properties; };
  const auto unit_colors =
      properties("v 0 0 0 1 0 0.2\nv 1 0 0 0 0.501961 0\nv 0 1 0 0 0 0.0039216\n");
  EXPECT_EQ(unit_colors.at("red"), (Values{255., 0., 0.}));
  EXPECT_EQ(unit_colors.at("green"), (Values{0., 128., 0.}));
  EXPECT_EQ(unit_colors.at("blue"), (Values{51., 0., 1.}));
  const auto byte_colors = properties("v 0 0 0 255 1 0\nv 1 0 0 3 128 0\nv 0 1 0 0 0 7\n");
  EXPECT_EQ(byte_colors.at("red"), (Values{255., 3., 0.}));
  EXPECT_EQ(byte_colors.at("green"), (Values{1., 128., 0.}));
  // If a vertex has no color, no colors are read. A single additional number is a weight.
  EXPECT_TRUE(properties("v 0 0 0 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\n").empty());
  EXPECT_TRUE(properties("v 0 0 0 1 x 1\nv 1 0 0\nv 0 1 0\n").empty());
}

TEST(Read_obj, reports_errors)
{
  expect_error(program::read_obj, "v 0 0 0\nf 1 2 3\n", "number of vertices is 1");
  expect_error(program::read_obj, "v 0 0 0\nf 0 0 0\n", "line 2");
  expect_error(program::read_obj, "v 0 0 0\nf -2 1 1\n", "line 2");
  expect_error(program::read_obj, "v 0 0\n", "a number is missing");
  expect_error(program::read_obj, "garbage", "no points");
}

TEST(Read_stl, welds_ascii_vertices)
{
  const Surface_file surface = program::read_stl(
      "solid two\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\n"
      "endfacet\nfacet normal 0 0 1\nouter loop\nvertex -0 1 -0\nvertex 1 0 0\nvertex 1 1 0\n"
      "endloop\nendfacet\nendsolid two\n",
      "");
  EXPECT_EQ(surface.points.size(), 4u);
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3}));
}

TEST(Read_stl, reads_facets_with_any_line_ends)
{
  const std::string words[] = {"facet",  "normal", "0", "0", "1",      "outer",   "loop",
                               "vertex", "0",      "0", "0", "vertex", "1",       "0",
                               "0",      "vertex", "0", "1", "0",      "endloop", "endfacet"};
  // A line ends after each of the words at the set bits, except between numbers.
  for(unsigned bits = 0; bits < 64; ++bits)
    for(const std::string line_end : {"\n", "\r", "\r\n"})
    {
      const std::size_t ends[] = {4, 6, 10, 14, 18, 19};
      std::string text = "solid one" + line_end;
      for(std::size_t i = 0; i < std::size(words); ++i)
      {
        const auto end = std::find(std::begin(ends), std::end(ends), i);
        const bool is_end = end != std::end(ends) && (bits >> (end - std::begin(ends)) & 1) != 0;
        text += words[i] + (is_end ? line_end : " ");
      }
      const Surface_file surface = program::read_stl(text + line_end + "endsolid", "");
      EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{0, 1, 2})) << text;
      EXPECT_EQ(surface.points.size(), 3u) << text;
    }
}

TEST(Read_stl, reads_binary_starting_with_solid)
{
  std::string bytes = "solid" + std::string(75, ' ') + std::string("\1\0\0\0", 4);
  const std::string zero(4, '\0'), one("\0\0\x80\x3f", 4);
  for(const std::string& number :
      {zero, zero, one, zero, zero, zero, one, zero, zero, zero, one, zero})
    bytes += number;
  bytes += std::string(2, '\0');
  const Surface_file surface = program::read_stl(bytes, "");
  EXPECT_EQ(surface.points, (std::vector<program::Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_NE(error_message(program::read_stl, "Solid" + bytes.substr(5) + "x"), "");
  EXPECT_NE(error_message(program::read_stl, "not one"), "");
}

TEST(Read_xyz, accepts_separators_and_extra_columns)
{
  const Surface_file surface = program::read_xyz("# c\n0,0, 0\t0 0 2 9\n// c\n1;0;0 0 0 2 9\n", "");
  EXPECT_EQ(surface.points, (std::vector<program::Point>{{0, 0, 0}, {1, 0, 0}}));
  EXPECT_EQ(surface.normals, (std::vector<program::Point>{{0, 0, 2}, {0, 0, 2}}));
}

TEST(Read_xyz, reports_errors)
{
  expect_error(program::read_xyz, "0 0 0\n1 0 0 1\n",
               "line 2: it has 4 numbers, but the previous lines have 3");
  expect_error(program::read_xyz, "0 0\n", "three coordinates");
  expect_error(program::read_xyz, "3\n0 0 0\n", "differs from the number of points");
  expect_error(program::read_xyz, "0 0 x\n", "'x' is not a number");
}

TEST(Read_pwn, reads_both_normal_layouts)
{
  const Surface_file interleaved = program::read_pwn("0 0 0 0 0 1\n1 0 0 0 1 0\n", "");
  const Surface_file separate = program::read_pwn("2\n0 0 0\n1 0 0\n0 0 1\n0 1 0\n", "");
  EXPECT_EQ(interleaved.points, separate.points);
  EXPECT_EQ(interleaved.normals, separate.normals);
  EXPECT_EQ(separate.normals, (std::vector<program::Point>{{0, 0, 1}, {0, 1, 0}}));
}

TEST(Read_vtp, reads_ascii_and_strips)
{
  const Surface_file surface = program::read_vtp(
      "<?xml version=\"1.0\"?><!-- > --><VTKFile type='PolyData'><PolyData><Piece><PointData>"
      "<DataArray Name=\"d\" format=\"ascii\">1 2 3 4</DataArray>"
      "<DataArray type='String' Name=\"s\" format=\"ascii\">65 0</DataArray></PointData>"
      "<Points><DataArray NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 1 1 0"
      "</DataArray></Points><Strips><DataArray Name=\"connectivity\" format=\"ascii\">0 1 2 3"
      "</DataArray><DataArray Name=\"offsets\" format=\"ascii\">4</DataArray></Strips></Piece>"
      "</PolyData></VTKFile>",
      "");
  EXPECT_EQ(surface.properties.at("d"), (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3}));
}

TEST(Read_vtp, reports_errors)
{
  const Reader read = program::read_vtp;
  expect_error(read, "<VTKFile type=\"UnstructuredGrid\">", "not a VTP file");
  expect_error(read, "<VTKFile type=\"PolyData\"><Piece/><Piece/>", "pieces");
  expect_error(read,
               "<VTKFile type=\"PolyData\"><Points><DataArray type=\"Float32\" "
               "format=\"binary\">AQAAAA==?</DataArray>",
               "not valid base64");
  expect_error(read,
               "<VTKFile type=\"PolyData\"><Points><DataArray type=\"Float32\" "
               "format=\"binary\">/////w==</DataArray>",
               "is truncated");
}

TEST(Read_surface_file, error_names_file_and_reason)
{
  const auto error_of = [](const std::string& name)
  {
    try
    {
      program::read_surface_file(name);
    }
    catch(const program::Input_error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string folder = testing::TempDir();
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "nowhere.ply: there is no such",
                      error_of(folder + "nowhere.ply"));
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "not a regular file", error_of(folder));
  std::ofstream(folder + "read_surface_file.doc") << "x";
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "extension must be",
                      error_of(folder + "read_surface_file.doc"));
  std::ofstream(folder + "read_surface_file.off").close();
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "it is empty",
                      error_of(folder + "read_surface_file.off"));
}

// If a valid file is truncated or modified, the reader reports an error or returns valid data.
TEST(Read_files, corrupted_files_are_rejected_or_valid)
{
  const std::map<std::string, Reader> readers = {{"ply", program::read_ply},
                                                 {"off", program::read_off},
                                                 {"obj", program::read_obj},
                                                 {"stl", program::read_stl},
                                                 {"xyz", program::read_xyz},
                                                 {"pwn", program::read_pwn},
                                                 {"vtp", program::read_vtp},
                                                 {"gpw", program::read_gpw},
                                                 {"gltf", program::read_gltf},
                                                 {"gifti", program::read_gifti},
                                                 {"freesurfer", program::read_freesurfer}};
  const std::filesystem::path corpus = GEODESIC_PROCESSING_SOURCE "/test/fuzz/corpus";
  std::size_t files = 0, good = 0, bad = 0;
  for(const auto& entry : std::filesystem::recursive_directory_iterator(corpus))
  {
    // Other folders have no files of a reader.
    const auto found = readers.find(entry.path().parent_path().filename().string());
    if(!entry.is_regular_file() || found == readers.end())
      continue;
    ++files;
    const Reader read = found->second;
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const auto attempt = [&](const std::string& changed)
    {
      try
      {
        const program::Surface surface = program::repair(read(changed, "name"), "name");
        EXPECT_FALSE(surface.file.points.empty());
        EXPECT_EQ(surface.file.corners.size(), 3 * surface.file.number_of_polygons());
        ++good;
      }
      catch(const program::Input_error&)
      {
        ++bad;
      }
    };
    attempt(bytes);
    const std::size_t stride = bytes.size() / 100 + 1;
    for(std::size_t i = 0; i < bytes.size(); i += stride)
    {
      attempt(bytes.substr(0, i));
      std::string changed = bytes;
      changed[i] = static_cast<char>(changed[i] ^ 0x41);
      attempt(changed);
    }
  }
  EXPECT_GE(files, 45u);
  EXPECT_GE(good, files); // at least each unmodified file
  EXPECT_GT(bad, files);
}

} // namespace read_files_test
