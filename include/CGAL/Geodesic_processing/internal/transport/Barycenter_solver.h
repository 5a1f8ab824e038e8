// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_BARYCENTER_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_BARYCENTER_SOLVER_H

#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// What an iteration may start from where another one, for as many masses, ended.
struct Barycenter_state
{
  std::vector<Field> shrunk_flows,
      scaled_duals;         // #masses; empty: from the weighted mean of the masses
  Vector masses, mass_dual; // #sites
  double factor = 0.;       // of the integral of a flow's length: by how much vectors get shorter
};

struct Barycenter_options
{
  double tolerance = 1e-2;              // of the gap between the bounds, relative to the upper one
  unsigned maximum_iterations = 0;      // zero: as many as are usually needed at most
  std::function<bool(double)> callback; // gets a fraction from 0 to 1, ends the iterations by false
  Barycenter_state warm_start;
};

// In lengths of the domain squared, times masses squared and weights.
struct Barycenter_result
{
  double value = 0.;              // halfway between the bounds
  double lower = 0.;              // what the potentials prove
  double upper = 0.;              // what the flows cost
  Vector masses;                  // #sites: the barycenter
  std::vector<double> distances;  // #masses: what the flow to each costs
  std::vector<Field> flows;       // #masses: from the barycenter to each
  std::vector<Vector> potentials; // #masses: each grows along its flow
  unsigned iterations = 0;
  double residual = 0.; // largest error of the masses that a flow moves, relative to their sum
  bool converged = false;
  Barycenter_state state; // where the iteration ended
};

// Throws Invalid_argument_error when there are not as many weights, one is negative or not finite, or all are
// zero.
CGAL_GEODESIC_PROCESSING_EXPORT
void check_weights(const std::vector<double>& weights, std::size_t number);

// The barycenter of masses m_i, with weights w_i: the masses m >= 0 that minimize the sum of w_i W(m, m_i)^2,
// W the earth mover's distance (Solomon, Rustamov, Guibas and Butscher 2014):
//   minimize the sum of w_i (integral of |J_i|)^2 where divergence(J_i) = m_i - m for all i.
//
// Both bounds are certified.  Any such m and J_i are an upper one.  As W^2 is the largest of
// 2 (integral of phi over m_i - m) - t^2 where |gradient(phi)| <= t, any potentials phi_i of slopes t_i
// are a lower one, with their best common factor: L^2 over the sum of w_i t_i^2, where L is the sum of
// w_i (integral of phi_i over m_i), less the most that m may have of the sum of w_i phi_i, where that is
// highest on each component.
//
// By the alternating direction method of multipliers.  In turn the nearest flows that fit to one m, which
// two factorizations tell, and shorter vectors and masses that are not negative.
//
// Nothing depends on the units of lengths, masses and weights.  Queries may run in several threads.
class CGAL_GEODESIC_PROCESSING_EXPORT Barycenter_solver
{
public:
  // Throws Unsupported_surface_error when there is no triangle with an area.
  explicit Barycenter_solver(Operators operators);

  // masses   each #sites, not negative, with the same sum on each component up to 1e-9
  // weights  one for each, not negative, not all zero
  // Throws Invalid_argument_error when that is not so, or the tolerance not positive.
  Barycenter_result solve(const std::vector<Vector>& masses, const std::vector<double>& weights,
                          const Barycenter_options& options = {}) const;

  const Operators& operators() const { return m_operators; }

private:
  class Admm;

  void check_input(const std::vector<Vector>& masses, const std::vector<double>& weights) const;

  Operators m_operators;
  std::vector<Index> m_component; // #sites
  std::size_t m_number_of_components = 0;
  Vector m_lumped_mass;                    // #sites: the mass of a unit density, positive
  double m_area = 0., m_stiffness = 0.;    // of the masses as to flows: a length squared
  std::unique_ptr<Sparse_solver> m_solver; // of the Laplacian
  std::unique_ptr<Sparse_solver>
      m_damped_solver; // of the Laplacian plus the lumped masses over stiffness
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_BARYCENTER_SOLVER_H
