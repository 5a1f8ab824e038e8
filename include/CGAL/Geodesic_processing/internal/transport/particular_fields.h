// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_PARTICULAR_FIELDS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_PARTICULAR_FIELDS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/numerics/dense_product.h>
#include <CGAL/Geodesic_processing/internal/operators/Poisson_solver.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

// Fields that transport masses and depend linearly on them.
//
// Fields are columns here: the first components in all triangles, then the second ones, each times the
// root of the triangle's area; so inner products are those of columns.

namespace CGAL::Geodesic_processing::internal {

enum class Particular_field
{
  gradient,      // of the solution of Poisson's equation
  raviart_thomas // in the middles of triangles, of a field whose flow across sides is balanced
};

// Masses at sites, a column for each distribution.
using Masses = Eigen::SparseMatrix<double>;

// A unit of mass at each location, shared by the corners of its triangle as its barycentric coordinates
// are.
CGAL_GEODESIC_PROCESSING_EXPORT
Masses masses_at(const Surface_arrays& triangles, const std::vector<Surface_location>& locations);

CGAL_GEODESIC_PROCESSING_EXPORT
Vector as_column(const Operators& operators, const Field& field);
CGAL_GEODESIC_PROCESSING_EXPORT
Field as_field(const Operators& operators, const Vector& column);

// The gradients of functions, one in each column.
CGAL_GEODESIC_PROCESSING_EXPORT
Matrix gradients(const Operators& operators, const Matrix& functions);

class CGAL_GEODESIC_PROCESSING_EXPORT Particular_fields
{
public:
  // Gradients where there is no other way: on clouds, where nothing is glued, and where a component
  // falls apart into pieces that meet at sites alone.  Gradients are orthogonal to harmonic fields
  // anyway: then these are found only on request.  Throws Unsupported_surface_error when they would take
  // more than 2 GB.
  Particular_fields(const Surface_arrays& triangles, const Operators& operators,
                    Particular_field kind, bool with_harmonic_fields = true);
  ~Particular_fields();

  Particular_field kind() const { return m_kind; }
  std::size_t number_of_harmonic_fields() const { return std::size_t(m_harmonic.cols()); }
  const Matrix& harmonic_fields() const { return m_harmonic; } // orthonormal; none of a cloud
  const std::vector<Index>& component() const { return m_component; } // #sites

  // Of masses that are missing at sites, as columns, each up to a field of the component alone when they
  // do not sum to zero there.  Orthogonal to the harmonic fields and to rotated gradients of functions
  // that vanish on the border.
  //
  // `gradient` balances the masses at sites, `raviart_thomas` the same ones after each was spread evenly
  // over the triangles around its site: then no triangle gains or loses anything but its share.
  Matrix fields(const Masses& masses) const;

  // The divergence of the field of one distribution: its masses, or what they are after they were spread.
  Vector balanced(const Vector& masses) const;

  // Hands the field of each column over in turn, with the column's number, where keeping all of them at
  // once would take longer than computing them.
  void for_each_field(const Masses& masses,
                      const std::function<void(Eigen::Index, const Vector&)>& use) const;

  // What is orthogonal to gradients, of columns.
  Matrix without_gradients(const Matrix& columns) const;

private:
  struct Tree;

  const Surface_arrays& m_triangles;
  const Operators& m_operators;
  Particular_field m_kind;
  std::vector<Index> m_component;
  std::unique_ptr<Poisson_solver> m_poisson_solver;
  std::unique_ptr<Sparse_solver> m_inner_solver; // of functions that vanish on the border
  std::vector<bool> m_is_border;                 // #sites
  std::unique_ptr<Tree> m_tree;
  std::vector<std::array<Vec2, 2>>
      m_hat_gradients; // #triangles: gradients of corners 1 and 2, as columns
  Vector m_ring_area;  // #sites: the area of the triangles around each
  Matrix m_harmonic;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_PARTICULAR_FIELDS_H
