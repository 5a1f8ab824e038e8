// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "io/errors.h"
#include "commands/transport_utilities.h"

namespace program {

namespace {

struct Plan_options : Transport_options
{
  std::string capacity;
  double spread = 0.;
  Region_options region;
};

// Returns one capacity per vertex of the region and per other source (location or path). Returns
// an empty array if no capacities are given.
std::vector<double> capacities(const std::string& text, const std::vector<std::size_t>& region,
                               std::size_t number_of_other_sources, const Surface& surface)
{
  std::vector<double> result;
  if(text.empty())
    return result;
  if(const auto numbers = parse_numbers(text))
  {
    if(numbers->size() != region.size() + number_of_other_sources)
      throw Usage_error("--capacity " + printable(text) + ": the number of capacities must be " +
                        std::to_string(region.size() + number_of_other_sources) +
                        (number_of_other_sources > 0
                             ? ", the number of vertices, locations and paths of the region."
                             : ", the number of vertices of the region."));
    return *numbers;
  }
  if(number_of_other_sources > 0)
    throw Usage_error(
        "--capacity " + printable(text) +
        ": capacities must be numbers, because --to-at and --to-path have no property.");
  const std::vector<double> values = property(surface, text);
  for(const std::size_t vertex : region)
    result.push_back(values[vertex]);
  return result;
}

// Computes the optimal transport from the masses to the region.
template <typename Domain>
Transport_result
compute_plan(const Domain& domain, const Masses& from, const std::vector<std::size_t>& to,
             const std::vector<double>& capacity, const Plan_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  std::vector<GP::Source<Surface_type>> region;
  for(const std::size_t vertex : to)
    region.emplace_back(vertex_at<Surface_type>(vertex));
  Transport_result result;
  add_sources(domain, options.region, job.surface(), region, result);
  const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
  GP::Region_transport_solver<Surface_type> solver(
      domain, region,
      preparation(domain, options, speed).capacities(capacity).spreading_weight(options.spread));
  job.begin_stage("query");
  result.cost = compute_cost(solver, options.method, distribution(domain, from),
                             query_parameters(options, job));
  copy_solution(domain, solver, job, result);
  for(std::size_t i = 0; i < job.surface().file.points.size(); ++i)
    result.arrivals.push_back(solver.arrival(vertex_at<Surface_type>(i)));
  add_hodge_decomposition(domain, options, result);
  result.triangles = picture_triangles(domain, job);
  return result;
}

void run_plan(Job& job, const Plan_options& options)
{
  if(options.from.empty() || (options.to.empty() && options.region.empty()))
    throw Usage_error("plan: --from is required, and --to, --to-at or --to-path.");
  check(options);
  check(options.region);
  const Surface& surface = job.read({"ply", "vtp"});
  check(options.region, surface);
  const Masses from = read_masses(options.from, "--from", options, surface);
  const std::vector<std::size_t> to = options.to.empty()
                                          ? std::vector<std::size_t>()
                                          : region_vertices(options.to, "--to", surface);
  const std::vector<double> capacity = capacities(
      options.capacity, to, options.region.at.size() + options.region.paths.size(), surface);
  check(options, surface);

  job.begin_stage("prepare");
  Transport_result result;
  visit_domain(job, [&](const auto& domain)
               { result = compute_plan(domain, from, to, capacity, options, job); });
  report(job, options, result.cost, "cost");
  std::vector<std::size_t> marked_vertices = from.vertices;
  if(!options.to.empty() && is_vertex_list(options.to))
  {
    marked_vertices.insert(marked_vertices.end(), to.begin(), to.end());
    std::vector<double> arrivals;
    for(const std::size_t vertex : to)
    {
      arrivals.push_back(result.arrivals[vertex]);
      job.print_line("arrive at " + std::to_string(vertex) + "  " + rounded_text(arrivals.back()));
    }
    job.result()["arrivals"] = arrivals;
  }

  job.begin_stage("write");
  write_transport(job, result, marked_vertices);
  job.finish();
}

} // namespace

void add_plan(CLI::App& program)
{
  Command command(program, "plan", "compute the optimal transport of masses to a region");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output", "write the potential, the flow and the arrivals: .ply .vtp");
  const auto options = std::make_shared<Plan_options>();
  command.add("--from", options->from, "X", "mass distribution, as for emd");
  command.add("--to", options->to, "X",
              "vertex indices V[,V...], or a property that is positive at the vertices of the "
              "region");
  add_region_options(command, options->region, "--to");
  command.add("--capacity", options->capacity, "X",
              "maximum mass that arrives at each vertex, then location, then path: X[,X...] in "
              "this order, or a property of the vertices");
  command.add("--spread", options->spread, "W",
              "add W times the integral of the squared density of arriving mass to the cost");
  add_options(command, *options);
  command.set_callback([job, options] { run_plan(*job, *options); });
}

} // namespace program
