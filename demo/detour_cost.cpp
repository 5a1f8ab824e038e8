// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts the vertices that violate the triangle inequality, for spectral distances and for heat
// distances with three time steps.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Distances = std::vector<double>;

namespace GP = CGAL::Geodesic_processing;

// Computes the relative detour (d(p, v) + d(v, q)) / d(p, q) - 1 of each vertex v, with d(p, q)
// averaged over both directions. Negative values violate the triangle inequality.
Distances compute_detours(const std::string& name, const Distances& p, const Distances& q,
                          std::size_t p_index, std::size_t q_index)
{
  const double forward = p[q_index], backward = q[p_index], distance = 0.5 * (forward + backward);
  Distances result;
  std::size_t number_of_violations = 0;
  for(std::size_t v = 0; v < p.size(); ++v)
  {
    result.push_back((p[v] + q[v]) / distance - 1.);
    number_of_violations += result.back() < -1e-6; // beyond round-off errors
  }
  std::cout << name << " violate the triangle inequality at " << number_of_violations << " of "
            << p.size() << " vertices, by at most "
            << 100. * (std::max)(0., -*std::min_element(result.begin(), result.end()))
            << " %; the distance from p to q is " << forward << ", from q to p " << backward
            << ".\n";
  return result;
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 5 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
    return std::cerr << "usage: detour_cost MESH VERTEX VERTEX RESULT.ply\n", EXIT_FAILURE;
  const Vertex p(Mesh::size_type(std::stoul(argv[2]))), q(Mesh::size_type(std::stoul(argv[3])));
  auto map = mesh.add_property_map<Vertex, double>("v:detour", 0.).first;
  const auto domain = GP::make_domain(mesh);
  const auto compute_distances = [&](Vertex from, const auto& write)
  {
    write(from);
    Distances result;
    for(Vertex v : mesh.vertices())
      result.push_back(map[v]);
    return result;
  };
  const GP::Transport_metric<Mesh> metric(domain);
  const auto spectral = [&](Vertex from) { metric.write_distances<CGAL::Parallel_tag>(from, map); };
  std::vector<Distances> detours = {compute_detours(
      "Spectral distances", compute_distances(p, spectral), compute_distances(q, spectral), p, q)};
  for(const int time_step : {1, 10, 100})
  {
    GP::Geodesic_distance_solver<Mesh, GP::Heat> solver(
        domain, GP::parameters::heat_time_step(double(time_step)));
    const auto heat = [&](Vertex from)
    {
      solver.compute(from);
      solver.write_distances(map);
    };
    detours.push_back(compute_detours(
        "Heat distances with a time step of " + std::to_string(time_step) + " squared edge lengths",
        compute_distances(p, heat), compute_distances(q, heat), p, q));
  }

  // Writes all results in a row, from spectral distances to the largest time step. Those of the
  // heat method are rotated by 180 degrees. If the triangle inequality is violated, the value is
  // set to the minimum of the color range.
  Mesh output;
  output.add_property_map<Vertex, double>("v:detour", 0.);
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double step = 1.1 * (box.xmax() - box.xmin()), sum = box.xmin() + box.xmax();
  const Mesh original = mesh;
  for(std::size_t i = 0; i < detours.size(); ++i)
  {
    for(Vertex v : mesh.vertices())
    {
      map[v] = detours[i][v] < -1e-6 ? -0.4 : (std::min)(0.4, detours[i][v]);
      const auto& x = original.point(v);
      mesh.point(v) = i == 0 ? x : Kernel::Point_3(sum - x.x() + double(i) * step, x.y(), -x.z());
    }
    output += mesh;
  }
  return CGAL::IO::write_polygon_mesh(argv[4], output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
