// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "errors.h"
#include "transports.h"

namespace program {

namespace {

// The library's part.
template <typename Surface_type>
Transport_result find_plan(const Surface_type& surface, const Masses& from,
                           const std::vector<std::size_t>& to, const Transport_options& options,
                           Job& job)
{
  const auto domain = GP::make_domain(surface, GP::parameters::threads(job.threads()));
  using Site = typename std::decay_t<decltype(domain)>::Site;
  std::vector<Site> region;
  for(const std::size_t vertex : to)
    region.push_back(site<Surface_type>(vertex));
  std::optional<GP::Region_transport_solver<Surface_type>> solver;
  with_preparation<Site>(domain, options, job,
                         [&](const auto& np) { solver.emplace(domain, region, np); });
  job.stage("query");
  Transport_result result;
  with_masses<Site>(from,
                    [&](const auto& before)
                    {
                      with_transport_method(options.method,
                                            [&](auto method) {
                                              result.cost =
                                                  solver->template compute<decltype(method)>(
                                                      before, query(options, job));
                                            });
                    });
  read_solution(*solver, surface, job, result);
  for(std::size_t i = 0; i < job.surface().file.points.size(); ++i)
    result.arrivals.push_back(solver->arrival(site<Surface_type>(i)));
  decompose(domain, surface, options, result);
  result.triangles = picture_triangles(domain, job);
  return result;
}

void run_plan(Job& job, const Transport_options& options)
{
  if(options.from.empty() || options.to.empty())
    throw Usage_error("plan: give --from and --to.");
  check(options);
  const Surface& surface = job.read({"ply", "vtp"});
  const Masses from = read_masses(options.from, "--from", options, surface);
  const std::vector<std::size_t> to = region_vertices(options.to, "--to", surface);
  check(options, surface);

  job.stage("prepare");
  Transport_result result;
  on_surface(surface, [&](const auto& mesh_or_cloud)
             { result = find_plan(mesh_or_cloud, from, to, options, job); });
  report(job, options, result.cost, "cost");
  std::vector<std::size_t> marked = from.vertices;
  if(are_vertices(options.to))
  {
    marked.insert(marked.end(), to.begin(), to.end());
    std::vector<double> arrivals;
    for(const std::size_t vertex : to)
    {
      arrivals.push_back(result.arrivals[vertex]);
      job.say("arrive at " + std::to_string(vertex) + "  " + readable(arrivals.back()));
    }
    job.result()["arrivals"] = arrivals;
  }

  job.stage("write");
  write_transport(job, result, marked);
  job.finish();
}

} // namespace

void add_plan(CLI::App& program)
{
  Command command(program, "plan", "how masses move to wherever in a region it costs the least");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Transport_options>();
  command.add("--from", options->from, "X", "masses, as those of emd");
  command.add("--to", options->to, "X",
              "vertices V[,V...], or a property that is positive at those of the region");
  add_options(command, *options);
  command.set_run([job, options] { run_plan(*job, *options); });
}

} // namespace program
