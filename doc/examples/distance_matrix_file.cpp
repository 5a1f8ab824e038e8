// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the distances of all vertices to a file of NumPy, in two parts as on two machines, and
// joins the parts. In Python, numpy.load("distances.npy", mmap_mode="r") opens the file.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  Mesh mesh;
  CGAL::make_grid(
      20, 20, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);
  const std::vector<Mesh::Vertex_index> vertices(mesh.vertices().begin(), mesh.vertices().end());
  const std::size_t n = vertices.size(), half = n / 2;

  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::vector<std::string> parts = {(folder / "distances_0.npy").string(),
                                          (folder / "distances_1.npy").string()};
  const std::string joined = (folder / "distances.npy").string();
  GP::write_geodesic_distance_matrix<GP::Fast_marching, CGAL::Parallel_tag, float>(
      mesh, vertices, parts[0], GP::parameters::row_range(std::make_pair(std::size_t(0), half)));
  GP::write_geodesic_distance_matrix<GP::Fast_marching, CGAL::Parallel_tag, float>(
      mesh, vertices, parts[1], GP::parameters::row_range(std::make_pair(half, n)));
  GP::merge_distance_matrices(parts, joined);

  // A header of 128 bytes precedes the numbers.
  const std::size_t size = std::filesystem::file_size(joined);
  std::cout << n << " rows in " << size << " bytes\n";
  for(const std::string& file : {parts[0], parts[1], joined})
    std::filesystem::remove(file);
  return size == 128 + n * n * sizeof(float) ? EXIT_SUCCESS : EXIT_FAILURE;
}
