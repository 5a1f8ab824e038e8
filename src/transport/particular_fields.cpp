// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/particular_fields.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "operators/eigenfunctions.h"
#include "operators/harmonic_fields.h"
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Triangles times harmonic fields, of two numbers each.
constexpr double most_numbers = 1.25e8;

using Slopes = std::array<Planar, 2>; // of the hats of corners 1 and 2, times the root of the area

std::vector<Slopes> slopes(const Operators& operators)
{
  std::vector<Slopes> result(operators.number_of_triangles());
  for(std::size_t f = 0; f < result.size(); ++f)
  {
    const double root = std::sqrt(operators.area[f]);
    result[f] = {root * operators.hat[3 * f + 1], root * operators.hat[3 * f + 2]};
  }
  return result;
}

void write_gradient(const Operators& operators, const std::vector<Slopes>& slope,
                    const double* function, double* column)
{
  const std::size_t n = slope.size();
  for(std::size_t f = 0; f < n; ++f)
  {
    const Index* corner = &operators.corner[3 * f];
    const double first = function[corner[0]];
    const double a = function[corner[1]] - first, b = function[corner[2]] - first;
    column[f] = a * slope[f][0][0] + b * slope[f][1][0];
    column[n + f] = a * slope[f][0][1] + b * slope[f][1][1];
  }
}

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

Masses masses_at(const Glued_triangles& triangles, const std::vector<Location>& locations)
{
  std::vector<Eigen::Triplet<double>> entries;
  for(std::size_t j = 0; j < locations.size(); ++j)
  {
    const Location& location = locations[j];
    if(location.triangle == none)
      entries.emplace_back(location.site, j, 1.);
    else
      for(std::size_t k = 0; k < 3; ++k)
        if(location.barycentric[k] != 0.)
          entries.emplace_back(triangles.corner[3 * location.triangle + k], j,
                               location.barycentric[k]);
  }
  Masses result(Eigen::Index(triangles.number_of_sites()), Eigen::Index(locations.size()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

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
  const std::vector<Slopes> slope = slopes(operators);
  Matrix result(2 * Eigen::Index(slope.size()), functions.cols());
  for(Eigen::Index j = 0; j < functions.cols(); ++j)
    write_gradient(operators, slope, functions.col(j).data(), result.col(j).data());
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

  // Of a column of masses to the roots, in triangles one after another, some of them twice.
  std::vector<std::pair<Index, Planar>> flow(const Glued_triangles& triangles,
                                             const Operators& operators, const Vector& star,
                                             const Masses& masses, Eigen::Index column) const
  {
    std::vector<std::pair<Index, Planar>> result;
    // The field of Raviart and Thomas 1977 of what flows in through a side, in the middle.
    const auto flow_in = [&](Index side, double amount)
    {
      const Index f = side / 3;
      const auto corners = unfolded(triangles, f);
      const Planar middle = (1. / 3.) * (corners[0] + corners[1] + corners[2]);
      result.emplace_back(f, (-0.5 * amount / std::sqrt(operators.area[f])) *
                                 (middle - corners[previous_side(side) % 3]));
    };
    // Far ones first: all that flows through a triangle is known then.  The order of equal ones must not
    // depend on amounts, of which the way back has the opposite ones.
    struct Amount
    {
      Index depth, triangle;
      double mass;

      bool operator<(const Amount& other) const
      {
        return std::tie(depth, triangle) < std::tie(other.depth, other.triangle);
      }
    };
    std::priority_queue<Amount> queue;
    for(Masses::InnerIterator it(masses, column); it; ++it)
    {
      const auto site = Index(it.row());
      for(Index k = triangles.first[site]; k < triangles.first[site + 1]; ++k)
        if(const Index f = triangles.star[k] / 3; operators.area[f] > 0.)
          queue.push({depth[f], f, it.value() * operators.area[f] / star[site]});
    }
    while(!queue.empty())
    {
      const Index f = queue.top().triangle;
      double amount = 0.;
      for(; !queue.empty() && queue.top().triangle == f; queue.pop())
        amount += queue.top().mass;
      if(way[f] == none)
        continue;
      const Index twin = triangles.twin[way[f]];
      flow_in(way[f], amount);
      flow_in(twin, -amount);
      queue.push({depth[twin / 3], twin / 3, amount});
    }
    return result;
  }
};

Particular_fields::Particular_fields(const Glued_triangles& triangles, const Operators& operators,
                                     Particular_field kind, bool with_harmonic_fields)
    : m_triangles(triangles), m_operators(operators), m_kind(kind),
      m_is_border(border_sites(triangles))
{
  std::size_t components = 0;
  std::tie(m_component, components) = internal::components(operators);
  const Laplacian laplacian(operators);
  const Sparse_matrix matrix = laplacian.matrix(operators);
  Sparse_matrix held = matrix;
  laplacian.hold(held);
  m_poisson = std::make_unique<Sparse_solver>(held, Elimination::quick);

  const auto n = Eigen::Index(operators.number_of_triangles());
  m_harmonic.resize(2 * n, 0);
  if(triangles.is_cloud())
    m_kind = Particular_field::gradient;
  else if(with_harmonic_fields || kind == Particular_field::raviart_thomas)
  {
    if(const std::size_t number = internal::number_of_harmonic_fields(triangles);
       double(number) * double(n) > most_numbers)
      throw Unsupported_surface_error(
          "The surface has " + std::to_string(number) +
          " ways around handles and holes, too many for so many faces.");
    const std::vector<Field> harmonic = internal::harmonic_fields(triangles, operators, *m_poisson);
    m_harmonic.resize(2 * n, Eigen::Index(harmonic.size()));
    for(std::size_t i = 0; i < harmonic.size(); ++i)
      m_harmonic.col(Eigen::Index(i)) = as_column(operators, harmonic[i]);
  }
  m_slope = slopes(operators);
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
      inner_laplacian(operators, matrix, m_is_border, m_component, components), Elimination::quick);
}

Particular_fields::~Particular_fields() = default;

Matrix Particular_fields::fields(const Masses& masses) const
{
  Matrix result(2 * Eigen::Index(m_operators.number_of_triangles()), masses.cols());
  for_each_field(masses, [&](Eigen::Index j, const Vector& column) { result.col(j) = column; });
  return result;
}

Vector Particular_fields::balanced(const Vector& masses) const
{
  if(m_kind == Particular_field::gradient)
    return masses;
  Vector result = Vector::Zero(masses.size());
  for(std::size_t f = 0; f < m_operators.number_of_triangles(); ++f)
  {
    const Index* corner = &m_operators.corner[3 * f];
    double mass = 0.;
    for(std::size_t k = 0; k < 3 && m_operators.area[f] > 0.; ++k)
      mass += masses[corner[k]] * m_operators.area[f] / m_star[corner[k]];
    for(std::size_t k = 0; k < 3; ++k)
      result[corner[k]] += mass / 3.;
  }
  return result;
}

void Particular_fields::for_each_field(
    const Masses& masses, const std::function<void(Eigen::Index, const Vector&)>& use) const
{
  const auto n = Eigen::Index(m_operators.number_of_triangles());
  Vector column(2 * n);
  if(m_kind == Particular_field::gradient)
  {
    Matrix potential(masses);
    m_poisson->solve_columns(potential);
    for(Eigen::Index j = 0; j < masses.cols(); ++j)
    {
      write_gradient(m_operators, m_slope, potential.col(j).data(), column.data());
      use(j, column);
    }
    return;
  }

  // What flows along the tree, and the function whose turned gradient is its part of such fields.
  std::vector<std::vector<std::pair<Index, Planar>>> flow(std::size_t(masses.cols()));
  Matrix turning = Matrix::Zero(Eigen::Index(m_operators.number_of_sites), masses.cols());
  for(Eigen::Index j = 0; j < masses.cols(); ++j)
  {
    flow[j] = m_tree->flow(m_triangles, m_operators, m_star, masses, j);
    for(const auto& [f, vector] : flow[j])
      for(std::size_t k = 0; k < 3; ++k)
        if(const Index site = m_operators.corner[3 * f + k]; !m_is_border[site])
          turning(site, j) +=
              std::sqrt(m_operators.area[f]) * dot(vector, turned_left(m_operators.hat[3 * f + k]));
  }
  m_inner->solve_columns(turning);
  Vector turned(2 * n), around(m_harmonic.cols());
  for(Eigen::Index j = 0; j < masses.cols(); ++j)
  {
    write_gradient(m_operators, m_slope, turning.col(j).data(), turned.data());
    column.head(n) = turned.tail(n);
    column.tail(n) = -turned.head(n);
    around.setZero();
    for(const auto& [f, vector] : flow[j])
    {
      column[f] += vector[0];
      column[n + f] += vector[1];
      if(around.size() > 0)
        around += vector[0] * m_harmonic.row(f) + vector[1] * m_harmonic.row(n + f);
    }
    if(around.size() > 0)
      column.noalias() -= m_harmonic * around;
    use(j, column);
  }
}

Matrix Particular_fields::without_gradients(const Matrix& columns) const
{
  Matrix divergences(Eigen::Index(m_operators.number_of_sites), columns.cols());
  for(Eigen::Index j = 0; j < columns.cols(); ++j)
    divergences.col(j) = divergence(m_operators, as_field(m_operators, columns.col(j)));
  m_poisson->solve_columns(divergences);
  return columns - gradients(m_operators, divergences);
}

} // namespace CGAL::Geodesic_processing::internal
