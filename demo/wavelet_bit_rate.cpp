// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the error of a semi-regular mesh decoded from 1, 2, 4 and 8 bits per vertex.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  Mesh mesh, subdivided;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << "usage: wavelet_bit_rate MESH RESULT.ply\n";
    return EXIT_FAILURE;
  }

  GP::semi_regular_remeshing(mesh, 250, 4, subdivided,
                             GP::parameters::number_of_relaxation_steps(10));

  const GP::Subdivision_wavelet<Mesh> wavelet(subdivided);
  const auto bytes =
      wavelet.encode(wavelet.analyze(subdivided.points(), GP::parameters::do_use_frames(true)));
  const Tree tree(faces(mesh).first, faces(mesh).second, mesh);
  for(const double bits : {1., 2., 4., 8.})
  {
    Mesh decoded;
    const auto size = std::ptrdiff_t(bits / 8. * double(subdivided.number_of_vertices()));
    GP::decode_wavelets(std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + size), decoded);
    double sum = 0.;
    for(const auto v : decoded.vertices())
      sum += tree.squared_distance(decoded.point(v));
    std::cout << bits << " bits per vertex: the root mean square distance to the input is "
              << std::sqrt(sum / double(decoded.number_of_vertices())) << ".\n";
  }
  return CGAL::IO::write_polygon_mesh(argv[2], subdivided) ? EXIT_SUCCESS : EXIT_FAILURE;
}
