// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/sampling/tessellation.h>

#include <CGAL/Geodesic_processing/internal/log_map/log_map.h>
#include "mesh/patches.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "distances/rows.h"
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include <CGAL/Geodesic_processing/internal/log_map/tangent_plane.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The stencil by which the gradient is measured: three directions are the least that do not see the even
// terms, and on a plane any length is right.  A longer one averages the errors of fronts.
constexpr std::size_t directions = 3;
constexpr double stencil_part = 0.25; // of the radius of the cell

// What is gone of the way to the mean, at first: cells follow their centres, so that further steps go on in
// the same direction.
constexpr double overrelaxation = 1.8;

// A centre that would go less far, in radii of its cell, stays.
constexpr double least_move = 1e-3;

// What is lower by less may be so by rounding.
constexpr double rounding = 1e-12;

// How often cells are added, and up to how many for each site, before patches are cut in two.
constexpr unsigned most_rounds = 20;
constexpr double most_cells = 0.1;

// Where handles ask for so many times as many cells as the caller did, these are moved once: each is where a
// handle is, and of a surface with thousands of handles every step costs seconds.
constexpr double many_more = 4.;

class Lloyd
{
public:
  Lloyd(std::shared_ptr<const Glued_triangles> triangles, const Front& front,
        std::shared_ptr<const std::vector<double>> slowness, const Tessellation_options& options)
      : m_triangles(std::move(triangles)), m_front(front), m_options(options),
        m_mass(m_triangles->number_of_sites(), 0.)
  {
    m_limits.slowness = std::move(slowness);
    const Glued_triangles& t = *m_triangles;
    for(Index f = 0; f < t.number_of_triangles(); ++f)
      if(const double s = slowness_of(f); s < infinity)
      {
        const double* const side = &t.length[3 * std::size_t(f)];
        const double weight = t.weight.empty() ? 1. : double(t.weight[f]);
        for(Index corner = 3 * f; corner < 3 * f + 3; ++corner)
          m_mass[t.corner[corner]] += weight * s * s * twice_area(side[0], side[1], side[2]) / 6.;
      }
  }

  Tessellation run()
  {
    m_is_finished = start() && (has_many_handles() || relax(m_options.most_steps));
    if(m_triangles->is_cloud())
      return {m_state.centers, m_state.cells, m_state.energies, m_is_finished};
    make_patches();
    leave_out_empty_patches();
    return {m_state.centers, m_state.patches, m_state.energies, m_is_finished};
  }

private:
  struct State
  {
    std::vector<Location> centers;
    std::vector<double> distances; // #sites: from the nearest centre
    std::vector<Index> cells;      // #sites: of this centre
    std::vector<Index> patches;    // #triangles, on a mesh
    std::vector<double> energies;
  };

  double slowness_of(Index triangle) const
  {
    return m_limits.slowness ? (*m_limits.slowness)[triangle] : 1.;
  }

  // More handles than there shall be cells, that are to be discs, as Euler's formula tells, two holes counting as
  // much as a handle: nearly each cell will be cut, and what it costs to move them before that is lost.
  bool has_many_handles() const
  {
    if(!m_options.makes_discs)
      return false;
    const Glued_triangles& t = *m_triangles;
    long long euler = t.number_of_triangles();
    for(Index side = 0; side < t.twin.size(); ++side)
      euler -= t.twin[side] == none || side < t.twin[side];
    for(Index site = 0; site < t.number_of_sites(); ++site)
      euler += t.first[site] < t.first[site + 1];
    return euler < -2 * static_cast<long long>(m_options.number);
  }

  double energy() const
  {
    double sum = 0.;
    for(Index site = 0; site < m_mass.size(); ++site)
      if(m_state.cells[site] != none)
        sum += m_mass[site] * m_state.distances[site] * m_state.distances[site];
    return sum;
  }

  bool start()
  {
    Sampling sampling(m_triangles, m_front,
                      m_triangles->is_cloud() ? Sample_place::site : Sample_place::triangle,
                      m_limits.slowness);
    Sampling_goal goal;
    goal.number = m_options.number;
    goal.seed = m_options.seed;
    if(m_options.callback)
      goal.callback = [&](double) { return m_options.callback(0.); };
    const bool is_whole = sample_farthest(sampling, goal, [](double) {});
    m_state.centers = sampling.samples();
    m_state.distances = sampling.distances();
    m_state.cells = sampling.labels();
    m_state.energies = {energy()};
    return is_whole;
  }

  bool relax(unsigned steps)
  {
    for(unsigned step = 0; step < steps; ++step)
    {
      if(!take_step(double(step) / double(steps)))
        return false;
      if(is_stalled())
        break;
    }
    return true;
  }

  bool take_step(double fraction_done)
  {
    if(m_options.callback && !m_options.callback(fraction_done))
      return false;
    move_centers();
    update_cells(0);
    m_state.energies.push_back(energy());
    return true;
  }

  bool is_stalled() const
  {
    const double before = m_state.energies[m_state.energies.size() - 2];
    return !(m_state.energies.back() < (1. - m_options.least_gain) * before);
  }

  // Every cell on its own, as its centre and the distances of its sites belong to no other.
  void move_centers()
  {
    std::vector<std::vector<Index>> sites(m_state.centers.size());
    for(Index site = 0; site < m_mass.size(); ++site)
      if(m_state.cells[site] != none && m_mass[site] > 0.)
        sites[m_state.cells[site]].push_back(site);
    for_each_row(m_front, sites.size(), m_limits, m_options.threads,
                 [&](std::size_t cell, Front& front, const Front_limits& limits)
                 { move_center(m_state.centers[cell], sites[cell], front, limits); });
  }

  void move_center(Location& center, const std::vector<Index>& sites, Front& front,
                   Front_limits limits)
  {
    const Glued_triangles& t = *m_triangles;
    double mass = 0., before = 0., radius = 0.;
    std::vector<double> distances;
    for(const Index site : sites)
    {
      distances.push_back(m_state.distances[site]);
      mass += m_mass[site];
      before += m_mass[site] * distances.back() * distances.back();
      radius = std::max(radius, distances.back());
    }
    const Location at = t.is_cloud() ? center : cleaned(t, center);
    const Index triangle = triangle_around(at);
    if(!(radius > 0.) || triangle == none)
      return;
    const double slowness = slowness_of(triangle);
    if(!(slowness < infinity))
      return;
    const double length = stencil_part * radius / slowness;
    // The integral of squared distances from a place; what its front does not reach counts as much as
    // if it went by the centre.
    const auto measure = [&](const Location& place, double way, std::vector<double>* found)
    {
      limits.maximum_distance = radius + 2. * way * slowness;
      front.run({Source{{place}}}, limits);
      double sum = 0.;
      for(std::size_t i = 0; i < sites.size(); ++i)
      {
        double distance = front.distance(sites[i]);
        if(!(distance < infinity))
          distance = distances[i] + way * slowness;
        sum += m_mass[sites[i]] * distance * distance;
        if(found)
          (*found)[i] = distance;
      }
      return sum;
    };

    const Tangent_plane plane(t, at);
    const Stencil stencil = make_stencil(plane, sites, length);
    // Of the gradient g at the centre, by least squares of E(q) - E(0) = g q + M |q|^2.
    double xx = 0., xy = 0., yy = 0.;
    Planar b = {0., 0.};
    for(std::size_t j = 0; j < stencil.places.size(); ++j)
    {
      const Planar& q = stencil.vectors[j];
      const double way = norm(q), square = slowness * slowness * way * way;
      const double rise = measure(stencil.places[j], way, nullptr) - before - mass * square;
      xx += q[0] * q[0];
      xy += q[0] * q[1];
      yy += q[1] * q[1];
      b = b + rise * q;
    }
    const double determinant = xx * yy - xy * xy;
    if(!(determinant > 1e-4 * (xx + yy) * (xx + yy)))
      return;
    const Planar gradient =
        (1. / determinant) * Planar{yy * b[0] - xy * b[1], xx * b[1] - xy * b[0]};
    // Beyond the mean of the logarithms, to it, or a part of the way.
    const Planar mean = (-0.5 / (mass * slowness * slowness)) * gradient;
    std::vector<double> found(sites.size());
    for(double way = std::min(overrelaxation * norm(mean), radius / slowness);
        way * slowness > least_move * radius; way /= 2.)
    {
      const Location place = end_of(plane, (way / norm(mean)) * mean, sites);
      if(measure(place, way, &found) < (1. - rounding) * before)
      {
        center = place;
        for(std::size_t i = 0; i < sites.size(); ++i)
          m_state.distances[sites[i]] = found[i];
        return;
      }
    }
  }

  Index triangle_around(const Location& at) const
  {
    const Glued_triangles& t = *m_triangles;
    if(!t.is_cloud())
      return triangle_at(t, at);
    return t.first[at.site] == t.first[at.site + 1] ? none : t.star[t.first[at.site]] / 3;
  }

  Stencil make_stencil(const Tangent_plane& plane, const std::vector<Index>& sites,
                       double length) const
  {
    return m_triangles->is_cloud()
               ? stencil_of_sites(*m_triangles, plane, sites, m_state.distances, length, directions)
               : straight_stencil(plane, length, directions);
  }

  // Where a tangent vector leads: on a cloud to the site of the cell that is the nearest to it.
  Location end_of(const Tangent_plane& plane, const Planar& vector,
                  const std::vector<Index>& sites) const
  {
    const Glued_triangles& t = *m_triangles;
    if(!t.is_cloud())
      return plane.straight(std::atan2(vector[1], vector[0]), norm(vector)).locations.back();
    const Spatial end = plane.point() + vector[0] * plane.x() + vector[1] * plane.y();
    const auto squared = [&](Index site)
    {
      const Spatial way = t.point[site] - end;
      return dot(way, way);
    };
    Location result;
    result.site = *std::min_element(sites.begin(), sites.end(),
                                    [&](Index a, Index b) { return squared(a) < squared(b); });
    return result;
  }

  // Sites that are nearer to other centres than to their own, of which all from `first` on are looked at.
  void update_cells(std::size_t first)
  {
    // The sites of its own cell are as far from a centre as is known: it has to get to their end.
    std::vector<double> known = m_state.distances;
    for(double& distance : known)
      distance *= 1. + 1e-9;
    Front_limits limits = m_limits;
    limits.known = &known;
    std::vector<std::vector<std::pair<Index, double>>> nearer(m_state.centers.size() - first);
    for_each_row(m_front, nearer.size(), limits, m_options.threads,
                 [&](std::size_t i, Front& front, const Front_limits& own)
                 {
                   front.run({Source{{m_state.centers[first + i]}}}, own);
                   for(const Index site : front.reached())
                     if(front.distance(site) < m_state.distances[site])
                       nearer[i].emplace_back(site, front.distance(site));
                 });
    for(std::size_t i = 0; i < nearer.size(); ++i)
      for(const auto& [site, distance] : nearer[i])
        if(distance < m_state.distances[site])
        {
          m_state.distances[site] = distance;
          m_state.cells[site] = Index(first + i);
        }
  }

  void make_patches()
  {
    const Glued_triangles& t = *m_triangles;
    m_state.patches = tidied_patches();
    if(!m_options.makes_discs || !m_is_finished)
      return;
    // A cell around a tube becomes two where it is farthest from its centre.
    const std::size_t asked = m_state.centers.size();
    for(unsigned round = 0; round < most_rounds; ++round)
    {
      const std::vector<Location> added = farthest_of_no_discs();
      const std::size_t before = m_state.centers.size();
      if(added.empty() || before + added.size() > most_cells * double(m_mass.size()))
        break;
      m_state.centers.insert(m_state.centers.end(), added.begin(), added.end());
      update_cells(before);
      m_state.energies.push_back(energy());
      m_state.patches = tidied_patches();
    }
    if(m_state.centers.size() > asked)
      relax_discs(asked);
    for(const Index triangle : split_into_discs(t, m_state.patches, Index(m_state.centers.size())))
      m_state.centers.push_back({triangle, none, {1. / 3., 1. / 3., 1. / 3.}});
  }

  // As long as as many patches are discs.
  void relax_discs(std::size_t asked)
  {
    const auto number_of_discs = [&]
    {
      const std::vector<bool> is_disc =
          are_discs(*m_triangles, m_state.patches, Index(m_state.centers.size()));
      return std::count(is_disc.begin(), is_disc.end(), true);
    };
    const auto before = number_of_discs();
    const bool are_many_more = m_state.centers.size() > many_more * double(asked);
    const unsigned most_steps = std::min(are_many_more ? 1u : ~0u, m_options.most_steps);
    for(unsigned step = 0; step < most_steps; ++step)
    {
      State last = m_state;
      m_is_finished = take_step(1.);
      if(!m_is_finished)
        break;
      m_state.patches = tidied_patches();
      const bool is_worse = number_of_discs() < before, is_last = is_stalled();
      if(is_worse)
        m_state = std::move(last);
      if(is_worse || is_last)
        break;
    }
  }

  // Cells between vertices, and those that were given away.
  void leave_out_empty_patches()
  {
    std::vector<Index> number(m_state.centers.size(), none);
    for(const Index patch : m_state.patches)
      if(patch != none)
        number[patch] = 0;
    std::vector<Location> kept;
    for(std::size_t i = 0; i < number.size(); ++i)
      if(number[i] == 0)
      {
        number[i] = Index(kept.size());
        kept.push_back(m_state.centers[i]);
      }
    for(Index& patch : m_state.patches)
      if(patch != none)
        patch = number[patch];
    m_state.centers = std::move(kept);
  }

  std::vector<Index> tidied_patches() const
  {
    std::vector<Index> result = patches(*m_triangles, m_state.distances, m_state.cells);
    tidy(*m_triangles, result);
    return result;
  }

  // A site of each patch that is no disc.
  std::vector<Location> farthest_of_no_discs() const
  {
    const Glued_triangles& t = *m_triangles;
    const std::vector<bool> is_disc = are_discs(t, m_state.patches, Index(m_state.centers.size()));
    std::vector<Index> farthest(is_disc.size(), none);
    for(Index corner = 0; corner < t.corner.size(); ++corner)
      if(const Index patch = m_state.patches[corner / 3]; patch != none && !is_disc[patch])
      {
        const Index site = t.corner[corner];
        Index& best = farthest[patch];
        if(m_state.distances[site] > (best == none ? 0. : m_state.distances[best]))
          best = site;
      }
    std::vector<Location> result;
    for(const Index site : farthest)
      if(site != none)
        result.push_back(at_site(t, site));
    return result;
  }

  std::shared_ptr<const Glued_triangles> m_triangles;
  const Front& m_front;
  const Tessellation_options& m_options;
  Front_limits m_limits;
  std::vector<double> m_mass; // #sites: the area around, in the metric
  State m_state;
  bool m_is_finished = true;
};

} // namespace

Tessellation tessellate(std::shared_ptr<const Glued_triangles> triangles, const Front& front,
                        std::shared_ptr<const std::vector<double>> slowness,
                        const Tessellation_options& options)
{
  return Lloyd(std::move(triangles), front, std::move(slowness), options).run();
}

} // namespace CGAL::Geodesic_processing::internal
