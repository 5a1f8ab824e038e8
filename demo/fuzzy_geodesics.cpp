// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes fuzzy geodesics between two vertices, from the length of detours and from a flow.
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

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 5 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
    return std::cerr << "usage: fuzzy_geodesics MESH VERTEX VERTEX RESULT.ply\n", EXIT_FAILURE;
  const Vertex p(Mesh::size_type(std::stoul(argv[2]))), q(Mesh::size_type(std::stoul(argv[3])));
  auto likelihood = mesh.add_property_map<Vertex, double>("v:likelihood", 0.).first;
  const auto domain = GP::make_domain(mesh);
  const double distance = GP::Geodesic_path_finder<Mesh>(domain)(p, q).length;
  const auto width = GP::parameters::width(0.1 * distance);

  // Writes one copy of the mesh per method, next to each other.
  Mesh output;
  output.add_property_map<Vertex, double>("v:likelihood", 0.);
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const Kernel::Vector_3 step(1.1 * (box.xmax() - box.xmin()), 0., 0.);
  const auto append_copy = [&](const char* name)
  {
    std::size_t number_of_likely_vertices = 0;
    for(Vertex v : mesh.vertices())
      number_of_likely_vertices += likelihood[v] > 0.5;
    std::cout << name << ": " << number_of_likely_vertices << " of " << num_vertices(mesh)
              << " vertices have a likelihood above 0.5\n";
    output += mesh;
    for(Vertex v : mesh.vertices())
      mesh.point(v) = mesh.point(v) + step;
  };
  GP::fuzzy_geodesic_by_distances(domain, p, q, likelihood, width);
  append_copy("From the length of detours");
  GP::fuzzy_geodesic(domain, p, q, likelihood, width);
  append_copy("From an optimal flow");
  return CGAL::IO::write_polygon_mesh(argv[4], output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
