// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_TRANSPORT_ITERATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_TRANSPORT_ITERATION_H

#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Those of a component whose masses, which sum to minus `mass`, leave through them; with room for more.
struct Exit_group
{
  Index component;
  double mass;
  std::vector<Exit> exits;
};

// For a price of leaving at each site, and what is paid besides: no more than what it costs to get rid of
// the mass; and the price at which the last of it leaves.
std::pair<double, double> dual_exit_cost(const Exit_group& group, const Vector& price);

// To minimize the integral of |J| over the fields with divergence(J) = masses; with exits, and what is paid
// there, over those with divergence(J) = masses + what leaves.
struct Transport_problem
{
  const Operators& operators;
  const Laplacian& laplacian;
  const Sparse_matrix& matrix; // of it, held
  const Sparse_solver& solver; // of the matrix
  const Vector& masses;
  std::vector<Exit_group> exits = {};
};

// A way to get there step by step, and the best that was seen so far.
class Transport_iteration
{
public:
  explicit Transport_iteration(const Transport_problem& problem) : m_problem(problem) {}
  virtual ~Transport_iteration() = default;

  // False when rounding lets it go no farther.
  virtual bool advance() = 0;

  double upper() const { return m_upper; }
  double lower() const { return m_lower; }
  const Field& flow() const { return m_flow; } // costs `upper`
  const std::vector<double>& outflow() const
  {
    return m_outflow;
  }                                                       // through exits, one after another
  const Vector& potential() const { return m_potential; } // of slope one at most, proves `lower`

protected:
  const Operators& operators() const { return m_problem.operators; }
  const Transport_problem& problem() const { return m_problem; }

  // The field must have the divergence that is asked for, and is not kept when more leaves than there is
  // room for, or less than nothing; the potential may have any slope.
  void update_upper_bound(const Field& flow, const std::vector<double>& outflow = {});
  void update_lower_bound(const Vector& potential);

private:
  Transport_problem m_problem;
  double m_lower = 0., m_upper = infinity;
  Field m_flow;
  std::vector<double> m_outflow;
  Vector m_potential = Vector::Zero(m_problem.masses.size());
};

// For the second-order cone program: scaling of Nesterov and Todd, predictor and corrector of Mehrotra,
// centrality corrector of Gondzio.  A step is a factorization.
std::unique_ptr<Transport_iteration> interior_point(const Transport_problem& problem);

// Least squares again and again, weighted by one over the length that vectors had before (Weiszfeld 1937
// in each triangle; figure 4 of Solomon and others 2014).  A step is a factorization; the gap stalls at
// about one percent.
std::unique_ptr<Transport_iteration> weiszfeld(const Transport_problem& problem);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_TRANSPORT_ITERATION_H
