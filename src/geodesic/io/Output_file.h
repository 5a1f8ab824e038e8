// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_OUTPUT_FILE_H
#define GEODESIC_PROGRAM_IO_OUTPUT_FILE_H

#include <string>
#include <string_view>
#include <vector>

namespace program {

// Writes a file completely or leaves what was there: the bytes go to a file beside it, which is
// renamed when it is safe.  What is not a regular file (a pipe, /dev/stdout) is written directly.
// Throws Output_error.
void write_file(const std::string& filename, std::string_view bytes);

// A name beside `filename` that no other process uses, for writers that need a file of their own.
std::string temporary_filename(const std::string& filename);

// Renames `from`, which lies beside `filename`, to it; throws Output_error.
void replace_file(const std::string& temporary, const std::string& filename);

// Throws Output_error when the folder of the file is missing: said before any computing.
void check_directory(const std::string& filename);

// The shortest text that reads back as the same number; inf and nan in these letters.
void append_number(std::string& text, double value);
std::string number_text(double value);
// One number a line.
std::string number_lines(const std::vector<double>& values);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_OUTPUT_FILE_H
