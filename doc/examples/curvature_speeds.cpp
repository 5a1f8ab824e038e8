// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Samples a folded sheet uniformly, with samples attracted by its crease, repelled by it, and
// denser at an edge of an image.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
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

int main()
{
  // Creates a sheet with a crease along x = 20.
  Mesh mesh;
  CGAL::make_grid(
      40, 40, mesh, [](int i, int j) { return Point(i, j, std::abs(i - 20)); }, true);

  auto speed = mesh.add_property_map<Vertex, double>("v:speed", 1.).first;
  const auto count_at_crease = [&]
  {
    std::vector<GP::Location<Mesh>> samples;
    GP::farthest_point_sampling(mesh, 200, std::back_inserter(samples),
                                GP::parameters::speed_map(speed));
    return std::count_if(samples.begin(), samples.end(),
                         [&](const auto& sample)
                         { return std::abs(PMP::construct_point(sample, mesh).x() - 20.) < 3.; });
  };

  const auto uniform = count_at_crease();
  GP::curvature_speeds<GP::Edge_attractive>(mesh, speed);
  const auto attracted = count_at_crease();
  GP::curvature_speeds<GP::Edge_repulsive>(mesh, speed);
  const auto repelled = count_at_crease();

  std::cout << "Of 200 samples " << uniform << " lie within 3 of the crease, " << attracted
            << " when it attracts them and " << repelled << " when it repels them.\n";

  // The image is black on one side of the crease and white on the other.
  auto image = mesh.add_property_map<Vertex, double>("v:image").first;
  for(Vertex v : mesh.vertices())
    image[v] = mesh.point(v).x() < 20. ? 0. : 255.;
  GP::image_speeds(mesh, image, speed);
  const auto at_edge_of_image = count_at_crease();

  // The speed is 1 at vertices with the mean curvature of the crease, and lower at flat ones.
  const Vertex on_crease(20 + 41 * 20), on_flat_side(5 + 41 * 20);
  GP::similar_curvature_speeds(mesh, on_crease, speed);
  std::cout << at_edge_of_image << " samples lie there when the image has an edge. The speed for "
            << "curvatures as at the crease is " << speed[on_flat_side] << " at a flat vertex.\n";
  return attracted > 2 * uniform && 2 * repelled < uniform && at_edge_of_image > 2 * uniform &&
                 speed[on_crease] == 1. && speed[on_flat_side] < 0.5
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
