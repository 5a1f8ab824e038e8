// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/read_bytes.h"

#include "readers/Scanner.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace program {

Bytes read_bytes(const std::string& filename)
{
  std::error_code error;
  const auto status = std::filesystem::status(filename, error);
  if(!std::filesystem::exists(status))
    fail(filename, "there is no such file");
  if(!std::filesystem::is_regular_file(status))
    fail(filename, "it is not a regular file");
  const auto size = std::filesystem::file_size(filename, error);
  std::ifstream file(filename, std::ios::binary);
  if(error || !file)
    fail(filename, "it cannot be opened for reading");
  Bytes bytes(size);
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.truncate(static_cast<std::size_t>(file.gcount()));
  if(file.bad())
    fail(filename, "it cannot be read");
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
