// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves the vertices of a mesh until a geodesic distance has a prescribed value.
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
  // A hill over a square.
  Mesh mesh;
  CGAL::make_grid(
      12, 12, mesh,
      [](std::size_t i, std::size_t j)
      {
        const double x = double(i) / 12. - 0.5, y = double(j) / 12. - 0.5;
        return Point(x, y, 0.4 * std::exp(-8. * (x * x + y * y)));
      },
      true);

  // Locations move with the vertices of their faces.
  const GP::Location<Mesh> source = {Mesh::Face_index(21), {0.2, 0.3, 0.5}},
                           target = {Mesh::Face_index(250), {0.4, 0.5, 0.1}};
  const double prescribed_distance = 1.1;

  // Newton's method along the gradient.
  for(int i = 0; i < 20; ++i)
  {
    const auto derivatives = GP::geodesic_distance_derivatives(mesh, source, target);
    const double difference = prescribed_distance - derivatives.distance;
    std::cout << "the distance is " << derivatives.distance << '\n';
    if(std::abs(difference) < 1e-12)
      return EXIT_SUCCESS;
    // Otherwise these are the derivatives of one shortest path, which still reduce the difference.
    if(!derivatives.is_differentiable())
      std::cout << "it is not differentiable\n";
    double squared_norm = 0.;
    for(const auto& [v, gradient] : derivatives.vertex_gradients)
      squared_norm += gradient.squared_length();
    for(const auto& [v, gradient] : derivatives.vertex_gradients)
      mesh.point(v) = mesh.point(v) + (difference / squared_norm) * gradient;
  }
  return EXIT_FAILURE;
}
