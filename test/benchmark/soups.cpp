// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the time in which domains of polygon soups are built. --quick: small meshes only.
#include "models.h"
#include "report.h"

#include <CGAL/Geodesic_processing/Soup_domain.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <array>
#include <cstdio>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

using Polygon = std::array<std::size_t, 3>;

struct Soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<Polygon> triangles;
};

// Returns the points and faces of a mesh.
Soup soup_of(const Mesh& mesh)
{
  Soup result;
  for(const Vertex v : mesh.vertices())
    result.points.push_back(mesh.point(v));
  for(const Face f : mesh.faces())
  {
    Polygon triangle;
    std::size_t corner = 0;
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      triangle[corner++] = v;
    result.triangles.push_back(triangle);
  }
  return result;
}

// Returns the mesh of a soup that needs no repair.
Mesh mesh_of(const Soup& soup)
{
  Mesh mesh;
  mesh.reserve(Mesh::size_type(soup.points.size()),
               Mesh::size_type(soup.points.size() + soup.triangles.size()),
               Mesh::size_type(soup.triangles.size()));
  for(const auto& p : soup.points)
    mesh.add_vertex(p);
  for(const Polygon& triangle : soup.triangles)
    mesh.add_face(Vertex(triangle[0]), Vertex(triangle[1]), Vertex(triangle[2]));
  return mesh;
}

// Returns the soup with three points for each triangle, as in an STL file. Each second triangle, on
// average, is reversed.
Soup torn(const Soup& soup)
{
  Soup result;
  std::mt19937 random(1);
  for(const Polygon& triangle : soup.triangles)
  {
    const std::size_t first = result.points.size();
    for(const std::size_t corner : triangle)
      result.points.push_back(soup.points[corner]);
    result.triangles.push_back({first, first + 1, first + 2});
    if(random() % 2 == 0)
      std::swap(result.triangles.back()[0], result.triangles.back()[1]);
  }
  return result;
}

// Returns the median of the seconds of several calls.
template <typename Function>
double seconds(const Function& f)
{
  std::vector<double> times;
  for(int i = 0; i < 5; ++i)
    times.push_back(cpu_seconds(f));
  return median(times);
}

// Returns the seconds in which CGAL makes a mesh of a soup. Its functions change their arguments.
double seconds_of_cgal(const Soup& soup, bool is_clean)
{
  std::vector<double> times;
  for(int i = 0; i < 5; ++i)
  {
    Soup copy = soup;
    times.push_back(cpu_seconds(
        [&]
        {
          Mesh mesh;
          if(!is_clean)
            PMP::repair_polygon_soup(copy.points, copy.triangles);
          PMP::orient_polygon_soup(copy.points, copy.triangles);
          PMP::polygon_soup_to_polygon_mesh(copy.points, copy.triangles, mesh);
        }));
  }
  return median(times);
}

void add_row(const std::string& name, const Mesh& mesh, Table& table)
{
  const Soup clean = soup_of(mesh), pieces = torn(clean);
  const double of_mesh = seconds([&] { GP::make_domain(mesh_of(clean)); }),
               of_clean = seconds([&] { GP::make_domain(clean.points, clean.triangles); }),
               of_pieces = seconds(
                   [&] {
                     GP::make_domain(pieces.points, pieces.triangles,
                                     GP::parameters::merge_tolerance(0.));
                   });
  const double cgal_clean = seconds_of_cgal(clean, true),
               cgal_pieces = seconds_of_cgal(pieces, false);
  table.add({name, std::to_string(mesh.number_of_faces()), format_fixed(1e3 * of_mesh, 0),
             format_fixed(1e3 * of_clean, 0), format_fixed(of_clean / of_mesh, 2),
             format_fixed(1e3 * cgal_clean, 0), format_fixed(1e3 * of_pieces, 0),
             format_fixed(1e3 * cgal_pieces, 0), format_fixed(cgal_pieces / of_pieces, 1)});
}

} // namespace

int main(int argc, char* argv[])
{
  const bool is_quick = argc > 1 && std::string(argv[1]) == "--quick";
  std::printf("Domains of polygon soups: milliseconds\n\n");
  Table table("milliseconds", {"soup", "faces", "mesh", "arrays", "arrays/mesh", "CGAL arrays",
                               "torn", "CGAL torn", "CGAL/torn"});
  for(const unsigned level : {4u, 6u, 7u})
    if(!is_quick || level == 4)
      add_row("icosphere " + std::to_string(level), icosphere(level), table);
  for(const std::size_t n : {100u, 500u})
    if(!is_quick || n == 100)
      add_row("square " + std::to_string(n), jittered_square(n), table);
  table.print();
}
