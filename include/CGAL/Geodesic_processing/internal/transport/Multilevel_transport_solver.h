// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MULTILEVEL_TRANSPORT_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MULTILEVEL_TRANSPORT_SOLVER_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/transport/Curve_embedding.h>
#include <CGAL/Geodesic_processing/internal/transport/Mass_distribution.h>
#include <CGAL/Geodesic_processing/internal/transport/streamlines.h>
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Multilevel_transport_options
{
  Transport_options transport;
  bool do_normalize = false; // scales both sides so that each sums to one
  bool do_bound_from_above = false;
};

// On coarse surfaces more than a percent may be lost between points; a query of a refined one takes some
// tenths of a second there.
inline unsigned default_number_of_refinements(const Surface_arrays& triangles)
{
  return triangles.number_of_vertices() <= 5000 ? 1 : 0;
}

// Where masses may go.  Of an exit all sites are one, with the sides and triangles between them, or a curve,
// on a mesh.  Without limits all exits are one.
struct Transport_region
{
  std::vector<std::vector<Index>> exits; // sites; of a curve none
  std::vector<std::vector<Surface_location>>
      curves;                   // #exits, or empty: polylines, as those of Inscription
  std::vector<double> capacity; // #exits: of masses, infinite for no limit; or empty
  double spreading_weight = 0.; // times the integral of the square of the density of what arrives

  Transport_region() = default;
  Transport_region(std::vector<Index> vertices) { exits.push_back(std::move(vertices)); }

  bool is_empty() const { return exits.empty(); }
  bool is_limited() const { return !capacity.empty() || spreading_weight > 0.; }
};

// In the caller's units; potential and flow of the coarse sites and triangles.
struct Multilevel_transport_result : Transport_result
{
  double upper_continuous = infinity; // if asked for
  double estimate = 0.;               // extrapolated over the last refinement, else the value
  Vector arrivals;                    // #sites: the masses that come to a region, zero elsewhere
  Mass_distribution from, to;         // as they were moved; of a region the first alone
};

// Transport_solver on a surface, on request refined, and with another measure of lengths.
class CGAL_GEODESIC_PROCESSING_EXPORT Multilevel_transport_solver
{
public:
  // refinements  how often each triangle is divided in four
  // measure      #triangles: the length of a vector is that of its product with this positive definite
  //              tensor, in the plane where the triangle is unfolded; infinite where nothing may
  //              pass; empty: its own
  // region       for solve_to_region() alone
  // Throws Unsupported_surface_error when there is no triangle with an area, or too many, and
  // Invalid_argument_error when two exits share a site, a limit makes no sense, or a curve is on a cloud.
  explicit Multilevel_transport_solver(std::shared_ptr<const Surface_arrays> triangles,
                                       unsigned refinements = 0,
                                       std::vector<Metric_tensor> metric = {},
                                       Transport_region region = {});

  // Throws Invalid_argument_error when a mass is not finite, the sums differ, as a whole or on a
  // component, or nothing can be normalized.
  Multilevel_transport_result solve(const Mass_distribution& from, const Mass_distribution& to,
                                    const Multilevel_transport_options& options = {}) const;

  // To wherever in the region it costs the least: without limits the region is one site, at which the
  // potential is zero; elsewhere the potential is minus a lower bound of the distance to the region.  With
  // limits it is that of Transport_solver.  Throws as solve(), and when masses are on a component without a
  // part of the region, or without enough room.
  Multilevel_transport_result
  solve_to_region(const Mass_distribution& from,
                  const Multilevel_transport_options& options = {}) const;

  // The lines along which masses were moved.  On a mesh two factorizations and some hundred solutions.
  Streamlines streamlines(const Multilevel_transport_result& result) const;

  // Whether lengths are those of the surface, on a mesh but for where nothing may pass: then a line that is
  // pulled taut on open_triangles() is shorter.
  bool has_surface_metric() const;

  // The coarse ones, not glued where something may pass on one side alone.
  std::shared_ptr<const Surface_arrays> open_triangles() const;

  // #sites: whether a way leads to the region; empty without one.
  const std::vector<bool>& is_region_reachable() const { return m_reaches_region; }

  // Of the surface as it is refined: its first sites are those of the surface.
  const Transport_solver& finest_level_solver() const { return *m_levels.back().solver; }
  double finest_level_scale() const { return m_levels.back().triangles->scale; }

private:
  struct Level
  {
    std::shared_ptr<const Surface_arrays> triangles;
    std::vector<Metric_tensor> metric;        // #triangles, or empty
    std::vector<double> area;                 // #triangles: zero where nothing may pass
    std::vector<std::vector<Index>> exits;    // without limits one; none where curves are not yet
    std::unique_ptr<Transport_solver> solver; // of the last two alone that have exits
  };

  // Of the base.
  Multilevel_transport_result transport_masses(Mass_distribution masses,
                                               const Multilevel_transport_options& options) const;

  void add_level(std::shared_ptr<const Surface_arrays> triangles, std::vector<Metric_tensor> metric,
                 std::vector<std::vector<Index>> exits);
  // The first level that has all exits.
  std::size_t base_level() const { return m_curve_embedding ? 1 : 0; }
  std::vector<Exit> limited_exits(const Level& level) const;
  double cost_to_vertices(const Mass_distribution& masses) const;
  double cost_of_flow(const Field& flow) const;

  std::vector<Level> m_levels;                      // the finest last
  std::optional<Curve_embedding> m_curve_embedding; // on the first of them, where there are curves
  Transport_region m_region;
  std::vector<bool> m_reaches_region;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MULTILEVEL_TRANSPORT_SOLVER_H
