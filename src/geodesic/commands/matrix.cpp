// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "picture/Picture.h"
#include "app/commands.h"
#include "io/errors.h"
#include "commands/matrix_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace program {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Matrix_options
{
  Row_selection rows;
  Matrix_file_options file;
  std::string method = "automatic";
  std::optional<std::size_t> basis_size;
  double max_distance = infinity;

  bool is_sparse() const { return max_distance < infinity; }
};

using Sparse_matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

struct Matrix_result
{
  std::vector<std::size_t> vertices; // of the rows and columns
  Eigen::MatrixXd dense;             // either `dense` or `sparse` is used
  Sparse_matrix sparse;
  std::size_t entries = 0; // number of pairs that a path within the limit connects
  // For the picture:
  std::vector<double> values;           // #vertices
  std::vector<std::uint32_t> triangles; // of a cloud
};

// Returns the picture's values: distances from the row vertices. If all vertices are rows, returns
// the number of entries of each row.
template <typename Domain>
std::vector<double> picture_values(const Domain& domain,
                                   const std::vector<typename Domain::Vertex>& descriptors,
                                   const std::string& method, const Matrix_result& result,
                                   const Matrix_options& options, const Job& job)
{
  std::vector<double> values(job.surface().file.points.size());
  if(options.rows.has_all_vertices())
  {
    for(std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<double>(result.sparse.outerIndexPtr()[i + 1] -
                                      result.sparse.outerIndexPtr()[i]);
    return values;
  }
  using Surface_type = typename Domain::Surface;
  Distance_solver<Surface_type> solver(domain, GP::parameters::method(to_method(method)));
  solver.compute(descriptors, GP::parameters::maximum_distance(options.max_distance));
  for(std::size_t i = 0; i < values.size(); ++i)
    values[i] = solver.distance(vertex_at<Surface_type>(i));
  return values;
}

// Selects the row vertices and computes the distances between them.
template <typename Domain>
Matrix_result compute_matrix(const Domain& domain, const Matrix_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  job.begin_stage("query");
  Matrix_result result;
  result.vertices = row_vertices(domain, options.rows, job);
  std::vector<typename Domain::Vertex> descriptors;
  for(const std::size_t vertex : result.vertices)
    descriptors.push_back(vertex_at<Surface_type>(vertex));

  if(is_metric(options.method))
  {
    with_metric<Surface_type>(domain, options.method, options.basis_size, job,
                              [&](const auto& metric)
                              { result.dense = metric.distance_matrix(descriptors); });
    if(!job.picture().empty()) // a picture shows path lengths
      result.values = picture_values(domain, descriptors, "automatic", result, options, job);
  }
  else
  {
    const auto np = GP::parameters::method(to_method(options.method))
                        .number_of_threads(job.threads())
                        .callback(job.progress_callback("distances"));
    if(options.is_sparse())
      result.sparse = GP::sparse_geodesic_distance_matrix<Runtime_method, CGAL::Parallel_tag>(
          domain, descriptors, options.max_distance, np);
    else
      result.dense =
          GP::geodesic_distance_matrix<Runtime_method, CGAL::Parallel_tag>(domain, descriptors, np);
    if(!job.picture().empty())
      result.values = picture_values(domain, descriptors, options.method, result, options, job);
  }
  result.entries = options.is_sparse()
                       ? static_cast<std::size_t>(result.sparse.nonZeros())
                       : static_cast<std::size_t>((result.dense.array() < infinity).count());
  result.triangles = picture_triangles(domain, job);
  return result;
}

// Appends one line per entry: row, column, distance.
void append_entries(std::string& text, const Sparse_matrix& matrix, Eigen::Index index_base)
{
  for(Eigen::Index row = 0; row < matrix.rows(); ++row)
    for(Sparse_matrix::InnerIterator entry(matrix, row); entry; ++entry)
    {
      text +=
          std::to_string(row + index_base) + ' ' + std::to_string(entry.col() + index_base) + ' ';
      append_number(text, entry.value());
      text += '\n';
    }
}

// Returns one line per row, or per entry of a sparse matrix.
std::string values_text(const Matrix_result& result)
{
  std::string text;
  append_entries(text, result.sparse, 0);
  for(Eigen::Index row = 0; row < result.dense.rows(); ++row)
    for(Eigen::Index column = 0; column < result.dense.cols(); ++column)
    {
      append_number(text, result.dense(row, column));
      text += column + 1 < result.dense.cols() ? ' ' : '\n';
    }
  return text;
}

// Returns the matrix in Matrix Market format. "coordinate" uses 1-based indices, "array" is
// column-major. The distances of most methods are not symmetric to the last digit, so the matrix
// is "general".
std::string to_matrix_market(const Matrix_result& result, bool is_sparse)
{
  std::string text = "%%MatrixMarket matrix ";
  text += is_sparse ? "coordinate" : "array";
  text += " real general\n";
  const std::string rows = std::to_string(result.vertices.size());
  text += rows + ' ' + rows + (is_sparse ? ' ' + std::to_string(result.entries) : "") + '\n';
  append_entries(text, result.sparse, 1);
  for(Eigen::Index i = 0; i < result.dense.size(); ++i)
  {
    append_number(text, result.dense.data()[i]);
    text += '\n';
  }
  return text;
}

// Throws Usage_error if the options are inconsistent.
void check(const Matrix_options& options, bool has_numpy_output)
{
  if(!options.rows.sources.empty() && options.rows.number)
    throw Usage_error("matrix: --sources and --number cannot be combined.");
  if(options.rows.number && *options.rows.number == 0)
    throw Usage_error("--number: the matrix must have at least one row.");
  if(!(options.max_distance >= 0.))
    throw Usage_error("--limit: the distance must not be negative.");
  if(options.rows.has_all_vertices() && !options.is_sparse() && !has_numpy_output)
    throw Usage_error("matrix: --limit or a .npy file as output is required if neither --sources "
                      "nor --number is given.");
  if(has_numpy_output && is_metric(options.method))
    throw Usage_error("--method " + options.method + ": this method does not support .npy files.");
  if(options.file.is_given() && !has_numpy_output)
    throw Usage_error("matrix: --float32, --rows, --regions, --between-regions and --average need "
                      "a .npy file as output.");
  check(options.file, options.rows);
  if(!options.rows.sources.empty())
  {
    std::vector<std::size_t> vertices = parse_indices(options.rows.sources, "--sources");
    std::sort(vertices.begin(), vertices.end());
    const auto duplicate = std::adjacent_find(vertices.begin(), vertices.end());
    if(duplicate != vertices.end())
      throw Usage_error("--sources: vertex " + std::to_string(*duplicate) + " is listed twice.");
  }
  check_basis(options.method, options.basis_size);
  check_method_or_metric(options.method);
  if(is_metric(options.method) && options.is_sparse())
    throw Usage_error("--method " + options.method + ": this method does not support --limit.");
}

void run_matrix(Job& job, const Matrix_options& options)
{
  const bool has_numpy_output = file_extension(job.output()) == "npy";
  check(options, has_numpy_output);
  if(has_numpy_output && !(job.values().empty() && job.picture().empty()))
    throw Usage_error("matrix: --values and --picture cannot be combined with a .npy file.");
  const Surface& surface = job.read({"mtx", "npy"});
  if(!is_metric(options.method))
    check_method(options.method, surface);
  if(!options.rows.sources.empty())
    for(const std::size_t vertex : parse_indices(options.rows.sources, "--sources"))
      check_vertex(surface, vertex);

  job.begin_stage("prepare");
  if(has_numpy_output)
  {
    write_matrix_file(job, options.file, options.method, options.max_distance, options.rows);
    return job.finish();
  }
  Matrix_result result;
  visit_domain(job, [&](const auto& domain) { result = compute_matrix(domain, options, job); });
  const std::size_t rows = result.vertices.size();
  job.result()["rows"] = rows;
  job.result()["entries"] = result.entries;
  if(!options.rows.has_all_vertices())
    job.result()["sources"] = result.vertices;
  job.print_line("rows            " + std::to_string(rows));
  job.print_line("entries         " + std::to_string(result.entries));

  job.begin_stage("write");
  job.write_values([&] { return values_text(result); });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file, result.values, "", {}, {}, {}, result.triangles};
    picture.title = options.rows.has_all_vertices() ? "near vertices" : "distance";
    if(!options.rows.has_all_vertices())
      for(const std::size_t vertex : result.vertices)
        picture.markers.push_back(surface.file.points[vertex]);
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
    write_file(job.output(), to_matrix_market(result, options.is_sparse()));
  job.finish();
}

} // namespace

void add_matrix(CLI::App& program)
{
  Command command(program, "matrix",
                  "compute the distances between all pairs of vertices, or between near pairs");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Matrix_options>();
  command.describe("--output",
                   "write the matrix in Matrix Market format: .mtx, or as an array of NumPy: .npy. "
                   "A .npy file is written in tiles and need not fit in memory; if the command is "
                   "interrupted, the same command continues");
  command.describe(
      "--values", "write the matrix as text: one row per line; a sparse matrix has row, column and "
                  "distance of one entry per line");
  command.describe(
      "--picture",
      "draw the distance to the nearest source, or for all vertices the number of near "
      "vertices: .png");
  command.add("--sources", options->rows.sources, "V[,V...]", "indices of the vertices");
  command.add("--number", options->rows.number, "N",
              "number of vertices, selected by farthest point sampling");
  command
      .add("--method", options->method, "NAME",
           "automatic, exact, euclidean, fast-marching, dijkstra or heat, as for distance; "
           "spectral, emd or biharmonic")
      .shows_default();
  command.add("--basis", options->basis_size, "K",
              "basis size of emd, as for distance (default 100)");
  command.add("--limit", options->max_distance, "D",
              "only pairs of vertices within this distance, as a sparse matrix; in a .npy file the "
              "others are infinite");
  add_matrix_file_options(command, options->file);
  command.set_callback([job, options] { run_matrix(*job, *options); });
}

} // namespace program
