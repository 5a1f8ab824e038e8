// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/remeshing.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/spatial_search/Triangle_tree.h>
#include "mesh/crossings.h"
#include <CGAL/Geodesic_processing/internal/mesh/curves.h>
#include "remeshing/dual.h"
#include "remeshing/fitting.h"
#include "mesh/flips.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>
#include "sampling/relaxation.h"
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include "remeshing/smoothing.h"
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Sides longer than this part of the spacing of samples are halved: then a cell has some four sites.
constexpr double longest_part = 0.65;
// Where samples move, a little longer ones, which saves time.
constexpr double longest_part_of_relaxed = 0.75;
// But not with so many steps: a tenth to three quarters more time for 0.1 degrees of the mean of the least angles, 0.4 of
// their first percentile, and a distance of fitted vertices that is up to a tenth smaller, on six models.
constexpr std::size_t many_steps = 30;
constexpr double longest_part_of_well_relaxed = 0.5;

// Of a fit after many steps: nearer by 2 to 5 percent.
constexpr int careful_steps = 3;
// One in so many may be longer, by this factor at most: else all triangles would be glued anew for the sake of
// the last few sides.
constexpr std::size_t few_of = 50;
constexpr double little_longer = 1.5;
// But not beyond so many sites for each there was and for each sample: webs of needles would become
// webs of longer ones.
constexpr std::size_t most_for_a_site = 4, most_for_a_sample = 32;
// Each has six half-edges.
constexpr std::size_t most_vertices = (std::size_t(1) << 31) / 6;
// Of so many samples one is strewn where they are moved anyway: these take one front together, and what is
// farthest from all of them then fills the gaps.  With one of twenty the samples take three times as long,
// for 0.2 degrees of the mean of the least angles after twelve steps.
constexpr std::size_t strewn_part = 2;
// After samples have moved on the surface, between each other: as long as six steps there take, for 1.2 degrees of the
// mean of the least angles after twelve of these.  Half as many give 0.3 degrees less, twice as many 0.5 more.
constexpr int smoothing_steps = 20;
// Farther than any curve is long, in the domain's scale: it has less than 2^31 sides.
constexpr double longest_curve = 0x1p32;
// How often samples are added where triangles cross: on the models whose surfaces do not cross themselves
// five times are the most that were seen, in the folds of a brain.
constexpr int most_rounds_at_crossings = 10;
// How often sides are halved where all sites are samples: once or twice is enough for two triangles of
// the same corners.
constexpr int most_refinements = 20;

// The cells of samples, numbered: those that come to a site.
struct Cells
{
  std::vector<Index> labels;  // #sites: the cell of each, none where there is no triangle
  std::vector<Index> samples; // #cells: the sample of each
};

// The cells that a sampling knows, each in one part: where fronts were wrong by a rounding, or came
// around others, sites go over to a cell next to them.
Cells connected_cells(const Glued_triangles& t, const Sampling& sampling)
{
  const std::vector<double>& distances = sampling.distances();
  std::vector<Index> nearest(sampling.samples().size(), none); // the site of each sample
  for(const Index site : sampling.sites())
    if(Index& known = nearest[sampling.labels()[site]];
       known == none || distances[site] < distances[known])
      known = site;

  Cells result;
  result.labels.assign(t.number_of_sites(), none);
  std::vector<Index> reached;
  for(Index sample = 0; sample < nearest.size(); ++sample)
  {
    if(nearest[sample] == none)
      continue;
    const Index cell = Index(result.samples.size());
    result.samples.push_back(sample);
    reached = {nearest[sample]};
    result.labels[nearest[sample]] = cell;
    while(!reached.empty())
    {
      const Index site = reached.back();
      reached.pop_back();
      for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
        for(const Index corner : {next_side(t.star[i]), previous_side(t.star[i])})
          if(const Index next = t.corner[corner];
             result.labels[next] == none && sampling.labels()[next] == sample)
          {
            result.labels[next] = cell;
            reached.push_back(next);
          }
    }
  }

  std::vector<Index> apart;
  for(const Index site : sampling.sites())
    if(result.labels[site] == none)
      apart.push_back(site);
  while(!apart.empty())
  {
    std::vector<std::pair<Index, Index>> found; // site and cell
    std::vector<Index> left;
    for(const Index site : apart)
    {
      Index best = none;
      double least = infinity;
      const auto reach = [&](Index next, double length)
      {
        if(result.labels[next] != none && distances[next] + length < least)
        {
          best = result.labels[next];
          least = distances[next] + length;
        }
      };
      for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
      {
        const Index corner = t.star[i], previous = previous_side(corner);
        reach(t.corner[next_side(corner)], t.length[corner]);
        reach(t.corner[previous], t.length[previous]);
      }
      if(best == none)
        left.push_back(site);
      else
        found.emplace_back(site, best);
    }
    for(const auto& [site, cell] : found)
      result.labels[site] = cell;
    apart = std::move(left);
  }
  return result;
}

class Remesher
{
public:
  Remesher(const std::shared_ptr<const Glued_triangles>& triangles, const Remeshing_goal& goal)
      : m_goal(goal),
        m_coarse_curves(goal.is_curve.empty() ? border_and_sharp_sides(*triangles) : goal.is_curve),
        m_has_curves(std::find(m_coarse_curves.begin(), m_coarse_curves.end(), true) !=
                     m_coarse_curves.end())
  {
    use(refinement(triangles));
  }

  Remeshing run()
  {
    set_spacing();
    open_folds();
    refine();
    begin();
    m_result.is_finished = sample() && relax() && complete();
    return std::move(m_result);
  }

private:
  const Glued_triangles& t() const { return *m_surface.triangles; }
  double slowness(Index triangle) const { return m_slowness ? (*m_slowness)[triangle] : 1.; }
  // The size of our unit in that of the coarse triangles: a power of two.
  double unit_size() const { return t().scale / m_surface.coarse->scale; }
  bool tell(double done) const { return !m_goal.callback || m_goal.callback(done); }

  void use(Refinement surface)
  {
    m_surface = std::move(surface);
    // Where all sites are one point no site is farther than others: any lengths will do.
    if(std::all_of(t().length.begin(), t().length.end(), [](double l) { return l == 0.; }))
    {
      Glued_triangles spread = t();
      std::fill(spread.length.begin(), spread.length.end(), 1.);
      m_surface.triangles = std::make_shared<const Glued_triangles>(std::move(spread));
    }
    m_is_curve.assign(t().corner.size(), false);
    m_is_curve_site.assign(t().number_of_sites(), false);
    if(m_has_curves)
      mark_curves();
    m_slowness = m_goal.slowness;
    if(m_slowness && !m_surface.parent.empty())
    {
      std::vector<double> slownesses;
      for(const Index parent : m_surface.parent)
        slownesses.push_back((*m_goal.slowness)[parent]);
      m_slowness = std::make_shared<const std::vector<double>>(std::move(slownesses));
    }
  }

  void mark_curves()
  {
    const std::vector<Index> coarse = coarse_sides(m_surface);
    for(Index side = 0; side < coarse.size(); ++side)
      if(coarse[side] != none && m_coarse_curves[coarse[side]])
      {
        m_is_curve[side] = true;
        for(const Index corner : {side, next_side(side)})
          m_is_curve_site[t().corner[corner]] = true;
      }
  }

  // Of a honeycomb of so many cells, those at the border halved by it, that covers as much.
  void set_spacing()
  {
    double area = 0., border = 0.;
    for(Index f = 0; f < t().number_of_triangles(); ++f)
    {
      const double* const l = &t().length[3 * std::size_t(f)];
      area += 0.5 * slowness(f) * slowness(f) * twice_area(l[0], l[1], l[2]);
      for(Index side = 3 * f; side < 3 * f + 3; ++side)
        if(t().twin[side] == none)
          border += slowness(f) * t().length[side];
    }
    const double n = double(std::max<std::size_t>(m_goal.number, 1));
    const double quarter = border / 4.;
    m_spacing = std::max(
        (quarter + std::sqrt(quarter * quarter + 2. / std::sqrt(3.) * area * n)) / n, border / n);
    m_spacing *= unit_size();
  }

  // Halves the sides of two triangles of the same corners, which no samples at these can tell apart.
  void open_folds()
  {
    std::vector<bool> is_halved(t().corner.size(), false);
    bool has_folds = false;
    for(Index side = 0; side < is_halved.size(); ++side)
    {
      const Index other = t().twin[side], next = t().twin[next_side(side)];
      if(other == none || next == none || other / 3 != next / 3 || other / 3 == side / 3)
        continue;
      has_folds = true;
      for(Index k = 0; k < 3; ++k)
        for(const Index around : {3 * (side / 3) + k, 3 * (other / 3) + k})
        {
          is_halved[around] = true;
          if(t().twin[around] != none)
            is_halved[t().twin[around]] = true;
        }
    }
    if(has_folds)
      use(halved(m_surface, is_halved));
  }

  double part_of_spacing() const
  {
    if(m_goal.relaxation_steps == 0)
      return longest_part;
    return m_goal.relaxation_steps < many_steps ? longest_part_of_relaxed
                                                : longest_part_of_well_relaxed;
  }

  void refine()
  {
    const std::size_t most = most_for_a_site * t().number_of_sites() +
                             most_for_a_sample * (m_goal.number + number_asked_for_on_curves());
    const double part = part_of_spacing();
    for(;;)
    {
      const double longest = part * m_spacing / unit_size();
      const std::vector<double> on_curves =
          m_goal.curve_spacing.empty() ? std::vector<double>() : spacing_on_curves();
      std::vector<bool> is_long(t().corner.size(), false);
      std::size_t number_of_long = 0;
      bool is_fine = true;
      for(Index side = 0; side < is_long.size(); ++side)
      {
        const double length = slowness(side / 3) * t().length[side];
        const bool is_long_on_curve =
            !on_curves.empty() && m_is_curve[side] && t().length[side] > part * on_curves[side];
        if(!(length > longest) && !is_long_on_curve)
          continue;
        ++number_of_long;
        is_fine = is_fine && !is_long_on_curve && length <= little_longer * longest;
        is_long[side] = true;
        if(t().twin[side] != none)
          is_long[t().twin[side]] = true;
      }
      is_fine = is_fine && number_of_long * few_of <= is_long.size();
      if(is_fine || t().number_of_sites() >= most)
        return;
      use(halved(m_surface, is_long));
    }
  }

  void begin()
  {
    m_front.emplace(m_surface.triangles, Front_kind::euclidean);
    m_sampling.emplace(m_surface.triangles, *m_front, Sample_place::triangle, m_slowness);
  }

  bool sample()
  {
    std::vector<Location> first = to_fine(m_surface, m_goal.first_samples);
    const std::vector<Location> on_curves = spread_on_curves(t(), spacing_on_curves());
    first.insert(first.end(), on_curves.begin(), on_curves.end());
    m_number_of_fixed = first.size();
    if(!first.empty())
      m_sampling->add(first);
    if(m_goal.relaxation_steps > 0 && first.size() < m_goal.number)
      m_sampling->add(strewn((m_goal.number - first.size()) / strewn_part));
    const std::size_t number = m_sampling->samples().size();
    return add_farthest(m_goal.number - std::min(m_goal.number, number), 0., 0.4);
  }

  // Places after equal parts of the area, in the order of triangles, which have near numbers where they are
  // neighbours; none nearer to other samples than all will be.
  std::vector<Location> strewn(std::size_t number) const
  {
    const auto mass = [&](Index f)
    {
      const double* const l = &t().length[3 * std::size_t(f)];
      return slowness(f) * slowness(f) * twice_area(l[0], l[1], l[2]);
    };
    double total = 0.;
    for(Index f = 0; f < t().number_of_triangles(); ++f)
      total += mass(f);
    const double part = total / double(number);
    std::vector<Location> result;
    double sum = part * double(std::mt19937(m_goal.seed)()) / 0x1p32;
    for(Index f = 0; f < t().number_of_triangles() && number > 0; ++f)
    {
      sum += mass(f);
      if(!(sum >= part))
        continue;
      sum = std::fmod(sum, part);
      if(m_sampling->distances()[t().corner[3 * f]] > m_spacing / unit_size())
        result.push_back({f, none, {1. / 3., 1. / 3., 1. / 3.}});
    }
    return result;
  }

  // At most: both sides of an edge count.
  std::size_t number_asked_for_on_curves() const
  {
    double result = 0.;
    const std::vector<double>& spacing = m_goal.curve_spacing;
    for(Index side = 0; side < spacing.size(); ++side)
      if(m_coarse_curves[side] && spacing[side] > 0.)
        result += m_surface.coarse->length[side] / spacing[side];
    if(!(result <= double(most_vertices)))
      throw Invalid_argument_error(
          "A mesh with vertices so near to each other along curves has more "
          "than 2^31 half-edges.");
    return std::size_t(result);
  }

  // #sides: the one asked for, or that of all samples; zero off the curves.
  std::vector<double> spacing_on_curves() const
  {
    std::vector<double> result(t().corner.size(), 0.);
    if(!m_has_curves)
      return result;
    const std::vector<Index> coarse = coarse_sides(m_surface);
    for(Index side = 0; side < result.size(); ++side)
    {
      if(!m_is_curve[side])
        continue;
      const double given = m_goal.curve_spacing.empty() ? 0. : m_goal.curve_spacing[coarse[side]];
      const Index twin = t().twin[side];
      const double least =
          twin == none ? slowness(side / 3) : std::min(slowness(side / 3), slowness(twin / 3));
      const double spacing = (given > 0. ? given : m_spacing / least) / unit_size();
      result[side] = std::min(spacing, longest_curve);
    }
    return result;
  }

  // Adds so many, and more where no sample has come yet.
  bool add_farthest(std::size_t number, double begin, double end)
  {
    Sampling_goal goal;
    goal.seed = m_goal.seed;
    goal.number = number;
    if(m_goal.callback)
      goal.callback = [&](double done) { return m_goal.callback(begin + (end - begin) * done); };
    const auto nothing = [](double) {};
    if(number > 0 && !sample_farthest(*m_sampling, goal, nothing))
      return false;
    goal.number = 1;
    while(m_sampling->covering_radius() == infinity)
      if(!sample_farthest(*m_sampling, goal, nothing))
        return false;
    return true;
  }

  // Moves samples to the centroids of their cells.
  bool relax()
  {
    const std::size_t steps = m_goal.relaxation_steps;
    if(steps == 0)
      return true;
    const std::vector<Location>& samples = m_sampling->samples();
    std::vector<bool> is_fixed;
    for(std::size_t i = 0; i < samples.size(); ++i)
      is_fixed.push_back(i < m_number_of_fixed || is_on_curve(samples[i]));
    Relaxation relaxation(m_surface.triangles, m_slowness, samples, m_sampling->labels(), is_fixed);
    for(std::size_t step = 0; step < steps; ++step)
    {
      if(!tell(0.4 + 0.4 * double(step) / double(steps)))
        return false;
      relaxation.step(step + 1 == steps);
    }
    Smoothing smoothing(t(), m_slowness.get(), relaxation.samples(),
                        triangles_between(t(), relaxation.labels()), is_fixed, m_is_curve);
    for(int step = 0; step < smoothing_steps; ++step)
    {
      if(!tell(0.8))
        return false;
      smoothing.step();
    }
    begin();
    m_sampling->add(smoothing.samples());
    return true;
  }

  bool is_on_curve(const Location& sample) const
  {
    const Location clean = cleaned(t(), sample);
    if(const Index site = site_of(t(), clean); site != none)
      return m_is_curve_site[site];
    const Index side = side_of(clean);
    return side != none && m_is_curve[side];
  }

  bool complete()
  {
    for(;;)
    {
      if(!tell(0.9))
        return false;
      const Cells cells = connected_cells(t(), *m_sampling);
      // Some samples came to no site.
      if(cells.samples.size() < m_goal.number && m_sampling->covering_radius() > 0.)
      {
        if(!add_farthest(m_goal.number - cells.samples.size(), 0.8, 0.9))
          return false;
        continue;
      }
      Dual found = dual(t(), cells.labels, Index(cells.samples.size()), m_is_curve);
      const std::vector<Index> strays = cells_off_curves(cells);
      m_stuck = cells_beside_samples(cells);
      if(found.is_closed_ball() && strays.empty() && m_stuck.empty())
      {
        Coarse_mesh mesh = joined(cells, found.triangles);
        std::vector<Location> more = far_places(cells, mesh);
        if(more.empty())
        {
          Remeshing now = finished(cells, std::move(mesh), std::move(found.triangles));
          if(m_goal.avoids_crossings)
            more = places_at_crossings(cells, now);
          if(is_result(std::move(now), more.empty()))
            return true;
        }
        m_sampling->add(more);
        continue;
      }
      m_is_touched.assign(cells.samples.size(), false);
      const std::vector<Location> more = places_to_add(cells, found, strays);
      if(!more.empty())
        m_sampling->add(more);
      else
        refine_around(cells);
    }
  }

  // Cells that come to a curve, on which their sample is not.
  std::vector<Index> cells_off_curves(const Cells& cells) const
  {
    std::vector<bool> comes_to_curve(cells.samples.size(), false);
    for(Index site = 0; site < cells.labels.size(); ++site)
      if(m_is_curve_site[site] && cells.labels[site] != none)
        comes_to_curve[cells.labels[site]] = true;
    std::vector<Index> result;
    for(Index cell = 0; cell < cells.samples.size(); ++cell)
      if(comes_to_curve[cell] && !is_on_curve(m_sampling->samples()[cells.samples[cell]]))
        result.push_back(cell);
    return result;
  }

  // Cells whose sample is on a curve, on none of whose sites there they are, and those that are there.
  std::vector<Index> cells_beside_samples(const Cells& cells) const
  {
    std::vector<Index> result;
    for(Index cell = 0; cell < cells.samples.size(); ++cell)
    {
      const Location& sample = m_sampling->samples()[cells.samples[cell]];
      if(!is_on_curve(sample))
        continue;
      const Location clean = cleaned(t(), sample);
      const Index site = site_of(t(), clean), side = side_of(clean);
      const std::array<Index, 2> ends = {site != none ? site : t().corner[side],
                                         site != none ? site : t().corner[next_side(side)]};
      const Index a = cells.labels[ends[0]], b = cells.labels[ends[1]];
      if(a != cell && b != cell)
        for(const Index c : {cell, a, b})
          result.push_back(c);
    }
    return result;
  }

  // Samples at the farthest sites where something is wrong, if they are not samples already; one for
  // several faults next to each other.
  std::vector<Location> places_to_add(const Cells& cells, const Dual& found,
                                      const std::vector<Index>& strays)
  {
    const std::size_t n = cells.samples.size();
    const std::vector<double>& distances = m_sampling->distances();
    std::vector<Index> farthest(n, none), on_curve(n, none), nearest_on_curve(n, none);
    const auto raise = [&](Index& best, Index site)
    {
      if(best == none || distances[site] > distances[best])
        best = site;
    };
    for(Index site = 0; site < cells.labels.size(); ++site)
      if(const Index cell = cells.labels[site]; cell != none)
      {
        raise(farthest[cell], site);
        if(!m_is_curve_site[site])
          continue;
        raise(on_curve[cell], site);
        Index& nearest = nearest_on_curve[cell];
        if(nearest == none || distances[site] < distances[nearest])
          nearest = site;
      }
    std::vector<Index> at_arc(found.torn_arcs.size(), none),
        at_curve(found.torn_curves.size(), none), at_place(found.repeated_places.size(), none);
    std::vector<bool> is_torn(n, false), is_repeated(n, false);
    for(const auto* arcs : {&found.torn_arcs, &found.torn_curves})
      for(const auto& cells_of_arc : *arcs)
        for(const Index cell : cells_of_arc)
          is_torn[cell] = true;
    for(const auto& cells_of_place : found.repeated_places)
      for(const Index cell : cells_of_place)
        is_repeated[cell] = true;
    const auto is_in = [](const auto& list, const auto& element)
    {
      const auto place = std::lower_bound(list.begin(), list.end(), element);
      return place != list.end() && *place == element ? std::size_t(place - list.begin())
                                                      : list.size();
    };
    for(Index side = 0; side < t().corner.size(); ++side)
    {
      const Index x = t().corner[side], z = t().corner[next_side(side)];
      const Index a = cells.labels[x], b = cells.labels[z];
      if(a == b || !is_torn[a] || !is_torn[b])
        continue;
      const std::array<Index, 2> both = {std::min(a, b), std::max(a, b)};
      if(const auto i = is_in(found.torn_arcs, both); i < at_arc.size())
      {
        raise(at_arc[i], x);
        raise(at_arc[i], z);
      }
      if(const auto i = is_in(found.torn_curves, both); i < at_curve.size() && m_is_curve[side])
      {
        raise(at_curve[i], x);
        raise(at_curve[i], z);
      }
    }
    for(Index f = 0; f < t().number_of_triangles() && !at_place.empty(); ++f)
    {
      std::array<Index, 3> around;
      for(Index k = 0; k < 3; ++k)
        around[k] = cells.labels[t().corner[3 * f + k]];
      if(!is_repeated[around[0]] || !is_repeated[around[1]] || !is_repeated[around[2]])
        continue;
      std::sort(around.begin(), around.end());
      if(const auto i = is_in(found.repeated_places, around); i < at_place.size())
        for(Index k = 0; k < 3; ++k)
          raise(at_place[i], t().corner[3 * f + k]);
    }

    std::vector<Location> result;
    const auto add = [&](std::initializer_list<Index> around, Index site)
    {
      if(std::any_of(around.begin(), around.end(), [&](Index c) { return m_is_touched[c]; }))
        return;
      // Else anywhere in these cells.
      for(const Index cell : around)
        if(distances[site] == 0.)
          site = farthest[cell];
      for(const Index cell : around)
        m_is_touched[cell] = true;
      if(distances[site] > 0.)
        result.push_back({none, site, {}});
      else
        m_stuck.insert(m_stuck.end(), around);
    };
    for(const Index cell : found.torn_borders)
      add({cell}, on_curve[cell]);
    for(const Index cell : strays)
      add({cell}, nearest_on_curve[cell]);
    for(const Index cell : found.no_discs)
      add({cell}, farthest[cell]);
    for(std::size_t i = 0; i < at_curve.size(); ++i)
      add({found.torn_curves[i][0], found.torn_curves[i][1]}, at_curve[i]);
    for(std::size_t i = 0; i < at_arc.size(); ++i)
      add({found.torn_arcs[i][0], found.torn_arcs[i][1]}, at_arc[i]);
    for(std::size_t i = 0; i < at_place.size(); ++i)
      add({found.repeated_places[i][0], found.repeated_places[i][1], found.repeated_places[i][2]},
          at_place[i]);
    return result;
  }

  // Where each site is a sample and the triangles are no surface of their own yet: two that share
  // their corners.
  void refine_around(const Cells& cells)
  {
    if(++m_number_of_refinements > most_refinements)
      throw Unsupported_surface_error(
          "The mesh folds onto itself so that samples cannot be joined.");
    std::vector<bool> is_stuck(cells.samples.size(), false), is_halved(t().corner.size(), false);
    for(const Index cell : m_stuck)
      is_stuck[cell] = true;
    for(Index f = 0; f < t().number_of_triangles(); ++f)
      for(Index k = 0; k < 3; ++k)
        if(is_stuck[cells.labels[t().corner[3 * f + k]]])
          for(Index side = 3 * f; side < 3 * f + 3; ++side)
          {
            is_halved[side] = true;
            if(t().twin[side] != none)
              is_halved[t().twin[side]] = true;
          }
    std::vector<Location> samples;
    for(const Location& sample : m_sampling->samples())
      samples.push_back(to_coarse(m_surface, sample));
    use(halved(m_surface, is_halved));
    begin();
    m_sampling->add(to_fine(m_surface, samples));
  }

  // Where four cells almost meet in one place, sites do not tell which two do.
  Coarse_mesh joined(const Cells& cells, std::vector<std::array<Index, 3>> triangles) const
  {
    Coarse_mesh result{{}, std::move(triangles)};
    std::vector<bool> is_kept;
    const bool is_limited = m_goal.maximum_deviation < infinity;
    const std::vector<Index> farthest = is_limited ? farthest_sites(cells) : std::vector<Index>();
    for(Index cell = 0; cell < cells.samples.size(); ++cell)
    {
      const Location& sample = m_sampling->samples()[cells.samples[cell]];
      result.points.push_back(scaled_coordinates(t(), sample));
      // Where no sample can be added, the surface is what it was.
      is_kept.push_back(is_on_curve(sample) || (is_limited && farthest[cell] == none));
    }
    flip_to_larger_angles(result.points, is_kept, result.triangles);
    if(m_goal.is_fitted)
      fit(t(), cells.labels, is_kept, result, m_goal.maximum_deviation / unit_size(),
          m_goal.relaxation_steps < many_steps ? 0 : careful_steps);
    return result;
  }

  // Of each cell the site farthest from its sample; none where all are samples.
  std::vector<Index> farthest_sites(const Cells& cells) const
  {
    std::vector<Index> result(cells.samples.size(), none);
    const std::vector<double>& distances = m_sampling->distances();
    for(Index site = 0; site < cells.labels.size(); ++site)
      if(const Index cell = cells.labels[site];
         cell != none && distances[site] > 0. &&
         (result[cell] == none || distances[site] > distances[result[cell]]))
        result[cell] = site;
    return result;
  }

  // Sites that are farther from the mesh than they may be, or else those of its triangles that are
  // farther from the surface; no samples, which fitting moves by no more than they may be off.
  std::vector<Location> far_places(const Cells& cells, const Coarse_mesh& mesh)
  {
    if(!(m_goal.maximum_deviation < infinity))
      return {};
    const std::vector<double>& distances = m_sampling->distances();
    std::vector<Index> labels = cells.labels;
    for(Index site = 0; site < labels.size(); ++site)
      if(distances[site] == 0.)
        labels[site] = none;
    std::vector<Index> sites = far_sites(t(), labels, mesh, m_goal.maximum_deviation / unit_size());
    if(sites.empty())
    {
      const std::vector<Index> farthest = farthest_sites(cells);
      for(const auto& f : mesh.triangles)
      {
        Index best = none;
        for(const Index cell : f)
          if(const Index site = farthest[cell];
             site != none && (best == none || distances[site] > distances[best]))
            best = site;
        if(best != none && is_far(mesh, f))
          sites.push_back(best);
      }
      std::sort(sites.begin(), sites.end());
      sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    }
    std::vector<Location> result;
    for(const Index site : sites)
      result.push_back({none, site, {}});
    return result;
  }

  // Whether the middle of a triangle or of a side is farther from the surface than it may be.
  bool is_far(const Coarse_mesh& mesh, const std::array<Index, 3>& triangle)
  {
    if(!m_tree)
      m_tree.emplace(m_surface.coarse);
    const Glued_triangles& coarse = *m_surface.coarse;
    const auto is_far_place = [&](const Spatial& p)
    {
      const Spatial place = t().origin + t().scale * p;
      return norm(place - coordinates(coarse, m_tree->nearest(place))) >
             m_goal.maximum_deviation * coarse.scale;
    };
    const Spatial &a = mesh.points[triangle[0]], &b = mesh.points[triangle[1]],
                  &c = mesh.points[triangle[2]];
    return is_far_place((1. / 3.) * (a + b + c)) || is_far_place(0.5 * (a + b)) ||
           is_far_place(0.5 * (b + c)) || is_far_place(0.5 * (c + a));
  }

  // Where triangles cross and the surface does not, some of them are too far from it.
  std::vector<Location> places_at_crossings(const Cells& cells, Remeshing& now)
  {
    const std::size_t most = now.triangles.size();
    const auto crossings = crossing_triangles(now.points, now.triangles, most);
    now.crossings = crossings.size();
    // So many are not for want of samples.
    if(crossings.empty() || crossings.size() == most)
      return {};
    const std::vector<bool> is_cut = cells_that_cross(cells);
    std::vector<bool> is_concerned(cells.samples.size(), false);
    for(const auto& crossing : crossings)
    {
      const auto is_clean = [&](Index f)
      {
        const auto& corners = now.triangles[f];
        return !is_cut[corners[0]] && !is_cut[corners[1]] && !is_cut[corners[2]];
      };
      if(is_clean(crossing[0]) || is_clean(crossing[1]))
        for(const Index f : crossing)
          for(const Index cell : now.triangles[f])
            is_concerned[cell] = true;
    }
    const std::vector<Index> farthest = farthest_sites(cells);
    std::vector<Location> result;
    for(Index cell = 0; cell < farthest.size(); ++cell)
      if(is_concerned[cell] && farthest[cell] != none)
        result.push_back({none, farthest[cell], {}});
    return result;
  }

  // Whether it is settled what comes out: this, or what there was before samples were added at crossings
  // in vain.
  bool is_result(Remeshing now, bool is_last)
  {
    const bool is_given_up = !is_last && ++m_rounds_at_crossings > most_rounds_at_crossings;
    if(is_given_up || (is_last && m_crossing && m_crossing->crossings <= now.crossings))
      m_result = std::move(*m_crossing);
    else if(is_last)
      m_result = std::move(now);
    else if(!m_crossing)
      m_crossing = std::move(now);
    return is_last || is_given_up;
  }

  // Cells in which the surface itself crosses a part of it: no samples would help.
  std::vector<bool> cells_that_cross(const Cells& cells)
  {
    if(!m_crosses)
    {
      const Glued_triangles& coarse = *m_surface.coarse;
      std::vector<std::array<Index, 3>> corners(coarse.number_of_triangles());
      for(Index f = 0; f < corners.size(); ++f)
        std::copy_n(&coarse.corner[3 * std::size_t(f)], 3, corners[f].begin());
      m_crosses.emplace(corners.size(), false);
      for(const auto& crossing : crossing_triangles(coarse.point, corners, corners.size()))
        for(const Index f : crossing)
          (*m_crosses)[f] = true;
    }
    std::vector<bool> result(cells.samples.size(), false);
    for(Index f = 0; f < t().number_of_triangles(); ++f)
      if((*m_crosses)[m_surface.parent.empty() ? f : m_surface.parent[f]])
        for(Index k = 0; k < 3; ++k)
          result[cells.labels[t().corner[3 * f + k]]] = true;
    return result;
  }

  // On the triangles that were given.
  Remeshing finished(const Cells& cells, Coarse_mesh mesh,
                     std::vector<std::array<Index, 3>> between_cells) const
  {
    Remeshing result;
    for(std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      result.samples.push_back(cleaned(
          *m_surface.coarse, to_coarse(m_surface, m_sampling->samples()[cells.samples[i]])));
      result.points.push_back(m_goal.is_fitted
                                  ? t().origin + t().scale * mesh.points[i]
                                  : coordinates(*m_surface.coarse, result.samples.back()));
    }
    result.triangles = std::move(mesh.triangles);
    result.surface = m_surface;
    result.cells = cells.labels;
    result.between_cells = std::move(between_cells);
    return result;
  }

  const Remeshing_goal& m_goal;
  std::vector<bool> m_coarse_curves;
  bool m_has_curves;
  double m_spacing = 0.; // in the unit of the coarse triangles

  Refinement m_surface;
  std::vector<bool> m_is_curve, m_is_curve_site; // #sides, #sites
  std::shared_ptr<const std::vector<double>> m_slowness;
  std::optional<Front> m_front;
  std::optional<Sampling> m_sampling;
  std::size_t m_number_of_fixed = 0; // samples, the first ones
  Remeshing m_result;

  // Of a round
  std::vector<bool> m_is_touched; // #cells
  std::vector<Index> m_stuck;     // cells that have a fault and no site left
  int m_number_of_refinements = 0, m_rounds_at_crossings = 0;
  std::optional<Remeshing> m_crossing;        // before any samples were added at crossings
  std::optional<std::vector<bool>> m_crosses; // #coarse triangles, once some of the result do
  std::optional<Triangle_tree> m_tree;        // of the coarse triangles, once it is asked
};

} // namespace

Remeshing remeshing(const std::shared_ptr<const Glued_triangles>& triangles,
                    const Remeshing_goal& goal)
{
  if(goal.number > most_vertices)
    throw Invalid_argument_error("A mesh of so many vertices has more than 2^31 half-edges.");
  return Remesher(triangles, goal).run();
}

} // namespace CGAL::Geodesic_processing::internal
