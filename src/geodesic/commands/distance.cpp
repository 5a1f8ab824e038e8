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
#include <optional>

namespace program {

namespace {

struct Distance_options
{
  std::string source;    // "V,V,..."
  std::string source_at; // "x,y,z"
  bool use_boundary = false;
  std::string method = "automatic";
  std::optional<std::size_t> basis_size;
  double max_distance = std::numeric_limits<double>::infinity();
  double relative_tolerance = 0.;
  std::optional<double> heat_time_step; // in squared mean edge lengths
  Speed_options speed_options;
};

struct Distance_result
{
  std::vector<double> values; // #vertices
  // For the picture:
  std::vector<Point> sources;           // positions of the sources; empty for boundaries
  std::vector<std::uint32_t> triangles; // of a cloud
};

// Returns the distances of all vertices from the single source that these metrics support.
template <typename Surface_type, typename Domain>
std::vector<double> metric_distances(const Domain& domain, const Distance_options& options,
                                     Job& job)
{
  std::vector<double> result(job.surface().file.points.size());
  const Value_map<typename Domain::Vertex> map{&result};
  const auto np = GP::parameters::number_of_threads(job.threads())
                      .callback(job.progress_callback("distance to each vertex"));
  with_metric<Surface_type>(
      domain, options.method, options.basis_size, job,
      [&](const auto& metric)
      {
        job.begin_stage("query");
        if(options.source_at.empty())
          metric.template write_distances<CGAL::Parallel_tag>(
              vertex_at<Surface_type>(parse_indices(options.source, "--source").front()), map, np);
        else
          metric.template write_distances<CGAL::Parallel_tag>(
              locate(domain, options.source_at, "--source-at"), map, np);
      });
  return result;
}

// Computes the distance of each vertex.
template <typename Domain>
Distance_result compute_distances(const Domain& domain, const Distance_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  Distance_result result;
  std::vector<GP::Source<Surface_type>> sources;
  if(!options.source.empty())
    for(const std::size_t vertex : parse_indices(options.source, "--source"))
    {
      sources.emplace_back(vertex_at<Surface_type>(vertex));
      result.sources.push_back(job.surface().file.points[vertex]);
    }
  if(!options.source_at.empty())
  {
    const typename Domain::Location location = locate(domain, options.source_at, "--source-at");
    sources.emplace_back(location);
    result.sources.push_back(location_point(domain, location));
  }
  if constexpr(is_mesh<Surface_type>)
    if(options.use_boundary)
      GP::border_sources(domain, std::back_inserter(sources));
  if(sources.empty())
    fail(job.input(), "the mesh has no boundary");

  if(is_metric(options.method))
  {
    result.values = metric_distances<Surface_type>(domain, options, job);
    result.triangles = picture_triangles(domain, job);
    return result;
  }
  const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
  result.values.resize(job.surface().file.points.size());
  if(!std::isfinite(options.max_distance))
    check_memory(job,
                 options.method == "automatic" && !speed.empty() ? "euclidean" : options.method);
  Distance_solver<Surface_type> solver(
      domain,
      GP::parameters::method(to_method(options.method)).heat_time_step(options.heat_time_step));
  job.begin_stage("query");
  solver.compute(sources, GP::parameters::maximum_distance(options.max_distance)
                              .relative_tolerance(options.relative_tolerance)
                              .callback(job.progress_callback("distance"))
                              .speed_map(speed_map<typename Domain::Vertex>(speed)));
  for(std::size_t i = 0; i < result.values.size(); ++i)
    result.values[i] = solver.distance(vertex_at<Surface_type>(i));
  result.triangles = picture_triangles(domain, job);
  return result;
}

void check(const Distance_options& options)
{
  if(options.source.empty() && options.source_at.empty() && !options.use_boundary)
    throw Usage_error("distance: --source, --source-at or --source-border is required.");
  if(!options.source.empty())
    parse_indices(options.source, "--source");
  if(!options.source_at.empty())
    parse_point(options.source_at, "--source-at");
  check_method_or_metric(options.method);
  if(is_metric(options.method) && (options.use_boundary || std::isfinite(options.max_distance) ||
                                   options.source.empty() == options.source_at.empty() ||
                                   options.source.find(',') != std::string::npos))
    throw Usage_error("--method " + options.method +
                      ": this method supports exactly one source (--source or --source-at) and no "
                      "--limit.");
  check_basis(options.method, options.basis_size);
  if(!(options.max_distance >= 0.))
    throw Usage_error("--limit: the distance must not be negative.");
  if(!(options.relative_tolerance >= 0.))
    throw Usage_error("--relative-tolerance: the tolerance must not be negative.");
  if(options.relative_tolerance > 0. && options.method != "automatic" && options.method != "exact")
    throw Usage_error("--relative-tolerance: only the method exact has a tolerance.");
  if(options.heat_time_step && options.method != "heat")
    throw Usage_error("--heat-time-step: only the method heat has a time step.");
  if(options.heat_time_step &&
     !(*options.heat_time_step > 0. && std::isfinite(*options.heat_time_step)))
    throw Usage_error("--heat-time-step: the step must be positive and finite.");
  check(options.speed_options, options.method);
}

void run_distance(Job& job, const Distance_options& options)
{
  check(options);
  const Surface& surface = job.read();
  if(!is_metric(options.method))
    check_method(options.method, surface);
  if(!options.source.empty())
    for(const std::size_t vertex : parse_indices(options.source, "--source"))
      check_vertex(surface, vertex);
  if(options.use_boundary && !surface.is_mesh())
    fail(surface.name, "a cloud has no boundary");

  job.begin_stage("prepare");
  Distance_result result;
  visit_domain(job, [&](const auto& domain) { result = compute_distances(domain, options, job); });
  const double largest_distance = report_distances(job, result.values);

  job.begin_stage("write");
  job.write_values([&] { return number_lines(result.values); });
  if(!job.picture().empty())
    draw(job.picture(),
         {&surface.file, result.values, "distance", {}, {}, result.sources, result.triangles});
  if(!job.output().empty())
    write_result(job, "distance", result.values, largest_distance);
  job.finish();
}

} // namespace

void add_distance(CLI::App& program)
{
  Command command(program, "distance",
                  "compute the geodesic distance from each vertex to the nearest source");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Distance_options>();
  command.add("--source", options->source, "V[,V...]", "indices of source vertices");
  command.add("--source-at", options->source_at, "x,y,z",
              "source at the location closest to a point");
  command.add_flag("--source-border", options->use_boundary,
                   "sources at all boundary cycles of a mesh");
  command
      .add("--method", options->method, "NAME",
           "exact, euclidean, fast-marching, dijkstra, heat, or automatic: exact on meshes if the "
           "speeds admit it, otherwise euclidean; or, from a single source and in seconds, the "
           "metrics spectral, emd (optimal transport) or biharmonic")
      .shows_default();
  command.add("--basis", options->basis_size, "K",
              "basis size of emd: 0 is spectral, larger values approximate geodesic distances "
              "better (default 100)");
  command.add("--limit", options->max_distance, "D",
              "maximum distance; vertices beyond it are not reached");
  command.add("--relative-tolerance", options->relative_tolerance, "R",
              "admit errors of exact up to this fraction of each distance, which saves time on "
              "fine meshes (default 0)");
  command.add("--heat-time-step", options->heat_time_step, "M",
              "time step of heat in squared mean edge lengths: larger steps smooth the distances "
              "(default 1)");
  add_speed_options(command, options->speed_options);
  command.set_callback([job, options] { run_distance(*job, *options); });
}

} // namespace program
