// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_HEAT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_HEAT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Computes distances by the heat method (Crane, Weischedel and Wardetzky 2013), on the intrinsic
// Delaunay triangulation of a mesh or on the weighted triangles of a cloud.
//
// The time step is a multiple of the squared mean edge length. It is increased if a component may
// be wider than 600 square roots of it, because heat that underflows has no gradient. It is
// decreased to the square of ten widths, because heat that is constant up to round-off errors has
// no gradient either. The heat of a source with an offset is reduced by the decay over that
// distance. The distances of a connected
// component are shifted such that their mean over the sources equals the mean offset.
class CGAL_GEODESIC_PROCESSING_EXPORT Heat_solver
{
public:
  // Computes two sparse factorizations, of the heat and of the Poisson system.
  //
  // time_step  in squared mean edge lengths; positive
  // callback   called with 0 before each step; an exception that it throws cancels the computation.
  //            A factorization is one step, because CHOLMOD cannot be interrupted.
  explicit Heat_solver(std::shared_ptr<const Surface_arrays> triangles, double time_step = 1.,
                       const std::function<bool(double)>& callback = {});

  // Throws Unsupported_surface_error if the limits have a slowness.
  static void check_speeds(const Front_limits& limits);

  // As Front::run(). Solves two linear systems by their factorizations. Sources, predecessors and
  // the reached vertices are those of Dijkstra's algorithm. Targets and known distances are
  // ignored. Throws as check_speeds().
  bool run(const std::vector<Front_source>& sources, const Front_limits& limits = {});

  // Returns the distance of a vertex, or interpolates linearly in a triangle. Infinite if not
  // reached.
  double distance(Index vertex) const { return m_distance[vertex]; }
  double distance(const Surface_location& location) const;
  Index source(Index vertex) const { return m_dijkstra.source(vertex); }
  Index predecessor(Index vertex) const;
  const std::vector<Index>& reached() const { return m_reached; }

private:
  struct Systems;
  std::shared_ptr<const Surface_arrays> m_triangles;
  std::shared_ptr<const Systems> m_systems;
  Front m_dijkstra;
  std::vector<double> m_distance; // #vertices
  std::vector<Index> m_reached;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_HEAT_H
