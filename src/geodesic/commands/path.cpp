// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "picture/Picture.h"
#include "io/Scanner.h"
#include "commands/cloud_paths.h"
#include "app/commands.h"

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
  Cloud_path_options cloud;
  bool start = false; // the chain of arcs as well
};

struct Result
{
  std::vector<Point> points;
  double length = 0., front_distance = 0.;
  // On a cloud:
  std::vector<Point> start;
  double start_length = 0.;
  Surface_file surfels; // where a picture is wanted
};

std::size_t vertex_of(const End& end)
{
  const std::vector<std::size_t> vertices = parse_integers(end.vertex, end.vertex_option);
  if(vertices.size() != 1)
    throw Usage_error(std::string(end.vertex_option) + ": give one vertex.");
  return vertices[0];
}

template <typename Path>
void keep(const Path& path, Result& result)
{
  for(const auto& p : path.points)
    result.points.push_back(coordinates(p));
  result.length = path.length;
  result.front_distance = path.front_distance;
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
  std::visit(
      [&](const auto& begin, const auto& end)
      {
        if(options.method.empty())
          keep(GP::Geodesic_path_finder<Surface_type>(domain)(begin, end), result);
        else
          with_method<Surface_type>(
              options.method, [&](auto method)
              { keep(GP::geodesic_path<decltype(method)>(domain, begin, end), result); });
      },
      from, to);
  return result;
}

// On a cloud the path of least energy.
Result find_cloud_path(const Cloud& cloud, const Path_options& options, Job& job)
{
  Path_finder find = make_path_finder(cloud, options.cloud, job);
  using Place = std::variant<Path_finder::Site, Path_finder::Location>;
  const auto place = [&](const End& end)
  {
    return end.point.empty() ? Place(site<Cloud>(vertex_of(end)))
                             : Place(find.locate(parse_point_3(end.point, end.point_option)));
  };
  const Place from = place(options.from), to = place(options.to);
  job.stage("query");
  Result result;
  std::visit(
      [&](const auto& begin, const auto& end)
      {
        const auto path = find(begin, end);
        keep(path, result);
        for(const Cloud::Index& surfel : path.start)
          result.start.push_back(coordinates(find.point(surfel)));
        result.start_length = path.start_length;
      },
      from, to);
  if(!job.picture().empty())
    result.surfels = seen_surfels(cloud, find);
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
  if(!surface.is_mesh() && options.method.empty())
    result = find_cloud_path(make_cloud(surface), options, job);
  else
    on_surface(surface,
               [&](const auto& mesh_or_cloud) { result = find_path(mesh_or_cloud, options, job); });
  if(result.points.empty())
    fail(surface.name, "no path joins the two places, they lie on different components");
  job.result()["length"] = json_number(result.length);
  job.result()["front_distance"] = json_number(result.front_distance);
  job.result()["points"] = result.points.size();
  if(!result.start.empty())
    job.result()["start_length"] = json_number(result.start_length);
  job.say("length          " + readable(result.length));
  job.say("points          " + std::to_string(result.points.size()));

  job.stage("write");
  job.write_values([&] { return points_text(result.points); });
  std::vector<std::vector<Point>> chains;
  if(options.start && !result.start.empty())
    chains.push_back(result.start);
  if(!job.picture().empty())
  {
    Picture picture{result.surfels.points.empty() ? &surface.file : &result.surfels};
    picture.polylines = {result.points};
    picture.markers = {result.points.front(), result.points.back()};
    picture.chains = chains;
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
  {
    Surface_file line;
    line.polylines = chains;
    line.polylines.insert(line.polylines.begin(), result.points);
    write_surface_file(job.output(), line);
  }
  job.finish();
}

} // namespace

void add_path(CLI::App& program)
{
  Command command(program, "path", "a shortest path on the surface");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Path_options>();
  for(End* end : {&options->from, &options->to})
  {
    command.add(end->vertex_option, end->vertex, "V", "a vertex by its place in the file");
    command.add(end->point_option, end->point, "x,y,z", "the place nearest to a point");
  }
  command.add("--method", options->method, "NAME",
              "follow its distances: dijkstra, fast-marching, euclidean, exact or heat; without, "
              "a search for this path alone");
  add_cloud_path_options(command, options->cloud);
  command.add_flag(
      "--start", options->start,
      "on a cloud, draw and write the chain of arcs that the path starts from as well");
  command.set_run([job, options] { run_path(*job, *options); });
}

} // namespace program
