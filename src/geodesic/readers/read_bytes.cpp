// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/read_bytes.h"

#include "readers/Scanner.h"
#include "readers/parse_chunks.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace program {

namespace {

// Reads a range of a file to an array. Returns the number of bytes that the file has there.
std::size_t read_range(const std::string& filename, std::size_t begin, std::size_t size,
                       char* bytes)
{
  std::ifstream file(filename, std::ios::binary);
  if(!file)
    fail(filename, "it cannot be opened for reading");
  file.seekg(static_cast<std::streamoff>(begin));
  file.read(bytes, static_cast<std::streamsize>(size));
  if(file.bad())
    fail(filename, "it cannot be read");
  return static_cast<std::size_t>(file.gcount());
}

} // namespace

Bytes read_bytes(const std::string& filename, unsigned number_of_threads)
{
  std::error_code error;
  const auto status = std::filesystem::status(filename, error);
  if(!std::filesystem::exists(status))
    fail(filename, "there is no such file");
  if(!std::filesystem::is_regular_file(status))
    fail(filename, "it is not a regular file");
  const auto size = std::filesystem::file_size(filename, error);
  if(error)
    fail(filename, "it cannot be opened for reading");
  Bytes bytes(size);
  const std::size_t count = number_of_chunks(size, number_of_threads);
  const bool is_read =
      count > 1 &&
      parse_chunks(count, number_of_threads,
                   [&](std::size_t i)
                   {
                     const std::size_t begin = size / count * i,
                                       end = i + 1 == count ? size : begin + size / count;
                     return read_range(filename, begin, end - begin, bytes.data() + begin) ==
                            end - begin;
                   });
  if(!is_read)
    bytes.truncate(read_range(filename, 0, size, bytes.data()));
  return bytes;
}

Bytes read_referenced_bytes(const std::string& filename, const std::string& path)
{
  const std::filesystem::path relative = std::filesystem::path(path).lexically_normal();
  if(relative.empty() || !relative.is_relative() || *relative.begin() == "..")
    fail(filename, "it refers to the file '" + printable(path) + "', which is not in its folder");
  return read_bytes((std::filesystem::path(filename).parent_path() / relative).string());
}

} // namespace program
