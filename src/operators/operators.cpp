// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include "core/unfold.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Operators operators(const Glued_triangles& triangles, Flat_triangles flat)
{
  Operators result;
  const std::size_t n = triangles.number_of_triangles();
  result.corner = triangles.corner;
  result.number_of_sites = triangles.number_of_sites();
  result.area.assign(n, 0.);
  result.hat.assign(3 * n, Planar{0., 0.});
  for(std::size_t f = 0; f < n; ++f)
  {
    const double* length = &triangles.length[3 * f];
    double twice = twice_area(length[0], length[1], length[2]);
    const auto [shortest, longest] = std::minmax({length[0], length[1], length[2]});
    auto place = unfolded(triangles, Index(f));
    if(const double least = 1e-7 * shortest * longest; !(twice > least))
    {
      if(flat == Flat_triangles::left_out || !(least > 0.))
        continue;
      twice = least;
      place[2][1] = twice / length[0];
    }
    result.area[f] = 0.5 * twice * (triangles.weight.empty() ? 1. : triangles.weight[f]);
    for(std::size_t k = 0; k < 3; ++k)
      result.hat[3 * f + k] = (1. / twice) * turned_left(place[(k + 2) % 3] - place[(k + 1) % 3]);
  }
  return result;
}

Operators measured_operators(const Glued_triangles& t, const std::vector<Tensor>& measure)
{
  Operators result = operators(t, Flat_triangles::raised);
  for(std::size_t f = 0; f < measure.size(); ++f)
  {
    const bool blocked = is_blocked(measure[f]);
    if(blocked)
      result.area[f] = 0.;
    for(std::size_t corner = 3 * f; corner < 3 * f + 3; ++corner)
      result.hat[corner] =
          blocked ? Planar{0., 0.} : product(inverse(measure[f]), result.hat[corner]);
  }
  return result;
}

void gradient(const Operators& operators, const Vector& function, Field& result)
{
  result.resize(operators.number_of_triangles());
  for(std::size_t f = 0; f < result.size(); ++f)
  {
    const Index* corner = &operators.corner[3 * f];
    const Planar* hat = &operators.hat[3 * f];
    const double first = function[corner[0]];
    result[f] = (function[corner[1]] - first) * hat[1] + (function[corner[2]] - first) * hat[2];
  }
}

Field gradient(const Operators& operators, const Vector& function)
{
  Field result;
  gradient(operators, function, result);
  return result;
}

Vector divergence(const Operators& operators, const Field& field)
{
  Vector result = Vector::Zero(Eigen::Index(operators.number_of_sites));
  for(std::size_t f = 0; f < field.size(); ++f)
  {
    const Planar flow = operators.area[f] * field[f];
    for(std::size_t k = 0; k < 3; ++k)
      result[operators.corner[3 * f + k]] += dot(flow, operators.hat[3 * f + k]);
  }
  return result;
}

Field turned_left(Field field)
{
  for(Planar& vector : field)
    vector = turned_left(vector);
  return field;
}

double inner_product(const Operators& operators, const Field& a, const Field& b)
{
  double result = 0.;
  for(std::size_t f = 0; f < a.size(); ++f)
    result += operators.area[f] * dot(a[f], b[f]);
  return result;
}

Vector lumped_mass(const Operators& operators)
{
  Vector result = Vector::Zero(Eigen::Index(operators.number_of_sites));
  for(std::size_t c = 0; c < operators.corner.size(); ++c)
    result[operators.corner[c]] += operators.area[c / 3] / 3.;
  return result;
}

Vector mean_lengths(const Glued_triangles& triangles, const Field& field)
{
  const Operators o = operators(triangles);
  Vector sum = Vector::Zero(Eigen::Index(o.number_of_sites)), area = sum;
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
  std::vector<Index> parent(operators.number_of_sites);
  std::iota(parent.begin(), parent.end(), Index(0));
  const auto root = [&](Index site)
  {
    while(parent[site] != site)
      site = parent[site] = parent[parent[site]];
    return site;
  };
  for(std::size_t c = 0; c < operators.corner.size(); ++c)
    if(operators.area[c / 3] > 0.)
    {
      const Index a = root(operators.corner[c]), b = root(operators.corner[c - c % 3]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  std::vector<Index> label(parent.size());
  std::size_t count = 0;
  for(Index site = 0; site < parent.size(); ++site) // roots come first
    label[site] = parent[site] == site ? Index(count++) : label[root(site)];
  return {std::move(label), count};
}

Laplacian::Laplacian(const Operators& operators)
{
  const auto n = Eigen::Index(operators.number_of_sites);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(operators.corner.size() + operators.number_of_sites);
  for(Eigen::Index site = 0; site < n; ++site)
    entries.emplace_back(site, site, 0.);
  for(Index side = 0; side < operators.corner.size(); ++side)
  {
    const Index a = operators.corner[side], b = operators.corner[next_side(side)];
    entries.emplace_back(std::max(a, b), std::min(a, b), 0.);
  }
  m_pattern.resize(n, n);
  m_pattern.setFromTriplets(entries.begin(), entries.end());

  const int* row = m_pattern.innerIndexPtr();
  const int* column = m_pattern.outerIndexPtr();
  const auto place = [&](Index a, Index b)
  {
    const Index low = std::min(a, b), high = std::max(a, b);
    return Index(std::lower_bound(row + column[low], row + column[low + 1], int(high)) - row);
  };
  m_place.resize(operators.number_of_triangles());
  for(std::size_t f = 0; f < m_place.size(); ++f)
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Index a = operators.corner[3 * f + k], b = operators.corner[3 * f + (k + 1) % 3];
      m_place[f][k] = place(a, a);
      m_place[f][3 + k] = place(a, b);
    }

  const auto [component, number] = components(operators);
  m_held.assign(number, none);
  for(Index site = 0; site < component.size(); ++site)
    if(m_held[component[site]] == none)
      m_held[component[site]] = place(site, site);
}

Sparse_matrix Laplacian::matrix(const Operators& operators) const
{
  Sparse_matrix result = m_pattern;
  assemble(operators, std::vector<Tensor>(m_place.size(), Tensor{1., 0., 1.}), result);
  return result;
}

void Laplacian::assemble(const Operators& operators, const std::vector<Tensor>& tensors,
                         Sparse_matrix& matrix) const
{
  double* const entry = matrix.valuePtr();
  std::fill_n(entry, matrix.nonZeros(), 0.);
  for(std::size_t f = 0; f < m_place.size(); ++f)
  {
    const Tensor& tensor = tensors[f];
    const Planar* hat = &operators.hat[3 * f];
    std::array<Planar, 3> flow;
    for(std::size_t k = 0; k < 3; ++k)
      flow[k] = operators.area[f] * product(tensor, hat[k]);
    const auto& place = m_place[f];
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t next = (k + 1) % 3;
      entry[place[k]] += dot(flow[k], hat[k]);
      // Both orders of a pair meet on the diagonal where a side ends at the site that it leaves.
      entry[place[3 + k]] += (place[k] == place[next] ? 2. : 1.) * dot(flow[k], hat[next]);
    }
  }
}

void Laplacian::hold(Sparse_matrix& matrix, const std::vector<bool>& is_definite) const
{
  double* const entry = matrix.valuePtr();
  for(std::size_t i = 0; i < m_held.size(); ++i)
    if(i >= is_definite.size() || !is_definite[i])
      entry[m_held[i]] = entry[m_held[i]] > 0. ? 2. * entry[m_held[i]] : 1.;
}

} // namespace CGAL::Geodesic_processing::internal
