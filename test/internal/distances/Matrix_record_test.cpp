// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Matrix_record.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace matrix_record_test {

using CGAL::Geodesic_processing::File_error;
using namespace CGAL::Geodesic_processing::internal;

const Matrix_layout layout = {20, 3, Number_format::float32, 30, 81};
constexpr Matrix_key key = {1, 2};

struct Matrix_record_test : testing::Test
{
  std::string path = (std::filesystem::temp_directory_path() /
                      (std::string("matrix_record_") +
                       testing::UnitTest::GetInstance()->current_test_info()->name()))
                         .string();

  Matrix_record_test() { std::filesystem::remove(path); }
  ~Matrix_record_test() override { std::filesystem::remove(path); }

  std::string content() const
  {
    std::ostringstream result;
    result << std::ifstream(path, std::ios::binary).rdbuf();
    return result.str();
  }
  void set_content(const std::string& text) const { std::ofstream(path, std::ios::binary) << text; }
  // Records tiles of two rows.
  void write_tiles(const std::vector<std::size_t>& tiles) const
  {
    Matrix_record record(path);
    record.begin(layout, key, 2);
    for(const std::size_t tile : tiles)
      record.add(tile);
  }
  // Returns the recorded tiles.
  std::vector<std::size_t> read_tiles() const
  {
    Matrix_record record(path);
    Recorded_tiles tiles;
    EXPECT_TRUE(record.read(layout, key, tiles));
    EXPECT_EQ(tiles.rows_per_tile, 2u);
    EXPECT_EQ(tiles.is_finished.size(), 10u);
    std::vector<std::size_t> result;
    for(std::size_t tile = 0; tile < tiles.is_finished.size(); ++tile)
      if(tiles.is_finished[tile])
        result.push_back(tile);
    return result;
  }
};

using Tiles = std::vector<std::size_t>;

TEST_F(Matrix_record_test, has_recorded_tiles)
{
  write_tiles({3, 0, 7});
  EXPECT_EQ(read_tiles(), (Tiles{0, 3, 7}));
  EXPECT_EQ(content().substr(0, content().find(" tile")),
            "geodesic_distance_matrix rows 30:50 of 81 columns 3 bits 32 surface 0000000000000001 "
            "arguments 0000000000000002");
  write_tiles({});
  EXPECT_EQ(read_tiles(), Tiles{});
  Matrix_record(path).remove();
  EXPECT_FALSE(std::filesystem::exists(path));
}

// The record may end at any byte, and the next tile is recorded there. Steps of three bytes end at
// each position in a line.
TEST_F(Matrix_record_test, ignores_interrupted_writes)
{
  write_tiles({3, 0, 7});
  const std::string text = content();
  const std::size_t first_size = text.find('\n') + 1;
  for(std::size_t size = 0; size < text.size(); size += 3)
  {
    set_content(text.substr(0, size));
    Recorded_tiles tiles;
    const std::size_t number = size < first_size ? 0 : (size - first_size) / 11; // bytes per line
    {
      Matrix_record record(path);
      ASSERT_EQ(record.read(layout, key, tiles), size >= first_size) << size;
      if(size < first_size)
        record.begin(layout, key, 2);
      record.add(9);
    }
    Tiles expected = Tiles{3, 0, 7};
    expected.resize(number);
    expected.push_back(9);
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(read_tiles(), expected) << size;
  }
}

TEST_F(Matrix_record_test, ignores_damaged_lines)
{
  write_tiles({3, 0, 7});
  const std::string text = content();
  const std::size_t first_size = text.find('\n') + 1;
  for(std::size_t i = first_size; i + 1 < text.size(); ++i)
    for(const char c : {'\0', '1', '\n'})
    {
      if(c == text[i])
        continue;
      std::string damaged = text;
      damaged[i] = c;
      set_content(damaged);
      Tiles expected = {3, 0, 7};
      expected.erase(expected.begin() + std::ptrdiff_t((i - first_size) / 11));
      if(text[i] == '\n' && (i - first_size) / 11 < 2) // joins two lines
        expected.erase(expected.begin() + std::ptrdiff_t((i - first_size) / 11));
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(read_tiles(), expected) << i;
    }
  // A line of the record of another matrix.
  std::filesystem::remove(path);
  {
    Matrix_record record(path);
    record.begin(layout, {1, 3}, 2);
    record.add(5);
  }
  const std::string other = content();
  set_content(text + other.substr(other.find('\n') + 1));
  EXPECT_EQ(read_tiles(), (Tiles{0, 3, 7}));
}

TEST_F(Matrix_record_test, rejects_records_of_other_matrices)
{
  write_tiles({3});
  const std::string text = content();
  Recorded_tiles tiles;
  Matrix_layout other = layout;
  ++other.first_row;
  EXPECT_THROW(Matrix_record(path).read(other, key, tiles), File_error);
  EXPECT_THROW(Matrix_record(path).read(layout, {2, 2}, tiles), File_error);
  EXPECT_THROW(Matrix_record(path).read(layout, {1, 1}, tiles), File_error);
  for(const std::string& foreign :
      {std::string("notes\n"), std::string("notes"), "geodesic_distance_matrix\n" + text,
       std::string("\n\n"), std::string(100, '\0')})
  {
    set_content(foreign);
    EXPECT_THROW(Matrix_record(path).read(layout, key, tiles), File_error) << foreign;
    EXPECT_EQ(content(), foreign);
  }
}

TEST_F(Matrix_record_test, is_locked_while_it_exists)
{
  std::unique_ptr<Matrix_record> record = std::make_unique<Matrix_record>(path);
  EXPECT_THROW(Matrix_record{path}, File_error);
  record->remove();
  EXPECT_NO_THROW(Matrix_record{path}); // another file of the same name
  record.reset();
  EXPECT_NO_THROW(Matrix_record{path});
}

} // namespace matrix_record_test
