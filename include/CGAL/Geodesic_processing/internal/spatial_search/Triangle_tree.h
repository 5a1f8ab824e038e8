// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_TRIANGLE_TREE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_TRIANGLE_TREE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <memory>

namespace CGAL::Geodesic_processing::internal {

// Finds the location on a mesh that is nearest to a point in space.  Copies share the tree.
class CGAL_GEODESIC_PROCESSING_EXPORT Triangle_tree
{
public:
  // O(n log n).
  explicit Triangle_tree(std::shared_ptr<const Surface_arrays> triangles);

  // point  in the caller's coordinates.
  // Throws Invalid_argument_error when a coordinate is not finite or the mesh is empty.
  Surface_location nearest(const std::array<double, 3>& point) const;

private:
  struct Tree;
  std::shared_ptr<const Surface_arrays> m_triangles;
  std::shared_ptr<const Tree> m_tree;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_SEARCH_TRIANGLE_TREE_H
