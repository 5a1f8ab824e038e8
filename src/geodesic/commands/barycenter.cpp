// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "io/errors.h"
#include "commands/transport_utilities.h"
#include "io/write_surface_file.h"

#include <algorithm>
#include <numeric>

namespace program {

namespace {

struct Barycenter_options : Transport_options
{
  std::vector<std::string> mass_arguments;
  std::string points;
  std::vector<double> weights;
};

struct Barycenter_result
{
  GP::Transport_barycenter_cost cost;
  std::vector<double> masses, density; // #vertices
  std::optional<std::size_t>
      point; // if the inputs are points: minimizer of the weighted squared distances
  double point_value = 0.;
  std::vector<double> objective; // #vertices: weighted squared distances, if the inputs are points
  std::vector<std::vector<Point>> paths = {}; // from the minimizer to all points, for a picture
  std::vector<std::uint32_t> triangles;       // of a cloud
};

// Computes the barycenter of the mass distributions and, if all are points, the barycenter of
// these points.
template <typename Domain>
Barycenter_result find_barycenter(const Domain& domain, const std::vector<Masses>& masses,
                                  const std::vector<std::size_t>& points,
                                  const Barycenter_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  using Vertex = typename Domain::Vertex;
  std::vector<Mass_distribution> given;
  for(const Masses& mass : masses)
    given.push_back(distribution(domain, mass));
  std::vector<double> weights = options.weights;
  if(weights.empty())
    weights.assign(masses.size(), 1.);

  std::optional<GP::Transport_barycenter_solver<Surface_type>> solver;
  Barycenter_result result;
  const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
  const auto prepared = preparation(domain, options, speed);
  solver.emplace(domain, prepared);
  if(points.size() == masses.size())
  {
    std::vector<Vertex> vertices;
    for(const std::size_t vertex : points)
      vertices.push_back(vertex_at<Surface_type>(vertex));
    result.objective.resize(job.surface().file.points.size());
    const auto found = GP::geodesic_barycenter(
        domain, vertices,
        prepared.weights(weights).objective_map(Value_map<Vertex>{&result.objective}));
    result.point = static_cast<std::size_t>(found.vertex);
    result.point_value = found.value;
    if(!job.picture().empty())
    {
      GP::Geodesic_distance_solver<Surface_type> distance_solver(domain);
      distance_solver.compute(found.vertex, prepared);
      for(const Vertex& v : vertices)
        result.paths.push_back(coordinates_of(distance_solver.path(v).points));
    }
  }
  job.begin_stage("query");
  const auto np = GP::parameters::tolerance(options.tolerance)
                      .do_normalize(options.normalize)
                      .weights(weights)
                      .callback(job.progress_callback("barycenter"));
  result.cost = solver->compute(given, np);
  result.masses.resize(job.surface().file.points.size());
  result.density.resize(result.masses.size());
  solver->write_masses(Value_map<Vertex>{&result.masses});
  solver->write_density(Value_map<Vertex>{&result.density});
  result.triangles = picture_triangles(domain, job);
  return result;
}

void run_barycenter(Job& job, const Barycenter_options& options)
{
  if(options.mass_arguments.empty() && options.points.empty())
    throw Usage_error("barycenter: --of or --points is required.");
  if(options.density && !options.points.empty())
    throw Usage_error("barycenter: --density applies to properties and files, not to --points.");
  check(options);
  const Surface& surface = job.read();
  std::vector<Masses> masses;
  for(const std::string& entry : options.mass_arguments)
    masses.push_back(read_masses(entry, "--of", options, surface));
  std::vector<std::size_t> points;
  if(!options.points.empty())
    points = parse_indices(options.points, "--points");
  for(const std::size_t vertex : points)
    masses.push_back(read_masses(std::to_string(vertex), "--points", options, surface));
  if(options.density && !std::all_of(masses.begin(), masses.end(),
                                     [](const Masses& entry) { return entry.is_density; }))
    throw Usage_error("barycenter: --density applies to properties and files, not to vertices.");
  if(!options.weights.empty() && options.weights.size() != masses.size())
    throw Usage_error(
        "--weight: the number of weights is " + std::to_string(options.weights.size()) +
        ", but the number of mass distributions is " + std::to_string(masses.size()) + ".");

  job.begin_stage("prepare");
  Barycenter_result result;
  visit_domain(job, [&](const auto& domain)
               { result = find_barycenter(domain, masses, points, options, job); });
  GP::Earth_movers_cost cost;
  cost.value = result.cost.value;
  cost.lower = result.cost.lower;
  cost.upper = result.cost.upper;
  cost.number_of_iterations = result.cost.number_of_iterations;
  cost.residual = result.cost.residual;
  cost.is_converged = result.cost.is_converged;
  report(job, options, cost, "squared distances");
  job.result()["distances"] = result.cost.distances;
  if(result.point)
  {
    job.result()["point"] = *result.point;
    job.result()["point_value"] = json_number(result.point_value);
    job.print_line("best vertex              " + std::to_string(*result.point) +
                   ", sum of squared distances " + rounded_text(result.point_value));
  }

  job.begin_stage("write");
  job.write_values([&] { return number_lines(result.masses); });
  if(!job.picture().empty())
  {
    std::vector<Point> marker_points;
    for(const Masses& entry : masses)
      for(const std::size_t vertex : entry.vertices)
        marker_points.push_back(surface.file.points[vertex]);
    Picture picture{&surface.file};
    picture.values = result.point ? result.objective : result.density;
    picture.title = result.point ? "squared distances" : "mass per area";
    picture.polylines = result.paths;
    picture.markers = marker_points;
    picture.triangles = result.triangles;
    // The camera must show the vertices of largest mass that contain half of the mass.
    std::vector<std::size_t> order(result.masses.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return result.masses[i] > result.masses[j]; });
    const double half_mass = 0.5 * std::accumulate(result.masses.begin(), result.masses.end(), 0.);
    double sum = 0.;
    for(std::size_t i = 0; i < order.size() && sum < half_mass; sum += result.masses[order[i++]])
      picture.visible_points.push_back(surface.file.points[order[i]]);
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
  {
    Surface_file file = surface.file;
    file.properties["mass"] = result.masses;
    file.properties["density"] = result.density;
    write_surface_file(job.output(), file);
  }
  job.finish();
}

} // namespace

void add_barycenter(CLI::App& program)
{
  Command command(program, "barycenter",
                  "compute the barycenter of mass distributions or of vertices");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Barycenter_options>();
  options->tolerance = 0.01;
  command.add("--of", options->mass_arguments, "X",
              "mass distribution, as for emd; can be repeated");
  command.add("--points", options->points, "V[,V...]",
              "vertex indices; each vertex is a mass distribution. Without --of, also find the "
              "vertex with the smallest sum of squared distances");
  command.add("--weight", options->weights, "W",
              "weight of a mass distribution; repeated in the order of the distributions, first "
              "--of, then --points (default 1)");
  command.add_flag("--density", options->density,
                   "values of properties and files are mass per area");
  command.add_flag("--normalize", options->normalize,
                   "scale each mass distribution to total mass 1");
  command
      .add("--tolerance", options->tolerance, "T",
           "maximum gap between lower and upper bound, relative to the upper bound")
      .shows_default();
  command.add("--refine", options->refine, "N", "number of 1-to-4 refinements, as for emd");
  add_speed_options(command, options->speed_options);
  command.set_callback([job, options] { run_barycenter(*job, *options); });
}

} // namespace program
