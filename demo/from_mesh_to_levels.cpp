// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What becomes of a mesh with a base: its places there, the base itself, and levels over it, side by side?
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace GP = CGAL::Geodesic_processing;

using Shares = std::array<double, 3>; // of the corners of a base face

// Those of the corners of a face: its part k keeps corner k, and corner k of the last lies across from it.
std::array<Shares, 3> corners(std::size_t face, unsigned level)
{
  if(level == 0)
    return {Shares{1., 0., 0.}, Shares{0., 1., 0.}, Shares{0., 0., 1.}};
  const std::array<Shares, 3> whole = corners(face / 4, level - 1);
  const std::size_t part = face % 4;
  std::array<Shares, 3> result;
  for(std::size_t k = 0; k < 3; ++k)
    for(std::size_t i = 0; i < 3; ++i)
      result[k][i] = part == 3 ? 0.5 * (whole[(k + 1) % 3][i] + whole[(k + 2) % 3][i])
                               : 0.5 * (whole[k][i] + whole[part][i]);
  return result;
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 4 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << "usage: from_mesh_to_levels MESH LEVELS RESULT.ply\n";
    return EXIT_FAILURE;
  }

  // The largest of the three shares: one at base vertices, a third in the middle of base faces.
  const auto share = mesh.add_property_map<Mesh::Vertex_index, double>("v:share", 1.).first;
  const GP::Base_parameterization<Mesh> base(mesh, 60);
  const auto largest = [](const Shares& s) { return *std::max_element(s.begin(), s.end()); };
  for(const auto v : mesh.vertices())
    share[v] = largest(base(v).barycentric);
  std::cout << base.number_of_base_faces() << " base faces, " << base.folds() << " folds.\n";

  Mesh row = mesh;
  const auto box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double step = 1.1 * (box.xmax() - box.xmin());
  for(unsigned level = 0; level < unsigned(std::atoi(argv[2])); ++level)
  {
    Mesh output;
    GP::semi_regular_remeshing(mesh, 60, level, output);
    std::cout << "Level " << level << " has " << num_faces(output) << " faces.\n";
    const auto own = output.add_property_map<Mesh::Vertex_index, double>("v:share", 0.).first;
    for(const auto f : output.faces())
    {
      std::size_t k = 0;
      for(const auto v : output.vertices_around_face(output.halfedge(f)))
        own[v] = largest(corners(f, level)[k++]);
    }
    for(const auto v : output.vertices())
      output.point(v) = output.point(v) + Kernel::Vector_3((level + 1) * step, 0., 0.);
    row += output;
  }
  return CGAL::IO::write_polygon_mesh(argv[3], row) ? EXIT_SUCCESS : EXIT_FAILURE;
}
