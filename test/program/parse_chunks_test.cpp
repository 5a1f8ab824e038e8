// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/parse_chunks.h"
#include "readers/Input_error.h"
#include "readers/Surface_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <unistd.h>

namespace parse_chunks_test {

using program::Surface_file;

TEST(Parse_chunks, chunks_are_lines_and_form_the_text)
{
  std::string text = "a\nbb\n\nccc\r\nd";
  for(std::size_t count = 1; count < 9; ++count)
  {
    std::string joined;
    for(const std::string_view chunk : program::split_lines(text, count))
    {
      EXPECT_TRUE(joined.empty() || joined.back() == '\n');
      joined += chunk;
    }
    EXPECT_EQ(joined, text);
    EXPECT_LE(program::split_lines(text, count).size(), count);
  }
  EXPECT_EQ(program::number_of_chunks(std::size_t{3} << 20, 1), 1u);
  EXPECT_EQ(program::number_of_chunks(std::size_t{3} << 20, 2), 3u);
  EXPECT_EQ(program::number_of_chunks(std::size_t{30} << 20, 2), 8u);
}

TEST(Parse_chunks, exceptions_and_rejections_are_reported)
{
  for(const unsigned threads : {1u, 2u, 8u})
  {
    std::vector<int> number_of_calls(5, 0);
    EXPECT_TRUE(program::parse_chunks(5, threads,
                                      [&](std::size_t i) { return ++number_of_calls[i] == 1; }));
    EXPECT_EQ(number_of_calls, std::vector<int>(5, 1));
    EXPECT_FALSE(program::parse_chunks(3, threads, [](std::size_t i) { return i != 2; }));
  }
  const auto parse_or_throw = [](std::size_t i)
  {
    if(i == 1)
      throw std::runtime_error("failed");
    return true;
  };
  EXPECT_FALSE(program::parse_chunks(3, 2, parse_or_throw));
}

// The content of a file, or the error message.
struct Result
{
  Surface_file surface;
  std::string error;
};

Result read(const std::string& filename, unsigned number_of_threads)
{
  try
  {
    return {program::read_surface_file(filename, {}, number_of_threads), ""};
  }
  catch(const program::Input_error& error)
  {
    return {{}, error.what()};
  }
}

// Compares the results of several threads with those of one. The text has more than 2^21
// bytes. Other processes run other tests, so that the file has the name of the test.
void expect_equal_results(const std::string& extension, const std::string& text)
{
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name(),
                    filename = testing::TempDir() + test + std::to_string(getpid()) + extension;
  std::ofstream(filename, std::ios::binary) << text;
  const Result expected = read(filename, 1);
  for(const unsigned number_of_threads : {2u, 5u})
  {
    const Result result = read(filename, number_of_threads);
    EXPECT_EQ(result.error, expected.error);
    EXPECT_TRUE(result.surface.points == expected.surface.points);
    EXPECT_TRUE(result.surface.normals == expected.surface.normals);
    EXPECT_TRUE(result.surface.corners == expected.surface.corners);
    EXPECT_TRUE(result.surface.polygon_begin == expected.surface.polygon_begin);
    EXPECT_TRUE(result.surface.uv == expected.surface.uv);
    EXPECT_TRUE(result.surface.edges == expected.surface.edges);
    EXPECT_TRUE(result.surface.properties == expected.surface.properties);
  }
  std::filesystem::remove(filename);
}

// Returns a text with this line in the middle of many copies of others.
std::string text_with(const std::string& line, const std::string& others)
{
  std::string copies;
  while(copies.size() < 1100000)
    copies += others;
  return copies + line + copies;
}

TEST(Read_with_threads, obj_does_not_depend_on_their_number)
{
  const std::string triangle = "v 1.5 2 3\nv -1 0 1e-3\nv 0 0 1\nf 1 2 3\n",
                    with_uv = "v 1 2 3\nvt 0 1\nvt .5 .25\nf 1/1 1/2 1/1\n",
                    with_colors = "v 1 2 3 0 .5 1\nf 1 1 1\n";
  for(const char* line : {"", "\r\n", "f -1 -2 -3\n", "f 1 2 \\\n3\n", "f 1//1 2//1 3//1\n",
                          "f 0 1 2\n", "v 0 nan 0\n", "v 1 2 3 1 0 0\n"})
    expect_equal_results(".obj", text_with(line, triangle));
  for(const char* line : {"", "f 1/-1 1/-2 1/1\n", "f 1 1 1\n"})
    expect_equal_results(".obj", text_with(line, with_uv));
  expect_equal_results(".obj", text_with("", with_colors));
}

TEST(Read_with_threads, xyz_does_not_depend_on_their_number)
{
  for(const char* others : {"1.5 2 3\n-1 0 1e-3\n", "1, 2, 3, 0, 0, 1\r\n"})
    for(const char* line : {"", "# comment\n", "5\n", "1 2 3 4 5\n"})
      expect_equal_results(".xyz", text_with(line, others));
  expect_equal_results(".xyz", "7\n" + text_with("", "1 2 3\n"));
}

// Returns a number of copies of a line, with another line in the middle of them.
std::string lines_with(const std::string& line, std::size_t number, const std::string& others)
{
  std::string result;
  for(std::size_t i = 0; i < number; ++i)
    result += (i == number / 2 ? line : "") + others;
  return result;
}

TEST(Read_with_threads, ascii_stl_does_not_depend_on_their_number)
{
  // Different vertices, because a chunk must continue the numbers of the one before.
  std::string facets;
  for(int i = 0; i < 4000; ++i)
  {
    const std::string x = std::to_string(i % 1000), y = std::to_string(i / 1000);
    facets += "facet normal 0 0 1\nouter loop\nvertex " + x + " " + y + " 0\nvertex " + x +
              ".5 0 1e-3\nvertex 7 " + y + ".25 -0\nendloop\nendfacet\n";
  }
  const std::string triangle = "outer loop\nvertex 1 2 3\nvertex 4 5 6\nvertex 7 8 9\nendloop\n";
  // Nothing, a new solid, a line with all words, a polygon, carriage returns, errors.
  for(const std::string& line :
      {std::string(), std::string("endsolid\nsolid vertex endloop\n"),
       std::string("outer loop vertex 1 2 3 vertex 4 5 6 vertex 1 1 1 endloop\n"),
       std::string("outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n"),
       "\r" + triangle, std::string("vertex 1 2\n"), std::string("endloop\n"),
       std::string("vertex 1 2 3\nendloop\n"), std::string("vertex 1 2 nan\n"),
       std::string("vertex 1 2 3\n")})
    expect_equal_results(".stl", "solid\n" + text_with(line, facets) + "endsolid\n");
  expect_equal_results(".stl", "solid\n" + text_with("", facets) + "vertex 1 2 3\n");
}

TEST(Read_with_threads, off_does_not_depend_on_their_number)
{
  const std::string header = "OFF # comment\n# comment\n\n150000 150000 0\n",
                    vertices = lines_with("", 150000, "1.5 2.25 3.125\n"),
                    faces = lines_with("", 150000, "3 0 149999 77 255 0 0\n");
  expect_equal_results(".off", header + vertices + faces);
  expect_equal_results(".off", header + vertices + faces + "2 0 1\n# the end");
  expect_equal_results(".off", header + vertices); // faces are missing
  // A comment or an empty line, a face with a missing index or an invalid one, two faces.
  for(const char* line :
      {"# comment\n", "\r\n", "3 0 1\n", "3 0 1 150000\n", "3 0 1 2\r3 0 1 2\r\n", "4 0 1 2 3\n"})
    expect_equal_results(".off", header + vertices + lines_with(line, 149999, "3 0 149999 77\n"));
  for(const char* line : {"# comment\n", "1 2 x\n", "1 2 3\r\n"})
    expect_equal_results(".off", header + lines_with(line, 149999, "1.5 2.25 3.125\n") + faces);
  // The header is longer than a chunk.
  expect_equal_results(".off", "OFF\n" + text_with("", "# comment\n") + "1 0 0\n1 2 3\n");
}

std::string ply_header(const std::string& format)
{
  return "ply\nformat " + format +
         " 1.0\nelement vertex 100000\nproperty float x\nproperty float y\nproperty float z\n"
         "property uchar red\nelement face 100000\nproperty list uchar int vertex_indices\n"
         "element edge 100000\nproperty int vertex1\nproperty int vertex2\nend_header\n";
}

TEST(Read_with_threads, ascii_ply_does_not_depend_on_their_number)
{
  const std::string vertices = lines_with("", 100000, "1.5 2.25 3.125 9\n"),
                    faces = lines_with("", 100000, "3 0 99999 77\n"),
                    edges = lines_with("", 100000, "7 -1\n"), header = ply_header("ascii");
  expect_equal_results(".ply", header + vertices + faces + edges);
  expect_equal_results(".ply", header + vertices + faces + edges + "1 2 3\n");
  expect_equal_results(".ply", header + vertices + faces);
  // An empty line, an item on two lines, two items on a line, an invalid number, a long list.
  for(const char* line : {"\n", "3 0\n1 2\n", "3 0 1 2 3 0 1 2\n", "3 0 1 2\r3 0 1 2\r\n",
                          "3 0 1 x\n", "9999999 1\n", "4 0 1 2 3\n"})
    expect_equal_results(".ply",
                         header + vertices + lines_with(line, 99999, "3 0 99999 77\n") + edges);
  for(const char* line : {"1 2 3 x\n", "1 2 3\n4\n", "1e9 inf 7 0\r\n"})
    expect_equal_results(".ply",
                         header + lines_with(line, 99999, "1.5 2.25 3.125 9\n") + faces + edges);
}

TEST(Read_with_threads, binary_ply_does_not_depend_on_their_number)
{
  const std::string vertex("abcdefghijklm", 13), triangle("\3\1\0\0\0\2\0\0\0\3\0\0\0", 13),
      edge("\1\0\0\0\2\0\0\0", 8);
  for(const char* format : {"binary_little_endian", "binary_big_endian"})
  {
    const std::string header = ply_header(format), vertices = lines_with("", 100000, vertex),
                      edges = lines_with("", 100000, edge);
    expect_equal_results(".ply", header + vertices + lines_with("", 100000, triangle) + edges);
    expect_equal_results(".ply", header + vertices +
                                     lines_with(std::string("\1\0\0\0\0", 5), 99999, triangle) +
                                     edges);
    expect_equal_results(".ply", header + vertices + lines_with("", 100000, triangle));
  }
}

} // namespace parse_chunks_test
