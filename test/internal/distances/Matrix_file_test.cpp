// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Matrix_file.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <signal.h>
#include <sys/resource.h>

namespace matrix_file_test {

using CGAL::Geodesic_processing::File_error;
using namespace CGAL::Geodesic_processing::internal;

constexpr std::uint64_t key = 0x0123456789abcdef;

std::string content(const std::string& path)
{
  std::ostringstream result;
  result << std::ifstream(path, std::ios::binary).rdbuf();
  return result.str();
}

void set_content(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

// A folder for files, which is removed at the end.
struct Matrix_file_test : testing::Test
{
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      (std::string("matrix_file_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  std::string path = (folder / "m.npy").string(), record = path + ".tiles";
  Matrix_layout layout = {5, 3, Number_format::float64};

  Matrix_file_test()
  {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  ~Matrix_file_test() override { std::filesystem::remove_all(folder); }

  // The bytes of a tile: entry (i, j) is 10 i + j.
  static std::vector<char> tile_bytes(const Matrix_file& file, std::size_t tile)
  {
    std::vector<char> result;
    for(std::size_t i = file.first_row(tile); i < file.end_row(tile); ++i)
      for(std::size_t j = 0; j < file.layout().columns; ++j)
      {
        const double x = 10. * double(i) + double(j);
        const float single = float(x);
        const bool is_single = file.layout().format == Number_format::float32;
        const char* begin =
            is_single ? reinterpret_cast<const char*>(&single) : reinterpret_cast<const char*>(&x);
        result.insert(result.end(), begin, begin + (is_single ? 4 : 8));
      }
    return result;
  }
  void write_all(const std::string& to)
  {
    Matrix_file file(to, layout, 2 * layout.row_size(), key);
    for(std::size_t tile = 0; tile < file.number_of_tiles(); ++tile)
      file.write(tile, tile_bytes(file, tile));
    file.finish();
  }
  // Returns the message of the exception that opening the file throws.
  std::string open_error(std::uint64_t other_key = key)
  {
    try
    {
      Matrix_file(path, layout, 48, other_key);
    }
    catch(const File_error& error)
    {
      return error.what();
    }
    return "";
  }
};

// The format is specified in the documentation of numpy.lib.format.
TEST_F(Matrix_file_test, has_format_of_numpy)
{
  for(const Number_format format : {Number_format::float32, Number_format::float64})
  {
    layout.format = format;
    write_all(path);
    EXPECT_FALSE(std::filesystem::exists(record));
    const std::string bytes = content(path);
    const std::size_t number_size = format == Number_format::float32 ? 4 : 8;
    ASSERT_GT(bytes.size(), 10u);
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\0", 8));
    const std::size_t header_size = 10 + static_cast<unsigned char>(bytes[8]) +
                                    256 * std::size_t{static_cast<unsigned char>(bytes[9])};
    EXPECT_EQ(header_size % 64, 0u);
    ASSERT_EQ(bytes.size(), header_size + 15 * number_size);
    const std::string header = bytes.substr(10, header_size - 10);
    EXPECT_EQ(header.substr(0, header.find('}') + 1),
              std::string("{'descr': '<f") + (number_size == 4 ? "4" : "8") +
                  "', 'fortran_order': False, 'shape': (5, 3), }");
    EXPECT_EQ(header.back(), '\n');
    for(std::size_t i = 0; i < 5; ++i)
      for(std::size_t j = 0; j < 3; ++j)
      {
        const char* entry = bytes.data() + header_size + (3 * i + j) * number_size;
        float single;
        double number;
        if(number_size == 4)
        {
          std::memcpy(&single, entry, 4);
          number = single;
        }
        else
          std::memcpy(&number, entry, 8);
        EXPECT_EQ(number, 10. * double(i) + double(j));
      }
  }
}

TEST_F(Matrix_file_test, has_tiles_of_whole_rows)
{
  const Matrix_file file(path, layout, 2 * 24 + 23, key), small(path + "2", layout, 1, key);
  ASSERT_EQ(file.number_of_tiles(), 3u);
  EXPECT_EQ(file.first_row(1), 2u);
  EXPECT_EQ(file.end_row(1), 4u);
  EXPECT_EQ(file.end_row(2), 5u);
  EXPECT_EQ(small.number_of_tiles(), 5u);
}

TEST_F(Matrix_file_test, continues_after_recorded_tiles)
{
  write_all(path + ".expected");
  {
    Matrix_file file(path, layout, 48, key);
    file.write(1, tile_bytes(file, 1));
  }
  // A line without an end, from an interrupted write, is no tile.
  std::ofstream(record, std::ios::app) << "0";
  {
    // The size of the tiles is that of the record.
    Matrix_file file(path, layout, 24, key);
    ASSERT_EQ(file.number_of_tiles(), 3u);
    EXPECT_FALSE(file.is_finished(0));
    EXPECT_TRUE(file.is_finished(1));
    file.write(2, tile_bytes(file, 2));
  }
  Matrix_file file(path, layout, 48, key);
  EXPECT_FALSE(file.is_finished(0));
  EXPECT_TRUE(file.is_finished(2));
  file.write(0, tile_bytes(file, 0));
  file.finish();
  EXPECT_FALSE(std::filesystem::exists(record));
  EXPECT_EQ(content(path), content(path + ".expected"));
}

TEST_F(Matrix_file_test, rejects_records_that_do_not_fit)
{
  Matrix_file(path, layout, 48, key);
  EXPECT_EQ(open_error(), "");
  EXPECT_NE(open_error(key + 1).find("belongs to another computation"), std::string::npos);
  const std::string valid_record = content(record);
  set_content(record, valid_record + "3\n");
  EXPECT_NE(open_error().find("'3' is not a tile"), std::string::npos);
  set_content(record, "something else\n");
  EXPECT_NE(open_error().find("it is not a record"), std::string::npos);
  set_content(record, valid_record);
  set_content(path, "short");
  EXPECT_NE(open_error().find("its size is not that of its record"), std::string::npos);
  // A record whose first line was not written completely has no tiles.
  set_content(record, valid_record.substr(0, 20));
  EXPECT_EQ(open_error(), "");
  EXPECT_EQ(content(record), valid_record);
}

TEST_F(Matrix_file_test, names_file_that_cannot_be_written)
{
  path = (folder / "missing" / "m.npy").string();
  EXPECT_NE(open_error().find("it cannot be opened for writing"), std::string::npos);
  path = folder.string();
  EXPECT_NE(open_error().find("it cannot be opened for writing"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_directory(folder));
  path = (folder / "large.npy").string();
  layout = {std::size_t(1) << 30, std::size_t(1) << 25, Number_format::float64};
  EXPECT_NE(open_error().find("but the disk has only"), std::string::npos);
}

// A limit of the size of files stands for a full disk.
TEST_F(Matrix_file_test, reports_full_disk)
{
  rlimit old_limit;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  const auto old_handler = signal(SIGXFSZ, SIG_IGN);
  rlimit limit = old_limit;
  limit.rlim_cur = 4096;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  layout.rows = 1000;
  const std::string error = open_error();
  setrlimit(RLIMIT_FSIZE, &old_limit);
  signal(SIGXFSZ, old_handler);
  EXPECT_NE(error.find("the disk has no space for 24"), std::string::npos) << error;
}

TEST_F(Matrix_file_test, merges_parts)
{
  layout.rows = 5;
  write_all(path + "1");
  layout.rows = 0;
  write_all(path + "2");
  layout.rows = 2;
  write_all(path + "3");
  merge_matrix_files({path + "1", path + "2", path + "3"}, path);
  const std::string first = content(path + "1"), third = content(path + "3"),
                    merged = content(path);
  const std::size_t header_size = first.size() - 5 * 24;
  EXPECT_EQ(merged.substr(header_size), first.substr(header_size) + third.substr(header_size));
  EXPECT_NE(merged.find("'shape': (7, 3)"), std::string::npos);
}

TEST_F(Matrix_file_test, rejects_parts_that_do_not_fit)
{
  const auto error_of = [&](const std::vector<std::string>& parts)
  {
    try
    {
      merge_matrix_files(parts, path);
    }
    catch(const File_error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  write_all(path + "1");
  layout.columns = 4;
  write_all(path + "2");
  Matrix_file(path + "3", layout, 48, key);
  set_content(path + "4", "no matrix");
  set_content(path + "5", content(path + "1").substr(0, 200));
  EXPECT_NE(error_of({path + "1", path + "2"}).find("it has other columns"), std::string::npos);
  EXPECT_NE(error_of({path + "3"}).find("it is not complete"), std::string::npos);
  EXPECT_NE(error_of({path + "4"}).find("it is not a .npy file"), std::string::npos);
  EXPECT_NE(error_of({path + "5"}).find("its size is not"), std::string::npos);
  EXPECT_NE(error_of({path + "6"}).find("it cannot be opened"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path));
  std::filesystem::copy(path + "1", path);
  EXPECT_NE(error_of({path}).find("it is one of the files"), std::string::npos);
  EXPECT_EQ(content(path), content(path + "1"));
}

} // namespace matrix_file_test
