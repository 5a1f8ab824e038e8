// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shortens polylines on surfaces that are given by their squared distances: a triangle mesh with an
// AABB tree, and a torus with a formula.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
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
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // A tetrahedron. The polyline begins on the face z = 0 and ends on the face y = 0.
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0., 0., 0.), Point(4., 0., 0.), Point(0., 4., 0.), Point(0., 0., 4.),
                         mesh);
  const Tree tree(faces(mesh).begin(), faces(mesh).end(), mesh);
  const std::vector<Point> bent = {Point(1., 1., 0.), Point(2.5, 0., 0.), Point(1.5, 0., 1.)};
  const auto on_mesh =
      GP::shorten_polyline(bent, [&](const Point& p) { return tree.squared_distance(p); });
  // The overload for meshes computes a locally shortest path, which is exact.
  const auto exact = GP::shorten_polyline(mesh, bent);
  std::cout << "on the mesh: energy " << on_mesh.distance << ", locally shortest path "
            << exact.length << '\n';

  // A zigzag line along the inner circle of a torus with radii 1 and 0.4.
  const auto squared_distance = [](const Point& p)
  {
    const double from_axis = std::hypot(p.x(), p.y());
    const double from_torus = std::hypot(from_axis - 1., p.z()) - 0.4;
    return from_torus * from_torus;
  };
  std::vector<Point> zigzag;
  for(int i = 0; i <= 20; ++i)
  {
    const double a = 0.1 * i, b = CGAL_PI + (i % 2 == 0 ? 0. : 0.3);
    const double r = 1. + 0.4 * std::cos(b);
    zigzag.emplace_back(r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b));
  }
  const auto on_torus = GP::shorten_polyline(zigzag, squared_distance);
  std::cout << "on the torus: " << on_torus.distance << '\n';

  // In the plane of the unfolded faces, the geodesic is a straight line. The minimizer rounds the
  // edge off, which adds 0.05 % to its length. On the torus, the geodesic is an arc of the inner
  // circle, whose radius is 0.6; a smooth curve of 76 segments has an error below 1e-5.
  const double unfolded = std::hypot(0.5, 2.);
  return std::abs(exact.length - unfolded) < 1e-12 &&
                 std::abs(on_mesh.distance - unfolded) < 1e-3 * unfolded &&
                 std::abs(on_torus.distance - 0.6 * 2.) < 1e-5
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
