// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reconstructs two meshes from surfels on a torus: one with vertices on the surface, and one with
// vertices that are moved such that the faces fit the surface.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Cloud = CGAL::Point_set_3<Kernel::Point_3, Kernel::Vector_3>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

int main()
{
  Cloud cloud(true);
  for(int i = 0; i < 120; ++i)
    for(int j = 0; j < 40; ++j)
    {
      const double u = 2. * CGAL_PI * i / 120., v = 2. * CGAL_PI * j / 40.;
      const Kernel::Vector_3 radial(std::cos(u), std::sin(u), 0.),
          normal = std::cos(v) * radial + Kernel::Vector_3(0., 0., std::sin(v));
      cloud.insert(CGAL::ORIGIN + radial + 0.4 * normal, normal);
    }

  Mesh interpolated, fitted;
  GP::geodesic_delaunay_remeshing(cloud, 300, interpolated,
                                  GP::parameters::number_of_relaxation_steps(5));
  GP::geodesic_delaunay_remeshing(cloud, 300, fitted,
                                  GP::parameters::number_of_relaxation_steps(5).do_fit(true));

  // A torus has V - E + F = 0, hence F = 2 V.  If the vertices are on the torus, most of the faces
  // are inside it and the volume is too small.
  const double volume = 2. * CGAL_PI * CGAL_PI * 0.4 * 0.4;
  const double missing = 1. - PMP::volume(interpolated) / volume;
  const double missing_in_fit = 1. - PMP::volume(fitted) / volume;
  std::cout << interpolated.number_of_vertices() << " vertices, " << interpolated.number_of_faces()
            << " faces; of the volume " << 100. * missing << " percent are missing, "
            << 100. * missing_in_fit << " percent where faces fit\n";
  return interpolated.number_of_faces() == 2 * interpolated.number_of_vertices() &&
                 std::abs(missing_in_fit) < 0.5 * missing
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
