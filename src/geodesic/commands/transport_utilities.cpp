// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/transport_utilities.h"

#include "readers/read_bytes.h"
#include "io/write_surface_file.h"
#include "io/errors.h"

#include <cmath>
#include <fstream>

namespace program {

namespace {

// Reads a file with one number per line.
std::vector<double> read_masses_file(const std::string& name, std::size_t number)
{
  const Bytes bytes = read_bytes(name);
  Scanner scanner(bytes, name, '#');
  std::vector<double> result;
  while(scanner.next_line())
  {
    result.push_back(scanner.parse_coordinate(scanner.word()));
    if(!scanner.is_line_empty())
      scanner.fail("the line contains more than one number");
  }
  if(result.size() != number)
    fail(name, "the number of masses is " + std::to_string(result.size()) +
                   ", but the number of vertices is " + std::to_string(number));
  return result;
}

double norm(const Point& p) { return std::hypot(p[0], p[1], p[2]); }

// Returns segments along the flow at up to about 4,000 faces or surfels. Their length increases
// with the strength of the flow, up to a maximum.
std::vector<std::vector<Point>> flow_arrows(const Surface_file& file,
                                            const std::vector<Point>& flow)
{
  constexpr std::size_t max_arrows = 4000;
  Point low = file.points[0], high = low;
  for(const Point& p : file.points)
    for(std::size_t c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  const double size = norm({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  std::vector<double> strength;
  for(const Point& v : flow)
    strength.push_back(norm(v));
  std::vector<double> sorted = strength;
  std::sort(sorted.begin(), sorted.end());
  const double reference_strength =
      sorted[sorted.size() - 1 - sorted.size() / 50]; // 2 % of the vectors are stronger
  std::vector<std::vector<Point>> result;
  const std::size_t step = std::max<std::size_t>(1, flow.size() / max_arrows);
  for(std::size_t i = 0; i < flow.size(); i += step)
  {
    if(!(strength[i] > 0.02 * reference_strength))
      continue;
    Point p = file.points[std::min(i, file.points.size() - 1)];
    if(!file.corners.empty())
      for(std::size_t c = 0; c < 3; ++c)
        p[c] = (file.points[file.corners[3 * i]][c] + file.points[file.corners[3 * i + 1]][c] +
                file.points[file.corners[3 * i + 2]][c]) /
               3.;
    const double length =
        0.02 * size * std::min(1., strength[i] / reference_strength) / strength[i];
    Point q = p;
    for(std::size_t c = 0; c < 3; ++c)
      q[c] += length * flow[i][c];
    result.push_back({p, q});
  }
  return result;
}

void draw_transport(const Job& job, const Transport_result& result,
                    const std::vector<std::size_t>& marked_vertices)
{
  Picture picture{&job.surface().file};
  picture.values = result.potential;
  picture.title = "potential";
  picture.triangles = result.triangles;
  picture.thin_polylines = flow_arrows(job.surface().file, result.fields.at("flow"));
  for(const std::size_t vertex : marked_vertices)
    picture.markers.push_back(job.surface().file.points[vertex]);
  add_feature_polylines(result, picture);
  draw(job.picture(), picture);
}

} // namespace

void add_feature_polylines(const Transport_result& result, Picture& picture)
{
  for(const std::vector<Point>& polyline : result.feature_polylines)
    if(polyline.size() == 1)
      picture.markers.push_back(polyline.front());
    else
      picture.polylines.push_back(polyline);
}

bool is_vertex_list(const std::string& text)
{
  return !text.empty() && text.find_first_not_of("0123456789,") == std::string::npos;
}

Masses read_masses(const std::string& text, const std::string& option,
                   const Transport_options& options, const Surface& surface)
{
  Masses result;
  const std::size_t n = surface.file.points.size();
  if(is_vertex_list(text))
  {
    result.vertices = parse_indices(text, option);
    result.values.assign(n, 0.);
    for(const std::size_t vertex : result.vertices)
    {
      check_vertex(surface, vertex);
      result.values[vertex] += 1. / static_cast<double>(result.vertices.size());
    }
    return result;
  }
  result.is_density = options.density;
  const bool is_property = surface.file.properties.count(text) > 0;
  result.values =
      !is_property && std::ifstream(text) ? read_masses_file(text, n) : property(surface, text);
  return result;
}

std::vector<std::size_t> region_vertices(const std::string& text, const std::string& option,
                                         const Surface& surface)
{
  std::vector<std::size_t> result;
  if(is_vertex_list(text))
  {
    result = parse_indices(text, option);
    for(const std::size_t vertex : result)
      check_vertex(surface, vertex);
    return result;
  }
  const std::vector<double> values = property(surface, text);
  for(std::size_t i = 0; i < values.size(); ++i)
    if(values[i] > 0.)
      result.push_back(i);
  if(result.empty())
    fail(surface.name, "the property " + printable(text) + " is not positive at any vertex");
  return result;
}

void add_region_options(Command& command, Region_options& options, const std::string& prefix)
{
  options.at_option = prefix + "-at";
  options.path_option = prefix + "-path";
  command.add(options.at_option, options.at, "x,y,z",
              "location on a mesh closest to a point; can be repeated");
  command.add(options.path_option, options.paths, "V,V[,V...]",
              "shortest path on a mesh through these vertices; can be repeated");
}

void check(const Region_options& options)
{
  for(const std::string& point : options.at)
    parse_point(point, options.at_option);
  for(const std::string& path : options.paths)
    if(parse_indices(path, options.path_option).size() < 2)
      throw Usage_error(options.path_option + ": at least two vertices are required.");
}

void check(const Region_options& options, const Surface& surface)
{
  if(!options.empty() && !surface.is_mesh())
    fail(surface.name, options.at_option + " and " + options.path_option + " need a mesh");
  for(const std::string& path : options.paths)
    for(const std::size_t vertex : parse_indices(path, options.path_option))
      check_vertex(surface, vertex);
}

void add_query_options(Command& command, Transport_options& options)
{
  command.add_flag("--density", options.density,
                   "values of properties and files are mass per area");
  command.add_flag("--normalize", options.normalize,
                   "scale each mass distribution to total mass 1");
  command
      .add("--method", options.method, "NAME",
           "interior-point, admm (for tolerances of about 0.01) or weiszfeld")
      .shows_default();
  command
      .add("--tolerance", options.tolerance, "T",
           "maximum gap between lower and upper bound, relative to the upper bound")
      .shows_default();
  command.add("--refine", options.refine, "N",
              "number of 1-to-4 refinements of the triangles, which reduce the error on curved "
              "surfaces (default 1 up to 5,000 vertices, otherwise 0)");
}

void add_options(Command& command, Transport_options& options)
{
  add_query_options(command, options);
  command.add_flag("--bound-above", options.bound_above,
                   "also compute an upper bound for flows on the surface itself, which must be a "
                   "mesh");
  command.add_flag(
      "--hodge", options.hodge,
      "also write the Hodge decomposition of the flow: gradient, rotation and harmonic field, or "
      "on a cloud gradient and remainder");
  add_speed_options(command, options.speed_options);
}

void check(const Transport_options& options, const Surface& surface)
{
  if(!surface.is_mesh() && options.bound_above)
    fail(surface.name, "--bound-above needs a mesh, but the input is a cloud");
}

void check(const Transport_options& options)
{
  if(!(options.tolerance > 0.))
    throw Usage_error("--tolerance: the tolerance must be positive.");
  if(options.method != "interior-point" && options.method != "admm" &&
     options.method != "weiszfeld")
    throw Usage_error("--method " + printable(options.method) +
                      ": the methods are interior-point, admm and weiszfeld.");
  check(options.speed_options);
}

void report(Job& job, const Transport_options& options, const GP::Earth_movers_cost& cost,
            const std::string& title)
{
  const auto print_line = [&](const std::string& label, const std::string& text)
  {
    job.print_line(label +
                   std::string(std::max<std::size_t>(24, label.size() + 2) - label.size(), ' ') +
                   text);
  };
  job.result()["value"] = json_number(cost.value);
  job.result()["lower"] = json_number(cost.lower);
  job.result()["upper"] = json_number(cost.upper);
  if(options.bound_above)
    job.result()["upper_continuous"] = json_number(cost.upper_continuous);
  job.result()["iterations"] = cost.number_of_iterations;
  job.result()["residual"] = json_number(cost.residual);
  job.result()["converged"] = cost.is_converged;
  print_line(title, rounded_text(cost.value));
  print_line("bounds", rounded_text(cost.lower) + " to " + rounded_text(cost.upper));
  if(options.bound_above)
    print_line("on the surface", "at most " + rounded_text(cost.upper_continuous));
  if(!cost.is_converged)
    job.print_warning("the gap between the bounds exceeds --tolerance");
}

void write_transport(const Job& job, const Transport_result& result,
                     const std::vector<std::size_t>& marked_vertices)
{
  job.write_values([&] { return number_lines(result.potential); });
  if(!job.picture().empty())
    draw_transport(job, result, marked_vertices);
  if(job.output().empty())
    return;
  Surface_file file = job.surface().file;
  if(!result.potential.empty())
    file.properties["potential"] = result.potential;
  if(!result.arrivals.empty())
    file.properties["arrivals"] = result.arrivals;
  if(!file.corners.empty())
    file.vectors = result.fields;
  else
    for(const auto& [name, vectors] : result.fields)
      for(std::size_t c = 0; c < 3; ++c)
      {
        std::vector<double>& values = file.properties[name + "_" + "xyz"[c]];
        for(const Point& v : vectors)
          values.push_back(v[c]);
      }
  write_surface_file(job.output(), file);
}

template <typename Domain>
Mass_distribution distribution(const Domain& domain, const Masses& given)
{
  using GP::internal::masses; // Not public: This function returns a Mass_distribution.
  const Property_map<typename Domain::Vertex> map{&given.values};
  return given.is_density ? masses(domain, GP::mass_density(map)) : masses(domain, map);
}

template <typename Domain>
void add_sources(const Domain& domain, const Region_options& options, const Surface& surface,
                 std::vector<GP::Source<typename Domain::Surface>>& region,
                 Transport_result& result)
{
  using Surface_type = typename Domain::Surface;
  if constexpr(is_mesh<Surface_type>)
  {
    for(const std::string& point : options.at)
    {
      const auto place = locate(domain, point, options.at_option);
      region.emplace_back(place);
      result.feature_polylines.push_back({location_point(domain, place)});
    }
    for(const std::string& text : options.paths)
    {
      GP::Geodesic_path_finder<Surface_type> find(domain);
      const std::vector<std::size_t> vertices = parse_indices(text, options.path_option);
      typename GP::Source<Surface_type>::Polyline polyline;
      result.feature_polylines.emplace_back();
      for(std::size_t i = 1; i < vertices.size(); ++i)
      {
        const auto path =
            find(vertex_at<Surface_type>(vertices[i - 1]), vertex_at<Surface_type>(vertices[i]));
        if(path.empty())
          fail(surface.name, "no path connects the vertices " + std::to_string(vertices[i - 1]) +
                                 " and " + std::to_string(vertices[i]));
        polyline.insert(polyline.end(), path.locations.begin(), path.locations.end());
        for(const auto& point : path.points)
          result.feature_polylines.back().push_back(coordinates(point));
      }
      region.emplace_back(std::move(polyline));
    }
  }
}

template <typename Domain>
void copy_solution(const Domain& domain,
                   const GP::Transport_solution<typename Domain::Surface>& solution, const Job& job,
                   Transport_result& result)
{
  for(std::size_t i = 0; i < job.surface().file.points.size(); ++i)
    result.potential.push_back(solution.potential(vertex_at<typename Domain::Surface>(i)));
  solution.write_flow(vector_map(result.fields["flow"], domain));
}

template <typename Domain>
void add_hodge_decomposition(const Domain& domain, const Transport_options& options,
                             Transport_result& result)
{
  if(!options.hodge)
    return;
  const auto map = [&](const char* name) { return vector_map(result.fields[name], domain); };
  if constexpr(is_mesh<typename Domain::Surface>)
    GP::hodge_decomposition(domain, map("flow"), map("gradient"), map("rotation"), map("harmonic"));
  else
    GP::hodge_decomposition(domain, map("flow"), map("gradient"), map("remainder"));
}

template Mass_distribution distribution(const Mesh_domain&, const Masses&);
template Mass_distribution distribution(const Cloud_domain&, const Masses&);
template void add_sources(const Mesh_domain&, const Region_options&, const Surface&,
                          std::vector<GP::Source<Mesh>>&, Transport_result&);
template void add_sources(const Cloud_domain&, const Region_options&, const Surface&,
                          std::vector<GP::Source<Cloud>>&, Transport_result&);
template void copy_solution(const Mesh_domain&, const GP::Transport_solution<Mesh>&, const Job&,
                            Transport_result&);
template void copy_solution(const Cloud_domain&, const GP::Transport_solution<Cloud>&, const Job&,
                            Transport_result&);
template void add_hodge_decomposition(const Mesh_domain&, const Transport_options&,
                                      Transport_result&);
template void add_hodge_decomposition(const Cloud_domain&, const Transport_options&,
                                      Transport_result&);

} // namespace program
