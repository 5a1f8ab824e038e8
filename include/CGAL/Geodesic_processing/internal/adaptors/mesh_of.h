// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_MESH_OF_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_MESH_OF_H

#include <CGAL/Geodesic_processing/Location.h>

namespace CGAL::Geodesic_processing::internal {

// Returns the mesh of a domain, or the mesh itself, for functions that require only its
// connectivity and property maps.
template <typename TriangleMesh>
const TriangleMesh& mesh_of(const TriangleMesh& mesh)
{
  return mesh;
}
template <typename TriangleMesh>
const TriangleMesh& mesh_of(const Mesh_domain<TriangleMesh>& domain)
{
  return domain.mesh();
}
template <typename Point>
const Surface_mesh<Point>& mesh_of(const Soup_domain<Point>& domain)
{
  return domain.mesh();
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_MESH_OF_H
