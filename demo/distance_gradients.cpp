// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes the gradients of a geodesic distance with respect to the vertices of a mesh.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 5 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
    return std::cerr << "usage: distance_gradients MESH VERTEX VERTEX RESULT.ply\n", EXIT_FAILURE;
  const Vertex p(Mesh::size_type(std::stoul(argv[2]))), q(Mesh::size_type(std::stoul(argv[3])));
  const auto domain = GP::make_domain(mesh);
  const auto derivatives = GP::geodesic_distance_derivatives(domain, p, q);
  const auto path = GP::geodesic_path(domain, p, q);

  // The color of a vertex is the length of its gradient.
  auto norms = mesh.add_property_map<Vertex, double>("v:gradient", 0.).first;
  double squared_norm = 0.;
  for(const auto& [v, gradient] : derivatives.vertex_gradients)
  {
    norms[v] = std::sqrt(gradient.squared_length());
    squared_norm += gradient.squared_length();
  }
  std::cout << "The distance is " << derivatives.distance << ". Its gradient has the norm "
            << std::sqrt(squared_norm) << " and is not zero at "
            << derivatives.vertex_gradients.size() << " of " << num_vertices(mesh)
            << " vertices.\n";

  // Each pair of consecutive new vertices is a segment. Gradients at the ends are unit vectors,
  // others are smaller.
  const std::size_t first = mesh.number_of_vertices();
  for(std::size_t i = 0; i + 1 < path.points.size(); ++i)
  {
    mesh.add_vertex(path.points[i]);
    mesh.add_vertex(path.points[i + 1]);
  }
  for(const auto& [v, gradient] : derivatives.vertex_gradients)
  {
    const Kernel::Point_3 point = mesh.point(v);
    mesh.add_vertex(point);
    mesh.add_vertex(point + 0.3 * derivatives.distance * gradient);
  }
  std::ostringstream ply;
  CGAL::IO::write_PLY(ply, mesh);
  std::string text = ply.str();
  const std::size_t edges = (mesh.number_of_vertices() - first) / 2;
  text.insert(text.find("end_header"), "element edge " + std::to_string(edges) +
                                           "\nproperty int vertex1\nproperty int vertex2\n");
  for(std::size_t i = 0; i < 2 * edges; ++i)
    text += std::to_string(first + i) + (i % 2 == 0 ? ' ' : '\n');
  return std::ofstream(argv[4]) << text ? EXIT_SUCCESS : EXIT_FAILURE;
}
