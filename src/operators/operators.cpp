// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "core/unfold.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns twice the area below which a triangle is degenerate.
double min_doubled_area(const double* length)
{
  const auto [shortest, longest] = std::minmax({length[0], length[1], length[2]});
  return 1e-7 * shortest * longest;
}

} // namespace

Operators operators(const Surface_arrays& triangles, Degenerate_triangles degenerate)
{
  Operators result;
  const std::size_t n = triangles.number_of_triangles();
  result.corner = triangles.corner;
  result.number_of_vertices = triangles.number_of_vertices();
  result.area.assign(n, 0.);
  result.hat_gradient.assign(3 * n, Vec2{0., 0.});
  for(std::size_t f = 0; f < n; ++f)
  {
    const double* length = &triangles.length[3 * f];
    double doubled_area = twice_area(length[0], length[1], length[2]);
    auto points = unfolded(triangles, Index(f));
    if(const double minimum = min_doubled_area(length); !(doubled_area > minimum))
    {
      if(degenerate == Degenerate_triangles::skipped || !(minimum > 0.))
        continue;
      // Otherwise differences of potentials across the height are round-off errors.
      constexpr double min_height = 1e-9;
      doubled_area = std::max(minimum, min_height * std::max({length[0], length[1], length[2]}));
      points[2][1] = doubled_area / length[0];
    }
    result.area[f] = 0.5 * doubled_area * (triangles.weight.empty() ? 1. : triangles.weight[f]);
    for(std::size_t k = 0; k < 3; ++k)
      result.hat_gradient[3 * f + k] =
          (1. / doubled_area) * rotated_left(points[(k + 2) % 3] - points[(k + 1) % 3]);
  }
  return result;
}

void require_area(const Surface_arrays& triangles)
{
  for(std::size_t f = 0; f < triangles.number_of_triangles(); ++f)
  {
    const double* length = &triangles.length[3 * f];
    if(twice_area(length[0], length[1], length[2]) > min_doubled_area(length))
      return;
  }
  throw Unsupported_surface_error("No triangle of the surface has an area.");
}

Operators metric_operators(const Surface_arrays& t, const std::vector<Metric_tensor>& metric)
{
  Operators result = operators(t, Degenerate_triangles::thickened);
  for(std::size_t f = 0; f < metric.size(); ++f)
  {
    const bool is_wall = is_blocked(metric[f]);
    if(is_wall)
      result.area[f] = 0.;
    for(std::size_t corner = 3 * f; corner < 3 * f + 3; ++corner)
      result.hat_gradient[corner] =
          is_wall ? Vec2{0., 0.} : product(inverse(metric[f]), result.hat_gradient[corner]);
  }
  return result;
}

void gradient(const Operators& operators, const Vector& function, Field& result)
{
  result.resize(operators.number_of_triangles());
  for(std::size_t f = 0; f < result.size(); ++f)
  {
    const Index* corner = &operators.corner[3 * f];
    const Vec2* hat_gradient = &operators.hat_gradient[3 * f];
    const double value_0 = function[corner[0]];
    result[f] = (function[corner[1]] - value_0) * hat_gradient[1] +
                (function[corner[2]] - value_0) * hat_gradient[2];
  }
}

Field gradient(const Operators& operators, const Vector& function)
{
  Field result;
  gradient(operators, function, result);
  return result;
}

Vector minus_divergence(const Operators& operators, const Field& field)
{
  Vector result = Vector::Zero(Eigen::Index(operators.number_of_vertices));
  for(std::size_t f = 0; f < field.size(); ++f)
  {
    const Vec2 flow = operators.area[f] * field[f];
    for(std::size_t k = 0; k < 3; ++k)
      result[operators.corner[3 * f + k]] += dot(flow, operators.hat_gradient[3 * f + k]);
  }
  return result;
}

Field rotated_right(Field field)
{
  for(Vec2& vector : field)
    vector = rotated_right(vector);
  return field;
}

Field rotated_left(Field field)
{
  for(Vec2& vector : field)
    vector = rotated_left(vector);
  return field;
}

double inner_product(const Operators& operators, const Field& a, const Field& b)
{
  double result = 0.;
  for(std::size_t f = 0; f < a.size(); ++f)
    result += operators.area[f] * dot(a[f], b[f]);
  return result;
}

double integrated_length(const Operators& o, const Field& field, double initial)
{
  double result = initial;
  for(std::size_t f = 0; f < field.size(); ++f)
    result += o.area[f] * norm(field[f]);
  return result;
}

Vector lumped_mass(const Operators& operators)
{
  Vector result = Vector::Zero(Eigen::Index(operators.number_of_vertices));
  for(std::size_t c = 0; c < operators.corner.size(); ++c)
    result[operators.corner[c]] += operators.area[c / 3] / 3.;
  return result;
}

Vector mean_magnitudes(const Surface_arrays& triangles, const Field& field)
{
  const Operators o = operators(triangles);
  Vector sum = Vector::Zero(Eigen::Index(o.number_of_vertices)), area = sum;
  for(std::size_t c = 0; c < o.corner.size() && !field.empty(); ++c)
  {
    sum[o.corner[c]] += o.area[c / 3] * norm(field[c / 3]);
    area[o.corner[c]] += o.area[c / 3];
  }
  for(Eigen::Index i = 0; i < sum.size(); ++i)
    if(area[i] > 0.)
      sum[i] /= area[i];
  return sum;
}

std::pair<std::vector<Index>, std::size_t> components(const Operators& operators)
{
  std::vector<Index> parent(operators.number_of_vertices);
  std::iota(parent.begin(), parent.end(), Index(0));
  const auto root = [&](Index vertex)
  {
    while(parent[vertex] != vertex)
      vertex = parent[vertex] = parent[parent[vertex]];
    return vertex;
  };
  for(std::size_t c = 0; c < operators.corner.size(); ++c)
    if(operators.area[c / 3] > 0.)
    {
      const Index a = root(operators.corner[c]), b = root(operators.corner[c - c % 3]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  std::vector<Index> label(parent.size());
  std::size_t count = 0;
  // the root is the smallest index of its set
  for(Index vertex = 0; vertex < parent.size(); ++vertex)
    label[vertex] = parent[vertex] == vertex ? Index(count++) : label[root(vertex)];
  return {std::move(label), count};
}

Laplacian::Laplacian(const Operators& operators)
{
  const auto n = Eigen::Index(operators.number_of_vertices);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(operators.corner.size() + operators.number_of_vertices);
  for(Eigen::Index vertex = 0; vertex < n; ++vertex)
    entries.emplace_back(vertex, vertex, 0.);
  for(Index h = 0; h < operators.corner.size(); ++h)
  {
    const Index a = operators.corner[h], b = operators.corner[next_halfedge(h)];
    entries.emplace_back(std::max(a, b), std::min(a, b), 0.);
  }
  m_pattern.resize(n, n);
  m_pattern.setFromTriplets(entries.begin(), entries.end());

  const int* row = m_pattern.innerIndexPtr();
  const int* column = m_pattern.outerIndexPtr();
  const auto entry_index = [&](Index a, Index b)
  {
    const Index low = std::min(a, b), high = std::max(a, b);
    return Index(std::lower_bound(row + column[low], row + column[low + 1], int(high)) - row);
  };
  m_entries.resize(operators.number_of_triangles());
  for(std::size_t f = 0; f < m_entries.size(); ++f)
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Index a = operators.corner[3 * f + k], b = operators.corner[3 * f + (k + 1) % 3];
      m_entries[f][k] = entry_index(a, a);
      m_entries[f][3 + k] = entry_index(a, b);
    }

  const auto [component, number] = components(operators);
  m_pinned.assign(number, none);
  for(Index vertex = 0; vertex < component.size(); ++vertex)
    if(m_pinned[component[vertex]] == none)
      m_pinned[component[vertex]] = entry_index(vertex, vertex);
}

Sparse_matrix Laplacian::matrix(const Operators& operators) const
{
  Sparse_matrix result = m_pattern;
  assemble(operators, std::vector<Metric_tensor>(m_entries.size(), Metric_tensor{1., 0., 1.}),
           result);
  return result;
}

void Laplacian::assemble(const Operators& operators, const std::vector<Metric_tensor>& tensors,
                         Sparse_matrix& matrix) const
{
  double* const values = matrix.valuePtr();
  std::fill_n(values, matrix.nonZeros(), 0.);
  for(std::size_t f = 0; f < m_entries.size(); ++f)
  {
    const Metric_tensor& tensor = tensors[f];
    const Vec2* hat_gradient = &operators.hat_gradient[3 * f];
    std::array<Vec2, 3> flow;
    for(std::size_t k = 0; k < 3; ++k)
      flow[k] = operators.area[f] * product(tensor, hat_gradient[k]);
    const auto& entries = m_entries[f];
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t next_k = (k + 1) % 3;
      values[entries[k]] += dot(flow[k], hat_gradient[k]);
      // If an edge is a loop, both off-diagonal entries of the pair add to the diagonal.
      values[entries[3 + k]] +=
          (entries[k] == entries[next_k] ? 2. : 1.) * dot(flow[k], hat_gradient[next_k]);
    }
  }
}

void Laplacian::pin(Sparse_matrix& matrix, const std::vector<bool>& is_definite) const
{
  double* const values = matrix.valuePtr();
  for(std::size_t i = 0; i < m_pinned.size(); ++i)
    if(i >= is_definite.size() || !is_definite[i])
      values[m_pinned[i]] = values[m_pinned[i]] > 0. ? 2. * values[m_pinned[i]] : 1.;
}

} // namespace CGAL::Geodesic_processing::internal
