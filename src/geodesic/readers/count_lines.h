// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_COUNT_LINES_H
#define GEODESIC_PROGRAM_READERS_COUNT_LINES_H

#include <cstddef>
#include <string_view>

namespace program {

// Returns the number of line feeds before the last character, and one more.
std::size_t number_of_lines(std::string_view text);

// Returns an upper bound of the number of lines, at most one for each min_size bytes. Lines end
// with a line feed. Arrays of this capacity are not reallocated.
std::size_t max_number_of_lines(std::string_view text, std::size_t min_size);

// The same for the lines that begin with a character.
std::size_t max_number_of_lines(std::string_view text, std::size_t min_size, char first);

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_COUNT_LINES_H
