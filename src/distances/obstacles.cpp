// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/obstacles.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include "distances/Window_propagator.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Removes corners from the rings.
template <typename Predicate>
void remove_corners(Surface_arrays& t, const Predicate& is_removed)
{
  Index end = 0;
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
  {
    const Index begin = t.ring_begin[vertex];
    t.ring_begin[vertex] = end;
    for(Index i = begin; i < t.ring_begin[vertex + 1]; ++i)
      if(!is_removed(t.ring[i]))
        t.ring[end++] = t.ring[i];
  }
  t.ring_begin.back() = end;
  t.ring.resize(end);
}

} // namespace

std::optional<double> uniform_slowness(const std::vector<double>& slowness)
{
  std::optional<double> result;
  for(const double value : slowness)
    if(value < infinity)
    {
      if(result && std::abs(value - *result) > round_off_tolerance * *result)
        return std::nullopt;
      result = result.value_or(value);
    }
  return result.value_or(1.);
}

std::optional<double> constant_slowness(const std::vector<double>* slowness)
{
  if(!slowness || slowness->empty())
    return 1.;
  const double value = slowness->front();
  const bool is_constant =
      value < infinity && std::adjacent_find(slowness->begin(), slowness->end(),
                                             std::not_equal_to<>()) == slowness->end();
  return is_constant ? std::optional(value) : std::nullopt;
}

std::shared_ptr<const Surface_arrays> without_obstacles(const Surface_arrays& mesh,
                                                        const std::vector<double>& slowness)
{
  const auto is_obstacle = [&](Index halfedge_or_corner)
  { return slowness[halfedge_or_corner / 3] == infinity; };
  auto result = std::make_shared<Surface_arrays>();
  result->corner = mesh.corner;
  result->twin = mesh.twin;
  result->length = mesh.length;
  result->point = mesh.point;
  result->scale = mesh.scale;
  result->origin = mesh.origin;
  for(Index h = 0; h < mesh.corner.size(); ++h)
  {
    if(is_obstacle(h))
      result->length[h] = 0.;
    if(is_obstacle(h) || (mesh.twin[h] != none && is_obstacle(mesh.twin[h])))
      result->twin[h] = none;
  }
  build_rings(*result, mesh.number_of_vertices());
  remove_corners(*result, is_obstacle);
  return result;
}

Surface_location outside_obstacles(const Surface_arrays& mesh, const Surface_arrays& copy,
                                   const Surface_location& location)
{
  if(const Index vertex = vertex_of(mesh, location); vertex != none)
    return vertex_location(copy, vertex);
  for(const Index triangle : triangles_at(mesh, location))
    if(copy.length[3 * triangle] > 0.)
      return {triangle, none, *barycentric_in(mesh, triangle, location)};
  return location;
}

} // namespace CGAL::Geodesic_processing::internal
