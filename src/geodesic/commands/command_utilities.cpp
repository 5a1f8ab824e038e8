// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/command_utilities.h"

#include "readers/Scanner.h"
#include "io/write_surface_file.h"
#include "io/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <unordered_set>
#include <utility>

namespace program {

namespace {

bool is_solver_method(const std::string& method)
{
  return method == "dijkstra" || method == "fast-marching" || method == "euclidean" ||
         method == "exact" || method == "heat" || method == "automatic";
}

} // namespace

bool is_metric(const std::string& method)
{
  return method == "spectral" || method == "emd" || method == "biharmonic";
}

void check_basis(const std::string& method, const std::optional<std::size_t>& basis_size)
{
  if(basis_size && method != "emd")
    throw Usage_error("--basis: only the method emd has a basis.");
}

void check_method(const std::string& method, const std::string& option)
{
  if(is_metric(method))
    throw Usage_error(option + " " + method +
                      ": only the commands distance and matrix support this method.");
  if(!is_solver_method(method))
    throw Usage_error(option + " " + printable(method) +
                      ": the methods are automatic, exact, euclidean, fast-marching, dijkstra and "
                      "heat.");
}

void check_method_or_metric(const std::string& method)
{
  if(!is_metric(method) && !is_solver_method(method))
    throw Usage_error("--method " + printable(method) +
                      ": the methods are automatic, exact, euclidean, fast-marching, dijkstra, "
                      "heat, spectral, emd and biharmonic.");
}

Distance_method to_method(const std::string& method)
{
  return method == "dijkstra"        ? Distance_method::dijkstra
         : method == "fast-marching" ? Distance_method::fast_marching
         : method == "exact"         ? Distance_method::exact
         : method == "heat"          ? Distance_method::heat
         : method == "euclidean"     ? Distance_method::euclidean_front
                                     : Distance_method::automatic;
}

void check_memory(const Job& job, const std::string& method)
{
  if(!job.surface().is_mesh())
    return;
  // The maxima on the meshes of the manual, in bytes per vertex. Meshes of needles need more.
  const double bytes_per_vertex = method == "dijkstra"                         ? 35.
                                  : method == "fast-marching"                  ? 165.
                                  : method == "euclidean"                      ? 325.
                                  : method == "exact" || method == "automatic" ? 130.
                                                                               : 0.;
  const std::string name = method == "automatic" ? "exact" : method;
  job.check_memory("the method " + name,
                   bytes_per_vertex * double(job.surface().file.points.size()));
}

void check_method(const std::string& method, const Surface& surface)
{
  if(method == "exact" && !surface.is_mesh())
    fail(surface.name, "the method exact needs a mesh, but the input is a cloud");
}

std::vector<std::uint32_t> picture_triangles(const Cloud_domain& domain)
{
  // Not public: The triangles of a cloud overlap, so no function returns them as a mesh.
  const auto& surfels = domain.surfels();
  const auto& t = surfels.arrays;
  // The triangles of a cloud overlap if the one-rings of its surfels disagree. Triangles of
  // largest weight (found by the most surfels) are accepted first. Each directed halfedge is used
  // once.
  std::vector<std::uint32_t> order(t.number_of_triangles());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t f, std::uint32_t g) { return t.weight[f] > t.weight[g]; });
  std::unordered_set<std::uint64_t> used_halfedges;
  used_halfedges.reserve(t.corner.size());
  std::vector<std::uint32_t> corners;
  for(const std::uint32_t f : order)
  {
    std::uint64_t halfedges[3];
    for(std::size_t k = 0; k < 3; ++k)
      halfedges[k] = std::uint64_t{t.corner[3 * std::size_t{f} + k]} << 32 |
                     t.corner[3 * std::size_t{f} + (k + 1) % 3];
    if(std::any_of(halfedges, halfedges + 3,
                   [&](std::uint64_t h) { return used_halfedges.count(h) > 0; }))
      continue;
    used_halfedges.insert(halfedges, halfedges + 3);
    for(const std::uint64_t h : halfedges)
      corners.push_back(surfels.caller_vertex[h >> 32]);
  }
  return corners;
}

Cloud_domain make_domain(const Cloud& cloud, const Job& job)
{
  return Cloud_domain(cloud, GP::parameters::number_of_threads(job.threads()));
}

template <typename Domain>
typename Domain::Location locate(const Domain& domain, const std::string& text,
                                 const std::string& option)
{
  return GP::Surface_locator<typename Domain::Surface>(domain)(parse_point_3(text, option));
}

template Mesh_domain::Location locate(const Mesh_domain&, const std::string&, const std::string&);
template Cloud_domain::Location locate(const Cloud_domain&, const std::string&, const std::string&);

template <typename Domain>
std::vector<std::size_t> farthest_vertices(const Domain& domain, std::size_t number, Job& job,
                                           const std::vector<double>& speeds)
{
  using Vertex = typename Domain::Vertex;
  std::vector<Vertex> vertices;
  GP::farthest_vertex_sampling(domain, number, std::back_inserter(vertices),
                               GP::parameters::random_seed(job.seed())
                                   .callback(job.progress_callback("farthest vertices"))
                                   .speed_map(speed_map<Vertex>(speeds)));
  std::vector<std::size_t> result;
  for(const auto& one : vertices)
    result.push_back(static_cast<std::size_t>(one));
  return result;
}

template std::vector<std::size_t> farthest_vertices(const Mesh_domain&, std::size_t, Job&,
                                                    const std::vector<double>&);
template std::vector<std::size_t> farthest_vertices(const Cloud_domain&, std::size_t, Job&,
                                                    const std::vector<double>&);

void report_unreached(Job& job, const std::vector<long long>& labels)
{
  const auto unreached = std::count(labels.begin(), labels.end(), -1);
  job.result()["unreached"] = unreached;
  if(unreached > 0)
    job.print_line("unreached       " + std::to_string(unreached) + " of " +
                   std::to_string(labels.size()));
}

std::string labels_text(const std::vector<long long>& labels)
{
  std::string text;
  for(const long long label : labels)
    text += std::to_string(label) + '\n';
  return text;
}

Surface_file to_file(const Mesh& mesh)
{
  Surface_file result;
  for(const auto v : mesh.vertices())
    result.points.push_back(coordinates(mesh.point(v)));
  for(const auto f : mesh.faces())
  {
    for(const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      result.corners.push_back(v);
    result.polygon_begin.push_back(result.corners.size());
  }
  return result;
}

std::string points_text(const std::vector<Point>& points)
{
  std::string text;
  for(const Point& p : points)
    text += number_text(p[0]) + ' ' + number_text(p[1]) + ' ' + number_text(p[2]) + '\n';
  return text;
}

const std::vector<double>& property(const Surface& surface, const std::string& name)
{
  const auto found = surface.file.properties.find(name);
  if(found != surface.file.properties.end())
    return found->second;
  std::string names;
  for(const auto& other : surface.file.properties)
    names += (names.empty() ? "" : ", ") + other.first;
  fail(surface.name, "the vertices have no property '" + printable(name) + "'" +
                         (names.empty() ? ", and no other properties" : ", only " + names));
}

double report_distances(Job& job, const std::vector<double>& distances)
{
  double largest_distance = 0.;
  std::size_t unreached = 0;
  for(const double x : distances)
    if(std::isfinite(x))
      largest_distance = std::max(largest_distance, x);
    else
      ++unreached;
  job.result()["max"] = json_number(largest_distance);
  job.result()["unreached"] = unreached;
  job.print_line("largest distance  " + rounded_text(largest_distance));
  if(unreached > 0)
    job.print_line("unreached         " + std::to_string(unreached) + " of " +
                   std::to_string(distances.size()));
  return largest_distance;
}

Surface_file separate_regions(const Surface_file& mesh,
                              const std::vector<std::uint32_t>& face_labels,
                              std::vector<long long>& vertex_labels)
{
  Surface_file result;
  vertex_labels.clear();
  // The index of each label and vertex
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> index;
  for(std::size_t corner = 0; corner < mesh.corners.size(); ++corner)
  {
    const std::uint32_t label = face_labels[corner / 3], vertex = mesh.corners[corner];
    const auto [entry, is_new] =
        index.try_emplace({label, vertex}, static_cast<std::uint32_t>(result.points.size()));
    if(is_new)
    {
      result.points.push_back(mesh.points[vertex]);
      vertex_labels.push_back(
          label == std::numeric_limits<std::uint32_t>::max() ? -1 : static_cast<long long>(label));
    }
    result.corners.push_back(entry->second);
    if(corner % 3 == 2)
      result.polygon_begin.push_back(result.corners.size());
  }
  return result;
}

void write_polylines(const Job& job, std::vector<std::vector<Point>> polylines)
{
  if(job.output().empty())
    return;
  Surface_file file;
  file.polylines = std::move(polylines);
  write_surface_file(job.output(), file);
}

void write_result(const Job& job, const std::string& name, const std::vector<double>& values,
                  double size)
{
  Surface_file file = job.surface().file;
  file.properties[name] = values;
  if(file_extension(job.output()) == "obj")
  {
    file.uv.clear();
    for(const double x : values)
      file.uv.push_back({std::isfinite(x) && size > 0. ? std::clamp(x / size, 0., 1.) : 0., 0.5});
  }
  write_surface_file(job.output(), file, name);
}

} // namespace program
