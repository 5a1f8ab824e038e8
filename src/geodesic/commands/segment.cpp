// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "picture/Picture.h"
#include "app/commands.h"
#include "commands/densities.h"
#include "io/errors.h"

#include <iterator>
#include <map>
#include <utility>

namespace program {

namespace {

struct Segment_options
{
  std::size_t number = 0;
  std::size_t iterations = 20;
  bool makes_discs = false;
  Density_options densities;
};

struct Result
{
  std::vector<long long> labels; // #polygons, of a cloud #points
  std::vector<Point> centers;
  std::vector<double> energies;
  std::vector<std::uint32_t> triangles; // of a cloud, for the picture
};

// The library's part: the cells.
template <typename Surface_type>
Result find_cells(const Surface_type& surface, const Segment_options& options, Job& job)
{
  const auto domain = GP::make_domain(surface, GP::parameters::threads(job.threads()));
  using Domain = std::decay_t<decltype(domain)>;
  const std::vector<double> speed = speeds(domain, options.densities, job);
  job.stage("query");
  Result result;
  const Surface_file& file = job.surface().file;
  result.labels.assign(is_mesh<Surface_type> ? file.number_of_polygons() : file.points.size(), -1);
  std::vector<typename Domain::Location> centers;
  const auto asked = GP::parameters::random_seed(job.seed())
                         .threads(job.threads())
                         .maximum_number_of_iterations(unsigned(options.iterations))
                         .do_make_discs(options.makes_discs)
                         .center_output(std::back_inserter(centers))
                         .energy_output(std::back_inserter(result.energies))
                         .callback(job.progress("cells"));
  const auto find = [&](const auto& labels)
  {
    with_speeds<typename Domain::Site>(
        speed, asked,
        [&](const auto& np)
        {
          GP::geodesic_centroidal_tessellation<GP::Euclidean_front, CGAL::Parallel_tag>(
              domain, options.number, labels, np);
        });
  };
  if constexpr(is_mesh<Surface_type>)
    find(Label_map<typename Surface_type::Face_index>{&result.labels});
  else
    find(Label_map<typename Domain::Site>{&result.labels});
  for(const auto& center : centers)
    result.centers.push_back(coordinates(domain.point(domain.inner(center))));
  result.triangles = picture_triangles(domain, job);
  return result;
}

// The mesh cut along the borders of its patches, with their labels at the vertices.
Surface_file cut_apart(const Surface_file& mesh, const std::vector<long long>& labels)
{
  Surface_file result;
  result.first = mesh.first;
  std::vector<double>& label = result.properties["label"];
  std::map<std::pair<std::uint32_t, long long>, std::uint32_t> copies;
  for(std::size_t f = 0; f < mesh.number_of_polygons(); ++f)
    for(std::size_t corner = mesh.first[f]; corner < mesh.first[f + 1]; ++corner)
    {
      const std::uint32_t point = mesh.corners[corner];
      const auto [copy, is_new] =
          copies.try_emplace({point, labels[f]}, static_cast<std::uint32_t>(result.points.size()));
      if(is_new)
      {
        result.points.push_back(mesh.points[point]);
        label.push_back(static_cast<double>(labels[f]));
      }
      result.corners.push_back(copy->second);
    }
  return result;
}

void run_segment(Job& job, const Segment_options& options)
{
  if(options.number == 0)
    throw Usage_error("segment: give --number, at least 1.");
  check(options.densities);
  const Surface& surface = job.read();
  if(options.makes_discs && !surface.is_mesh())
    throw Input_error(job.input() + ": a cloud has no faces, which --discs needs.");

  job.stage("prepare");
  Result result;
  on_surface(surface,
             [&](const auto& mesh_or_cloud) { result = find_cells(mesh_or_cloud, options, job); });
  job.result()["charts"] = result.centers.size();
  job.result()["energy"] = json_number(result.energies.back());
  job.result()["energies"] = result.energies;
  job.say("charts          " + std::to_string(result.centers.size()));
  job.say("energy          " + readable(result.energies.back()) + ", " +
          readable(result.energies.front()) + " at the start");
  report_unreached(job, result.labels);

  job.stage("write");
  job.write_values([&] { return labels_text(result.labels); });
  Surface_file file = surface.file;
  if(surface.is_mesh())
    file = cut_apart(file, result.labels);
  else
    file.properties["label"].assign(result.labels.begin(), result.labels.end());
  if(!job.picture().empty())
  {
    Picture picture{&file};
    const std::vector<double>& labels = file.properties.at("label");
    picture.labels.assign(labels.begin(), labels.end());
    picture.triangles = result.triangles;
    picture.markers = result.centers;
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
    write_surface_file(job.output(), file, "label");
  job.finish();
}

} // namespace

void add_segment(CLI::App& program)
{
  Command command(program, "segment", "charts of about equal size, about their centres of mass");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Segment_options>();
  command.add("--number", options->number, "N", "of charts");
  command.add("--iterations", options->iterations, "N", "steps of centres at most (20)");
  command.add_flag("--discs", options->makes_discs, "each chart a disc, by more of them");
  add_density_options(command, options->densities);
  command.set_run([job, options] { run_segment(*job, *options); });
}

} // namespace program
