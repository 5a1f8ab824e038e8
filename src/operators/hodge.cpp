// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/hodge.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "core/edges.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Shifts a potential on each component such that its integral is zero. If `has_boundary` is true,
// index 0 stands for the boundary, and the potential of components with boundary is shifted to zero
// there.
Vector normalized(const Operators& operators, Vector potential, bool has_boundary)
{
  const auto [component, number_of_components] = components(operators);
  const Vector mass = lumped_mass(operators);
  std::vector<double> sum(number_of_components, 0.), total(number_of_components, 0.);
  for(Eigen::Index i = 0; i < potential.size(); ++i)
  {
    sum[component[std::size_t(i)]] += mass[i] * potential[i];
    total[component[std::size_t(i)]] += mass[i];
  }
  if(has_boundary)
  {
    sum[component[0]] = potential[0];
    total[component[0]] = 1.;
  }
  for(Eigen::Index i = 0; i < potential.size(); ++i)
    if(const Index c = component[std::size_t(i)]; total[c] > 0.)
      potential[i] -= sum[c] / total[c];
  return potential;
}

} // namespace

Operators crouzeix_raviart_operators(const Surface_arrays& triangles, const Operators& operators)
{
  if(triangles.is_cloud())
    throw Unsupported_surface_error(
        "Edge operators need a mesh: a cloud has no halfedges with twins.");
  Operators result;
  result.area = operators.area;
  result.corner.resize(operators.corner.size());
  result.hat_gradient.resize(operators.hat_gradient.size());
  result.number_of_vertices = 1; // the boundary
  for(Index h = 0; h < triangles.corner.size(); ++h)
  {
    const Index twin = triangles.twin[h];
    if(twin == none)
      result.corner[h] = 0;
    else
      result.corner[h] = twin < h ? result.corner[twin] : Index(result.number_of_vertices++);
    // The hat function of an edge is 1 minus twice that of the opposite corner.
    result.hat_gradient[h] = -2. * operators.hat_gradient[previous_halfedge(h)];
  }
  return result;
}

Hodge_solver::Hodge_solver(const Surface_arrays& triangles, Operators operators)
    : m_operators(std::move(operators)),
      m_edge_operators(crouzeix_raviart_operators(triangles, m_operators)),
      m_vertex_solver(m_operators), m_edge_solver(m_edge_operators)
{}

Hodge_components Hodge_solver::decompose(const Field& field) const
{
  Hodge_components result;
  Vector potential = m_vertex_solver.solve(minus_divergence(m_operators, field));
  result.gradient = gradient(m_operators, potential);
  result.gradient_potential = normalized(m_operators, std::move(potential), false);
  Vector edge_potential =
      m_edge_solver.solve(minus_divergence(m_edge_operators, rotated_right(field)));
  result.rotation = rotated_left(gradient(m_edge_operators, edge_potential));
  edge_potential = normalized(m_edge_operators, std::move(edge_potential), true);
  for(const Index edge : m_edge_operators.corner)
    result.rotation_potential.push_back(edge_potential[edge]);
  result.harmonic = field;
  for(std::size_t f = 0; f < field.size(); ++f)
    result.harmonic[f] = field[f] - result.gradient[f] - result.rotation[f];
  return result;
}

Vector vertex_rotation_potential(const Surface_arrays& triangles, const Operators& operators,
                                 const Field& field)
{
  if(triangles.is_cloud())
    throw Unsupported_surface_error("Rotations need a mesh: a cloud has no halfedges with twins.");
  std::vector<bool> is_boundary(operators.number_of_vertices, false);
  for(Index h = 0; h < triangles.corner.size(); ++h)
    if(triangles.twin[h] == none)
      is_boundary[triangles.corner[h]] = is_boundary[triangles.corner[next_halfedge(h)]] = true;
  // Index 0 stands for all vertices of the boundary.
  Operators merged = operators;
  std::vector<Index> index(operators.number_of_vertices, 0);
  merged.number_of_vertices = 1;
  for(Index vertex = 0; vertex < index.size(); ++vertex)
    if(!is_boundary[vertex])
      index[vertex] = Index(merged.number_of_vertices++);
  for(Index& corner : merged.corner)
    corner = index[corner];
  const Vector potential = normalized(
      merged, Poisson_solver(merged).solve(minus_divergence(merged, rotated_right(field))), true);
  Vector result(Eigen::Index(index.size()));
  for(Index vertex = 0; vertex < index.size(); ++vertex)
    result[vertex] = potential[index[vertex]];
  return result;
}

namespace {

// Returns for each vertex of a cloud the vertex that represents it. This is the vertex itself, or
// for a copy without triangles the coincident vertex that has triangles.
std::vector<Index> representatives(const Surface_arrays& cloud)
{
  const auto has_triangles = [&](Index vertex)
  { return cloud.ring_begin[vertex] < cloud.ring_begin[vertex + 1]; };
  std::vector<Index> result(cloud.number_of_vertices());
  std::iota(result.begin(), result.end(), Index(0));
  for(Index vertex = 0; vertex < result.size(); ++vertex)
    if(!has_triangles(vertex))
      for(Index i = cloud.graph.begin[vertex]; i < cloud.graph.begin[vertex + 1]; ++i)
        if(graph_edge_length(cloud, vertex, i) == 0. && has_triangles(cloud.graph.target[i]))
          result[vertex] = cloud.graph.target[i];
  return result;
}

Vec3 tangential(const Vec3& vector, const Vec3& normal)
{
  return vector - dot(vector, normal) * normal;
}

// Returns the mean of the field over coincident surfels, for the surfel that represents them.
std::vector<Vec3> mean_of_copies(const std::vector<Index>& representative,
                                 const std::vector<Vec3>& field)
{
  std::vector<Vec3> result(field.size(), Vec3{0., 0., 0.});
  std::vector<double> count(field.size(), 0.);
  for(std::size_t vertex = 0; vertex < field.size(); ++vertex)
  {
    result[representative[vertex]] = result[representative[vertex]] + field[vertex];
    count[representative[vertex]] += 1.;
  }
  for(std::size_t vertex = 0; vertex < field.size(); ++vertex)
    result[vertex] = (1. / std::max(count[vertex], 1.)) * result[vertex];
  return result;
}

} // namespace

Surfel_field_components gradient_and_remainder(const Surface_arrays& cloud, std::vector<Vec3> field)
{
  if(!cloud.is_cloud())
    throw Unsupported_surface_error("Fields of surfels need a cloud: a mesh has no normals.");
  for(std::size_t vertex = 0; vertex < field.size(); ++vertex)
    field[vertex] = tangential(field[vertex], cloud.normal[vertex]);
  const std::vector<Index> representative = representatives(cloud);
  const std::vector<Vec3> mean = mean_of_copies(representative, field);

  const Operators o = operators(cloud);
  Field planar(o.number_of_triangles());
  for(Index f = 0; f < planar.size(); ++f)
  {
    const Index* corner = &o.corner[3 * std::size_t(f)];
    planar[f] =
        in_plane(cloud, f, (1. / 3.) * (mean[corner[0]] + mean[corner[1]] + mean[corner[2]]));
  }
  Vector potential = Poisson_solver(o).solve(minus_divergence(o, planar));
  const Field gradient_field = gradient(o, potential);
  potential = normalized(o, std::move(potential), false);

  Surfel_field_components result;
  std::vector<Vec3> sum(field.size(), Vec3{0., 0., 0.});
  std::vector<double> area(field.size(), 0.);
  for(Index c = 0; c < o.corner.size(); ++c)
  {
    const Index vertex = o.corner[c];
    sum[vertex] = sum[vertex] + o.area[c / 3] * in_space(cloud, c / 3, gradient_field[c / 3]);
    area[vertex] += o.area[c / 3];
  }
  for(std::size_t vertex = 0; vertex < field.size(); ++vertex)
  {
    const Index source = representative[vertex];
    const Vec3 vector = area[source] > 0. ? (1. / area[source]) * sum[source] : Vec3{0., 0., 0.};
    result.gradient.push_back(tangential(vector, cloud.normal[vertex]));
    result.remainder.push_back(field[vertex] - result.gradient[vertex]);
    result.potential.push_back(potential[source]);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
