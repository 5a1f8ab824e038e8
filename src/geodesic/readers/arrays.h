// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_ARRAYS_H
#define GEODESIC_PROGRAM_READERS_ARRAYS_H

#include "readers/Surface_file.h"
#include "readers/binary_numbers.h"

namespace program {

// Returns the values of consecutive numbers. Bytes after the last complete number are ignored.
std::vector<double> decode_numbers(std::string_view bytes, Number_type type, bool big_endian);

// Returns the numbers of a text. Throws Input_error if a word is not a number.
std::vector<double> numbers_in_text(std::string_view text, const std::string& name);

// Returns consecutive triples of coordinates. Numbers after the last triple are ignored.
std::vector<Point> to_points(const std::vector<double>& coordinates);

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_ARRAYS_H
