// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Maps a sphere to the plane by the logarithmic map at a pole and measures the maximum error.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  if(argc != 2)
  {
    std::cerr << "usage: azimuthal_map RESULT.ply\n";
    return EXIT_FAILURE;
  }

  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0., 0., 0.), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(6));
  for(Vertex v : mesh.vertices())
  {
    const Vector direction = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + direction / std::sqrt(direction.squared_length());
  }

  // The map extends to colatitude 150 degrees, which is 60 degrees beyond the equator.
  const double degree = std::acos(-1.) / 180., max_angle = 150. * degree;
  GP::Logarithmic_map<Mesh> map(mesh);
  const Vertex pole(0);
  map.compute(pole, GP::parameters::maximum_distance(max_angle));
  const Vector up = mesh.point(pole) - CGAL::ORIGIN, u = map.frame().u, v = map.frame().v;

  // The function is zero on every thirtieth parallel and meridian. Its amplitude is the
  // colatitude, at most 1, because the meridians meet at the pole.
  Mesh flat;
  auto value = flat.add_property_map<Vertex, double>("v:graticule").first;
  std::vector<Vertex> image(mesh.number_of_vertices());
  double max_error = 0.;
  for(Vertex vertex : map.reached())
  {
    const Vector direction = mesh.point(vertex) - CGAL::ORIGIN;
    const double colatitude = std::acos(std::clamp(direction * up, -1., 1.)),
                 longitude = std::atan2(direction * v, direction * u);
    const auto [x, y] = map(vertex);
    max_error = (std::max)(max_error, std::hypot(x - colatitude * std::cos(longitude),
                                                 y - colatitude * std::sin(longitude)));
    image[vertex] = flat.add_vertex(Point(x, y, 0.));
    value[image[vertex]] =
        (std::min)(1., colatitude) * std::sin(6. * colatitude) * std::sin(6. * longitude);
  }
  for(Mesh::Face_index f : mesh.faces())
  {
    std::vector<Vertex> corners;
    for(Vertex vertex : mesh.vertices_around_face(mesh.halfedge(f)))
      if(map.is_inside(vertex))
        corners.push_back(image[vertex]);
    if(corners.size() == 3)
      flat.add_face(corners);
  }

  // Lengths along circles of latitude are stretched by this factor.
  const auto stretch = [](double colatitude) { return colatitude / std::sin(colatitude); };
  std::cout << "The maximum error is " << max_error << " times the radius of the sphere.  Lengths"
            << " along circles of latitude are stretched by a factor of " << stretch(90. * degree)
            << " at the equator and " << stretch(max_angle) << " at the boundary of the map.\n";
  return CGAL::IO::write_polygon_mesh(argv[1], flat) ? EXIT_SUCCESS : EXIT_FAILURE;
}
