// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output_file.h"
#include "Picture.h"
#include "Scanner.h"
#include "commands.h"
#include "farthest_vertices.h"
#include "queries.h"

#include <algorithm>
#include <cmath>

namespace program {

namespace {

struct Voronoi_options
{
  std::size_t number = 0;
  std::string seeds; // "V,V,..."
};

struct Result
{
  std::vector<std::size_t> seeds;
  std::vector<long long> labels; // #vertices: the place of the nearest seed, -1 where none reaches
  std::vector<double> values;    // #vertices: its distance
  std::vector<std::uint32_t> triangles; // of a cloud, for the picture
};

// The library's part: seeds, and the nearest one of each vertex.
template <typename Surface_type>
Result find_cells(const Surface_type& surface, const Voronoi_options& options, Job& job)
{
  const auto domain = GP::make_domain(surface, GP::parameters::threads(job.threads()));
  GP::Geodesic_distance_solver<Surface_type> solver(domain);
  job.stage("query");
  Result result;
  if(!options.seeds.empty())
    result.seeds = parse_integers(options.seeds, "--seeds");
  else
    result.seeds = farthest_vertices(solver, options.number, job);

  std::vector<GP::Source<Surface_type>> sources;
  for(const std::size_t seed : result.seeds)
    sources.emplace_back(site<Surface_type>(seed));
  solver.compute(sources);
  result.triangles = picture_triangles(domain, job);
  const std::size_t n = job.surface().file.points.size();
  result.labels.resize(n);
  result.values.resize(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    result.values[i] = solver.distance(site<Surface_type>(i));
    result.labels[i] = std::isfinite(result.values[i])
                           ? static_cast<long long>(solver.source_label(site<Surface_type>(i)))
                           : -1;
  }
  return result;
}

void run_voronoi(Job& job, const Voronoi_options& options)
{
  if((options.number == 0) == options.seeds.empty())
    throw Usage_error("voronoi: give either --number, at least 1, or --seeds.");
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
  const auto unreached = std::count(result.labels.begin(), result.labels.end(), -1);
  job.result()["seeds"] = result.seeds;
  job.result()["unreached"] = unreached;
  job.say("seeds           " + std::to_string(result.seeds.size()));
  if(unreached > 0)
    job.say("unreached       " + std::to_string(unreached) + " of " +
            std::to_string(result.labels.size()));

  job.stage("write");
  if(!job.values().empty())
  {
    std::string text;
    for(const long long label : result.labels)
      text += std::to_string(label) + '\n';
    job.write_values(text);
  }
  if(!job.picture().empty())
  {
    Picture picture{&surface.file, {}, "", result.labels, {}, {}, result.triangles};
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
  CLI::App* const command =
      program.add_subcommand("voronoi", "labels: which of the seeds is nearest");
  const auto job = std::make_shared<Job>(*command);
  const auto options = std::make_shared<Voronoi_options>();
  command->add_option("--number", options->number, "of seeds, spread by farthest vertices")
      ->type_name("N");
  command->add_option("--seeds", options->seeds, "vertices by their place in the file")
      ->type_name("V[,V...]");
  command->callback([job, options] { run_voronoi(*job, *options); });
}

} // namespace program
