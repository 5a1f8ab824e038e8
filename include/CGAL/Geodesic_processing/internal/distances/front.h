// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/distances/Front_state.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The limits and options of a distance query.
struct Front_limits
{
  double maximum_distance = infinity;    // vertices farther than this are not reached
  std::vector<Surface_location> targets; // the query may stop when all of them are final
  // #triangles: 1 / speed, infinite for an obstacle; null if it is 1 everywhere.
  std::shared_ptr<const std::vector<double>> slowness;
  // #vertices: distances known from previous queries, or null. The front propagates only from
  // vertices whose known distance it improves, and reaches one ring of vertices beyond them. This
  // is because a triangle in which two fronts meet needs the new distance at all of its corners.
  // Without that ring the mean error of the combined distances is 20 to 2,000 times larger on scans
  // and mechanical parts.
  const std::vector<double>* known_distance = nullptr;
  double relative_tolerance = 0.;       // of windows; fronts do not support it
  std::function<bool(double)> callback; // receives the fraction done; returns false to cancel
};

// Computes distances from sources by a front: Dijkstra's algorithm, fast marching, or circular
// fronts (Front_kind), on meshes and clouds.
//
// A query takes O(k log k) time for k reached vertices; no array of size #vertices is cleared.
// Copies share the triangles and may run concurrently.
class CGAL_GEODESIC_PROCESSING_EXPORT Front
{
public:
  // A Euclidean front on a mesh can propagate on a triangulation with bisected long edges. It is
  // then more accurate, takes longer, and does not support known distances.
  Front(std::shared_ptr<const Surface_arrays> triangles, Front_kind kind,
        Bisected_edges bisected = Bisected_edges::none);

  // Propagates the front from the sources. If the slowness is the same everywhere, the front is
  // that without slowness, and its distances are multiplied. The distances do not depend on the
  // order of the sources. Returns false if the callback cancelled it; then only vertices that were
  // final are reached. On a cloud, their distances could still decrease slightly.
  bool run(const std::vector<Front_source>& sources, const Front_limits& limits = {});

  // Returns the distance of the last query, in the unit of the arrays (Surface_arrays::scale);
  // infinity if no source reaches the vertex or location.
  double distance(Index vertex) const { return m_state.unit * m_state.vertices[vertex].distance; }
  double distance(const Surface_location& location) const;
  // Returns the position of the nearest source in the array of sources, or none if not reached.
  Index source(Index vertex) const { return m_state.sources[vertex]; }
  // Returns the adjacent vertex, closer to the source, next to which the shortest path arrives.
  // Returns none if the vertex is on a source or not reached, or if there is no such vertex.
  Index predecessor(Index vertex) const;
  // Returns the reached vertices, each once, nearly in the order of their distances.
  const std::vector<Index>& reached() const { return m_state.reached; }

private:
  void begin_query(const Front_limits& limits);
  void store_geometry();
  bool propagate(const Front_limits& limits);
  void propagate_from(Index vertex);
  std::vector<Index> collect_final_vertices();

  Front_state m_state;
  // Of the last query, as in Front_limits, and its value if that is the same everywhere.
  std::shared_ptr<const std::vector<double>> m_slowness;
  std::optional<double> m_constant_slowness = 1.;
  std::size_t m_number_of_visits = 0; // of all queries
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_H
