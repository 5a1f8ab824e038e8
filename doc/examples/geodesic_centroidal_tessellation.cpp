// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments a torus into charts with disk topology, accesses each chart as a mesh, and segments a
// cloud of surfels.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = Mesh::Face_index;
using Cloud = CGAL::Point_set_3<Point, Kernel::Vector_3>;

namespace GP = CGAL::Geodesic_processing;

// Returns a torus of 60 by 24 vertices with radii 3 and 1.
Mesh make_torus()
{
  Mesh mesh;
  const double two_pi = 2. * std::acos(-1.);
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i < 60; ++i)
    for(int j = 0; j < 24; ++j)
    {
      const double u = two_pi * i / 60., w = two_pi * j / 24., r = 3. + std::cos(w);
      v.push_back(mesh.add_vertex(Point(r * std::cos(u), r * std::sin(u), std::sin(w))));
    }
  const auto at = [&](int i, int j) { return v[std::size_t(i % 60 * 24 + j % 24)]; };
  for(int i = 0; i < 60; ++i)
    for(int j = 0; j < 24; ++j)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

int main()
{
  Mesh mesh = make_torus();
  auto chart = mesh.add_property_map<Face, std::size_t>("f:chart").first;
  std::vector<double> energies;
  const std::size_t number_of_charts = GP::geodesic_centroidal_tessellation(
      mesh, 12, chart,
      GP::parameters::do_make_discs(true).energy_output(std::back_inserter(energies)));
  std::cout << number_of_charts << " charts, energy " << energies.front() << " to "
            << energies.back() << '\n';

  // Each chart must have the Euler characteristic of a disk.
  bool is_correct = number_of_charts >= 12 && energies.back() < energies.front();
  for(std::size_t i = 0; i < number_of_charts; ++i)
  {
    const CGAL::Face_filtered_graph<Mesh> disk(mesh, i, chart);
    const auto vertices = disk.number_of_vertices(), edges = disk.number_of_halfedges() / 2;
    std::cout << "chart " << i << ": " << disk.number_of_faces() << " faces\n";
    is_correct =
        is_correct && disk.is_selection_valid() && vertices + disk.number_of_faces() == edges + 1;
  }

  // On a cloud, surfels have labels instead of faces.
  Cloud cloud(true);
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const Point& p = mesh.point(v);
    const double r = std::hypot(p.x(), p.y());
    cloud.insert(p, Kernel::Vector_3(p.x() - 3. * p.x() / r, p.y() - 3. * p.y() / r, p.z()));
  }
  auto label = cloud.add_property_map<std::size_t>("label").first;
  const std::size_t number_of_cells = GP::geodesic_centroidal_tessellation(cloud, 12, label);
  std::vector<std::size_t> size(number_of_cells, 0);
  for(Cloud::Index i : cloud)
    ++size[label[i]];
  const auto [smallest, largest] = std::minmax_element(size.begin(), size.end());
  std::cout << "cells of the cloud have " << *smallest << " to " << *largest << " surfels\n";
  is_correct = is_correct && number_of_cells == 12 && *smallest > 0;
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
