// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Input_error.h"
#include "readers/decompress.h"

#include <cstdint>
#include <cstdlib>

// Decompresses the bytes in each format. The size of an LZ4 block is unknown, so several are tried.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto attempt = [size](const auto& decompress)
  {
    try
    {
      if(decompress().size() > program::max_compression_ratio * size)
        std::abort();
    }
    catch(const program::Input_error&)
    {}
  };
  attempt([&] { return program::inflate(bytes, "input"); });
  for(const std::size_t length : {std::size_t{0}, std::size_t{117}, size, 2 * size, 1000 * size})
    attempt([&] { return program::decompress_lz4(bytes, length, "input"); });
  return 0;
}
