// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_DECOMPRESS_H
#define GEODESIC_PROGRAM_READERS_DECOMPRESS_H

#include <cstddef>
#include <string>
#include <string_view>

namespace program {

// The result of a decompression is at most this number of times as long as its input. So a short
// file cannot exhaust the memory. zlib compresses zeros by a factor of 1,030.
constexpr std::size_t max_compression_ratio = 1000;

// Decompresses data in the zlib or gzip format. A gzip file can have several members. `name` is the
// file name in error messages. Throws Input_error if the data are invalid, truncated or too long.
std::string inflate(std::string_view bytes, const std::string& name);

// Decompresses an LZ4 block, whose result has `size` bytes. Throws Input_error as inflate(), and if
// the program was built without LZ4.
std::string decompress_lz4(std::string_view bytes, std::size_t size, const std::string& name);

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_DECOMPRESS_H
