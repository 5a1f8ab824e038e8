// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures how much distances change if a mesh is perturbed by noise or its head is rotated.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

// Appends a mesh to the row and prints the mean relative change of its distances. The reference is
// the first mesh of the row.
void append(Mesh& output, Mesh mesh, const char* name, Vertex from, double step)
{
  auto spectral = mesh.add_property_map<Vertex, double>("v:distance", 0.).first;
  auto geodesic = mesh.add_property_map<Vertex, double>("v:geodesic", 0.).first;
  GP::Transport_metric<Mesh>(mesh).write_distances<CGAL::Parallel_tag>(from, spectral);
  GP::geodesic_distances<GP::Exact>(mesh, from, geodesic);
  const std::size_t n = mesh.number_of_vertices();
  const Kernel::Vector_3 shift(step * double(output.number_of_vertices() / n), 0., 0.);
  for(Vertex v : mesh.vertices())
    mesh.point(v) += shift;
  output += mesh;
  const auto relative_change = [&](const char* property)
  {
    const auto map = output.add_property_map<Vertex, double>(property).first; // the existing map
    const std::size_t last = output.number_of_vertices() - n;
    double sum = 0.;
    for(std::size_t i = 0; i < n; ++i)
      if(i != from.idx())
        sum += std::abs(map[Vertex(last + i)] / map[Vertex(i)] - 1.);
    return 100. * sum / double(n);
  };
  std::cout << name << ": spectral distances change by " << relative_change("v:distance")
            << " %, geodesic distances by " << relative_change("v:geodesic") << " %\n";
}

int main(int argc, char* argv[])
{
  Mesh mesh, output;
  if(argc != 4 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
    return std::cerr << "usage: robustness MESH VERTEX RESULT.ply\n", EXIT_FAILURE;
  const Vertex from(Mesh::size_type(std::stoul(argv[2])));
  output.add_property_map<Vertex, double>("v:distance", 0.);
  output.add_property_map<Vertex, double>("v:geodesic", 0.);
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double step = 1.2 * (box.xmax() - box.xmin()), height = box.ymax() - box.ymin();
  append(output, mesh, "Input", from, step);

  double edge = 0.;
  for(auto h : mesh.halfedges())
    edge +=
        std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)))) /
        mesh.number_of_halfedges();
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0., 1.);
  for(const double noise_ratio : {0.1, 0.3})
  {
    Mesh noisy = mesh;
    for(Vertex v : noisy.vertices())
      noisy.point(v) +=
          noise_ratio * edge * Kernel::Vector_3(normal(random), normal(random), normal(random));
    append(output, noisy,
           noise_ratio < 0.2 ? "Noise of 0.1 edge lengths" : "Noise of 0.3 edge lengths", from,
           step);
  }

  // The top quarter is rotated by 0.7 radians and the lower half is fixed. The rest is
  // deformed as rigidly as possible.
  const Kernel::Point_3 neck(0.5 * (box.xmin() + box.xmax()), box.ymin() + 0.6 * height,
                             0.5 * (box.zmin() + box.zmax()));
  CGAL::Surface_mesh_deformation<Mesh> deformation(mesh);
  deformation.insert_roi_vertices(mesh.vertices().begin(), mesh.vertices().end());
  for(Vertex v : mesh.vertices())
    if(std::abs(mesh.point(v).y() - box.ymin() - 0.625 * height) > 0.125 * height)
      deformation.insert_control_vertex(v);
  for(Vertex v : mesh.vertices())
    if(mesh.point(v).y() > box.ymax() - 0.25 * height)
    {
      const auto d = mesh.point(v) - neck;
      const double c = std::cos(0.7), s = std::sin(0.7);
      deformation.set_target_position(
          v, neck + Kernel::Vector_3(c * d.x() + s * d.z(), d.y(), c * d.z() - s * d.x()));
    }
  deformation.deform(20, 0.);
  append(output, mesh, "Rotated head", from, step);
  return CGAL::IO::write_polygon_mesh(argv[3], output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
