// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_COMMANDS_MATRIX_FILE_H
#define GEODESIC_PROGRAM_COMMANDS_MATRIX_FILE_H

#include "app/Command.h"
#include "app/Job.h"
#include "commands/command_utilities.h"

#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace program {

// The options of a matrix that is written to a .npy file.
struct Matrix_file_options
{
  bool use_float32 = false;
  std::string rows;          // "BEGIN:END", or empty for all
  std::string regions;       // a property or a file with an integer for each vertex
  bool do_join_rows = false; // one row per region, too
  bool do_average = false;

  bool is_given() const
  {
    return use_float32 || !rows.empty() || !regions.empty() || do_join_rows || do_average;
  }
};

// Selects the vertices of the rows of a matrix.
struct Row_selection
{
  std::string sources; // "V,V,..."
  std::optional<std::size_t> number;

  bool has_all_vertices() const { return sources.empty() && !number; }
};

// Returns the vertices of the rows, in their order.
template <typename Domain>
std::vector<std::size_t> row_vertices(const Domain& domain, const Row_selection& selection,
                                      Job& job)
{
  if(!selection.sources.empty())
    return parse_indices(selection.sources, "--sources");
  if(selection.number)
    return farthest_vertices(domain, *selection.number, job);
  std::vector<std::size_t> result(job.surface().file.points.size());
  std::iota(result.begin(), result.end(), std::size_t{0});
  return result;
}

void add_matrix_file_options(Command& command, Matrix_file_options& options);

// Throws Usage_error if the options are inconsistent.
void check(const Matrix_file_options& options, const Row_selection& rows);

// Computes the distances from some vertices to the same vertices, or to the regions of all
// vertices, or between these regions, and writes them to the output. Unreached entries are
// infinite. Continues an interrupted computation. Throws Output_error, and Usage_error if the rows are out of range.
void write_matrix_file(Job& job, const Matrix_file_options& options, const std::string& method,
                       double max_distance, const Row_selection& rows);

} // namespace program

#endif // GEODESIC_PROGRAM_COMMANDS_MATRIX_FILE_H
