// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Samples a mesh such that each vertex is within a given distance of its nearest sample, and
// selects surfels of a cloud.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <limits>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Cloud = CGAL::Point_set_3<Point, Kernel::Vector_3>;

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

int main()
{
  // Creates a planar grid of size 40 by 30.
  Mesh mesh;
  CGAL::make_grid(
      40, 30, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);

  std::vector<GP::Location<Mesh>> samples;
  std::vector<double> radii;
  GP::farthest_point_sampling(
      mesh, std::numeric_limits<std::size_t>::max(), std::back_inserter(samples),
      GP::parameters::covering_radius(5.).covering_radius_output(std::back_inserter(radii)));

  std::cout << samples.size() << " samples, the first four at\n";
  for(std::size_t i = 0; i < 4; ++i)
    std::cout << PMP::construct_point(samples[i], mesh) << '\n';

  // The first sample is a corner, because the farthest vertex from any vertex is a corner. The
  // covering radii are non-increasing.
  const Point first = PMP::construct_point(samples[0], mesh);
  const bool is_corner =
      (first.x() == 0. || first.x() == 40.) && (first.y() == 0. || first.y() == 30.);
  bool is_correct = is_corner && radii.back() <= 5. && radii.size() == samples.size() &&
                    std::is_sorted(radii.rbegin(), radii.rend());

  // On a square of surfels, the first four samples are the corners.
  Cloud cloud(true);
  for(int i = 0; i <= 20; ++i)
    for(int j = 0; j <= 20; ++j)
      cloud.insert(Point(i, j, 0.), Kernel::Vector_3(0., 0., 1.));
  std::vector<Cloud::Index> surfels;
  GP::farthest_vertex_sampling(cloud, 4, std::back_inserter(surfels));
  for(Cloud::Index i : surfels)
  {
    std::cout << "surfel at " << cloud.point(i) << '\n';
    is_correct = is_correct && std::abs(cloud.point(i).x() - 10.) == 10. &&
                 std::abs(cloud.point(i).y() - 10.) == 10.;
  }
  is_correct = is_correct && surfels.size() == 4;
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
