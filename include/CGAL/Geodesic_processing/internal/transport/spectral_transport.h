// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_SPECTRAL_TRANSPORT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_SPECTRAL_TRANSPORT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/numerics/dense_product.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include <CGAL/Geodesic_processing/internal/transport/particular_fields.h>
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Spectral_transport_options
{
  double tolerance = 1e-3;            // of the gap between the bounds, relative to the upper one
  unsigned maximum_iterations = 5000; // of one distance
  unsigned threads = 1;
  std::function<bool(double)> callback; // gets the part that is done, by one thread at a time, and
                                        //   cancels by false
};

struct Transport_bounds
{
  double lower = 0.;
  double upper = 0.; // infinite where masses would have to leave a component
  unsigned iterations = 0;

  double value() const { return 0.5 * (lower + upper); }
  bool are_within(double tolerance) const // relative to the upper one
  {
    return lower == upper || upper - lower <= tolerance * upper;
  }
};

// The distances d_k of Solomon, Rustamov, Guibas and Butscher 2014 between distributions of mass: the
// least integral of |v + B c|, where v is the particular field of the difference of the two and B are
// the rotated gradients of k eigenfunctions and the harmonic fields.  For k = 0 nothing is sought: B is
// empty, harmonic fields are left out as well, and d_0 is the integral of |v|, also around handles and
// holes.  The least of a norm over a space is a norm of what is left: d_k is a metric, and it never grows
// with k.
class CGAL_GEODESIC_PROCESSING_EXPORT Spectral_transport
{
public:
  // k is rounded up as eigenfunctions() does.  On a cloud the rotated gradients are made free of
  // gradients, which they are on a mesh.  Throws Unsupported_surface_error when there is no triangle with
  // an area.
  Spectral_transport(std::shared_ptr<const Surface_arrays> triangles, std::size_t k,
                     Particular_field kind);
  ~Spectral_transport();

  std::size_t basis_size() const { return m_basis_size; } // k, rounded up
  Particular_field kind() const { return m_particular->kind(); }
  const Operators& operators() const { return m_operators; }

  // Of distributions, columns that sum to zero, from nothing: d_k between p and q is that of q - p.
  // Any c gives an upper bound; a field that is orthogonal to B, divided by its largest vector, a lower
  // one (by duality).  Empty when the callback cancelled it.
  std::vector<Transport_bounds> distances(const Masses& differences,
                                          const Spectral_transport_options& options) const;

  // The same of one distribution at sites, with the flow, and without a potential; the callback gets a
  // fraction of the iterations, and ends them by false.  What the flow has to move is known from the
  // particular field.
  Transport_result transport(const Vector& masses, const Spectral_transport_options& options) const;

  // Of all pairs of columns.  For k = 0 with floats for the fields; upper bounds then, and the middles
  // of the bounds for others.  Symmetric; empty when the callback cancelled it.
  Matrix all_pairs(const Masses& masses, const Spectral_transport_options& options) const;

  // Of a column to all sites: upper bounds, by floats.  For k > 0 c is sought with a tenth of the
  // triangles, clusters with the mean vectors in them; with it all triangles are summed up.  Infinite at
  // sites of other components, and at those of no triangle.  Empty when the callback cancelled it.
  Vector one_to_all(const Masses& source, const Spectral_transport_options& options) const;

private:
  struct Clusters;

  bool is_balanced(const Masses& differences, Eigen::Index column) const;
  std::vector<double> column_masses(const Masses& masses, Eigen::Index column) const;
  Float_matrix coarse_correction(const Float_matrix& fields) const;

  std::shared_ptr<const Surface_arrays> m_triangles;
  Operators m_operators;
  std::size_t m_number_of_components = 0;
  std::size_t m_basis_size = 0;
  std::unique_ptr<Particular_fields> m_particular;
  Vector m_sqrt_area; // #triangles: roots of areas
  Matrix m_basis;     // orthonormal columns
  std::unique_ptr<Clusters> m_clusters;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_SPECTRAL_TRANSPORT_H
