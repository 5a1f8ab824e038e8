// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_EXITS_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_EXITS_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The exits of one component and the mass that has to leave through them. Masses are fractions
// of the total mass that is moved, and prices are scaled accordingly.
struct Exit_group
{
  Index component;
  double mass; // positive
  std::vector<Exit> exits;
};

// The exits of all components. In `full` groups the capacity is just sufficient, which
// determines the outflow of each exit; `open` groups have capacity to spare.
struct Exit_groups
{
  std::vector<Exit_group> open, full;
  std::vector<std::size_t> order; // for each exit of the open groups in turn its index in the input
  std::vector<double> outflow;    // #exits of the input: of full groups, zero for the others
  double cost = 0.;               // of the outflow of the full groups
};

// Groups exits by component.
//
// component   #vertices
// masses      #vertices: target mass minus source mass, divided by moved_mass
// moved_mass  the total mass that is moved; capacities and prices of `exits` are in this unit of
//             mass
CGAL_GEODESIC_PROCESSING_EXPORT
Exit_groups group_exits(const std::vector<Exit>& exits, const std::vector<Index>& component,
                        const Vector& masses, double moved_mass);

struct Exit_cost
{
  double cost;
  double marginal_cost; // of the last mass that leaves
};

// Returns a lower bound of the cost at which the mass of a group leaves, if mass that leaves at
// vertex v costs potential[v] per unit in addition to the price: the maximum of the dual function
//   mu mass + sum of min over 0 <= x <= capacity of (price / 2 x^2 + (potential[v] - mu) x)
// over the marginal cost mu, and the mu at which it is attained. Bisection to machine precision.
CGAL_GEODESIC_PROCESSING_EXPORT
Exit_cost dual_exit_cost(const Exit_group& group, const Vector& potential);

// Returns the marginal cost at the most expensive exit of a full group.
CGAL_GEODESIC_PROCESSING_EXPORT
double full_marginal_cost(const Exit_group& full, const Vector& potential);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_TRANSPORT_EXITS_H
