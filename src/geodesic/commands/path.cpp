// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "commands/cloud_paths.h"
#include "commands/speed_options.h"
#include "app/commands.h"
#include "io/errors.h"

#include <cmath>

namespace program {

namespace {

// An endpoint of the path: either a vertex or a point, as text.
struct Path_end
{
  std::string vertex, point;
  const char *vertex_option, *point_option;
};

struct Path_options
{
  Path_end from = {"", "", "--from", "--from-at"}, to = {"", "", "--to", "--to-at"};
  std::string through; // "V,V,...": vertices that the path passes in this order
  std::string method;  // the path follows this method's distances; empty: search for a single path
  Speed_options speed_options;      // the path has a short travel time
  bool is_locally_shortest = false; // the search ends with the first locally shortest path
  Cloud_path_options cloud;
  bool start = false; // also output the initial path in the surfel graph
};

struct Path_result
{
  std::vector<Point> points;
  double length = 0., front_distance = 0., lower = 0.;
  std::vector<double> speed; // #vertices; empty: 1 everywhere
  // On a cloud:
  std::vector<Point> start;
  double start_length = 0.;
  Surface_file surfels; // set if a picture is requested
};

std::size_t parse_vertex(const Path_end& end)
{
  const std::vector<std::size_t> vertices = parse_indices(end.vertex, end.vertex_option);
  if(vertices.size() != 1)
    throw Usage_error(std::string(end.vertex_option) + ": exactly one vertex is required.");
  return vertices[0];
}

// Returns whether a single path is searched. Otherwise the path follows distances.
bool is_single_search(const Path_options& options)
{
  return options.method.empty() && !options.speed_options.is_given();
}

// Returns the method of the distances that the path follows.
std::string distance_method(const Path_options& options)
{
  return options.method.empty() ? "automatic" : options.method;
}

// Appends a path that begins at the end of the result.
template <typename Path>
void append_path(const Path& path, Path_result& result)
{
  const std::vector<Point> points = coordinates_of(path.points);
  result.points.insert(result.points.end(), points.begin() + (result.points.empty() ? 0 : 1),
                       points.end());
  result.length += path.length;
  result.front_distance += path.front_distance;
  result.lower += path.lower;
}

// Calls search(begin, end) for each part of the path between consecutive locations, until one has
// no path.
template <typename Surface, typename Endpoint, typename Search>
void search_parts(const Endpoint& from, const Endpoint& to, const Path_options& options,
                  Path_result& result, const Search& search)
{
  std::vector<Endpoint> stops = {from};
  if(!options.through.empty())
    for(const std::size_t vertex : parse_indices(options.through, "--through"))
      stops.emplace_back(vertex_at<Surface>(vertex));
  stops.push_back(to);
  for(std::size_t i = 0; i + 1 < stops.size(); ++i)
    if(!std::visit(search, stops[i], stops[i + 1]))
    {
      result.points.clear();
      return;
    }
}

// Computes the path between two endpoints.
template <typename Domain>
Path_result find_path(const Domain& domain, const Path_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  using Path_endpoint = std::variant<typename Domain::Vertex, typename Domain::Location>;
  const auto endpoint = [&](const Path_end& end)
  {
    return end.point.empty() ? Path_endpoint(vertex_at<Surface_type>(parse_vertex(end)))
                             : Path_endpoint(locate(domain, end.point, end.point_option));
  };
  const Path_endpoint from = endpoint(options.from), to = endpoint(options.to);
  Path_result result;
  result.speed = compute_speeds(domain, options.speed_options, job);
  job.begin_stage("query");
  if(is_single_search(options))
  {
    GP::Geodesic_path_finder<Surface_type> finder(domain);
    search_parts<Surface_type>(from, to, options, result,
                               [&](const auto& begin, const auto& end)
                               {
                                 const auto path = options.is_locally_shortest
                                                       ? finder.locally_shortest_path(begin, end)
                                                       : finder(begin, end);
                                 append_path(path, result);
                                 return !path.empty();
                               });
  }
  else
    search_parts<Surface_type>(
        from, to, options, result,
        [&](const auto& begin, const auto& end)
        {
          Distance_solver<Surface_type> solver(
              domain, GP::parameters::method(to_method(distance_method(options))));
          solver.compute(end, GP::parameters::targets(begin).speed_map(
                                  speed_map<typename Domain::Vertex>(result.speed)));
          const auto path = solver.path(begin);
          append_path(path, result);
          return !path.empty();
        });
  return result;
}

// Computes the path of minimum energy on a cloud.
Path_result find_cloud_path(const Cloud& cloud, const Path_options& options, Job& job)
{
  Path_finder finder = make_path_finder(cloud, options.cloud, job);
  using Path_endpoint = std::variant<Path_finder::Vertex, Path_finder::Location>;
  const auto endpoint = [&](const Path_end& end)
  {
    return end.point.empty()
               ? Path_endpoint(vertex_at<Cloud>(parse_vertex(end)))
               : Path_endpoint(finder.locate(parse_point_3(end.point, end.point_option)));
  };
  const Path_endpoint from = endpoint(options.from), to = endpoint(options.to);
  job.begin_stage("query");
  Path_result result;
  search_parts<Cloud>(from, to, options, result,
                      [&](const auto& begin, const auto& end)
                      {
                        const auto path = finder(begin, end);
                        append_path(path, result);
                        for(const Cloud::Index& surfel : path.initial_path)
                          result.start.push_back(coordinates(finder.point(surfel)));
                        result.start_length += path.initial_length;
                        return !path.empty();
                      });
  if(!job.picture().empty())
    result.surfels = denoised_surfels(cloud, finder);
  return result;
}

void check(const Path_end& end)
{
  if(end.vertex.empty() == end.point.empty())
    throw Usage_error(std::string("path: either ") + end.vertex_option + " or " + end.point_option +
                      " is required, but not both.");
  if(!end.vertex.empty())
    parse_vertex(end);
  else
    parse_point(end.point, end.point_option);
}

void run_path(Job& job, const Path_options& options)
{
  check(options.from);
  check(options.to);
  if(!options.through.empty())
    parse_indices(options.through, "--through");
  check_method(distance_method(options));
  check(options.speed_options, distance_method(options));
  if(options.is_locally_shortest && !is_single_search(options))
    throw Usage_error("--locally-shortest: this option cannot be combined with --method, --speed "
                      "and --density-image.");
  const Surface& surface = job.read({"vtp", "ply", "obj"});
  check_method(distance_method(options), surface);
  for(const Path_end* end : {&options.from, &options.to})
    if(!end->vertex.empty())
      check_vertex(surface, parse_vertex(*end));
  if(!options.through.empty())
    for(const std::size_t vertex : parse_indices(options.through, "--through"))
      check_vertex(surface, vertex);

  job.begin_stage("prepare");
  Path_result result;
  if(!surface.is_mesh() && is_single_search(options))
    result = find_cloud_path(make_cloud(surface), options, job);
  else
    visit_domain(job, [&](const auto& domain) { result = find_path(domain, options, job); });
  if(result.points.empty())
    fail(surface.name, "no path connects the endpoints, which are in different components");
  job.result()["length"] = json_number(result.length);
  job.result()["front_distance"] = json_number(result.front_distance);
  job.result()["lower"] = json_number(result.lower);
  job.result()["points"] = result.points.size();
  if(!result.start.empty())
    job.result()["start_length"] = json_number(result.start_length);
  job.print_line("length          " + rounded_text(result.length));
  job.print_line("points          " + std::to_string(result.points.size()));

  job.begin_stage("write");
  job.write_values([&] { return points_text(result.points); });
  std::vector<std::vector<Point>> initial_paths;
  if(options.start && !result.start.empty())
    initial_paths.push_back(result.start);
  if(!job.picture().empty())
  {
    Picture picture{result.surfels.points.empty() ? &surface.file : &result.surfels};
    picture.values = result.speed;
    picture.title = "speed";
    picture.show_isolines = false;
    picture.polylines = {result.points};
    picture.markers = {result.points.front(), result.points.back()};
    if(!options.through.empty())
      for(const std::size_t vertex : parse_indices(options.through, "--through"))
        picture.markers.push_back(surface.file.points[vertex]);
    picture.thin_polylines = initial_paths;
    draw(job.picture(), picture);
  }
  initial_paths.insert(initial_paths.begin(), result.points);
  write_polylines(job, std::move(initial_paths));
  job.finish();
}

} // namespace

void add_path(CLI::App& program)
{
  Command command(program, "path", "compute a shortest path between two vertices or locations");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output", "write the path: .ply .obj .vtp");
  const auto options = std::make_shared<Path_options>();
  for(Path_end* end : {&options->from, &options->to})
  {
    command.add(end->vertex_option, end->vertex, "V", "endpoint: index of a vertex");
    command.add(end->point_option, end->point, "x,y,z", "endpoint: location closest to a point");
  }
  command.add("--through", options->through, "V[,V...]",
              "vertices that the path passes, in this order");
  command.add("--method", options->method, "NAME",
              "follow the distances of a method: automatic, exact, euclidean, fast-marching, "
              "dijkstra or heat (default: search for a single path, on meshes a shortest one)");
  add_speed_options(command, options->speed_options);
  command.add_flag("--locally-shortest", options->is_locally_shortest,
                   "without --method and speeds: a locally shortest path, which is found faster");
  add_cloud_path_options(command, options->cloud);
  command.add_flag("--start", options->start,
                   "for clouds, also write and draw the initial path in the surfel graph");
  command.set_callback([job, options] { run_path(*job, *options); });
}

} // namespace program
