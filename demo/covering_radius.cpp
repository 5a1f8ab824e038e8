// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the covering radius of 10, 100 and 1,000 samples relative to a hexagonal lattice.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << "usage: covering_radius MESH RESULT.ply\n";
    return EXIT_FAILURE;
  }

  std::vector<GP::Location<Mesh>> samples;
  std::vector<double> radii;
  GP::farthest_point_sampling(mesh, 1000, std::back_inserter(samples),
                              GP::parameters::covering_radius_output(std::back_inserter(radii)));

  // The hexagonal lattice is the optimal covering of the plane by disks of radius r. Its cells are
  // hexagons of area 1.5 sqrt(3) r^2.
  const double area = CGAL::Polygon_mesh_processing::area(mesh);
  for(std::size_t n = 10; n <= radii.size(); n *= 10)
    std::cout << n << " samples have a covering radius of " << radii[n - 1] << ", "
              << radii[n - 1] / std::sqrt(area / (1.5 * std::sqrt(3.) * double(n)))
              << " times that of a hexagonal lattice.\n";

  samples.resize(std::min<std::size_t>(samples.size(), 100));
  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  GP::geodesic_distances(mesh, samples, distance);
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
