// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_READ_BYTES_H
#define GEODESIC_PROGRAM_READERS_READ_BYTES_H

#include <string>

namespace program {

// Reads all bytes of a regular file. Throws Input_error.
std::string read_bytes(const std::string& filename);

// Reads a file to which another file refers by a path relative to its folder. Throws Input_error,
// also if the path leaves this folder.
std::string read_referenced_bytes(const std::string& filename, const std::string& path);

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_READ_BYTES_H
