// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "commands/speed_options.h"
#include "io/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace program {

namespace {

struct Isoline_options
{
  std::string property;  // vertex property whose isolines are computed
  std::string source;    // "V,V,...": isolines of the distance from these sources
  std::string source_at; // "x,y,z"
  bool use_boundary = false;
  std::string method = "automatic";
  Speed_options speed_options;
  std::string isovalues; // "V,V,..."
  std::size_t number = 10;
};

struct Isoline_result
{
  std::vector<double> values; // #vertices
  std::vector<std::vector<Point>> lines;
  std::size_t number_of_closed = 0;
  double length = 0.;
};

bool has_sources(const Isoline_options& options)
{
  return !options.source.empty() || !options.source_at.empty() || options.use_boundary;
}

// Computes the distance of each vertex.
std::vector<double> source_distances(const Mesh_domain& domain, const Isoline_options& options,
                                     Job& job)
{
  std::vector<GP::Source<Mesh>> sources;
  if(!options.source.empty())
    for(const std::size_t vertex : parse_indices(options.source, "--source"))
      sources.emplace_back(vertex_at<Mesh>(vertex));
  if(!options.source_at.empty())
    sources.emplace_back(locate(domain, options.source_at, "--source-at"));
  if(options.use_boundary)
    GP::border_sources(domain, std::back_inserter(sources));
  if(sources.empty())
    fail(job.input(), "the mesh has no boundary");
  const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
  check_memory(job, options.method == "automatic" && !speed.empty() ? "euclidean" : options.method);
  Distance_solver<Mesh> solver(domain, to_method(options.method));
  job.begin_stage("query");
  solver.compute(sources, GP::parameters::callback(job.progress_callback("distance"))
                              .speed_map(speed_map<Mesh::Vertex_index>(speed)));
  std::vector<double> values(job.surface().file.points.size());
  for(std::size_t i = 0; i < values.size(); ++i)
    values[i] = solver.distance(vertex_at<Mesh>(i));
  return values;
}

// Returns the isovalues of the command line, or values of equal spacing between the smallest and
// the largest value.
std::vector<double> isovalues_of(const Isoline_options& options, const std::vector<double>& values)
{
  if(!options.isovalues.empty())
    return *parse_numbers(options.isovalues);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for(const double value : values)
    if(std::isfinite(value))
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  std::vector<double> result;
  if(low < high)
    for(std::size_t i = 1; i <= options.number; ++i)
    {
      const double fraction = static_cast<double>(i) / static_cast<double>(options.number + 1);
      result.push_back((1. - fraction) * low + fraction * high);
    }
  return result;
}

// Computes the values and their isolines.
Isoline_result find_isolines(const Mesh_domain& domain, const Isoline_options& options, Job& job)
{
  Isoline_result result;
  if(options.property.empty())
    result.values = source_distances(domain, options, job);
  else
    result.values = property(job.surface(), options.property);
  job.begin_stage("query");
  // Distances from boundaries and travel times are not distances from points.
  const bool do_fit_circles =
      options.property.empty() && !options.use_boundary && !options.speed_options.is_given();
  std::vector<GP::Isoline<Mesh>> lines;
  GP::isolines(domain, Property_map<Mesh::Vertex_index>{&result.values},
               isovalues_of(options, result.values), std::back_inserter(lines),
               GP::parameters::do_fit_circles(do_fit_circles));
  for(const auto& line : lines)
  {
    result.lines.push_back(coordinates_of(line.points));
    result.number_of_closed += line.is_closed;
    result.length += line.length;
  }
  return result;
}

void check(const Isoline_options& options)
{
  if(options.property.empty() == !has_sources(options))
    throw Usage_error("isolines: either --property or sources (--source, --source-at or "
                      "--source-border) are required, but not both.");
  if(!options.source.empty())
    parse_indices(options.source, "--source");
  if(!options.source_at.empty())
    parse_point(options.source_at, "--source-at");
  check_method(options.method);
  check(options.speed_options, options.method);
  if(options.isovalues.empty())
    return;
  const auto isovalues = parse_numbers(options.isovalues);
  if(!isovalues || !std::all_of(isovalues->begin(), isovalues->end(),
                                [](double value) { return std::isfinite(value); }))
    throw Usage_error("--isovalues " + printable(options.isovalues) +
                      ": finite numbers that are separated by commas are required.");
}

void run_isolines(Job& job, const Isoline_options& options)
{
  check(options);
  const Surface& surface = job.read({"vtp", "ply", "obj"});
  if(!surface.is_mesh())
    fail(surface.name, "isolines need a mesh, because the triangles of a cloud overlap");
  check_method(options.method, surface);
  if(!options.source.empty())
    for(const std::size_t vertex : parse_indices(options.source, "--source"))
      check_vertex(surface, vertex);

  job.begin_stage("prepare");
  const Isoline_result result = find_isolines(*surface.domain, options, job);
  job.result()["lines"] = result.lines.size();
  job.result()["closed"] = result.number_of_closed;
  job.result()["length"] = json_number(result.length);
  job.print_line("lines           " + std::to_string(result.lines.size()) + ", " +
                 std::to_string(result.number_of_closed) + " closed");
  job.print_line("length          " + rounded_text(result.length));

  job.begin_stage("write");
  job.write_values([&] { return number_lines(result.values); });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file};
    picture.values = result.values;
    picture.title = options.property.empty() ? "distance" : options.property;
    picture.show_isolines = false;
    picture.thin_polylines = result.lines;
    draw(job.picture(), picture);
  }
  write_polylines(job, result.lines);
  job.finish();
}

} // namespace

void add_isolines(CLI::App& program)
{
  Command command(program, "isolines",
                  "compute isolines of a vertex property, or of the distance from sources: offset "
                  "curves");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output", "write the isolines: .ply .obj .vtp");
  const auto options = std::make_shared<Isoline_options>();
  command.add("--property", options->property, "NAME", "vertex property of the file");
  command.add("--source", options->source, "V[,V...]", "indices of source vertices");
  command.add("--source-at", options->source_at, "x,y,z",
              "source at the location closest to a point");
  command.add_flag("--source-border", options->use_boundary, "sources at all boundary cycles");
  command
      .add("--method", options->method, "NAME",
           "of distances: automatic, exact, euclidean, fast-marching, dijkstra or heat")
      .shows_default();
  command.add("--isovalues", options->isovalues, "X[,X...]", "values of the isolines");
  command
      .add("--number", options->number, "N",
           "without --isovalues: number of values, with equal spacing between the smallest and the "
           "largest value")
      .shows_default();
  add_speed_options(command, options->speed_options);
  command.set_callback([job, options] { run_isolines(*job, *options); });
}

} // namespace program
