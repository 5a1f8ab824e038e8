// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "io/write_surface_file.h"
#include "picture/Picture.h"
#include "app/commands.h"
#include "commands/speed_options.h"
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
  bool make_disks = false;
  Speed_options speed_options;
};

struct Segment_result
{
  std::vector<long long> labels; // #polygons of a mesh, #points of a cloud
  std::vector<Point> centers;
  std::vector<double> energies;
  std::vector<std::uint32_t> triangles; // of a cloud, for the picture
};

// Computes the cells.
template <typename Domain>
Segment_result find_cells(const Domain& domain, const Segment_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
  job.begin_stage("query");
  Segment_result result;
  const Surface_file& file = job.surface().file;
  result.labels.assign(is_mesh<Surface_type> ? file.number_of_polygons() : file.points.size(), -1);
  std::vector<typename Domain::Location> centers;
  const auto parameters = GP::parameters::random_seed(job.seed())
                              .number_of_threads(job.threads())
                              .maximum_number_of_iterations(unsigned(options.iterations))
                              .do_make_discs(options.make_disks)
                              .center_output(std::back_inserter(centers))
                              .energy_output(std::back_inserter(result.energies))
                              .callback(job.progress_callback("cells"))
                              .speed_map(speed_map<typename Domain::Vertex>(speed));
  const auto tessellate = [&](const auto& labels)
  {
    GP::geodesic_centroidal_tessellation<GP::Euclidean_front, CGAL::Parallel_tag>(
        domain, options.number, labels, parameters);
  };
  if constexpr(is_mesh<Surface_type>)
    tessellate(Label_map<typename Surface_type::Face_index>{&result.labels});
  else
    tessellate(Label_map<typename Domain::Vertex>{&result.labels});
  for(const auto& center : centers)
    result.centers.push_back(location_point(domain, center));
  result.triangles = picture_triangles(domain, job);
  return result;
}

// Returns the mesh cut along the boundaries of its patches, with the labels as a vertex property.
// Vertices are duplicated per label.
Surface_file split_along_boundaries(const Surface_file& mesh, const std::vector<long long>& labels)
{
  Surface_file result;
  result.polygon_begin = mesh.polygon_begin;
  std::vector<double>& label = result.properties["label"];
  std::map<std::pair<std::uint32_t, long long>, std::uint32_t> copies;
  for(std::size_t f = 0; f < mesh.number_of_polygons(); ++f)
    for(std::size_t corner = mesh.polygon_begin[f]; corner < mesh.polygon_begin[f + 1]; ++corner)
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
    throw Usage_error("segment: --number is required and must be at least 1.");
  check(options.speed_options);
  const Surface& surface = job.read();
  if(options.make_disks && !surface.is_mesh())
    throw Input_error(job.input() + ": --discs needs a mesh, but the input is a cloud.");

  job.begin_stage("prepare");
  Segment_result result;
  visit_domain(job, [&](const auto& domain) { result = find_cells(domain, options, job); });
  job.result()["charts"] = result.centers.size();
  job.result()["energy"] = json_number(result.energies.back());
  job.result()["energies"] = result.energies;
  job.print_line("charts          " + std::to_string(result.centers.size()));
  job.print_line("energy          " + rounded_text(result.energies.back()) + ", " +
                 rounded_text(result.energies.front()) + " initially");
  report_unreached(job, result.labels);

  job.begin_stage("write");
  job.write_values([&] { return labels_text(result.labels); });
  Surface_file file = surface.file;
  if(surface.is_mesh())
    file = split_along_boundaries(file, result.labels);
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
  Command command(program, "segment", "divide the surface into charts of about equal size");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Segment_options>();
  command.add("--number", options->number, "N", "number of charts");
  command.add("--iterations", options->iterations, "N",
              "maximum number of iterations that move the centers (default 20)");
  command.add_flag("--disks,--discs", options->make_disks,
                   "add charts until each chart is a topological disk");
  add_speed_options(command, options->speed_options);
  command.set_callback([job, options] { run_segment(*job, *options); });
}

} // namespace program
