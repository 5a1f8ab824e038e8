// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes distances on a soup of single faces, half of them reversed and some of them repeated.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

// The triangles of a mesh, each with its own three points, as a file in the format STL has them.
struct Soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<Vertex> vertex; // of the mesh, for each point
};

Soup damaged(const Mesh& mesh)
{
  Soup soup;
  std::mt19937 random(1);
  for(const auto face : mesh.faces())
  {
    std::array<std::size_t, 3> triangle;
    std::size_t corner = 0;
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
    {
      triangle[corner++] = soup.points.size();
      soup.points.push_back(mesh.point(v));
      soup.vertex.push_back(v);
    }
    if(random() % 2 == 0)
      std::swap(triangle[0], triangle[1]);
    soup.triangles.push_back(triangle);
    if(random() % 100 == 0)
      soup.triangles.push_back({triangle[1], triangle[2], triangle[0]});
  }
  return soup;
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
    return std::cerr << "usage: damaged_soup MESH RESULT.ply\n", EXIT_FAILURE;
  const Soup soup = damaged(mesh);
  const auto domain =
      GP::make_domain(soup.points, soup.triangles, GP::parameters::merge_tolerance(0.));
  const GP::Soup_report& report = domain.report();
  std::cout << report.number_of_merged_points << " of " << soup.points.size()
            << " points are merged, " << report.number_of_reversed_triangles << " of "
            << soup.triangles.size() << " triangles are reversed, "
            << report.number_of_duplicate_triangles << " are duplicates\n";

  // The same distances as on the undamaged mesh, at each of the points.
  std::vector<double> distance(soup.points.size());
  GP::geodesic_distances(domain, Vertex(0), CGAL::make_property_map(distance));
  auto expected = mesh.add_property_map<Vertex, double>("v:distance", 0.).first;
  GP::geodesic_distances(mesh, soup.vertex[0], expected);
  double difference = 0., farthest = 0.;
  for(std::size_t i = 0; i < distance.size(); ++i)
  {
    difference = std::max(difference, std::abs(distance[i] - expected[soup.vertex[i]]));
    farthest = std::max(farthest, distance[i]);
  }
  std::cout << "largest difference to the distances on the undamaged mesh: "
            << difference / farthest << " of the largest distance\n";

  Mesh repaired = domain.mesh();
  auto result = repaired.add_property_map<Vertex, double>("v:distance", 0.).first;
  for(std::size_t i = 0; i < distance.size(); ++i)
    result[Vertex(Mesh::size_type(i))] = distance[i];
  return difference <= 1e-9 * farthest && CGAL::IO::write_polygon_mesh(argv[2], repaired)
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
