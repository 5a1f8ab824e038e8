// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Multilevel_transport_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/transport/continuous_flow.h>
#include "transport/Spanning_forest.h"
#include "transport/close_vertices.h"
#include "transport/uniform_refinement.h"
#include "core/unfold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the vertices of a region after refinement: those of the coarse surface, and the
// midpoints of edges between two of them.
std::vector<Index> refined(const Surface_arrays& coarse, const Surface_arrays& fine,
                           const std::vector<Index>& region)
{
  Vector is_inside = Vector::Zero(Eigen::Index(coarse.number_of_vertices()));
  for(const Index vertex : region)
    is_inside[vertex] = 1.;
  const Vector inside = refined(coarse, fine, is_inside);
  std::vector<Index> result;
  for(Index vertex = 0; vertex < inside.size(); ++vertex)
    if(inside[vertex] == 1.)
      result.push_back(vertex);
  return result;
}

// Returns whether the interior point method did not converge because of round-off errors: it takes
// few iterations, and did not stop at a limit of the caller.
bool is_stuck(const Transport_result& result, const Transport_options& options)
{
  return !result.is_converged && options.method == Transport_method::interior_point &&
         (options.maximum_iterations == 0 ||
          result.number_of_iterations < options.maximum_iterations);
}

// Solves with one unknown for all vertices that are close to each other. The flow does not move
// masses between them. The cost of moving these masses along tiny edges is added to the upper bound.
Transport_result solve_with_merged_vertices(const Surface_arrays& triangles, const Vector& masses,
                                            const Close_vertices& close,
                                            const Transport_options& options)
{
  const Operators original = operators(triangles, Degenerate_triangles::thickened);
  Operators merged = original;
  merge_close_vertices(triangles, close, merged);
  Vector merged_masses = masses;
  merge_vertices(merged_masses, close.groups);
  const Transport_solver solver(std::move(merged));
  Transport_result result = solver.solve(merged_masses, options);
  separate_close_vertices(solver.operators(), original, result.flow);
  const double cost =
      cost_between_close_vertices(close, masses - minus_divergence(original, result.flow));
  for(const std::vector<Index>& group : close.groups)
    for(const Index vertex : group)
      result.potential[vertex] = double(result.potential[group.front()]);
  result.remaining_cost += cost;
  result.upper += cost;
  result.value = 0.5 * (result.lower + result.upper);
  result.is_converged =
      result.is_converged && result.upper - result.lower <= options.tolerance * result.upper;
  return result;
}

// Returns the arrays with twins removed along the boundary of obstacles.
std::shared_ptr<const Surface_arrays> cut_open(const std::shared_ptr<const Surface_arrays>& arrays,
                                               const std::vector<Metric_tensor>& metric)
{
  if(arrays->is_cloud() || std::none_of(metric.begin(), metric.end(), is_blocked))
    return arrays;
  Surface_arrays result = *arrays;
  for(Index h = 0; h < result.twin.size(); ++h)
    if(const Index twin = arrays->twin[h];
       twin != none && is_blocked(metric[h / 3]) != is_blocked(metric[twin / 3]))
      result.twin[h] = none;
  return std::make_shared<const Surface_arrays>(std::move(result));
}

// Returns the metric with the identity inside obstacles.
std::vector<Metric_tensor> cut_open(std::vector<Metric_tensor> metric)
{
  std::replace_if(metric.begin(), metric.end(), is_blocked, Metric_tensor{1., 0., 1.});
  return metric;
}

Mass_distribution scaled(Mass_distribution masses, double factor)
{
  masses.at_vertices *= factor;
  for(auto& [location, mass] : masses.at_locations)
    mass *= factor;
  masses.density *= factor;
  return masses;
}

void check_region(const Transport_region& region)
{
  if(!region.capacity.empty() && region.capacity.size() != region.exits.size())
    throw Invalid_argument_error("There are " + std::to_string(region.capacity.size()) +
                                 " capacities for " + std::to_string(region.exits.size()) +
                                 " exits.");
  for(const double capacity : region.capacity)
    if(!(capacity > 0.))
      throw Invalid_argument_error("A capacity is not positive.");
  if(!(region.spreading_weight >= 0.) || !std::isfinite(region.spreading_weight))
    throw Invalid_argument_error("The spreading weight is negative or not finite.");
}

// Sorts the vertices of each exit. If there are no limits, merges all exits into one.
std::vector<std::vector<Index>> merged_exits(std::vector<std::vector<Index>> exits, bool is_limited)
{
  if(!is_limited && exits.size() > 1)
  {
    for(std::size_t i = 1; i < exits.size(); ++i)
      exits[0].insert(exits[0].end(), exits[i].begin(), exits[i].end());
    exits.resize(1);
  }
  std::vector<Index> vertices;
  for(std::vector<Index>& exit : exits)
  {
    std::sort(exit.begin(), exit.end());
    exit.erase(std::unique(exit.begin(), exit.end()), exit.end());
    vertices.insert(vertices.end(), exit.begin(), exit.end());
  }
  std::sort(vertices.begin(), vertices.end());
  if(std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end())
    throw Invalid_argument_error("Two exits share a vertex.");
  return exits;
}

} // namespace

Multilevel_transport_solver::Multilevel_transport_solver(
    std::shared_ptr<const Surface_arrays> triangles, unsigned refinements,
    std::vector<Metric_tensor> metric, Transport_region region)
    : m_region(std::move(region))
{
  check_region(m_region);
  require_area(*triangles);
  if(std::ldexp(double(triangles->corner.size()), 2 * int(std::min(refinements, 30u))) > 2e9)
    throw Unsupported_surface_error("The refined surface would have more than 2^31 halfedges.");
  if(m_region.curves.empty())
    add_level(std::move(triangles), std::move(metric),
              merged_exits(m_region.exits, m_region.is_limited()));
  else
  {
    add_level(std::move(triangles), std::move(metric), {});
    embed_curves();
  }
  if(!m_region.is_empty())
    find_reachable_vertices();
  for(unsigned level = 0; level < refinements; ++level)
    refine();
  prepare_solvers();
}

// Adds a level in which the curves of the region consist of edges, and makes exits of their
// vertices.
void Multilevel_transport_solver::embed_curves()
{
  const Level& input = m_levels.front();
  std::vector<std::vector<Index>> exits = m_region.exits;
  std::vector<Index> region_vertices;
  for(const std::vector<Index>& exit : exits)
    region_vertices.insert(region_vertices.end(), exit.begin(), exit.end());
  m_curve_embedding.emplace(input.triangles, m_region.curves, region_vertices);
  for(std::size_t i = 0; i < exits.size(); ++i)
    if(exits[i].empty())
      exits[i] = m_curve_embedding->vertices()[i];
  std::vector<Metric_tensor> metric = m_curve_embedding->refined(input.metric);
  add_level(m_curve_embedding->triangles(), std::move(metric),
            merged_exits(std::move(exits), m_region.is_limited()));
}

// Finds the vertices whose component has an exit.
void Multilevel_transport_solver::find_reachable_vertices()
{
  const Level& level = base();
  Operators operators = metric_operators(*level.triangles, level.metric);
  merge_vertices(operators, level.exits);
  const auto [component, number] = components(operators);
  std::vector<bool> has_exit(number, false);
  for(const std::vector<Index>& exit : level.exits)
    has_exit[component[exit.front()]] = true;
  for(const Index label : component)
    m_reaches_region.push_back(has_exit[label]);
  // Merged vertices are no longer corners of triangles and have components of their own.
  for(const std::vector<Index>& exit : level.exits)
    for(const Index vertex : exit)
      m_reaches_region[vertex] = true;
}

// Adds a level in which each triangle of the last one is divided in four.
void Multilevel_transport_solver::refine()
{
  const Level& coarse = m_levels.back();
  auto triangles = std::make_shared<const Surface_arrays>(refined(*coarse.triangles));
  std::vector<std::vector<Index>> exits;
  for(const std::vector<Index>& exit : coarse.exits)
    exits.push_back(refined(*coarse.triangles, *triangles, exit));
  std::vector<Metric_tensor> metric;
  for(const Metric_tensor& tensor : coarse.metric)
    metric.insert(metric.end(), 4, tensor);
  add_level(std::move(triangles), std::move(metric), std::move(exits));
}

void Multilevel_transport_solver::prepare_solvers()
{
  const std::size_t first =
      std::max(base_level(), m_levels.size() - std::min<std::size_t>(m_levels.size(), 2));
  for(std::size_t level = first; level < m_levels.size(); ++level)
  {
    Level& current = m_levels[level];
    Operators operators = metric_operators(*current.triangles, current.metric);
    merge_vertices(operators, current.exits);
    current.solver = std::make_unique<Transport_solver>(std::move(operators));
  }
}

void Multilevel_transport_solver::add_level(std::shared_ptr<const Surface_arrays> triangles,
                                            std::vector<Metric_tensor> metric,
                                            std::vector<std::vector<Index>> exits)
{
  m_levels.emplace_back();
  Level& level = m_levels.back();
  level.area = metric_operators(*triangles, metric).area;
  level.triangles = std::move(triangles);
  level.metric = std::move(metric);
  level.exits = std::move(exits);
}

// Returns the exits of a level in its unit of length, or nothing if there are no limits. The
// density of arrivals is the outflow divided by a third of the area of the incident triangles
// before refinement.
std::vector<Exit> Multilevel_transport_solver::limited_exits(const Level& level) const
{
  std::vector<Exit> result;
  if(!m_region.is_limited())
    return result;
  const Level& coarse = base();
  const double scale = coarse.triangles->scale;
  for(std::size_t i = 0; i < coarse.exits.size(); ++i)
  {
    double area = 0.;
    for(const Index vertex : coarse.exits[i])
      for(Index k = coarse.triangles->ring_begin[vertex];
          k < coarse.triangles->ring_begin[vertex + 1]; ++k)
        area += scale * scale * coarse.area[coarse.triangles->ring[k] / 3] / 3.;
    const double weight = m_region.spreading_weight;
    result.push_back({level.exits[i].front(),
                      m_region.capacity.empty() ? infinity : m_region.capacity[i],
                      weight > 0. ? 2. * weight / (area * level.triangles->scale) : 0.});
  }
  return result;
}

// Returns the corners of a triangle of the finest level, mapped such that lengths are measured
// ones.
std::array<Vec2, 3> Multilevel_transport_solver::measured_corners(Index triangle) const
{
  const Level& fine = m_levels.back();
  std::array<Vec2, 3> result = unfolded(*fine.triangles, triangle);
  if(!fine.metric.empty())
    for(Vec2& p : result)
      p = product(fine.metric[triangle], p);
  return result;
}

// Returns an upper bound of the cost of moving masses of the finest level to the vertices at which
// masses_at_vertices() places them.
double Multilevel_transport_solver::cost_to_vertices(const Mass_distribution& masses) const
{
  const std::vector<Metric_tensor>& metric = m_levels.back().metric;
  double result = 0.;
  for(const auto& [location, mass] : masses.at_locations)
    if(location.triangle != none)
    {
      if(!metric.empty() && is_blocked(metric[location.triangle]))
        return infinity;
      const auto p = measured_corners(location.triangle);
      const Vec2 point = unfolded_point(p, location.barycentric);
      for(std::size_t k = 0; k < 3; ++k)
        result += std::abs(mass * location.barycentric[k]) * norm(point - p[k]);
    }
  return masses.density.size() == 0 ? result : density_cost_to_vertices(masses.density, result);
}

// Returns an upper bound of the cost of moving a linear density to the vertices, added to
// `initial`. masses_at_vertices() gives corner k the mass of density times h_k, where h_i are the
// hat functions. At the point with barycentric coordinates h_i, the distance to corner k is at
// most the sum of h_i |p_k - p_i|, by convexity. The integral of h_i h_j h_k over a triangle is
// area / 30 if two of them are the same, and area / 60 if none are.
double Multilevel_transport_solver::density_cost_to_vertices(const Vector& density,
                                                             double initial) const
{
  const Surface_arrays& t = *m_levels.back().triangles;
  const std::vector<double>& area = m_levels.back().area;
  double result = initial;
  for(std::size_t f = 0; f < area.size(); ++f)
  {
    if(area[f] == 0.)
      continue;
    const auto p = measured_corners(Index(f));
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        for(std::size_t k = 0; k < 3; ++k)
          if(i != k)
            result += t.scale * t.scale * area[f] / (i == j || j == k ? 30. : 60.) *
                      std::abs(density[t.corner[3 * f + j]]) * norm(p[k] - p[i]);
  }
  return result;
}

// Returns the cost of a flow of the finest level if it is made continuous across edges, on the
// surface without obstacles.
double Multilevel_transport_solver::cost_of_flow(const Field& flow) const
{
  const Level& fine = m_levels.back();
  const auto open_mesh = cut_open(fine.triangles, fine.metric);
  const Operators o = operators(*open_mesh);
  const double cost = continuous_flow(*open_mesh, o, flow, cut_open(fine.metric)).cost;
  // The flow on triangles without area, which are thickened to compute it, is moved along edges.
  const Vector masses =
      minus_divergence(operators(*open_mesh, Degenerate_triangles::thickened), flow) -
      minus_divergence(o, flow);
  return masses.isZero(0.)
             ? cost
             : cost + Spanning_forest(metric_operators(*fine.triangles, fine.metric)).cost(masses);
}

std::shared_ptr<const Surface_arrays> Multilevel_transport_solver::open_triangles() const
{
  return cut_open(m_levels.front().triangles, m_levels.front().metric);
}

bool Multilevel_transport_solver::has_surface_metric() const
{
  const Level& coarse = m_levels.front();
  return std::all_of(coarse.metric.begin(), coarse.metric.end(),
                     [&](const Metric_tensor& tensor)
                     {
                       return tensor == Metric_tensor{1., 0., 1.} ||
                              (is_blocked(tensor) && !coarse.triangles->is_cloud());
                     });
}

Streamlines Multilevel_transport_solver::streamlines(const Transport_result& result) const
{
  const Level& coarse = m_levels.front();
  const auto open_mesh = open_triangles();
  const double scale = coarse.triangles->scale;
  Field flow = result.flow;
  for(Vec2& vector : flow)
    vector = scale * vector;
  const Operators thickened_operators = operators(*open_mesh, Degenerate_triangles::thickened);
  const Vector from = masses_at_vertices(*open_mesh, coarse.area, result.from);
  const Vector to = from + minus_divergence(thickened_operators, flow);

  // A negative source mass is a target mass, and conversely.
  Moved_masses masses;
  masses.source_masses = from.cwiseMax(0.) - to.cwiseMin(0.);
  masses.target_masses = to.cwiseMax(0.) - from.cwiseMin(0.);
  masses.has_point_sources = result.from.density.size() == 0;
  masses.has_point_targets = result.to.density.size() == 0;
  for(const auto& [location, mass] : result.from.at_locations)
    masses.source_locations.push_back(location);
  for(const auto& [location, mass] : result.to.at_locations)
    masses.target_locations.push_back(location);
  if(open_mesh->is_cloud())
    return Streamlines(open_mesh, thickened_operators, flow, std::move(masses));
  return Streamlines(
      open_mesh, continuous_flow(*open_mesh, operators(*open_mesh), flow, cut_open(coarse.metric)),
      std::move(masses));
}

Transport_result Multilevel_transport_solver::solve(const Mass_distribution& from,
                                                    const Mass_distribution& to,
                                                    const Transport_options& options) const
{
  const Level& coarse = m_levels.front();
  Transport_result result = transport_masses(
      difference(*coarse.triangles, coarse.area, from, to, options.do_normalize), options);
  const auto normalized = [&](const Mass_distribution& distribution)
  {
    if(!options.do_normalize)
      return distribution;
    return scaled(distribution,
                  1. / masses_at_vertices(*coarse.triangles, coarse.area, distribution).sum());
  };
  result.from = normalized(from);
  result.to = normalized(to);
  return result;
}

Transport_result
Multilevel_transport_solver::solve_to_region(const Mass_distribution& from,
                                             const Transport_options& options) const
{
  const Mass_distribution embedded_from =
      m_curve_embedding ? m_curve_embedding->refined(from) : from;
  const Level& coarse = base();
  const Vector at_vertices = masses_at_vertices(*coarse.triangles, coarse.area, embedded_from);
  Mass_distribution to;
  const Index first = coarse.exits.front().front();
  to.at_locations = {{{none, first, {}}, at_vertices.sum()}};
  Mass_distribution masses =
      difference(*coarse.triangles, coarse.area, embedded_from, to, options.do_normalize);
  const double factor = options.do_normalize ? 1. / at_vertices.sum() : 1.;
  // With limits the target masses are unknown, so that difference() only serves to check.
  if(m_region.is_limited())
    masses = scaled(embedded_from, -factor);
  Transport_result result = transport_masses(masses, options);

  for(const std::vector<Index>& exit : coarse.exits)
    for(const Index vertex : exit)
      result.potential[vertex] = result.potential[exit.front()];
  if(!m_region.is_limited())
    result.potential.array() -= double(result.potential[first]);

  result.arrivals = arrivals(result.flow, factor * at_vertices);
  result.from = scaled(from, factor);
  if(m_curve_embedding)
  {
    result.arrivals = m_curve_embedding->coarsened(result.arrivals);
    result.flow = m_curve_embedding->coarsened(result.flow);
    result.potential.conservativeResize(result.arrivals.size());
  }
  return result;
}

// #vertices of the base level: the mass that a flow carries to each vertex of the region.
//
// A uniform flow carries the flux through half of the adjacent edges to a vertex. At obtuse angles,
// other flows can carry a negative mass to a vertex, and as much more to its neighbors. Negative
// masses are set to zero such that the sum over an exit remains equal. With limits, mass that starts
// at an exit can leave it. The mass that stays is then divided as the mass that starts there.
Vector Multilevel_transport_solver::arrivals(const Field& flow, const Vector& source_masses) const
{
  const Level& coarse = base();
  const double scale = coarse.triangles->scale;
  const Vector inflow =
      minus_divergence(operators(*coarse.triangles, Degenerate_triangles::thickened), flow);
  Vector result = Vector::Zero(source_masses.size());
  for(const std::vector<Index>& exit : coarse.exits)
  {
    double sum = 0., positive = 0., sources = 0.;
    for(const Index vertex : exit)
    {
      sum += inflow[vertex];
      positive += std::max(inflow[vertex], 0.);
      sources += source_masses[vertex];
    }
    const double factor = positive > 0. ? std::max(sum, 0.) / positive : 0.;
    const double staying =
        sources > 0. ? std::max(sources + scale * std::min(sum, 0.), 0.) / sources : 1.;
    for(const Index vertex : exit)
      result[vertex] =
          scale * factor * std::max(inflow[vertex], 0.) + staying * source_masses[vertex];
  }
  return result;
}

// Solves on the last two levels, or on the last one if there is no refinement.
Multilevel_transport_solver::Finest_solution
Multilevel_transport_solver::solve_levels(Mass_distribution masses,
                                          const Transport_options& options) const
{
  const std::size_t finest = m_levels.size() - 1;
  Finest_solution solution = {{}, std::move(masses), 0.};
  Transport_options level_options = options;
  level_options.warm_start = {};
  // The coarse level takes about a fifth of the time.
  double progress = 0., stage_weight = finest > base_level() ? 0.2 : 1.;
  bool is_cancelled = false;
  if(options.callback) // not called again after it has returned false
    level_options.callback = [&](double fraction)
    {
      is_cancelled = is_cancelled || !options.callback(progress + stage_weight * fraction);
      return !is_cancelled;
    };
  for(std::size_t level = base_level(); level <= finest; ++level)
  {
    const Level& current = m_levels[level];
    if(level > base_level())
      solution.masses =
          refined(*m_levels[level - 1].triangles, *current.triangles, solution.masses);
    if(!current.solver)
      continue;
    // The unit of length halves with each refinement.
    solution.coarse_value = current.triangles->scale * 2. * solution.result.value;
    if(level == finest)
      level_options.warm_start = options.warm_start; // the final state of a query of this level
    Vector vertex_masses = masses_at_vertices(*current.triangles, current.area, solution.masses);
    merge_vertices(vertex_masses, current.exits);
    solution.result = current.solver->solve(vertex_masses, level_options, limited_exits(current));
    // Merging vertices changes distances by the lengths of the merged edges, so that the first
    // attempt is limited to edges of length zero, up to round-off errors.
    const bool can_merge =
        is_stuck(solution.result, options) && current.exits.empty() && current.metric.empty();
    for(const double max_length : {1e-9, 1e-6, 1e-4, 1e-3})
      if(can_merge && !solution.result.is_converged && !is_cancelled)
        if(const Close_vertices close = close_vertices(*current.triangles, max_length);
           !close.groups.empty())
        {
          level_options.warm_start = {};
          Transport_result merged =
              solve_with_merged_vertices(*current.triangles, vertex_masses, close, level_options);
          if(merged.upper - merged.lower < solution.result.upper - solution.result.lower)
            solution.result = std::move(merged);
        }
    progress = stage_weight;
    stage_weight = 1. - stage_weight;
  }
  return solution;
}

Transport_result
Multilevel_transport_solver::transport_masses(Mass_distribution masses,
                                              const Transport_options& options) const
{
  Finest_solution solution = solve_levels(std::move(masses), options);
  Transport_result result = std::move(solution.result);
  const std::vector<Metric_tensor>& metric = m_levels.back().metric;
  for(std::size_t f = 0; f < metric.size(); ++f)
    if(!is_blocked(metric[f]))
      result.flow[f] = product(inverse(metric[f]), result.flow[f]);
  if(options.do_bound_from_above)
    result.upper_continuous =
        cost_of_flow(result.flow) + result.remaining_cost + cost_to_vertices(solution.masses);
  rescale(result, m_levels.back().triangles->scale);
  const std::size_t finest = m_levels.size() - 1;
  if(finest > base_level())
    result.estimate = 2. * result.value - solution.coarse_value;
  result.potential.conservativeResize(Eigen::Index(base().triangles->number_of_vertices()));
  for(std::size_t level = finest; level > base_level(); --level)
    result.flow = coarsened(result.flow);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
