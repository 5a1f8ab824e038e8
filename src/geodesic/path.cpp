// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output_file.h"
#include "Picture.h"
#include "Scanner.h"
#include "commands.h"
#include "queries.h"

#include <cmath>

namespace program {

namespace {

// An end of the path: a vertex or a point, as given.
struct End
{
  std::string vertex, point;
  const char *vertex_option, *point_option;
};

struct Path_options
{
  End from = {"", "", "--from", "--from-at"}, to = {"", "", "--to", "--to-at"};
  std::string method; // whose distances the path follows; none: a search for this one path
};

struct Result
{
  std::vector<Point> points;
  double length = 0., front_distance = 0.;
};

std::size_t vertex_of(const End& end)
{
  const std::vector<std::size_t> vertices = parse_integers(end.vertex, end.vertex_option);
  if(vertices.size() != 1)
    throw Usage_error(std::string(end.vertex_option) + ": give one vertex.");
  return vertices[0];
}

// The library's part: the path between two ends.
template <typename Surface_type>
Result find_path(const Surface_type& surface, const Path_options& options, Job& job)
{
  const auto domain = GP::make_domain(surface, GP::parameters::threads(job.threads()));
  using Domain = std::decay_t<decltype(domain)>;
  using Place = std::variant<typename Domain::Site, typename Domain::Location>;
  const auto place = [&](const End& end)
  {
    return end.point.empty() ? Place(site<Surface_type>(vertex_of(end)))
                             : Place(locate(domain, end.point, end.point_option));
  };
  const Place from = place(options.from), to = place(options.to);
  job.stage("query");
  Result result;
  const auto keep = [&](const auto& path)
  {
    for(const auto& p : path.points)
      result.points.push_back({p.x(), p.y(), p.z()});
    result.length = path.length;
    result.front_distance = path.front_distance;
  };
  std::visit(
      [&](const auto& begin, const auto& end)
      {
        if(options.method.empty())
          keep(GP::Geodesic_path_finder<Surface_type>(domain)(begin, end));
        else
          with_method<Surface_type>(
              options.method,
              [&](auto method) { keep(GP::geodesic_path<decltype(method)>(domain, begin, end)); });
      },
      from, to);
  return result;
}

void check(const End& end)
{
  if(end.vertex.empty() == end.point.empty())
    throw Usage_error(std::string("path: give either ") + end.vertex_option + " or " +
                      end.point_option + ".");
  if(!end.vertex.empty())
    vertex_of(end);
  else
    parse_point(end.point, end.point_option);
}

void run_path(Job& job, const Path_options& options)
{
  check(options.from);
  check(options.to);
  if(!options.method.empty())
    check_method(options.method);
  const Surface& surface = job.read({"vtp", "ply", "obj"});
  check_method(options.method, surface);
  for(const End* end : {&options.from, &options.to})
    if(!end->vertex.empty())
      check_vertex(surface, vertex_of(*end));

  job.stage("prepare");
  Result result;
  on_surface(surface,
             [&](const auto& mesh_or_cloud) { result = find_path(mesh_or_cloud, options, job); });
  if(result.points.empty())
    fail(surface.name, "no path joins the two places, they lie on different components");
  job.result()["length"] = json_number(result.length);
  job.result()["front_distance"] = json_number(result.front_distance);
  job.result()["points"] = result.points.size();
  job.say("length          " + readable(result.length));
  job.say("points          " + std::to_string(result.points.size()));

  job.stage("write");
  job.write_values([&] { return points_text(result.points); });
  if(!job.picture().empty())
    draw(job.picture(), {&surface.file,
                         {},
                         "",
                         {},
                         {result.points},
                         {result.points.front(), result.points.back()}});
  if(!job.output().empty())
  {
    Surface_file line;
    line.polylines = {result.points};
    write_surface_file(job.output(), line);
  }
  job.finish();
}

} // namespace

void add_path(CLI::App& program)
{
  CLI::App* const command = program.add_subcommand("path", "a shortest path on the surface");
  const auto job = std::make_shared<Job>(*command);
  const auto options = std::make_shared<Path_options>();
  for(End* end : {&options->from, &options->to})
  {
    command->add_option(end->vertex_option, end->vertex, "a vertex by its place in the file")
        ->type_name("V");
    command->add_option(end->point_option, end->point, "the place nearest to a point")
        ->type_name("x,y,z");
  }
  command
      ->add_option(
          "--method", options->method,
          "follow its distances: dijkstra, fast-marching, euclidean, exact or heat; without, "
          "a search for this path alone")
      ->type_name("NAME");
  command->callback([job, options] { run_path(*job, *options); });
}

} // namespace program
