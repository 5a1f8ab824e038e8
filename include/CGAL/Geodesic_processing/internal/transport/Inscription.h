// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_INSCRIPTION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_INSCRIPTION_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>
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
class CGAL_GEODESIC_PROCESSING_EXPORT Inscription
{
public:
  // curves  polylines, consecutive locations in a common triangle; one location: a point
  // whole   sites; sides between two of them need not be divided
  //
  // No other side joins two sites of curves, or one to those of `whole`: it is divided in two.  What
  // comes closer than 1e-10 of a side to a side or to a site is moved there.
  Inscription(std::shared_ptr<const Glued_triangles> triangles,
              const std::vector<std::vector<Location>>& curves, const std::vector<Index>& whole);

  const std::shared_ptr<const Glued_triangles>& triangles() const { return m_fine; }

  // #curves: the sites along each, in no order.
  const std::vector<std::vector<Index>>& sites() const { return m_sites; }

  // Where a location in a triangle lies then.
  Location refined(const Location& location) const;
  // The same function, linear in each of the coarse triangles.
  Vector refined(const Vector& function) const;
  Mass_distribution refined(const Mass_distribution& masses) const;
  std::vector<Tensor> refined(const std::vector<Tensor>& measure) const;

  // The field's means over the parts of each triangle.
  Field coarsened(const Field& fine) const;
  // Those of new sites shared by the corners of the triangle where they are: the integral of each function
  // that is linear in coarse triangles is the same.
  Vector coarsened(const Vector& masses) const;

private:
  // A triangle of those that another one was divided into.
  struct Part
  {
    Index triangle, whole;
    std::array<std::array<double, 3>, 3> corner; // barycentric, in the whole
    Planar axis;                                 // of its plane, in that of the whole
  };

  std::shared_ptr<const Glued_triangles> m_coarse, m_fine;
  std::vector<std::vector<Index>> m_sites;
  std::vector<Location> m_added; // #new sites: where they are in the coarse triangles
  std::vector<Part> m_parts;     // one after another for each whole
  std::unordered_map<Index, std::size_t> m_first_part; // of a whole

  class Builder;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_INSCRIPTION_H
