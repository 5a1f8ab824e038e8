// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/hodge.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <utility>

namespace CGAL::Geodesic_processing::internal {

Operators crouzeix_raviart_operators(const Surface_arrays& triangles, const Operators& operators)
{
  if(triangles.is_cloud())
    throw Unsupported_surface_error(
        "Edge operators need a mesh: a cloud has no halfedges with twins.");
  Operators result;
  result.area = operators.area;
  result.corner.resize(operators.corner.size());
  result.hat_gradient.resize(operators.hat_gradient.size());
  result.number_of_vertices = 1; // the boundary
  for(Index h = 0; h < triangles.corner.size(); ++h)
  {
    const Index twin = triangles.twin[h];
    if(twin == none)
      result.corner[h] = 0;
    else
      result.corner[h] = twin < h ? result.corner[twin] : Index(result.number_of_vertices++);
    // The hat function of an edge is 1 minus twice that of the opposite corner.
    result.hat_gradient[h] = -2. * operators.hat_gradient[previous_halfedge(h)];
  }
  return result;
}

Hodge_solver::Hodge_solver(const Surface_arrays& triangles, Operators operators)
    : m_operators(std::move(operators)),
      m_edge_operators(crouzeix_raviart_operators(triangles, m_operators)),
      m_vertex_solver(m_operators), m_edge_solver(m_edge_operators)
{}

Hodge_components Hodge_solver::decompose(const Field& field) const
{
  Hodge_components result;
  result.gradient =
      gradient(m_operators, m_vertex_solver.solve(minus_divergence(m_operators, field)));
  result.rotation = rotated_left(
      gradient(m_edge_operators,
               m_edge_solver.solve(minus_divergence(m_edge_operators, rotated_right(field)))));
  result.harmonic = field;
  for(std::size_t f = 0; f < field.size(); ++f)
    result.harmonic[f] = field[f] - result.gradient[f] - result.rotation[f];
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
