// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "io/errors.h"
#include "commands/transport_utilities.h"

namespace program {

namespace {

struct Fuzzy_options : Transport_options
{
  std::optional<double> width;
  bool by_distances = false;
};

std::size_t parse_vertex(const std::string& text, const std::string& option)
{
  const std::vector<std::size_t> vertices = parse_indices(text, option);
  if(vertices.size() != 1)
    throw Usage_error(option + ": exactly one vertex is required.");
  return vertices[0];
}

// Computes the likelihood of each vertex.
template <typename Domain>
Transport_result compute_likelihoods(const Domain& domain, std::size_t from, std::size_t to,
                                     const Fuzzy_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  using Vertex = typename Domain::Vertex;
  const Vertex p = vertex_at<Surface_type>(from), q = vertex_at<Surface_type>(to);
  job.begin_stage("query");
  Transport_result result;
  result.potential.resize(job.surface().file.points.size());
  const Value_map<Vertex> map{&result.potential};
  const auto compute = [&](const auto& np)
  {
    if(options.by_distances)
      return GP::fuzzy_geodesic_by_distances(domain, p, q, map, np);
    const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
    const auto parameters = preparation(domain, options, speed)
                                .tolerance(options.tolerance)
                                .callback(job.progress_callback("transport"));
    if(options.width)
      result.cost = GP::fuzzy_geodesic(domain, p, q, map, parameters.width(*options.width));
    else
      result.cost = GP::fuzzy_geodesic(domain, p, q, map, parameters);
  };
  if(options.width)
    compute(GP::parameters::width(*options.width));
  else
    compute(GP::parameters::number_of_threads(job.threads()));
  result.triangles = picture_triangles(domain, job);
  return result;
}

void run_fuzzy(Job& job, const Fuzzy_options& options)
{
  if(options.from.empty() || options.to.empty())
    throw Usage_error("fuzzy: --from and --to are required.");
  const std::size_t from = parse_vertex(options.from, "--from"),
                    to = parse_vertex(options.to, "--to");
  if(from == to)
    throw Usage_error("fuzzy: --from and --to must be different vertices.");
  if(options.width && !(*options.width > 0.))
    throw Usage_error("--width: the width must be positive.");
  check(options);
  const Surface& surface = job.read();
  check_vertex(surface, from);
  check_vertex(surface, to);

  job.begin_stage("prepare");
  Transport_result result;
  visit_domain(job, [&](const auto& domain)
               { result = compute_likelihoods(domain, from, to, options, job); });
  if(!options.by_distances)
    report(job, options, result.cost, "cost");

  job.begin_stage("write");
  job.write_values([&] { return number_lines(result.potential); });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file, result.potential, "likelihood"};
    picture.markers = {surface.file.points[from], surface.file.points[to]};
    picture.triangles = result.triangles;
    picture.show_isolines = options.by_distances;
    for(std::size_t i = 0; i < result.potential.size(); ++i)
      if(result.potential[i] > 0.3)
        picture.visible_points.push_back(surface.file.points[i]);
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
    write_result(job, "likelihood", result.potential, 1.);
  job.finish();
}

} // namespace

void add_fuzzy(CLI::App& program)
{
  Command command(
      program, "fuzzy",
      "compute the likelihood that shortest paths between two vertices pass each vertex");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Fuzzy_options>();
  command.add("--from", options->from, "V", "index of the first vertex");
  command.add("--to", options->to, "V", "index of the second vertex");
  command.add("--width", options->width, "W",
              "standard deviation of the Gaussian masses around both vertices (default: 1/20 of "
              "their distance)");
  command.add_flag("--by-distances", options->by_distances,
                   "compute the likelihood from the length of the detour through each vertex, "
                   "relative to --width, instead of from a flow");
  command
      .add("--tolerance", options->tolerance, "T",
           "maximum gap between lower and upper bound, relative to the upper bound")
      .shows_default();
  command.add("--refine", options->refine, "N", "number of 1-to-4 refinements, as for emd");
  add_speed_options(command, options->speed_options);
  command.set_callback([job, options] { run_fuzzy(*job, *options); });
}

} // namespace program
