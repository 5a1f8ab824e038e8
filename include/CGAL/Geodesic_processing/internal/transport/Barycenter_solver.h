// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_BARYCENTER_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_BARYCENTER_SOLVER_H

#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include <CGAL/Geodesic_processing/transport_costs.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

class Spanning_forest;

// The iterate of a query, from which another query with as many masses can start.
struct Barycenter_state
{
  std::vector<Field> shrunk_flows; // #masses; empty: start from the weighted mean of the masses
  std::vector<Field> scaled_duals; // #masses
  Vector masses, mass_dual;        // #vertices
  double factor = 0.;              // shrinkage: |J| decreases by factor times the integral of |J|
};

struct Barycenter_options
{
  double tolerance = 1e-2;              // relative gap between the bounds: (upper - lower) / upper
  unsigned maximum_iterations = 0;      // 0 uses the default, 5000
  std::function<bool(double)> callback; // receives the progress in [0, 1]; returns false to cancel
  Barycenter_state warm_start;
};

// The bounds of a query (squared lengths times squared masses times weights) with the barycenter,
// and with the potentials and flows that certify the bounds.
struct Barycenter_result : Transport_barycenter_cost
{
  Vector masses;                  // #vertices: the barycenter
  std::vector<Field> flows;       // #masses: from the barycenter to each of the masses
  std::vector<Vector> potentials; // #masses: each increases along its flow
  Barycenter_state state;         // the final iterate
};

// Throws Invalid_argument_error if the number of weights is not `number`, a weight is negative or
// not finite, or all weights are zero.
CGAL_GEODESIC_PROCESSING_EXPORT
void check_weights(const std::vector<double>& weights, std::size_t number);

// Computes barycenters of masses m_i with weights w_i. If W is the earth mover's distance, the
// barycenter is the m >= 0 that minimizes the sum of w_i W(m, m_i)^2 (Solomon, Rustamov, Guibas
// and Butscher 2014):
//   minimize the sum of w_i (integral of |J_i|)^2 subject to divergence(J_i) = m_i - m for all i.
//
// Both bounds are certified. Every feasible m with flows J_i is an upper bound. For the lower
// bound, W^2 is the maximum of 2 (integral of phi (m_i - m)) - t^2 over functions with
// |gradient(phi)| <= t. Thus potentials phi_i of slopes t_i, with the best common factor, prove
// L^2 / (sum of w_i t_i^2). To compute L, subtract from the sum of w_i (integral of phi_i m_i) the
// maximum, over m, of the integral of (sum of w_i phi_i) m. This maximum is attained if the mass
// of each component is at the vertex with the largest sum of w_i phi_i.
//
// The method is ADMM.  Each step projects to the flows with a common m, then shrinks the flows and
// clamps the masses at zero. The projection uses two precomputed factorizations.
//
// Results scale with the units of length, mass and weight. Queries can run concurrently.
class CGAL_GEODESIC_PROCESSING_EXPORT Barycenter_solver
{
public:
  // Computes two factorizations. Throws Unsupported_surface_error if no triangle has an area.
  explicit Barycenter_solver(Operators operators);

  // Computes the barycenter of the given masses.
  //
  // masses   each #vertices, not negative; on each component all have the same sum, up to 1e-9
  // weights  #masses: not negative, not all zero
  // Throws Invalid_argument_error if masses or weights are invalid, or if the tolerance is not
  // positive.
  // An iteration is O(k n log n) for k masses.
  Barycenter_result solve(const std::vector<Vector>& masses, const std::vector<double>& weights,
                          const Barycenter_options& options = {}) const;

  const Operators& operators() const { return m_operators; }

private:
  class Admm;

  void check_input(const std::vector<Vector>& masses, const std::vector<double>& weights) const;
  void check_masses(const Vector& masses) const;
  std::vector<double> component_totals(const Vector& masses) const;

  Operators m_operators;
  std::vector<Index> m_component; // #vertices
  std::size_t m_number_of_components = 0;
  Vector m_lumped_mass; // #vertices: the integral of the hat function, positive
  double m_area = 0.;
  double m_stiffness = 0.; // weight of masses relative to flows in the projection: a squared length
  std::shared_ptr<const Spanning_forest> m_forest;
  std::unique_ptr<Sparse_solver> m_solver;        // of the Laplacian, pinned
  std::unique_ptr<Sparse_solver> m_damped_solver; // of the Laplacian plus lumped mass / stiffness
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_BARYCENTER_SOLVER_H
