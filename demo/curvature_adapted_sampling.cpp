// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures how well tangent planes at samples approximate a surface, for three sample densities.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
  {
    std::cerr << "usage: curvature_adapted_sampling MESH RESULT.ply\n";
    return EXIT_FAILURE;
  }

  auto speed = mesh.add_property_map<Vertex, double>("v:speed", 1.).first;
  auto nearest = mesh.add_property_map<Vertex, std::size_t>("v:nearest").first;
  std::vector<GP::Location<Mesh>> samples;
  const auto print_error = [&](const char* description)
  {
    samples.clear();
    GP::farthest_point_sampling(mesh, 1000, std::back_inserter(samples),
                                GP::parameters::speed_map(speed).source_label_map(nearest));
    // Sums the distances of vertices to the plane of the face that contains their nearest sample.
    double sum = 0.;
    for(Vertex v : mesh.vertices())
      if(nearest[v] < samples.size())
      {
        const auto& sample = samples[nearest[v]];
        const auto normal = PMP::compute_face_normal(sample.first, mesh);
        sum += std::abs(normal * (mesh.point(v) - PMP::construct_point(sample, mesh)));
      }
    std::cout << description << ": the mean distance of vertices to the tangent planes at 1,000"
              << " samples is " << sum / double(mesh.number_of_vertices()) << ".\n";
  };
  print_error("Uniform samples");
  GP::curvature_speeds<GP::Edge_repulsive>(mesh, speed);
  print_error("Sparser samples at creases");
  GP::curvature_speeds<GP::Edge_attractive>(mesh, speed);
  print_error("Denser samples at creases");
  GP::geodesic_distances(mesh, samples, mesh.add_property_map<Vertex, double>("v:distance").first);
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
