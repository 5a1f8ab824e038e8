// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares geodesic distances on a mesh with distances on the point cloud of its vertices.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Cloud = CGAL::Point_set_3<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
  {
    std::cerr << "usage: mesh_vs_cloud MESH RESULT.ply\n";
    return EXIT_FAILURE;
  }

  Cloud cloud(true);
  for(Vertex v : mesh.vertices())
    cloud.insert(mesh.point(v), CGAL::Polygon_mesh_processing::compute_vertex_normal(v, mesh));

  auto on_mesh = mesh.add_property_map<Vertex, double>("v:distance").first;
  auto on_cloud = cloud.add_property_map<double>("distance").first;
  GP::geodesic_distances(mesh, Vertex(0), on_mesh);
  GP::geodesic_distances(cloud, Cloud::Index(0), on_cloud);

  double sum = 0., difference = 0.;
  for(Vertex v : mesh.vertices())
    if(std::isfinite(on_mesh[v]) && std::isfinite(on_cloud[v.idx()]))
    {
      sum += on_mesh[v];
      difference += std::abs(on_mesh[v] - on_cloud[v.idx()]);
    }
  std::cout << "Distances on the cloud differ from distances on the mesh by "
            << 100. * difference / sum << " % on average.\n";

  std::ofstream result(argv[2]);
  return result << cloud ? EXIT_SUCCESS : EXIT_FAILURE;
}
