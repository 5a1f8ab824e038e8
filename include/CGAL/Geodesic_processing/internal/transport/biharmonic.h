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

// Computes biharmonic distances (Lipman, Rustamov and Funkhouser 2010). The squared distance is the
// integral of the squared difference of two Green's functions of the Laplacian, with Neumann
// boundary conditions. They are a metric, but not lengths of paths.
class CGAL_GEODESIC_PROCESSING_EXPORT Biharmonic_distances
{
public:
  // Throws Unsupported_surface_error if no triangle has positive area.
  explicit Biharmonic_distances(const Surface_arrays& triangles);

  // Returns the distances of all pairs of columns, each of total mass 1. The result is symmetric.
  // Distances between components are infinite.
  Matrix all_pairs(const Masses& masses) const;

  // Returns the distances from a column to all vertices. A vertex of another component or without a
  // triangle has infinite distance. The first call solves one system per vertex, later calls two.
  Vector one_to_all(const Masses& source, unsigned number_of_threads) const;

private:
  Operators m_operators;
  std::vector<Index> m_component; // #vertices
  std::size_t m_number_of_components = 0;
  Vector m_mass;           // #vertices
  Vector m_component_mass; // #components
  std::unique_ptr<Poisson_solver> m_solver;
  mutable std::once_flag m_squares_computed;
  mutable Vector
      m_squared_distances; // #vertices: squared distance to the pinned vertex of the component

  Matrix green_functions(const Masses& masses) const;
  Matrix component_masses(const Masses& masses) const;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_BIHARMONIC_H
