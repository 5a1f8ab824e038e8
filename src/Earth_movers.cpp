// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/Earth_movers.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/continuous_flow.h>
#include <CGAL/Geodesic_processing/internal/flat_refinement.h>
#include <CGAL/Geodesic_processing/internal/unfold.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

Tensor inverse(const Tensor& a)
{
  const double determinant = a[0] * a[2] - a[1] * a[1];
  return {a[2] / determinant, -a[1] / determinant, a[0] / determinant};
}

bool is_blocked(const Tensor& measure) { return !std::isfinite(measure[0] + measure[2]); }

// Without the triangles through which nothing may pass.
Operators open_operators(const Glued_triangles& t, const std::vector<Tensor>& measure)
{
  Operators result = operators(t, Flat_triangles::raised);
  for(std::size_t f = 0; f < measure.size(); ++f)
    if(is_blocked(measure[f]))
    {
      result.area[f] = 0.;
      std::fill_n(result.hat.begin() + 3 * std::ptrdiff_t(f), 3, Planar{0., 0.});
    }
  return result;
}

// Those of the field that is measured, A J: its divergence is that of J, and the length of a function's
// gradient what it changes by per measured length.
Operators measured_operators(const Glued_triangles& t, const std::vector<Tensor>& measure)
{
  Operators result = open_operators(t, measure);
  for(std::size_t f = 0; f < measure.size(); ++f)
    if(!is_blocked(measure[f]))
      for(std::size_t corner = 3 * f; corner < 3 * f + 3; ++corner)
        result.hat[corner] = product(inverse(measure[f]), result.hat[corner]);
  return result;
}

// The means over triangles that were divided; the one in the middle is turned by half.
Field of_coarse(const Field& fine)
{
  Field result(fine.size() / 4);
  for(std::size_t f = 0; f < result.size(); ++f)
    result[f] = 0.25 * (fine[4 * f] + fine[4 * f + 1] + fine[4 * f + 2] - fine[4 * f + 3]);
  return result;
}

Mass_distribution refined(const Glued_triangles& coarse, const Glued_triangles& fine,
                          const Mass_distribution& masses)
{
  Mass_distribution result;
  if(masses.at_sites.size() > 0)
  {
    result.at_sites = Vector::Zero(Eigen::Index(fine.number_of_sites()));
    result.at_sites.head(masses.at_sites.size()) = masses.at_sites;
  }
  for(const auto& [location, mass] : masses.at_locations)
    result.at_locations.emplace_back(refined(location), mass);
  if(masses.density.size() > 0)
    result.density = refined(coarse, fine, masses.density);
  return result;
}

// target += factor * source, where empty is zero.
void add(Vector& target, double factor, const Vector& source)
{
  if(source.size() == 0)
    return;
  if(target.size() == 0)
    target = Vector::Zero(source.size());
  target += factor * source;
}

void add(Mass_distribution& target, double factor, const Mass_distribution& source)
{
  add(target.at_sites, factor, source.at_sites);
  for(const auto& [location, mass] : source.at_locations)
    target.at_locations.emplace_back(location, factor * mass);
  add(target.density, factor, source.density);
}

} // namespace

Earth_movers::Earth_movers(std::shared_ptr<const Glued_triangles> triangles, unsigned refinements,
                           std::vector<Tensor> measure)
{
  if(std::ldexp(double(triangles->corner.size()), 2 * int(std::min(refinements, 30u))) > 2e9)
    throw Unsupported_surface_error("The refined surface would have more than 2^31 half-edges.");
  m_levels.resize(refinements + 1);
  for(unsigned level = 0; level <= refinements; ++level)
  {
    if(level > 0)
    {
      triangles = std::make_shared<const Glued_triangles>(refined(*triangles));
      for(const Tensor& tensor : std::exchange(measure, {}))
        measure.insert(measure.end(), 4, tensor);
    }
    m_levels[level].triangles = triangles;
    m_levels[level].measure = measure;
    if(level + 1 >= refinements)
      m_levels[level].solver =
          std::make_unique<Transport_solver>(measured_operators(*triangles, measure));
  }
}

// What is to be moved: `to` less `from`.
Mass_distribution Earth_movers::difference(const Mass_distribution& from,
                                           const Mass_distribution& to, bool do_normalize) const
{
  Mass_distribution result;
  std::array<double, 2> total{}, size{};
  const std::array<const Mass_distribution*, 2> sides = {&from, &to};
  for(std::size_t i = 0; i < 2; ++i)
  {
    const Vector mass = at_sites(0, *sides[i]);
    total[i] = mass.sum();
    size[i] = mass.lpNorm<1>();
    if(!std::isfinite(size[i]))
      throw Invalid_argument_error("A mass is not a finite number.");
  }
  if(do_normalize)
  {
    for(const double sum : total)
      if(!(sum > 0.))
        throw Invalid_argument_error("Masses that sum to " + std::to_string(sum) +
                                     " cannot be scaled so that they sum to one.");
    add(result, 1. / total[1], to);
    add(result, -1. / total[0], from);
    return result;
  }
  if(std::abs(total[1] - total[0]) > 1e-9 * std::max(size[0], size[1]))
    throw Invalid_argument_error("The masses sum to " + std::to_string(total[0]) +
                                 " before and to " + std::to_string(total[1]) +
                                 " after they are moved.");
  add(result, 1., to);
  add(result, -1., from);
  return result;
}

// At sites, such that the integral of each function that is linear in triangles is the same.
Vector Earth_movers::at_sites(std::size_t level, const Mass_distribution& masses) const
{
  const Glued_triangles& t = *m_levels[level].triangles;
  Vector result = Vector::Zero(Eigen::Index(t.number_of_sites()));
  add(result, 1., masses.at_sites);
  for(const auto& [location, mass] : masses.at_locations)
    if(location.triangle == none)
      result[location.site] += mass;
    else
      for(std::size_t k = 0; k < 3; ++k)
        result[t.corner[3 * location.triangle + k]] += mass * location.barycentric[k];
  if(masses.density.size() > 0)
  {
    const Sparse_matrix integrals = consistent_mass(open_operators(t, m_levels[level].measure));
    result +=
        t.scale * t.scale * (integrals.selfadjointView<Eigen::Lower>() * masses.density).eval();
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
  const Operators o = open_operators(t, measure);
  for(std::size_t f = 0; f < o.area.size(); ++f)
  {
    if(o.area[f] == 0.)
      continue;
    const auto p = places(f);
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        for(std::size_t k = 0; k < 3; ++k)
          if(i != k)
            result += t.scale * t.scale * o.area[f] / (i == j || j == k ? 30. : 60.) *
                      std::abs(masses.density[t.corner[3 * f + j]]) * norm(p[k] - p[i]);
  }
  return result;
}

// On the surface itself; what is blocked is no part of it.
double Earth_movers::cost_of_flow(const Field& flow) const
{
  const Glued_triangles& whole = *m_levels.back().triangles;
  std::vector<Tensor> measure = m_levels.back().measure;
  if(std::none_of(measure.begin(), measure.end(), is_blocked))
    return cost_of_continuous_flow(whole, operators(whole), flow, measure);
  Glued_triangles open = whole;
  for(Index side = 0; side < open.twin.size(); ++side)
    if(const Index twin = whole.twin[side];
       twin != none && is_blocked(measure[side / 3]) != is_blocked(measure[twin / 3]))
      open.twin[side] = none;
  std::replace_if(measure.begin(), measure.end(), is_blocked, Tensor{1., 0., 1.});
  return cost_of_continuous_flow(open, operators(open), flow, measure);
}

Earth_movers_result Earth_movers::solve(const Mass_distribution& from, const Mass_distribution& to,
                                        const Earth_movers_options& options) const
{
  const std::size_t finest = m_levels.size() - 1;
  Mass_distribution masses = difference(from, to, options.do_normalize);
  Earth_movers_result result;
  double before = 0.; // the value on the surface that is refined once less
  for(std::size_t level = 0; level <= finest; ++level)
  {
    const Level& here = m_levels[level];
    if(level > 0)
      masses = refined(*m_levels[level - 1].triangles, *here.triangles, masses);
    if(!here.solver)
      continue;
    before = here.triangles->scale * 2. * result.value;
    static_cast<Transport&>(result) =
        here.solver->solve(at_sites(level, masses), options.transport);
  }
  const double scale = m_levels.back().triangles->scale;
  const std::vector<Tensor>& measure = m_levels.back().measure;
  for(std::size_t f = 0; f < measure.size(); ++f)
    if(!is_blocked(measure[f]))
      result.flow[f] = product(inverse(measure[f]), result.flow[f]);
  if(options.do_bound_from_above)
    result.upper_continuous = scale * (cost_of_flow(result.flow) + cost_to_sites(masses));
  result.value *= scale;
  result.lower *= scale;
  result.upper *= scale;
  result.estimate = finest > 0 ? 2. * result.value - before : result.value;
  result.potential =
      scale * result.potential.head(m_levels.front().triangles->number_of_sites()).eval();
  for(std::size_t level = finest; level > 0; --level)
    result.flow = of_coarse(result.flow);
  for(Planar& vector : result.flow)
    vector = (1. / scale) * vector;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
