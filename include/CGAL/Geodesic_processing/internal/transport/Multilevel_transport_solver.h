// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MULTILEVEL_TRANSPORT_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MULTILEVEL_TRANSPORT_SOLVER_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/transport/Curve_embedding.h>
#include <CGAL/Geodesic_processing/internal/transport/Mass_distribution.h>
#include <CGAL/Geodesic_processing/internal/transport/streamlines.h>
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns the default number of uniform refinements. On coarse surfaces, the cost between points
// can be more than a percent too small. A query on the refined surface takes some tenths of a
// second there.
inline unsigned default_number_of_refinements(const Surface_arrays& triangles)
{
  return triangles.number_of_vertices() <= 5000 ? 1 : 0;
}

// The region at which mass can leave the surface: a list of exits. An exit is a set of vertices,
// with the edges and triangles between them, or a polyline. Moving within an exit costs nothing.
// Without limits, moving between exits costs nothing either.
struct Transport_region
{
  std::vector<std::vector<Index>> exits; // #exits: vertices; empty if the exit is a polyline
  // #exits, or empty: polylines as for Curve_embedding; empty if the exit is a set of vertices
  std::vector<std::vector<Surface_location>> curves;
  std::vector<double> capacity; // #exits: mass that can arrive, may be infinite; empty for no limit
  double spreading_weight = 0.; // adds this times the integral of the squared density of arrivals

  Transport_region() = default;
  Transport_region(std::vector<Index> vertices) { exits.push_back(std::move(vertices)); }

  bool is_empty() const { return exits.empty(); }
  bool is_limited() const { return !capacity.empty() || spreading_weight > 0.; }
};

// Computes optimal transport on a surface that is refined uniformly, optionally with a metric and
// with a region. This class uses a Transport_solver on each of the last two levels, extrapolates
// the value, and maps the result of the finest level back to the input. Results are in the unit
// of the coordinates.
//
// Const member functions can be called concurrently.
class CGAL_GEODESIC_PROCESSING_EXPORT Multilevel_transport_solver
{
public:
  // refinements  number of 1-to-4 subdivisions of each triangle
  // metric       #triangles, or empty: the length of a vector v is |A v|, where A is this positive
  //              definite tensor in the plane of the unfolded triangle; infinite in obstacles
  // region       for solve_to_region(); must be empty if solve() is called
  //
  // Throws Unsupported_surface_error if no triangle has an area or the refined surface is too
  // large.
  // Throws Invalid_argument_error if exits share a vertex, a limit is invalid, or a cloud has
  // curves.
  explicit Multilevel_transport_solver(std::shared_ptr<const Surface_arrays> triangles,
                                       unsigned refinements = 0,
                                       std::vector<Metric_tensor> metric = {},
                                       Transport_region region = {});

  // Computes the transport from one mass distribution to another. Throws Invalid_argument_error
  // if a mass is not finite, if the total masses differ (on the surface or on a component), or if
  // a distribution that is to be normalized has no positive total mass.
  Transport_result solve(const Mass_distribution& from, const Mass_distribution& to,
                         const Transport_options& options = {}) const;

  // Computes the transport of a mass distribution to the region, with free marginal: each mass
  // arrives in the region at minimum cost. Without limits the potential is zero in the region,
  // and elsewhere its absolute value is a lower bound of the distance to the region. With limits
  // it is the potential of Transport_solver. Throws as solve(), and if a component with mass has
  // no exit or too little capacity.
  Transport_result solve_to_region(const Mass_distribution& from,
                                   const Transport_options& options = {}) const;

  // Prepares streamlines of the flow of a result. On a mesh this takes two factorizations and
  // some hundred back substitutions.
  Streamlines streamlines(const Transport_result& result) const;

  // Returns whether lengths are those of the surface, that is, whether the metric is the
  // identity, on meshes except in obstacles. Only then can streamlines be shortened on
  // open_triangles().
  bool has_surface_metric() const;

  // Returns the triangles before refinement, with twins removed along the boundary of obstacles.
  std::shared_ptr<const Surface_arrays> open_triangles() const;

  // #vertices: whether the region can be reached from a vertex; empty without a region.
  const std::vector<bool>& is_region_reachable() const { return m_reaches_region; }

  // Returns the solver of the refined surface, whose first vertices are those of the input.
  const Transport_solver& finest_level_solver() const { return *m_levels.back().solver; }
  double finest_level_scale() const { return m_levels.back().triangles->scale; }

private:
  struct Level
  {
    std::shared_ptr<const Surface_arrays> triangles;
    std::vector<Metric_tensor> metric;        // #triangles, or empty
    std::vector<double> area;                 // #triangles: zero in obstacles
    std::vector<std::vector<Index>> exits;    // merged into one if there are no limits
    std::unique_ptr<Transport_solver> solver; // of the last two levels from base_level() on
  };

  struct Finest_solution
  {
    Transport_result result;  // in the unit of the finest level
    Mass_distribution masses; // on the finest level
    double coarse_value; // of the level before, in the unit of the coordinates; 0 if there is none
  };

  void add_level(std::shared_ptr<const Surface_arrays> triangles, std::vector<Metric_tensor> metric,
                 std::vector<std::vector<Index>> exits);
  void embed_curves();
  void find_reachable_vertices();
  void refine();
  void prepare_solvers();

  // Returns the level that is refined: that of the input, or of the input with embedded curves.
  const Level& base() const { return m_levels[base_level()]; }
  std::size_t base_level() const { return m_curve_embedding ? 1 : 0; }

  std::vector<Exit> limited_exits(const Level& level) const;
  // Solves for masses (target minus source) on the base level. Potential and flow are those of its
  // vertices and triangles.
  Transport_result transport_masses(Mass_distribution masses,
                                    const Transport_options& options) const;
  Finest_solution solve_levels(Mass_distribution masses, const Transport_options& options) const;
  std::array<Vec2, 3> measured_corners(Index triangle) const;
  double cost_to_vertices(const Mass_distribution& masses) const;
  double density_cost_to_vertices(const Vector& density, double initial) const;
  double cost_of_flow(const Field& flow) const;
  Vector arrivals(const Field& flow, const Vector& source_masses) const;

  std::vector<Level> m_levels;                      // from coarse to fine
  std::optional<Curve_embedding> m_curve_embedding; // of the input; only if the region has curves
  Transport_region m_region;
  std::vector<bool> m_reaches_region; // #vertices of the base level, or empty
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MULTILEVEL_TRANSPORT_SOLVER_H
