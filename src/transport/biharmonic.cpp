// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/biharmonic.h>

#include <CGAL/Geodesic_processing/internal/core/parallel.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace CGAL::Geodesic_processing::internal {

Biharmonic_distances::Biharmonic_distances(const Surface_arrays& triangles)
    : m_operators(internal::operators(triangles, Degenerate_triangles::thickened)),
      m_mass(lumped_mass(m_operators))
{
  require_area(triangles);
  std::tie(m_component, m_number_of_components) = components(m_operators);
  m_component_mass = Vector::Zero(Eigen::Index(m_number_of_components));
  for(std::size_t vertex = 0; vertex < m_component.size(); ++vertex)
    m_component_mass[m_component[vertex]] += m_mass[Eigen::Index(vertex)];
  m_solver = std::make_unique<Poisson_solver>(m_operators);
}

// Returns the Green's function of each column minus that of the same masses at the pinned vertices.
// The difference of two columns with equal masses on each component is the difference of their
// Green's functions. All integrals are zero.
Matrix Biharmonic_distances::green_functions(const Masses& masses) const
{
  Matrix result(masses);
  m_solver->solve_columns(result);
  Vector mean(m_component_mass.size());
  for(Eigen::Index j = 0; j < result.cols(); ++j)
  {
    mean.setZero();
    for(Eigen::Index vertex = 0; vertex < result.rows(); ++vertex)
      mean[m_component[vertex]] += m_mass[vertex] * result(vertex, j);
    for(Eigen::Index vertex = 0; vertex < result.rows(); ++vertex)
      if(m_mass[vertex] > 0.)
        result(vertex, j) -= mean[m_component[vertex]] / m_component_mass[m_component[vertex]];
  }
  return result;
}

// Returns the mass on each component: #components by #columns.
Matrix Biharmonic_distances::component_masses(const Masses& masses) const
{
  Matrix result = Matrix::Zero(Eigen::Index(m_number_of_components), masses.cols());
  for(Eigen::Index j = 0; j < masses.cols(); ++j)
    for(Masses::InnerIterator it(masses, j); it; ++it)
      result(m_component[it.row()], j) += it.value();
  return result;
}

Matrix Biharmonic_distances::all_pairs(const Masses& masses) const
{
  Matrix functions = green_functions(masses), result;
  functions.array().colwise() *= m_mass.array().sqrt();
  transposed_product(functions, functions, result);
  const Matrix mass = component_masses(masses);
  const Vector square = result.diagonal();
  for(Eigen::Index j = 0; j < result.cols(); ++j)
    for(Eigen::Index i = 0; i <= j; ++i)
    {
      const bool is_disconnected = (mass.col(i) - mass.col(j)).lpNorm<Eigen::Infinity>() > 1e-9;
      const double distance = std::max(0., square[i] + square[j] - 2. * result(i, j));
      result(i, j) = result(j, i) = is_disconnected ? infinity : i == j ? 0. : std::sqrt(distance);
    }
  return result;
}

Vector Biharmonic_distances::one_to_all(const Masses& source, unsigned number_of_threads) const
{
  const std::size_t n = m_operators.number_of_vertices;
  const auto compute_squared_distances = [&]
  {
    m_squared_distances.resize(Eigen::Index(n));
    constexpr std::size_t block_size = 32;
    for_each_block(n, block_size, number_of_threads,
                   [&](std::size_t, std::size_t begin, std::size_t end)
                   {
                     Masses masses(Eigen::Index(n), Eigen::Index(end - begin));
                     for(std::size_t i = begin; i < end; ++i)
                       masses.insert(Eigen::Index(i), Eigen::Index(i - begin)) = 1.;
                     const Matrix functions = green_functions(masses);
                     for(std::size_t i = begin; i < end; ++i)
                       m_squared_distances[Eigen::Index(i)] =
                           functions.col(Eigen::Index(i - begin)).cwiseAbs2().dot(m_mass);
                   });
  };
  std::call_once(m_squares_computed, compute_squared_distances);

  const Vector function = green_functions(source).col(0);
  const double square = function.cwiseAbs2().dot(m_mass);
  const Vector product = m_solver->solve(m_mass.cwiseProduct(function));
  const Matrix mass = component_masses(source);
  Vector result = Vector::Constant(Eigen::Index(n), infinity);
  for(Eigen::Index vertex = 0; vertex < result.size(); ++vertex)
    if(m_mass[vertex] > 0. && std::abs(mass(m_component[vertex], 0) - 1.) <= 1e-9)
      result[vertex] =
          std::sqrt(std::max(0., square + m_squared_distances[vertex] - 2. * product[vertex]));
  for(Masses::InnerIterator it(source, 0); it; ++it)
    if(it.value() == 1.)
      result[it.row()] = 0.;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
