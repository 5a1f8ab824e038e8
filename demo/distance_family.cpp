// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares distances from one vertex: geodesic, transport with decreasing basis sizes, biharmonic.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

// Appends a copy of the mesh to the row and prints its mean distance relative to the geodesic one.
// Distances are divided by their maximum, so that colors are comparable.
void append_copy(Mesh& output, const Mesh& mesh, const std::string& name, double step,
                 double geodesic_sum)
{
  Mesh copy = mesh;
  auto map = copy.add_property_map<Vertex, double>("v:distance").first; // the existing map
  double largest = 0., sum = 0.;
  for(Vertex v : copy.vertices())
  {
    copy.point(v) +=
        Kernel::Vector_3(step * output.number_of_vertices() / copy.number_of_vertices(), 0., 0.);
    largest = (std::max)(largest, map[v]);
    sum += map[v];
  }
  for(Vertex v : copy.vertices())
    map[v] /= largest;
  output += copy;
  std::cout << name << ": " << sum / geodesic_sum << " times the mean geodesic distance\n";
}

int main(int argc, char* argv[])
{
  Mesh mesh, output;
  if(argc != 4 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
    return std::cerr << "usage: distance_family MESH VERTEX RESULT.ply\n", EXIT_FAILURE;
  const auto box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double step = 1.1 * (box.xmax() - box.xmin());
  const Vertex from(Mesh::size_type(std::stoul(argv[2])));
  auto map = mesh.add_property_map<Vertex, double>("v:distance", 0.).first;
  auto uniform = mesh.add_property_map<Vertex, double>("v:uniform", 1.).first;
  output.add_property_map<Vertex, double>("v:distance", 0.);
  const auto domain = GP::make_domain(mesh);

  GP::geodesic_distances<GP::Exact>(domain, from, map);
  double geodesic_sum = 0.;
  for(Vertex v : mesh.vertices())
    geodesic_sum += map[v];
  append_copy(output, mesh, "Geodesic distance", step, geodesic_sum);
  // If all mass is transported to one vertex, the potential decreases by the distance to it.
  GP::Earth_movers_solver<Mesh> solver(domain);
  solver.compute(GP::mass_density(uniform), from, GP::parameters::do_normalize(true));
  for(Vertex v : mesh.vertices())
    map[v] = solver.potential(from) - solver.potential(v);
  append_copy(output, mesh, "Transport distance", step, geodesic_sum);
  for(const std::size_t k : {100, 10, 0})
  {
    const GP::Transport_metric<Mesh> metric(domain, k);
    metric.write_distances<CGAL::Parallel_tag>(from, map);
    append_copy(output, mesh,
                "Transport distance, basis size " + std::to_string(metric.basis_size()), step,
                geodesic_sum);
  }
  GP::Biharmonic_metric<Mesh>(domain).write_distances(from, map);
  append_copy(output, mesh, "Biharmonic distance", step, geodesic_sum);
  return CGAL::IO::write_polygon_mesh(argv[3], output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
