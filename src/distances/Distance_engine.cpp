// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "distances/obstacles.h"

#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Kernel = std::variant<Front, Window_propagation, Heat_solver>;

Kernel make_kernel(Distance_method method, std::shared_ptr<const Surface_arrays> triangles,
                   const std::optional<double>& heat_time_step = {},
                   const std::function<bool(double)>& callback = {})
{
  if(heat_time_step && method != Distance_method::heat)
    throw Unsupported_surface_error("A time step requires the method Heat.");
  if(method == Distance_method::exact && triangles->is_cloud())
    throw Unsupported_surface_error(
        "Exact distances need a mesh, because the triangles of a cloud are not connected.");
  if(method == Distance_method::automatic)
    method = triangles->is_cloud() ? Distance_method::euclidean_front : Distance_method::exact;
  switch(method)
  {
  case Distance_method::dijkstra:
    return Front(std::move(triangles), Front_kind::dijkstra);
  case Distance_method::fast_marching:
    return Front(std::move(triangles), Front_kind::planar);
  case Distance_method::exact:
    return Kernel(std::in_place_type<Window_propagation>, std::move(triangles));
  case Distance_method::heat:
    return Kernel(std::in_place_type<Heat_solver>, std::move(triangles),
                  heat_time_step.value_or(1.), callback);
  default:
    return Front(std::move(triangles), Front_kind::euclidean, Bisected_edges::long_edges);
  }
}

} // namespace

Front_kind front_kind(Distance_method method)
{
  switch(method)
  {
  case Distance_method::dijkstra:
    return Front_kind::dijkstra;
  case Distance_method::fast_marching:
    return Front_kind::planar;
  case Distance_method::euclidean_front:
  case Distance_method::automatic:
    return Front_kind::euclidean;
  default:
    throw Invalid_argument_error(
        "The method must be a front: Euclidean_front, Fast_marching or Dijkstra.");
  }
}

Distance_engine::Distance_engine(Distance_method method,
                                 std::shared_ptr<const Surface_arrays> triangles,
                                 std::optional<double> heat_time_step,
                                 const std::function<bool(double)>& callback)
    : m_method(method), m_triangles(std::move(triangles)),
      m_kernel(make_kernel(method, m_triangles, heat_time_step, callback))
{}

void Distance_engine::select(const Front_limits& limits)
{
  bool is_exact = windows() != nullptr;
  if(m_method == Distance_method::automatic && !m_triangles->is_cloud())
    is_exact = !limits.slowness || uniform_slowness(*limits.slowness);
  // All exceptions are thrown before the kernel changes, so that the last result remains.
  if(limits.relative_tolerance > 0. && !is_exact)
    throw Unsupported_surface_error("A relative tolerance requires the method Exact.");
  if(is_exact)
    Window_propagation::check_speeds(limits);
  else if(std::holds_alternative<Heat_solver>(m_kernel))
    Heat_solver::check_speeds(limits);
  if(is_exact != (windows() != nullptr))
    m_kernel = make_kernel(is_exact ? Distance_method::exact : Distance_method::euclidean_front,
                           m_triangles);
}

bool Distance_engine::run(const std::vector<Front_source>& sources, const Front_limits& limits)
{
  select(limits);
  m_slowness = constant_slowness(limits.slowness.get()) ? nullptr : limits.slowness;
  return std::visit([&](auto& kernel) { return kernel.run(sources, limits); }, m_kernel);
}

double Distance_engine::distance(Index vertex) const
{
  return std::visit([vertex](const auto& kernel) { return kernel.distance(vertex); }, m_kernel);
}

double Distance_engine::distance(const Surface_location& location) const
{
  return std::visit([&](const auto& kernel) { return kernel.distance(location); }, m_kernel);
}

std::vector<double> Distance_engine::distances(const std::vector<Surface_location>& locations) const
{
  if(const Window_propagation* exact = windows())
    return exact->distances(locations);
  std::vector<double> result;
  for(const Surface_location& location : locations)
    result.push_back(distance(location));
  return result;
}

Index Distance_engine::source(Index vertex) const
{
  return std::visit([vertex](const auto& kernel) { return kernel.source(vertex); }, m_kernel);
}

Index Distance_engine::predecessor(Index vertex) const
{
  return std::visit([vertex](const auto& kernel) { return kernel.predecessor(vertex); }, m_kernel);
}

const std::vector<Index>& Distance_engine::reached() const
{
  return std::visit(
      [](const auto& kernel) -> const std::vector<Index>& { return kernel.reached(); }, m_kernel);
}

Row_engine Distance_engine::row_engine() const
{
  return std::visit([](const auto& kernel) { return Row_engine(&kernel); }, m_kernel);
}

} // namespace CGAL::Geodesic_processing::internal
