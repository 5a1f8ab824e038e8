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
#include <utility>
#include <vector>

// Fields that transport given masses and depend linearly on them.
//
// In this file, a field is a column of 2 #triangles numbers: the first components of all vectors,
// then the second components. Each vector is multiplied by the square root of the area of its
// triangle. Hence the inner product of two fields is that of their columns.

namespace CGAL::Geodesic_processing::internal {

// The two kinds of particular fields.
enum class Particular_field
{
  gradient,      // the gradient of the solution of Poisson's equation
  raviart_thomas // a Raviart-Thomas field with balanced fluxes, evaluated at the centroids
};

// Masses at vertices: #vertices by #distributions.
using Masses = Eigen::SparseMatrix<double>;

// Returns one column with a unit mass for each location. Inside a triangle, the mass is distributed
// to the corners by the barycentric coordinates.
CGAL_GEODESIC_PROCESSING_EXPORT
Masses masses_at(const Surface_arrays& triangles, const std::vector<Surface_location>& locations);

// Converts a field to a column.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector as_column(const Operators& operators, const Field& field);
// Converts a column to a field. A triangle without area gets the vector 0.
CGAL_GEODESIC_PROCESSING_EXPORT
Field as_field(const Operators& operators, const Vector& column);

// Computes the gradients of functions, one in each column.
CGAL_GEODESIC_PROCESSING_EXPORT
Matrix gradients(const Operators& operators, const Matrix& functions);

// Computes one field for each distribution of masses, by linear maps that are prepared once. The
// cost of a column is one solution of a sparse system, and for `raviart_thomas` one traversal of a
// tree.
class CGAL_GEODESIC_PROCESSING_EXPORT Particular_fields
{
public:
  // The kind is changed to `gradient` on a cloud, whose triangles have no twins. It is also changed
  // if some component consists of pieces that are connected only by a vertex. Gradients are
  // orthogonal to harmonic fields, which are then computed on request only. Throws
  // Unsupported_surface_error if harmonic fields need more than 2 GB.
  Particular_fields(const Surface_arrays& triangles, const Operators& operators,
                    Particular_field kind, bool with_harmonic_fields = true);
  ~Particular_fields();

  Particular_field kind() const { return m_kind; }
  std::size_t number_of_harmonic_fields() const { return std::size_t(m_harmonic.cols()); }
  const Matrix& harmonic_fields() const { return m_harmonic; } // orthonormal; empty on a cloud
  const std::vector<Index>& component() const { return m_component; } // #vertices

  // Returns the field of each column of masses: minus_divergence() of the field is the column. If a
  // column does not sum to zero on a component, the remainder is absorbed at a fixed vertex or
  // triangle of the component. Differences of such fields are still correct. The result is
  // orthogonal to harmonic fields and to rotated gradients of functions that vanish on the
  // boundary.
  //
  // If the kind is `gradient`, the field balances the masses at the vertices. If it is
  // `raviart_thomas`, it balances the masses after they are spread uniformly over the incident
  // triangles: the divergence in a triangle is the mass density.
  Matrix fields(const Masses& masses) const;

  // Returns minus_divergence() of the field of one distribution. This is equal to the masses, or to
  // the masses after spreading.
  Vector balanced(const Vector& masses) const;

  // Calls use(j, field) for each column j in turn. Use this function if storing all fields takes
  // longer than computing them.
  void for_each_field(const Masses& masses,
                      const std::function<void(Eigen::Index, const Vector&)>& use) const;

  // Subtracts from each column its gradient part.
  Matrix without_gradients(const Matrix& columns) const;

private:
  struct Tree;
  using Sparse_field = std::vector<std::pair<Index, Vec2>>; // a triangle can occur twice

  // Returns the stream function of the projection of each field onto rotated gradients.
  Matrix stream_functions(const std::vector<Sparse_field>& fields) const;

  const Surface_arrays& m_triangles;
  const Operators& m_operators;
  Particular_field m_kind;
  std::vector<Index> m_component;
  std::unique_ptr<Poisson_solver> m_poisson_solver;
  std::unique_ptr<Sparse_solver> m_inner_solver; // for functions that vanish on the boundary
  std::vector<bool> m_is_boundary;               // #vertices
  std::unique_ptr<Tree> m_tree;
  std::vector<std::array<Vec2, 2>>
      m_hat_gradients; // #triangles: weighted gradients of the hat functions of corners 1 and 2
  Vector m_ring_area;  // #vertices: area of the incident triangles
  Matrix m_harmonic;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_PARTICULAR_FIELDS_H
