// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_TRIANGLE_TREE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_TRIANGLE_TREE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <memory>

namespace CGAL::Geodesic_processing::internal {

// Computes the closest location of a mesh to a point in space, by CGAL's AABB tree of the
// triangles. Copies share the tree. Queries are thread-safe.
class CGAL_GEODESIC_PROCESSING_EXPORT Triangle_tree
{
public:
  // Builds the tree of all triangles with positive area. O(n log n).
  explicit Triangle_tree(std::shared_ptr<const Surface_arrays> triangles);

  // Returns the closest location to a point, which is given in the caller's coordinates. If no
  // triangle has a positive area, returns the closest vertex. Throws Invalid_argument_error if a
  // coordinate is not finite or the mesh has no vertices.
  Surface_location nearest(const std::array<double, 3>& point) const;

private:
  struct Tree;
  std::shared_ptr<const Surface_arrays> m_triangles;
  std::shared_ptr<const Tree> m_tree;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_TRIANGLE_TREE_H
