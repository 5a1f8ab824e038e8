// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/hodge.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

std::unique_ptr<Sparse_solver> held_laplacian(const Operators& operators)
{
  const Laplacian laplacian(operators);
  Sparse_matrix matrix = laplacian.matrix(operators);
  laplacian.hold(matrix);
  return std::make_unique<Sparse_solver>(matrix);
}

} // namespace

Operators operators_of_sides(const Glued_triangles& triangles, const Operators& operators)
{
  if(triangles.is_cloud())
    throw Unsupported_surface_error("A cloud has no sides: its triangles are not glued.");
  Operators result;
  result.area = operators.area;
  result.corner.resize(operators.corner.size());
  result.hat.resize(operators.hat.size());
  result.number_of_sites = 1; // the border
  for(Index side = 0; side < triangles.corner.size(); ++side)
  {
    const Index twin = triangles.twin[side];
    if(twin == none)
      result.corner[side] = 0;
    else
      result.corner[side] = twin < side ? result.corner[twin] : Index(result.number_of_sites++);
    result.hat[side] = -2. * operators.hat[previous_side(side)]; // of the corner opposite
  }
  return result;
}

Hodge_solver::Hodge_solver(const Glued_triangles& triangles, Operators operators)
    : m_operators(std::move(operators)),
      m_operators_of_sides(operators_of_sides(triangles, m_operators)),
      m_sites(held_laplacian(m_operators)), m_sides(held_laplacian(m_operators_of_sides))
{}

Hodge_parts Hodge_solver::decompose(const Field& field) const
{
  Hodge_parts result;
  result.gradient = gradient(m_operators, m_sites->solve(divergence(m_operators, field)));
  // Three turns to the left are one to the right.
  const Field turned_right = turned_left(turned_left(turned_left(field)));
  result.rotation = turned_left(gradient(
      m_operators_of_sides, m_sides->solve(divergence(m_operators_of_sides, turned_right))));
  result.harmonic = field;
  for(std::size_t f = 0; f < field.size(); ++f)
    result.harmonic[f] = field[f] - result.gradient[f] - result.rotation[f];
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
