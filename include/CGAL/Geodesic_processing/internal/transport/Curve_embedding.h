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

// A mesh on which curves are drawn: triangles that one passes are divided such that it runs along sides.
// Distances on it are the same.  Sites keep their numbers, new ones follow; of a divided triangle one part
// has its number, the others follow.  Without coordinates.
class CGAL_GEODESIC_PROCESSING_EXPORT Curve_embedding
{
public:
  // curves  polylines, consecutive locations in a common triangle; one location: a point
  // whole   sites; sides between two of them need not be divided
  //
  // No other side joins two sites of curves, or one to those of `whole`: it is divided in two.  What
  // comes closer than 1e-10 of a side to a side or to a site is moved there.
  Curve_embedding(std::shared_ptr<const Surface_arrays> triangles,
                  const std::vector<std::vector<Surface_location>>& curves,
                  const std::vector<Index>& region_vertices);

  const std::shared_ptr<const Surface_arrays>& triangles() const { return m_fine; }

  // #curves: the sites along each, in no order.
  const std::vector<std::vector<Index>>& vertices() const { return m_vertices; }

  // Where a location in a triangle lies then.
  Surface_location refined(const Surface_location& location) const;
  // The same function, linear in each of the coarse triangles.
  Vector refined(const Vector& function) const;
  Mass_distribution refined(const Mass_distribution& masses) const;
  std::vector<Metric_tensor> refined(const std::vector<Metric_tensor>& metric) const;

  // The field's means over the parts of each triangle.
  Field coarsened(const Field& fine) const;
  // Those of new sites shared by the corners of the triangle where they are: the integral of each function
  // that is linear in coarse triangles is the same.
  Vector coarsened(const Vector& masses) const;

private:
  // A triangle of those that another one was divided into.
  struct Subtriangle
  {
    Index triangle, parent;
    std::array<std::array<double, 3>, 3> corner; // barycentric, in the whole
    Vec2 axis;                                   // of its plane, in that of the whole
  };

  std::shared_ptr<const Surface_arrays> m_coarse, m_fine;
  std::vector<std::vector<Index>> m_vertices;
  std::vector<Surface_location>
      m_new_locations;                     // #new sites: where they are in the coarse triangles
  std::vector<Subtriangle> m_subtriangles; // one after another for each whole
  std::unordered_map<Index, std::size_t> m_subtriangles_begin; // of a whole

  class Builder;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CURVE_EMBEDDING_H
