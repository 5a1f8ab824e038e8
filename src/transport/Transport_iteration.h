// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_TRANSPORT_ITERATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_TRANSPORT_ITERATION_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>
#include "transport/Spanning_forest.h"
#include "transport/exits.h"

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Minimize the integral of |J| subject to divergence(J) = masses. If there are exits, the mass
// that leaves through each is a variable: divergence(J) = masses + outflow, and its price is
// added to the objective. Masses are scaled such that one unit of mass is moved.
struct Transport_problem
{
  const Operators& operators;
  const Laplacian& laplacian;
  const Sparse_matrix& matrix;   // the Laplacian, pinned
  const Sparse_solver& solver;   // factorization of the matrix
  const Spanning_forest& forest; // of the operators
  const Vector& masses;          // #vertices
  std::vector<Exit_group> exits = {};
};

// An iterative method for a Transport_problem. The base class keeps the best bounds of all
// iterates.
class CGAL_GEODESIC_PROCESSING_EXPORT Transport_iteration
{
public:
  explicit Transport_iteration(const Transport_problem& problem);
  virtual ~Transport_iteration() = default;

  // Improves the bounds. Returns false if round-off errors prevent further progress.
  virtual bool advance() = 0;

  // Returns what a call of advance() adds to the number of iterations.
  virtual unsigned iterations_per_advance() const { return 1; }
  virtual unsigned default_max_iterations() const { return 100; }

  // Returns the best bounds with flow, outflow and potential. The outflow has an entry for each
  // exit of problem().exits, one group after another. Other members are not set.
  const Transport_result& best() const { return m_best; }

  // Moves the best bounds out, with the final state of methods that have one.
  virtual Transport_result take_best() { return std::move(m_best); }

protected:
  const Operators& operators() const { return m_problem.operators; }
  const Transport_problem& problem() const { return m_problem; }

  // Keeps a flow with divergence(flow) = masses + outflow if it costs less than the best one.
  // Ignores it if an outflow is negative or exceeds the capacity. If the divergence has an error,
  // the bound contains the cost of moving the error along edges.
  void update_upper_bound(Field flow, const Vector& outflow = {});
  // Keeps a potential, divided by its maximum slope, if it proves a higher bound than the best one.
  void update_lower_bound(const Vector& potential);

private:
  // Returns the sum of the prices, or infinity if an outflow is negative or exceeds the capacity.
  double price(const Vector& outflow) const;
  // Returns an upper bound of the cost of moving the masses to which the flow does not lead. If it
  // is not negligible, corrects the flow.
  double correct(const Vector& outflow, double negligible_cost, Field& flow) const;

  Transport_problem m_problem;
  Transport_result m_best;
};

// The interior point method that Transport_solver describes. A step is a factorization.
CGAL_GEODESIC_PROCESSING_EXPORT
std::unique_ptr<Transport_iteration> interior_point(const Transport_problem& problem);

// Iteratively reweighted least squares: each triangle is weighted by one over the length of its
// vector in the previous iterate (Weiszfeld 1937; Solomon and others 2014, figure 4). A step is
// a factorization. The gap stalls at about one percent.
CGAL_GEODESIC_PROCESSING_EXPORT
std::unique_ptr<Transport_iteration> weiszfeld(const Transport_problem& problem);

// Returns the method of the options, at its start.
CGAL_GEODESIC_PROCESSING_EXPORT
std::unique_ptr<Transport_iteration> make_iteration(const Transport_problem& problem,
                                                    const Transport_options& options);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_TRANSPORT_ITERATION_H
