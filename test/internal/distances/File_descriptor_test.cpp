// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/File_descriptor.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include <fcntl.h>

namespace file_descriptor_test {

using CGAL::Geodesic_processing::File_error;
using namespace CGAL::Geodesic_processing::internal;

struct File_descriptor_test : testing::Test
{
  std::string path = (std::filesystem::temp_directory_path() /
                      (std::string("file_descriptor_") +
                       testing::UnitTest::GetInstance()->current_test_info()->name()))
                         .string();
  std::string other = path + "_2";

  File_descriptor_test() { remove_files(); }
  ~File_descriptor_test() override { remove_files(); }
  void remove_files() const
  {
    remove_file(path);
    remove_file(other);
  }
};

TEST_F(File_descriptor_test, reads_what_was_written)
{
  File_descriptor file(path, O_CREAT);
  EXPECT_EQ(file.size(), 0u);
  file.write("abc", 3, 2);
  file.synchronize();
  EXPECT_EQ(file.size(), 5u);
  EXPECT_EQ(file.read(10, 0), std::string("\0\0abc", 5));
  EXPECT_EQ(file.read(2, 3), "bc");
  file.resize(3);
  file.reserve(4);
  EXPECT_EQ(file.read(10, 0), std::string("\0\0a\0", 4));
  EXPECT_EQ(File_descriptor(path).read(10, 2), std::string("a\0", 2));
}

TEST_F(File_descriptor_test, is_locked_until_closed)
{
  File_descriptor file(path, O_CREAT);
  {
    File_descriptor first(path);
    EXPECT_TRUE(first.lock());
    EXPECT_FALSE(file.lock());
  }
  EXPECT_TRUE(file.lock());
}

TEST_F(File_descriptor_test, has_name_until_removed_or_replaced)
{
  const File_descriptor file(path, O_CREAT);
  EXPECT_TRUE(file.has_name());
  const File_descriptor replacement(other, O_CREAT);
  rename_file(other, path);
  EXPECT_FALSE(file.has_name());
  EXPECT_FALSE(std::filesystem::exists(other));
  const File_descriptor second(path);
  EXPECT_TRUE(second.has_name());
  remove_file(path);
  EXPECT_FALSE(second.has_name());
  EXPECT_NO_THROW(remove_file(path));
}

TEST_F(File_descriptor_test, names_file_and_reason)
{
  const auto expect_error = [&](const auto& function, const std::string& text)
  {
    try
    {
      function();
      ADD_FAILURE() << text;
    }
    catch(const File_error& error)
    {
      EXPECT_EQ(std::string(error.what()).substr(0, text.size()), text);
    }
  };
  expect_error([&] { File_descriptor file(path); },
               path + ": it cannot be opened for writing (No such file or directory).");
  expect_error([&] { rename_file(path, other); },
               path + ": it cannot be renamed to " + other + " (No such file or directory).");
  expect_error([&] { remove_file(std::filesystem::temp_directory_path().string()); },
               std::filesystem::temp_directory_path().string() + ": it cannot be removed (");
  expect_error([&] { File_descriptor(path, O_CREAT).reserve(std::size_t(1) << 62); },
               path + ": it needs 4611686018427387904 bytes, but the disk has only ");
}

} // namespace file_descriptor_test
