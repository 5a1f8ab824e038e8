// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/continuous_flow.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "operators/harmonic_fields.h"
#include <CGAL/Geodesic_processing/internal/transport/admm.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The fans of triangles around each vertex. A nonmanifold vertex has several fans: mass can pass
// through it, but functions need not be continuous there.
struct Fans
{
  std::vector<Index> fan_of_corner; // 3 #triangles: the fan of each corner
  Index number_of_fans = 0;
};

Fans fans(const Surface_arrays& t)
{
  Fans result;
  result.fan_of_corner.assign(t.corner.size(), none);
  for(Index corner = 0; corner < t.corner.size(); ++corner)
  {
    if(result.fan_of_corner[corner] != none)
      continue;
    const Index fan = result.number_of_fans++;
    for(Index c = corner; c != none && result.fan_of_corner[c] == none; c = next_corner_ccw(t, c))
      result.fan_of_corner[c] = fan;
    for(Index c = next_corner_cw(t, corner); c != none && result.fan_of_corner[c] == none;
        c = next_corner_cw(t, c))
      result.fan_of_corner[c] = fan;
  }
  return result;
}

Index root(std::vector<Index>& parent, Index i)
{
  while(parent[i] != i)
    i = parent[i] = parent[parent[i]];
  return i;
}

// Computes operators for functions with one value per fan. All fans of one boundary loop share a
// value, because nothing flows through the boundary.
Operators fan_operators(const Surface_arrays& t, Operators operators, const Fans& fans)
{
  std::vector<Index> parent(fans.number_of_fans);
  std::iota(parent.begin(), parent.end(), Index(0));
  for(Index h = 0; h < t.corner.size(); ++h)
    if(t.twin[h] == none)
    {
      const Index a = root(parent, fans.fan_of_corner[h]);
      const Index b = root(parent, fans.fan_of_corner[next_halfedge(h)]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  operators.number_of_vertices = fans.number_of_fans;
  for(std::size_t corner = 0; corner < t.corner.size(); ++corner)
    operators.corner[corner] = root(parent, fans.fan_of_corner[corner]);
  return operators;
}

// Returns the square of a symmetric tensor.
Metric_tensor squared(const Metric_tensor& a)
{
  return {a[0] * a[0] + a[1] * a[1], a[1] * (a[0] + a[2]), a[1] * a[1] + a[2] * a[2]};
}

// Each field takes one solution. On a surface with more handles, a circulation around one of them
// hardly reduces the cost.
constexpr std::size_t max_number_of_circulations = 32;

// Returns rotated harmonic fields, the circulations around handles. They are orthogonal to the
// rotated gradients of all functions. The result is empty if the mesh has a boundary or too many
// handles.
std::vector<Field> circulations(const Surface_arrays& t, const Operators& operators)
{
  const std::size_t dimension = number_of_harmonic_fields(t);
  if(dimension == 0 || dimension > max_number_of_circulations ||
     std::find(t.twin.begin(), t.twin.end(), none) != t.twin.end())
    return {};
  std::vector<Field> result =
      harmonic_fields(t, operators, Poisson_solver(operators, Elimination_order::low_fill));
  for(Field& field : result)
    field = rotated_left(std::move(field));
  return result;
}

// The space of divergence-free flows over which the cost is minimized: rotated gradients of
// functions of the fans, and circulations.
class Solenoidal_space
{
public:
  // The coefficients of one field of the space.
  struct Coefficients
  {
    Vector stream_function;          // #fans
    std::vector<double> circulation; // #circulations
  };

  Solenoidal_space(const Surface_arrays& triangles, const Operators& operators,
                   const std::vector<Metric_tensor>& metric, const Fans& fans)
      : m_triangles(triangles), m_operators(operators), m_metric(metric),
        m_fan_operators(fan_operators(triangles, operators, fans)),
        m_solver(m_fan_operators, stream_function_tensors(), Elimination_order::low_fill),
        // With a metric, circulations are not orthogonal to rotated gradients. They are left out.
        m_circulations(metric.empty() ? circulations(triangles, operators) : std::vector<Field>())
  {}

  // Computes the orthogonal projection of a field A J onto the space, where A is the metric.
  Coefficients project(const Field& field) const
  {
    Coefficients result;
    result.stream_function =
        m_solver.solve(minus_divergence(m_fan_operators, rotated_right(apply_metric(field))));
    for(const Field& circulation : m_circulations)
      result.circulation.push_back(inner_product(m_operators, field, circulation));
    return result;
  }

  // Returns A J, where A is the metric and J the flow with these coefficients.
  Field field(const Coefficients& coefficients) const
  {
    Field result =
        apply_metric(rotated_left(gradient(m_fan_operators, coefficients.stream_function)));
    for(std::size_t i = 0; i < m_circulations.size(); ++i)
      for(std::size_t f = 0; f < result.size(); ++f)
        result[f] = result[f] + coefficients.circulation[i] * m_circulations[i][f];
    return result;
  }

  // Adds the flux of a flow with these coefficients out of each triangle: #halfedges values.
  void add_flux(const Coefficients& coefficients, std::vector<double>& outward_flux) const
  {
    const Vector& function = coefficients.stream_function;
    for(Index h = 0; h < outward_flux.size(); ++h)
      outward_flux[h] -=
          function[m_fan_operators.corner[next_halfedge(h)]] - function[m_fan_operators.corner[h]];
    for(std::size_t i = 0; i < m_circulations.size(); ++i)
      for(Index h = 0; h < outward_flux.size(); ++h)
      {
        const auto p = unfolded(m_triangles, h / 3);
        outward_flux[h] += coefficients.circulation[i] * cross(p[next_halfedge(h) % 3] - p[h % 3],
                                                               -1. * m_circulations[i][h / 3]);
      }
  }

private:
  // Returns A J for a field J, where A is the metric.
  Field apply_metric(Field field) const
  {
    if(!m_metric.empty())
      for(std::size_t f = 0; f < field.size(); ++f)
        field[f] = product(m_metric[f], field[f]);
    return field;
  }

  // Returns the tensors K for which the Laplacian of a stream function is the integrated curl of
  // its flow in the metric.
  std::vector<Metric_tensor> stream_function_tensors() const
  {
    std::vector<Metric_tensor> result(m_operators.number_of_triangles(), Metric_tensor{1., 0., 1.});
    for(std::size_t f = 0; f < m_metric.size(); ++f)
    {
      const Metric_tensor s = squared(m_metric[f]);
      result[f] = {s[2], -s[1], s[0]}; // rotated by 90 degrees
    }
    return result;
  }

  const Surface_arrays& m_triangles;
  const Operators& m_operators;
  const std::vector<Metric_tensor>& m_metric;
  Operators m_fan_operators;
  Poisson_solver m_solver;
  std::vector<Field> m_circulations;
};

// Computes the fluxes through all edges, and their cost.
class Flux_field
{
public:
  Flux_field(const Surface_arrays& triangles, const Operators& operators, const Field& flow,
             const std::vector<Metric_tensor>& metric)
      : m_triangles(triangles), m_operators(operators), m_metric(metric), m_fans(fans(triangles)),
        m_absorbed_mass(triangles.number_of_triangles(), 0.),
        m_outward_flux(triangles.corner.size(), 0.)
  {
    spread_masses(flow);
    equilibrate(flow);
    minimize_cost();
  }

  Continuous_flow flow() const { return {m_outward_flux, m_absorbed_mass, cost()}; }

private:
  double cost() const
  {
    double result = m_spreading_cost;
    for(Index f = 0; f < m_absorbed_mass.size(); ++f)
      result += cost(f);
    return result;
  }

  std::array<Vec2, 3> unfolded_corners(Index f) const
  {
    auto result = unfolded(m_triangles, f);
    if(!m_metric.empty())
      for(Vec2& p : result)
        p = product(m_metric[f], p);
    return result;
  }

  // Spreads the mass of each fan uniformly over its triangles. Since distance is convex, its mean
  // over a triangle is at most its mean over the three corners. This bounds the cost of spreading.
  void spread_masses(const Field& flow)
  {
    std::vector<double> mass(m_fans.number_of_fans, 0.), area(m_fans.number_of_fans, 0.),
        count(m_fans.number_of_fans, 0.);
    for(std::size_t corner = 0; corner < m_outward_flux.size(); ++corner)
    {
      const std::size_t f = corner / 3;
      const Index fan = m_fans.fan_of_corner[corner];
      mass[fan] += m_operators.area[f] * dot(flow[f], m_operators.hat_gradient[corner]);
      area[fan] += m_operators.area[f];
      ++count[fan];
    }
    for(Index corner = 0; corner < m_outward_flux.size(); ++corner)
    {
      const Index f = corner / 3, fan = m_fans.fan_of_corner[corner];
      const double fraction = area[fan] > 0. ? m_operators.area[f] / area[fan] : 1. / count[fan];
      const auto p = unfolded_corners(f);
      m_absorbed_mass[f] += fraction * mass[fan];
      m_spreading_cost += fraction * std::abs(mass[fan]) *
                          (norm(p[next_halfedge(corner) % 3] - p[corner % 3]) +
                           norm(p[previous_halfedge(corner) % 3] - p[corner % 3])) /
                          3.;
    }
  }

  // Computes the flux through each edge. It is the mean of the values in both triangles, plus a
  // correction after which each triangle retains its absorbed mass. The sum of the squared
  // corrections is minimal.
  void equilibrate(const Field& flow)
  {
    const Index n = Index(m_absorbed_mass.size());
    Vector rhs(n);
    for(Index f = 0; f < n; ++f)
      rhs[f] = -m_absorbed_mass[f];
    const auto add = [&](Index h, double amount)
    {
      m_outward_flux[h] += amount;
      m_outward_flux[m_triangles.twin[h]] -= amount;
      rhs[h / 3] -= amount;
      rhs[m_triangles.twin[h] / 3] += amount;
    };
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<Index> parent(n);
    std::iota(parent.begin(), parent.end(), Index(0));
    for(Index h = 0; h < m_outward_flux.size(); ++h)
      if(const Index twin = m_triangles.twin[h]; twin != none)
      {
        // Twice the area times the gradient of a hat function is the inward normal of the opposite
        // edge, multiplied by its length.
        const Index opposite = previous_halfedge(h);
        const double flux =
            -2. * m_operators.area[h / 3] * dot(flow[h / 3], m_operators.hat_gradient[opposite]);
        add(h, 0.5 * flux);
        const Index f = h / 3, g = twin / 3;
        if(f == g)
          continue;
        entries.emplace_back(f, f, 1.);
        entries.emplace_back(std::max(f, g), std::min(f, g), -0.5);
        const Index a = root(parent, f), b = root(parent, g);
        parent[std::max(a, b)] = std::min(a, b);
      }
    for(Index f = 0; f < n; ++f)
      if(parent[f] == f)
        entries.emplace_back(f, f, 1.); // pins one triangle of each component
    Sparse_matrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Vector pressure = Sparse_solver(matrix).solve(rhs);
    for(Index h = 0; h < m_outward_flux.size(); ++h)
      if(const Index twin = m_triangles.twin[h]; twin != none)
        m_outward_flux[h] += pressure[h / 3] - pressure[twin / 3];
  }

  // Minimizes the cost by ADMM over the divergence-free fields. The result is used only if it has a
  // smaller cost.
  void minimize_cost()
  {
    const Solenoidal_space space(m_triangles, m_operators, m_metric, m_fans);
    const Field centroid_flow = this->centroid_flow();
    const auto deviation = [&](Field field)
    {
      for(std::size_t f = 0; f < field.size(); ++f)
        field[f] = field[f] - centroid_flow[f];
      return field;
    };
    Admm admm(m_operators,
              [&](const Field& field)
              {
                Field result = space.field(space.project(deviation(field)));
                for(std::size_t f = 0; f < result.size(); ++f)
                  result[f] = centroid_flow[f] + result[f];
                return result;
              });
    // Stop if ten iterations reduce the cost by less than 0.05 %.
    for(unsigned i = 0; i < 30; ++i)
    {
      const double previous_cost = admm.upper();
      admm.advance(10);
      if(i > 2 && admm.upper() > 0.9995 * previous_cost)
        break;
    }
    const double previous_cost = cost();
    std::vector<double> outward_flux = m_outward_flux;
    space.add_flux(space.project(deviation(admm.flow())), m_outward_flux);
    if(cost() > previous_cost)
      m_outward_flux = std::move(outward_flux);
  }

  // Returns the flow A J at the centroid of each triangle: #triangles vectors. It is 0 if the area
  // is 0.
  Field centroid_flow() const
  {
    Field result(m_absorbed_mass.size(), Vec2{0., 0.});
    for(Index f = 0; f < result.size(); ++f)
    {
      if(!(m_operators.area[f] > 0.))
        continue;
      const auto p = unfolded_corners(f);
      Vec2 sum = {0., 0.};
      for(Index k = 0; k < 3; ++k)
        sum = sum + m_outward_flux[3 * f + k] * ((p[k] + p[(k + 1) % 3]) - 2. * p[(k + 2) % 3]);
      result[f] = (1. / (6. * m_operators.area[f])) * sum;
    }
    return result;
  }

  // Returns an upper bound of the cost of triangle f. The flow is linear there and length is
  // convex, so that its mean is at most the mean at the corners.
  double cost(Index f) const
  {
    const auto p = unfolded_corners(f);
    double result = 0.;
    for(Index j = 0; j < 3; ++j)
    {
      Vec2 sum = {0., 0.};
      for(Index k = 0; k < 3; ++k)
        sum = sum + m_outward_flux[3 * f + (k + 1) % 3] * (p[j] - p[k]);
      result += norm(sum) / 6.;
    }
    return result;
  }

  const Surface_arrays& m_triangles;
  const Operators& m_operators;
  const std::vector<Metric_tensor>& m_metric;
  Fans m_fans;
  std::vector<double> m_absorbed_mass; // #triangles: mass that must remain in the triangle
  std::vector<double> m_outward_flux;  // #halfedges
  double m_spreading_cost = 0.;
};

} // namespace

Continuous_flow continuous_flow(const Surface_arrays& triangles, const Operators& operators,
                                const Field& flow, const std::vector<Metric_tensor>& metric)
{
  if(triangles.is_cloud())
    throw Unsupported_surface_error(
        "Continuous flows need a mesh: a cloud has no halfedges with twins.");
  return Flux_field(triangles, operators, flow, metric).flow();
}

} // namespace CGAL::Geodesic_processing::internal
