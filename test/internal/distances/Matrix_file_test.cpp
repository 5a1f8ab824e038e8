// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Matrix_file.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace matrix_file_test {

using CGAL::Geodesic_processing::File_error;
using namespace CGAL::Geodesic_processing::internal;

constexpr Matrix_key key = {0x0123456789abcdef, 0xfedcba9876543210};

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
  std::string path = (folder / "m.npy").string(), record = path + ".tiles",
              unfinished = path + ".unfinished";
  Matrix_layout layout = {5, 3, Number_format::float64, 0, 5};

  Matrix_file_test()
  {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  ~Matrix_file_test() override { std::filesystem::remove_all(folder); }

  std::size_t number_of_files() const
  {
    return std::size_t(std::distance(std::filesystem::directory_iterator(folder), {}));
  }
  // The bytes of a tile: entry (i, j) of the whole matrix is 10 i + j.
  static std::vector<char> tile_bytes(const Matrix_file& file, std::size_t tile)
  {
    std::vector<char> result;
    for(std::size_t i = file.first_row(tile); i < file.end_row(tile); ++i)
      for(std::size_t j = 0; j < file.layout().columns; ++j)
      {
        const double x = 10. * double(file.layout().first_row + i) + double(j);
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
  // Writes the rows from `begin` to `end` of the matrix.
  void write_part(const std::string& to, std::size_t begin, std::size_t end)
  {
    layout.first_row = begin;
    layout.rows = end - begin;
    write_all(to);
  }
  // Returns the message of the exception that a function throws.
  template <typename Function>
  static std::string error_of(const Function& function)
  {
    try
    {
      function();
    }
    catch(const File_error& error)
    {
      return error.what();
    }
    return "";
  }
  std::string open_error(const Matrix_key& other_key = key)
  {
    return error_of([&] { Matrix_file(path, layout, 48, other_key); });
  }
  std::string merge_error(const std::vector<std::string>& parts)
  {
    return error_of([&] { merge_matrix_files(parts, path); });
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

// A limit of the size of files stands for a full disk.
struct File_size_limit
{
  explicit File_size_limit(rlim_t size)
  {
    getrlimit(RLIMIT_FSIZE, &old_limit);
    rlimit limit = old_limit;
    limit.rlim_cur = size;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~File_size_limit()
  {
    setrlimit(RLIMIT_FSIZE, &old_limit);
    signal(SIGXFSZ, old_handler);
  }

  rlimit old_limit = {};
  void (*old_handler)(int) = signal(SIGXFSZ, SIG_IGN);
};

// A comment in the header, which Python ignores, has the rows of a part.
TEST_F(Matrix_file_test, part_has_its_rows_in_header)
{
  write_part(path, 2, 4);
  const std::string bytes = content(path);
  EXPECT_NE(bytes.find("'shape': (2, 3), } # from row 2 of 5, surface 0123456789abcdef, "
                       "arguments fedcba9876543210 "),
            std::string::npos);
  EXPECT_EQ((bytes.size() - 2 * 24) % 64, 0u);
}

TEST_F(Matrix_file_test, has_tiles_of_whole_rows)
{
  const Matrix_file file(path, layout, 2 * 24 + 23, key), small(path + "2", layout, 1, key);
  ASSERT_EQ(file.number_of_tiles(), 3u);
  EXPECT_EQ(file.first_row(1), 2u);
  EXPECT_EQ(file.end_row(1), 4u);
  EXPECT_EQ(file.end_row(2), 5u);
  EXPECT_EQ(small.number_of_tiles(), 5u);
  layout.rows = layout.total_rows = 1025;
  const Matrix_file long_file(path + "3", layout, 1 << 20, key);
  ASSERT_EQ(long_file.number_of_tiles(), 2u);
  EXPECT_EQ(long_file.end_row(0), 1024u);
  EXPECT_EQ(long_file.end_row(1), 1025u);
}

TEST_F(Matrix_file_test, has_its_name_only_when_complete)
{
  set_content(path, "old");
  {
    Matrix_file file(path, layout, 48, key);
    for(std::size_t tile = 0; tile < 3; ++tile)
      file.write(tile, tile_bytes(file, tile));
    EXPECT_EQ(content(path), "old");
    EXPECT_EQ(number_of_files(), 3u);
    file.finish();
    EXPECT_EQ(number_of_files(), 1u);
  }
  const std::string complete = content(path);
  EXPECT_EQ(complete.substr(1, 5), "NUMPY");
  {
    Matrix_file file(path, layout, 48, key);
    file.discard();
  }
  EXPECT_EQ(number_of_files(), 1u);
  EXPECT_EQ(content(path), complete);
}

TEST_F(Matrix_file_test, keeps_symbolic_links)
{
  std::filesystem::create_directory(folder / "disk");
  std::filesystem::create_symlink(folder / "disk" / "m.npy", path);
  write_all(path);
  EXPECT_TRUE(std::filesystem::is_symlink(path));
  EXPECT_TRUE(std::filesystem::is_regular_file(folder / "disk" / "m.npy"));
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

// The process ended after the file was renamed, and before the record was removed.
TEST_F(Matrix_file_test, continues_after_renaming)
{
  write_all(path + ".expected");
  {
    Matrix_file file(path, layout, 240, key);
    file.write(0, tile_bytes(file, 0));
  }
  std::filesystem::rename(unfinished, path);
  Matrix_file file(path, layout, 240, key);
  ASSERT_EQ(file.number_of_tiles(), 1u);
  EXPECT_TRUE(file.is_finished(0));
  file.finish();
  EXPECT_FALSE(std::filesystem::exists(record));
  EXPECT_EQ(content(path), content(path + ".expected"));
}

// The process ended while the space was reserved: the file has a part of its size, and the record is
// empty.
TEST_F(Matrix_file_test, begins_anew_after_interrupted_creation)
{
  write_all(path + ".expected");
  for(const std::size_t size : {std::size_t(0), std::size_t(100), std::size_t(128)})
  {
    set_content(unfinished, content(path + ".expected").substr(0, size));
    set_content(record, "");
    write_all(path);
    EXPECT_EQ(content(path), content(path + ".expected"));
    EXPECT_EQ(number_of_files(), 2u);
  }
}

TEST_F(Matrix_file_test, rejects_other_matrices)
{
  Matrix_file(path, layout, 48, key);
  const std::string valid_record = content(record);
  EXPECT_EQ(open_error(), "");
  EXPECT_NE(open_error({key.surface + 1, key.arguments}).find("distances of another surface"),
            std::string::npos);
  const std::string other = "belongs to other rows, columns, numbers or arguments";
  EXPECT_NE(open_error({key.surface, key.arguments + 1}).find(other), std::string::npos);
  const Matrix_layout old_layout = layout;
  for(const Matrix_layout& new_layout : {Matrix_layout{4, 3, Number_format::float64, 0, 5},
                                         Matrix_layout{4, 3, Number_format::float64, 1, 5},
                                         Matrix_layout{5, 4, Number_format::float64, 0, 5},
                                         Matrix_layout{5, 6, Number_format::float32, 0, 5}})
  {
    layout = new_layout;
    EXPECT_NE(open_error().find(other), std::string::npos);
  }
  layout = old_layout;
  EXPECT_EQ(content(record), valid_record);
  set_content(unfinished, "short");
  EXPECT_NE(open_error().find("its size is not that of its record"), std::string::npos);
  std::filesystem::remove(unfinished);
  EXPECT_NE(open_error().find("its size is not that of its record"), std::string::npos);
}

TEST_F(Matrix_file_test, rejects_second_writer)
{
  Matrix_file file(path, layout, 48, key);
  EXPECT_NE(open_error().find("another process is writing this matrix"), std::string::npos);
  file.write(0, tile_bytes(file, 0));
  EXPECT_EQ(number_of_files(), 2u);
}

TEST_F(Matrix_file_test, keeps_foreign_files)
{
  set_content(record, "something else\n");
  EXPECT_NE(open_error().find("it is not a record"), std::string::npos);
  EXPECT_EQ(content(record), "something else\n");
  std::filesystem::remove(record);
  set_content(unfinished, "a letter");
  EXPECT_NE(open_error().find("it exists and is not a .npy file"), std::string::npos);
  EXPECT_EQ(content(unfinished), "a letter");
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(Matrix_file_test, names_file_that_cannot_be_written)
{
  path = (folder / "missing" / "m.npy").string();
  EXPECT_NE(open_error().find("it cannot be opened for writing"), std::string::npos);
  path = folder.string();
  EXPECT_NE(open_error().find("it exists and is not a regular file"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_directory(folder));
  path = (folder / "large.npy").string();
  layout.rows = std::size_t(1) << 30;
  layout.columns = std::size_t(1) << 25;
  EXPECT_NE(open_error().find("but the disk has only"), std::string::npos);
  EXPECT_EQ(number_of_files(), 0u);
}

// Runs in a process of its own, because root may write everywhere.
TEST_F(Matrix_file_test, names_folder_that_cannot_be_written)
{
  std::filesystem::permissions(folder, std::filesystem::perms(0555));
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if(child == 0)
  {
    constexpr uid_t nobody = 65534;
    if(geteuid() == 0 && setuid(nobody) != 0)
      _exit(2);
    _exit(open_error().find("it cannot be opened for writing (Permission denied)") ==
          std::string::npos);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  std::filesystem::permissions(folder, std::filesystem::perms(0755));
}

TEST_F(Matrix_file_test, reports_full_disk_before_computation)
{
  layout.rows = 1000;
  std::string error;
  {
    const File_size_limit limit(4096);
    error = open_error();
  }
  EXPECT_NE(error.find("the disk has no space for 24"), std::string::npos) << error;
  EXPECT_EQ(number_of_files(), 0u);
}

TEST_F(Matrix_file_test, continues_after_full_disk)
{
  write_all(path + ".expected");
  std::string error;
  {
    Matrix_file file(path, layout, 48, key);
    file.write(0, tile_bytes(file, 0));
    const File_size_limit limit(200); // two of three tiles
    error = error_of(
        [&]
        {
          file.write(1, tile_bytes(file, 1));
          file.write(2, tile_bytes(file, 2));
        });
  }
  EXPECT_NE(error.find("it cannot be written (File too large)"), std::string::npos) << error;
  Matrix_file file(path, layout, 48, key);
  EXPECT_TRUE(file.is_finished(0));
  EXPECT_FALSE(file.is_finished(2));
  for(std::size_t tile = 0; tile < 3; ++tile)
    file.write(tile, tile_bytes(file, tile));
  file.finish();
  EXPECT_EQ(content(path), content(path + ".expected"));
}

TEST_F(Matrix_file_test, merges_parts_in_any_order)
{
  for(const Number_format format : {Number_format::float32, Number_format::float64})
  {
    layout = {5, 3, format, 0, 5};
    write_all(path + ".expected");
    write_part(path + "1", 0, 2);
    write_part(path + "2", 2, 2);
    write_part(path + "3", 2, 3);
    write_part(path + "4", 3, 5);
    for(const std::vector<int>& order :
        {std::vector<int>{1, 2, 3, 4}, std::vector<int>{4, 1, 3}, std::vector<int>{3, 2, 4, 1}})
    {
      std::vector<std::string> parts;
      for(const int i : order)
        parts.push_back(path + std::to_string(i));
      merge_matrix_files(parts, path);
      EXPECT_EQ(content(path), content(path + ".expected"));
      EXPECT_FALSE(std::filesystem::exists(record));
    }
  }
  merge_matrix_files({path + ".expected"}, path);
  EXPECT_EQ(content(path), content(path + ".expected"));
}

TEST_F(Matrix_file_test, names_missing_and_repeated_rows)
{
  const auto expect_error = [&](const std::vector<std::string>& parts, const std::string& text)
  { EXPECT_NE(merge_error(parts).find(text), std::string::npos) << merge_error(parts); };
  write_part(path + "1", 0, 2);
  write_part(path + "2", 1, 4);
  write_part(path + "3", 3, 5);
  write_part(path + "4", 4, 5);
  expect_error({path + "3", path + "1"}, "m.npy: the rows 2:3 are in no part.");
  expect_error({path + "2", path + "4"}, "m.npy: the rows 0:1 are in no part.");
  expect_error({path + "1"}, "m.npy: the rows 2:5 are in no part.");
  expect_error({path + "1", path + "2", path + "4"},
               "m.npy: the rows 1:2 are both in " + path + "1 and in " + path + "2.");
  expect_error({path + "4", path + "3", path + "1"}, "m.npy: the rows 2:3 are in no part.");
  expect_error({path + "1", path + "1"}, "the rows 0:2 are both in");
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(Matrix_file_test, rejects_parts_that_do_not_fit)
{
  const auto expect_error = [&](const std::vector<std::string>& parts, const std::string& text)
  { EXPECT_NE(merge_error(parts).find(text), std::string::npos) << merge_error(parts); };
  const auto write_with_key = [&](const std::string& to, const Matrix_key& other_key)
  {
    Matrix_file file(to, layout, 240, other_key);
    file.write(0, tile_bytes(file, 0));
    file.finish();
  };
  write_all(path + "0");
  write_part(path + "1", 0, 2);
  layout.first_row = 2;
  layout.rows = 3;
  write_with_key(path + "2", {key.surface + 1, key.arguments});
  write_with_key(path + "3", {key.surface, key.arguments + 1});
  layout.columns = 4;
  write_all(path + "4");
  Matrix_file(path + "5", layout, 48, key);
  set_content(path + "6", "no matrix");
  set_content(path + "7", content(path + "1").substr(0, 200));
  expect_error({path + "1", path + "0"}, "m.npy0: it has all rows and is not a part");
  expect_error({path + "0", path + "0"}, "m.npy0: it has all rows and is not a part");
  expect_error({path + "1", path + "2"}, "m.npy2: it belongs to another surface than ");
  expect_error({path + "1", path + "3"}, "m.npy3: it belongs to other arguments than ");
  expect_error({path + "1", path + "4"}, "m.npy4: it has other columns or numbers than ");
  expect_error({path + "5"}, "m.npy5: it is not complete.");
  expect_error({path + "5.unfinished"}, "m.npy5.unfinished: it is not complete.");
  expect_error({path + "6"}, "it is not a .npy file");
  expect_error({path + "7"}, "its size is not");
  expect_error({path + "8"}, "it cannot be opened");
  expect_error({}, "there are no parts");
  EXPECT_FALSE(std::filesystem::exists(path));
  std::filesystem::copy(path + "1", path);
  expect_error({path}, "it is one of the parts");
  EXPECT_EQ(content(path), content(path + "1"));
}

} // namespace matrix_file_test
