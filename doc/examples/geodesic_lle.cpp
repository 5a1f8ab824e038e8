// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flattens a hill by geodesic LLE, then minimizes the distortion such that no face is inverted.
// Multidimensional scaling flattens it for comparison.
#include <CGAL/Geodesic_processing.h>

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
  const auto hill = [](int i, int j)
  {
    const double x = i / 20. - 1., y = j / 20. - 1.;
    return Point(x, y, std::exp(-4. * (x * x + y * y)));
  };
  CGAL::make_grid(40, 40, mesh, hill, true);

  auto uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
  GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(100));
  const GP::Flattening_distortion initial = GP::flattening_distortion(mesh, uv);
  const GP::Distortion_minimum minimization = GP::minimize_distortion(mesh, uv);
  const GP::Flattening_distortion minimized = GP::flattening_distortion(mesh, uv);

  std::cout << "Angles and areas: " << initial.conformal << " and " << initial.authalic << ", with "
            << initial.number_of_flips << " flips; after " << minimization.number_of_iterations
            << " steps " << minimized.conformal << " and " << minimized.authalic << ", with "
            << minimized.number_of_flips << ".\n";

  GP::geodesic_mds(mesh, uv, GP::parameters::number_of_base_points(100));
  const GP::Flattening_distortion scaled = GP::flattening_distortion(mesh, uv);
  std::cout << "Multidimensional scaling: " << scaled.conformal << " and " << scaled.authalic
            << ", with " << scaled.number_of_flips << " flips.\n";
  return minimized.number_of_flips == 0 &&
                 minimized.symmetric_dirichlet < initial.symmetric_dirichlet &&
                 minimized.symmetric_dirichlet < scaled.symmetric_dirichlet
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
