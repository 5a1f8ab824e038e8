// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Multilevel_barycenter_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "transport/uniform_refinement.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Multilevel_barycenter_solver::Multilevel_barycenter_solver(
    std::shared_ptr<const Surface_arrays> triangles, unsigned refinements,
    std::vector<Metric_tensor> metric)
{
  require_area(*triangles);
  if(std::ldexp(double(triangles->corner.size()), 2 * int(std::min(refinements, 30u))) > 2e9)
    throw Unsupported_surface_error("The refined surface would have more than 2^31 halfedges.");
  const Operators operators_of_surface = metric_operators(*triangles, metric);
  m_vertex_areas = triangles->scale * triangles->scale * lumped_mass(operators_of_surface);
  m_levels.push_back({triangles, operators_of_surface.area});
  for(unsigned level = 0; level < refinements; ++level)
  {
    triangles = std::make_shared<const Surface_arrays>(refined(*triangles));
    for(const Metric_tensor& tensor : std::exchange(metric, {}))
      metric.insert(metric.end(), 4, tensor);
    m_levels.push_back({triangles, {}});
  }
  Operators operators = metric_operators(*triangles, metric);
  m_levels.back().area = operators.area;
  m_metric = std::move(metric);
  m_solver = std::make_unique<Barycenter_solver>(std::move(operators));
}

Vector Multilevel_barycenter_solver::finest_masses(Mass_distribution distribution,
                                                   bool do_normalize) const
{
  for(std::size_t level = 1; level < m_levels.size(); ++level)
    distribution =
        refined(*m_levels[level - 1].triangles, *m_levels[level].triangles, distribution);
  Vector result =
      masses_at_vertices(*m_levels.back().triangles, m_levels.back().area, distribution);
  if(!do_normalize)
    return result;
  const double sum = result.sum();
  if(!std::isfinite(sum))
    throw Invalid_argument_error("A mass is not a finite number.");
  if(!(sum > 0.))
    throw Invalid_argument_error("A total mass of " + std::to_string(sum) +
                                 " cannot be scaled to one.");
  result /= sum;
  return result;
}

Field Multilevel_barycenter_solver::restored(Field flow) const
{
  for(std::size_t f = 0; f < flow.size(); ++f)
  {
    if(!m_metric.empty() && !is_blocked(m_metric[f]))
      flow[f] = product(inverse(m_metric[f]), flow[f]);
    flow[f] = (1. / m_levels.back().triangles->scale) * flow[f];
  }
  for(std::size_t level = m_levels.size() - 1; level > 0; --level)
    flow = coarsened(flow);
  return flow;
}

Barycenter_result Multilevel_barycenter_solver::solve(const std::vector<Mass_distribution>& masses,
                                                      const std::vector<double>& weights,
                                                      bool do_normalize,
                                                      const Barycenter_options& options) const
{
  std::vector<Vector> at_vertices;
  for(const Mass_distribution& distribution : masses)
    at_vertices.push_back(finest_masses(distribution, do_normalize));
  Barycenter_result result = m_solver->solve(at_vertices, weights, options);
  const double scale = m_levels.back().triangles->scale;
  for(double* square : {&result.value, &result.lower, &result.upper})
    *square *= scale * scale;
  for(double& distance : result.distances)
    distance *= scale;
  result.potentials.clear();
  for(Field& flow : result.flows)
    flow = restored(std::move(flow));
  for(std::size_t level = m_levels.size() - 1; level > 0; --level)
    result.masses =
        coarsened(*m_levels[level - 1].triangles, *m_levels[level].triangles, result.masses);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
