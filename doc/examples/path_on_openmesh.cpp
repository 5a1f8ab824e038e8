// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes the shortest path between the closest locations to two points, on a mesh of OpenMesh.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/Geodesic_processing.h>

#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Creates a roof of two rectangles, 1 by 2, that meet at a right angle along the y-axis.
  Mesh mesh;
  const auto left_0 = mesh.add_vertex(Mesh::Point(0, 0, -1));
  const auto left_1 = mesh.add_vertex(Mesh::Point(0, 2, -1));
  const auto ridge_0 = mesh.add_vertex(Mesh::Point(0, 0, 0));
  const auto ridge_1 = mesh.add_vertex(Mesh::Point(0, 2, 0));
  const auto right_0 = mesh.add_vertex(Mesh::Point(1, 0, 0));
  const auto right_1 = mesh.add_vertex(Mesh::Point(1, 2, 0));
  mesh.add_face(left_0, ridge_0, ridge_1);
  mesh.add_face(left_0, ridge_1, left_1);
  mesh.add_face(ridge_0, right_0, right_1);
  mesh.add_face(ridge_0, right_1, ridge_1);

  // One domain and one search tree serve all calls.
  const auto domain = GP::make_domain(mesh);
  const GP::Surface_locator<Mesh> locate(domain);
  const GP::Location<Mesh> from = locate(Point(-0.2, 0.5, -0.5)); // in front of the left side
  const GP::Location<Mesh> to = locate(Point(0.5, 1.5, 0.3));     // above the right side

  const GP::Surface_path<Mesh> path = GP::geodesic_path(domain, from, to);
  std::cout << "from " << domain.point(from) << " to " << domain.point(to) << ", length "
            << path.length << '\n';

  // Both sides unfold to a square, with the locations at (-0.5, 0.5) and (0.5, 1.5).
  return std::abs(path.length - std::sqrt(2.)) < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
