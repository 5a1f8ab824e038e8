// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/matrix_file.h"

#include "app/commands.h"
#include "io/errors.h"
#include "readers/Scanner.h"
#include "readers/read_bytes.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>

namespace program {

namespace {

// Parses BEGIN:END. Throws Usage_error.
std::pair<std::size_t, std::size_t> parse_rows(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const auto begin = to_integer(text.substr(0, colon)),
             end = colon == std::string::npos ? begin : to_integer(text.substr(colon + 1));
  if(colon == std::string::npos || !begin || !end || *begin < 0 || *end < *begin)
    throw Usage_error("--rows: '" + text + "' is not a range BEGIN:END of rows, counted from 0.");
  return {static_cast<std::size_t>(*begin), static_cast<std::size_t>(*end)};
}

// Reads the region of each vertex from a property, or from a file with one integer per line.
std::vector<long long> read_regions(const std::string& text, const Surface& surface)
{
  const std::size_t n = surface.file.points.size();
  std::vector<long long> result;
  if(surface.file.properties.count(text) != 0 || !std::ifstream(text))
  {
    for(const double value : property(surface, text))
    {
      if(!(value >= -1. && value < static_cast<double>(n) && std::floor(value) == value))
        fail(surface.name, "the property " + printable(text) + " is not a region at a vertex");
      result.push_back(static_cast<long long>(value));
    }
    return result;
  }
  const Bytes bytes = read_bytes(text);
  Scanner scanner(bytes, text, '#');
  while(scanner.next_line())
  {
    result.push_back(scanner.parse_integer(scanner.word()));
    if(!scanner.is_line_empty())
      scanner.fail("the line contains more than one number");
    if(result.back() >= static_cast<long long>(n))
      scanner.fail("the region is not smaller than the number of vertices");
  }
  if(result.size() != n)
    fail(text, "the number of regions is " + std::to_string(result.size()) +
                   ", but the number of vertices is " + std::to_string(n));
  return result;
}

template <typename Domain>
void write_rows(const Domain& domain, Job& job, const Matrix_file_options& options,
                const std::string& method, double max_distance, const Row_selection& selection)
{
  using Vertex = typename Domain::Vertex;
  using Surface_type = typename Domain::Surface;
  job.begin_stage("query");
  const std::size_t n = job.surface().file.points.size();
  const std::vector<std::size_t> positions = row_vertices(domain, selection, job);
  std::vector<Vertex> sources;
  for(const std::size_t position : positions)
    sources.push_back(vertex_at<Surface_type>(position));
  std::vector<long long> regions; // empty, or of each vertex
  if(!options.regions.empty())
    regions = read_regions(options.regions, job.surface());
  const std::size_t number_of_regions =
      regions.empty()
          ? 0
          : static_cast<std::size_t>(1 + *std::max_element(regions.begin(), regions.end()));
  const std::size_t number_of_rows = options.do_join_rows ? number_of_regions : sources.size();
  const auto range = options.rows.empty() ? std::make_pair(std::size_t{0}, number_of_rows)
                                          : parse_rows(options.rows);
  if(range.second > number_of_rows)
    throw Usage_error("--rows: the matrix has only " + std::to_string(number_of_rows) + " rows.");

  const auto np = GP::parameters::method(to_method(method))
                      .number_of_threads(job.threads())
                      .callback(job.progress_callback("distances"))
                      .maximum_distance(max_distance)
                      .row_range(range);
  const auto write = [&](auto number, const auto& parameters)
  {
    GP::write_geodesic_distance_matrix<Runtime_method, CGAL::Parallel_tag, decltype(number)>(
        domain, sources, job.output(), parameters);
  };
  const auto write_numbers = [&](const auto& parameters)
  { options.use_float32 ? write(float(), parameters) : write(double(), parameters); };
  if(options.regions.empty())
    write_numbers(np);
  else
  {
    std::vector<Vertex> targets;
    for(std::size_t i = 0; i < n; ++i)
      targets.push_back(vertex_at<Surface_type>(i));
    const Property_map<Vertex, long long> map{&regions};
    const auto column_np =
        np.targets(targets).region_map(map).do_average_regions(options.do_average);
    if(options.do_join_rows)
      write_numbers(column_np.row_region_map(map));
    else
      write_numbers(column_np);
  }
  const std::size_t columns = regions.empty() ? sources.size() : number_of_regions;
  job.result()["rows"] = range.second - range.first;
  job.result()["columns"] = columns;
  if(!selection.has_all_vertices())
    job.result()["sources"] = positions;
  job.print_line("rows            " + std::to_string(range.second - range.first));
  job.print_line("columns         " + std::to_string(columns));
}

} // namespace

void add_matrix_file_options(Command& command, Matrix_file_options& options)
{
  command.add_flag("--float32", options.use_float32,
                   "numbers of 32 instead of 64 bits in a .npy file");
  command.add("--rows", options.rows, "BEGIN:END",
              "write only these rows to a .npy file, counted from 0, without the row END");
  command.add("--regions", options.regions, "FILE",
              "columns of a .npy file: the minimum of the distances to each region. The region of "
              "each vertex is an integer, one per line of a file, or a property; -1 is none");
  command.add_flag("--between-regions", options.do_join_rows,
                   "one row per region, too: the minimum of the distances between two regions");
  command.add_flag("--average", options.do_average,
                   "the mean distance of regions instead of the minimum");
}

void check(const Matrix_file_options& options, const Row_selection& rows)
{
  if(!options.rows.empty())
    parse_rows(options.rows);
  if(options.do_average && options.regions.empty())
    throw Usage_error("--average: this option needs --regions.");
  if(options.do_join_rows && options.regions.empty())
    throw Usage_error("--between-regions: this option needs --regions.");
  if(options.do_join_rows && !rows.has_all_vertices())
    throw Usage_error("--between-regions: this option excludes --sources and --number.");
}

void write_matrix_file(Job& job, const Matrix_file_options& options, const std::string& method,
                       double max_distance, const Row_selection& rows)
{
  try
  {
    visit_domain(job, [&](const auto& domain)
                 { write_rows(domain, job, options, method, max_distance, rows); });
  }
  catch(const GP::File_error& error)
  {
    throw Output_error(error.what());
  }
}

void add_merge_matrices(CLI::App& program)
{
  struct Options
  {
    std::vector<std::string> parts;
    std::string output;
  };
  Command command(program, "merge-matrices",
                  "join .npy files with parts of the rows of a matrix, in any order");
  const auto options = std::make_shared<Options>();
  command
      .add("--part", options->parts, "FILE",
           "file that the command matrix has written; can be repeated")
      .required();
  command.add("-o,--output", options->output, "FILE", "file with all rows: .npy").required();
  command.set_callback(
      [options]
      {
        try
        {
          GP::merge_distance_matrices(options->parts, options->output);
        }
        catch(const GP::File_error& error)
        {
          throw Output_error(error.what());
        }
      });
}

} // namespace program
