// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "picture/Picture.h"
#include "io/Scanner.h"
#include "app/commands.h"
#include "commands/transports.h"

namespace program {

namespace {

struct Streamline_options : Transport_options
{
  std::size_t number = 50;
  std::string seeds;
  bool as_traced = false;
};

struct Lines
{
  GP::Earth_movers_cost cost;
  std::vector<std::vector<Point>> lines;
  std::vector<double> potential; // #vertices
  double length = 0.;            // of all
  std::size_t arrived = 0;
  std::vector<std::uint32_t> triangles; // of a cloud
};

// The library's part.
template <typename Surface_type>
Lines find_lines(const Surface_type& surface, const Masses& from, const Masses& to,
                 const std::vector<std::size_t>& seeds, const Streamline_options& options, Job& job)
{
  const auto domain = GP::make_domain(surface, GP::parameters::threads(job.threads()));
  using Site = typename std::decay_t<decltype(domain)>::Site;
  std::optional<GP::Earth_movers_solver<Surface_type>> solver;
  with_preparation<Site>(domain, options, job, [&](const auto& np) { solver.emplace(domain, np); });
  job.stage("query");
  Lines result;
  const auto compute = [&](const auto& before, const auto& after)
  {
    with_transport_method(options.method,
                          [&](auto method) {
                            result.cost = solver->template compute<decltype(method)>(
                                before, after, query(options, job));
                          });
  };
  with_masses<Site>(from, [&](const auto& before)
                    { with_masses<Site>(to, [&](const auto& after) { compute(before, after); }); });
  const auto trace = solver->streamlines(GP::parameters::do_straighten(!options.as_traced));
  std::vector<GP::Streamline<Surface_type>> lines;
  if(options.seeds.empty())
    trace(options.number, std::back_inserter(lines));
  else
    for(const std::size_t seed : seeds)
      lines.push_back(trace(site<Surface_type>(seed)));
  for(const auto& line : lines)
  {
    result.lines.emplace_back();
    for(const auto& p : line.points)
      result.lines.back().push_back(coordinates(p));
    result.length += line.length;
    result.arrived += line.has_arrived;
  }
  for(std::size_t i = 0; i < job.surface().file.points.size(); ++i)
    result.potential.push_back(solver->potential(site<Surface_type>(i)));
  result.triangles = picture_triangles(domain, job);
  return result;
}

void run_streamlines(Job& job, const Streamline_options& options)
{
  if(options.from.empty() || options.to.empty())
    throw Usage_error("streamlines: give --from and --to.");
  check(options);
  const Surface& surface = job.read({"vtp", "ply", "obj"});
  const Masses from = read_masses(options.from, "--from", options, surface);
  const Masses to = read_masses(options.to, "--to", options, surface);
  std::vector<std::size_t> seeds;
  if(!options.seeds.empty())
    seeds = region_vertices(options.seeds, "--seeds", surface);

  job.stage("prepare");
  Lines found;
  on_surface(surface, [&](const auto& mesh_or_cloud)
             { found = find_lines(mesh_or_cloud, from, to, seeds, options, job); });
  report(job, options, found.cost, "earth mover's distance");
  const double number = static_cast<double>(std::max<std::size_t>(1, found.lines.size()));
  job.result()["lines"] = found.lines.size();
  job.result()["arrived"] = found.arrived;
  job.result()["mean_length"] = json_number(found.length / number);
  job.say("lines                   " + std::to_string(found.lines.size()) + ", of which " +
          std::to_string(found.arrived) + " arrive");
  job.say("mean length             " + readable(found.length / number));

  job.stage("write");
  job.write_values([&] { return lines(found.potential); });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file};
    picture.values = found.potential;
    picture.title = "potential";
    picture.triangles = found.triangles;
    picture.chains = found.lines;
    for(const std::vector<Point>& line : found.lines)
      picture.places.insert(picture.places.end(), line.begin(), line.end());
    for(const Masses* side : {&from, &to})
      for(const std::size_t vertex : side->vertices)
        picture.markers.push_back(surface.file.points[vertex]);
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
  {
    Surface_file file;
    file.polylines = found.lines;
    write_surface_file(job.output(), file);
  }
  job.finish();
}

} // namespace

void add_streamlines(CLI::App& program)
{
  Command command(program, "streamlines", "the lines along which masses move");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Streamline_options>();
  command.add("--from", options->from, "X", "masses, as those of emd");
  command.add("--to", options->to, "X", "likewise");
  command.add("--number", options->number, "N", "of lines, for equal parts of the mass")
      .shows_default();
  command.add("--seeds", options->seeds, "X",
              "instead from vertices V[,V...], or where a property is positive");
  command.add_flag("--as-traced", options->as_traced, "do not pull lines taut");
  add_query_options(command, *options);
  add_density_options(command, options->densities);
  command.set_run([job, options] { run_streamlines(*job, *options); });
}

} // namespace program
