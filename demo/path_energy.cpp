// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shortens a path on a mesh and a path on a torus by their squared distances to the surface.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

namespace GP = CGAL::Geodesic_processing;

// Returns the shortest chain of edges between two vertices; empty if there is none.
std::vector<Point> chain_of_edges(const Mesh& mesh, Vertex from, Vertex to)
{
  GP::Geodesic_distance_solver<Mesh, GP::Dijkstra> solver(mesh);
  solver.compute(to);
  std::vector<Point> chain;
  if(std::isfinite(solver.distance(from)))
    chain.push_back(mesh.point(from));
  while(!chain.empty() && from != to)
  {
    // The distances decrease along the chain.
    Vertex next = from;
    double shortest = std::numeric_limits<double>::infinity();
    for(const Vertex v : CGAL::vertices_around_target(mesh.halfedge(from), mesh))
    {
      const double length = std::sqrt(CGAL::squared_distance(mesh.point(from), mesh.point(v)));
      if(length + solver.distance(v) < shortest && solver.distance(v) < solver.distance(from))
      {
        shortest = length + solver.distance(v);
        next = v;
      }
    }
    from = next;
    chain.push_back(mesh.point(from));
  }
  return chain;
}

double length(const std::vector<Point>& polyline)
{
  double sum = 0.;
  for(std::size_t i = 1; i < polyline.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(polyline[i - 1], polyline[i]));
  return sum;
}

// Returns a point of the torus with radii 1 and 0.4.
Point on_torus(double u, double v)
{
  const double r = 1. + 0.4 * std::cos(v);
  return Point(r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v));
}

Mesh make_torus()
{
  constexpr int along = 160, around = 64;
  Mesh mesh;
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < around; ++j)
      mesh.add_vertex(on_torus(2. * CGAL_PI * i / along, 2. * CGAL_PI * j / around));
  const auto vertex = [](int i, int j)
  { return Vertex(Mesh::size_type((i % along) * around + j % around)); };
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < around; ++j)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

// Writes a mesh to a PLY file, with the segments of polylines as edges.
bool write(const char* file, Mesh mesh, const std::vector<std::vector<Point>>& polylines)
{
  std::string edges;
  int number_of_edges = 0;
  for(const std::vector<Point>& polyline : polylines)
    for(std::size_t i = 0; i < polyline.size(); ++i)
    {
      const auto vertex = Mesh::size_type(mesh.add_vertex(polyline[i]));
      if(i > 0)
      {
        edges += std::to_string(vertex - 1) + ' ' + std::to_string(vertex) + '\n';
        ++number_of_edges;
      }
    }
  std::ostringstream ply;
  CGAL::IO::write_PLY(ply, mesh);
  std::string text = ply.str();
  text.insert(text.find("end_header"), "element edge " + std::to_string(number_of_edges) +
                                           "\nproperty int vertex1\nproperty int vertex2\n");
  return bool(std::ofstream(file) << text << edges);
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 5 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
    return std::cerr << "usage: path_energy MESH FROM TO RESULT.ply\n", EXIT_FAILURE;
  const Vertex from(Mesh::size_type(std::stoul(argv[2]))), to(Mesh::size_type(std::stoul(argv[3])));

  const std::vector<Point> chain = chain_of_edges(mesh, from, to);
  if(chain.size() < 2)
    return std::cerr << "no edges connect the vertices\n", EXIT_FAILURE;
  const Tree tree(faces(mesh).begin(), faces(mesh).end(), mesh);
  const auto path =
      GP::shorten_polyline(chain, [&](const Point& p) { return tree.squared_distance(p); });
  // The overload for meshes computes a locally shortest path near the same chain.
  const double exact = GP::shorten_polyline(mesh, chain).length;
  std::cout << "On the mesh, the chain of edges is " << length(chain) / exact
            << " times and the path of minimum energy " << path.distance / exact
            << " times as long as the locally shortest path near the chain.\n";

  // A curve that winds around the tube of the torus while it goes around the axis.
  std::vector<Point> drawn;
  for(int i = 0; i <= 200; ++i)
    drawn.push_back(on_torus(0.024 * i, 0.06 * i + 0.5 * std::sin(0.3 * i)));
  const auto winding = GP::shorten_polyline(drawn,
                                            [](const Point& p)
                                            {
                                              const double r = std::hypot(p.x(), p.y()) - 1.;
                                              const double height = std::hypot(r, p.z()) - 0.4;
                                              return height * height;
                                            });
  std::cout << "On the torus, the drawn curve has the length " << length(drawn)
            << ", and the geodesic near it " << winding.distance << ".\n";

  // Draws the torus beside the mesh, in the same size.
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double width = box.xmax() - box.xmin(), scale = width / 2.8;
  const Point center(box.xmax() + 0.6 * width, (box.ymin() + box.ymax()) / 2.,
                     (box.zmin() + box.zmax()) / 2.);
  const auto placed = [&](const Point& p)
  {
    // The axis of the torus is the y-axis of the mesh.
    return center + scale * Kernel::Vector_3(p.x(), -p.z(), p.y());
  };
  Mesh torus = make_torus();
  for(const Vertex v : torus.vertices())
    torus.point(v) = placed(torus.point(v));
  mesh += torus;
  std::vector<std::vector<Point>> polylines = {chain, path.points, drawn, winding.points};
  for(std::size_t i = 2; i < 4; ++i)
    for(Point& p : polylines[i])
      p = placed(p);
  return write(argv[4], mesh, polylines) ? EXIT_SUCCESS : EXIT_FAILURE;
}
