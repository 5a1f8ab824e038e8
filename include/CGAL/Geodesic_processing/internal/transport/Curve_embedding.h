// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CURVE_EMBEDDING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CURVE_EMBEDDING_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/transport/Mass_distribution.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <array>
#include <cstddef>
#include <memory>
#include <unordered_map>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Embeds curves into a surface: triangles that a curve crosses are subdivided, so that the curve
// runs along edges. Geodesic distances do not change. A vertex keeps its index, and new vertices
// follow. One subtriangle keeps the index of the triangle, and the others follow. The result has no
// coordinates.
//
// On a cloud, all triangles at an edge are subdivided at a point of the edge. Other triangles that
// overlap a location are not. Subtriangles keep the weight of their triangle. The result has no
// normals, and no edges in the graph. O(n log n) on a cloud.
class CGAL_GEODESIC_PROCESSING_EXPORT Curve_embedding
{
public:
  // curves  polylines; two consecutive locations must be in a common triangle; a single location is
  //   a point
  //
  // region_vertices  vertices of regions; an edge between two of them may stay
  //
  // If an edge is not part of a curve but has both ends on curves, it is split at its midpoint. An
  // edge from a curve vertex to a region vertex is split as well. Points closer than 1e-10 (in
  // barycentric coordinates) to an edge or vertex are moved onto it.
  Curve_embedding(std::shared_ptr<const Surface_arrays> triangles,
                  const std::vector<std::vector<Surface_location>>& curves,
                  const std::vector<Index>& region_vertices);

  // Returns the subdivided surface.
  const std::shared_ptr<const Surface_arrays>& triangles() const { return m_fine; }

  // Returns #curves lists: the vertices along each curve, in ascending order.
  const std::vector<std::vector<Index>>& vertices() const { return m_vertices; }

  // Returns the same location in the subdivided surface.
  Surface_location refined(const Surface_location& location) const;
  // Returns the same function on the subdivided surface. It is linear in each input triangle.
  Vector refined(const Vector& function) const;
  // Returns the same mass distribution on the subdivided surface.
  Mass_distribution refined(const Mass_distribution& masses) const;
  // Returns the same metric: one tensor for each triangle, rotated into the plane of the
  // subtriangle.
  std::vector<Metric_tensor> refined(const std::vector<Metric_tensor>& metric) const;

  // Returns the area-weighted mean over the subtriangles of each triangle.
  Field coarsened(const Field& fine) const;
  // Distributes the mass of each new vertex to the corners of its triangle, by barycentric
  // coordinates. The integral of every function that is linear in the triangles of the input is
  // preserved.
  Vector coarsened(const Vector& masses) const;

private:
  // One triangle of a subdivided triangle, the parent.
  struct Subtriangle
  {
    Index triangle, parent;
    std::array<std::array<double, 3>, 3> corner; // barycentric coordinates in the parent
    Vec2 axis; // direction of its halfedge 0 in the plane of the parent
  };

  std::shared_ptr<const Surface_arrays> m_coarse, m_fine;
  std::vector<std::vector<Index>> m_vertices;
  std::vector<Surface_location> m_new_locations; // #new vertices: locations in the input
  std::vector<Subtriangle> m_subtriangles;       // those of one parent are contiguous
  std::unordered_map<Index, std::size_t> m_subtriangles_begin; // key: index of the parent

  class Builder;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CURVE_EMBEDDING_H
