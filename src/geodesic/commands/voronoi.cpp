// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "picture/Picture.h"
#include "io/Scanner.h"
#include "app/commands.h"
#include "commands/densities.h"

namespace program {

namespace {

struct Voronoi_options
{
  std::size_t number = 0;
  std::string seeds; // "V,V,..."
  Density_options densities;
};

struct Result
{
  std::vector<std::size_t> seeds;
  std::vector<long long> labels; // #vertices: the place of the nearest seed, -1 where none reaches
  // For the picture:
  std::vector<std::vector<Point>> lines; // between the cells of a mesh
  std::vector<std::uint32_t> triangles;  // of a cloud
};

// The library's part: seeds, the nearest one of each vertex, and the lines between.
template <typename Surface_type>
Result find_cells(const Surface_type& surface, const Voronoi_options& options, Job& job)
{
  const auto domain = GP::make_domain(surface, GP::parameters::threads(job.threads()));
  using Site = typename std::decay_t<decltype(domain)>::Site;
  const std::vector<double> speed = speeds(domain, options.densities, job);
  job.stage("query");
  Result result;
  result.seeds = options.seeds.empty() ? farthest_vertices(domain, options.number, job, speed)
                                       : parse_integers(options.seeds, "--seeds");
  std::vector<Site> seeds;
  for(const std::size_t seed : result.seeds)
    seeds.push_back(site<Surface_type>(seed));
  result.labels.assign(job.surface().file.points.size(), -1);
  const Label_map<Site> labels{&result.labels};
  const auto progress = GP::parameters::callback(job.progress("cells"));
  if constexpr(is_mesh<Surface_type>)
  {
    std::vector<GP::Voronoi_bisector<Surface_type>> lines;
    with_speeds<Site>(speed, progress.bisector_output(std::back_inserter(lines)),
                      [&](const auto& np)
                      { GP::geodesic_voronoi_diagram(domain, seeds, labels, np); });
    for(const auto& line : lines)
    {
      result.lines.emplace_back();
      for(const auto& p : line.points)
        result.lines.back().push_back(coordinates(p));
    }
  }
  else
    with_speeds<Site>(speed, progress,
                      [&](const auto& np)
                      { GP::geodesic_voronoi_diagram(domain, seeds, labels, np); });
  result.triangles = picture_triangles(domain, job);
  return result;
}

void run_voronoi(Job& job, const Voronoi_options& options)
{
  if((options.number == 0) == options.seeds.empty())
    throw Usage_error("voronoi: give either --number, at least 1, or --seeds.");
  check(options.densities);
  if(!options.seeds.empty())
    parse_integers(options.seeds, "--seeds");
  const Surface& surface = job.read();
  if(!options.seeds.empty())
    for(const std::size_t vertex : parse_integers(options.seeds, "--seeds"))
      check_vertex(surface, vertex);

  job.stage("prepare");
  Result result;
  on_surface(surface,
             [&](const auto& mesh_or_cloud) { result = find_cells(mesh_or_cloud, options, job); });
  job.result()["seeds"] = result.seeds;
  job.say("seeds           " + std::to_string(result.seeds.size()));
  report_unreached(job, result.labels);

  job.stage("write");
  job.write_values([&] { return labels_text(result.labels); });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file, {}, "", result.labels, result.lines, {}, result.triangles};
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
  Command command(program, "voronoi", "labels: which of the seeds is nearest");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Voronoi_options>();
  command.add("--number", options->number, "N", "of seeds, spread by farthest vertices");
  command.add("--seeds", options->seeds, "V[,V...]", "vertices by their place in the file");
  add_density_options(command, options->densities);
  command.set_run([job, options] { run_voronoi(*job, *options); });
}

} // namespace program
