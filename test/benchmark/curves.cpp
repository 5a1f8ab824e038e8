// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the time of diameters, loops, Bezier curves and splines, and of paths with speeds.
#include <CGAL/Geodesic_processing.h>

#include "models.h"
#include "report.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace GP = CGAL::Geodesic_processing;
using namespace benchmarks;

std::vector<std::pair<std::string, Mesh>> load_models(const std::vector<std::string>& names)
{
  std::vector<std::pair<std::string, Mesh>> result;
  for(const std::string& name : names)
    if(auto mesh = load_model(name))
      result.emplace_back(name, std::move(*mesh));
  return result;
}

void print_diameters(bool is_quick)
{
  std::printf("Iterations and times until the bounds differ by the tolerance, at most 100 "
              "iterations, without make_domain()\n");
  Table table("diameter and radius",
              {"mesh", "vertices", "diameter to 1 %: iterations", "diameter to 1 % [s]",
               "diameter to 0.1 %: iterations", "diameter to 0.1 % [s]",
               "radius to 1 %: iterations", "radius to 1 % [s]", "radius: gap %"});
  auto meshes = load_models(
      is_quick ? std::vector<std::string>{"pinion_650"}
               : std::vector<std::string>{"bunny_37k", "nefertiti_35k", "armadillo_26k", "man_17k",
                                          "fandisk_16k", "kitten_9k", "pinion_650"});
  if(!is_quick)
  {
    meshes.emplace_back("sphere", icosphere(6));
    meshes.emplace_back("torus", mesh_of(CGAL::Geodesic_processing::test::torus(200, 200)));
  }
  for(const auto& [name, mesh] : meshes)
  {
    const auto domain = GP::make_domain(mesh);
    std::vector<std::string> row = {name, std::to_string(num_vertices(mesh))};
    for(const double tolerance : {0.01, 0.001})
    {
      std::size_t iterations = 0;
      const double seconds = cpu_seconds(
          [&]
          {
            iterations =
                GP::geodesic_diameter(domain, GP::parameters::relative_tolerance(tolerance))
                    .number_of_iterations;
          });
      row.insert(row.end(), {std::to_string(iterations), format_significant(seconds)});
    }
    GP::Geodesic_radius<Mesh> radius;
    const double seconds = cpu_seconds([&] { radius = GP::geodesic_radius(domain); });
    row.insert(row.end(), {std::to_string(radius.number_of_iterations), format_significant(seconds),
                           format_fixed(100. * (radius.upper / radius.lower - 1.), 1)});
    table.add(row);
  }
  table.print();
}

void print_loops(bool is_quick)
{
  std::printf("Shortest noncontractible loops through five vertices, a basis of loops, and exact "
              "distances of all vertices\n");
  Table table("loops",
              {"mesh", "vertices", "loops of the basis", "basis [s]", "shortest loop, minimum [s]",
               "shortest loop, maximum [s]", "exact distances [s]"});
  for(const auto& [name, mesh] : load_models(
          is_quick ? std::vector<std::string>{"rotor_2k4"}
                   : std::vector<std::string>{"rotor_2k4", "turbine_9k", "bunny_zipper_36k"}))
  {
    const auto domain = GP::make_domain(mesh);
    std::vector<GP::Geodesic_loop<Mesh>> basis;
    const double basis_time =
        cpu_seconds([&] { GP::loop_basis(domain, std::back_inserter(basis)); });
    std::vector<double> times;
    const std::size_t n = num_vertices(mesh);
    for(std::size_t i = 0; i < 5; ++i)
      times.push_back(cpu_seconds(
          [&, i = i]
          { GP::shortest_noncontractible_loop(domain, Vertex(Mesh::size_type(i * n / 5))); }));
    const double exact_time = cpu_seconds(
        [&]
        {
          GP::Geodesic_distance_solver<Mesh, GP::Exact> solver(domain);
          solver.compute(Vertex(0));
        });
    table.add({name, std::to_string(n), std::to_string(basis.size()),
               format_significant(basis_time),
               format_significant(*std::min_element(times.begin(), times.end())),
               format_significant(*std::max_element(times.begin(), times.end())),
               format_significant(exact_time)});
  }
  table.print();
}

void print_splines(bool is_quick)
{
  Table table("curves", {"mesh", "vertices", "curve", "segments", "time [s]"});
  for(const auto& [name, mesh] : load_models({is_quick ? "pinion_650" : "bunny_37k"}))
  {
    const auto domain = GP::make_domain(mesh);
    const std::size_t n = num_vertices(mesh);
    std::vector<Vertex> control_points;
    for(std::size_t i = 0; i < 4; ++i)
      control_points.push_back(Vertex(Mesh::size_type(i * (n - 1) / 3)));
    const auto add =
        [&, &name = name](const char* curve, std::size_t subdivisions, const auto& compute)
    {
      std::vector<double> times;
      for(int i = 0; i < 3; ++i)
        times.push_back(cpu_seconds([&] { compute(subdivisions); }));
      table.add({name, std::to_string(n), curve, std::to_string(std::size_t(1) << subdivisions),
                 format_significant(median(times))});
    };
    const auto bezier = [&](std::size_t subdivisions)
    {
      GP::geodesic_bezier_curve(domain, control_points,
                                GP::parameters::number_of_subdivisions(subdivisions));
    };
    const auto spline = [&](std::size_t subdivisions)
    {
      GP::geodesic_spline(
          domain, control_points,
          GP::parameters::number_of_subdivisions(subdivisions).degree(3).is_closed(true));
    };
    add("cubic Bezier curve", 6, bezier);
    add("cubic Bezier curve", 8, bezier);
    add("closed cubic spline", 4, spline);
  }
  table.print();
}

void print_paths_with_speeds(bool is_quick)
{
  std::printf("Paths from 50 vertices to vertex 0, after the travel times of curvature speeds\n");
  Table table("paths with speeds", {"mesh", "vertices", "faces", "travel times [ms]",
                                    "path, median [ms]", "path, maximum [ms]"});
  for(const auto& [name, loaded] :
      load_models(is_quick ? std::vector<std::string>{"pinion_650"}
                           : std::vector<std::string>{"bunny_37k", "nefertiti_35k", "armadillo_26k",
                                                      "kitten_9k", "camel_10k", "fandisk_6k5"}))
  {
    Mesh mesh = loaded;
    const auto speed = mesh.add_property_map<Vertex, double>("v:speed", 1.).first;
    GP::curvature_speeds<GP::Edge_attractive>(mesh, speed);
    GP::Geodesic_distance_solver<Mesh, GP::Fast_marching> solver(GP::make_domain(mesh));
    const double query = cpu_seconds(
        [&, speed = speed] { solver.compute(Vertex(0), GP::parameters::speed_map(speed)); });
    const std::size_t n = num_vertices(mesh);
    std::vector<double> times;
    for(std::size_t i = 1; i <= 50; ++i)
      times.push_back(
          cpu_seconds([&, i = i] { solver.path(Vertex(Mesh::size_type(i * (n - 1) / 50))); }));
    table.add({name, std::to_string(n), std::to_string(num_faces(mesh)),
               format_significant(1000. * query), format_significant(1000. * median(times)),
               format_significant(1000. * *std::max_element(times.begin(), times.end()))});
  }
  table.print();
}

} // namespace

// curves [--quick]
int main(int argc, char* argv[])
{
  const bool is_quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  print_diameters(is_quick);
  print_loops(is_quick);
  print_splines(is_quick);
  print_paths_with_speeds(is_quick);
}
