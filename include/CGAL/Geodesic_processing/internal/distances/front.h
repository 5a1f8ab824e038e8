// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/Vertex_queue.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/distances/vertex_fans.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// How a front passes a triangle.
enum class Front_kind
{
  dijkstra,  // along arcs only (Dijkstra): never below the distance, inconsistent under refinement
  planar,    // as a straight line (Kimmel and Sethian 1998): first order, admits speeds
  euclidean, // as a circle about an unfolded source, whose direction each site knows
};

// What a query asks for, beside its sources.
struct Front_limits
{
  double maximum_distance = infinity;    // sites farther away are not reached
  std::vector<Surface_location> targets; // the front may stop when all of them are final
  // #triangles: 1 / speed, infinite at an obstacle; null where it is 1
  std::shared_ptr<const std::vector<double>> slowness;
  // #sites: what is known already.  The front goes on only where it improves that, and reaches one
  // site beyond: fronts that meet in a triangle need it at all of its corners.  Without that ring the
  // mean error of what is known afterwards is 20 to 2,000 times larger on scans and parts.
  const std::vector<double>* known_distance = nullptr;
  std::function<bool(double)> callback; // told the fraction done; false cancels
};

// A front that spreads from sources over a domain, and what it leaves behind at each site.
// A query costs in proportion to the sites that it visits: nothing of size #sites is cleared.
// Copies share the triangles and may run at the same time.
class CGAL_GEODESIC_PROCESSING_EXPORT Front
{
public:
  Front(std::shared_ptr<const Surface_arrays> triangles, Front_kind kind);

  // Lets the front start from the sources.  False when the callback cancelled it: then only sites
  // that were final are reached.  The distances do not depend on the order of the sources.
  bool run(const std::vector<Front_source>& sources, const Front_limits& limits = {});

  // All of the last run, in the domain's scale.
  double distance(Index vertex) const { return m_vertices[vertex].distance; }
  double distance(const Surface_location& location) const;
  // The position among the sources of the nearest one; none where no source reaches.
  Index source(Index vertex) const { return m_sources[vertex]; }
  // A neighbouring site nearer to the source, next to which the shortest path arrives; none at
  // sources and where no source reaches.
  Index predecessor(Index vertex) const;
  // The sites reached, each once; nearly in the order of their distances.
  const std::vector<Index>& reached() const { return m_reached; }

private:
  struct Vertex_data
  {
    double distance = infinity;
    Index corner = none; // of the site, in the triangle that the front came through; without
                         //   directions, and on a cloud, the predecessor
    Index state = 0;     // see the flags in front.cpp
  };
  struct Arrival;

  // Whether sites of the running query know the direction of their sources.
  bool has_directions() const { return m_kind == Front_kind::euclidean && !m_slowness; }
  double offset_at(Index vertex) const
  {
    return m_has_single_source ? m_min_offset : m_offsets[m_sources[vertex]];
  }
  bool have_same_source(Index x, Index z) const
  {
    return m_has_single_source || m_sources[x] == m_sources[z];
  }

  void prefetch_around(Index vertex) const;
  void initialize(const std::vector<Front_source>& sources);
  void initialize_vertex(Index vertex, double distance, Index flags, Index source);
  void initialize_triangle(Index triangle, const Surface_location& begin,
                           const Surface_location& end, double offset, Index source);
  bool relax(Index vertex, const Arrival& arrival, Index source);
  bool may_improve_neighbors(Index vertex) const;
  bool needs_invalidation(Index vertex, double correction) const;
  bool can_invalidate() const;
  void invalidate_descendants();

  void relax_along_edge(Index vertex, const Fan_position& position, Index flags);
  void relax_all_edges(Index vertex, Index flags);
  void propagate_along_edges(Index vertex);

  void propagate_planar(Index vertex);
  double planar_update(Index x, Index z, double base, const Vec2& apex, double slowness,
                       bool& is_nearer_to_z) const;

  void propagate_euclidean(Index vertex);
  bool propagate_around(Index vertex);
  void propagate_without_direction(Index vertex);
  void update_circular(Index vertex, const Fan_position& position, bool is_mirrored,
                       const Vec2& opening, const Vec2& angle, double min_curvature);
  bool was_reached_after(Index vertex, Index neighbor) const;
  void update_from(Index corner, bool is_mirrored);

  void propagate_on_cloud(Index vertex);
  void update_on_cloud(Index from, const Vec3* source, Index along, Index target);

  Vec2 in_corner_frame(const Vec2& vector, const std::array<Vec2, 3>& corners, Index corner) const;
  Vec2 tangent_coordinates(Index vertex, const Vec3& direction) const;
  double distance_at(Index triangle, const std::array<double, 3>& barycentric) const;
  bool source_direction(Index corner, bool is_mirrored, Vec2& source) const;

  std::shared_ptr<const Surface_arrays> m_triangles;
  std::shared_ptr<const Vertex_fans> m_fans;              // but for arcs, and distances on clouds
  std::shared_ptr<const std::vector<Index>> m_components; // #sites, for Euclidean fronts on clouds
  Front_kind m_kind;
  bool m_has_splits = false; // in the spokes of a Euclidean front, for queries with speeds

  std::vector<Vertex_data> m_vertices;
  // #sites, for Euclidean fronts: the unit vector back to the source; on a mesh in the plane of the
  // triangle of the site's corner, whose side lies on the first axis; on a cloud in the tangent frame.
  std::vector<Vec2> m_directions;
  std::vector<Index> m_sources;
  std::vector<Index> m_reached;
  Vertex_queue m_queue;
  std::size_t m_number_invalidated = 0; // sites taken back in the running query
  std::vector<Index>
      m_corrected_vertices; // while a site spreads: final ones whose distance has fallen

  // Of the running query
  std::shared_ptr<const std::vector<double>> m_slowness;
  std::vector<std::pair<Index, Front_source>>
      m_source_pieces;           // sorted: triangle, its part of a source
  std::vector<double> m_offsets; // #sources
  double m_min_offset = 0.;
  double m_max_distance = infinity;
  bool m_has_single_source = false; // one source only
  const std::vector<double>* m_known_distance = nullptr;
  bool m_improves_known_distance =
      true; // the site that spreads may reach others which it does not improve
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_H
