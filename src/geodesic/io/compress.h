// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_COMPRESS_H
#define GEODESIC_PROGRAM_IO_COMPRESS_H

#include <string>
#include <string_view>

namespace program {

// Returns the bytes in the zlib format, which inflate() decompresses. Throws std::bad_alloc.
std::string compress(std::string_view bytes);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_COMPRESS_H
