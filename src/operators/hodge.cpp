// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/hodge.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

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
  result.gradient =
      gradient(m_operators, m_vertex_solver.solve(minus_divergence(m_operators, field)));
  result.rotation = rotated_left(
      gradient(m_edge_operators,
               m_edge_solver.solve(minus_divergence(m_edge_operators, rotated_right(field)))));
  result.harmonic = field;
  for(std::size_t f = 0; f < field.size(); ++f)
    result.harmonic[f] = field[f] - result.gradient[f] - result.rotation[f];
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
        if(cloud.graph.length[i] == 0. && has_triangles(cloud.graph.target[i]))
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
  const Field gradient_field = gradient(o, Poisson_solver(o).solve(minus_divergence(o, planar)));

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
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
