// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameterizes a mesh over a coarse base mesh, computes a semi-regular mesh of the same surface,
// and splits the mesh along the base edges.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

int main()
{
  // Creates a height field of size 40 by 30 with a hill.
  Mesh mesh;
  CGAL::make_grid(
      40, 30, mesh,
      [](int i, int j)
      { return Point(i, j, 200. / (20. + (i - 20.) * (i - 20.) + (j - 15.) * (j - 15.))); },
      true);

  const auto locations =
      mesh.add_property_map<Mesh::Vertex_index, GP::Base_location>("v:place").first;
  const auto base = GP::parameterize_over_base(mesh, 20, locations);
  const Mesh::Vertex_index v(500);
  std::cout << "vertex 500 is in base face " << locations[v].face << " of "
            << base.number_of_base_faces() << ", " << base.number_of_flips()
            << " triangles are inverted\n";

  Mesh semi_regular;
  const auto result = GP::semi_regular_remeshing(mesh, 20, 3, semi_regular);
  std::cout << "each of " << result.number_of_base_faces
            << " faces is cut into 64: " << semi_regular.number_of_faces() << '\n';

  // Each base face is a set of faces of the split mesh, which has the shape of the input.
  Mesh base_mesh, split;
  const auto base_face =
      split.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:base_face").first;
  GP::geodesic_base_mesh(mesh, 20, base_mesh, split, base_face);
  std::vector<double> base_area(base_mesh.number_of_faces(), 0.);
  for(Mesh::Face_index f : split.faces())
    base_area[base_face[f]] += PMP::face_area(f, split);
  double area = 0.;
  bool is_covered = true;
  for(const double a : base_area)
  {
    area += a;
    is_covered = is_covered && a > 0.;
  }
  std::cout << "the split mesh has " << split.number_of_faces() << " faces instead of "
            << mesh.number_of_faces() << ", which cover the " << base_mesh.number_of_faces()
            << " base faces\n";

  // The base location of a vertex maps back to the vertex.
  const bool is_correct = base.number_of_flips() == 0 &&
                          CGAL::squared_distance(base.point(locations[v]), mesh.point(v)) < 1e-12 &&
                          semi_regular.number_of_faces() == 64 * result.number_of_base_faces &&
                          is_covered && std::abs(area - PMP::area(mesh)) < 1e-9 * area;
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
