// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes exact distances between the corners of a cube, the shortest paths, and their initial
// directions.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
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
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), mesh);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  Vertex from, to;
  for(Vertex v : mesh.vertices())
  {
    if(mesh.point(v) == Point(0, 0, 0))
      from = v;
    if(mesh.point(v) == Point(1, 1, 1))
      to = v;
  }

  // The opposite corner is on the cut locus: six paths to it have the same minimum length.
  GP::Geodesic_distance_solver<Mesh, GP::Exact> solver(mesh);
  solver.compute(from);
  const std::vector<GP::Surface_path<Mesh>> paths = solver.shortest_paths(to);
  std::cout << paths.size() << " shortest paths, the first of length " << paths[0].length << '\n';
  bool is_correct = paths.size() == 6;
  for(const auto& path : paths)
    is_correct = is_correct && std::abs(path.length - std::sqrt(5.)) < 1e-12;

  // Computes the exact logarithmic map of a neighbor: angle and length of the shortest path.
  const Vertex neighbor = mesh.source(mesh.halfedge(from));
  const auto departure = solver.departure(neighbor);
  std::cout << "to " << mesh.point(neighbor) << " it is " << departure.length
            << " in the direction " << departure.direction << " at the angle "
            << departure.polar_angle << '\n';
  const Kernel::Vector_3 expected = mesh.point(neighbor) - mesh.point(from);
  is_correct =
      is_correct && (departure.length * departure.direction - expected).squared_length() < 1e-24;

  // Computes the distances of all pairs in parallel. From each corner, three others have distance
  // 1, three have sqrt(2), and one has sqrt(5).
  const std::vector<Vertex> corners(mesh.vertices().begin(), mesh.vertices().end());
  const Eigen::MatrixXd distances =
      GP::geodesic_distance_matrix<GP::Exact, CGAL::Parallel_tag>(mesh, corners);
  is_correct = is_correct &&
               std::abs(distances.sum() / 8. - (3. + 3. * std::sqrt(2.) + std::sqrt(5.))) < 1e-12;

  // Computes only the distances up to 1.2: from each corner to itself and to three neighbors at
  // distance 1.
  const auto near_pairs = GP::sparse_geodesic_distance_matrix<GP::Exact>(mesh, corners, 1.2);
  std::cout << near_pairs.nonZeros() << " of " << distances.size() << " pairs are within 1.2\n";
  is_correct = is_correct && near_pairs.nonZeros() == 8 * 4;

  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
