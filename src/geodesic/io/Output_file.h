// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_OUTPUT_FILE_H
#define GEODESIC_PROGRAM_IO_OUTPUT_FILE_H

#include <string>
#include <string_view>
#include <vector>

namespace program {

// Writes a file completely or leaves an existing file unchanged. The bytes are written to a
// temporary file in the same directory, which is then renamed. Files that are not regular (a pipe,
// /dev/stdout) are written directly. Throws Output_error.
void write_file(const std::string& filename, std::string_view bytes);

// From now on, SIGINT, SIGTERM and SIGHUP delete the temporary file of write_file() before they end
// the process. Signals that are ignored remain ignored.
void remove_unfinished_file_on_signals();

// Returns an unused file name in the directory of `filename`, for writers that create their own
// file.
std::string temporary_filename(const std::string& filename);

// Renames `temporary`, which must be in the same directory, to `filename`. Throws Output_error.
void replace_file(const std::string& temporary, const std::string& filename);

// Throws Output_error if the directory of the file does not exist. Called before any computation.
void check_directory(const std::string& filename);

// Appends the shortest text from which the same number is read; infinity and NaN are "inf" and
// "nan".
void append_number(std::string& text, double value);
std::string number_text(double value);
// Returns the numbers as text, one per line.
std::string number_lines(const std::vector<double>& values);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_OUTPUT_FILE_H
