// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "io/write_surface_file.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "commands/cloud_paths.h"
#include "app/commands.h"
#include "io/errors.h"

#include <algorithm>

namespace program {

namespace {

struct Surfels_options
{
  bool estimate_normals = false;
  unsigned neighbors = 18;
  double outlier_percentage = 0.; // percent
  bool graph_edges = false;
  Surfel_options surfels;
};

// Estimates normals if requested, and removes outliers. Returns the number of outliers.
std::size_t prepare_cloud(Cloud& cloud, const Surfels_options& options, const Job& job)
{
  const Cloud original = cloud;
  const std::size_t removed = GP::estimate_surfels<CGAL::Parallel_tag>(
      cloud, GP::parameters::number_of_neighbors(options.neighbors)
                 .outlier_percentage(options.outlier_percentage)
                 .number_of_threads(job.threads()));
  auto radius = cloud.add_property_map<double>("radius").first; // the existing map
  cloud.remove_property_map(radius);
  if(!options.estimate_normals)
    for(const Cloud::Index& index : cloud)
      cloud.normal(index) = original.normal(index);
  return removed;
}

void run_surfels(Job& job, const Surfels_options& options)
{
  if(!(options.outlier_percentage >= 0.) || !(options.outlier_percentage <= 100.))
    throw Usage_error("--outliers: the percentage must be between 0 and 100.");
  const Surface& surface = job.read({"ply", "vtp", "off", "obj"});
  if(surface.is_mesh())
    fail(surface.name, "surfels needs a cloud, but the input is a mesh");

  job.begin_stage("prepare");
  Cloud cloud = make_cloud(surface);
  const std::size_t removed = options.estimate_normals || options.outlier_percentage > 0.
                                  ? prepare_cloud(cloud, options, job)
                                  : 0;
  const Path_finder finder = make_path_finder(cloud, {options.surfels}, job);
  job.begin_stage("query");
  Surface_file file = denoised_surfels(cloud, finder);
  std::vector<std::uint32_t> position; // output indices of surfels, without outliers
  std::vector<double>&radius = file.properties["radius"], &component = file.properties["component"];
  for(const Cloud::Index& surfel : cloud)
  {
    position.resize(surfel + 1);
    position[surfel] = static_cast<std::uint32_t>(radius.size());
    radius.push_back(finder.radius(surfel));
    component.push_back(double(finder.component(surfel)));
  }
  if(options.graph_edges)
    finder.for_each_edge(
        [&](Cloud::Index a, Cloud::Index b) {
          file.edges.push_back({position[a], position[b]});
        });
  std::vector<double> sorted = radius;
  std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2),
                   sorted.end());
  const double median = sorted[sorted.size() / 2];
  job.result()["outliers"] = removed;
  job.result()["components"] = finder.number_of_components();
  job.result()["arcs"] = finder.number_of_edges();
  job.result()["radius"] = json_number(median);
  job.result()["noise"] = json_number(finder.noise());
  job.print_line("outliers        " + std::to_string(removed));
  job.print_line("components      " + std::to_string(finder.number_of_components()));
  job.print_line("arcs            " + std::to_string(finder.number_of_edges()));
  job.print_line("median radius   " + rounded_text(median));
  if(options.surfels.noise != GP::Surfel_noise::kept)
    job.print_line("noise           " + rounded_text(100. * finder.noise()) + " % of the spacing");

  job.begin_stage("write");
  job.write_values([&] { return number_lines(radius); });
  if(!job.picture().empty())
  {
    Picture picture{&file};
    if(finder.number_of_components() > 1)
      for(const double c : component)
        picture.labels.push_back(static_cast<long long>(c));
    for(const auto& [a, b] : file.edges)
      picture.thin_polylines.push_back({file.points[a], file.points[b]});
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
    write_surface_file(job.output(), file);
  job.finish();
}

} // namespace

void add_surfels(CLI::App& program)
{
  Command command(program, "surfels",
                  "compute normals, radii and the surfel graph of a cloud; -o writes the denoised "
                  "surfels");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Surfels_options>();
  command.add_flag("--estimate", options->estimate_normals,
                   "estimate new normals by fitted quadrics, even if the file contains normals");
  command
      .add("--neighbors", options->neighbors, "K",
           "number of neighbors from which a normal is estimated")
      .shows_default();
  command.add("--outliers", options->outlier_percentage, "P",
              "percentage of outliers: remove the points with the largest distances to their "
              "neighbors");
  command.add_flag("--arcs", options->graph_edges, "write and draw the edges of the graph");
  add_surfel_options(command, options->surfels);
  command.set_callback([job, options] { run_surfels(*job, *options); });
}

} // namespace program
