// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_FUZZ_READER_H
#define GEODESIC_PROGRAM_FUZZ_READER_H

#include "readers/Surface_file.h"

// Reads bytes as a file of one format, repairs what came out as the program does, and stops where a
// promise is broken. Errors with a sentence are what bad bytes deserve.
int fuzz_reader(program::Reader read, const std::uint8_t* data, std::size_t size);

#endif // GEODESIC_PROGRAM_FUZZ_READER_H
