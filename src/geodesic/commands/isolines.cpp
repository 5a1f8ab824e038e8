// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "io/write_surface_file.h"
#include "io/write_svg.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "commands/speed_options.h"
#include "io/errors.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace program {

namespace {

using UV = std::array<double, 2>;

struct Isoline_options
{
  std::string property;  // vertex property whose isolines are computed
  std::string source;    // "V,V,...": isolines of the distance from these sources
  std::string source_at; // "x,y,z"
  bool use_boundary = false;
  std::string method = "automatic";
  Speed_options speed_options;
  std::string isovalues; // "V,V,..."
  std::size_t number = 10;
  bool is_divided = false;

  // Distances from boundaries and travel times are not distances from points.
  bool do_fit_circles() const
  {
    return property.empty() && !use_boundary && !speed_options.is_given();
  }
};

struct Isoline_result
{
  std::vector<double> values; // #vertices
  std::vector<double> isovalues;
  std::vector<GP::Isoline<Mesh>> lines;
  // With --divided, the mesh that is split along the lines, with the face number "label"
  Surface_file divided;
};

bool has_sources(const Isoline_options& options)
{
  return !options.source.empty() || !options.source_at.empty() || options.use_boundary;
}

// Computes the distance of each vertex.
std::vector<double> source_distances(const Mesh_domain& domain, const Isoline_options& options,
                                     Job& job)
{
  std::vector<GP::Source<Mesh>> sources;
  if(!options.source.empty())
    for(const std::size_t vertex : parse_indices(options.source, "--source"))
      sources.emplace_back(vertex_at<Mesh>(vertex));
  if(!options.source_at.empty())
    sources.emplace_back(locate(domain, options.source_at, "--source-at"));
  if(options.use_boundary)
    GP::border_sources(domain, std::back_inserter(sources));
  if(sources.empty())
    fail(job.input(), "the mesh has no boundary");
  const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
  check_memory(job, options.method == "automatic" && !speed.empty() ? "euclidean" : options.method);
  Distance_solver<Mesh> solver(domain, GP::parameters::method(to_method(options.method)));
  job.begin_stage("query");
  solver.compute(sources, GP::parameters::callback(job.progress_callback("distance"))
                              .speed_map(speed_map<Mesh::Vertex_index>(speed)));
  std::vector<double> values(job.surface().file.points.size());
  for(std::size_t i = 0; i < values.size(); ++i)
    values[i] = solver.distance(vertex_at<Mesh>(i));
  return values;
}

// Returns the isovalues of the command line, or values of equal spacing between the smallest and
// the largest value.
std::vector<double> isovalues_of(const Isoline_options& options, const std::vector<double>& values)
{
  if(!options.isovalues.empty())
    return *parse_numbers(options.isovalues);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for(const double value : values)
    if(std::isfinite(value))
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  std::vector<double> result;
  if(low < high)
    for(std::size_t i = 1; i <= options.number; ++i)
    {
      const double fraction = static_cast<double>(i) / static_cast<double>(options.number + 1);
      result.push_back((1. - fraction) * low + fraction * high);
    }
  return result;
}

// Computes the values and their isolines.
Isoline_result find_isolines(const Mesh_domain& domain, const Isoline_options& options, Job& job)
{
  Isoline_result result;
  if(options.property.empty())
    result.values = source_distances(domain, options, job);
  else
    result.values = property(job.surface(), options.property);
  job.begin_stage("query");
  result.isovalues = isovalues_of(options, result.values);
  const Property_map<Mesh::Vertex_index> values{&result.values};
  const auto np = GP::parameters::do_fit_circles(options.do_fit_circles());
  GP::isolines(domain, values, result.isovalues, std::back_inserter(result.lines), np);
  if(options.is_divided)
  {
    Mesh mesh;
    const auto label = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:label").first;
    GP::split_at_isolines(domain, values, result.isovalues, mesh, label, np);
    result.divided = to_file(mesh);
    for(const Mesh::Face_index face : mesh.faces())
      result.divided.face_numbers["label"].push_back(static_cast<std::uint32_t>(label[face]));
  }
  return result;
}

void report(Job& job, const Isoline_result& result)
{
  std::size_t number_of_closed = 0;
  double length = 0.;
  for(const auto& line : result.lines)
  {
    number_of_closed += line.is_closed;
    length += line.length;
  }
  job.result()["lines"] = result.lines.size();
  job.result()["closed"] = number_of_closed;
  job.result()["length"] = json_number(length);
  job.print_line("lines           " + std::to_string(result.lines.size()) + ", " +
                 std::to_string(number_of_closed) + " closed");
  job.print_line("length          " + rounded_text(length));
}

// Returns an SVG image of the isolines on the flattened mesh, which must be a disk.
std::string flattened_svg(const Mesh_domain& domain, const Isoline_result& result, Job& job)
{
  job.begin_stage("query");
  std::vector<UV> uv(job.surface().file.points.size());
  const Value_map<Mesh::Vertex_index, UV> uv_map = {&uv};
  GP::geodesic_lle(
      domain, uv_map,
      GP::parameters::random_seed(job.seed()).callback(job.progress_callback("flattening")));
  GP::minimize_distortion(domain, uv_map,
                          GP::parameters::callback(job.progress_callback("distortion")));

  const Mesh& mesh = domain.mesh();
  const auto is_boundary = [&](Mesh::Halfedge_index h) { return mesh.is_border(h); };
  const auto halfedges = mesh.halfedges();
  // The boundary of the mesh is on the left of its boundary halfedges.
  const auto first = *std::find_if(halfedges.begin(), halfedges.end(), is_boundary);
  std::vector<UV> boundary = {uv[mesh.source(first)]};
  for(auto h = first; boundary.size() == 1 || h != first; h = mesh.next(h))
    boundary.push_back(uv[mesh.target(h)]);

  std::vector<Planar_line> lines;
  for(const auto& line : result.lines)
  {
    lines.push_back({{}, line.is_closed, line.value});
    for(const auto& [face, barycentric] : line.locations)
    {
      UV p = {0., 0.};
      auto h = mesh.halfedge(face);
      for(std::size_t k = 0; k < 3; ++k, h = mesh.next(h))
        for(std::size_t i = 0; i < 2; ++i)
          p[i] += barycentric[k] * uv[mesh.source(h)][i];
      lines.back().points.push_back(p);
    }
  }
  return to_svg(lines, boundary);
}

void draw_isolines(const Job& job, const Isoline_options& options, const Isoline_result& result,
                   const std::vector<std::vector<Point>>& lines)
{
  Picture picture{&job.surface().file};
  Surface_file regions;
  if(options.is_divided)
  {
    regions =
        separate_regions(result.divided, result.divided.face_numbers.at("label"), picture.labels);
    picture.surface = &regions;
  }
  else
  {
    picture.values = result.values;
    picture.title = options.property.empty() ? "distance" : options.property;
    picture.show_isolines = false;
  }
  picture.thin_polylines = lines;
  draw(job.picture(), picture);
}

void check(const Isoline_options& options)
{
  if(options.property.empty() == !has_sources(options))
    throw Usage_error("isolines: either --property or sources (--source, --source-at or "
                      "--source-border) are required, but not both.");
  if(!options.source.empty())
    parse_indices(options.source, "--source");
  if(!options.source_at.empty())
    parse_point(options.source_at, "--source-at");
  check_method(options.method);
  check(options.speed_options, options.method);
  if(options.isovalues.empty())
    return;
  const auto isovalues = parse_numbers(options.isovalues);
  if(!isovalues || !std::all_of(isovalues->begin(), isovalues->end(),
                                [](double value) { return std::isfinite(value); }))
    throw Usage_error("--isovalues " + printable(options.isovalues) +
                      ": finite numbers that are separated by commas are required.");
}

// Throws Input_error unless the mesh is a disk, which can be flattened.
void check_disk(const Surface& surface)
{
  const GP::Soup_report& report = surface.domain->report();
  if(!report.is_manifold() || report.number_of_components != 1 || report.genus != 0 ||
     report.number_of_boundary_cycles != 1)
    fail(surface.name, "it is not a disk, which an image in the plane (.svg) requires");
}

void run_isolines(Job& job, const Isoline_options& options)
{
  check(options);
  const Surface& surface = options.is_divided ? job.read() : job.read({"vtp", "ply", "obj", "svg"});
  if(!surface.is_mesh())
    fail(surface.name, "isolines need a mesh, because the triangles of a cloud overlap");
  const bool is_svg = file_extension(job.output()) == "svg";
  if(is_svg)
    check_disk(surface);
  check_method(options.method, surface);
  if(!options.source.empty())
    for(const std::size_t vertex : parse_indices(options.source, "--source"))
      check_vertex(surface, vertex);

  job.begin_stage("prepare");
  const Mesh_domain& domain = *surface.domain;
  const Isoline_result result = find_isolines(domain, options, job);
  report(job, result);
  if(options.is_divided)
  {
    job.report("vertices_out", result.divided.points.size());
    job.report("faces_out", result.divided.number_of_polygons());
  }
  const std::string svg = is_svg ? flattened_svg(domain, result, job) : "";

  job.begin_stage("write");
  job.write_values([&] { return number_lines(result.values); });
  std::vector<std::vector<Point>> lines;
  for(const auto& line : result.lines)
    lines.push_back(coordinates_of(line.points));
  if(!job.picture().empty())
    draw_isolines(job, options, result, lines);
  if(is_svg)
    write_file(job.output(), svg);
  else if(!options.is_divided)
    write_polylines(job, lines);
  else if(!job.output().empty())
    write_surface_file(job.output(), result.divided);
  job.finish();
}

} // namespace

void add_isolines(CLI::App& program)
{
  Command command(program, "isolines",
                  "compute isolines of a vertex property, or of the distance from sources: offset "
                  "curves");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output",
                   "write the isolines: .ply .obj .vtp, or .svg of the flattened mesh, which must "
                   "be a disk");
  const auto options = std::make_shared<Isoline_options>();
  command.add("--property", options->property, "NAME", "vertex property of the file");
  command.add("--source", options->source, "V[,V...]", "indices of source vertices");
  command.add("--source-at", options->source_at, "x,y,z",
              "source at the location closest to a point");
  command.add_flag("--source-border", options->use_boundary, "sources at all boundary cycles");
  command
      .add("--method", options->method, "NAME",
           "of distances: automatic, exact, euclidean, fast-marching, dijkstra or heat")
      .shows_default();
  command.add("--isovalues", options->isovalues, "X[,X...]", "values of the isolines");
  command
      .add("--number", options->number, "N",
           "without --isovalues: number of values, with equal spacing between the smallest and the "
           "largest value")
      .shows_default();
  command.add_flag("--divided", options->is_divided,
                   "write and draw the mesh, split along the isolines; the property label is the "
                   "number of isovalues that are at most the values of the face");
  add_speed_options(command, options->speed_options);
  command.set_callback([job, options] { run_isolines(*job, *options); });
}

} // namespace program
