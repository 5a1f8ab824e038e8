// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes the cut locus of the first vertex from the initial directions of shortest paths.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
  {
    std::cerr << "usage: cut_locus MESH RESULT.ply\n";
    return EXIT_FAILURE;
  }

  GP::Geodesic_distance_solver<Mesh, GP::Exact> solver(mesh);
  solver.compute(Vertex(0));
  solver.write_distances(mesh.add_property_map<Vertex, double>("v:distance").first);
  std::vector<GP::Geodesic_departure<Mesh>> departures;
  for(Vertex v : mesh.vertices())
    departures.push_back(solver.departure(v));

  // If the cut locus does not cross an edge, the shortest paths to its ends leave the source in
  // similar directions. An edge crosses it if the directions differ by more than five times the
  // edge length over the shorter distance.
  std::vector<std::optional<Mesh::Point>> crossing(mesh.number_of_edges());
  std::size_t number_of_crossings = 0;
  for(Mesh::Edge_index e : mesh.edges())
  {
    const auto &to_a = departures[mesh.vertex(e, 0)], &to_b = departures[mesh.vertex(e, 1)];
    const Mesh::Point a = mesh.point(mesh.vertex(e, 0)), b = mesh.point(mesh.vertex(e, 1));
    const double squared_angle = (to_a.direction - to_b.direction).squared_length();
    const double shorter = (std::min)(to_a.length, to_b.length);
    const double edge_length = std::sqrt(CGAL::squared_distance(a, b));
    if(edge_length > 0. && squared_angle * shorter * shorter > 25. * edge_length * edge_length)
    {
      crossing[e] = a + 0.5 * (1. + (to_b.length - to_a.length) / edge_length) * (b - a);
      ++number_of_crossings;
    }
  }
  const std::size_t first = mesh.number_of_vertices();
  for(Mesh::Face_index f : mesh.faces())
  {
    std::vector<Mesh::Point> edge_crossings;
    for(Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      if(const auto& p = crossing[mesh.edge(h)])
        edge_crossings.push_back(*p);
    // The crossings of a face are joined at their centroid. If there is only one, it is joined to
    // the centroid of the face.
    Kernel::Vector_3 center = CGAL::NULL_VECTOR;
    if(edge_crossings.size() == 1)
      for(Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
        center += (mesh.point(v) - CGAL::ORIGIN) / 3.;
    else
      for(const Mesh::Point& crossing_point : edge_crossings)
        center += (crossing_point - CGAL::ORIGIN) / double(edge_crossings.size());
    for(const Mesh::Point& crossing_point : edge_crossings)
    {
      mesh.add_vertex(crossing_point);
      mesh.add_vertex(CGAL::ORIGIN + center);
    }
  }
  // Each pair of consecutive new vertices is a segment of the cut locus.
  std::ostringstream ply;
  CGAL::IO::write_PLY(ply, mesh);
  std::string text = ply.str();
  const std::size_t edges = (mesh.number_of_vertices() - first) / 2;
  text.insert(text.find("end_header"), "element edge " + std::to_string(edges) +
                                           "\nproperty int vertex1\nproperty int vertex2\n");
  for(std::size_t i = 0; i < 2 * edges; ++i)
    text += std::to_string(first + i) + (i % 2 == 0 ? ' ' : '\n');
  std::cout << "The cut locus crosses " << number_of_crossings << " of " << mesh.number_of_edges()
            << " edges.\n";
  return std::ofstream(argv[2]) << text ? EXIT_SUCCESS : EXIT_FAILURE;
}
