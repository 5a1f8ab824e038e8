// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/heat.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/Sparse_solver.h>
#include <CGAL/Geodesic_processing/internal/glue.h>
#include <CGAL/Geodesic_processing/internal/intrinsic_delaunay.h>
#include <CGAL/Geodesic_processing/internal/path_locations.h>
#include <CGAL/Geodesic_processing/internal/planar.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// How many square roots of the time step the surface may be wide: exp(-600) is about 1e-260.
constexpr double widest = 600.;

// A bound on the width of the widest component: twice the longest distance from one of its sites.
double width_of(const std::shared_ptr<const Glued_triangles>& triangles,
                const std::vector<Index>& component, std::size_t components)
{
  std::vector<bool> has_seed(components, false);
  std::vector<Source> seeds;
  for(Index site = 0; site < component.size(); ++site)
    if(!has_seed[component[site]])
    {
      has_seed[component[site]] = true;
      seeds.push_back({{Location{none, site, {}}}, 0., 0});
    }
  Front front(triangles, Front_kind::arcs);
  front.run(seeds);
  double longest = 0.;
  for(const Index site : front.reached())
    longest = std::max(longest, front.distance(site));
  return 2. * longest;
}

// Where needles raise some entries a million times above others, rounding may hide that a matrix is
// definite: then its diagonal grows until it shows, at most by a millionth of a millionth of itself.
std::unique_ptr<Sparse_solver> factorized(Sparse_matrix& matrix)
{
  const Vector diagonal = matrix.diagonal();
  for(double growth = 1e-14; growth < 1e-11; growth *= 10.)
    try
    {
      return std::make_unique<Sparse_solver>(matrix);
    }
    catch(const Unsupported_surface_error&)
    {
      matrix.diagonal() = (1. + growth) * diagonal;
    }
  return std::make_unique<Sparse_solver>(matrix);
}

} // namespace

struct Heat_solver::Systems
{
  std::vector<Index> corner;     // 3 #triangles of the triangulation that carries the heat
  std::vector<double> length;    // 3 #triangles
  std::vector<double> cotangent; // 3 #triangles, of the angle opposite to each side, times weight
  std::vector<Index> component;  // #sites
  std::size_t components = 0;
  double step = 0.; // square root of the time step
  std::unique_ptr<Sparse_solver> heat, poisson;
};

Heat_solver::Heat_solver(std::shared_ptr<const Glued_triangles> triangles)
    : m_triangles(triangles), m_arcs(triangles, Front_kind::arcs),
      m_distance(triangles->number_of_sites(), infinity)
{
  auto systems = std::make_shared<Systems>();
  Glued_triangles t = *m_triangles;
  std::tie(systems->component, systems->components) = components(t);

  double mean = 0.;
  for(const double length : t.length)
    mean += length / double(t.length.size());
  // A millionth of a side's length keeps the cotangents below a million (Sharp and Crane 2020).
  mollify(t, 1e-6 * (mean > 0. ? mean : 1.));
  if(!t.is_cloud())
    flip_to_delaunay(t);

  const Index n = static_cast<Index>(t.number_of_sites());
  const double width = width_of(m_triangles, systems->component, systems->components);
  systems->step = std::max(mean, width / widest);
  const double step_square = systems->step * systems->step;

  systems->cotangent.resize(t.length.size());
  std::vector<double> mass(n, 0.), diagonal(n, 0.);
  std::vector<Eigen::Triplet<double>> stiffness;
  stiffness.reserve(2 * t.length.size());
  for(Index side = 0; side < t.length.size(); ++side)
  {
    const double weight = t.weight.empty() ? 1. : t.weight[side / 3];
    const Planar angle = corner_angle(t, previous_side(side));
    // Mollified sines are at least about 1e-6; those of a flipped triangle may be less.
    const double cotangent = weight * angle[0] / std::max(angle[1], 1e-9);
    systems->cotangent[side] = cotangent;
    const Index a = t.corner[side], b = t.corner[next_side(side)];
    diagonal[a] += 0.5 * cotangent;
    diagonal[b] += 0.5 * cotangent;
    if(a != b)
      stiffness.emplace_back(std::max(a, b), std::min(a, b), -0.5 * cotangent);
    else
      diagonal[a] -= cotangent;
    // A third of half the product of the two sides at a corner and its sine.
    const double product = t.length[side] * t.length[previous_side(side)];
    mass[a] += weight * product * corner_angle(t, side)[1] / 6.;
  }
  Sparse_matrix heat(n, n), poisson(n, n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(stiffness.size() + n);
  for(const auto& entry : stiffness)
    entries.emplace_back(entry.row(), entry.col(), step_square * entry.value());
  for(Index i = 0; i < n; ++i)
    entries.emplace_back(i, i, mass[i] > 0. ? mass[i] + step_square * diagonal[i] : 1.);
  heat.setFromTriplets(entries.begin(), entries.end());
  systems->heat = factorized(heat);

  // The Laplacian knows constants on each island as zero.  Holding one site there makes it definite, and
  // the potential is the same up to a constant, because the divergence sums to zero.  (A shift small
  // enough to change nothing on a long strip is lost in rounding.)
  const auto [island, islands_found] = islands(t);
  std::vector<bool> is_held(islands_found, false);
  entries = std::move(stiffness);
  for(Index i = 0; i < n; ++i)
    if(!(mass[i] > 0.))
      entries.emplace_back(i, i, 1.);
    else if(is_held[island[i]])
      entries.emplace_back(i, i, diagonal[i]);
    else
    {
      is_held[island[i]] = true;
      entries.emplace_back(i, i, 2. * diagonal[i]);
    }
  poisson.setFromTriplets(entries.begin(), entries.end());
  systems->poisson = factorized(poisson);

  systems->corner = std::move(t.corner);
  systems->length = std::move(t.length);
  m_systems = std::move(systems);
}

bool Heat_solver::run(const std::vector<Source>& sources, const Front_limits& limits)
{
  if(limits.slowness)
    throw Unsupported_surface_error("The heat method takes no speeds: use fast marching.");
  for(const Index site : m_reached)
    m_distance[site] = infinity;
  m_reached.clear();
  const auto is_cancelled = [&](double fraction)
  { return limits.callback && !limits.callback(fraction); };
  if(is_cancelled(0.))
  {
    m_arcs.run({});
    return false;
  }
  m_arcs.run(sources);

  const Glued_triangles& t = *m_triangles;
  const Systems& s = *m_systems;
  const Index n = static_cast<Index>(m_distance.size());

  // Heat, and its mean offset, given to the sites around each source: points by their barycentric
  // coordinates, segments half at each end.
  double lowest = infinity;
  for(const Source& source : sources)
    lowest = std::min(lowest, source.offset);
  Vector heat = Vector::Zero(n);
  std::vector<std::pair<Index, double>> given; // sites and heat, in order
  std::vector<double> offset;                  // of each of those
  const auto give = [&](const Location& location, double amount, double at)
  {
    for(int k = 0; k < (location.triangle == none ? 1 : 3); ++k)
    {
      const Index site =
          location.triangle == none ? location.site : t.corner[3 * location.triangle + k];
      const double part = location.triangle == none ? amount : amount * location.barycentric[k];
      if(part <= 0.)
        continue;
      heat[site] += part * std::exp(-(at - lowest) / s.step);
      given.emplace_back(site, part);
      offset.push_back(at);
    }
  };
  for(const Source& source : sources)
  {
    if(source.polyline.size() == 1)
      give(source.polyline[0], 1., source.offset);
    for(std::size_t i = 1; i < source.polyline.size(); ++i)
    {
      const double length =
          polyline_length(t, {source.polyline[i - 1], source.polyline[i]}) / s.step;
      give(source.polyline[i - 1], 0.5 * length, source.offset);
      give(source.polyline[i], 0.5 * length, source.offset);
    }
  }
  const Vector u = s.heat->solve(heat);
  if(is_cancelled(0.5))
  {
    m_arcs.run({});
    return false;
  }

  // The divergence of the unit field against the gradient of u: half the sum over the sides at a
  // corner of cotangent times the field along the side.
  Vector divergence = Vector::Zero(n);
  for(std::size_t f = 0; f < s.corner.size(); f += 3)
  {
    const double* length = &s.length[f];
    const Planar angle = [&]
    {
      const double product = 2. * length[0] * length[2];
      const double versine = std::clamp((length[1] - (length[0] - length[2])) *
                                            (length[1] + (length[0] - length[2])) / product,
                                        0., 2.);
      return Planar{1. - versine, std::sqrt(versine * (2. - versine))};
    }();
    const std::array<Planar, 3> corners = {Planar{0., 0.}, Planar{length[0], 0.},
                                           length[2] * angle};
    std::array<double, 3> value = {u[s.corner[f]], u[s.corner[f + 1]], u[s.corner[f + 2]]};
    // Divided by the largest first: heat far away is below what squares can hold.
    const double largest = std::max({std::abs(value[0]), std::abs(value[1]), std::abs(value[2])});
    if(!(largest > 0.) || !(corners[2][1] > 0.))
      continue;
    const double first = (value[1] - value[0]) / largest, second = (value[2] - value[0]) / largest;
    // Opposite to the source of a symmetric surface there is no direction, only rounding.
    if(std::max(std::abs(first), std::abs(second)) < 1e-13)
      continue;
    const double du = first / corners[1][0];
    const double dv = (second - du * corners[2][0]) / corners[2][1];
    const double size = std::hypot(du, dv);
    if(!(size > 0.))
      continue;
    const Planar field = {-du / size, -dv / size};
    for(std::size_t k = 0; k < 3; ++k)
    {
      const double flow = 0.5 * s.cotangent[f + k] * dot(corners[(k + 1) % 3] - corners[k], field);
      divergence[s.corner[f + k]] += flow;
      divergence[s.corner[f + (k + 1) % 3]] -= flow;
    }
  }
  Vector potential = s.poisson->solve(divergence);
  // The field points away from the sources and the stiffness is positive: L phi = -div.
  potential = -potential;

  std::vector<double> shift(s.components, 0.), amount(s.components, 0.);
  for(std::size_t i = 0; i < given.size(); ++i)
  {
    const auto [site, part] = given[i];
    shift[s.component[site]] += part * (offset[i] - potential[site]);
    amount[s.component[site]] += part;
  }
  for(const Index site : m_arcs.reached())
  {
    const Index component = s.component[site];
    const double distance =
        std::max(potential[site] + shift[component] / amount[component], lowest);
    if(distance > limits.maximum_distance)
      continue;
    m_distance[site] = distance;
    m_reached.push_back(site);
  }
  return true;
}

double Heat_solver::distance(const Location& location) const
{
  if(location.triangle == none)
    return m_distance[location.site];
  double result = 0.;
  for(int k = 0; k < 3; ++k)
    if(location.barycentric[k] > 0.)
      result +=
          location.barycentric[k] * m_distance[m_triangles->corner[3 * location.triangle + k]];
  return result;
}

Index Heat_solver::predecessor(Index site) const { return m_arcs.predecessor(site); }

} // namespace CGAL::Geodesic_processing::internal
