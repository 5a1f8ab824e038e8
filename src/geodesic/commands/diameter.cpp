// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/Picture.h"
#include "app/commands.h"
#include "commands/command_utilities.h"
#include "io/errors.h"

namespace program {

namespace {

struct Diameter_options
{
  double tolerance = 0.01;
  std::size_t max_iterations = 100;
  bool use_radius = false;
};

// The shortest path between two vertices, and the distances from one of them.
struct Diameter_path
{
  std::vector<Point> points;
  std::vector<double> distances; // #vertices
};

Diameter_path find_diameter_path(const Mesh_domain& domain, Mesh::Vertex_index from,
                                 Mesh::Vertex_index to, const Job& job)
{
  Distance_solver<Mesh> solver(domain, GP::parameters::method(Distance_method::exact));
  solver.compute(from);
  Diameter_path result;
  result.points = coordinates_of(solver.path(to).points);
  for(std::size_t i = 0; i < job.surface().file.points.size(); ++i)
    result.distances.push_back(solver.distance(vertex_at<Mesh>(i)));
  return result;
}

void run_diameter(Job& job, const Diameter_options& options)
{
  if(!(options.tolerance >= 0.))
    throw Usage_error("--tolerance: the tolerance must not be negative.");
  if(options.max_iterations == 0)
    throw Usage_error("--iterations: the number must be positive.");
  const Surface& surface = job.read({"vtp", "ply", "obj"});
  if(!surface.is_mesh())
    fail(surface.name, "bounds of the diameter need a mesh, because they need exact distances");

  job.begin_stage("prepare");
  const Mesh_domain& domain = *surface.domain;
  check_memory(job, "exact");
  job.begin_stage("query");
  const auto np = GP::parameters::relative_tolerance(options.tolerance)
                      .maximum_number_of_iterations(options.max_iterations)
                      .callback(job.progress_callback("diameter"));
  const GP::Geodesic_diameter<Mesh> diameter = GP::geodesic_diameter(domain, np);
  job.result()["lower"] = json_number(diameter.lower);
  job.result()["upper"] = json_number(diameter.upper);
  job.result()["from"] = std::size_t(diameter.from);
  job.result()["to"] = std::size_t(diameter.to);
  job.result()["converged"] = diameter.is_converged;
  job.result()["iterations"] = diameter.number_of_iterations;
  job.print_line("diameter        " + rounded_text(diameter.lower) + " to " +
                 rounded_text(diameter.upper));
  job.print_line("vertices        " + std::to_string(std::size_t(diameter.from)) + " and " +
                 std::to_string(std::size_t(diameter.to)));
  bool is_converged = diameter.is_converged;
  if(options.use_radius)
  {
    const GP::Geodesic_radius<Mesh> radius = GP::geodesic_radius(domain, np);
    job.result()["radius_lower"] = json_number(radius.lower);
    job.result()["radius_upper"] = json_number(radius.upper);
    job.result()["center"] = std::size_t(radius.center);
    job.result()["radius_converged"] = radius.is_converged;
    job.result()["radius_iterations"] = radius.number_of_iterations;
    job.print_line("radius          " + rounded_text(radius.lower) + " to " +
                   rounded_text(radius.upper));
    job.print_line("center          " + std::to_string(std::size_t(radius.center)));
    is_converged = is_converged && radius.is_converged;
  }
  if(!is_converged)
    job.print_warning("the bounds differ by more than --tolerance");
  Diameter_path path;
  if(!job.output().empty() || !job.picture().empty() || !job.values().empty())
    path = find_diameter_path(domain, diameter.from, diameter.to, job);

  job.begin_stage("write");
  job.write_values([&] { return points_text(path.points); });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file};
    picture.values = path.distances;
    picture.title = "distance";
    picture.polylines = {path.points};
    picture.markers = {path.points.front(), path.points.back()};
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
    write_polylines(job, {path.points});
  job.finish();
}

} // namespace

void add_diameter(CLI::App& program)
{
  Command command(program, "diameter",
                  "compute bounds of the largest distance between two vertices of a mesh");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output", "write the longest shortest path that was found: .ply .obj .vtp");
  const auto options = std::make_shared<Diameter_options>();
  command
      .add("--tolerance", options->tolerance, "T",
           "maximum difference of the bounds, as a fraction of the lower one")
      .shows_default();
  command
      .add("--iterations", options->max_iterations, "N",
           "maximum number of vertices of a component from which distances are computed")
      .shows_default();
  command.add_flag("--radius", options->use_radius,
                   "also compute bounds of the smallest eccentricity, and a center");
  command.set_callback([job, options] { run_diameter(*job, *options); });
}

} // namespace program
