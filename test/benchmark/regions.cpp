// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the errors and times of transport to regions: exits of mazes, exits with limited
// capacity, features, and refracted rays. Times include all set-up. Uses one thread. --quick: small
// meshes.
#include "models.h"
#include "report.h"

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>
#include <CGAL/Geodesic_processing/Region_transport_solver.h>
#include <CGAL/Geodesic_processing/feature_distance.h>
#include <CGAL/Geodesic_processing/geodesic_distances.h>
#include <CGAL/Geodesic_processing/geodesic_path.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace {

namespace GP = CGAL::Geodesic_processing;
using namespace benchmarks;
using Distances = Mesh::Property_map<Vertex, double>;

// Returns the unit square with a wall in every fifth column of cells. Each wall has a gap of two
// cells. Diagonals alternate.
Mesh maze(int cells, std::mt19937& random)
{
  Mesh mesh;
  std::vector<Vertex> vertex((cells + 1) * (cells + 1));
  const auto at = [&](int i, int j)
  {
    Vertex& v = vertex[j * (cells + 1) + i];
    if(v == Mesh::null_vertex())
      v = mesh.add_vertex({double(i) / cells, double(j) / cells, 0.});
    return v;
  };
  int gap = 0;
  for(int i = 0; i < cells; ++i)
  {
    if(i % 5 == 0)
      gap = int(random() % unsigned(cells - 1));
    for(int j = 0; j < cells; ++j)
      if(i % 5 != 4 || j == gap || j == gap + 1)
      {
        const int turn = (i + j) % 2;
        const Vertex a = at(i + turn, j), b = at(i + 1, j + turn), c = at(i + 1 - turn, j + 1),
                     d = at(i, j + 1 - turn);
        mesh.add_face(a, b, c);
        mesh.add_face(a, c, d);
      }
  }
  return mesh;
}

template <typename Sources>
std::vector<double> exact_distances(Mesh& mesh, const Sources& sources)
{
  const Distances map = mesh.add_property_map<Vertex, double>("v:exact").first;
  GP::geodesic_distances<GP::Exact>(mesh, sources, map);
  std::vector<double> result;
  for(const Vertex v : mesh.vertices())
    result.push_back(map[v]);
  return result;
}

Vertex random_vertex(const Mesh& mesh, std::mt19937& random)
{
  return Vertex(Mesh::size_type(random() % mesh.number_of_vertices()));
}

// Adds a row with the errors of the distances to the nearest of two exits, over five mazes.
void add_nearest_exit_row(Table& table, int cells, std::mt19937& random)
{
  double error = 0., gap = 0.;
  unsigned iterations = 0;
  Mesh mesh;
  for(int trial = 0; trial < 5; ++trial)
  {
    mesh = maze(cells, random);
    const std::vector<Vertex> exits = {random_vertex(mesh, random), random_vertex(mesh, random)};
    const std::vector<double> exact = exact_distances(mesh, exits);
    GP::Region_transport_solver<Mesh> solver(mesh, exits);
    for(int i = 0; i < 10; ++i)
    {
      const Vertex from = random_vertex(mesh, random);
      const auto cost = solver.compute(from, GP::parameters::tolerance(1e-6));
      error = std::max(error, exact[from] > 0. ? std::abs(cost.value / exact[from] - 1.) : 0.);
      gap = std::max(gap, cost.upper > 0. ? 1. - cost.lower / cost.upper : 0.);
      iterations = std::max(iterations, cost.number_of_iterations);
    }
  }
  table.add({std::to_string(cells) + " cells", std::to_string(mesh.number_of_vertices()),
             format_fixed(error, 7), format_fixed(gap, 7), std::to_string(iterations)});
}

// Adds a row for the transport of the masses of all vertices to `exits` random vertices, over five
// mazes. Each exit has a capacity of 1.2 / `exits`, a fifth more than an equal fraction.
void add_capacity_row(Table& table, int cells, std::size_t exits, double tolerance,
                      std::mt19937& random)
{
  double largest_gap = 0., max_excess = 0., lost_mass = 0., time = 0.;
  unsigned max_iterations = 0;
  constexpr int trials = 5;
  Mesh mesh;
  for(int trial = 0; trial < trials; ++trial)
  {
    mesh = maze(cells, random);
    std::vector<Vertex> exit_vertices;
    while(exit_vertices.size() < exits)
      if(const Vertex v = random_vertex(mesh, random);
         std::find(exit_vertices.begin(), exit_vertices.end(), v) == exit_vertices.end())
        exit_vertices.push_back(v);
    const std::vector<double> capacity(exits, 1.2 / double(exits));
    GP::Earth_movers_cost cost;
    double sum = 0.;
    time += cpu_seconds(
        [&]
        {
          GP::Region_transport_solver<Mesh> solver(mesh, exit_vertices,
                                                   GP::parameters::capacities(capacity));
          const std::vector<Vertex> all(mesh.vertices().begin(), mesh.vertices().end());
          cost = solver.compute(all, GP::parameters::tolerance(tolerance));
          for(const Vertex v : exit_vertices)
          {
            max_excess = std::max(max_excess, solver.arrival(v) / capacity[0] - 1.);
            sum += solver.arrival(v);
          }
        });
    max_iterations = std::max(max_iterations, cost.number_of_iterations);
    largest_gap = std::max(largest_gap, 1. - cost.lower / cost.upper);
    lost_mass = std::max(lost_mass, std::abs(sum - 1.));
  }
  table.add({std::to_string(cells) + " cells", std::to_string(mesh.number_of_vertices()),
             std::to_string(exits), format_fixed(tolerance, 3), std::to_string(max_iterations),
             format_fixed(largest_gap, 5), format_fixed(std::max(max_excess, 0.), 9),
             format_fixed(lost_mass, 9), format_fixed(time / trials, 2)});
}

void print_mazes(bool is_quick)
{
  Table nearest_table("nearest exits",
                      {"maze", "vertices", "maximum error", "maximum gap", "maximum iterations"});
  Table capacity_table("exits with capacities",
                       {"maze", "vertices", "exits", "tolerance", "maximum iterations",
                        "maximum gap", "capacity excess", "lost mass", "mean time [s]"});
  for(const int cells : is_quick ? std::vector<int>{20} : std::vector<int>{20, 40, 80})
  {
    std::mt19937 random(1);
    add_nearest_exit_row(nearest_table, cells, random);
    for(const std::size_t exits : {3, 10})
      for(const double tolerance : {1e-2, 1e-3})
        add_capacity_row(capacity_table, cells, exits, tolerance, random);
  }
  std::printf(
      "Distance to the nearest of two exits with tolerance 1e-6: relative error over five mazes\n");
  nearest_table.print();
  std::printf(
      "Target: 1e-5.\n\nTransport of a uniform mass to exits with limited capacities: maxima over "
      "five mazes\n");
  capacity_table.print();
  std::printf("Targets: a gap of 1 %% in 150 iterations, capacity excess at most 1e-6.\n\n");
}

// Returns the vertices of a feature and the edges between them as sources. With the edges, a chain
// of vertices represents a curve.
std::vector<GP::Source<Mesh>> feature_sources(const Mesh& mesh, const std::vector<Vertex>& feature)
{
  using Source = GP::Source<Mesh>;
  std::vector<Source> sources(feature.begin(), feature.end());
  for(const auto h : mesh.halfedges())
  {
    const Vertex a = mesh.source(h), b = mesh.target(h);
    if(a < b && std::find(feature.begin(), feature.end(), a) != feature.end() &&
       std::find(feature.begin(), feature.end(), b) != feature.end())
    {
      const auto inner = mesh.is_border(h) ? mesh.opposite(h) : h;
      const Face f = mesh.face(inner);
      Source::Location first{f, {0., 0., 0.}}, second = first;
      auto face_h = mesh.halfedge(f);
      for(std::size_t k = 0; k < 3; ++k, face_h = mesh.next(face_h))
      {
        first.second[k] = mesh.source(face_h) == a ? 1. : 0.;
        second.second[k] = mesh.source(face_h) == b ? 1. : 0.;
      }
      sources.emplace_back(Source::Polyline{first, second});
    }
  }
  return sources;
}

// Returns the mean error of the distances if, as in the paper, the arriving mass is distributed
// uniformly over the feature.
double uniform_mass_error(Mesh& mesh, const std::vector<Vertex>& feature,
                          const std::vector<double>& exact)
{
  const Distances found = mesh.add_property_map<Vertex, double>("v:uniform").first;
  GP::feature_distance(mesh, feature, found, GP::parameters::do_fix_masses(true));
  double error = 0.;
  for(const Vertex v : mesh.vertices())
    error += std::abs(found[v] - exact[v]) / double(exact.size());
  return error;
}

void add_feature_row(Table& table, const std::string& name, Mesh mesh,
                     const std::vector<Vertex>& feature)
{
  const std::vector<double> exact = exact_distances(mesh, feature_sources(mesh, feature));
  const double diameter = *std::max_element(exact.begin(), exact.end());
  const Distances found = mesh.add_property_map<Vertex, double>("v:found").first;
  GP::Earth_movers_cost cost;
  const double time = cpu_seconds([&] { cost = GP::feature_distance(mesh, feature, found); });
  double mean = 0., largest = 0., above = 0.;
  for(const Vertex v : mesh.vertices())
  {
    mean += std::abs(found[v] - exact[v]) / double(exact.size());
    largest = std::max(largest, std::abs(found[v] - exact[v]));
    above = std::max(above, found[v] - exact[v]);
  }
  table.add({name, std::to_string(exact.size()), format_fixed(100. * mean / diameter, 3),
             format_fixed(100. * largest / diameter, 2),
             format_fixed(100. * uniform_mass_error(mesh, feature, exact) / diameter, 2),
             format_fixed(std::max(above, 0.) / diameter, 9),
             std::to_string(cost.number_of_iterations), format_fixed(time, 2)});
}

// Returns a chain of edges between the first vertex and the vertex farthest from it, along which
// Dijkstra distances decrease.
std::vector<Vertex> longest_edge_path(Mesh mesh)
{
  const Distances map = mesh.add_property_map<Vertex, double>("v:d").first;
  GP::geodesic_distances<GP::Dijkstra>(mesh, Vertex(0), map);
  Vertex last(0);
  for(const Vertex v : mesh.vertices())
    if(std::isfinite(map[v]) && map[v] > map[last])
      last = v;
  std::vector<Vertex> path = {last};
  while(map[path.back()] > 0.)
  {
    Vertex best = path.back();
    for(const Vertex v : mesh.vertices_around_target(mesh.halfedge(path.back())))
      if(map[v] + std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(path.back()))) <=
         map[path.back()] * (1. + 1e-9))
        best = v;
    if(best == path.back())
      break;
    path.push_back(best);
  }
  return path;
}

void print_features(bool is_quick)
{
  Table table("features", {"feature", "vertices", "mean error %", "maximum %",
                           "fixed masses, mean %", "excess over exact", "iterations", "time [s]"});
  std::vector<std::string> names = {"fandisk_6k5", "camel_10k", "fsaverage5_inflated_left_10k"};
  if(!is_quick)
    names.insert(names.end(), {"bunny_37k", "nefertiti_35k", "armadillo_26k"});
  for(const std::string& name : names)
    if(const auto mesh = load_model(name))
    {
      add_feature_row(table, name + ", a point", *mesh, {Vertex(0)});
      add_feature_row(table, name + ", a curve", *mesh, longest_edge_path(*mesh));
    }
  if(!is_quick)
    add_feature_row(table, "sphere, three points", icosphere(6),
                    {Vertex(0), Vertex(5), Vertex(11)});
  std::printf("Distances to features from one optimal transport: errors relative to the maximum "
              "distance\n");
  table.print();
  std::printf("Targets: mean error of 1 %%, 2 s for 50,000 vertices.\n\n");
}

void print_refraction()
{
  Table table("refraction", {"vertices", "refinements", "rays", "mean error %", "maximum error %"});
  constexpr std::size_t cells = 80;
  const Mesh mesh = mesh_of(CGAL::Geodesic_processing::test::square(cells));
  const auto speed = boost::make_function_property_map<Face>(
      [&](Face f)
      {
        double y = 0.;
        for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
          y += mesh.point(v).y() / 3.;
        return y > 0.5 ? 1. / 3. : 1.;
      });
  for(const unsigned refinements : {0u, 1u})
  {
    GP::Earth_movers_solver<Mesh> solver(
        mesh, GP::parameters::face_speed_map(speed).number_of_refinements(refinements));
    std::mt19937 random(1);
    double mean = 0., largest = 0.;
    constexpr int rays = 20;
    for(int i = 0; i < rays;)
    {
      const Vertex from = random_vertex(mesh, random), to = random_vertex(mesh, random);
      const auto p = mesh.point(from), q = mesh.point(to);
      if(!(p.y() < 0.4 && q.y() > 0.6))
        continue;
      ++i;
      double low = 0., high = 1.; // bisects the slope of the travel time
      for(int step = 0; step < 60; ++step)
      {
        const double x = 0.5 * (low + high);
        const double slope = (x - p.x()) / std::hypot(x - p.x(), 0.5 - p.y()) +
                             3. * (x - q.x()) / std::hypot(x - q.x(), q.y() - 0.5);
        (slope < 0. ? low : high) = x;
      }
      const double exact =
          std::hypot(low - p.x(), 0.5 - p.y()) + 3. * std::hypot(low - q.x(), q.y() - 0.5);
      const auto cost = solver.compute(from, to, GP::parameters::tolerance(1e-5));
      const double error = std::abs(cost.value / exact - 1.);
      mean += error / rays;
      largest = std::max(largest, error);
    }
    table.add({std::to_string(mesh.number_of_vertices()), std::to_string(refinements),
               std::to_string(rays), format_fixed(100. * mean, 3),
               format_fixed(100. * largest, 3)});
  }
  std::printf(
      "Travel time between random points in the two halves of a square, one of them three times\n"
      "slower, compared with Snell's law\n");
  table.print();
  std::printf("Target: 0.15 %%.\n");
}

} // namespace

int main(int argc, char* argv[])
{
  const bool is_quick = argc > 1 && std::string(argv[1]) == "--quick";
  print_mazes(is_quick);
  print_features(is_quick);
  print_refraction();
}
