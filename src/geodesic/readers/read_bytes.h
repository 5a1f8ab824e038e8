// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_READ_BYTES_H
#define GEODESIC_PROGRAM_READERS_READ_BYTES_H

#include <string>

namespace program {

// Reads all bytes of a regular file. Throws Input_error.
std::string read_bytes(const std::string& filename);

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_READ_BYTES_H
