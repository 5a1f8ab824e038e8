// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "io/errors.h"
#include "commands/transports.h"

namespace program {

namespace {

struct Feature_options : Transport_options
{
  bool border = false;
  Region_options region;
};

// The library's part: distances of all vertices.
template <typename Surface_type>
Transport_result distances(const Surface_type& surface, const std::vector<std::size_t>& vertices,
                           const Feature_options& options, Job& job)
{
  const auto domain = GP::make_domain(surface, GP::parameters::threads(job.threads()));
  using Site = typename std::decay_t<decltype(domain)>::Site;
  std::vector<GP::Source<Surface_type>> feature;
  for(const std::size_t vertex : vertices)
    feature.emplace_back(site<Surface_type>(vertex));
  Transport_result result;
  add_sources(domain, options.region, job.surface(), feature, result);
  if constexpr(is_mesh<Surface_type>)
    if(options.border)
      GP::border_sources(surface, std::back_inserter(feature));
  if(feature.empty())
    fail(job.input(), "it has no border");
  job.stage("query");
  result.potential.resize(job.surface().file.points.size());
  const auto find = [&](const auto& np)
  { result.cost = GP::feature_distance(domain, feature, Value_map<Site>{&result.potential}, np); };
  with_preparation<Site>(
      domain, options, job,
      [&](const auto& np)
      { find(np.tolerance(options.tolerance).callback(job.progress("distance to a feature"))); });
  result.triangles = picture_triangles(domain, job);
  return result;
}

void run_feature_distance(Job& job, const Feature_options& options)
{
  if(options.to.empty() && options.region.empty() && !options.border)
    throw Usage_error(
        "feature-distance: give --feature, --feature-at, --feature-path or --border.");
  check(options);
  check(options.region);
  const Surface& surface = job.read();
  check(options.region, surface);
  const std::vector<std::size_t> vertices = options.to.empty()
                                                ? std::vector<std::size_t>()
                                                : region_vertices(options.to, "--feature", surface);
  if(options.border && !surface.is_mesh())
    fail(surface.name, "a cloud has no border");

  job.stage("prepare");
  Transport_result result;
  on_surface(surface, [&](const auto& mesh_or_cloud)
             { result = distances(mesh_or_cloud, vertices, options, job); });
  const double farthest = report_distances(job, result.potential);
  report(job, options, result.cost, "integral");

  job.stage("write");
  job.write_values([&] { return lines(result.potential); });
  if(!job.picture().empty())
  {
    std::vector<Point> marked;
    if(are_vertices(options.to))
      for(const std::size_t vertex : vertices)
        marked.push_back(surface.file.points[vertex]);
    Picture picture{&surface.file, result.potential, "distance"};
    picture.markers = marked;
    picture.triangles = result.triangles;
    add_curves(result, picture);
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
    write_result(job, "distance", result.potential, farthest);
  job.finish();
}

} // namespace

void add_feature_distance(CLI::App& program)
{
  Command command(program, "feature-distance",
                  "distances from a point, a curve, a border or a set, by transport of masses");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Feature_options>();
  command.add("--feature", options->to, "X",
              "vertices V[,V...], or a property that is positive at those of the feature");
  add_region_options(command, options->region, "--feature");
  command.add_flag("--border", options->border, "all borders of a mesh");
  command.add("--tolerance", options->tolerance, "T", "of the gap between the bounds, relative")
      .shows_default();
  command.add("--refine", options->refine, "N", "as in emd");
  add_density_options(command, options->densities);
  command.set_run([job, options] { run_feature_distance(*job, *options); });
}

} // namespace program
