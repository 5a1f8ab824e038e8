// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_HEAT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_HEAT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Distances by the heat method (Crane, Weischedel and Wardetzky 2013), on the intrinsic Delaunay
// triangulation of a mesh or on the weighted triangles of a cloud.
//
// The time step is the square of the mean length of a side, or more where the surface is more than
// 300 of those wide: heat that underflows has no direction.  A source with an offset gets as much
// less heat as it would have lost on the way.  A whole component is shifted such that the mean
// over its sources is right.
class CGAL_GEODESIC_PROCESSING_EXPORT Heat_solver
{
public:
  // Two sparse factorizations.
  explicit Heat_solver(std::shared_ptr<const Surface_arrays> triangles);

  // As Front::run(); labels, predecessors and what is reached are those of the shortest arcs.
  // Throws Unsupported_surface_error when the limits ask for speeds.
  bool run(const std::vector<Front_source>& sources, const Front_limits& limits = {});

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
  std::vector<double> m_distance; // #sites
  std::vector<Index> m_reached;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_HEAT_H
