// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/compress.h"

#include <zlib.h>

#include <new>

namespace program {

std::string compress(std::string_view bytes)
{
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  if(::compress(reinterpret_cast<Bytef*>(result.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size())) != Z_OK)
    throw std::bad_alloc(); // the only failure, because the result has enough bytes
  result.resize(size);
  return result;
}

} // namespace program
