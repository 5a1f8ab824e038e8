// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fills a hole in a plate, and keeps the outer boundary of the plate open.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Removes a vertex in the center of a plate with its six faces.
  Mesh mesh;
  CGAL::make_grid(
      20, 20, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);
  const auto hole = CGAL::Euler::remove_center_vertex(mesh.halfedge(Vertex(10 * 21 + 10)), mesh);
  CGAL::Euler::make_hole(hole, mesh);

  std::vector<Face> faces;
  const GP::Hole_filling_result result =
      GP::fill_holes(mesh, GP::parameters::maximum_number_of_edges(20)
                               .hole_filling_method(GP::Hole_filling_method::unfolding)
                               .face_output(std::back_inserter(faces)));
  std::cout << result.number_of_filled << " of " << result.number_of_holes << " holes filled with "
            << result.number_of_faces << " faces\n";

  // The faces are in the plane and cover the hole.
  const bool is_correct = result.number_of_holes == 2 && result.number_of_filled == 1 &&
                          faces.size() == 4 &&
                          std::abs(CGAL::Polygon_mesh_processing::area(faces, mesh) - 3.) < 1e-12 &&
                          std::abs(CGAL::Polygon_mesh_processing::area(mesh) - 400.) < 1e-9;
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
