// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures how the errors of the distance methods are distributed over many meshes.
#include <CGAL/Geodesic_processing.h>

#include "Cgal_heat_solver.h"
#include "Error_plot.h"
#include "models.h"
#include "report.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

constexpr std::size_t max_vertices = 150000, number_of_sources = 5;
constexpr double infinity = std::numeric_limits<double>::infinity();

// The results of one method, one value per mesh. If the method fails, the errors are infinite.
struct Method_results
{
  std::string name;
  std::vector<double> mean, maximum; // relative errors
  std::vector<double> seconds;       // per query and vertex
};

// Reads any polygon soup and separates it at nonmanifold edges.
Mesh read_soup(const std::string& file)
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  Mesh mesh;
  if(!CGAL::IO::read_polygon_soup(file, points, polygons))
    return mesh;
  PMP::repair_polygon_soup(points, polygons);
  PMP::orient_polygon_soup(points, polygons);
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  PMP::triangulate_faces(mesh);
  return mesh;
}

std::vector<Vertex> sources_of(const Mesh& mesh)
{
  std::vector<Vertex> result;
  for(std::size_t s = 0; s < number_of_sources; ++s)
    result.push_back(Vertex(Mesh::size_type(s * num_vertices(mesh) / number_of_sources)));
  return result;
}

// Adds the errors of a method on a mesh. `make_solver` returns a solver with compute() and
// distance(). Vertices that are unreached, or closer than 5 % of the largest distance, do not
// count.
template <typename Make_solver>
void measure(Method_results& results, const Mesh& mesh,
             const std::vector<std::vector<double>>& reference, const Make_solver& make_solver)
{
  Mean_and_max errors;
  double seconds = 0.;
  try
  {
    auto solver = make_solver();
    const std::vector<Vertex> sources = sources_of(mesh);
    for(std::size_t s = 0; s < sources.size(); ++s)
    {
      seconds += cpu_seconds([&] { solver->compute(sources[s]); });
      double largest = 0.;
      for(const double distance : reference[s])
        if(distance < infinity)
          largest = std::max(largest, distance);
      for(const Vertex v : mesh.vertices())
        if(const double exact = reference[s][v]; exact < infinity && exact > 0.05 * largest)
        {
          const double error = std::fabs(solver->distance(v) - exact) / exact;
          errors.add(std::isfinite(error) ? error : infinity);
        }
    }
  }
  catch(const std::exception&)
  {
    errors.add(infinity);
  }
  // The mean of an infinite error and others is not a number.
  results.mean.push_back(std::isfinite(errors.largest) ? errors.mean : infinity);
  results.maximum.push_back(errors.largest);
  results.seconds.push_back(seconds / double(number_of_sources * num_vertices(mesh)));
}

template <typename Method>
void measure_method(Method_results& results, const Mesh& mesh,
                    const std::vector<std::vector<double>>& reference)
{
  measure(results, mesh, reference,
          [&] { return std::make_unique<GP::Geodesic_distance_solver<Mesh, Method>>(mesh); });
}

// Returns the distances by `Exact`.
std::vector<std::vector<double>> reference_distances(const Mesh& mesh, double& seconds)
{
  GP::Geodesic_distance_solver<Mesh, GP::Exact> solver(mesh);
  std::vector<std::vector<double>> result;
  for(const Vertex source : sources_of(mesh))
  {
    seconds += cpu_seconds([&] { solver.compute(source); });
    result.emplace_back();
    for(const Vertex v : mesh.vertices())
      result.back().push_back(solver.distance(v));
  }
  return result;
}

double quantile(std::vector<double> values, double fraction)
{
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, std::size_t(fraction * double(values.size())))];
}

std::string percent_or_failed(double error)
{
  return std::isfinite(error) ? format_significant(100. * error) : "failed";
}

void print_quantiles(const char* title, const std::vector<Method_results>& results,
                     std::vector<double> Method_results::*values)
{
  Table table(title,
              {"method", "median", "80 %", "90 %", "95 %", "99 %", "at most 1 %", "at most 5 %"});
  for(const Method_results& method : results)
  {
    const std::vector<double>& v = method.*values;
    std::vector<std::string> row = {method.name};
    for(const double fraction : {0.5, 0.8, 0.9, 0.95, 0.99})
      row.push_back(percent_or_failed(quantile(v, fraction)));
    for(const double bound : {0.01, 0.05})
      row.push_back(format_fixed(
          100. * double(std::count_if(v.begin(), v.end(), [=](double x) { return x <= bound; })) /
              double(v.size()),
          1));
    table.add(row);
  }
  table.print();
}

// Errors above 1,000 % are not drawn: the method failed, and the lines of the others need the
// space.
constexpr double max_drawn_error = 10.;

// Returns the error that a share of the meshes exceeds, for shares from one to all meshes.
Panel panel(const std::string& title, const std::vector<Method_results>& results,
            std::vector<double> Method_results::*values)
{
  Panel result{title, "percent of the meshes with a larger error", {}};
  for(std::size_t m = 0; m < results.size(); ++m)
  {
    Series series{results[m].name, m, std::nan(""), {}};
    for(const double share : {1., 2., 5., 10., 20., 30., 50., 70., 90.})
      if(const double error = quantile(results[m].*values, 1. - share / 100.);
         error > 1e-7 && error <= max_drawn_error)
        series.points.push_back({share, error});
    result.series.push_back(series);
  }
  return result;
}

std::vector<std::string> files_in(const std::string& path)
{
  std::vector<std::string> result;
  if(!std::filesystem::is_directory(path))
    return {path};
  for(const auto& entry : std::filesystem::directory_iterator(path))
    result.push_back(entry.path().string());
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

// error_distribution [--quick] PLOT.svg [FILE | FOLDER]...
int main(int argc, char* argv[])
{
  bool quick = false;
  std::vector<std::string> arguments;
  for(int i = 1; i < argc; ++i)
    if(std::strcmp(argv[i], "--quick") == 0)
      quick = true;
    else
      arguments.push_back(argv[i]);
  std::vector<std::string> files;
  for(std::size_t i = 1; i < arguments.size(); ++i)
    for(const std::string& file : files_in(arguments[i]))
      files.push_back(file);
  if(arguments.size() < 2)
    for(const char* const folder : {"/meshes", "/patches", "/parts"})
      if(std::filesystem::is_directory(GEODESIC_PROCESSING_DATA + std::string(folder)))
        for(const std::string& file : files_in(GEODESIC_PROCESSING_DATA + std::string(folder)))
          files.push_back(file);

  std::vector<Method_results> results(5);
  results[0].name = "Dijkstra";
  results[1].name = "Fast_marching";
  results[2].name = "Euclidean_front";
  results[3].name = "Heat";
  results[4].name = "CGAL heat";
  std::vector<double> front_over_marching, exact_over_front, exact_microseconds;
  for(const std::string& file : files)
  {
    Mesh mesh = read_soup(file);
    if(num_faces(mesh) < 4 || num_vertices(mesh) > (quick ? 2000 : max_vertices))
      continue;
    double exact_seconds = 0.;
    const auto reference = reference_distances(mesh, exact_seconds);
    measure_method<GP::Dijkstra>(results[0], mesh, reference);
    measure_method<GP::Fast_marching>(results[1], mesh, reference);
    measure_method<GP::Euclidean_front>(results[2], mesh, reference);
    measure_method<GP::Heat>(results[3], mesh, reference);
    measure(results[4], mesh, reference, [&] { return std::make_unique<Cgal_heat_solver>(mesh); });
    const double n = double(number_of_sources * num_vertices(mesh));
    if(num_vertices(mesh) < 1000) // too fast for the clock
      continue;
    front_over_marching.push_back(results[2].seconds.back() / results[1].seconds.back());
    exact_over_front.push_back(exact_seconds / n / results[2].seconds.back());
    exact_microseconds.push_back(1e6 * exact_seconds / n);
  }
  if(results[0].mean.empty())
  {
    std::printf("No meshes.\n");
    return EXIT_SUCCESS;
  }
  std::printf("Relative errors in percent on %zu meshes, five sources each, compared with Exact.\n"
              "Vertices closer than 5 %% of the largest distance are excluded.\n\n",
              results[0].mean.size());
  print_quantiles("mean error, %", results, &Method_results::mean);
  print_quantiles("largest error, %", results, &Method_results::maximum);
  Table times("microseconds per vertex", {"meshes from 1,000 vertices", "median", "90 %", "99 %"});
  const auto add_times = [&](const char* name, const std::vector<double>& values)
  {
    if(!values.empty())
      times.add({name, format_significant(quantile(values, 0.5)),
                 format_significant(quantile(values, 0.9)),
                 format_significant(quantile(values, 0.99))});
  };
  add_times("Euclidean_front / Fast_marching", front_over_marching);
  add_times("Exact / Euclidean_front", exact_over_front);
  add_times("Exact, microseconds per vertex", exact_microseconds);
  times.print();
  std::printf("Target for the largest error of Euclidean_front: at most 5 %% on 95 %% of public "
              "meshes.\n");
  if(!arguments.empty() &&
     !write_error_plot(arguments[0], {panel("Mean error", results, &Method_results::mean),
                                      panel("Largest error", results, &Method_results::maximum)}))
  {
    std::fprintf(stderr, "error_distribution: cannot write %s\n", arguments[0].c_str());
    return EXIT_FAILURE;
  }
}
