// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "io/errors.h"
#include "commands/transport_utilities.h"

namespace program {

namespace {

struct Feature_options : Transport_options
{
  bool use_boundary = false, do_fix_masses = false;
  Region_options region;
};

// Computes the distance of each vertex by optimal transport.
template <typename Domain>
Transport_result compute_distances(const Domain& domain, const std::vector<std::size_t>& vertices,
                                   const Feature_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  using Vertex = typename Domain::Vertex;
  std::vector<GP::Source<Surface_type>> feature;
  for(const std::size_t vertex : vertices)
    feature.emplace_back(vertex_at<Surface_type>(vertex));
  Transport_result result;
  add_sources(domain, options.region, job.surface(), feature, result);
  if constexpr(is_mesh<Surface_type>)
    if(options.use_boundary)
      GP::border_sources(domain, std::back_inserter(feature));
  if(feature.empty())
    fail(job.input(), "the mesh has no boundary");
  job.begin_stage("query");
  result.potential.resize(job.surface().file.points.size());
  const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
  result.cost = GP::feature_distance(domain, feature, Value_map<Vertex>{&result.potential},
                                     preparation(domain, options, speed)
                                         .tolerance(options.tolerance)
                                         .do_fix_masses(options.do_fix_masses)
                                         .callback(job.progress_callback("distance to a feature")));
  result.triangles = picture_triangles(domain, job);
  return result;
}

void run_feature_distance(Job& job, const Feature_options& options)
{
  if(options.to.empty() && options.region.empty() && !options.use_boundary)
    throw Usage_error("feature-distance: --feature, --feature-at, --feature-path or --border is "
                      "required.");
  check(options);
  check(options.region);
  const Surface& surface = job.read();
  check(options.region, surface);
  const std::vector<std::size_t> vertices = options.to.empty()
                                                ? std::vector<std::size_t>()
                                                : region_vertices(options.to, "--feature", surface);
  if(options.use_boundary && !surface.is_mesh())
    fail(surface.name, "a cloud has no boundary");

  job.begin_stage("prepare");
  Transport_result result;
  visit_domain(job, [&](const auto& domain)
               { result = compute_distances(domain, vertices, options, job); });
  const double largest_distance = report_distances(job, result.potential);
  report(job, options, result.cost, "integral");

  job.begin_stage("write");
  job.write_values([&] { return number_lines(result.potential); });
  if(!job.picture().empty())
  {
    std::vector<Point> marked_vertices;
    if(is_vertex_list(options.to))
      for(const std::size_t vertex : vertices)
        marked_vertices.push_back(surface.file.points[vertex]);
    Picture picture{&surface.file, result.potential, "distance"};
    picture.markers = marked_vertices;
    picture.triangles = result.triangles;
    add_feature_polylines(result, picture);
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
    write_result(job, "distance", result.potential, largest_distance);
  job.finish();
}

} // namespace

void add_feature_distance(CLI::App& program)
{
  Command command(program, "feature-distance",
                  "compute distances from vertices, locations, paths or boundaries by optimal "
                  "transport");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Feature_options>();
  command.add("--feature", options->to, "X",
              "vertex indices V[,V...], or a property that is positive at the feature vertices");
  add_region_options(command, options->region, "--feature");
  command.add_flag("--border", options->use_boundary, "all boundary cycles of a mesh");
  command.add_flag(
      "--fixed-masses", options->do_fix_masses,
      "distribute the arriving mass uniformly over the feature; the result is then the "
      "dual potential, which is a distance only for a single point");
  command
      .add("--tolerance", options->tolerance, "T",
           "maximum gap between lower and upper bound, relative to the upper bound")
      .shows_default();
  command.add("--refine", options->refine, "N", "number of 1-to-4 refinements, as for emd");
  add_speed_options(command, options->speed_options);
  command.set_callback([job, options] { run_feature_distance(*job, *options); });
}

} // namespace program
