// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes the shortest path on the surface of a cube between opposite corners.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), mesh);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);

  Vertex from, to;
  for(Vertex v : mesh.vertices())
  {
    if(mesh.point(v) == Point(0, 0, 0))
      from = v;
    if(mesh.point(v) == Point(1, 1, 1))
      to = v;
  }

  const GP::Surface_path<Mesh> path = GP::geodesic_path(mesh, from, to);
  for(const Point& p : path.points)
    std::cout << p << '\n';
  std::cout << "length " << path.length << '\n';

  // Two adjacent faces unfold to a rectangle of size 1 by 2. Its diagonal is the shortest path.
  return std::abs(path.length - std::sqrt(5.)) < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
