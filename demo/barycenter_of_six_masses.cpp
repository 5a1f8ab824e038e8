// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes the transport barycenter of six densities and compares it with the best single vertex.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Map = Mesh::Property_map<Vertex, double>;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || mesh.number_of_vertices() < 7)
    return std::cerr << "usage: barycenter_of_six_masses MESH RESULT.ply\n", EXIT_FAILURE;

  // Centers Gaussian densities at six vertices from farthest point sampling.
  std::vector<Vertex> centers = {Vertex(0)}; // start of the sampling, removed below
  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  while(centers.size() < 7)
  {
    GP::geodesic_distances(mesh, centers, distance);
    centers.push_back(*std::max_element(mesh.vertices().begin(), mesh.vertices().end(),
                                        [&](Vertex v, Vertex w)
                                        { return distance[v] < distance[w]; }));
  }
  centers.erase(centers.begin());
  const GP::Geodesic_distance_solver<Mesh> prepared_solver(mesh);
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double width = 0.04 * std::hypot(box.x_span(), box.y_span(), box.z_span());
  auto input_density = mesh.add_property_map<Vertex, double>("v:density", 0.).first;
  std::vector<GP::Mass_density<Map>> masses;
  for(Vertex center : centers)
  {
    const std::string name = "v:mass " + std::to_string(masses.size());
    masses.push_back(GP::mass_density(mesh.add_property_map<Vertex, double>(name).first));
    GP::Geodesic_distance_solver<Mesh> solver = prepared_solver;
    solver.compute(center);
    for(Vertex v : mesh.vertices())
    {
      masses.back().map[v] = std::exp(-std::pow(solver.distance(v) / width, 2));
      input_density[v] += masses.back().map[v];
    }
  }

  GP::Transport_barycenter_solver<Mesh> solver(mesh);
  const auto cost = solver.compute(masses, GP::parameters::do_normalize(true));
  const auto point = GP::geodesic_barycenter(mesh, centers);
  std::cout << "Sum of squared transport distances from the six densities to their barycenter: "
            << cost.upper << " (lower bound: " << cost.lower << ").\n"
            << "Sum of squared distances from the centers to the best vertex: " << point.value
            << ".\n";

  // The inputs are shown with negative values and their barycenter with positive values. A copy
  // that is rotated by 180 degrees shows the back.
  auto mean = mesh.add_property_map<Vertex, double>("v:mean").first;
  solver.write_density(mean);
  const double highest = *std::max_element(mean.begin(), mean.end());
  for(Vertex v : mesh.vertices())
    input_density[v] = std::sqrt(mean[v] / highest) - input_density[v];
  Mesh back_view = mesh;
  for(Vertex v : back_view.vertices())
    back_view.point(v) = {box.xmin() + box.xmax() + 1.1 * box.x_span() - back_view.point(v).x(),
                          back_view.point(v).y(), box.zmin() + box.zmax() - back_view.point(v).z()};
  mesh += back_view;
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
