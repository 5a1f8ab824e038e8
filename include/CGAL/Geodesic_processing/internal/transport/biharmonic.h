// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_BIHARMONIC_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_BIHARMONIC_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/numerics/dense_product.h>
#include <CGAL/Geodesic_processing/internal/operators/Poisson_solver.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include <CGAL/Geodesic_processing/internal/transport/particular_fields.h>

#include <memory>
#include <mutex>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The distances of Lipman, Rustamov and Funkhouser 2010: the square of one is the integral of the square
// of the difference of two Green's functions of the Laplacian, with nothing flowing through the border.
// They are lengths, but not those of paths.
class CGAL_GEODESIC_PROCESSING_EXPORT Biharmonic_distances
{
public:
  // Throws Unsupported_surface_error when there is no triangle with an area.
  explicit Biharmonic_distances(const Surface_arrays& triangles);

  // Of all pairs of columns of masses, which are one in all; infinite between components.  Symmetric.
  Matrix all_pairs(const Masses& masses) const;

  // Of a column to all sites; infinite at those of other components and of no triangle.  The first call
  // solves a system for each site, the next ones two.
  Vector one_to_all(const Masses& source, unsigned threads) const;

private:
  Operators m_operators;
  std::vector<Index> m_component; // #sites
  std::size_t m_number_of_components = 0;
  Vector m_mass;           // #sites
  Vector m_component_mass; // #components
  std::unique_ptr<Poisson_solver> m_solver;
  mutable std::once_flag m_squares_computed;
  mutable Vector
      m_squared_distances; // #sites: of the distance to the site of the component that is held

  Matrix green_functions(const Masses& masses) const;
  Matrix component_masses(const Masses& masses) const;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_BIHARMONIC_H
