// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "picture/Picture.h"
#include "io/Scanner.h"
#include "commands/cloud_paths.h"
#include "app/commands.h"
#include "io/errors.h"

#include <algorithm>

namespace program {

namespace {

struct Surfels_options
{
  bool estimate = false;
  unsigned neighbors = 18;
  double outliers = 0.; // percent
  bool arcs = false;
  Surfel_options surfels;
};

// Estimates normals where that is asked for, and removes outliers; the number of these.
std::size_t prepare(Cloud& cloud, const Surfels_options& options, const Job& job)
{
  const Cloud given = cloud;
  const std::size_t removed = GP::estimate_surfels<CGAL::Parallel_tag>(
      cloud, GP::parameters::number_of_neighbors(options.neighbors)
                 .outlier_percentage(options.outliers)
                 .threads(job.threads()));
  auto radius = cloud.property_map<double>("radius").first;
  cloud.remove_property_map(radius);
  if(!options.estimate)
    for(const Cloud::Index& index : cloud)
      cloud.normal(index) = given.normal(index);
  return removed;
}

void run_surfels(Job& job, const Surfels_options& options)
{
  if(!(options.outliers >= 0.) || !(options.outliers <= 100.))
    throw Usage_error("--outliers: a percentage lies between 0 and 100.");
  const Surface& surface = job.read({"ply", "vtp", "off", "obj"});
  if(surface.is_mesh())
    fail(surface.name, "it is a mesh, surfels are made of points alone");

  job.stage("prepare");
  Cloud cloud = make_cloud(surface);
  const std::size_t removed =
      options.estimate || options.outliers > 0. ? prepare(cloud, options, job) : 0;
  const Path_finder finder = make_path_finder(cloud, {options.surfels}, job);
  job.stage("query");
  Surface_file file = seen_surfels(cloud, finder);
  std::vector<std::uint32_t> place; // of surfels, without outliers
  std::vector<double>&radius = file.properties["radius"], &component = file.properties["component"];
  for(const Cloud::Index& surfel : cloud)
  {
    place.resize(surfel + 1);
    place[surfel] = static_cast<std::uint32_t>(radius.size());
    radius.push_back(finder.radius(surfel));
    component.push_back(double(finder.component(surfel)));
  }
  if(options.arcs)
    finder.for_each_arc(
        [&](Cloud::Index a, Cloud::Index b) {
          file.edges.push_back({place[a], place[b]});
        });
  std::vector<double> sorted = radius;
  std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2),
                   sorted.end());
  const double median = sorted[sorted.size() / 2];
  job.result()["outliers"] = removed;
  job.result()["components"] = finder.number_of_components();
  job.result()["arcs"] = finder.number_of_arcs();
  job.result()["radius"] = json_number(median);
  job.result()["noise"] = json_number(finder.noise());
  job.say("outliers        " + std::to_string(removed));
  job.say("components      " + std::to_string(finder.number_of_components()));
  job.say("arcs            " + std::to_string(finder.number_of_arcs()));
  job.say("median radius   " + readable(median));
  if(options.surfels.noise != GP::Surfel_noise::kept)
    job.say("noise           " + readable(100. * finder.noise()) + " % of the spacing");

  job.stage("write");
  job.write_values([&] { return lines(radius); });
  if(!job.picture().empty())
  {
    Picture picture{&file};
    if(finder.number_of_components() > 1)
      for(const double c : component)
        picture.labels.push_back(static_cast<long long>(c));
    for(const auto& [a, b] : file.edges)
      picture.chains.push_back({file.points[a], file.points[b]});
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
                  "normals, radii and the graph of a cloud; -o writes them, without noise");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Surfels_options>();
  command.add_flag(
      "--estimate", options->estimate,
      "normals anew, although the file has some, by surfaces that are fitted to points");
  command.add("--neighbors", options->neighbors, "K", "that a normal is estimated from")
      .shows_default();
  command.add("--outliers", options->outliers, "P",
              "remove so many percent of the points, those farthest from their neighbours");
  command.add_flag("--arcs", options->arcs, "draw and write the arcs of the graph");
  add_surfel_options(command, options->surfels);
  command.set_run([job, options] { run_surfels(*job, *options); });
}

} // namespace program
