// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_results.h"

#include "Results.h"
#include "mesh_properties.h"
#include "overlaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <utility>

namespace mass_test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The round-off errors of lengths, areas and bounds, relative to them. On a hundred meshes, the
// lengths of shortest paths differed from exact distances by at most 1.3e-14. The lower bound of a
// path is 2e-12 below its length, unless there are thin triangles.
constexpr double round_off = 1e-9;

// The largest mean relative error of Euclidean_front. On 699 meshes the 99 % quantile is 0.75 %. On
// meshes of few long triangles it is larger, so the limit is seven times as much.
constexpr double max_mean_error = 0.05;

double distance(const Point& p, const Point& q)
{
  return std::hypot(p.x() - q.x(), p.y() - q.y(), p.z() - q.z());
}

// What the checks of several commands use
struct Input
{
  std::vector<Point> points;
  // The polygons, if CGAL reads the same points in the same order from the file, otherwise empty.
  Polygons polygons;
  std::vector<double> exact; // distances from vertex 0; empty if there are none
};

Topology reported_topology(Results& results)
{
  return {results.number("info", "components"), results.number("info", "boundary_loops"),
          results.number("info", "genus")};
}

// The polygons must be the faces that the program reports.
void check_faces(Results& results, const Soup& soup)
{
  const nlohmann::json& info = results.json("info");
  if(info.value("repaired", true) || info.value("kind", "") != "mesh")
    return;
  const double faces = results.number("info", "faces");
  results.expect(faces == double(soup.polygons.size()), "info",
                 "the surface has % faces, and CGAL reads %",
                 {faces, double(soup.polygons.size())});
  const std::optional<Topology> topology = topology_of(soup);
  const bool is_manifold = info.value("manifold", false);
  results.expect(topology.has_value() == is_manifold, "info",
                 is_manifold ? "the surface is a manifold, but not for CGAL"
                             : "the surface is not a manifold, but it is for CGAL");
  if(!topology)
    return;
  const Topology reported = reported_topology(results);
  results.expect(
      reported == *topology, "info",
      "the surface has % components, % boundary cycles and genus %, and CGAL computes %, "
      "% and %",
      {reported.components, reported.boundary_cycles, reported.genus, topology->components,
       topology->boundary_cycles, topology->genus});
}

Input check_info(Results& results)
{
  Input input;
  if(!results.has("info"))
    return input;
  const std::vector<double> values = results.values("info", 3);
  for(std::size_t i = 0; i < values.size(); i += 3)
    input.points.emplace_back(values[i], values[i + 1], values[i + 2]);
  results.expect(results.number("info", "vertices") == double(input.points.size()), "info",
                 "the number of vertices differs from the number of points");
  std::optional<Soup> soup = read_soup(results.surface());
  // CGAL ignores triangle strips of PLY files. Their faces are then unknown.
  const bool has_strips = soup && soup->polygons.empty() && results.surface().extension() == ".ply";
  if(soup && !has_strips && soup->points == input.points)
  {
    check_faces(results, *soup);
    input.polygons = std::move(soup->polygons);
  }
  return input;
}

// Returns whether the polygon has at least three different corners. Others are removed.
bool is_face(const std::vector<std::size_t>& polygon)
{
  return std::set<std::size_t>(polygon.begin(), polygon.end()).size() > 2;
}

// Returns the number of vertices without a polygon, or infinity if the polygons are unknown.
double number_of_isolated_vertices(const Input& input)
{
  if(input.polygons.empty())
    return infinity;
  std::vector<bool> is_isolated(input.points.size(), true);
  for(const auto& polygon : input.polygons)
    if(is_face(polygon))
      for(const std::size_t v : polygon)
        is_isolated[v] = false;
  return double(std::count(is_isolated.begin(), is_isolated.end(), true));
}

// Returns the length that the library gives to shorter edges: 2^-36 of a unit, which is at most
// half of the longest edge of the bounding box.
double min_edge_length(const std::vector<Point>& points)
{
  double extent = 0.;
  for(int k = 0; k < 3; ++k)
  {
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(), [k](const Point& p, const Point& q) { return p[k] < q[k]; });
    extent = std::max(extent, (*high)[k] - (*low)[k]);
  }
  return 0x1p-36 * 0.5 * extent;
}

// Returns the length of a shortest path along edges from vertex 0 to each vertex. Distances are
// exact for edges with the minimum length of the library, so edges have at least that length here.
std::vector<double> dijkstra(const Input& input)
{
  const double min_length = min_edge_length(input.points);
  std::vector<std::vector<std::size_t>> neighbors(input.points.size());
  for(const auto& polygon : input.polygons)
    if(is_face(polygon))
      for(std::size_t k = 0; k < polygon.size(); ++k)
      {
        neighbors[polygon[k]].push_back(polygon[(k + 1) % polygon.size()]);
        neighbors[polygon[(k + 1) % polygon.size()]].push_back(polygon[k]);
      }
  std::vector<double> result(input.points.size(), infinity);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  result[0] = 0.;
  for(queue.push({0., 0}); !queue.empty();)
  {
    const auto [d, v] = queue.top();
    queue.pop();
    if(d > result[v])
      continue;
    for(const std::size_t w : neighbors[v])
      if(const double sum = d + std::max(distance(input.points[v], input.points[w]), min_length);
         sum < result[w])
      {
        result[w] = sum;
        queue.push({sum, w});
      }
  }
  return result;
}

// Reads the distances of a method. There is one for each vertex, and infinity if it is unreached.
std::vector<double> check_distances(Results& results, const std::string& command,
                                    const Input& input)
{
  if(!results.has(command))
    return {};
  std::vector<double> d = results.values(command, 1, false);
  if(d.size() != input.points.size())
  {
    results.add_violation(command, "the number of distances differs from the number of vertices");
    return {};
  }
  results.expect(d[0] == 0., command, "the distance of the source is %", {d[0]});
  const auto negative = std::find_if(d.begin(), d.end(), [](double x) { return x < 0.; });
  results.expect(negative == d.end(), command, "the distance of vertex % is negative",
                 {double(negative - d.begin())});
  const double unreached = double(std::count(d.begin(), d.end(), infinity));
  results.expect(results.number(command, "unreached") == unreached, command,
                 "% vertices are unreached, and the JSON has another number", {unreached});
  return d;
}

// The distance of a vertex is at least its straight distance, and at most the length of a shortest
// path along edges.
void check_exact(Results& results, const Input& input)
{
  if(input.exact.empty())
    return;
  for(std::size_t i = 0; i < input.exact.size(); ++i)
    if(const double straight = distance(input.points[0], input.points[i]);
       input.exact[i] < straight * (1. - round_off))
    {
      results.expect(false, "exact",
                     "the distance of vertex % is %, but its straight distance is %",
                     {double(i), input.exact[i], straight});
      break;
    }
  if(input.polygons.empty())
    return;
  const std::vector<double> along_edges = dijkstra(input);
  for(std::size_t i = 0; i < input.exact.size(); ++i)
    if(input.exact[i] > along_edges[i] * (1. + round_off))
    {
      results.expect(false, "exact",
                     "the distance of vertex % is %, but a path along edges has the length %",
                     {double(i), input.exact[i], along_edges[i]});
      break;
    }
}

// The front reaches the same vertices as the exact method, at nearly the same distances.
void check_front(Results& results, const Input& input)
{
  const std::vector<double> front = check_distances(results, "front", input);
  if(front.empty() || input.exact.empty())
    return;
  double largest = 0.;
  for(const double x : input.exact)
    if(x != infinity)
      largest = std::max(largest, x);
  double sum = 0.;
  std::size_t number = 0;
  for(std::size_t i = 0; i < front.size(); ++i)
  {
    if((front[i] == infinity) != (input.exact[i] == infinity))
    {
      results.expect(false, "front", "the distance of vertex % is %, but the exact distance is %",
                     {double(i), front[i], input.exact[i]});
      return;
    }
    // Close to the source, relative errors have no meaning. The manual omits the same vertices.
    if(input.exact[i] == infinity || input.exact[i] <= 0.05 * largest)
      continue;
    sum += std::abs(front[i] / input.exact[i] - 1.);
    ++number;
  }
  results.expect(number == 0 || sum / number <= max_mean_error, "front",
                 "the mean relative error is %", {sum / number});
}

// Returns the triangles of the surface, or no value if they are unknown. The atlas has all of them,
// as the program reads and triangulates the file.
std::optional<std::vector<std::array<Point, 3>>> surface_triangles(Results& results,
                                                                   const Input& input)
{
  std::vector<std::array<Point, 3>> triangles;
  if(results.has("atlas"))
    if(const auto mesh = read_textured_mesh(results.path("atlas.obj")))
    {
      for(const auto& [a, b, c] : mesh->corners)
        triangles.push_back({mesh->points[a], mesh->points[b], mesh->points[c]});
      return triangles;
    }
  for(const auto& polygon : input.polygons)
  {
    if(polygon.size() != 3)
      return std::nullopt;
    triangles.push_back(
        {input.points[polygon[0]], input.points[polygon[1]], input.points[polygon[2]]});
  }
  if(triangles.empty())
    return std::nullopt;
  return triangles;
}

// Returns a bound of what the library subtracts from lower bounds because of thin triangles, where
// c is the longest edge, and d the excess of the sum of the others:
// - It lengthens the edges of triangles without area. The height above c is then at most
//   sqrt(c d / 2 + d^2 / 4), and a path crosses each triangle at most once. It subtracts the height
//   if d < 1e-14 c. Round-off errors of the lengths change d by a few 1e-16 c, so triangles up to
//   d = 2e-14 c count here, with the height 1e-7 c of that d.
// - If the height h is less than c / 30, it subtracts 10 epsilon c^2 / h, at most 5e-8 c. In these
//   triangles, round-off errors change h by a few percent, so twice as much counts here.
// - It lengthens edges to 2^-36 < 1.5e-11 of half of the extent. So do edges that have become
//   slightly longer than that.
double allowed_gap(const std::vector<std::array<Point, 3>>& triangles)
{
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double result = 0., extent = 0.;
  for(const auto& triangle : triangles)
    for(const Point& p : triangle)
      for(int k = 0; k < 3; ++k)
        extent = std::max(extent, std::abs(p[k] - triangles[0][0][k]));
  for(const auto& [p, q, r] : triangles)
  {
    const double a = distance(p, q), b = distance(q, r), c = distance(r, p);
    const double longest = std::max({a, b, c});
    if(a + b + c - 2. * longest < 2e-14 * longest)
      result += 1e-7 * longest;
    else if(const double height = std::sqrt(4. * CGAL::squared_area(p, q, r)) / longest;
            longest > 29. * height)
      result += std::min(20. * epsilon * longest * (longest / height), 1e-7 * longest);
    for(const double edge : {a, b, c})
      if(edge < 3e-11 * extent)
        result += 3e-11 * extent;
  }
  return result;
}

// The path joins vertex 0 and the target, and its length is their exact distance.
void check_path(Results& results, const Input& input)
{
  if(!results.has("path"))
    return;
  const double length = results.number("path", "length"), lower = results.number("path", "lower");
  const std::vector<double> values = results.values("path", 3);
  std::vector<Point> points;
  for(std::size_t i = 0; i < values.size(); i += 3)
    points.emplace_back(values[i], values[i + 1], values[i + 2]);
  if(points.empty() || results.target() >= input.points.size())
    return;
  // Without the triangles, it is unknown how far the lower bound is below the length.
  const auto triangles = surface_triangles(results, input);
  const double gap = triangles ? allowed_gap(*triangles) : infinity;
  results.expect(lower <= length && length <= lower * (1. + round_off) + gap, "path",
                 "the length is %, but its lower bound is %", {length, lower});
  double sum = 0.;
  for(std::size_t i = 1; i < points.size(); ++i)
    sum += distance(points[i - 1], points[i]);
  // The points are on edges. Far from the origin, their round-off errors exceed those of lengths.
  double magnitude = 0.;
  for(const double x : values)
    magnitude = std::max(magnitude, std::abs(x));
  const double error = round_off * length + 1e-14 * magnitude * double(points.size());
  results.expect(std::abs(sum - length) <= error, "path",
                 "the length is %, but the segments have the length %", {length, sum});
  const Point &begin = input.points[0], &end = input.points[results.target()];
  results.expect(distance(points.front(), begin) <= error && distance(points.back(), end) <= error,
                 "path", "the path does not join vertex 0 and vertex %",
                 {double(results.target())});
  results.expect(length >= distance(begin, end) * (1. - round_off), "path",
                 "the length is %, but the straight distance is %", {length, distance(begin, end)});
  // Thin triangles cause errors of exact distances, which are at most those of lower bounds.
  if(!input.exact.empty())
    results.expect(std::abs(length - input.exact[results.target()]) <=
                       round_off * length + (triangles ? gap : 0.),
                   "path", "the length is %, but the exact distance is %",
                   {length, input.exact[results.target()]});
}

// The samples are distinct locations on the surface. Different locations can be at the same point.
void check_sample(Results& results, const Input& input)
{
  if(!results.has("sample"))
    return;
  using Location = std::map<double, double>; // barycentric coordinates by vertex, without zeros
  const std::vector<double> values = results.values("sample", 6);
  std::set<Location> locations;
  const std::size_t number_of_samples = values.size() / 6;
  for(std::size_t i = 0; i < number_of_samples; ++i)
  {
    Location location;
    double sum = 0.;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const double vertex = values[6 * i + k], coordinate = values[6 * i + 3 + k];
      if(!(vertex >= 0. && vertex < double(input.points.size()) && coordinate >= 0.))
      {
        results.expect(false, "sample", "sample % is not on the surface", {double(i)});
        return;
      }
      if(coordinate > 0.)
        location[vertex] = coordinate;
      sum += coordinate;
    }
    results.expect(std::abs(sum - 1.) <= round_off, "sample",
                   "the barycentric coordinates of sample % have the sum %", {double(i), sum});
    locations.insert(location);
  }
  results.expect(results.number("sample", "samples") == double(number_of_samples), "sample",
                 "the JSON has another number of samples than the values");
  results.expect(locations.size() == number_of_samples, "sample", "two samples are equal");
  const auto& radius = results.json("sample")["covering_radius"];
  if(radius.is_null())
  {
    const double components = results.has("info") ? results.number("info", "components") : infinity;
    results.expect(components > double(number_of_samples), "sample",
                   "the covering radius is infinite, but there are % samples on % components",
                   {double(number_of_samples), components});
    return;
  }
  results.expect(radius.get<double>() >= 0., "sample", "the covering radius is negative");
}

// Each label is the index of a seed, and each vertex without a label is counted as unreached.
void check_voronoi(Results& results, const Input& input)
{
  if(!results.has("voronoi"))
    return;
  const std::vector<double> labels = results.values("voronoi", 1);
  const auto seeds = results.json("voronoi").value("seeds", std::vector<std::size_t>());
  if(labels.size() != input.points.size())
  {
    results.add_violation("voronoi", "the number of labels differs from the number of vertices");
    return;
  }
  for(std::size_t i = 0; i < labels.size(); ++i)
    if(labels[i] != std::floor(labels[i]) || labels[i] < -1. || labels[i] >= double(seeds.size()))
    {
      results.expect(false, "voronoi", "the label of vertex % is %", {double(i), labels[i]});
      return;
    }
  const double unreached = double(std::count(labels.begin(), labels.end(), -1.));
  results.expect(results.number("voronoi", "unreached") == unreached, "voronoi",
                 "% vertices have no label, and the JSON has another number", {unreached});
  const double components = results.number("info", "components");
  results.expect(unreached <= number_of_isolated_vertices(input) ||
                     components > double(seeds.size()),
                 "voronoi", "% vertices have no label, but there are % seeds on % components",
                 {unreached, double(seeds.size()), components});
  // A seed can have the label of another seed only at the same point.
  for(const std::size_t seed : seeds)
    results.expect(labels[seed] >= 0. &&
                       input.points[seeds[std::size_t(labels[seed])]] == input.points[seed],
                   "voronoi", "the seed at vertex % has the label %", {double(seed), labels[seed]});
}

// Each label is the index of a chart, and no step increases the energy.
void check_segment(Results& results)
{
  if(!results.has("segment"))
    return;
  const double charts = results.number("segment", "charts");
  for(const double label : results.values("segment", 1))
    if(label != std::floor(label) || label < -1. || label >= charts)
    {
      results.expect(false, "segment", "the label of a face is %", {label});
      break;
    }
  std::vector<double> energies;
  for(const auto& energy : results.json("segment").value("energies", nlohmann::json::array()))
    if(energy.is_number()) // null is reported elsewhere
      energies.push_back(energy.get<double>());
  for(std::size_t i = 1; i < energies.size(); ++i)
    results.expect(energies[i] <= energies[i - 1] * (1. + round_off), "segment",
                   "step % increases the energy from % to %",
                   {double(i), energies[i - 1], energies[i]});
}

// The mesh that a command writes is a triangle mesh with the topology of the input.
void check_remeshing(Results& results, const std::string& command, const Input& given)
{
  if(!results.has(command) || !results.has("info"))
    return;
  const std::optional<Soup> soup = read_soup(results.path(command + ".off"));
  if(!soup)
  {
    results.add_violation(command, "CGAL cannot read the mesh");
    return;
  }
  results.expect(results.number(command, "vertices_out") == double(soup->points.size()) &&
                     results.number(command, "faces_out") == double(soup->polygons.size()),
                 command, "the mesh has % vertices and % faces, and the JSON has other numbers",
                 {double(soup->points.size()), double(soup->polygons.size())});
  const std::optional<Topology> topology = topology_of(*soup);
  if(!topology)
  {
    results.add_violation(command, "the mesh is not a manifold");
    return;
  }
  const Topology input = reported_topology(results);
  results.expect(
      input == *topology, command,
      "the mesh has % components, % boundary cycles and genus %, and the input %, % and %",
      {topology->components, topology->boundary_cycles, topology->genus, input.components,
       input.boundary_cycles, input.genus});
  // A surface that is split at an edge has two vertices at the same point.
  const nlohmann::json& info = results.json("info");
  const double degenerate =
      double(number_of_degenerate_faces(*soup, {given.points, given.polygons}));
  results.expect(degenerate == 0. || !info.value("manifold", false) ||
                     info.value("degenerate_faces", 0) > 0,
                 command, "% faces have two corners at the same point", {degenerate});
  if(command == "semiregular")
    results.expect(results.number(command, "folds") == 0., command, "% triangles are inverted",
                   {results.number(command, "folds")});
  // The program counts intersecting faces before coordinates are rounded.
  if(command == "remesh" && results.number(command, "self_intersections") == 0.)
    results.expect(!intersects_itself(*soup), command,
                   "the mesh intersects itself, but not according to the JSON");
}

// Returns whether the height of a triangle is at least 1e-7 of its longest edge. The area of a
// lower one can be zero in double precision.
bool has_area(const Point& p, const Point& q, const Point& r)
{
  const double square = std::max(
      {CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p)});
  return 4. * CGAL::squared_area(p, q, r) > 1e-14 * square * square;
}

// The flips in the JSON are the faces with an area whose image is inverted or has no area.
void check_flatten(Results& results, const Input& input)
{
  if(!results.has("flatten") || !results.has("info"))
    return;
  const std::optional<Soup> soup = read_soup(results.path("flatten.off"));
  if(!soup || soup->points.size() != input.points.size())
  {
    results.add_violation("flatten", "the flat mesh does not have one point for each vertex");
    return;
  }
  double inverted = 0., degenerate = 0.;
  for(const auto& polygon : soup->polygons)
  {
    if(polygon.size() != 3)
      return;
    Kernel::Point_2 p[3];
    for(std::size_t k = 0; k < 3; ++k)
      p[k] = {soup->points[polygon[k]].x(), soup->points[polygon[k]].y()};
    const CGAL::Orientation orientation = CGAL::orientation(p[0], p[1], p[2]);
    const bool is_certain =
        orientation == CGAL::RIGHT_TURN &&
        has_area(input.points[polygon[0]], input.points[polygon[1]], input.points[polygon[2]]);
    inverted += is_certain;
    degenerate += orientation != CGAL::LEFT_TURN && !is_certain;
  }
  const double flips = results.number("flatten", "flips");
  results.expect(inverted <= flips && flips <= inverted + degenerate, "flatten",
                 "% faces are inverted and % are degenerate, but the JSON has % flips",
                 {inverted, degenerate, flips});
}

// The option --texels of mass.sh
constexpr double texture_size = 512.;

struct Chart_size
{
  double rest_area = 0.; // of the faces, if their heights are at least 1e-7 of their longest edges
  double image_area = 0.;
  std::set<std::size_t> vertices;
};

// Returns a power of two near the largest absolute coordinate, or 1 if all are zero.
double size_of(const std::vector<Point>& points)
{
  double result = 0.;
  for(const Point& p : points)
    result = std::max({result, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  return result > 0. ? std::ldexp(1., std::ilogb(result)) : 1.;
}

double squared_longest_edge(const Textured_mesh& mesh, const std::array<std::size_t, 3>& corners)
{
  double result = 0.;
  for(std::size_t k = 0; k < 3; ++k)
    result = std::max(
        result, CGAL::squared_distance(mesh.points[corners[k]], mesh.points[corners[(k + 1) % 3]]));
  return result;
}

// Returns the images of the faces. The areas of the faces and of their images agree with the JSON,
// and all charts have nearly the same scale.
//
// The mean of the symmetric Dirichlet energy of a chart is at most 8.5, or 100 if it has at most
// 100 vertices. The energy of a face is at least 2 (d + 1 / d), where d is the factor of its area.
// Therefore the factor of the area of a chart, which is the mean of d, is at most half of the
// maximum energy, and at least the reciprocal of that. The energy is computed with a minimum height
// of the faces, so the areas are too.
std::vector<Triangle_2> check_areas(Results& results, Textured_mesh mesh)
{
  // In this unit, squares of areas are representable.
  const double unit = size_of(mesh.points);
  for(Point& p : mesh.points)
    p = {p.x() / unit, p.y() / unit, p.z() / unit};
  double area = 0., coverage = 0., products = 0.;
  std::vector<Triangle_2> triangles;
  std::map<std::size_t, Chart_size> charts_by_label;
  const std::vector<std::size_t> chart = charts(mesh);
  for(std::size_t f = 0; f < mesh.corners.size(); ++f)
  {
    const auto& corners = mesh.corners[f];
    const double face_area = std::sqrt(CGAL::squared_area(
        mesh.points[corners[0]], mesh.points[corners[1]], mesh.points[corners[2]]));
    const auto& uv = mesh.uv_corners[f];
    triangles.push_back({mesh.uv[uv[0]], mesh.uv[uv[1]], mesh.uv[uv[2]]});
    const double image_area = CGAL::area(mesh.uv[uv[0]], mesh.uv[uv[1]], mesh.uv[uv[2]]);
    area += face_area;
    products += squared_longest_edge(mesh, corners);
    coverage += image_area;
    Chart_size& size = charts_by_label[chart[f]];
    size.rest_area += std::max(face_area, 0.5e-7 * squared_longest_edge(mesh, corners));
    size.image_area += image_area;
    size.vertices.insert(uv.begin(), uv.end());
  }
  // The round-off error of an area is relative to the products of the edges. If the faces are flat,
  // it exceeds that of the sum. The area of the surface is null if it overflows, and is rounded to
  // a multiple of the smallest number for each face if it underflows.
  if(!results.json("info").value("area", nlohmann::json()).is_null())
  {
    const double input_area = results.number("info", "area");
    const double underflow =
        double(mesh.corners.size()) * std::numeric_limits<double>::denorm_min();
    results.expect(std::abs(unit * (unit * area) - input_area) <=
                       round_off * input_area + unit * (unit * 1e-15 * products) + underflow,
                   "atlas", "the faces have the area %, but the surface has the area %",
                   {unit * (unit * area), input_area});
  }
  const double reported = results.number("atlas", "coverage");
  results.expect(std::abs(coverage - reported) <= round_off, "atlas",
                 "the faces cover % of the texture, but the JSON has the coverage %",
                 {coverage, reported});
  // All charts have the scale of the JSON.
  const double scale = unit * results.number("atlas", "texels_per_length") / texture_size;
  double worst = 1.;
  for(const auto& [label, chart] : charts_by_label)
    if(chart.rest_area > round_off * area)
    {
      const double factor = chart.image_area / (scale * scale * chart.rest_area);
      const double limit = chart.vertices.size() > 100 ? 4.25 : 50.;
      worst = std::max({worst, factor / limit, 1. / (factor * limit)});
    }
  results.expect(worst <= 1.001, "atlas", "the area of a chart exceeds its limits by the factor %",
                 {worst});
  return triangles;
}

// The texture coordinates are in the unit square. All faces are counterclockwise, and their
// interiors are disjoint, as the JSON certifies.
void check_atlas(Results& results)
{
  if(!results.has("atlas") || !results.has("info"))
    return;
  const std::optional<Textured_mesh> mesh = read_textured_mesh(results.path("atlas.obj"));
  if(!mesh)
  {
    results.add_violation("atlas", "the OBJ file has no triangles with texture coordinates");
    return;
  }
  for(const Kernel::Point_2& p : mesh->uv)
    if(!(p.x() >= 0. && p.x() <= 1. && p.y() >= 0. && p.y() <= 1.))
    {
      results.expect(false, "atlas", "the texture coordinates % % are not in the unit square",
                     {p.x(), p.y()});
      return;
    }
  const std::vector<Triangle_2> triangles = check_areas(results, *mesh);
  const double flips = double(std::count_if(triangles.begin(), triangles.end(), is_not_ccw));
  results.expect(flips == results.number("atlas", "flips"), "atlas",
                 "% faces are not counterclockwise, and the JSON has another number", {flips});
  results.expect(flips == 0., "atlas", "% faces are not counterclockwise", {flips});
  const double overlaps = results.number("atlas", "overlaps");
  results.expect(overlaps == 0., "atlas", "% charts overlap themselves", {overlaps});
  if(flips == 0.)
    if(const auto pair = find_overlap(triangles))
      results.expect(false, "atlas", "the faces % and % overlap in the texture",
                     {double(pair->first), double(pair->second)});
}

// The cost of moving a point mass is the exact distance, within certified bounds.
void check_emd(Results& results, const Input& input)
{
  if(!results.has("emd"))
    return;
  const double lower = results.number("emd", "lower"), value = results.number("emd", "value"),
               upper = results.number("emd", "upper"),
               upper_continuous = results.number("emd", "upper_continuous");
  results.expect(lower <= value && value <= upper, "emd", "the value % is not between % and %",
                 {value, lower, upper});
  results.expect(results.json("emd").value("converged", false), "emd",
                 "the method does not converge: the bounds are % and %", {lower, upper});
  // The default of --tolerance
  results.expect(upper - lower <= 0.001 * upper, "emd",
                 "the gap between % and % exceeds the tolerance", {lower, upper});
  if(input.exact.empty() || results.target() >= input.exact.size())
    return;
  const double exact = input.exact[results.target()];
  results.expect(lower <= exact * (1. + round_off), "emd",
                 "the lower bound % exceeds the exact distance %", {lower, exact});
  results.expect(upper_continuous >= exact * (1. - round_off), "emd",
                 "the upper bound on the surface % is below the exact distance %",
                 {upper_continuous, exact});
}

} // namespace

std::vector<std::string> check_results(const std::filesystem::path& folder)
{
  Results results(folder);
  Input input = check_info(results);
  input.exact = check_distances(results, "exact", input);
  check_exact(results, input);
  check_front(results, input);
  check_path(results, input);
  check_sample(results, input);
  check_voronoi(results, input);
  check_segment(results);
  check_remeshing(results, "remesh", input);
  check_remeshing(results, "semiregular", input);
  check_flatten(results, input);
  check_atlas(results);
  check_emd(results, input);
  return results.violations();
}

} // namespace mass_test
