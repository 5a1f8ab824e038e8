// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_PROGRAM_PROGRAM_H
#define CGAL_GEODESIC_PROCESSING_TEST_PROGRAM_PROGRAM_H

#include "triangulations.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <sys/wait.h>

// Runs the program, whose file is GEODESIC_PROCESSING_PROGRAM.

namespace program_test {

namespace fs = std::filesystem;

// Round-off errors of lengths on the unit square, which are written with 17 digits; measured are
// 9e-16.
constexpr double round_off = 1e-14;

struct Run_result
{
  int code = -1;
  std::string out, err;
};

inline std::string read_file(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Returns a grayscale image as a PNG file. Each row of `rows` is a zero followed by `width` bytes.
inline std::string png(unsigned width, const std::string& rows)
{
  const auto big_endian = [](std::uint32_t x)
  {
    return std::string{static_cast<char>(x >> 24), static_cast<char>(x >> 16),
                       static_cast<char>(x >> 8), static_cast<char>(x)};
  };
  const auto chunk = [&](const std::string& bytes) // chunk name and chunk data
  {
    std::uint32_t crc = ~0u;
    for(const unsigned char byte : bytes)
    {
      crc ^= byte;
      for(int bit = 0; bit < 8; ++bit)
        crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    return big_endian(static_cast<std::uint32_t>(bytes.size() - 4)) + bytes + big_endian(~crc);
  };
  std::uint32_t a = 1, b = 0;
  for(const unsigned char byte : rows)
  {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  // A single uncompressed block.
  const auto size = static_cast<std::uint16_t>(rows.size());
  const auto low = [](unsigned x) { return static_cast<char>(x & 255); };
  const std::string zlib_stream =
      std::string{'\x78', '\x01', '\x01', low(size), low(size >> 8), low(~size), low(~size >> 8)} +
      rows + big_endian(b << 16 | a);
  const auto height = static_cast<std::uint32_t>(rows.size() / (width + 1));
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR" + big_endian(width) + big_endian(height) +
               std::string{'\x08', '\0', '\0', '\0', '\0'}) +
         chunk("IDAT" + zlib_stream) + chunk("IEND");
}

// Provides a new folder with input files. Removes the folder at the end.
class Program : public testing::Test
{
protected:
  Program()
  {
    const testing::TestInfo* const test = testing::UnitTest::GetInstance()->current_test_info();
    m_folder = fs::path(testing::TempDir()) / ("geodesic_" + std::string(test->name()));
    fs::remove_all(m_folder);
    fs::create_directories(m_folder);

    // A unit square with 9 x 9 vertices, diagonals of alternating direction and a vertex property.
    std::ostringstream square;
    square << "ply\nformat ascii 1.0\nelement vertex 81\nproperty double x\nproperty double y\n"
              "property double z\nproperty float double_speed\nelement face 128\n"
              "property list uchar int vertex_indices\nend_header\n";
    for(int j = 0; j < 9; ++j)
      for(int i = 0; i < 9; ++i)
        square << i / 8. << ' ' << j / 8. << " 0 2\n";
    for(int j = 0; j < 8; ++j)
      for(int i = 0; i < 8; ++i)
      {
        const int a = 9 * j + i, b = a + 1, c = a + 10, d = a + 9;
        if((i + j) % 2 == 0)
          square << "3 " << a << ' ' << b << ' ' << c << "\n3 " << a << ' ' << c << ' ' << d
                 << '\n';
        else
          square << "3 " << a << ' ' << b << ' ' << d << "\n3 " << b << ' ' << c << ' ' << d
                 << '\n';
      }
    write("square.ply", square.str());

    write("closed.off",
          "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    write("apart.off",
          "OFF\n7 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 5\n1 0 5\n0 1 5\n9 9 9\n3 0 1 2\n3 3 4 5\n");
    write("quads.off",
          "OFF\n6 2 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n4 0 1 4 3\n4 1 4 5 2\n");
    // Two triangles that share a vertex.
    write("pinched.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n");
    // Two tetrahedra that share a vertex.
    write("bowtie.off", "OFF\n7 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n"
                        "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 0 4 5\n3 0 6 4\n3 4 6 5\n3 5 6 0\n");
    std::ostringstream cloud;
    for(int j = 0; j < 12; ++j)
      for(int i = 0; i < 12; ++i)
        cloud << i / 11. << ' ' << j / 11. << " 0 0 0 1\n";
    write("cloud.xyz", cloud.str());
  }
  ~Program() override { fs::remove_all(m_folder); }

  void write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(m_folder / name, std::ios::binary) << bytes;
  }

  // Runs a command line in the folder. The shell command begins with `prefix`.
  Run_result run(const std::string& arguments, const std::string& prefix = "") const
  {
    const fs::path out = fs::path(m_folder.string() + ".out"), err = m_folder.string() + ".err";
    const std::string redirection =
        arguments.find('>') == std::string::npos ? " >'" + out.string() + "'" : "";
    const int status = std::system(("cd '" + m_folder.string() + "' && " + prefix +
                                    "'" GEODESIC_PROCESSING_PROGRAM "' " + arguments + redirection +
                                    " 2>'" + err.string() + "'")
                                       .c_str());
    Run_result result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(out), read_file(err)};
    fs::remove(out);
    fs::remove(err);
    return result;
  }

  nlohmann::json json(const std::string& arguments) const
  {
    const Run_result result = run(arguments + " --json --quiet");
    EXPECT_EQ(result.code, 0) << arguments << ": " << result.err;
    return nlohmann::json::parse(result.out, nullptr, false);
  }

  std::vector<double> numbers(const std::string& name) const
  {
    std::istringstream stream(read_file(m_folder / name));
    std::vector<double> result;
    for(std::string word; stream >> word;)
      result.push_back(std::strtod(word.c_str(), nullptr));
    return result;
  }

  // Expects the exit code `code` and one error sentence that contains `text`.
  void expect_failure(const std::string& arguments, int code, const std::string& text) const
  {
    const std::size_t files = number_of_files();
    const Run_result result = run(arguments);
    EXPECT_EQ(result.code, code) << arguments;
    EXPECT_EQ(result.out, "") << arguments;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_PRED_FORMAT2(testing::IsSubstring, text, result.err);
    EXPECT_EQ(number_of_files(), files) << arguments << " left a file behind";
  }

  std::size_t number_of_files() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), {}));
  }

  fs::path m_folder;
};

// Returns the lines of a file with the 642 vertices of an icosphere and their normals.
inline std::string ball_cloud()
{
  std::ostringstream lines;
  lines.precision(17);
  for(const auto& p : CGAL::Geodesic_processing::test::icosphere(3).points)
    lines << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[0] << ' ' << p[1] << ' ' << p[2]
          << '\n';
  return lines.str();
}

} // namespace program_test

#endif // CGAL_GEODESIC_PROCESSING_TEST_PROGRAM_PROGRAM_H
