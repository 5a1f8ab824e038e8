// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/continuous_flow.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "operators/harmonic_fields.h"
#include <CGAL/Geodesic_processing/internal/transport/splitting.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The fans of triangles around sites, more than one where the surface is pinched: through such a site
// masses may go, but no function must be continuous there.
struct Fans
{
  std::vector<Index> of_corner; // 3 #triangles
  Index number = 0;
};

Fans fans(const Glued_triangles& t)
{
  Fans result;
  result.of_corner.assign(t.corner.size(), none);
  for(Index corner = 0; corner < t.corner.size(); ++corner)
  {
    if(result.of_corner[corner] != none)
      continue;
    const Index fan = result.number++;
    for(Index c = corner; c != none && result.of_corner[c] == none; c = turn_left(t, c))
      result.of_corner[c] = fan;
    for(Index c = turn_right(t, corner); c != none && result.of_corner[c] == none;
        c = turn_right(t, c))
      result.of_corner[c] = fan;
  }
  return result;
}

Index root(std::vector<Index>& parent, Index i)
{
  while(parent[i] != i)
    i = parent[i] = parent[parent[i]];
  return i;
}

// A value for each fan, but one for all fans of a border: through a border nothing flows.
Operators operators_of_fans(const Glued_triangles& t, Operators operators, const Fans& fans)
{
  std::vector<Index> parent(fans.number);
  std::iota(parent.begin(), parent.end(), Index(0));
  for(Index side = 0; side < t.corner.size(); ++side)
    if(t.twin[side] == none)
    {
      const Index a = root(parent, fans.of_corner[side]);
      const Index b = root(parent, fans.of_corner[next_side(side)]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  operators.number_of_sites = fans.number;
  for(std::size_t corner = 0; corner < t.corner.size(); ++corner)
    operators.corner[corner] = root(parent, fans.of_corner[corner]);
  return operators;
}

Tensor square(const Tensor& a)
{
  return {a[0] * a[0] + a[1] * a[1], a[1] * (a[0] + a[2]), a[1] * a[1] + a[2] * a[2]};
}

// Each costs a solution; surfaces with so many handles have hardly any way around one that pays.
constexpr std::size_t most_circulations = 32;

// Flows around handles, of a surface without border: harmonic fields turned, orthogonal to all functions'
// turned gradients.
std::vector<Field> circulations(const Glued_triangles& t, const Operators& operators)
{
  const std::size_t number = number_of_harmonic_fields(t);
  if(number == 0 || number > most_circulations ||
     std::find(t.twin.begin(), t.twin.end(), none) != t.twin.end())
    return {};
  const Laplacian laplacian(operators);
  Sparse_matrix matrix = laplacian.matrix(operators);
  laplacian.hold(matrix);
  std::vector<Field> result =
      harmonic_fields(t, operators, Sparse_solver(matrix, Elimination::sparse));
  for(Field& field : result)
    field = turned_left(std::move(field));
  return result;
}

// What flows out of triangles through their sides, and what that costs.
class Side_flow
{
public:
  Side_flow(const Glued_triangles& triangles, const Operators& operators, const Field& flow,
            const std::vector<Tensor>& measure)
      : m_triangles(triangles), m_operators(operators), m_measure(measure), m_fans(fans(triangles)),
        m_missing(triangles.number_of_triangles(), 0.), m_outward(triangles.corner.size(), 0.)
  {
    spread(flow);
    equilibrate(flow);
    shorten();
  }

  Continuous_flow flow() const { return {m_outward, m_missing, cost()}; }

private:
  double cost() const
  {
    double result = m_spreading;
    for(Index f = 0; f < m_missing.size(); ++f)
      result += cost(f);
    return result;
  }

  std::array<Planar, 3> place(Index f) const
  {
    auto result = unfolded(m_triangles, f);
    if(!m_measure.empty())
      for(Planar& p : result)
        p = product(m_measure[f], p);
    return result;
  }

  // The masses at the fans' sites evenly over their triangles.  The mean distance of a triangle's points
  // from a corner is at most a third of that of the two others, as distance is convex.
  void spread(const Field& flow)
  {
    std::vector<double> mass(m_fans.number, 0.), area(m_fans.number, 0.), count(m_fans.number, 0.);
    for(std::size_t corner = 0; corner < m_outward.size(); ++corner)
    {
      const std::size_t f = corner / 3;
      const Index fan = m_fans.of_corner[corner];
      mass[fan] += m_operators.area[f] * dot(flow[f], m_operators.hat[corner]);
      area[fan] += m_operators.area[f];
      ++count[fan];
    }
    for(Index corner = 0; corner < m_outward.size(); ++corner)
    {
      const Index f = corner / 3, fan = m_fans.of_corner[corner];
      const double share = area[fan] > 0. ? m_operators.area[f] / area[fan] : 1. / count[fan];
      const auto p = place(f);
      m_missing[f] += share * mass[fan];
      m_spreading += share * std::abs(mass[fan]) *
                     (norm(p[next_side(corner) % 3] - p[corner % 3]) +
                      norm(p[previous_side(corner) % 3] - p[corner % 3])) /
                     3.;
    }
  }

  // The mean of what both triangles of a side say, and the least change after which all that leaves the
  // one enters the other, and what is missing stays.
  void equilibrate(const Field& flow)
  {
    const Index n = Index(m_missing.size());
    Vector right(n);
    for(Index f = 0; f < n; ++f)
      right[f] = -m_missing[f];
    const auto add = [&](Index side, double amount)
    {
      m_outward[side] += amount;
      m_outward[m_triangles.twin[side]] -= amount;
      right[side / 3] -= amount;
      right[m_triangles.twin[side] / 3] += amount;
    };
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<Index> parent(n);
    std::iota(parent.begin(), parent.end(), Index(0));
    for(Index side = 0; side < m_outward.size(); ++side)
      if(const Index twin = m_triangles.twin[side]; twin != none)
      {
        // Twice the area times a hat's gradient is the side opposite, turned inward.
        const Index opposite = previous_side(side);
        const double out =
            -2. * m_operators.area[side / 3] * dot(flow[side / 3], m_operators.hat[opposite]);
        add(side, 0.5 * out);
        const Index f = side / 3, g = twin / 3;
        if(f == g)
          continue;
        entries.emplace_back(f, f, 1.);
        entries.emplace_back(std::max(f, g), std::min(f, g), -0.5);
        const Index a = root(parent, f), b = root(parent, g);
        parent[std::max(a, b)] = std::min(a, b);
      }
    for(Index f = 0; f < n; ++f)
      if(parent[f] == f)
        entries.emplace_back(f, f, 1.); // holds it
    Sparse_matrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Vector pressure = Sparse_solver(matrix).solve(right);
    for(Index side = 0; side < m_outward.size(); ++side)
      if(const Index twin = m_triangles.twin[side]; twin != none)
        m_outward[side] += pressure[side / 3] - pressure[twin / 3];
  }

  // Adds a function's turned gradient, and what circles around handles: if that makes the flow shorter.
  void shorten()
  {
    const Operators operators = operators_of_fans(m_triangles, m_operators, m_fans);
    std::vector<Tensor> tensors(m_missing.size(), Tensor{1., 0., 1.});
    const auto turned_gradient = [&](const Vector& function)
    {
      Field result = turned_left(gradient(operators, function));
      if(!m_measure.empty())
        for(std::size_t f = 0; f < result.size(); ++f)
          result[f] = product(m_measure[f], result[f]);
      return result;
    };
    const auto rotation = [&](Field field)
    {
      if(!m_measure.empty())
        for(std::size_t f = 0; f < field.size(); ++f)
          field[f] = product(m_measure[f], field[f]);
      return divergence(operators, turned_left(turned_left(turned_left(std::move(field)))));
    };
    if(!m_measure.empty())
      for(std::size_t f = 0; f < tensors.size(); ++f)
      {
        const Tensor s = square(m_measure[f]);
        tensors[f] = {s[2], -s[1], s[0]}; // turned
      }
    const Laplacian laplacian(operators);
    Sparse_matrix matrix = laplacian.matrix(operators);
    laplacian.assemble(operators, tensors, matrix);
    laplacian.hold(matrix);
    const Sparse_solver solver(matrix, Elimination::sparse);

    Field center(m_missing.size());
    for(Index f = 0; f < center.size(); ++f)
      if(m_operators.area[f] > 0.)
      {
        const auto p = place(f);
        Planar sum = {0., 0.};
        for(Index k = 0; k < 3; ++k)
          sum = sum + m_outward[3 * f + k] * ((p[k] + p[(k + 1) % 3]) - 2. * p[(k + 2) % 3]);
        center[f] = (1. / (6. * m_operators.area[f])) * sum;
      }
      else
        center[f] = {0., 0.};
    const auto change_of = [&](Field field)
    {
      for(std::size_t f = 0; f < field.size(); ++f)
        field[f] = field[f] - center[f];
      return field;
    };
    // Of measured lengths they are not orthogonal.
    const std::vector<Field> circling =
        m_measure.empty() ? circulations(m_triangles, m_operators) : std::vector<Field>();
    Splitting splitting(m_operators,
                        [&](const Field& field)
                        {
                          const Field change = change_of(field);
                          Field result = turned_gradient(solver.solve(rotation(change)));
                          for(const Field& circle : circling)
                          {
                            const double part = inner_product(m_operators, change, circle);
                            for(std::size_t f = 0; f < result.size(); ++f)
                              result[f] = result[f] + part * circle[f];
                          }
                          for(std::size_t f = 0; f < result.size(); ++f)
                            result[f] = center[f] + result[f];
                          return result;
                        });
    // Until it is not worth going on.
    for(unsigned i = 0; i < 30; ++i)
    {
      const double before = splitting.upper();
      splitting.advance(10);
      if(i > 2 && splitting.upper() > 0.9995 * before)
        break;
    }
    const double before = cost();
    std::vector<double> outward = m_outward;
    const Field change = change_of(splitting.flow());
    const Vector function = solver.solve(rotation(change));
    for(Index side = 0; side < m_outward.size(); ++side)
      m_outward[side] -=
          function[operators.corner[next_side(side)]] - function[operators.corner[side]];
    for(const Field& circle : circling)
    {
      const double part = inner_product(m_operators, change, circle);
      for(Index side = 0; side < m_outward.size(); ++side)
      {
        const auto p = unfolded(m_triangles, side / 3);
        m_outward[side] +=
            part * cross(p[next_side(side) % 3] - p[side % 3], -1. * circle[side / 3]);
      }
    }
    if(cost() > before)
      m_outward = std::move(outward);
  }

  // Linear in the triangle: length is convex, so that its mean is at most that at the corners.
  double cost(Index f) const
  {
    const auto p = place(f);
    double result = 0.;
    for(Index j = 0; j < 3; ++j)
    {
      Planar sum = {0., 0.};
      for(Index k = 0; k < 3; ++k)
        sum = sum + m_outward[3 * f + (k + 1) % 3] * (p[j] - p[k]);
      result += norm(sum) / 6.;
    }
    return result;
  }

  const Glued_triangles& m_triangles;
  const Operators& m_operators;
  const std::vector<Tensor>& m_measure;
  Fans m_fans;
  std::vector<double> m_missing; // #triangles: what has to stay there
  std::vector<double> m_outward; // #sides
  double m_spreading = 0.;
};

} // namespace

Continuous_flow continuous_flow(const Glued_triangles& triangles, const Operators& operators,
                                const Field& flow, const std::vector<Tensor>& measure)
{
  if(triangles.is_cloud())
    throw Unsupported_surface_error(
        "On a cloud flows are not bounded from above: its triangles are not glued.");
  return Side_flow(triangles, operators, flow, measure).flow();
}

} // namespace CGAL::Geodesic_processing::internal
