// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes a texture atlas of a spherical patch and bakes bands of latitude into its texture.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  Mesh mesh;
  const auto to_sphere = [](int i, int j)
  {
    const double x = i / 15. - 1., y = j / 15. - 1., size = std::sqrt(x * x + y * y + 1.);
    return Point(x / size, y / size, 1. / size);
  };
  CGAL::make_grid(30, 30, mesh, to_sphere, true);

  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const GP::Texture_atlas atlas =
      GP::texture_atlas(mesh, 6, uv, GP::parameters::texture_size(256).gutter_width(4));

  const auto latitude = [&](const auto& location)
  {
    double z = 0.;
    auto h = mesh.halfedge(location.first);
    for(const double weight : location.second)
    {
      z += weight * mesh.point(mesh.source(h)).z();
      h = mesh.next(h);
    }
    const bool is_dark = int(std::floor(20. * std::asin(z))) % 2 == 0;
    return is_dark ? GP::Decal_color{0.1, 0.3, 0.5, 1.} : GP::Decal_color{1., 1., 0.9, 1.};
  };
  const auto texels = GP::bake_atlas(mesh, uv, latitude, 256);

  std::cout << atlas.number_of_charts << " charts cover " << atlas.coverage
            << " of the texture, of " << texels.size() << " texels; "
            << (atlas.is_injective() ? "none" : "some") << " covers itself.\n";
  return atlas.is_injective() && atlas.coverage > 0.4 ? EXIT_SUCCESS : EXIT_FAILURE;
}
