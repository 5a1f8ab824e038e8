// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BENCHMARK_MODELS_H
#define CGAL_GEODESIC_PROCESSING_BENCHMARK_MODELS_H

#include "triangulations.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// Meshes of the benchmarks, and reference distances on them.

namespace benchmarks {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

inline Mesh mesh_of(const CGAL::Geodesic_processing::test::Triangulation& surface)
{
  Mesh mesh;
  mesh.reserve(Mesh::size_type(surface.points.size()),
               Mesh::size_type(surface.corners.size() * 3 / 2 / 3 + surface.points.size()),
               Mesh::size_type(surface.corners.size() / 3));
  for(const auto& p : surface.points)
    mesh.add_vertex({p[0], p[1], p[2]});
  for(std::size_t c = 0; c < surface.corners.size(); c += 3)
    mesh.add_face(Vertex(surface.corners[c]), Vertex(surface.corners[c + 1]),
                  Vertex(surface.corners[c + 2]));
  return mesh;
}

// Returns the vertices and faces of a triangle mesh as arrays.
inline CGAL::Geodesic_processing::test::Triangulation triangulation_of(const Mesh& mesh)
{
  CGAL::Geodesic_processing::test::Triangulation result;
  for(const Vertex v : mesh.vertices())
    result.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  for(const Face f : mesh.faces())
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      result.corners.push_back(CGAL::Geodesic_processing::internal::Index(v));
  return result;
}

// Returns a unit sphere with 10 * 4^level + 2 vertices.
inline Mesh icosphere(unsigned level)
{
  return mesh_of(CGAL::Geodesic_processing::test::icosphere(level));
}

// Returns the unit square with n x n vertices and a random diagonal in each cell. Each vertex is
// displaced by up to a quarter of a step, the largest displacement that cannot invert a triangle.
inline Mesh jittered_square(std::size_t n)
{
  return mesh_of(CGAL::Geodesic_processing::test::square(n - 1, 0.25));
}

// Returns `mesh` with each face split into four at the edge midpoints. The surface is unchanged,
// and the vertices of `mesh` keep their indices.
inline Mesh refined(const Mesh& mesh)
{
  Mesh result;
  const auto edges = Mesh::size_type(num_edges(mesh)), faces = Mesh::size_type(num_faces(mesh));
  const auto vertices = Mesh::size_type(num_vertices(mesh));
  result.reserve(vertices + edges, 2 * edges + 3 * faces, 4 * faces);
  for(const Vertex v : mesh.vertices())
    result.add_vertex(mesh.point(v));
  for(const auto e : mesh.edges())
    result.add_vertex(midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  for(const Face f : mesh.faces())
  {
    std::array<Vertex, 3> corner, middle; // middle[i] follows corner[i] on the boundary
    auto h = mesh.halfedge(f);
    for(int i = 0; i < 3; ++i, h = mesh.next(h))
    {
      corner[i] = mesh.source(h);
      middle[i] = Vertex(vertices + Mesh::size_type(mesh.edge(h)));
    }
    for(int i = 0; i < 3; ++i)
      result.add_face(corner[i], middle[i], middle[(i + 2) % 3]);
    result.add_face(middle[0], middle[1], middle[2]);
  }
  return result;
}

// Returns the mesh `name` of the data folder, or nothing if it cannot be read.
inline std::optional<Mesh> load_model(const std::string& name)
{
  const std::filesystem::path data_folder = GEODESIC_PROCESSING_DATA;
  for(const std::string subfolder : {"meshes/", "patches/"})
    for(const std::string extension : {".ply", ".off"})
    {
      const auto file = data_folder / (subfolder + name + extension);
      Mesh mesh;
      if(exists(file) && CGAL::IO::read_polygon_mesh(file.string(), mesh) && !is_empty(mesh))
        return mesh;
    }
  return std::nullopt;
}

inline double mean_edge_length(const Mesh& mesh)
{
  double sum = 0.;
  for(const auto e : mesh.edges())
    sum +=
        std::sqrt(squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / double(num_edges(mesh));
}

// Returns the fraction of obtuse faces.
inline double obtuse_face_ratio(const Mesh& mesh)
{
  std::size_t number = 0;
  for(const Face f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const auto &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
               &r = mesh.point(mesh.target(mesh.next(h)));
    if((q - p) * (r - p) < 0. || (r - q) * (p - q) < 0. || (p - r) * (q - r) < 0.)
      ++number;
  }
  return double(number) / double(num_faces(mesh));
}

inline std::vector<Vertex> three_sources(std::size_t number_of_vertices)
{
  const auto n = Mesh::size_type(number_of_vertices);
  return {Vertex(0), Vertex(n / 3), Vertex(Mesh::size_type(2 * std::size_t(n) / 3))};
}

// Reference distances from `source`, one per vertex. They are computed by closed forms on the
// sphere and the square, and by CGAL's exact algorithm on other meshes.

inline std::vector<double> great_circle_distances(const Mesh& sphere, Vertex source)
{
  const auto s = sphere.point(source) - CGAL::ORIGIN;
  std::vector<double> result;
  for(const Vertex v : sphere.vertices())
  {
    const auto p = sphere.point(v) - CGAL::ORIGIN;
    const auto across = cross_product(s, p);
    result.push_back(std::atan2(std::sqrt(across * across), s * p));
  }
  return result;
}

inline std::vector<double> euclidean_distances(const Mesh& square, Vertex source)
{
  std::vector<double> result;
  for(const Vertex v : square.vertices())
    result.push_back(std::sqrt(squared_distance(square.point(source), square.point(v))));
  return result;
}

inline std::vector<double> exact_distances(const Mesh& mesh, Vertex source)
{
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
  CGAL::Surface_mesh_shortest_path<Traits> paths(mesh);
  paths.add_source_point(source);
  std::vector<double> result;
  for(const Vertex v : mesh.vertices())
    result.push_back(paths.shortest_distance_to_source_points(v).first);
  return result;
}

} // namespace benchmarks

#endif // CGAL_GEODESIC_PROCESSING_BENCHMARK_MODELS_H
