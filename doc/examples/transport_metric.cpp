// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares how smooth geodesic distances and transport metrics are at the cut locus of a tube.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

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
  // Creates an open tube of 41 rings with 40 vertices each. Edges along rings have length 1.
  const int n = 40, rings = 41;
  const double radius = 0.5 / std::sin(CGAL_PI / n);
  Mesh mesh;
  for(int j = 0; j < rings; ++j)
    for(int i = 0; i < n; ++i)
      mesh.add_vertex(Point(radius * std::cos(2. * CGAL_PI * i / n),
                            radius * std::sin(2. * CGAL_PI * i / n), j));
  const auto at = [](int i, int j) { return Vertex(Mesh::size_type(n * j + i % n)); };
  for(int j = 0; j + 1 < rings; ++j)
    for(int i = 0; i < n; ++i)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }

  // Returns the negated second difference of the distance around the ring, at the vertex opposite
  // the source.
  const int middle = rings / 2;
  const Vertex from = at(0, middle), opposite = at(n / 2, middle);
  const auto slope_change = [&](const auto& distance)
  {
    return 2. * distance(opposite) - distance(at(n / 2 - 1, middle)) -
           distance(at(n / 2 + 1, middle));
  };

  GP::Geodesic_distance_solver<Mesh, GP::Exact> solver(mesh);
  solver.compute(from);
  const auto geodesic = [&](Vertex v) { return solver.distance(v); };
  std::cout << "geodesic: " << geodesic(opposite) << ", bends by " << slope_change(geodesic)
            << '\n';
  bool is_correct = std::abs(slope_change(geodesic) - 2.) < 1e-9; // the slope changes from 1 to -1

  // The transport metric is smoothest with basis size 0. It approaches the geodesic distance as
  // the basis size grows.
  double previous_distance = 1e9;
  for(const std::size_t k : {0, 20, 100})
  {
    const GP::Transport_metric<Mesh> metric(
        mesh, k, GP::parameters::transport_flow(GP::Transport_flow::gradient));
    const auto distance = [&](Vertex v)
    { return metric.distance(from, v, GP::parameters::tolerance(1e-4)); };
    std::cout << "k = " << metric.basis_size() << ": " << distance(opposite) << ", bends by "
              << slope_change(distance) << '\n';
    is_correct = is_correct && distance(opposite) < previous_distance &&
                 slope_change(distance) < 0.5 * slope_change(geodesic);
    previous_distance = distance(opposite);
  }
  return is_correct && previous_distance > geodesic(opposite) ? EXIT_SUCCESS : EXIT_FAILURE;
}
