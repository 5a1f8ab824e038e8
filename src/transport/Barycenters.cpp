// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Barycenters.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "transport/flat_refinement.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Barycenters::Barycenters(std::shared_ptr<const Glued_triangles> triangles, unsigned refinements,
                         std::vector<Tensor> measure)
{
  if(std::ldexp(double(triangles->corner.size()), 2 * int(std::min(refinements, 30u))) > 2e9)
    throw Unsupported_surface_error("The refined surface would have more than 2^31 half-edges.");
  const Operators whole = measured_operators(*triangles, measure);
  m_site_areas = triangles->scale * triangles->scale * lumped_mass(whole);
  m_levels.push_back({triangles, whole.area});
  for(unsigned level = 0; level < refinements; ++level)
  {
    triangles = std::make_shared<const Glued_triangles>(refined(*triangles));
    for(const Tensor& tensor : std::exchange(measure, {}))
      measure.insert(measure.end(), 4, tensor);
    m_levels.push_back({triangles, {}});
  }
  Operators operators = measured_operators(*triangles, measure);
  m_levels.back().area = operators.area;
  m_measure = std::move(measure);
  m_solver = std::make_unique<Barycenter_solver>(std::move(operators));
}

Barycenter Barycenters::solve(const std::vector<Mass_distribution>& masses,
                              const std::vector<double>& weights, bool do_normalize,
                              const Barycenter_options& options) const
{
  std::vector<Vector> at_sites;
  for(Mass_distribution one : masses)
  {
    for(std::size_t level = 1; level < m_levels.size(); ++level)
      one = refined(*m_levels[level - 1].triangles, *m_levels[level].triangles, one);
    at_sites.push_back(masses_at_sites(*m_levels.back().triangles, m_levels.back().area, one));
    if(!do_normalize)
      continue;
    const double sum = at_sites.back().sum();
    if(!std::isfinite(sum))
      throw Invalid_argument_error("A mass is not a finite number.");
    if(!(sum > 0.))
      throw Invalid_argument_error("Masses that sum to " + std::to_string(sum) +
                                   " cannot be scaled so that they sum to one.");
    at_sites.back() /= sum;
  }
  Barycenter result = m_solver->solve(at_sites, weights, options);
  const double scale = m_levels.back().triangles->scale;
  for(double* square : {&result.value, &result.lower, &result.upper})
    *square *= scale * scale;
  for(double& distance : result.distances)
    distance *= scale;
  result.potentials.clear();
  for(Field& flow : result.flows)
  {
    for(std::size_t f = 0; f < flow.size(); ++f)
    {
      if(!m_measure.empty() && !is_blocked(m_measure[f]))
        flow[f] = product(inverse(m_measure[f]), flow[f]);
      flow[f] = (1. / scale) * flow[f];
    }
    for(std::size_t level = m_levels.size() - 1; level > 0; --level)
      flow = coarsened(flow);
  }
  for(std::size_t level = m_levels.size() - 1; level > 0; --level)
    result.masses =
        coarsened(*m_levels[level - 1].triangles, *m_levels[level].triangles, result.masses);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
