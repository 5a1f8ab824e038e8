// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/particular_fields.h>

#include <CGAL/Geodesic_processing/internal/eigenfunctions.h>
#include <CGAL/Geodesic_processing/internal/harmonic_fields.h>
#include <CGAL/Geodesic_processing/internal/unfold.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Of functions that are zero on the border; one site of each component without border is held.
Sparse_matrix inner_laplacian(const Operators& operators, const Sparse_matrix& laplacian,
                              const std::vector<bool>& is_border,
                              const std::vector<Index>& component, std::size_t components)
{
  Sparse_matrix result = laplacian;
  for(int column = 0; column < result.outerSize(); ++column)
    for(Sparse_matrix::InnerIterator it(result, column); it; ++it)
      if(is_border[it.row()] || is_border[it.col()])
        it.valueRef() = it.row() == it.col() ? 1. : 0.;
  std::vector<bool> is_done(components, false);
  for(std::size_t site = 0; site < operators.number_of_sites; ++site)
    if(is_border[site])
      is_done[component[site]] = true;
  for(Eigen::Index site = 0; site < Eigen::Index(operators.number_of_sites); ++site)
    if(!is_done[component[site]])
    {
      is_done[component[site]] = true;
      double& entry = result.coeffRef(site, site);
      entry = entry > 0. ? 2. * entry : 1.;
    }
  return result;
}

} // namespace

Vector as_column(const Operators& operators, const Field& field)
{
  const auto n = Eigen::Index(field.size());
  Vector result(2 * n);
  for(Eigen::Index f = 0; f < n; ++f)
  {
    const double root = std::sqrt(operators.area[f]);
    result[f] = root * field[f][0];
    result[n + f] = root * field[f][1];
  }
  return result;
}

Field as_field(const Operators& operators, const Vector& column)
{
  const auto n = Eigen::Index(operators.number_of_triangles());
  Field result(std::size_t(n), Planar{0., 0.});
  for(Eigen::Index f = 0; f < n; ++f)
    if(operators.area[f] > 0.)
      result[f] = (1. / std::sqrt(operators.area[f])) * Planar{column[f], column[n + f]};
  return result;
}

Matrix gradients(const Operators& operators, const Matrix& functions)
{
  const auto n = Eigen::Index(operators.number_of_triangles());
  Matrix result(2 * n, functions.cols());
  std::vector<Planar> first(n), second(n);
  for(Eigen::Index f = 0; f < n; ++f)
  {
    const double root = std::sqrt(operators.area[f]);
    first[f] = root * operators.hat[3 * f + 1];
    second[f] = root * operators.hat[3 * f + 2];
  }
  for(Eigen::Index j = 0; j < functions.cols(); ++j)
  {
    const double* function = functions.col(j).data();
    double* x = result.col(j).data();
    double* y = x + n;
    for(Eigen::Index f = 0; f < n; ++f)
    {
      const Index* corner = &operators.corner[3 * f];
      const double origin = function[corner[0]];
      const double a = function[corner[1]] - origin, b = function[corner[2]] - origin;
      x[f] = a * first[f][0] + b * second[f][0];
      y[f] = a * first[f][1] + b * second[f][1];
    }
  }
  return result;
}

// Of triangles that have an area, joined through sides: one for each component.
struct Particular_fields::Tree
{
  std::vector<Index> way;   // #triangles: the side that leads to the root, none at a root
  std::vector<Index> depth; // #triangles: sides to cross on the way there
  std::size_t roots = 0;

  Tree(const Glued_triangles& triangles, const Operators& operators)
      : way(triangles.number_of_triangles(), none), depth(way.size(), none)
  {
    std::vector<Index> front;
    for(Index root = 0; root < way.size(); ++root)
    {
      if(depth[root] != none || !(operators.area[root] > 0.))
        continue;
      ++roots;
      depth[root] = 0;
      front.assign(1, root);
      for(std::size_t i = 0; i < front.size(); ++i)
        for(Index side = 3 * front[i]; side < 3 * front[i] + 3; ++side)
        {
          const Index twin = triangles.twin[side];
          if(twin == none || depth[twin / 3] != none || !(operators.area[twin / 3] > 0.))
            continue;
          depth[twin / 3] = depth[front[i]] + 1;
          way[twin / 3] = twin;
          front.push_back(twin / 3);
        }
    }
  }
};

Particular_fields::Particular_fields(const Glued_triangles& triangles, const Operators& operators,
                                     Particular_field kind)
    : m_triangles(triangles), m_operators(operators), m_kind(kind),
      m_is_border(border_sites(triangles))
{
  std::size_t components = 0;
  std::tie(m_component, components) = internal::components(operators);
  const Laplacian laplacian(operators);
  const Sparse_matrix matrix = laplacian.matrix(operators);
  Sparse_matrix held = matrix;
  laplacian.hold(held);
  m_poisson = std::make_unique<Sparse_solver>(held, Elimination::sparse);

  const auto n = Eigen::Index(operators.number_of_triangles());
  m_harmonic.resize(2 * n, 0);
  if(triangles.is_cloud())
    m_kind = Particular_field::gradient;
  else
  {
    const std::vector<Field> harmonic = internal::harmonic_fields(triangles, operators, *m_poisson);
    m_harmonic.resize(2 * n, Eigen::Index(harmonic.size()));
    for(std::size_t i = 0; i < harmonic.size(); ++i)
      m_harmonic.col(Eigen::Index(i)) = as_column(operators, harmonic[i]);
  }
  if(m_kind == Particular_field::gradient)
    return;

  m_star = 3. * lumped_mass(operators);
  m_tree = std::make_unique<Tree>(triangles, operators);
  std::vector<bool> has_area(components, false);
  for(std::size_t c = 0; c < operators.corner.size(); ++c)
    if(operators.area[c / 3] > 0.)
      has_area[m_component[operators.corner[c]]] = true;
  if(m_tree->roots != std::size_t(std::count(has_area.begin(), has_area.end(), true)))
  {
    m_kind = Particular_field::gradient;
    m_tree.reset();
    return;
  }
  m_inner = std::make_unique<Sparse_solver>(
      inner_laplacian(operators, matrix, m_is_border, m_component, components),
      Elimination::sparse);
}

Particular_fields::~Particular_fields() = default;

Matrix Particular_fields::fields(const Masses& masses) const
{
  if(m_kind == Particular_field::raviart_thomas)
    return balanced_fields(masses);
  return gradients(m_operators, m_poisson->solve_columns(Matrix(masses)));
}

Matrix Particular_fields::balanced_fields(const Masses& masses) const
{
  const auto n = Eigen::Index(m_operators.number_of_triangles());
  Matrix result = Matrix::Zero(2 * n, masses.cols());
  Matrix turning = Matrix::Zero(Eigen::Index(m_operators.number_of_sites), masses.cols());
  // Triangles from far to near, on the way to the root.
  std::priority_queue<std::pair<Index, Index>> queue;
  std::vector<double> missing(std::size_t(n), 0.);
  std::vector<bool> is_queued(std::size_t(n), false);
  const auto add = [&](Index triangle, double mass)
  {
    missing[triangle] += mass;
    if(!is_queued[triangle])
    {
      is_queued[triangle] = true;
      queue.emplace(m_tree->depth[triangle], triangle);
    }
  };
  for(Eigen::Index j = 0; j < masses.cols(); ++j)
  {
    // What flows in through a side (Raviart and Thomas 1977), seen in the middle of the triangle.
    const auto flow_in = [&](Index side, double amount)
    {
      const Index f = side / 3, opposite = previous_side(side) % 3;
      const auto corners = unfolded(m_triangles, f);
      const Planar from_corner =
          (1. / 3.) * (corners[0] + corners[1] + corners[2]) - corners[opposite];
      const Planar flow = (-0.5 * amount / m_operators.area[f]) * from_corner;
      const double root = std::sqrt(m_operators.area[f]);
      result(f, j) += root * flow[0];
      result(n + f, j) += root * flow[1];
      for(std::size_t k = 0; k < 3; ++k)
        turning(m_operators.corner[3 * f + k], j) +=
            m_operators.area[f] * dot(flow, turned_left(m_operators.hat[3 * f + k]));
    };
    for(Masses::InnerIterator it(masses, j); it; ++it)
    {
      const auto site = Index(it.row());
      for(Index k = m_triangles.first[site]; k < m_triangles.first[site + 1]; ++k)
        if(const Index f = m_triangles.star[k] / 3; m_operators.area[f] > 0.)
          add(f, it.value() * m_operators.area[f] / m_star[site]);
    }
    while(!queue.empty())
    {
      const Index f = queue.top().second;
      queue.pop();
      is_queued[f] = false;
      const double amount = std::exchange(missing[f], 0.);
      const Index way = m_tree->way[f];
      if(way == none)
        continue;
      flow_in(way, amount);
      flow_in(m_triangles.twin[way], -amount);
      add(m_triangles.twin[way] / 3, amount);
    }
    for(Eigen::Index site = 0; site < turning.rows(); ++site)
      if(m_is_border[site])
        turning(site, j) = 0.;
  }

  if(m_harmonic.cols() > 0)
    result -= m_harmonic * (m_harmonic.transpose() * result).eval();
  const Matrix rotation = gradients(m_operators, m_inner->solve_columns(turning));
  result.topRows(n) += rotation.bottomRows(n);
  result.bottomRows(n) -= rotation.topRows(n);
  return result;
}

Matrix Particular_fields::without_gradients(const Matrix& columns) const
{
  Matrix divergences(Eigen::Index(m_operators.number_of_sites), columns.cols());
  for(Eigen::Index j = 0; j < columns.cols(); ++j)
    divergences.col(j) = divergence(m_operators, as_field(m_operators, columns.col(j)));
  return columns - gradients(m_operators, m_poisson->solve_columns(divergences));
}

} // namespace CGAL::Geodesic_processing::internal
