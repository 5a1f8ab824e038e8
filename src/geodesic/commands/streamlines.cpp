// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "commands/transport_utilities.h"
#include "io/errors.h"

namespace program {

namespace {

struct Streamline_options : Transport_options
{
  std::size_t number = 50;
  std::string seeds;
  bool keep_traced = false;
};

struct Streamline_result
{
  GP::Earth_movers_cost cost;
  std::vector<std::vector<Point>> lines;
  std::vector<double> potential; // #vertices
  double length = 0.;            // total length of the streamlines
  std::size_t arrived = 0;
  std::vector<std::uint32_t> triangles; // of a cloud
};

// Computes streamlines of the optimal flow.
template <typename Domain>
Streamline_result compute_streamlines(const Domain& domain, const Masses& from, const Masses& to,
                                      const std::vector<std::size_t>& seeds,
                                      const Streamline_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
  GP::Earth_movers_solver<Surface_type> solver(domain, preparation(domain, options, speed));
  job.begin_stage("query");
  Streamline_result result;
  result.cost = compute_cost(solver, options.method, distribution(domain, from),
                             distribution(domain, to), query_parameters(options, job));
  const auto tracer = solver.streamlines(GP::parameters::do_straighten(!options.keep_traced));
  std::vector<GP::Streamline<Surface_type>> lines;
  if(options.seeds.empty())
    tracer(options.number, std::back_inserter(lines));
  else
    for(const std::size_t seed : seeds)
      lines.push_back(tracer(vertex_at<Surface_type>(seed)));
  for(const auto& line : lines)
  {
    result.lines.push_back(coordinates_of(line.points));
    result.length += line.length;
    result.arrived += line.has_arrived;
  }
  for(std::size_t i = 0; i < job.surface().file.points.size(); ++i)
    result.potential.push_back(solver.potential(vertex_at<Surface_type>(i)));
  result.triangles = picture_triangles(domain, job);
  return result;
}

void run_streamlines(Job& job, const Streamline_options& options)
{
  if(options.from.empty() || options.to.empty())
    throw Usage_error("streamlines: --from and --to are required.");
  check(options);
  const Surface& surface = job.read({"vtp", "ply", "obj"});
  const Masses from = read_masses(options.from, "--from", options, surface);
  const Masses to = read_masses(options.to, "--to", options, surface);
  std::vector<std::size_t> seeds;
  if(!options.seeds.empty())
    seeds = region_vertices(options.seeds, "--seeds", surface);

  job.begin_stage("prepare");
  Streamline_result result;
  visit_domain(job, [&](const auto& domain)
               { result = compute_streamlines(domain, from, to, seeds, options, job); });
  report(job, options, result.cost, "earth mover's distance");
  const double number_of_lines = static_cast<double>(std::max<std::size_t>(1, result.lines.size()));
  job.result()["lines"] = result.lines.size();
  job.result()["arrived"] = result.arrived;
  job.result()["mean_length"] = json_number(result.length / number_of_lines);
  job.print_line("lines                   " + std::to_string(result.lines.size()) + ", " +
                 std::to_string(result.arrived) + " arrived");
  job.print_line("mean length             " + rounded_text(result.length / number_of_lines));

  job.begin_stage("write");
  job.write_values([&] { return number_lines(result.potential); });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file};
    picture.values = result.potential;
    picture.title = "potential";
    picture.triangles = result.triangles;
    picture.thin_polylines = result.lines;
    for(const std::vector<Point>& line : result.lines)
      picture.visible_points.insert(picture.visible_points.end(), line.begin(), line.end());
    for(const Masses* masses : {&from, &to})
      for(const std::size_t vertex : masses->vertices)
        picture.markers.push_back(surface.file.points[vertex]);
    draw(job.picture(), picture);
  }
  write_polylines(job, result.lines);
  job.finish();
}

} // namespace

void add_streamlines(CLI::App& program)
{
  Command command(program, "streamlines",
                  "compute streamlines of the optimal flow between two mass distributions");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output", "write the streamlines: .ply .obj .vtp");
  const auto options = std::make_shared<Streamline_options>();
  command.add("--from", options->from, "X", "mass distribution, as for emd");
  command.add("--to", options->to, "X", "mass distribution, as for emd");
  command.add("--number", options->number, "N", "number of streamlines, each with the same mass")
      .shows_default();
  command.add("--seeds", options->seeds, "X",
              "start at vertices instead: indices V[,V...], or a property that is positive at "
              "the seeds");
  command.add_flag("--as-traced", options->keep_traced, "do not shorten the streamlines");
  add_query_options(command, *options);
  add_speed_options(command, options->speed_options);
  command.set_callback([job, options] { run_streamlines(*job, *options); });
}

} // namespace program
