// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decomposes an optimal flow into its gradient, rotational and harmonic components.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Field = Mesh::Property_map<Mesh::Face_index, Kernel::Vector_3>;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  Mesh mesh, output;
  if(argc < 5 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
    return std::cerr << "usage: hodge_decomposition MESH FROM TO... RESULT.ply\n", EXIT_FAILURE;
  const Vertex from(Mesh::size_type(std::stoul(argv[2])));
  std::vector<Vertex> to; // targets; the mass is transported to the nearest ones
  for(int i = 3; i + 1 < argc; ++i)
    to.emplace_back(Mesh::size_type(std::stoul(argv[i])));
  std::vector<Field> field;
  for(const char* name : {"f:flow", "f:gradient", "f:rotation", "f:harmonic"})
    field.push_back(mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>(name).first);
  GP::Region_transport_solver<Mesh> solver(mesh, to);
  std::cout << "Transport distance to the nearest target: " << solver.compute(from).value << ".\n";
  solver.write_flow(field[0]);
  GP::hodge_decomposition(solver.domain(), field[0], field[1], field[2], field[3]);

  // Writes one copy of the mesh per field. The field is drawn by edges between additional
  // vertices.
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double width = box.xmax() - box.xmin();
  std::vector<Mesh::Point> lines;
  double total_squared_norm = 0.;
  for(std::size_t i = 0; i < 4; ++i)
  {
    double squared_norm = 0.;
    std::vector<double> lengths;
    for(auto f : mesh.faces())
    {
      const double square = field[i][f].squared_length();
      squared_norm += square * CGAL::Polygon_mesh_processing::face_area(f, mesh);
      lengths.push_back(std::sqrt(square));
    }
    // Vectors shorter than 12 % of the 98th percentile are not drawn. Vectors longer than the 98th
    // percentile are drawn with the maximum length. Fields with a relative squared norm of at most
    // 1e-9 are round-off errors and are not drawn.
    std::vector<double> sorted = lengths;
    std::sort(sorted.begin(), sorted.end());
    const double reference_length = sorted[sorted.size() * 49 / 50];
    total_squared_norm = i == 0 ? squared_norm : total_squared_norm;
    const std::size_t step = mesh.number_of_faces() / 1000 + 1; // draws at most 1,000 faces
    for(auto f : mesh.faces())
      if(const double length = lengths[f]; f % step == 0 && length > 0.12 * reference_length &&
                                           squared_norm > 1e-9 * total_squared_norm)
      {
        Kernel::Vector_3 center = CGAL::NULL_VECTOR;
        for(Vertex corner : mesh.vertices_around_face(mesh.halfedge(f)))
          center += (mesh.point(corner) - CGAL::ORIGIN) / 3.;
        const double scale = 0.05 * width * (std::min)(1. / length, 1. / reference_length);
        lines.push_back(CGAL::ORIGIN + center);
        lines.push_back(CGAL::ORIGIN + center + scale * field[i][f]);
      }
    std::cout << 100. * squared_norm / total_squared_norm << " % of the squared norm: "
              << (i == 0   ? "flow"
                  : i == 1 ? "gradient component"
                  : i == 2 ? "rotational component"
                           : "harmonic component")
              << '\n';
    output += mesh;
    for(Vertex v : mesh.vertices())
      mesh.point(v) += Kernel::Vector_3(1.1 * width, 0., 0.);
  }
  const std::size_t first = output.number_of_vertices();
  for(const Mesh::Point& p : lines)
    output.add_vertex(p);
  std::ostringstream ply;
  CGAL::IO::write_PLY(ply, output);
  std::string text = ply.str();
  text.insert(text.find("end_header"), "element edge " + std::to_string(lines.size() / 2) +
                                           "\nproperty int vertex1\nproperty int vertex2\n");
  for(std::size_t i = 0; i < lines.size(); ++i)
    text += std::to_string(first + i) + (i % 2 == 0 ? ' ' : '\n');
  return std::ofstream(argv[argc - 1]) << text ? EXIT_SUCCESS : EXIT_FAILURE;
}
