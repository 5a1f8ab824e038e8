// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes a texture atlas of surfels on a torus. A cloud has no faces, so that the atlas belongs
// to a mesh that is reconstructed.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Cloud = CGAL::Point_set_3<Kernel::Point_3, Kernel::Vector_3>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  Cloud cloud(true);
  for(int i = 0; i < 60; ++i)
    for(int j = 0; j < 24; ++j)
    {
      const double u = 2. * CGAL_PI * i / 60., v = 2. * CGAL_PI * j / 24.;
      const Kernel::Vector_3 radial(std::cos(u), std::sin(u), 0.),
          normal = std::cos(v) * radial + Kernel::Vector_3(0., 0., std::sin(v));
      cloud.insert(CGAL::ORIGIN + radial + 0.4 * normal, normal);
    }

  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto surfel =
      mesh.add_property_map<Mesh::Vertex_index, GP::Location<Cloud>>("v:surfel").first;
  const GP::Texture_atlas atlas =
      GP::texture_atlas(cloud, 8, mesh, uv, GP::parameters::location_map(surfel));
  std::cout << atlas.number_of_charts << " charts on " << mesh.number_of_faces() << " faces cover "
            << 100. * atlas.coverage << " percent of the texture\n";

  // The vertices of the mesh are the surfels. A torus has V - E + F = 0, hence F = 2 V.
  bool are_equal = mesh.number_of_vertices() == cloud.size();
  for(const Mesh::Vertex_index v : mesh.vertices())
    are_equal &= mesh.point(v) == cloud.point(surfel[v].surfel);
  return are_equal && atlas.is_injective() && mesh.number_of_faces() == 2 * cloud.size()
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
