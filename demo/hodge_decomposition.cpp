// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hodge decomposition of an optimal flow, with the potentials of its gradient and its rotation.
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
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Field = Mesh::Property_map<Mesh::Face_index, Kernel::Vector_3>;
using Values = Mesh::Property_map<Vertex, double>;

namespace GP = CGAL::Geodesic_processing;

constexpr double no_value = std::numeric_limits<double>::infinity();

// Returns the integral of the squared vectors of a field.
double squared_norm(const Mesh& mesh, const Field& field)
{
  double result = 0.;
  for(auto f : mesh.faces())
    result += field[f].squared_length() * CGAL::Polygon_mesh_processing::face_area(f, mesh);
  return result;
}

// Appends two endpoints per arrow, for at most 1,000 faces. Vectors shorter than 12 % of the 98th
// percentile are omitted. Longer ones than the 98th percentile have the maximum length.
void append_arrows(const Mesh& mesh, const Field& field, double max_length,
                   std::vector<Mesh::Point>& endpoints)
{
  std::vector<double> lengths;
  for(auto f : mesh.faces())
    lengths.push_back(std::sqrt(field[f].squared_length()));
  std::vector<double> sorted = lengths;
  std::sort(sorted.begin(), sorted.end());
  const double reference_length = sorted[sorted.size() * 49 / 50];
  const std::size_t step = mesh.number_of_faces() / 1000 + 1;
  for(auto f : mesh.faces())
    if(const double length = lengths[f]; f % step == 0 && length > 0.12 * reference_length)
    {
      Kernel::Vector_3 center = CGAL::NULL_VECTOR;
      for(Vertex corner : mesh.vertices_around_face(mesh.halfedge(f)))
        center += (mesh.point(corner) - CGAL::ORIGIN) / 3.;
      endpoints.push_back(CGAL::ORIGIN + center);
      endpoints.push_back(CGAL::ORIGIN + center +
                          max_length * (std::min)(1. / length, 1. / reference_length) * field[f]);
    }
}

// Scales values such that the 2nd and the 98th percentile become -1 and 1, and clamps the others. At
// the endpoints of a flow, potentials are unbounded.
void normalize(const Mesh& mesh, Values& values)
{
  std::vector<double> sorted;
  for(Vertex v : mesh.vertices())
    sorted.push_back(values[v]);
  std::sort(sorted.begin(), sorted.end());
  const std::size_t rank = sorted.size() / 50;
  const double low = sorted[rank], high = sorted[sorted.size() - 1 - rank];
  for(Vertex v : mesh.vertices())
    values[v] = low < high ? std::clamp(2. * (values[v] - low) / (high - low) - 1., -1., 1.) : 0.;
}

// Writes a mesh and edges between additional vertices.
bool write_with_edges(const std::string& filename, Mesh& mesh,
                      const std::vector<Mesh::Point>& endpoints)
{
  const std::size_t first = mesh.number_of_vertices();
  for(const Mesh::Point& p : endpoints)
    mesh.add_vertex(p);
  std::ostringstream ply;
  CGAL::IO::write_PLY(ply, mesh);
  std::string text = ply.str();
  text.insert(text.find("end_header"), "element edge " + std::to_string(endpoints.size() / 2) +
                                           "\nproperty int vertex1\nproperty int vertex2\n");
  for(std::size_t i = 0; i < endpoints.size(); ++i)
    text += std::to_string(first + i) + (i % 2 == 0 ? ' ' : '\n');
  return bool(std::ofstream(filename) << text);
}

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
  Values gradient_potential = mesh.add_property_map<Vertex, double>("v:f").first,
         rotation_potential = mesh.add_property_map<Vertex, double>("v:g").first;
  GP::Region_transport_solver<Mesh> solver(mesh, to);
  std::cout << "Transport distance to the nearest target: " << solver.compute(from).value << ".\n";
  solver.write_flow(field[0]);
  GP::hodge_decomposition(solver.domain(), field[0], field[1], field[2], field[3],
                          GP::parameters::gradient_potential_map(gradient_potential)
                              .vertex_rotation_potential_map(rotation_potential));
  normalize(mesh, gradient_potential);
  normalize(mesh, rotation_potential);

  // Writes one copy of the mesh per field, and the two potentials in a second row.
  Values potential = mesh.add_property_map<Vertex, double>("v:potential", no_value).first;
  output.add_property_map<Vertex, double>("v:potential", no_value);
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double width = box.xmax() - box.xmin(), height = box.ymax() - box.ymin(),
               total_squared_norm = squared_norm(mesh, field[0]);
  const auto move = [&](double columns, double rows)
  {
    for(Vertex v : mesh.vertices())
      mesh.point(v) += Kernel::Vector_3(1.1 * columns * width, -1.3 * rows * height, 0.);
  };
  std::vector<Mesh::Point> endpoints;
  const char* const title[] = {"flow", "gradient component", "rotational component",
                               "harmonic component"};
  for(std::size_t i = 0; i < 4; ++i)
  {
    // Fields with a relative squared norm of at most 1e-9 are round-off errors and are not drawn.
    const double fraction = squared_norm(mesh, field[i]) / total_squared_norm;
    if(fraction > 1e-9)
      append_arrows(mesh, field[i], 0.05 * width, endpoints);
    std::cout << 100. * fraction << " % of the squared norm: " << title[i] << '\n';
    output += mesh;
    if(fraction > 1e-9 && (i == 1 || i == 2))
    {
      move(0., 1.);
      for(Vertex v : mesh.vertices())
        potential[v] = i == 1 ? gradient_potential[v] : rotation_potential[v];
      output += mesh;
      for(Vertex v : mesh.vertices())
        potential[v] = no_value;
      move(0., -1.);
    }
    move(1., 0.);
  }
  return write_with_edges(argv[argc - 1], output, endpoints) ? EXIT_SUCCESS : EXIT_FAILURE;
}
