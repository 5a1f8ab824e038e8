// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes travel times on a square whose right half is twice as fast. The speeds of the faces are
// in a vector.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Creates a grid from (0, 0) to (20, 20).
  Mesh mesh;
  CGAL::make_grid(
      20, 20, mesh, [](int i, int j) { return Point(i, j, 0); }, true);

  // Face indices are consecutive, so they are positions in the vector.
  std::vector<double> speed(num_faces(mesh));
  for(Mesh::Face_index f : mesh.faces())
  {
    double mean_x = 0.;
    for(Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(f), mesh))
      mean_x += mesh.point(v).x() / 3.;
    speed[f] = mean_x > 10. ? 2. : 1.;
  }

  // The front starts at all vertices of the left side.
  std::vector<Mesh::Vertex_index> left_side;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(mesh.point(v).x() == 0.)
      left_side.push_back(v);

  auto time = mesh.add_property_map<Mesh::Vertex_index, double>("v:time").first;
  GP::geodesic_distances(mesh, left_side, time,
                         GP::parameters::face_speed_map(CGAL::make_property_map(speed)));

  double max_time = 0.;
  for(Mesh::Vertex_index v : mesh.vertices())
    max_time = (std::max)(max_time, time[v]);
  std::cout << "The front crosses the square in time " << max_time << '\n';

  // The left half takes 10 / 1, and the right half 10 / 2.
  return std::abs(max_time - 15.) < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
