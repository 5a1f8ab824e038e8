// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/curves.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/planar.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A side in one of its directions: backwards where there is no twin.
struct Step
{
  Index side = none;
  bool is_backwards = false;
};

class Curves
{
public:
  Curves(const Glued_triangles& t, const std::vector<double>& spacing)
      : m_triangles(t), m_spacing(spacing), m_first(t.number_of_sites() + 1, 0),
        m_is_done(t.corner.size(), false)
  {
    for_each_step([&](const Step& step) { ++m_first[begin_of(step) + 1]; });
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_steps.resize(m_first.back());
    std::vector<Index> end(m_first.begin(), m_first.end() - 1);
    for_each_step([&](const Step& step) { m_steps[end[begin_of(step)]++] = step; });
  }

  std::vector<Location> spread()
  {
    for(const bool is_loop : {false, true})
      for(Index site = 0; site + 1 < m_first.size(); ++site)
      {
        const Index number = m_first[site + 1] - m_first[site];
        if(number == 2 && !is_loop)
          continue;
        if(number > 0 && !is_loop)
          m_result.push_back(at_site(m_triangles, site));
        for(Index i = m_first[site]; i < m_first[site + 1]; ++i)
          if(!m_is_done[m_steps[i].side])
          {
            follow(m_steps[i]);
            spread_on_chain(is_loop);
          }
      }
    return std::move(m_result);
  }

private:
  template <typename Use>
  void for_each_step(const Use& use) const
  {
    for(Index side = 0; side < m_spacing.size(); ++side)
      if(m_spacing[side] > 0.)
      {
        use(Step{side, false});
        if(m_triangles.twin[side] == none)
          use(Step{side, true});
      }
  }
  Index begin_of(const Step& step) const
  {
    return m_triangles.corner[step.is_backwards ? next_side(step.side) : step.side];
  }
  Index end_of(const Step& step) const
  {
    return m_triangles.corner[step.is_backwards ? step.side : next_side(step.side)];
  }
  Spatial direction(const Step& step) const
  {
    return unit(m_triangles.point[end_of(step)] - m_triangles.point[begin_of(step)]);
  }
  void mark(Index side)
  {
    m_is_done[side] = true;
    if(m_triangles.twin[side] != none)
      m_is_done[m_triangles.twin[side]] = true;
  }

  // The chain from a step on while there is one way to go.
  void follow(Step step)
  {
    m_chain.clear();
    for(;;)
    {
      mark(step.side);
      m_chain.push_back(step);
      const Index end = end_of(step), i = m_first[end];
      if(m_first[end + 1] != i + 2 ||
         (m_is_done[m_steps[i].side] && m_is_done[m_steps[i + 1].side]))
        return;
      step = m_steps[m_is_done[m_steps[i].side] ? i + 1 : i];
    }
  }

  void spread_on_chain(bool is_loop)
  {
    std::vector<Step>& steps = m_chain;
    // How sharply the chain turns where each step begins; a closed one starts where it does most.
    const std::size_t n = steps.size();
    std::vector<double>& turn = m_turn;
    turn.assign(n, 0.);
    for(std::size_t i = is_loop ? 0 : 1; i < n; ++i)
    {
      const Spatial before = direction(steps[(i + n - 1) % n]), after = direction(steps[i]);
      turn[i] = std::atan2(norm(cross(before, after)), dot(before, after));
    }
    if(is_loop)
    {
      const auto sharpest = std::max_element(turn.begin(), turn.end()) - turn.begin();
      std::rotate(turn.begin(), turn.begin() + sharpest, turn.end());
      std::rotate(steps.begin(), steps.begin() + sharpest, steps.end());
    }
    std::vector<double>& begin = m_begin;
    begin.assign(1, 0.);
    for(const Step& step : steps)
      begin.push_back(begin.back() + m_triangles.length[step.side] / m_spacing[step.side]);

    std::vector<std::size_t>& sharp = m_sharp;
    sharp.clear();
    for(std::size_t i = 1; i < n; ++i)
      if(turn[i] > pi / 3.)
        sharp.push_back(i);
    std::stable_sort(sharp.begin(), sharp.end(),
                     [&](std::size_t i, std::size_t j) { return turn[i] > turn[j]; });
    std::set<double> corners = {0., begin.back()};
    for(const std::size_t i : sharp)
    {
      const auto above = corners.lower_bound(begin[i]);
      if(*above - begin[i] >= 0.5 && begin[i] - *std::prev(above) >= 0.5)
        corners.insert(begin[i]);
    }

    if(is_loop)
      m_result.push_back(at_site(m_triangles, begin_of(steps[0])));
    const bool is_closed = is_loop || begin_of(steps[0]) == end_of(steps[n - 1]);
    const std::size_t pieces = corners.size() - 1;
    const double least = is_closed && pieces < 3 ? std::ceil(3. / double(pieces)) : 1.;
    std::size_t i = 0;
    for(auto from = corners.begin(), to = std::next(from); to != corners.end(); ++from, ++to)
    {
      const double number = std::max(least, std::round(*to - *from));
      const bool is_last = std::next(to) == corners.end();
      for(double k = 1.; k <= number - (is_last ? 1. : 0.); ++k)
      {
        const double place = k == number ? *to : *from + k / number * (*to - *from);
        while(i + 1 < n && begin[i + 1] <= place)
          ++i;
        const double share = std::clamp((place - begin[i]) / (begin[i + 1] - begin[i]), 0., 1.);
        const Step& step = steps[i];
        m_result.push_back(
            cleaned(m_triangles, {step.side / 3, none,
                                  on_side(step.side, step.is_backwards ? 1. - share : share)}));
      }
    }
  }

  const Glued_triangles& m_triangles;
  const std::vector<double>& m_spacing; // #sides
  std::vector<Index> m_first;           // #sites + 1: where those of each begin in
  std::vector<Step> m_steps;            // the curves' steps that leave a site
  std::vector<bool> m_is_done;          // #sides
  std::vector<Location> m_result;

  // Of one chain: kept, as there may be as many chains as triangles
  std::vector<Step> m_chain;
  std::vector<double> m_turn, m_begin; // where each step begins, in spacings
  std::vector<std::size_t> m_sharp;
};

} // namespace

std::vector<Location> spread_on_curves(const Glued_triangles& triangles,
                                       const std::vector<double>& spacing)
{
  return Curves(triangles, spacing).spread();
}

std::vector<bool> border_and_sharp_sides(const Glued_triangles& t, double angle)
{
  std::vector<Spatial> normal(angle < 180. ? t.number_of_triangles() : 0);
  for(Index f = 0; f < normal.size(); ++f)
  {
    const Spatial origin = t.point[t.corner[3 * f]];
    normal[f] =
        unit(cross(t.point[t.corner[3 * f + 1]] - origin, t.point[t.corner[3 * f + 2]] - origin));
  }
  std::vector<bool> result(t.corner.size(), false);
  for(Index side = 0; side < t.corner.size(); ++side)
    if(t.twin[side] == none)
      result[side] = true;
    else if(!normal.empty())
    {
      const Spatial &u = normal[side / 3], &v = normal[t.twin[side] / 3];
      result[side] = norm(u) > 0. && norm(v) > 0. &&
                     std::atan2(norm(cross(u, v)), dot(u, v)) >= angle * pi / 180.;
    }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
