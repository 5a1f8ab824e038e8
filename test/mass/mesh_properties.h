// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_MASS_MESH_PROPERTIES_H
#define CGAL_GEODESIC_PROCESSING_TEST_MASS_MESH_PROPERTIES_H

#include "Results.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace mass_test {

// The topology of a surface. Components are connected by edges. The genus is the sum of the genera
// of all components.
struct Topology
{
  double components = 0., boundary_cycles = 0., genus = 0.;

  bool operator==(const Topology& other) const
  {
    return components == other.components && boundary_cycles == other.boundary_cycles &&
           genus == other.genus;
  }
};

// Computes the topology of a polygon soup with CGAL. Returns no value if it is not a polygon mesh.
std::optional<Topology> topology_of(const Soup& soup);

// Returns whether two faces of a triangle mesh intersect, other than at a common vertex or edge.
// The soup must be a polygon mesh. The test is exact.
bool intersects_itself(const Soup& soup);

// Returns whether the surface touches itself at a point: the point is on several faces that are not
// adjacent there, for example on both sides of a slit or of a sheet without thickness.
bool touches_itself_at(const Soup& soup, const Point& point);

// Returns the number of triangles with two corners at the same point, at which the input does not
// touch itself.
std::size_t number_of_degenerate_faces(const Soup& soup, const Soup& input);

// Returns the chart of each face. Faces with a common texture coordinate are in the same chart.
std::vector<std::size_t> charts(const Textured_mesh& mesh);

} // namespace mass_test

#endif // CGAL_GEODESIC_PROCESSING_TEST_MASS_MESH_PROPERTIES_H
