// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "io/write_surface_file.h"
#include "picture/Picture.h"
#include "app/commands.h"
#include "commands/speed_options.h"
#include "io/errors.h"

#include <cmath>
#include <limits>

namespace program {

namespace {

struct Sample_options
{
  std::size_t number = 0;
  double spacing = 0.;
  Speed_options speed_options;
};

struct Sample_result
{
  std::vector<Point> points;
  std::vector<Point> normals;           // of samples of a cloud
  std::vector<double> covering_radii;   // covering radius after each sample
  std::string text;                     // location of each sample: the lines of --values
  std::vector<std::uint32_t> triangles; // of a cloud, for the picture
};

// Computes the samples.
template <typename Domain>
Sample_result find_samples(const Domain& domain, const Sample_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
  job.begin_stage("query");
  Sample_result result;
  std::vector<typename Domain::Location> samples;
  const auto parameters = GP::parameters::random_seed(job.seed())
                              .covering_radius(options.spacing)
                              .covering_radius_output(std::back_inserter(result.covering_radii))
                              .callback(job.progress_callback("samples"))
                              .speed_map(speed_map<typename Domain::Vertex>(speed));
  const std::size_t number =
      options.number > 0 ? options.number : std::numeric_limits<std::size_t>::max();
  GP::farthest_point_sampling(domain, number, std::back_inserter(samples), parameters);
  result.triangles = picture_triangles(domain, job);
  for(const auto& sample : samples)
  {
    result.points.push_back(location_point(domain, sample));
    result.text += location_text(domain, sample) + '\n';
    if constexpr(!is_mesh<Surface_type>)
      result.normals.push_back(job.surface().file.normals[std::size_t(sample.surfel)]);
  }
  return result;
}

void run_sample(Job& job, const Sample_options& options)
{
  if((options.number == 0) == (options.spacing == 0.))
    throw Usage_error(
        "sample: either --number (at least 1) or --spacing (positive) is required, but "
        "not both.");
  if(!(options.spacing >= 0.) || std::isinf(options.spacing))
    throw Usage_error("--spacing: the distance must be finite and not negative.");
  check(options.speed_options);
  const Surface& surface = job.read();

  job.begin_stage("prepare");
  Sample_result result;
  visit_domain(job, [&](const auto& domain) { result = find_samples(domain, options, job); });
  const double radius = result.covering_radii.empty() ? std::numeric_limits<double>::infinity()
                                                      : result.covering_radii.back();
  job.result()["samples"] = result.points.size();
  job.result()["covering_radius"] = json_number(radius);
  job.print_line("samples          " + std::to_string(result.points.size()));
  job.print_line("covering radius  " + rounded_text(radius));

  job.begin_stage("write");
  job.write_values([&] { return result.text; });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file};
    picture.markers = result.points;
    picture.triangles = result.triangles;
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
  {
    Surface_file file;
    file.points = result.points;
    file.normals = result.normals;
    file.properties["covering_radius"] = result.covering_radii;
    write_surface_file(job.output(), file, "covering_radius");
  }
  job.finish();
}

} // namespace

void add_sample(CLI::App& program)
{
  Command command(program, "sample", "compute evenly spaced samples by farthest point sampling");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Sample_options>();
  command.add("--number", options->number, "N", "number of samples");
  command.add("--spacing", options->spacing, "D",
              "maximum distance from any vertex to the nearest sample");
  add_speed_options(command, options->speed_options);
  command.set_callback([job, options] { run_sample(*job, *options); });
}

} // namespace program
