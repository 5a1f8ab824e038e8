// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the areas of the geodesic Voronoi cells of 20 vertices.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || mesh.number_of_vertices() < 20)
  {
    std::cerr << "usage: voronoi_areas MESH RESULT.ply\n";
    return EXIT_FAILURE;
  }

  std::vector<GP::Source<Mesh>> cities;
  const std::size_t step = mesh.number_of_vertices() / 20;
  for(std::size_t city = 0; city < 20; ++city)
    cities.emplace_back(Vertex(city * step), 0., city);

  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  auto nearest = mesh.add_property_map<Vertex, unsigned>("v:label", 20).first;
  GP::geodesic_distances(mesh, cities, distance, GP::parameters::source_label_map(nearest));

  // Assigns a third of each triangle's area to each of its vertices. The last entry is the area
  // that no source reaches.
  std::vector<double> areas(21, 0.);
  for(Mesh::Face_index f : mesh.faces())
    for(Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
      areas[std::isfinite(distance[v]) ? nearest[v] : 20] +=
          CGAL::Polygon_mesh_processing::face_area(f, mesh) / 3.;

  const auto [smallest, largest] = std::minmax_element(areas.begin(), areas.begin() + 20);
  std::cout << "The area of the largest of 20 Voronoi cells is " << *largest / *smallest
            << " times that of the smallest.\n";
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
