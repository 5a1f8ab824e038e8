// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/decompress.h"

#include "readers/Scanner.h"

#include <emscripten.h>

#include <cstdlib>

namespace program {

namespace {

// Decompresses by a function of the page. Returns the number of bytes and the address of a new
// array, or -1 if the data are invalid or expand to more than `max_size` bytes.
EM_JS(int, inflate_in_page, (const char* bytes, int size, double max_size, char** result), {
  const decompressed = Module.inflate(HEAPU8.subarray(bytes, bytes + size), max_size);
  if(!decompressed)
    return -1;
  const address = _malloc(Math.max(1, decompressed.length));
  if(!address)
    return -1;
  HEAPU8.set(decompressed, address);
  HEAPU32[result >> 2] = address;
  return decompressed.length;
});

} // namespace

// Replaces the function of the readers, because zlib is not available.
std::string inflate(std::string_view bytes, const std::string& name)
{
  char* address = nullptr;
  const int size = inflate_in_page(bytes.data(), static_cast<int>(bytes.size()),
                                   double(max_compression_ratio) * double(bytes.size()), &address);
  if(size < 0)
    fail(name, "its compressed data are invalid");
  std::string result(address, static_cast<std::size_t>(size));
  std::free(address);
  return result;
}

std::string decompress_lz4(std::string_view, std::size_t, const std::string& name)
{
  fail(name, "its data are compressed by LZ4, which the viewer does not read");
}

} // namespace program
