// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_SPANNING_FOREST_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_SPANNING_FOREST_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Bounds the cost of moving small masses, for example round-off errors, without a linear system:
// they move along the edges of a breadth-first tree of each component.
class CGAL_GEODESIC_PROCESSING_EXPORT Spanning_forest
{
public:
  // Triangles of area zero are ignored. O(n)
  explicit Spanning_forest(const Operators& operators);

  // Returns the cost of moving masses, which sum to zero on each component. Some field whose
  // divergence is the masses does not cost more: a function of slope one changes along an edge by
  // at most the length of the edge. O(n)
  //
  // masses  #vertices
  double cost(Vector masses) const;

private:
  std::vector<Index> m_order;            // all vertices, each after its parent
  std::vector<Index> m_parent;           // #vertices: `none` for a root
  std::vector<double> m_parent_distance; // #vertices: length of the edge to the parent
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_TRANSPORT_SPANNING_FOREST_H
