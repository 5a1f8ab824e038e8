// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures seconds and iterations of earth mover's distances for several gaps, between two points
// and between two smooth densities. Set-up is timed separately. Compares the interior point method
// with the two methods of Solomon, Rustamov, Guibas and Butscher 2014. Uses one thread. --quick:
// meshes of ten thousand vertices. methods: only the comparison.
#include "Array_surface.h"
#include "models.h"
#include "report.h"

#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;
using namespace benchmarks;

// Returns a density of total mass one. It decays with the squared distance from `center` as exp(-(d
// / (0.1 width))^2).
Vector gaussian_density(const Array_surface& surface, const Vector& areas, Index center,
                        double width)
{
  Vector result(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
  {
    const double d = test::distance(surface.point(i), surface.point(center)) / (0.1 * width);
    result[surface.vertex(i)] = std::exp(-d * d) * areas[surface.vertex(i)];
  }
  return result / result.sum();
}

Vector point_mass(const Array_surface& surface, Index i)
{
  return Vector::Unit(surface.size(), surface.vertex(i));
}

// Returns the difference of two densities around two vertices.
Vector difference_of_densities(const Array_surface& surface, const Vector& areas, Index from,
                               Index to)
{
  double width = 0.;
  for(Index i = 0; i < surface.size(); ++i)
    width = std::max(width, test::distance(surface.point(i), surface.point(from)));
  return gaussian_density(surface, areas, to, width) -
         gaussian_density(surface, areas, from, width);
}

void measure(const std::string& name, const Triangulation& triangulation, Table& table)
{
  const Array_surface surface(triangulation);
  std::unique_ptr<Transport_solver> solver;
  const double setup =
      cpu_seconds([&] { solver = std::make_unique<Transport_solver>(operators(surface.t())); });
  const Index from = 0, to = surface.size() / 2;

  Window_propagation windows(surface.triangles());
  windows.run({surface.source(from)});
  const double exact = windows.distance(surface.vertex(to));

  const Vector points = point_mass(surface, to) - point_mass(surface, from);
  const Vector densities =
      difference_of_densities(surface, lumped_mass(solver->operators()), from, to);
  for(const Vector* masses : {&points, &densities})
    for(const double tolerance : {1e-2, 1e-3, 1e-4})
    {
      Transport_options options;
      options.tolerance = tolerance;
      Transport_result transport;
      const double time = cpu_seconds([&] { transport = solver->solve(*masses, options); });
      const bool are_points = masses == &points;
      table.add({name, std::to_string(surface.size()), format_fixed(setup, 2),
                 are_points ? "points" : "densities", format_significant(tolerance),
                 format_fixed(time, 3), std::to_string(transport.number_of_iterations),
                 format_significant(transport.residual),
                 are_points ? format_fixed(100. * (1. - transport.lower / exact), 3) : "-"});
    }
}

// Measures the methods of figures 4 and 5 of the paper, and the interior point method.
void compare_methods(const std::vector<std::string>& names)
{
  std::printf("Methods: the gap is the relative difference of the bounds after at most 100 "
              "iterations, or 5,000 of\nalternating directions. The methods stop at a gap of 1 "
              "%%. Figures 4 and 5 of the paper show the last two\n");
  Table table("methods",
              {"model", "vertices", "masses", "method", "gap %", "time [s]", "iterations"});
  for(const std::string& name : names)
  {
    const auto mesh = load_model(name);
    if(!mesh)
      continue;
    const Array_surface surface(triangulation_of(*mesh));
    const Transport_solver solver(operators(surface.t()));
    const Index from = 0, to = surface.size() / 2;
    const Vector points = point_mass(surface, to) - point_mass(surface, from);
    const Vector densities =
        difference_of_densities(surface, lumped_mass(solver.operators()), from, to);
    for(const Vector* masses : {&points, &densities})
      for(const auto& [method, method_name] :
          {std::pair(Transport_method::interior_point, "interior point"),
           std::pair(Transport_method::weiszfeld, "Weiszfeld"),
           std::pair(Transport_method::admm, "alternating directions")})
      {
        Transport_options options;
        options.method = method;
        options.tolerance = 1e-2;
        Transport_result transport;
        const double time = cpu_seconds([&] { transport = solver.solve(*masses, options); });
        table.add({name, std::to_string(surface.size()), masses == &points ? "points" : "densities",
                   method_name, format_fixed(100. * (1. - transport.lower / transport.upper), 2),
                   format_fixed(time, 2), std::to_string(transport.number_of_iterations)});
      }
  }
  table.print();
}

} // namespace

int main(int argc, char* argv[])
{
  const std::string argument = argc > 1 ? argv[1] : "";
  const std::vector<std::string> compared = {"fandisk_6k5", "fsaverage5_inflated_left_10k",
                                             "kitten_9k"};
  if(argument == "methods")
    return compare_methods(compared), 0;
  Table table("gaps", {"model", "vertices", "set-up [s]", "masses", "gap", "time [s]", "iterations",
                       "residual", "lower bound below exact %"});
  std::vector<std::string> names = compared;
  if(argument != "--quick")
  {
    names.insert(names.end(), {"boot_20k", "bunny_37k"});
    measure("icosphere 7", test::icosphere(7), table);
  }
  for(const std::string& name : names)
    if(const auto mesh = load_model(name))
      measure(name, triangulation_of(*mesh), table);
  table.print();
  std::printf(
      "Targets between points: 6,000 vertices to a gap of 1e-3 in 0.2 s; bunny_37k to 1e-2, "
      "1e-3 and 1e-4 in\n1.0, 1.5 and 2.0 s; icosphere 7 to 1e-3 in 7 s; models to 1e-3 in "
      "25 iterations.\n\n");
  compare_methods(argument == "--quick" ? std::vector<std::string>{"fandisk_6k5"} : compared);
}
