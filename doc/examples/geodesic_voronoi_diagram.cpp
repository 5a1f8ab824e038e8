// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes geodesic Voronoi cells, their bisector, and the mesh cut along the bisector.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
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

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Creates a planar grid of size 30 by 20, with seeds at (0, 10) and (30, 10).
  Mesh mesh;
  CGAL::make_grid(
      30, 20, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);
  const std::vector<Vertex> seeds = {Vertex(10 * 31), Vertex(10 * 31 + 30)};

  auto cell = mesh.add_property_map<Vertex, std::size_t>("v:cell").first;
  std::vector<GP::Voronoi_bisector<Mesh>> bisectors;
  GP::geodesic_voronoi_diagram(mesh, seeds, cell,
                               GP::parameters::bisector_output(std::back_inserter(bisectors)));

  // There is one bisector, x = 15, which joins two boundary points.
  bool is_correct = bisectors.size() == 1;
  for(const Point& p : bisectors[0].points)
    is_correct = is_correct && std::abs(p.x() - 15.) < 1e-9;
  std::cout << "from " << bisectors[0].points.front() << " to " << bisectors[0].points.back()
            << '\n';
  for(Vertex v : mesh.vertices())
    is_correct =
        is_correct && (mesh.point(v).x() == 15. || cell[v] == (mesh.point(v).x() < 15. ? 0u : 1u));

  // Cuts the mesh along the bisector into two cells of equal area.
  Mesh cut;
  auto cell_of_face = cut.add_property_map<Mesh::Face_index, std::size_t>("f:cell").first;
  GP::geodesic_voronoi_cells(mesh, seeds, cut, cell_of_face);
  double areas[] = {0., 0.};
  for(Mesh::Face_index f : cut.faces())
    areas[cell_of_face[f]] += CGAL::Polygon_mesh_processing::face_area(f, cut);
  std::cout << "areas " << areas[0] << " and " << areas[1] << '\n';
  is_correct = is_correct && std::abs(areas[0] - 300.) < 1e-9 && std::abs(areas[1] - 300.) < 1e-9;
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
