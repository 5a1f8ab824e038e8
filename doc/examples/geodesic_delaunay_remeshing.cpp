// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Remeshes a sheet with fewer and with more vertices than the input has.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

int main()
{
  // Creates a planar grid of size 40 by 30.
  Mesh mesh;
  CGAL::make_grid(
      40, 30, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);

  bool is_correct = true;
  for(const std::size_t number : {10, 100, 2000})
  {
    Mesh output;
    const auto locations =
        output.add_property_map<Mesh::Vertex_index, GP::Location<Mesh>>("v:location").first;
    const auto result = GP::geodesic_delaunay_remeshing(
        mesh, number, output,
        GP::parameters::number_of_relaxation_steps(3).location_map(locations));
    const Mesh::Vertex_index last(Mesh::size_type(output.number_of_vertices() - 1));
    std::cout << output.number_of_vertices() << " vertices, " << output.number_of_faces()
              << " faces, " << result.number_of_added_vertices
              << " more than asked for; the last one lies in face " << locations[last].first
              << '\n';

    // The area is preserved, because corners and boundary edges are kept.
    is_correct = is_correct && std::abs(PMP::area(output) - 1200.) < 1e-9 &&
                 output.number_of_vertices() == number + result.number_of_added_vertices;
  }
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
