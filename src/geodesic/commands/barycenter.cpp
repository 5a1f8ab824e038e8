// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/Picture.h"
#include "io/Scanner.h"
#include "app/commands.h"
#include "io/errors.h"
#include "commands/transports.h"

#include <algorithm>
#include <numeric>

namespace program {

namespace {

struct Barycenter_options : Transport_options
{
  std::vector<std::string> of;
  std::string points;
  std::vector<double> weights;
};

struct Barycenter_result
{
  GP::Transport_barycenter_cost cost;
  std::vector<double> masses, density; // #vertices
  std::optional<std::size_t> point;    // of points alone: the one of least squared distances
  double point_value = 0.;
  std::vector<double> objective;             // #vertices: those squares, of points alone
  std::vector<std::vector<Point>> ways = {}; // from that point to all, for a picture
  std::vector<std::uint32_t> triangles;      // of a cloud
};

// The library's part.
template <typename Surface_type>
Barycenter_result find_barycenter(const Surface_type& surface, const std::vector<Masses>& masses,
                                  const std::vector<std::size_t>& points,
                                  const Barycenter_options& options, Job& job)
{
  const auto domain = GP::make_domain(surface, GP::parameters::threads(job.threads()));
  using Site = typename std::decay_t<decltype(domain)>::Site;
  using Map = Property_map<Site>;
  std::vector<Map> maps;
  std::vector<GP::Mass_density<Map>> densities;
  for(const Masses& one : masses)
    if(one.are_density)
      densities.push_back(GP::mass_density(Map{&one.values}));
    else
      maps.push_back(Map{&one.values});
  std::vector<double> weights = options.weights;
  if(weights.empty())
    weights.assign(masses.size(), 1.);

  std::optional<GP::Transport_barycenter_solver<Surface_type>> solver;
  Barycenter_result result;
  with_preparation<Site>(
      domain, options, job,
      [&](const auto& np)
      {
        solver.emplace(domain, np);
        if(points.size() != masses.size())
          return;
        std::vector<Site> sites;
        for(const std::size_t vertex : points)
          sites.push_back(site<Surface_type>(vertex));
        result.objective.resize(job.surface().file.points.size());
        const auto found = GP::geodesic_barycenter(
            domain, sites, np.weights(weights).objective_map(Value_map<Site>{&result.objective}));
        result.point = static_cast<std::size_t>(found.site);
        result.point_value = found.value;
        if(job.picture().empty())
          return;
        GP::Geodesic_distance_solver<Surface_type> from(domain);
        from.compute(found.site, np);
        for(const Site& site : sites)
        {
          result.ways.emplace_back();
          for(const auto& p : from.path(site).points)
            result.ways.back().push_back({p.x(), p.y(), p.z()});
        }
      });
  job.stage("query");
  const auto np = GP::parameters::tolerance(options.tolerance)
                      .do_normalize(options.normalize)
                      .weights(weights)
                      .callback(job.progress("barycenter"));
  result.cost = densities.empty() ? solver->compute(maps, np) : solver->compute(densities, np);
  result.masses.resize(job.surface().file.points.size());
  result.density.resize(result.masses.size());
  solver->write_masses(Value_map<Site>{&result.masses});
  solver->write_density(Value_map<Site>{&result.density});
  result.triangles = picture_triangles(domain, job);
  return result;
}

void run_barycenter(Job& job, const Barycenter_options& options)
{
  if(options.of.empty() && options.points.empty())
    throw Usage_error("barycenter: give --of or --points.");
  if(options.density && !options.points.empty())
    throw Usage_error("barycenter: --density is for properties and files, which --of takes.");
  check(options);
  const Surface& surface = job.read();
  std::vector<Masses> masses;
  for(const std::string& one : options.of)
    masses.push_back(read_masses(one, "--of", options, surface));
  std::vector<std::size_t> points;
  if(!options.points.empty())
    points = parse_integers(options.points, "--points");
  for(const std::size_t vertex : points)
    masses.push_back(read_masses(std::to_string(vertex), "--points", options, surface));
  if(options.density &&
     !std::all_of(masses.begin(), masses.end(), [](const Masses& one) { return one.are_density; }))
    throw Usage_error("barycenter: --density is for properties and files, not for vertices.");
  if(!options.weights.empty() && options.weights.size() != masses.size())
    throw Usage_error("--weight: there are " + std::to_string(options.weights.size()) + " for " +
                      std::to_string(masses.size()) + " masses.");

  job.stage("prepare");
  Barycenter_result found;
  on_surface(surface, [&](const auto& mesh_or_cloud)
             { found = find_barycenter(mesh_or_cloud, masses, points, options, job); });
  GP::Earth_movers_cost cost;
  cost.value = found.cost.value;
  cost.lower = found.cost.lower;
  cost.upper = found.cost.upper;
  cost.iterations = found.cost.iterations;
  cost.residual = found.cost.residual;
  cost.converged = found.cost.converged;
  report(job, options, cost, "squared distances");
  job.result()["distances"] = found.cost.distances;
  if(found.point)
  {
    job.result()["point"] = *found.point;
    job.result()["point_value"] = json_number(found.point_value);
    job.say("best vertex              " + std::to_string(*found.point) + ", where they sum to " +
            readable(found.point_value));
  }

  job.stage("write");
  job.write_values([&] { return lines(found.masses); });
  if(!job.picture().empty())
  {
    std::vector<Point> marked;
    for(const Masses& one : masses)
      for(const std::size_t vertex : one.vertices)
        marked.push_back(surface.file.points[vertex]);
    Picture picture{&surface.file};
    picture.values = found.point ? found.objective : found.density;
    picture.title = found.point ? "squared distances" : "mass per area";
    picture.polylines = found.ways;
    picture.markers = marked;
    picture.triangles = found.triangles;
    // To be seen: from the highest mass on, as far as half of it.
    std::vector<std::size_t> order(found.masses.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return found.masses[i] > found.masses[j]; });
    const double half = 0.5 * std::accumulate(found.masses.begin(), found.masses.end(), 0.);
    double sum = 0.;
    for(std::size_t i = 0; i < order.size() && sum < half; sum += found.masses[order[i++]])
      picture.places.push_back(surface.file.points[order[i]]);
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
  {
    Surface_file file = surface.file;
    file.properties["mass"] = found.masses;
    file.properties["density"] = found.density;
    write_surface_file(job.output(), file);
  }
  job.finish();
}

} // namespace

void add_barycenter(CLI::App& program)
{
  Command command(program, "barycenter",
                  "the masses with the least sum of squared distances to given ones");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Barycenter_options>();
  options->tolerance = 0.01;
  command.add("--of", options->of, "X", "masses, as those of emd; may be given several times");
  command.add("--points", options->points, "V[,V...]",
              "vertices, each with a mass of its own, and the vertex nearest to all");
  command.add("--weight", options->weights, "W",
              "of each of the masses, in their order, --of first (default 1 each)");
  command.add_flag("--density", options->density, "properties and files have mass per area");
  command.add_flag("--normalize", options->normalize, "scale all masses so that they sum to one");
  command.add("--tolerance", options->tolerance, "T", "of the gap between the bounds, relative")
      .shows_default();
  command.add("--refine", options->refine, "N", "as in emd");
  add_density_options(command, options->densities);
  command.set_run([job, options] { run_barycenter(*job, *options); });
}

} // namespace program
