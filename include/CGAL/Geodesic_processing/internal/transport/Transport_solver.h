// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_TRANSPORT_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_TRANSPORT_SOLVER_H

#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include <CGAL/Geodesic_processing/internal/transport/Mass_distribution.h>
#include <CGAL/Geodesic_processing/internal/transport/admm.h>
#include <CGAL/Geodesic_processing/transport_costs.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Exit_groups;
class Spanning_forest;

enum class Transport_method
{
  interior_point,
  admm,
  weiszfeld
};

// The options of a query, for Transport_solver and Multilevel_transport_solver.
struct Transport_options
{
  Transport_method method = Transport_method::interior_point;
  double tolerance = 1e-3;              // relative gap between the bounds: (upper - lower) / upper
  unsigned maximum_iterations = 0;      // 0 uses the default of the method: 100, for `admm` 5000
  std::function<bool(double)> callback; // receives the progress in [0, 1]; returns false to cancel
  Admm::State warm_start;               // `admm` only: final state of an earlier query, or empty

  // Used by Multilevel_transport_solver only.
  bool do_normalize = false;        // scales both mass distributions to a total mass of one
  bool do_bound_from_above = false; // computes Transport_result::upper_continuous
};

// A vertex at which mass can leave the surface. If x leaves, 0 <= x <= capacity, the cost is
// price / 2 * x^2.
struct Exit
{
  Index vertex;    // at most one exit for each vertex
  double capacity; // positive, may be infinite
  double price;    // finite, not negative
};

// The bounds of a query (lengths times masses) with the potential and the flow that certify them.
// Transport_solver uses the unit of length of its operators. Multilevel_transport_solver uses the
// unit of the coordinates, and returns potential and flow on the vertices and triangles before
// refinement.
struct Transport_result : Earth_movers_cost
{
  Vector potential; // #vertices: increases along the flow, by at most 1 per unit of length
  Field flow;       // #triangles: mass per unit length of a line across it
  double remaining_cost = 0.; // the part of `upper` for the masses that the flow does not move
  Vector outflow;             // #exits: the mass that leaves through each; Transport_solver only
  Admm::State state;          // the final state of `admm`
  Vector arrivals;            // #vertices: mass that arrives in the region; solve_to_region() only
  Mass_distribution from, to; // as they were moved; of solve_to_region() only `from`
};

// Converts a result from the unit of the operators, of length `scale`, to the unit of the
// coordinates.
inline void rescale(Transport_result& result, double scale)
{
  for(double* cost : {&result.value, &result.lower, &result.upper, &result.upper_continuous,
                      &result.estimate, &result.remaining_cost})
    *cost *= scale;
  result.potential *= scale;
  for(Vec2& vector : result.flow)
    vector = (1. / scale) * vector;
}

// Computes the earth mover's distance whose cost is the length of paths, in Beckmann's
// formulation (Solomon, Rustamov, Guibas and Butscher 2014, without their spectral truncation).
// Over all fields J that are constant in each triangle,
//   minimize the integral of |J| subject to divergence(J) = b.
// The dual problem is to maximize the sum of b times phi subject to |gradient(phi)| <= 1 in each
// triangle.
//
// Both bounds are certified: every feasible J is an upper bound, and every phi, divided by its
// maximum slope, is a lower bound. Round-off errors, which are large if triangles are needles, make
// J slightly infeasible. The upper bound contains the cost of moving the missing masses along
// edges. A function phi of slope one changes no faster than the geodesic distance. Therefore the
// lower bound also holds for the distance on the surface itself. On smooth surfaces the distance is
// larger by O(edge length).
//
// The default method is a primal-dual interior point method for the second-order cone program:
// Nesterov-Todd scaling, Mehrotra's predictor and corrector, Gondzio's centrality corrector. The
// matrix of each iteration is a Laplacian with a tensor in each triangle. All of these matrices
// have one sparsity pattern, whose symbolic analysis is shared by all queries.
//
// To a gap of 0.1 percent, 5 to 9 iterations are needed between points of models of 6,000 to 40,000
// vertices, and 16 to 21 between smooth densities (test/benchmark/transport.cpp). O(n^1.5) each.
//
// Results scale with the units of length and mass. Queries can run concurrently.
class CGAL_GEODESIC_PROCESSING_EXPORT Transport_solver
{
public:
  // Factorizes the Laplacian. Throws Unsupported_surface_error if no triangle has an area.
  explicit Transport_solver(Operators operators);

  // Computes bounds, potential and flow for the given masses.
  //
  // masses  #vertices: target mass minus source mass. On each component they must sum to zero,
  //         up to 1e-9 of the sum of their absolute values.
  // exits   If a component has exits, its surplus of source mass leaves through them, and the
  //         bounds include the prices. The potential is then minus the marginal cost of mass
  //         that leaves. At an exit with capacity left it is -price * outflow, at a full exit it
  //         is at most this value. `interior_point` only.
  //
  // Throws Invalid_argument_error if a mass is not finite, if the masses do not sum to zero, or if
  // the tolerance is not positive. Throws it also if an exit is invalid, or if the exits of a
  // component have too little capacity.
  Transport_result solve(const Vector& masses, const Transport_options& options = {},
                         const std::vector<Exit>& exits = {}) const;

  // Returns the flow with the given divergence that minimizes the integral of its squared length.
  // The masses must sum to zero on each component. One back substitution.
  //
  // To make a field J feasible with the smallest correction, add the flow of the masses
  // masses - minus_divergence(J).
  Field least_squares_flow(const Vector& masses) const;

  const Operators& operators() const { return m_operators; }

private:
  void check_input(const Vector& masses, const std::vector<Exit>& exits) const;
  void check_totals(const Vector& masses, const std::vector<Exit>& exits) const;
  // Returns the result for masses that are all zero.
  Transport_result zero_result(std::size_t number_of_exits) const;
  // Subtracts from the potential of each component with exits their marginal cost.
  void shift_to_marginal_cost(const Exit_groups& groups, Vector& potential) const;

  Operators m_operators;
  Laplacian m_laplacian;
  std::vector<Index> m_component; // #vertices
  std::size_t m_number_of_components = 0;
  Sparse_matrix m_matrix; // the Laplacian, with one vertex of each component pinned
  std::unique_ptr<Sparse_solver> m_solver; // factorization of m_matrix
  std::shared_ptr<const Spanning_forest> m_forest;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_TRANSPORT_SOLVER_H
