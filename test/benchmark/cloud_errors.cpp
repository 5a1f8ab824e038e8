// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares distances on clouds with exact distances. The surfels are the vertices of meshes with
// vertex normals.
#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>

#include "models.h"
#include "report.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace {

namespace GP = CGAL::Geodesic_processing;
using namespace benchmarks;
using Cloud = CGAL::Point_set_3<Kernel::Point_3>;

// Adds a row with the errors of a method at vertices that are farther than 5 % of the largest
// distance, from five sources.
template <typename Method>
void add_row(Table& table, const std::string& name, const std::string& method, const Mesh& mesh,
             const Cloud& cloud)
{
  GP::Geodesic_distance_solver<Mesh, GP::Exact> exact(mesh);
  GP::Geodesic_distance_solver<Cloud, Method> solver(cloud);
  Mean_and_max errors;
  std::size_t unreached = 0;
  for(std::size_t k = 0; k < 5; ++k)
  {
    const std::size_t source = k * mesh.number_of_vertices() / 5;
    exact.compute(Vertex(Mesh::size_type(source)));
    solver.compute(Cloud::Index(source));
    double farthest = 0.;
    for(const Vertex v : exact.reached())
      farthest = std::max(farthest, exact.distance(v));
    for(const Vertex v : exact.reached())
      if(exact.distance(v) > 0.05 * farthest)
      {
        const double found = solver.distance(Cloud::Index(std::size_t(v)));
        if(std::isinf(found))
        {
          ++unreached;
          continue;
        }
        errors.add(std::abs(found / exact.distance(v) - 1.));
      }
  }
  table.add({name, std::to_string(cloud.size()), method, format_fixed(100. * errors.mean, 2),
             format_fixed(100. * errors.largest, 1), std::to_string(unreached)});
}

} // namespace

int main()
{
  Table table("errors on clouds", {"cloud", "surfels", "method", "mean error %", "largest error %",
                                   "unreached surfels"});
  for(const char* const name :
      {"bunny_37k", "nefertiti_35k", "kitten_9k", "eight_5k", "human_woman_7k", "elephant_2k8"})
  {
    const std::optional<Mesh> mesh = load_model(name);
    if(!mesh)
      continue;
    Cloud cloud(true);
    for(const Vertex v : mesh->vertices())
      cloud.insert(mesh->point(v), CGAL::Polygon_mesh_processing::compute_vertex_normal(v, *mesh));
    add_row<GP::Euclidean_front>(table, name, "Euclidean_front", *mesh, cloud);
    add_row<GP::Fast_marching>(table, name, "Fast_marching", *mesh, cloud);
    add_row<GP::Dijkstra>(table, name, "Dijkstra", *mesh, cloud);
  }
  table.print();
}
