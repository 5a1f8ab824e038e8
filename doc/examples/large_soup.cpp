// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prepares a polygon soup with several threads, computes distances, and writes a distance matrix in
// two parts. The soup has three points per triangle, as in an STL file. It is a square that is
// folded like an accordion. A distance on it equals the distance on the flat square.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  const int n = 100; // the flat square consists of n times n unit squares
  std::vector<Point> points;
  std::vector<std::array<double, 2>> flat; // the position of each point on the flat square
  std::vector<std::array<std::size_t, 3>> triangles;
  const auto add_triangle = [&](const std::array<std::array<int, 2>, 3>& corners)
  {
    const std::size_t first = points.size();
    triangles.push_back({first, first + 1, first + 2});
    for(const auto& [i, j] : corners)
    {
      points.emplace_back(0.8 * i, j, 0.6 * (i % 2));
      flat.push_back({double(i), double(j)});
    }
  };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      add_triangle({{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
      add_triangle({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
    }

  const auto domain =
      GP::make_domain<CGAL::Parallel_tag>(points, triangles, GP::parameters::merge_tolerance(0.));
  std::cout << domain.report().number_of_merged_points << " of " << points.size()
            << " points were merged\n";

  // Vertex i of the mesh of the domain is point i. The method is exact.
  using Vertex = CGAL::Surface_mesh<Point>::Vertex_index;
  std::vector<double> distance(points.size());
  GP::geodesic_distances(domain, Vertex(0), CGAL::make_property_map(distance));
  double error = 0.;
  for(std::size_t i = 0; i < points.size(); ++i)
    error = std::max(error, std::abs(distance[i] - std::hypot(flat[i][0], flat[i][1])));

  // Each part could be written by another process or on another computer.
  std::vector<Vertex> samples;
  for(std::size_t i = 0; i < points.size(); i += 997)
    samples.emplace_back(i);
  const std::size_t rows = samples.size(), half = rows / 2;
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::vector<std::string> parts = {(folder / "large_soup_0.npy").string(),
                                          (folder / "large_soup_1.npy").string()};
  const std::string merged = (folder / "large_soup.npy").string();
  GP::write_geodesic_distance_matrix<GP::Exact, CGAL::Parallel_tag>(
      domain, samples, parts[0], GP::parameters::row_range(std::make_pair(std::size_t(0), half)));
  GP::write_geodesic_distance_matrix<GP::Exact, CGAL::Parallel_tag>(
      domain, samples, parts[1], GP::parameters::row_range(std::make_pair(half, rows)));
  GP::merge_distance_matrices(parts, merged);

  // A header of 128 bytes precedes the numbers, which are stored by rows.
  std::vector<double> matrix(rows * rows);
  std::ifstream file(merged, std::ios::binary);
  file.ignore(128);
  file.read(reinterpret_cast<char*>(matrix.data()),
            std::streamsize(matrix.size() * sizeof(double)));
  const bool is_complete = bool(file) && file.peek() == std::ifstream::traits_type::eof();
  file.close();
  for(std::size_t i = 0; i < rows; ++i)
    for(std::size_t j = 0; j < rows; ++j)
    {
      const auto &p = flat[samples[i]], &q = flat[samples[j]];
      const double exact = std::hypot(p[0] - q[0], p[1] - q[1]);
      error = std::max(error, std::abs(matrix[i * rows + j] - exact));
    }
  std::cout << matrix.size() << " distances were written; the largest error is " << error << '\n';
  for(const std::string& path : {parts[0], parts[1], merged})
    std::filesystem::remove(path);

  // The errors are round-off errors of distances up to 141.
  return is_complete && error < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
