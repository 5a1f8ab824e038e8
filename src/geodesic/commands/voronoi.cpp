// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "commands/speed_options.h"
#include "io/errors.h"

namespace program {

namespace {

struct Voronoi_options
{
  std::size_t number = 0;
  std::string seeds; // "V,V,..."
  Speed_options speed_options;
};

struct Voronoi_result
{
  std::vector<std::size_t> seeds;
  std::vector<long long> labels; // #vertices: index of the nearest seed, or -1 if unreached
  // For the picture:
  std::vector<std::vector<Point>> bisectors; // between the cells of a mesh
  std::vector<std::uint32_t> triangles;      // of a cloud
};

// Computes the seeds, the nearest seed of each vertex and the bisectors.
template <typename Domain>
Voronoi_result find_cells(const Domain& domain, const Voronoi_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  using Vertex = typename Domain::Vertex;
  const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
  job.begin_stage("query");
  Voronoi_result result;
  result.seeds = options.seeds.empty() ? farthest_vertices(domain, options.number, job, speed)
                                       : parse_indices(options.seeds, "--seeds");
  std::vector<Vertex> seeds;
  for(const std::size_t seed : result.seeds)
    seeds.push_back(vertex_at<Surface_type>(seed));
  result.labels.assign(job.surface().file.points.size(), -1);
  const Label_map<Vertex> labels{&result.labels};
  const auto asked =
      GP::parameters::callback(job.progress_callback("cells")).speed_map(speed_map<Vertex>(speed));
  if constexpr(is_mesh<Surface_type>)
  {
    std::vector<GP::Voronoi_bisector<Surface_type>> bisectors;
    GP::geodesic_voronoi_diagram(domain, seeds, labels,
                                 asked.bisector_output(std::back_inserter(bisectors)));
    for(const auto& bisector : bisectors)
      result.bisectors.push_back(coordinates_of(bisector.points));
  }
  else
    GP::geodesic_voronoi_diagram(domain, seeds, labels, asked);
  result.triangles = picture_triangles(domain, job);
  return result;
}

void run_voronoi(Job& job, const Voronoi_options& options)
{
  if((options.number == 0) == options.seeds.empty())
    throw Usage_error(
        "voronoi: either --number (at least 1) or --seeds is required, but not both.");
  check(options.speed_options);
  if(!options.seeds.empty())
    parse_indices(options.seeds, "--seeds");
  const Surface& surface = job.read();
  if(!options.seeds.empty())
    for(const std::size_t vertex : parse_indices(options.seeds, "--seeds"))
      check_vertex(surface, vertex);

  job.begin_stage("prepare");
  Voronoi_result result;
  visit_domain(job, [&](const auto& domain) { result = find_cells(domain, options, job); });
  job.result()["seeds"] = result.seeds;
  job.print_line("seeds           " + std::to_string(result.seeds.size()));
  report_unreached(job, result.labels);

  job.begin_stage("write");
  job.write_values([&] { return labels_text(result.labels); });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file, {}, "", result.labels, result.bisectors, {}, result.triangles};
    for(const std::size_t seed : result.seeds)
      picture.markers.push_back(surface.file.points[seed]);
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
  {
    std::vector<double> labels(result.labels.begin(), result.labels.end());
    write_result(job, "label", labels, static_cast<double>(result.seeds.size()));
  }
  job.finish();
}

} // namespace

void add_voronoi(CLI::App& program)
{
  Command command(program, "voronoi",
                  "compute geodesic Voronoi cells: label each vertex with its nearest seed");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Voronoi_options>();
  command.add("--number", options->number, "N",
              "number of seeds, selected by farthest point sampling");
  command.add("--seeds", options->seeds, "V[,V...]", "indices of the seed vertices");
  add_speed_options(command, options->speed_options);
  command.set_callback([job, options] { run_voronoi(*job, *options); });
}

} // namespace program
