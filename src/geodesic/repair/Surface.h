// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_REPAIR_SURFACE_H
#define GEODESIC_PROGRAM_REPAIR_SURFACE_H

#include "io/Surface_file.h"
#include "repair/repair.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Surface_mesh.h>

namespace program {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Cloud = CGAL::Point_set_3<Kernel::Point_3>;

// Of a point or a vector.
template <typename Point_or_vector>
Point coordinates(const Point_or_vector& p)
{
  return {p.x(), p.y(), p.z()};
}

// An input after repair: a mesh of triangles where the file has faces, else a cloud with normals.
// Vertices keep the numbers that they have in the file; none is added or removed.
struct Surface
{
  std::string name;
  Surface_file file;         // triangles, oriented; or points with unit normals
  Connectivity connectivity; // of a mesh
  bool is_repaired = false;

  bool is_mesh() const { return file.number_of_polygons() > 0; }
};

Surface read_surface(const std::string& filename, unsigned threads = 1);

// The policy alone: checks coordinates and indices, then repairs.  Throws Input_error.
Surface repair(Surface_file file, const std::string& name, unsigned threads = 1);

// Vertex i of the result is vertex i of the file.  Vertices where several fans meet stay one
// vertex, so that a front passes from fan to fan.
Mesh make_mesh(const Surface& surface);

// With normals, and the file's property "radius" where it has one; surfel i is point i of the file.
Cloud make_cloud(const Surface& surface);

} // namespace program

#endif // GEODESIC_PROGRAM_REPAIR_SURFACE_H
