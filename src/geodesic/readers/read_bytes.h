// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_READ_BYTES_H
#define GEODESIC_PROGRAM_READERS_READ_BYTES_H

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace program {

// An array of bytes that is not initialized. std::string writes zeros first, which takes as long as
// reading the bytes.
class Bytes
{
public:
  Bytes() = default;
  explicit Bytes(std::size_t size) : m_bytes(new char[size]), m_size(size) {}

  char* data() { return m_bytes.get(); }
  std::size_t size() const { return m_size; }
  operator std::string_view() const { return {m_bytes.get(), m_size}; }

  // Keeps the first bytes. Their number must not exceed the size.
  void truncate(std::size_t size) { m_size = size; }

private:
  std::unique_ptr<char[]> m_bytes;
  std::size_t m_size = 0;
};

// Reads all bytes of a regular file. Large files are read by several threads. Throws Input_error.
Bytes read_bytes(const std::string& filename, unsigned number_of_threads = 1);

// Reads a file to which another file refers by a path relative to its folder. Throws Input_error,
// also if the path leaves this folder.
Bytes read_referenced_bytes(const std::string& filename, const std::string& path);

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_READ_BYTES_H
