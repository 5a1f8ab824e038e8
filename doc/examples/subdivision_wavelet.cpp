// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compresses a bumpy sphere: reconstructs it from a tenth of its wavelet coefficients, and from the
// first half of its progressive stream.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point>(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(5));
  for(const auto v : mesh.vertices())
  {
    const auto n = mesh.point(v) - CGAL::ORIGIN;
    const double r = 1. + 0.1 * std::sin(4. * n.x() / std::sqrt(n.squared_length()));
    mesh.point(v) = CGAL::ORIGIN + r / std::sqrt(n.squared_length()) * n;
  }
  const Mesh original = mesh;
  const auto rms_error = [&](const auto& point)
  {
    double sum = 0.;
    for(const auto v : original.vertices())
      sum += (point(v) - original.point(v)).squared_length();
    return std::sqrt(sum / double(original.number_of_vertices()));
  };

  const GP::Subdivision_wavelet<Mesh> wavelet(mesh);
  GP::Wavelet_details details = wavelet.analyze(mesh.points(), GP::parameters::do_use_frames(true));
  std::vector<std::uint8_t> stream = wavelet.encode(details);

  wavelet.keep_largest(details, mesh.number_of_vertices() / 10);
  wavelet.synthesize(details, mesh.points());
  const double error_of_tenth = rms_error([&](auto v) { return mesh.point(v); });

  stream.resize(stream.size() / 2);
  Mesh decoded;
  const GP::Wavelet_stream decoded_stream = GP::decode_wavelets(stream, decoded);
  std::vector<Point> positions(mesh.number_of_vertices());
  for(std::size_t i = 0; i < positions.size(); ++i)
    positions[wavelet.vertex(i)] = decoded.point(Mesh::Vertex_index(Mesh::size_type(i)));
  const double error_of_half = rms_error([&](auto v) { return positions[v]; });

  std::cout << wavelet.number_of_levels() << " levels above " << wavelet.number_of_vertices(0)
            << " vertices. With a tenth of the details vertices move by " << error_of_tenth
            << ", with " << 8. * double(stream.size()) / double(positions.size())
            << " bits for each by " << error_of_half << ", after "
            << decoded_stream.number_of_bit_planes << " planes.\n";
  return wavelet.number_of_levels() == 5 && !decoded_stream.is_complete && error_of_tenth < 1e-3 &&
                 error_of_half < 1e-3
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
