// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_REPAIR_SURFACE_H
#define GEODESIC_PROGRAM_REPAIR_SURFACE_H

#include "readers/Surface_file.h"

#include <CGAL/Geodesic_processing/Soup_domain.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <optional>
#include <string>

namespace program {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Cloud = CGAL::Point_set_3<Kernel::Point_3>;

// Returns the coordinates of a point or a vector.
template <typename Point_or_vector>
Point coordinates(const Point_or_vector& p)
{
  return {p.x(), p.y(), p.z()};
}

// An input after repair: a triangle mesh if the file has faces, otherwise a cloud with normals.
// Vertices keep their index in the file; none is added or removed.
struct Surface
{
  std::string name;
  Surface_file file; // oriented triangles, or points with unit normals
  // Of a mesh. Vertex i of its mesh is vertex i of the file. A vertex with several fans remains
  // one vertex, so that fronts propagate from fan to fan.
  std::optional<CGAL::Geodesic_processing::Soup_domain<Kernel::Point_3>> domain;
  bool is_repaired = false;

  bool is_mesh() const { return domain.has_value(); }
};

// Checks coordinates and indices, then repairs the surface. Throws Input_error. Does not access
// files.
Surface repair(Surface_file file, const std::string& name, unsigned threads = 1);

// Returns the cloud with normals and, if the file has it, the property "radius". Surfel i is point
// i of the file.
Cloud make_cloud(const Surface& surface);

} // namespace program

#endif // GEODESIC_PROGRAM_REPAIR_SURFACE_H
