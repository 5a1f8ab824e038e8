// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_ADMM_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_ADMM_H

#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Minimizes the integral of the length of a field over an affine set of fields. This is the
// alternating direction method of multipliers (ADMM) of Solomon, Rustamov, Guibas and Butscher
// 2014, section 5. It alternates between the projection to the set and shrinking all vectors. A
// gap of half a percent takes some hundred projections.
//
// Both bounds are certified. Every field of the set is an upper bound. For the lower bound, let a
// field have vectors of length at most one, and be orthogonal to all differences of fields of the
// set. Its inner product with each field of the set is the same, and is a lower bound.
class CGAL_GEODESIC_PROCESSING_EXPORT Admm
{
public:
  // Returns the field of the set that is closest to the given one in L2.
  using Projection = std::function<Field(const Field&)>;

  // An iterate, from which another problem with the same operators can start.
  struct State
  {
    // #triangles each; empty: start from the least squares field of the set
    Field shrunk_flow, scaled_dual;
  };

  // Stores a reference to the operators. Computes the least squares field: one projection.
  Admm(const Operators& operators, Projection projection, State initial_state = {});

  // Performs the given number of steps, then updates the bounds: steps + 1 projections.
  void advance(unsigned steps);

  double upper() const { return m_upper; }
  double lower() const { return m_lower; }
  // Returns the field of the set that certifies the upper bound.
  const Field& flow() const { return m_flow; }
  // Returns the field of length at most one that certifies the lower bound; zero if that is zero.
  const Field& dual_field() const { return m_dual_field; }

  const State& state() const { return m_state; }

private:
  void update_upper_bound(const Field& flow);
  void update_lower_bound();

  const Operators& m_operators;
  Projection m_projection;
  Field m_least_squares_flow; // the field of the set that is closest to zero
  double m_threshold;         // shrinkage: the length that vectors lose in a step
  State m_state;
  double m_upper = infinity, m_lower = 0.;
  Field m_flow, m_dual_field;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_ADMM_H
