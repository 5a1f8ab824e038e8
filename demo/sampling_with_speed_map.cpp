// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Samples a square whose left half has a quarter of the speed of the right half.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const int number = argc == 3 ? std::atoi(argv[1]) : 0;
  if(number <= 0)
  {
    std::cerr << "usage: sampling_with_speed_map NUMBER RESULT.ply\n";
    return EXIT_FAILURE;
  }
  Mesh mesh;
  CGAL::make_grid(
      200, 200, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);
  auto speed = mesh.add_property_map<Vertex, double>("v:speed").first;
  for(auto v : mesh.vertices())
    speed[v] = mesh.point(v).x() < 100. ? 0.25 : 1.;

  std::vector<GP::Location<Mesh>> samples;
  GP::farthest_point_sampling(mesh, number, std::back_inserter(samples),
                              GP::parameters::speed_map(speed));
  const auto number_of_slow_samples = std::count_if(
      samples.begin(), samples.end(),
      [&](const auto& sample) { return PMP::construct_point(sample, mesh).x() < 100.; });
  std::cout << "The slow half contains " << number_of_slow_samples << " of " << number
            << " samples; " << std::lround(16. / 17. * number)
            << " are expected, because a quarter of the spacing gives 16 times the density.\n";

  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  GP::geodesic_distances(mesh, samples, distance, GP::parameters::speed_map(speed));
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
