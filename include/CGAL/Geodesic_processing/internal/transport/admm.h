// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_ADMM_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_ADMM_H

#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The field of an affine set that minimizes the integral of its length, by the alternating direction
// method of multipliers (Douglas and Rachford's splitting; Solomon and others 2014, section 5): in turn
// the nearest field of the set, and shorter vectors.  Half of a percent takes some hundred projections.
//
// Certified from both sides: a field of the set is an upper bound; a field of length at most one that is
// orthogonal to all differences of the set's fields has the same inner product with each of the set,
// which is a lower one.
class CGAL_GEODESIC_PROCESSING_EXPORT Admm
{
public:
  // The field of the set that is nearest to another one.
  using Projection = std::function<Field(const Field&)>;

  // What a problem may start from where another one, with the same operators, ended.
  struct State
  {
    Field shrunk_flow, scaled_dual; // empty: from the set's field of least squares
  };

  // The operators must live as long.
  Admm(const Operators& operators, Projection projection, State initial_state = {});

  // Some steps, each a projection, and one more to look for better bounds.
  void advance(unsigned steps);

  double upper() const { return m_upper; }
  double lower() const { return m_lower; }
  const Field& flow() const { return m_flow; }             // of the set, costs `upper`
  const Field& dual_field() const { return m_dual_field; } // orthogonal to it, proves `lower`

  const State& state() const { return m_state; }

private:
  void update_upper_bound(const Field& flow);
  void update_lower_bound();

  const Operators& m_operators;
  Projection m_projection;
  Field m_least_squares_flow; // of the set, nearest to zero
  double m_threshold;         // by how much vectors get shorter
  State m_state;
  double m_upper = infinity, m_lower = 0.;
  Field m_flow, m_dual_field;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_ADMM_H
