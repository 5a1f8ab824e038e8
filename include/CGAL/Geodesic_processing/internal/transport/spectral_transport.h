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

// Tolerance, limits and callback of Spectral_transport.
struct Spectral_transport_options
{
  double tolerance = 1e-3;            // of the gap between the bounds, relative to the upper bound
  unsigned maximum_iterations = 5000; // for each distance
  unsigned number_of_threads = 1;
  // Called with the fraction done, by one thread at a time. If it returns false, the computation is
  // cancelled.
  std::function<bool(double)> callback;
};

// Lower and upper bound of one transport distance, in the unit of the edge lengths.
struct Transport_bounds
{
  double lower = 0.;
  double upper = 0.; // infinite if masses differ on a component
  unsigned number_of_iterations = 0;

  double value() const { return 0.5 * (lower + upper); }
  bool are_within(double tolerance) const // relative to the upper bound
  {
    return lower == upper || upper - lower <= tolerance * upper;
  }
};

// The spectral transport distances d_k of Solomon, Rustamov, Guibas and Butscher 2014. The distance
// of two distributions is the minimum of the integral of |v + B c| over c. Here v is the particular
// field of their difference. B consists of the rotated gradients of k eigenfunctions and of the
// harmonic fields. If k = 0, B is empty (without harmonic fields) and d_0 is the integral of |v|.
//
// Since d_k is a quotient norm of the difference, it is a metric. It does not increase with k.
class CGAL_GEODESIC_PROCESSING_EXPORT Spectral_transport
{
public:
  // The number k is rounded up as in eigenfunctions(). On a cloud, the gradient part of the rotated
  // gradients is subtracted; on a mesh it is zero. Throws Unsupported_surface_error if no triangle
  // has positive area.
  Spectral_transport(std::shared_ptr<const Surface_arrays> triangles, std::size_t k,
                     Particular_field kind);
  ~Spectral_transport();

  std::size_t basis_size() const { return m_basis_size; } // k, rounded up
  Particular_field kind() const { return m_particular->kind(); }
  const Operators& operators() const { return m_operators; }

  // Computes bounds of the norm of each column, where `differences` are differences of two
  // distributions. The upper bound is the integral of |v + B c| for some c. The lower bound follows
  // by duality from a field orthogonal to B, divided by its maximum length. The bounds are infinite
  // if a column does not sum to zero on each component. The result is empty if the callback
  // cancelled.
  std::vector<Transport_bounds> distances(const Masses& differences,
                                          const Spectral_transport_options& options) const;

  // Computes the bounds for one difference of distributions, and the flow. There is no potential.
  // The callback receives the fraction of the maximum number of iterations; if it returns false,
  // the iteration stops. The residual compares the divergence of the flow with the masses that the
  // particular field balances.
  Transport_result transport(const Vector& masses, const Spectral_transport_options& options) const;

  // Returns the distances of all pairs of columns: symmetric, #columns by #columns. If k = 0,
  // fields are stored in single precision and the values are upper bounds. Otherwise each value is
  // the mean of both bounds. The result is empty if the callback cancelled.
  Matrix all_pairs(const Masses& masses, const Spectral_transport_options& options) const;

  // Returns upper bounds of the distances from a column to unit masses at all vertices, in single
  // precision. If k > 0, c is optimized on clusters, whose number is a tenth of that of the
  // triangles, with one mean vector in each. The integral for this c is then computed over all
  // triangles. A vertex of another component or without a triangle has infinite distance. The
  // result is empty if the callback cancelled.
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
  Vector m_sqrt_area; // #triangles: square roots of areas
  Matrix m_basis;     // orthonormal columns
  std::unique_ptr<Clusters> m_clusters;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_SPECTRAL_TRANSPORT_H
