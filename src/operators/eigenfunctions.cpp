// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/eigenfunctions.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include "numerics/dense_solvers.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Bounds of the columns of the null space and of the Lanczos basis. Equal components repeat each
// eigenvalue, so that no gap follows it. Without a bound, the basis then grows to the number of
// vertices.
constexpr Eigen::Index max_closed_components = 512;
Eigen::Index max_basis_columns(Eigen::Index requested) { return 512 + 8 * requested; }

// The generalized eigenproblem L x = value M x on the free vertices, in symmetric form. The
// operator M^(1/2) L^-1 M^(1/2) has the reciprocals as eigenvalues, so that its largest eigenvalues
// belong to the smallest values. A vertex is free if it has mass and is not on the boundary.
class Inverse_operator
{
public:
  Inverse_operator(const Surface_arrays& triangles, const Operators& operators)
  {
    const Vector mass = lumped_mass(operators);
    const std::vector<bool> is_boundary = boundary_vertices(triangles);
    const auto [component, number] = components(operators);
    std::vector<bool> has_boundary(number, false);
    std::vector<Index> reduced_index(operators.number_of_vertices, none);
    for(Index vertex = 0; vertex < reduced_index.size(); ++vertex)
      if(is_boundary[vertex])
        has_boundary[component[vertex]] = true;
      else if(mass[vertex] > 0.)
      {
        reduced_index[vertex] = Index(m_free_vertices.size());
        m_free_vertices.push_back(vertex);
      }
    m_sqrt_mass.resize(size());
    for(Eigen::Index i = 0; i < size(); ++i)
      m_sqrt_mass[i] = std::sqrt(mass[m_free_vertices[i]]);
    assemble_laplacian(operators, reduced_index);
    if(size() > 0)
      factorize(component, has_boundary);
  }

  Eigen::Index size() const { return Eigen::Index(m_free_vertices.size()); }
  const Matrix& null_space() const { return m_null_space; }

  // Applies the operator to columns, which must be orthogonal to the null space.
  Matrix apply(const Matrix& columns) const
  {
    Matrix result = m_sqrt_mass.asDiagonal() * columns;
    m_solver->solve_columns(result);
    return m_sqrt_mass.asDiagonal() * result;
  }

  // Returns the number of eigenvalues below `value`, which must lie in a gap of the spectrum.
  // Returns -1 if the factorization failed.
  Eigen::Index number_of_eigenvalues_below(double value) const
  {
    Sparse_matrix shifted = m_laplacian;
    shifted.diagonal() -= value * m_sqrt_mass.cwiseAbs2();
    const Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Lower> ldlt(shifted);
    if(ldlt.info() != Eigen::Success || !ldlt.vectorD().allFinite())
      return -1;
    return (ldlt.vectorD().array() < 0.).count() - m_null_space.cols();
  }

  // Returns the function of each column, at all vertices.
  Matrix functions(const Matrix& columns, std::size_t number_of_vertices) const
  {
    Matrix result = Matrix::Zero(Eigen::Index(number_of_vertices), columns.cols());
    for(Eigen::Index i = 0; i < size(); ++i)
      result.row(m_free_vertices[i]) = columns.row(i) / m_sqrt_mass[i];
    return result;
  }

private:
  // Extracts the rows and columns of free vertices from the Laplacian.
  void assemble_laplacian(const Operators& operators, const std::vector<Index>& reduced_index)
  {
    const Sparse_matrix full_laplacian = Laplacian(operators).matrix(operators);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(std::size_t(full_laplacian.nonZeros()));
    for(int column = 0; column < full_laplacian.outerSize(); ++column)
      for(Sparse_matrix::InnerIterator it(full_laplacian, column); it; ++it)
        if(reduced_index[it.row()] != none && reduced_index[it.col()] != none)
          entries.emplace_back(std::max(reduced_index[it.row()], reduced_index[it.col()]),
                               std::min(reduced_index[it.row()], reduced_index[it.col()]),
                               it.value());
    m_laplacian.resize(size(), size());
    m_laplacian.setFromTriplets(entries.begin(), entries.end());
  }

  // Pins one vertex of each component without boundary. The null space is projected out by the
  // Lanczos iteration.
  void factorize(const std::vector<Index>& component, const std::vector<bool>& has_boundary)
  {
    std::vector<Index> constant_index(has_boundary.size(), none);
    Index constants = 0;
    Sparse_matrix pinned = m_laplacian;
    for(Eigen::Index i = 0; i < size(); ++i)
    {
      const Index c = component[m_free_vertices[i]];
      if(has_boundary[c] || constant_index[c] != none)
        continue;
      constant_index[c] = constants++;
      pinned.coeffRef(i, i) *= 2.;
    }
    if(Eigen::Index(constants) > max_closed_components)
      throw Unsupported_surface_error(
          "Eigenfunctions are computed on at most 512 closed components.");
    m_null_space = Matrix::Zero(size(), constants);
    for(Eigen::Index i = 0; i < size(); ++i)
      if(const Index c = constant_index[component[m_free_vertices[i]]]; c != none)
        m_null_space(i, c) = m_sqrt_mass[i];
    m_null_space.colwise().normalize();
    m_solver = std::make_unique<Sparse_solver>(pinned, Elimination_order::fast);
  }

  std::vector<Index> m_free_vertices; // indices of vertices
  Vector m_sqrt_mass;                 // #free vertices
  Sparse_matrix m_laplacian;
  Matrix m_null_space; // orthonormal columns: the constants of components without boundary
  std::unique_ptr<Sparse_solver> m_solver;
};

// Block Lanczos iteration (Golub and Underwood 1977) with full reorthogonalization and without
// restarts. It uses three to four columns for each eigenfunction.
class Block_lanczos
{
public:
  explicit Block_lanczos(const Inverse_operator& inverse)
      : m_inverse(inverse), m_residual(inverse.size(), 0)
  {}

  // Returns the maximum number of columns that can be added.
  Eigen::Index remaining_dimension() const
  {
    return m_inverse.size() - m_inverse.null_space().cols() - m_size;
  }

  // Adds the next block. Random columns are appended to it: if an eigenvalue has a higher
  // multiplicity than a block has columns, previous blocks miss some of its eigenvectors.
  void expand(Eigen::Index number_of_random_columns)
  {
    Matrix block(m_inverse.size(), m_residual.cols() + number_of_random_columns);
    block.leftCols(m_residual.cols()) = m_residual;
    for(Eigen::Index j = m_residual.cols(); j < block.cols(); ++j)
      for(double& x : block.col(j))
        x = m_uniform(m_random);
    make_orthogonal(block);
    const Eigen::Index number_added = std::min(make_orthonormal(block), remaining_dimension());
    block.conservativeResize(Eigen::NoChange, number_added);

    if(m_basis.cols() < m_size + number_added)
      m_basis.conservativeResize(m_inverse.size(), 2 * (m_size + number_added));
    if(m_basis.rows() == 0)
      m_basis.resize(m_inverse.size(), 2 * (m_size + number_added));
    m_basis.middleCols(m_size, number_added) = block;
    m_size += number_added;
    m_last_block_size = number_added;

    m_residual = m_inverse.apply(block);
    const Matrix coefficients = make_orthogonal(m_residual);
    m_projected_operator.conservativeResize(m_size, m_size);
    m_projected_operator.rightCols(number_added) = coefficients;
    m_projected_operator.bottomRows(number_added) = coefficients.transpose();
  }

  // Computes the Ritz pairs, largest values first, and the number of converged ones. The error of a
  // value is of second order in the residual: a relative residual of 1e-8 leaves a relative error
  // of 1e-16.
  void solve()
  {
    const Eigen_system solver = eigen_system(m_projected_operator);
    // Assignments of temporary matrices swap. If Eigen resizes a matrix and there is no memory, the
    // matrix still points to its old block, which is free.
    m_values = Vector(solver.values.reverse());
    m_vectors = Matrix(solver.vectors.rowwise().reverse());
    const Matrix residual = small_product(m_residual, m_vectors.bottomRows(m_last_block_size));
    m_number_of_converged = 0;
    while(m_number_of_converged < m_size &&
          (remaining_dimension() == 0 ||
           residual.col(m_number_of_converged).norm() <= 1e-8 * m_values[m_number_of_converged]))
      ++m_number_of_converged;
  }
  Eigen::Index size() const { return m_size; }
  Eigen::Index number_of_converged() const { return m_number_of_converged; }
  double value(Eigen::Index i) const { return 1. / m_values[i]; }
  Matrix vectors(Eigen::Index number) const
  {
    Matrix result;
    product(m_basis.leftCols(m_size), m_vectors.leftCols(number), result);
    return result;
  }

private:
  // Makes the columns of the block orthogonal to the null space and to the basis. One sweep leaves
  // round-off errors; the second one removes them. Returns the coefficients of the basis.
  Matrix make_orthogonal(Matrix& block) const
  {
    Matrix total_coefficients = Matrix::Zero(m_size, block.cols());
    Matrix coefficients, projected;
    for(int sweep = 0; sweep < 2; ++sweep)
    {
      block -= small_product(m_inverse.null_space(),
                             small_transposed_product(m_inverse.null_space(), block));
      if(m_size == 0)
        continue;
      transposed_product(m_basis.leftCols(m_size), block, coefficients);
      product(m_basis.leftCols(m_size), coefficients, projected);
      block -= projected;
      total_coefficients += coefficients;
    }
    return total_coefficients;
  }

  // Applies the modified Gram-Schmidt method. A column is dropped if only round-off errors remain
  // of it. Returns the number of columns left.
  Eigen::Index make_orthonormal(Matrix& block) const
  {
    Eigen::Index kept = 0;
    const Vector size = block.colwise().norm();
    for(Eigen::Index j = 0; j < block.cols(); ++j)
    {
      Vector column = block.col(j);
      for(int sweep = 0; sweep < 2; ++sweep)
        for(Eigen::Index i = 0; i < kept; ++i)
          column -= block.col(i).dot(column) * block.col(i);
      if(!(column.norm() > 1e-10 * size.maxCoeff()))
        continue;
      block.col(kept++) = column.normalized();
    }
    return kept;
  }

  const Inverse_operator& m_inverse;
  std::mt19937 m_random{1};
  std::uniform_real_distribution<double> m_uniform{-1., 1.};
  Matrix m_basis;          // capacity: more than m_size columns
  Eigen::Index m_size = 0; // number of columns that are set
  Eigen::Index m_last_block_size = 0;
  Matrix m_projected_operator; // the operator in the basis
  Matrix m_residual;           // the operator applied to the last block, orthogonal to the basis
  Vector m_values;
  Matrix m_vectors;
  Eigen::Index m_number_of_converged = 0;
};

// Returns the smallest number of functions, at least `number`, that is followed by a gap. Returns 0
// if there is none among the converged values. The value after the gap must have converged as well.
Eigen::Index size_up_to_gap(const Block_lanczos& lanczos, Eigen::Index number)
{
  for(Eigen::Index k = number; k < lanczos.number_of_converged(); ++k)
    if(lanczos.value(k) - lanczos.value(k - 1) > spectral_gap(std::size_t(k)) * lanczos.value(k))
      return k;
  return 0;
}

} // namespace

std::vector<bool> boundary_vertices(const Surface_arrays& triangles)
{
  std::vector<bool> result(triangles.number_of_vertices(), false);
  for(Index h = 0; h < triangles.twin.size(); ++h)
    if(triangles.twin[h] == none)
      result[triangles.corner[h]] = result[triangles.corner[next_halfedge(h)]] = true;
  return result;
}

Eigenfunctions eigenfunctions(const Surface_arrays& triangles, const Operators& operators,
                              std::size_t number)
{
  const Inverse_operator inverse(triangles, operators);
  const Eigen::Index dimension = inverse.size() - inverse.null_space().cols();
  const Eigen::Index requested = Eigen::Index(std::min(number, std::size_t(dimension)));
  Eigenfunctions result;
  if(requested == 0)
  {
    result.function.resize(Eigen::Index(operators.number_of_vertices), 0);
    return result;
  }

  constexpr Eigen::Index block = 8; // as fast as 4, twice as fast as 32
  Block_lanczos lanczos(inverse);
  lanczos.expand(block);
  Eigen::Index number_chosen = 0,
               next_size = std::min(dimension, requested + requested / 2 + 2 * block);
  for(int recounts = 0; number_chosen == 0;)
  {
    while(lanczos.remaining_dimension() > 0 && lanczos.size() < next_size)
      lanczos.expand(0);
    next_size = lanczos.size() + lanczos.size() / 8 + block;
    lanczos.solve();
    number_chosen = lanczos.remaining_dimension() == 0 && requested == dimension
                        ? dimension
                        : size_up_to_gap(lanczos, requested);
    if(lanczos.remaining_dimension() == 0 && number_chosen == 0)
      number_chosen = dimension;
    if(number_chosen == 0 && lanczos.size() > max_basis_columns(requested))
      throw Unsupported_surface_error("The spectrum has no gap that separates the requested number "
                                      "of eigenfunctions: many eigenvalues are equal.");
    if(number_chosen == 0 || number_chosen == dimension || recounts == 5)
      continue;
    // The midpoint of the gap.
    const double cutoff = 0.5 * (lanczos.value(number_chosen - 1) + lanczos.value(number_chosen));
    const Eigen::Index missing = inverse.number_of_eigenvalues_below(cutoff) - number_chosen;
    if(missing <= 0)
      continue;
    lanczos.expand(missing + block);
    number_chosen = 0;
    ++recounts;
  }

  result.value.resize(number_chosen);
  for(Eigen::Index i = 0; i < number_chosen; ++i)
    result.value[i] = lanczos.value(i);
  result.function = inverse.functions(lanczos.vectors(number_chosen), operators.number_of_vertices);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
