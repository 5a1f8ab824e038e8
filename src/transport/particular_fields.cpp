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

// Maximum of #triangles times #harmonic fields; an entry has two numbers of eight bytes.
constexpr double max_number_of_entries = 1.25e8;

// Gradients of the hat functions of corners 1 and 2, times the square root of the area.
using Hat_gradients = std::array<Vec2, 2>;

std::vector<Hat_gradients> weighted_hat_gradients(const Operators& operators)
{
  std::vector<Hat_gradients> result(operators.number_of_triangles());
  for(std::size_t f = 0; f < result.size(); ++f)
  {
    const double root = std::sqrt(operators.area[f]);
    result[f] = {root * operators.hat_gradient[3 * f + 1],
                 root * operators.hat_gradient[3 * f + 2]};
  }
  return result;
}

// Computes the gradient of a function as a column of 2 #triangles values.
void write_gradient(const Operators& operators, const std::vector<Hat_gradients>& hat_gradients,
                    const double* function, double* column)
{
  const std::size_t n = hat_gradients.size();
  for(std::size_t f = 0; f < n; ++f)
  {
    const Index* corner = &operators.corner[3 * f];
    const double value_0 = function[corner[0]];
    const double a = function[corner[1]] - value_0, b = function[corner[2]] - value_0;
    column[f] = a * hat_gradients[f][0][0] + b * hat_gradients[f][1][0];
    column[n + f] = a * hat_gradients[f][0][1] + b * hat_gradients[f][1][1];
  }
}

// Returns the Laplacian for functions that vanish on the boundary. In a component without boundary,
// one vertex is pinned.
Sparse_matrix inner_laplacian(const Operators& operators, const std::vector<bool>& is_boundary,
                              const std::vector<Index>& component, std::size_t components)
{
  Sparse_matrix result = Laplacian(operators).matrix(operators);
  for(int column = 0; column < result.outerSize(); ++column)
    for(Sparse_matrix::InnerIterator it(result, column); it; ++it)
      if(is_boundary[it.row()] || is_boundary[it.col()])
        it.valueRef() = it.row() == it.col() ? 1. : 0.;
  std::vector<bool> is_pinned(components, false);
  for(std::size_t vertex = 0; vertex < operators.number_of_vertices; ++vertex)
    if(is_boundary[vertex])
      is_pinned[component[vertex]] = true;
  for(Eigen::Index vertex = 0; vertex < Eigen::Index(operators.number_of_vertices); ++vertex)
    if(!is_pinned[component[vertex]])
    {
      is_pinned[component[vertex]] = true;
      double& entry = result.coeffRef(vertex, vertex);
      entry = entry > 0. ? 2. * entry : 1.;
    }
  return result;
}

} // namespace

Masses masses_at(const Surface_arrays& triangles, const std::vector<Surface_location>& locations)
{
  std::vector<Eigen::Triplet<double>> entries;
  for(std::size_t j = 0; j < locations.size(); ++j)
  {
    const Surface_location& location = locations[j];
    if(location.triangle == none)
      entries.emplace_back(location.vertex, j, 1.);
    else
      for(std::size_t k = 0; k < 3; ++k)
        if(location.barycentric[k] != 0.)
          entries.emplace_back(triangles.corner[3 * location.triangle + k], j,
                               location.barycentric[k]);
  }
  Masses result(Eigen::Index(triangles.number_of_vertices()), Eigen::Index(locations.size()));
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
  Field result(std::size_t(n), Vec2{0., 0.});
  for(Eigen::Index f = 0; f < n; ++f)
    if(operators.area[f] > 0.)
      result[f] = (1. / std::sqrt(operators.area[f])) * Vec2{column[f], column[n + f]};
  return result;
}

Matrix gradients(const Operators& operators, const Matrix& functions)
{
  const std::vector<Hat_gradients> hat_gradients = weighted_hat_gradients(operators);
  Matrix result(2 * Eigen::Index(hat_gradients.size()), functions.cols());
  for(Eigen::Index j = 0; j < functions.cols(); ++j)
    write_gradient(operators, hat_gradients, functions.col(j).data(), result.col(j).data());
  return result;
}

// A spanning forest of the triangles with positive area, across edges: one tree for each component.
struct Particular_fields::Tree
{
  // #triangles: the halfedge that leads to the parent; none at a root
  std::vector<Index> parent_halfedge;
  std::vector<Index> depth; // #triangles: number of edges to the root
  std::size_t roots = 0;

  Tree(const Surface_arrays& triangles, const Operators& operators)
      : parent_halfedge(triangles.number_of_triangles(), none), depth(parent_halfedge.size(), none)
  {
    std::vector<Index> bfs_queue;
    for(Index root = 0; root < parent_halfedge.size(); ++root)
    {
      if(depth[root] != none || !(operators.area[root] > 0.))
        continue;
      ++roots;
      depth[root] = 0;
      bfs_queue.assign(1, root);
      for(std::size_t i = 0; i < bfs_queue.size(); ++i)
        for(Index h = 3 * bfs_queue[i]; h < 3 * bfs_queue[i] + 3; ++h)
        {
          const Index twin = triangles.twin[h];
          if(twin == none || depth[twin / 3] != none || !(operators.area[twin / 3] > 0.))
            continue;
          depth[twin / 3] = depth[bfs_queue[i]] + 1;
          parent_halfedge[twin / 3] = twin;
          bfs_queue.push_back(twin / 3);
        }
    }
  }

  // Returns the flow of a column of masses along the tree to the roots, as pairs of triangle and
  // vector. A triangle can occur twice.
  Sparse_field flow(const Surface_arrays& triangles, const Operators& operators,
                    const Vector& ring_area, const Masses& masses, Eigen::Index column) const
  {
    Sparse_field result;
    // Adds the Raviart-Thomas field (1977) of an inward flux through halfedge h, at the centroid.
    const auto add_inflow = [&](Index h, double amount)
    {
      const Index f = h / 3;
      const auto corners = unfolded(triangles, f);
      const Vec2 middle = (1. / 3.) * (corners[0] + corners[1] + corners[2]);
      result.emplace_back(f, (-0.5 * amount / std::sqrt(operators.area[f])) *
                                 (middle - corners[previous_halfedge(h) % 3]));
    };
    // The deepest triangle is processed first, when all its inflow is known. The order of triangles
    // with equal depth must not depend on the amounts: reversed masses must give the reversed flow.
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
      const auto vertex = Index(it.row());
      for(Index k = triangles.ring_begin[vertex]; k < triangles.ring_begin[vertex + 1]; ++k)
        if(const Index f = triangles.ring[k] / 3; operators.area[f] > 0.)
          queue.push({depth[f], f, it.value() * operators.area[f] / ring_area[vertex]});
    }
    while(!queue.empty())
    {
      const Index f = queue.top().triangle;
      double amount = 0.;
      for(; !queue.empty() && queue.top().triangle == f; queue.pop())
        amount += queue.top().mass;
      if(parent_halfedge[f] == none)
        continue;
      const Index twin = triangles.twin[parent_halfedge[f]];
      add_inflow(parent_halfedge[f], amount);
      add_inflow(twin, -amount);
      queue.push({depth[twin / 3], twin / 3, amount});
    }
    return result;
  }
};

Particular_fields::Particular_fields(const Surface_arrays& triangles, const Operators& operators,
                                     Particular_field kind, bool with_harmonic_fields)
    : m_triangles(triangles), m_operators(operators), m_kind(kind),
      m_is_boundary(boundary_vertices(triangles))
{
  std::size_t components = 0;
  std::tie(m_component, components) = internal::components(operators);
  m_poisson_solver = std::make_unique<Poisson_solver>(operators);

  const auto n = Eigen::Index(operators.number_of_triangles());
  m_harmonic.resize(2 * n, 0);
  if(triangles.is_cloud())
    m_kind = Particular_field::gradient;
  else if(with_harmonic_fields || kind == Particular_field::raviart_thomas)
  {
    if(const std::size_t number = internal::number_of_harmonic_fields(triangles);
       double(number) * double(n) > max_number_of_entries)
      throw Unsupported_surface_error(
          "The surface has " + std::to_string(number) +
          " independent loops around handles and holes, too many for its number of faces.");
    const std::vector<Field> harmonic =
        internal::harmonic_fields(triangles, operators, *m_poisson_solver);
    m_harmonic.resize(2 * n, Eigen::Index(harmonic.size()));
    for(std::size_t i = 0; i < harmonic.size(); ++i)
      m_harmonic.col(Eigen::Index(i)) = as_column(operators, harmonic[i]);
  }
  m_hat_gradients = weighted_hat_gradients(operators);
  if(m_kind == Particular_field::gradient)
    return;

  m_ring_area = 3. * lumped_mass(operators);
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
  m_inner_solver = std::make_unique<Sparse_solver>(
      inner_laplacian(operators, m_is_boundary, m_component, components), Elimination_order::fast);
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
      mass += masses[corner[k]] * m_operators.area[f] / m_ring_area[corner[k]];
    for(std::size_t k = 0; k < 3; ++k)
      result[corner[k]] += mass / 3.;
  }
  return result;
}

Matrix Particular_fields::stream_functions(const std::vector<Sparse_field>& fields) const
{
  Matrix result =
      Matrix::Zero(Eigen::Index(m_operators.number_of_vertices), Eigen::Index(fields.size()));
  for(std::size_t j = 0; j < fields.size(); ++j)
    for(const auto& [f, vector] : fields[j])
      for(std::size_t k = 0; k < 3; ++k)
        if(const Index vertex = m_operators.corner[3 * f + k]; !m_is_boundary[vertex])
          result(vertex, Eigen::Index(j)) +=
              std::sqrt(m_operators.area[f]) *
              dot(vector, rotated_left(m_operators.hat_gradient[3 * f + k]));
  m_inner_solver->solve_columns(result);
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
    m_poisson_solver->solve_columns(potential);
    for(Eigen::Index j = 0; j < masses.cols(); ++j)
    {
      write_gradient(m_operators, m_hat_gradients, potential.col(j).data(), column.data());
      use(j, column);
    }
    return;
  }

  // Compute the flow along the tree and subtract its projections onto rotated gradients and onto
  // harmonic fields.
  std::vector<Sparse_field> flow;
  for(Eigen::Index j = 0; j < masses.cols(); ++j)
    flow.push_back(m_tree->flow(m_triangles, m_operators, m_ring_area, masses, j));
  const Matrix stream_function = stream_functions(flow);
  Vector stream_gradient(2 * n), circulation(m_harmonic.cols());
  for(Eigen::Index j = 0; j < masses.cols(); ++j)
  {
    write_gradient(m_operators, m_hat_gradients, stream_function.col(j).data(),
                   stream_gradient.data());
    column.head(n) = stream_gradient.tail(n);
    column.tail(n) = -stream_gradient.head(n);
    circulation.setZero();
    for(const auto& [f, vector] : flow[j])
    {
      column[f] += vector[0];
      column[n + f] += vector[1];
      if(circulation.size() > 0)
        circulation += vector[0] * m_harmonic.row(f) + vector[1] * m_harmonic.row(n + f);
    }
    if(circulation.size() > 0)
      column.noalias() -= m_harmonic * circulation;
    use(j, column);
  }
}

Matrix Particular_fields::without_gradients(const Matrix& columns) const
{
  Matrix divergences(Eigen::Index(m_operators.number_of_vertices), columns.cols());
  for(Eigen::Index j = 0; j < columns.cols(); ++j)
    divergences.col(j) = minus_divergence(m_operators, as_field(m_operators, columns.col(j)));
  m_poisson_solver->solve_columns(divergences);
  return columns - gradients(m_operators, divergences);
}

} // namespace CGAL::Geodesic_processing::internal
