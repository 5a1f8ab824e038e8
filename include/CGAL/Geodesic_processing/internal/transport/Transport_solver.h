// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_TRANSPORT_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_TRANSPORT_SOLVER_H

#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include <CGAL/Geodesic_processing/internal/transport/admm.h>

#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

enum class Transport_method
{
  interior_point,
  admm,
  weiszfeld
};

struct Transport_options
{
  Transport_method method = Transport_method::interior_point;
  double tolerance = 1e-3;              // of the gap between the bounds, relative to the upper one
  unsigned maximum_iterations = 0;      // zero: as many as the method usually needs at most
  std::function<bool(double)> callback; // gets a fraction from 0 to 1, ends the iterations by false
  Admm::State warm_start;               // for `splitting`, from the same solver; may be empty
};

// Where masses may leave the surface.
struct Exit
{
  Index vertex;    // each has one exit at most
  double capacity; // of mass: positive, or infinite
  double price;    // half of it times the square of what leaves is paid
};

// What moving masses costs, in lengths of the domain times masses, and how they move.
struct Transport_result
{
  double value = 0.;       // halfway between the bounds
  double lower = 0.;       // what the potential proves
  double upper = 0.;       // what the flow costs
  Vector potential;        // #sites: grows along the flow, by at most one per unit of length
  Field flow;              // #triangles: mass per length of a line across
  Vector outflow;          // #exits
  unsigned iterations = 0; // factorizations, or of `splitting` solutions
  double residual = 0.;   // largest |divergence(flow) - masses|, relative to the mass that is moved
  bool converged = false; // whether the gap is within the tolerance
  Admm::State state;      // where `splitting` ended
};

// From the unit of triangles, which have another scale, to the caller's.
inline void rescale(Transport_result& transport, double scale)
{
  for(double* length : {&transport.value, &transport.lower, &transport.upper})
    *length *= scale;
  transport.potential *= scale;
  for(Vec2& vector : transport.flow)
    vector = (1. / scale) * vector;
}

// The earth mover's distance with the length of a path as cost (Solomon, Rustamov, Guibas and Butscher
// 2014), without their spectral truncation: over all fields J, constant in each triangle,
//   minimize the integral of |J| where divergence(J) = b,
// whose dual is to maximize the sum of b times phi where |gradient(phi)| <= 1 in each triangle.
//
// Both bounds are certified: any such J is an upper one, any phi divided by its largest slope a lower
// one.  A phi of slope one changes no faster than distance does, so that the lower one also holds for
// the distance on the surface itself, which on smooth ones is larger by a part of the order of a side.
//
// An interior point method for the second-order cone program: scaling of Nesterov and Todd, predictor
// and corrector of Mehrotra, centrality corrector of Gondzio.  The matrix of each iteration is a
// Laplacian with a tensor for each triangle, of one pattern, whose analysis is shared by all queries.
// To 0.1 percent it takes 5 to 9 iterations between points of models of 6,000 to 40,000 vertices, and 16
// to 21 between smooth densities (test/benchmark/transport.cpp); O(n^1.5) each.
//
// Nothing depends on the units of lengths and masses.  Queries may run in several threads.
class CGAL_GEODESIC_PROCESSING_EXPORT Transport_solver
{
public:
  // Throws Unsupported_surface_error when there is no triangle with an area.
  explicit Transport_solver(Operators operators);

  // masses  #sites: what is missing there, negative where there is too much; the sum over each component
  // is zero up to 1e-9 of the sum of sizes.  Throws Invalid_argument_error when it is not, when a mass
  // is not finite, or the tolerance not positive.
  //
  // exits  what is too much on their components leaves through them.  Bounds are of all that is paid,
  // proved with each exit taking what it takes for less than a price; the potential is zero where that is
  // paid, below where there is no more room.  `interior_point` alone.  Throws Invalid_argument_error when
  // there is not enough room as well.
  Transport_result solve(const Vector& masses, const Transport_options& options = {},
                         const std::vector<Exit>& exits = {}) const;

  // The flow of least squares that moves the masses, which sum to zero on each component: with a vector
  // of any field's missing masses, what brings it nearest to flows that do.  One solution.
  Field least_squares_flow(const Vector& masses) const;

  const Operators& operators() const { return m_operators; }

private:
  void check_input(const Vector& masses, const std::vector<Exit>& exits) const;

  Operators m_operators;
  Laplacian m_laplacian;
  std::vector<Index> m_component; // #sites
  std::size_t m_number_of_components = 0;
  Sparse_matrix m_matrix;                  // the Laplacian
  std::unique_ptr<Sparse_solver> m_solver; // of it
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_TRANSPORT_SOLVER_H
