// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_FRONT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_FRONT_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>
#include <CGAL/Geodesic_processing/internal/core/Queue.h>
#include <CGAL/Geodesic_processing/internal/core/planar.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include <CGAL/Geodesic_processing/internal/distances/spokes.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// How a front passes a triangle.
enum class Front_kind
{
  arcs,      // along arcs only (Dijkstra): never below the distance, inconsistent under refinement
  planar,    // as a straight line (Kimmel and Sethian 1998): first order, admits speeds
  euclidean, // as a circle about an unfolded source, whose direction each site knows
};

// What a query asks for, beside its sources.
struct Front_limits
{
  double maximum_distance = infinity; // sites farther away are not reached
  std::vector<Location> targets;      // the front may stop when all of them are final
  // #triangles: 1 / speed, infinite at an obstacle; null where it is 1
  std::shared_ptr<const std::vector<double>> slowness;
  // #sites: what is known already.  The front goes on only where it improves that, and reaches one
  // site beyond: fronts that meet in a triangle need it at all of its corners.  Without that ring the
  // mean error of what is known afterwards is 20 to 2,000 times larger on scans and parts.
  const std::vector<double>* known = nullptr;
  std::function<bool(double)> callback; // told the fraction done; false cancels
};

// A front that spreads from sources over a domain, and what it leaves behind at each site.
// A query costs in proportion to the sites that it visits: nothing of size #sites is cleared.
// Copies share the triangles and may run at the same time.
class CGAL_GEODESIC_PROCESSING_EXPORT Front
{
public:
  Front(std::shared_ptr<const Glued_triangles> triangles, Front_kind kind);

  // Lets the front start from the sources.  False when the callback cancelled it: then only sites
  // that were final are reached.  The distances do not depend on the order of the sources.
  bool run(const std::vector<Source>& sources, const Front_limits& limits = {});

  // All of the last run, in the domain's scale.
  double distance(Index site) const { return m_sites[site].distance; }
  double distance(const Location& location) const;
  // The position among the sources of the nearest one; none where no source reaches.
  Index source(Index site) const { return m_sources[site]; }
  // A neighbouring site nearer to the source, next to which the shortest path arrives; none at
  // sources and where no source reaches.
  Index predecessor(Index site) const;
  // The sites reached, each once; nearly in the order of their distances.
  const std::vector<Index>& reached() const { return m_reached; }

private:
  struct Site
  {
    double distance = infinity;
    Index corner = none; // of the site, in the triangle that the front came through; without
                         //   directions, and on a cloud, the predecessor
    Index state = 0;     // see the flags in front.cpp
  };
  struct Arrival;

  // Whether sites of the running query know the direction of their sources.
  bool has_directions() const { return m_kind == Front_kind::euclidean && !m_slowness; }
  double offset_at(Index site) const
  {
    return m_is_single ? m_lowest_offset : m_offsets[m_sources[site]];
  }
  bool is_same_front(Index x, Index z) const { return m_is_single || m_sources[x] == m_sources[z]; }

  void prefetch_around(Index site) const;
  void start(const std::vector<Source>& sources);
  void start_at_site(Index site, double distance, Index flags, Index source);
  void start_in_triangle(Index triangle, const Location& begin, const Location& end, double offset,
                         Index source);
  bool offer(Index site, const Arrival& arrival, Index source);
  bool may_improve_around(Index site) const;
  bool is_worth_retracting(Index site, double correction) const;
  bool can_retract() const;
  void retract();

  void offer_along(Index site, const Spoke_place& place, Index flags);
  void offer_along_all(Index site, Index flags);
  void spread_along_arcs(Index site);

  void spread_planar(Index site);
  double cross_planar(Index x, Index z, double base, const Planar& apex, double slowness,
                      bool& is_nearer_to_z) const;

  void spread_euclidean(Index site);
  bool spread_all_around(Index site);
  void spread_blindly(Index site);
  void cross_circle(Index site, const Spoke_place& place, bool mirrored, const Planar& opening,
                    const Planar& angle, double least_curvature);
  bool was_reached_after(Index site, Index neighbour) const;
  void cross_from(Index corner, bool mirrored);

  void spread_on_cloud(Index site);
  void cross_on_cloud(Index from, const Spatial* source, Index along, Index target);

  Planar in_corner(const Planar& vector, const std::array<Planar, 3>& corners, Index corner) const;
  Planar tangent(Index site, const Spatial& direction) const;
  double distance_in(Index triangle, const std::array<double, 3>& barycentric) const;
  bool source_at(Index corner, bool mirrored, Planar& source) const;

  std::shared_ptr<const Glued_triangles> m_triangles;
  std::shared_ptr<const Spokes> m_spokes;              // but for arcs, and distances on clouds
  std::shared_ptr<const std::vector<Index>> m_islands; // #sites, for Euclidean fronts on clouds
  Front_kind m_kind;
  bool m_has_splits = false; // in the spokes of a Euclidean front, for queries with speeds

  std::vector<Site> m_sites;
  // #sites, for Euclidean fronts: the unit vector back to the source; on a mesh in the plane of the
  // triangle of the site's corner, whose side lies on the first axis; on a cloud in the tangent frame.
  std::vector<Planar> m_directions;
  std::vector<Index> m_sources;
  std::vector<Index> m_reached;
  Queue m_queue;
  std::size_t m_forgotten = 0;    // sites taken back in the running query
  std::vector<Index> m_corrected; // while a site spreads: final ones whose distance has fallen

  // Of the running query
  std::shared_ptr<const std::vector<double>> m_slowness;
  std::vector<std::pair<Index, Source>> m_started_in; // sorted: triangle, its part of a source
  std::vector<double> m_offsets;                      // #sources
  double m_lowest_offset = 0.;
  double m_maximum = infinity;
  bool m_is_single = false; // one source only
  const std::vector<double>* m_known = nullptr;
  bool m_improves = true; // the site that spreads may reach others which it does not improve
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_FRONT_H
