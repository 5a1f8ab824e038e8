// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes the logarithmic map at the pole of a spherical patch and its distortion.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Point_2 = Kernel::Point_2;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Projects one face of a cube to the unit sphere.
  Mesh mesh;
  const auto to_sphere = [](int i, int j)
  {
    const double x = i / 30. - 1., y = j / 30. - 1., radius = std::sqrt(x * x + y * y + 1.);
    return Point(x / radius, y / radius, 1. / radius);
  };
  CGAL::make_grid(60, 60, mesh, to_sphere, true);
  const Vertex pole(30 + 61 * 30);

  auto uv = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
  // Uses a long stencil, because the sphere is smooth.
  GP::logarithmic_map(mesh, pole, uv,
                      GP::parameters::up_direction(Kernel::Vector_3(0, 1, 0)).stencil_length(0.2));

  double largest = 0.;
  for(Vertex v : mesh.vertices())
  {
    const Point& p = mesh.point(v);
    const double radius = std::hypot(p.x(), p.y()), angle = std::atan2(radius, p.z());
    if(v != pole)
      largest = std::max(largest, std::hypot(uv[v].x() - angle * p.x() / radius,
                                             uv[v].y() - angle * p.y() / radius));
  }
  const auto stretch = GP::surface_distortion(mesh, uv, &GP::Face_distortion::mips);
  std::cout << "Places on the map are off by " << largest << " at most; angles are stretched by "
            << stretch.mean() << " in the mean and by " << stretch.worst << " at the rim.\n";

  // The most distorted face is at a corner of the patch. Lengths along rays are kept there.
  const GP::Face_distortion worst = GP::face_distortion(stretch.worst_location.first, mesh, uv);
  std::cout << "There, the singular values are " << worst.sigma_1 << " and " << worst.sigma_2
            << ".\n";

  // Fast marching is less accurate close to its source. Shorter edges there and smooth distance maps
  // reduce the errors of directions.
  const auto mean_error = [&](std::size_t refinements, std::size_t steps)
  {
    auto rough_uv = mesh.add_property_map<Vertex, Point_2>("v:rough_uv").first;
    GP::logarithmic_map<GP::Gradient<GP::Fast_marching>>(
        mesh, pole, rough_uv,
        GP::parameters::up_direction(Kernel::Vector_3(0, 1, 0))
            .number_of_base_refinements(refinements)
            .number_of_smoothing_steps(steps));
    double sum = 0.;
    for(Vertex v : mesh.vertices())
      sum += std::sqrt(CGAL::squared_distance(uv[v], rough_uv[v]));
    return sum / double(mesh.number_of_vertices());
  };
  const double plain = mean_error(0, 0), improved = mean_error(3, 30);
  std::cout << "Fast marching is off by " << plain << " in the mean, with both options by "
            << improved << ".\n";

  // Circles around the pole are stretched by angle / sin(angle).
  const double boundary_angle = std::atan(std::sqrt(2.));
  return largest < 2e-3 && improved < plain && std::abs(worst.mips() - stretch.worst) < 1e-9 &&
                 std::abs(stretch.worst - boundary_angle / std::sin(boundary_angle)) < 0.05
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
