// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places decals with an image of a flag at several vertices of a sphere, and a translucent sun on
// it.
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
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Projects one face of a cube to the unit sphere.
  Mesh mesh;
  const auto to_sphere = [](int i, int j)
  {
    const double x = i / 30. - 1., y = j / 30. - 1., size = std::sqrt(x * x + y * y + 1.);
    return Point(x / size, y / size, 1. / size);
  };
  CGAL::make_grid(60, 60, mesh, to_sphere, true);
  const auto vertex = [](int i, int j) { return Vertex(i + 61 * j); };
  const auto up = GP::parameters::up_direction(Kernel::Vector_3(0, 1, 0));

  // An image is a function of decal coordinates. An image file can be used through a function that
  // interpolates its pixels.
  const GP::Decal_color blue = {0., 0., 1., 1.}, yellow = {1., 1., 0., 1.};
  const GP::Decal_image flag = [&](const GP::Decal_coordinates& p)
  { return p[1] > 0.5 ? blue : yellow; };
  const GP::Decal_image sun = [](const GP::Decal_coordinates& p)
  {
    const bool is_inside = std::hypot(p[0] - 0.5, p[1] - 0.5) < 0.5;
    return GP::Decal_color{1., 0., 0., is_inside ? 0.5 : 0.};
  };

  // The placer precomputes once. The cost of a placement depends on the number of faces that the
  // decal covers.
  GP::Decal_placer<Mesh> placer(mesh);
  for(const int column : {15, 30})
    std::cout << "At column " << column << " the flag covers a part of "
              << placer.place(vertex(column, 30), 0.6, 0.4, up).faces.size() << " faces.\n";

  // Composites both decals into vertex colors.
  const auto flag_decal = placer.place(vertex(30, 30), 0.6, 0.4, up),
             sun_decal = placer.place(vertex(35, 35), 0.2, 0.2, up);
  auto color = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color", CGAL::IO::white()).first;
  GP::composite_decal(flag_decal, flag, color);
  GP::composite_decal(sun_decal, sun, color);

  // Bakes both decals into a texture image.
  const auto texture = GP::bake_decals<Mesh>({{flag_decal, flag}, {sun_decal, sun}}, 8);
  std::cout << texture.faces.size() << " faces are textured by an image of " << texture.width
            << " by " << texture.height << " texels.\n";

  return color[vertex(30, 28)] == CGAL::IO::yellow() && color[vertex(35, 35)][2] == 128 &&
                 color[vertex(5, 5)] == CGAL::IO::white() &&
                 texture.faces.size() >= flag_decal.faces.size()
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
