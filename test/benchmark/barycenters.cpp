// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures barycenters of point masses: the cost after 250 steps, the location of the barycenter of
// two points, and the cost of barycenters in the plane. Uses one thread. --quick: meshes with some
// thousand vertices.
#include "models.h"
#include "report.h"

#include <CGAL/Geodesic_processing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

namespace GP = CGAL::Geodesic_processing;
using namespace benchmarks;

struct Model
{
  std::string name;
  Mesh mesh;
};

std::vector<Vertex> random_vertices(const Mesh& mesh, std::size_t number, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<Mesh::size_type> distribution(0, mesh.number_of_vertices() - 1);
  std::vector<Vertex> result;
  while(result.size() < number)
    if(const Vertex v(distribution(random)); !mesh.is_isolated(v))
      result.push_back(v);
  return result;
}

std::string percent(double ratio, int decimals) { return format_fixed(100. * ratio, decimals); }

// Compares the cost after 250 steps with the cost after 4,000 steps. Then measures the steps and
// seconds to a gap of one percent.
void print_250_steps(const std::vector<Model>& models)
{
  Table table("points on meshes",
              {"mesh", "vertices", "points", "set-up [s]", "250 steps [s]", "cost excess %",
               "gap %", "gap of 4,000 steps %", "steps to gap of 1 %", "time [s]"});
  for(const auto& [name, mesh] : models)
    for(const std::size_t k : {3u, 6u})
    {
      const bool is_large = mesh.number_of_vertices() > 5000;
      if(is_large && k == 6)
        continue;
      const std::vector<Vertex> points = random_vertices(mesh, k, 1);
      std::unique_ptr<GP::Transport_barycenter_solver<Mesh>> solver;
      const auto domain = GP::make_domain(mesh);
      const double setup = cpu_seconds(
          [&]
          {
            solver = std::make_unique<GP::Transport_barycenter_solver<Mesh>>(
                domain, GP::parameters::number_of_refinements(0u));
          });
      const auto steps = [&](unsigned max_iterations, double tolerance)
      {
        return solver->compute(
            points,
            GP::parameters::maximum_number_of_iterations(max_iterations).tolerance(tolerance));
      };
      GP::Transport_barycenter_cost cost_after_250, one_percent_cost;
      const double time = cpu_seconds([&] { cost_after_250 = steps(250, 1e-6); });
      const double one_percent_time = cpu_seconds([&] { one_percent_cost = steps(4000, 0.01); });
      const GP::Transport_barycenter_cost reference_cost =
          is_large ? one_percent_cost : steps(4000, 1e-6);
      const auto gap = [](const GP::Transport_barycenter_cost& cost)
      { return percent(1. - cost.lower / cost.upper, 2); };
      table.add({name, std::to_string(mesh.number_of_vertices()), std::to_string(k),
                 format_fixed(setup, 2), format_fixed(time, 2),
                 is_large ? "-" : percent(cost_after_250.upper / reference_cost.upper - 1., 3),
                 gap(cost_after_250), is_large ? "-" : gap(reference_cost),
                 std::to_string(one_percent_cost.number_of_iterations),
                 format_fixed(one_percent_time, 2)});
    }
  table.print();
}

// Compares barycenters of two points at distance d with the exact cost, half of d squared. The
// exact barycenter can be placed at the midpoint of the geodesic.
void print_two_points(const std::vector<Model>& models)
{
  Table table("two points", {"two points on", "vertices", "distance d [edges]",
                             "cost / (d^2/2) - 1 %", "half at each point %", "at midpoint vertex %",
                             "mass within 3 edges %", "mean position"});
  for(const auto& [name, mesh] : models)
  {
    if(mesh.number_of_vertices() > 5000)
      continue;
    const double edge = mean_edge_length(mesh);
    GP::Transport_barycenter_solver<Mesh> solver(mesh);
    GP::Earth_movers_solver<Mesh> distances(mesh);
    for(unsigned seed = 1; seed <= 3; ++seed)
    {
      const std::vector<Vertex> points = random_vertices(mesh, 2, 10 + seed);
      GP::Geodesic_distance_solver<Mesh, GP::Exact> solver_from(mesh), solver_to(mesh),
          geodesic_distance(mesh);
      solver_from.compute(points[0]);
      solver_to.compute(points[1]);
      const double d = solver_from.distance(points[1]), exact = 0.5 * d * d;
      geodesic_distance.compute(GP::Source<Mesh>(solver_from.path(points[1]).locations));
      const GP::Transport_barycenter_cost cost =
          solver.compute(points, GP::parameters::tolerance(2e-3));
      const auto costs = [&](const auto& masses)
      {
        double result = 0.;
        for(const Vertex point : points)
          result += std::pow(distances.compute(masses, point).value, 2);
        return percent(result / exact - 1., 2);
      };
      double mass_near_geodesic = 0., position = 0.;
      for(const Vertex v : mesh.vertices())
      {
        const double mass = solver.mass(v), a = solver_from.distance(v), b = solver_to.distance(v);
        mass_near_geodesic += geodesic_distance.distance(v) <= 3. * edge ? mass : 0.;
        position += mass > 0. ? mass * a / (a + b) : 0.;
      }
      const Vertex middle = GP::geodesic_barycenter<GP::Exact>(mesh, points).vertex;
      table.add({name, std::to_string(mesh.number_of_vertices()), format_fixed(d / edge, 0),
                 percent(cost.value / exact - 1., 2), costs(points), costs(middle),
                 percent(mass_near_geodesic, 1), format_fixed(position, 3)});
    }
  }
  table.print();
}

// In a convex planar domain, the exact cost is the sum of squared distances from the centroid.
void print_planar_points(std::size_t n)
{
  const Mesh mesh = jittered_square(n);
  GP::Transport_barycenter_solver<Mesh> solver(mesh);
  Table table("points in a square",
              {"points in a square", "vertices", "cost / cost of centroid - 1 %", "steps"});
  for(const std::size_t k : {2u, 3u, 4u, 5u, 6u})
  {
    const std::vector<Vertex> points = random_vertices(mesh, k, 100 + unsigned(k));
    double x = 0., y = 0., exact = 0.;
    for(const Vertex v : points)
    {
      x += mesh.point(v).x() / double(k);
      y += mesh.point(v).y() / double(k);
    }
    for(const Vertex v : points)
      exact += std::pow(mesh.point(v).x() - x, 2) + std::pow(mesh.point(v).y() - y, 2);
    const GP::Transport_barycenter_cost cost =
        solver.compute(points, GP::parameters::tolerance(5e-3));
    table.add({std::to_string(k), std::to_string(mesh.number_of_vertices()),
               percent(cost.value / exact - 1., 2), std::to_string(cost.number_of_iterations)});
  }
  table.print();
}

} // namespace

int main(int argc, char* argv[])
{
  const bool is_quick = argc > 1 && std::string(argv[1]) == "--quick";
  std::vector<Model> models = {{"sphere", icosphere(4)}};
  std::vector<std::string> names = {"rotor_2k4", "cow_2k9", "elephant_2k8", "triceratops_2k8"};
  if(!is_quick)
    names.insert(names.end(), {"kitten_9k", "bunny_37k"});
  for(const std::string& name : names)
    if(const auto mesh = load_model(name))
      models.push_back({name, *mesh});
  print_250_steps(models);
  print_two_points(models);
  print_planar_points(50);
}
