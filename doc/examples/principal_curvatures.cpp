// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes the principal curvatures of half a cylinder, as a mesh and as a cloud: 1/2 around the
// axis and 0 along it.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
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
using Cloud = CGAL::Point_set_3<Point, Kernel::Vector_3>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Creates half a cylinder of radius 2 along the y axis.
  Mesh mesh;
  CGAL::make_grid(
      60, 60, mesh,
      [](int i, int j)
      {
        const double angle = 0.05 * (30 - i);
        return Point(2. * std::sin(-angle), 0.1 * j, 2. * std::cos(angle));
      },
      true);

  auto curvatures =
      mesh.add_property_map<Vertex, GP::Principal_curvatures<Mesh>>("v:curvatures").first;
  GP::principal_curvatures(mesh, curvatures);

  const auto& center_curvatures = curvatures[Vertex(30 + 61 * 30)];
  std::cout << "The least curvature is " << center_curvatures.min_curvature << " along "
            << center_curvatures.min_direction << ", the largest "
            << center_curvatures.max_curvature << " along " << center_curvatures.max_direction
            << ".\n";

  // The vertices as surfels. The error is smaller, because quadrics are fitted to points and
  // normals.
  Cloud cloud(true);
  for(Vertex v : mesh.vertices())
  {
    const Point& p = mesh.point(v);
    cloud.insert(p, Kernel::Vector_3(p.x() / 2., 0., p.z() / 2.));
  }
  auto surfel_curvatures =
      cloud.add_property_map<GP::Principal_curvatures<Cloud>>("curvatures").first;
  GP::principal_curvatures(cloud, surfel_curvatures);
  const auto& at_center = surfel_curvatures[Cloud::Index(30 + 61 * 30)];
  std::cout << "Curvatures of the surfel are " << at_center.min_curvature << " and "
            << at_center.max_curvature << ".\n";
  const bool is_correct = std::abs(at_center.max_curvature - 0.5) < 0.005 &&
                          std::abs(at_center.min_curvature) < 0.005 &&
                          std::abs(center_curvatures.max_curvature - 0.5) < 0.05 &&
                          std::abs(center_curvatures.min_curvature) < 0.02 &&
                          std::abs(center_curvatures.min_direction.y()) > 0.99;
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
