// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/biharmonic.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace CGAL::Geodesic_processing::internal {

Biharmonic_distances::Biharmonic_distances(const Glued_triangles& triangles)
    : m_operators(internal::operators(triangles)), m_mass(lumped_mass(m_operators))
{
  if(!(m_mass.sum() > 0.))
    throw Unsupported_surface_error("The surface has no triangle with an area.");
  std::tie(m_component, m_components) = components(m_operators);
  m_component_mass = Vector::Zero(Eigen::Index(m_components));
  for(std::size_t site = 0; site < m_component.size(); ++site)
    m_component_mass[m_component[site]] += m_mass[Eigen::Index(site)];
  const Laplacian laplacian(m_operators);
  Sparse_matrix matrix = laplacian.matrix(m_operators);
  laplacian.hold(matrix);
  m_solver = std::make_unique<Sparse_solver>(matrix, Elimination::quick);
}

// Of the masses, less the ones of the same masses at the held site of the component: a difference of two
// is that of what they stand for.  Their integrals are zero.
Matrix Biharmonic_distances::green_functions(const Masses& masses) const
{
  Matrix result(masses);
  m_solver->solve_columns(result);
  Vector mean(m_component_mass.size());
  for(Eigen::Index j = 0; j < result.cols(); ++j)
  {
    mean.setZero();
    for(Eigen::Index site = 0; site < result.rows(); ++site)
      mean[m_component[site]] += m_mass[site] * result(site, j);
    for(Eigen::Index site = 0; site < result.rows(); ++site)
      if(m_mass[site] > 0.)
        result(site, j) -= mean[m_component[site]] / m_component_mass[m_component[site]];
  }
  return result;
}

// #components by #columns.
Matrix Biharmonic_distances::component_masses(const Masses& masses) const
{
  Matrix result = Matrix::Zero(Eigen::Index(m_components), masses.cols());
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
      const bool is_apart = (mass.col(i) - mass.col(j)).lpNorm<Eigen::Infinity>() > 1e-9;
      const double distance = std::max(0., square[i] + square[j] - 2. * result(i, j));
      result(i, j) = result(j, i) = is_apart ? infinity : i == j ? 0. : std::sqrt(distance);
    }
  return result;
}

Vector Biharmonic_distances::one_to_all(const Masses& source, unsigned threads) const
{
  const std::size_t n = m_operators.number_of_sites;
  const auto find_squares = [&]
  {
    m_square.resize(Eigen::Index(n));
    constexpr std::size_t at_once = 32;
    for_each_block(n, at_once, threads,
                   [&](std::size_t, std::size_t begin, std::size_t end)
                   {
                     Masses masses(Eigen::Index(n), Eigen::Index(end - begin));
                     for(std::size_t i = begin; i < end; ++i)
                       masses.insert(Eigen::Index(i), Eigen::Index(i - begin)) = 1.;
                     const Matrix functions = green_functions(masses);
                     for(std::size_t i = begin; i < end; ++i)
                       m_square[Eigen::Index(i)] =
                           functions.col(Eigen::Index(i - begin)).cwiseAbs2().dot(m_mass);
                   });
  };
  std::call_once(m_is_known, find_squares);

  const Vector function = green_functions(source).col(0);
  const double square = function.cwiseAbs2().dot(m_mass);
  const Vector product = m_solver->solve(m_mass.cwiseProduct(function));
  const Matrix mass = component_masses(source);
  Vector result = Vector::Constant(Eigen::Index(n), infinity);
  for(Eigen::Index site = 0; site < result.size(); ++site)
    if(m_mass[site] > 0. && std::abs(mass(m_component[site], 0) - 1.) <= 1e-9)
      result[site] = std::sqrt(std::max(0., square + m_square[site] - 2. * product[site]));
  for(Masses::InnerIterator it(source, 0); it; ++it)
    if(it.value() == 1.)
      result[it.row()] = 0.;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
