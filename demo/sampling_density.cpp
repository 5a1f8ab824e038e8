// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Samples a surface with a user-defined density, higher in the upper third of the model.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
  {
    std::cerr << "usage: sampling_density MESH RESULT.ply\n";
    return EXIT_FAILURE;
  }
  const auto box = PMP::bbox(mesh);
  const double height = (box.ymin() + 2. * box.ymax()) / 3.;
  auto speed = mesh.add_property_map<Vertex, double>("v:speed").first;
  for(const auto v : mesh.vertices())
    speed[v] = mesh.point(v).y() > height ? 0.3 : 1.;

  const auto number_above = [&](const auto& np)
  {
    std::vector<GP::Location<Mesh>> samples;
    GP::farthest_point_sampling(mesh, 1000, std::back_inserter(samples), np);
    return std::count_if(samples.begin(), samples.end(),
                         [&](const auto& sample)
                         { return PMP::construct_point(sample, mesh).y() > height; });
  };
  std::cout << "The upper third contains " << number_above(GP::parameters::speed_map(speed))
            << " of 1,000 samples with low speed, and "
            << number_above(GP::parameters::random_seed(0)) << " with uniform speed.\n";
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
