// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Earth_movers.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/transport/continuous_flow.h>
#include "transport/flat_refinement.h"
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Sites of a surface that was refined: those of the coarse one, and middles between two of them.
std::vector<Index> refined(const Glued_triangles& coarse, const Glued_triangles& fine,
                           const std::vector<Index>& region)
{
  Vector is_inside = Vector::Zero(Eigen::Index(coarse.number_of_sites()));
  for(const Index site : region)
    is_inside[site] = 1.;
  const Vector inside = refined(coarse, fine, is_inside);
  std::vector<Index> result;
  for(Index site = 0; site < inside.size(); ++site)
    if(inside[site] == 1.)
      result.push_back(site);
  return result;
}

// One unknown for all sites of an exit, the first one's.
void merge(Operators& operators, const std::vector<std::vector<Index>>& exits)
{
  std::vector<Index> unknown(operators.number_of_sites);
  std::iota(unknown.begin(), unknown.end(), Index(0));
  for(const std::vector<Index>& exit : exits)
    for(const Index site : exit)
      unknown[site] = exit.front();
  for(Index& site : operators.corner)
    site = unknown[site];
}

// What is missing there, in the first site.
void merge(Vector& masses, const std::vector<std::vector<Index>>& exits)
{
  for(const std::vector<Index>& exit : exits)
    for(const Index site : exit)
      if(site != exit.front())
        masses[exit.front()] += std::exchange(masses[site], 0.);
}

// Not glued where nothing may pass on one side.
std::shared_ptr<const Glued_triangles> opened(const std::shared_ptr<const Glued_triangles>& whole,
                                              const std::vector<Tensor>& measure)
{
  if(whole->is_cloud() || std::none_of(measure.begin(), measure.end(), is_blocked))
    return whole;
  Glued_triangles result = *whole;
  for(Index side = 0; side < result.twin.size(); ++side)
    if(const Index twin = whole->twin[side];
       twin != none && is_blocked(measure[side / 3]) != is_blocked(measure[twin / 3]))
      result.twin[side] = none;
  return std::make_shared<const Glued_triangles>(std::move(result));
}

std::vector<Tensor> opened(std::vector<Tensor> measure)
{
  std::replace_if(measure.begin(), measure.end(), is_blocked, Tensor{1., 0., 1.});
  return measure;
}

Mass_distribution scaled(Mass_distribution masses, double factor)
{
  masses.at_sites *= factor;
  for(auto& [location, mass] : masses.at_locations)
    mass *= factor;
  masses.density *= factor;
  return masses;
}

void check(const Transport_region& region)
{
  if(!region.capacity.empty() && region.capacity.size() != region.exits.size())
    throw Invalid_argument_error("There are " + std::to_string(region.capacity.size()) +
                                 " capacities for " + std::to_string(region.exits.size()) +
                                 " exits.");
  for(const double capacity : region.capacity)
    if(!(capacity > 0.))
      throw Invalid_argument_error("A capacity is not positive.");
  if(!(region.spreading_weight >= 0.) || !std::isfinite(region.spreading_weight))
    throw Invalid_argument_error("The weight of spreading is negative or not finite.");
}

// Without limits all exits are one.
std::vector<std::vector<Index>> distinct(std::vector<std::vector<Index>> exits, bool is_limited)
{
  if(!is_limited && exits.size() > 1)
  {
    for(std::size_t i = 1; i < exits.size(); ++i)
      exits[0].insert(exits[0].end(), exits[i].begin(), exits[i].end());
    exits.resize(1);
  }
  std::vector<Index> sites;
  for(std::vector<Index>& exit : exits)
  {
    std::sort(exit.begin(), exit.end());
    exit.erase(std::unique(exit.begin(), exit.end()), exit.end());
    sites.insert(sites.end(), exit.begin(), exit.end());
  }
  std::sort(sites.begin(), sites.end());
  if(std::adjacent_find(sites.begin(), sites.end()) != sites.end())
    throw Invalid_argument_error("Two exits share a site.");
  return exits;
}

} // namespace

Earth_movers::Earth_movers(std::shared_ptr<const Glued_triangles> triangles, unsigned refinements,
                           std::vector<Tensor> measure, Transport_region region)
    : m_region(std::move(region))
{
  check(m_region);
  if(std::ldexp(double(triangles->corner.size()), 2 * int(std::min(refinements, 30u))) > 2e9)
    throw Unsupported_surface_error("The refined surface would have more than 2^31 half-edges.");
  std::vector<std::vector<Index>> exits = m_region.exits;
  if(!m_region.curves.empty())
  {
    if(triangles->is_cloud())
      throw Invalid_argument_error("A region of a cloud has a location that is not at a surfel.");
    std::vector<Index> whole;
    for(const std::vector<Index>& exit : exits)
      whole.insert(whole.end(), exit.begin(), exit.end());
    m_inscription.emplace(triangles, m_region.curves, whole);
    for(std::size_t i = 0; i < exits.size(); ++i)
      if(exits[i].empty())
        exits[i] = m_inscription->sites()[i];
    add_level(triangles, measure, {});
    triangles = m_inscription->triangles();
    measure = m_inscription->refined(measure);
  }
  add_level(triangles, measure, distinct(std::move(exits), m_region.is_limited()));
  if(!m_region.is_empty())
  {
    Operators operators = measured_operators(*triangles, measure);
    merge(operators, m_levels.back().exits);
    const auto [component, number] = components(operators);
    std::vector<bool> has_exit(number, false);
    for(const std::vector<Index>& exit : m_levels.back().exits)
      has_exit[component[exit.front()]] = true;
    for(const Index label : component)
      m_reaches_region.push_back(has_exit[label]);
    for(const std::vector<Index>& exit : m_levels.back().exits)
      for(const Index site : exit)
        m_reaches_region[site] = true;
  }
  for(unsigned level = 0; level < refinements; ++level)
  {
    const Level& coarse = m_levels.back();
    triangles = std::make_shared<const Glued_triangles>(refined(*coarse.triangles));
    exits.clear();
    for(const std::vector<Index>& exit : coarse.exits)
      exits.push_back(refined(*coarse.triangles, *triangles, exit));
    for(const Tensor& tensor : std::exchange(measure, {}))
      measure.insert(measure.end(), 4, tensor);
    add_level(triangles, measure, std::move(exits));
  }
  for(std::size_t level =
          std::max(base(), m_levels.size() - std::min<std::size_t>(m_levels.size(), 2));
      level < m_levels.size(); ++level)
  {
    Level& here = m_levels[level];
    Operators operators = measured_operators(*here.triangles, here.measure);
    merge(operators, here.exits);
    here.solver = std::make_unique<Transport_solver>(std::move(operators));
  }
}

void Earth_movers::add_level(std::shared_ptr<const Glued_triangles> triangles,
                             std::vector<Tensor> measure, std::vector<std::vector<Index>> exits)
{
  m_levels.emplace_back();
  Level& level = m_levels.back();
  level.area = measured_operators(*triangles, measure).area;
  level.triangles = std::move(triangles);
  level.measure = std::move(measure);
  level.exits = std::move(exits);
}

std::vector<Exit> Earth_movers::limited_exits(const Level& level) const
{
  std::vector<Exit> result;
  if(!m_region.is_limited())
    return result;
  const Level& coarse = m_levels[base()];
  const double scale = coarse.triangles->scale;
  for(std::size_t i = 0; i < coarse.exits.size(); ++i)
  {
    double area = 0.;
    for(const Index site : coarse.exits[i])
      for(Index k = coarse.triangles->first[site]; k < coarse.triangles->first[site + 1]; ++k)
        area += scale * scale * coarse.area[coarse.triangles->star[k] / 3] / 3.;
    const double weight = m_region.spreading_weight;
    result.push_back({level.exits[i].front(),
                      m_region.capacity.empty() ? infinity : m_region.capacity[i],
                      weight > 0. ? 2. * weight / (area * level.triangles->scale) : 0.});
  }
  return result;
}

// At most what it costs to move masses within the finest triangles to those at sites.
double Earth_movers::cost_to_sites(const Mass_distribution& masses) const
{
  const Glued_triangles& t = *m_levels.back().triangles;
  const std::vector<Tensor>& measure = m_levels.back().measure;
  const auto places = [&](std::size_t f)
  {
    auto result = unfolded(t, Index(f));
    if(!measure.empty())
      for(Planar& p : result)
        p = product(measure[f], p);
    return result;
  };
  double result = 0.;
  for(const auto& [location, mass] : masses.at_locations)
    if(location.triangle != none)
    {
      if(!measure.empty() && is_blocked(measure[location.triangle]))
        return infinity;
      const auto p = places(location.triangle);
      const Planar place = unfolded_point(p, location.barycentric);
      for(std::size_t k = 0; k < 3; ++k)
        result += std::abs(mass * location.barycentric[k]) * norm(place - p[k]);
    }
  if(masses.density.size() == 0)
    return result;
  // The hats of corners i, j and k: the i-th part of the density's share of j, as far as k at most, as
  // distance is convex.
  const std::vector<double>& area = m_levels.back().area;
  for(std::size_t f = 0; f < area.size(); ++f)
  {
    if(area[f] == 0.)
      continue;
    const auto p = places(f);
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        for(std::size_t k = 0; k < 3; ++k)
          if(i != k)
            result += t.scale * t.scale * area[f] / (i == j || j == k ? 30. : 60.) *
                      std::abs(masses.density[t.corner[3 * f + j]]) * norm(p[k] - p[i]);
  }
  return result;
}

// On the surface itself; what is blocked is no part of it.
double Earth_movers::cost_of_flow(const Field& flow) const
{
  const Level& fine = m_levels.back();
  const auto open = opened(fine.triangles, fine.measure);
  return continuous_flow(*open, operators(*open), flow, opened(fine.measure)).cost;
}

std::shared_ptr<const Glued_triangles> Earth_movers::open_triangles() const
{
  return opened(m_levels.front().triangles, m_levels.front().measure);
}

bool Earth_movers::has_own_lengths() const
{
  const Level& coarse = m_levels.front();
  return std::all_of(coarse.measure.begin(), coarse.measure.end(),
                     [&](const Tensor& tensor) {
                       return tensor == Tensor{1., 0., 1.} ||
                              (is_blocked(tensor) && !coarse.triangles->is_cloud());
                     });
}

Streamlines Earth_movers::streamlines(const Earth_movers_result& result) const
{
  const Level& coarse = m_levels.front();
  const auto open = open_triangles();
  const double scale = coarse.triangles->scale;
  Field flow = result.flow;
  for(Planar& vector : flow)
    vector = scale * vector;
  const Operators flat = operators(*open, Flat_triangles::raised);
  const Vector from = masses_at_sites(*open, coarse.area, result.from);
  const Vector to = from + divergence(flat, flow);

  // What is negative before is there after.
  Moved_masses masses;
  masses.before = from.cwiseMax(0.) - to.cwiseMin(0.);
  masses.after = to.cwiseMax(0.) - from.cwiseMin(0.);
  masses.are_points_before = result.from.density.size() == 0;
  masses.are_points_after = result.to.density.size() == 0;
  for(const auto& [place, mass] : result.from.at_locations)
    masses.places_before.push_back(place);
  for(const auto& [place, mass] : result.to.at_locations)
    masses.places_after.push_back(place);
  if(open->is_cloud())
    return Streamlines(open, flat, flow, std::move(masses));
  return Streamlines(open, continuous_flow(*open, operators(*open), flow, opened(coarse.measure)),
                     std::move(masses));
}

Earth_movers_result Earth_movers::solve(const Mass_distribution& from, const Mass_distribution& to,
                                        const Earth_movers_options& options) const
{
  const Level& coarse = m_levels.front();
  Earth_movers_result result =
      move(difference(*coarse.triangles, coarse.area, from, to, options.do_normalize), options);
  const auto moved = [&](const Mass_distribution& side)
  {
    if(!options.do_normalize)
      return side;
    return scaled(side, 1. / masses_at_sites(*coarse.triangles, coarse.area, side).sum());
  };
  result.from = moved(from);
  result.to = moved(to);
  return result;
}

Earth_movers_result Earth_movers::solve_to_region(const Mass_distribution& from,
                                                  const Earth_movers_options& options) const
{
  const Mass_distribution there = m_inscription ? m_inscription->refined(from) : from;
  const Level& coarse = m_levels[base()];
  const Vector at_sites = masses_at_sites(*coarse.triangles, coarse.area, there);
  Mass_distribution to;
  const Index first = coarse.exits.front().front();
  to.at_locations = {{{none, first, {}}, at_sites.sum()}};
  Mass_distribution masses =
      difference(*coarse.triangles, coarse.area, there, to, options.do_normalize);
  if(m_region.is_limited()) // where it goes is not known
    masses.at_locations.erase(masses.at_locations.begin());
  Earth_movers_result result = move(masses, options);

  for(const std::vector<Index>& exit : coarse.exits)
    for(const Index site : exit)
      result.potential[site] = result.potential[exit.front()];
  if(!m_region.is_limited())
    result.potential.array() -= double(result.potential[first]);

  const double scale = coarse.triangles->scale;
  const Vector missing =
      divergence(operators(*coarse.triangles, Flat_triangles::raised), result.flow);
  const double factor = options.do_normalize ? 1. / at_sites.sum() : 1.;
  result.arrivals = Vector::Zero(at_sites.size());
  for(const std::vector<Index>& exit : coarse.exits)
    for(const Index site : exit)
      result.arrivals[site] = scale * missing[site] + factor * at_sites[site];
  result.from = scaled(from, factor);
  if(m_inscription)
  {
    result.arrivals = m_inscription->coarsened(result.arrivals);
    result.flow = m_inscription->coarsened(result.flow);
    result.potential.conservativeResize(result.arrivals.size());
  }
  return result;
}

Earth_movers_result Earth_movers::move(Mass_distribution masses,
                                       const Earth_movers_options& options) const
{
  const std::size_t finest = m_levels.size() - 1;
  Earth_movers_result result;
  Transport_options transport = options.transport;
  transport.start = {};
  double done = 0., part = finest > base() ? 0.2 : 1.; // of the time, about
  bool is_cancelled = false;
  if(options.transport.callback) // not asked again after it said no
    transport.callback = [&](double fraction)
    {
      is_cancelled = is_cancelled || !options.transport.callback(done + part * fraction);
      return !is_cancelled;
    };
  double before = 0.; // the value on the surface that is refined once less
  for(std::size_t level = base(); level <= finest; ++level)
  {
    const Level& here = m_levels[level];
    if(level > base())
      masses = refined(*m_levels[level - 1].triangles, *here.triangles, masses);
    if(!here.solver)
      continue;
    before = here.triangles->scale * 2. * result.value;
    if(level == finest)
      transport.start = options.transport.start; // which ended there
    Vector missing = masses_at_sites(*here.triangles, here.area, masses);
    merge(missing, here.exits);
    static_cast<Transport&>(result) = here.solver->solve(missing, transport, limited_exits(here));
    done = part;
    part = 1. - part;
  }
  const double scale = m_levels.back().triangles->scale;
  const std::vector<Tensor>& measure = m_levels.back().measure;
  for(std::size_t f = 0; f < measure.size(); ++f)
    if(!is_blocked(measure[f]))
      result.flow[f] = product(inverse(measure[f]), result.flow[f]);
  if(options.do_bound_from_above)
    result.upper_continuous = scale * (cost_of_flow(result.flow) + cost_to_sites(masses));
  rescale(result, scale);
  result.estimate = finest > base() ? 2. * result.value - before : result.value;
  result.potential.conservativeResize(Eigen::Index(m_levels[base()].triangles->number_of_sites()));
  for(std::size_t level = finest; level > base(); --level)
    result.flow = coarsened(result.flow);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
