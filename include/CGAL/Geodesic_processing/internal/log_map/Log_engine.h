// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_LOG_ENGINE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_LOG_ENGINE_H

#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/log_map/log_map.h>
#include <CGAL/Geodesic_processing/internal/log_map/tangent_plane.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <variant>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Log_map_options
{
  double maximum_distance = infinity;
  double stencil_length = 0.;   // in the scale of the surface arrays; 0: chosen automatically
  std::size_t stencil_size = 8; // number of stencil directions
  // Of Gradient_engine; see smooth_gradients() and refine_around_base().
  std::size_t number_of_smoothing_steps = 0;
  std::size_t number_of_base_refinements = 0;
};

// Receives a vertex and its tangent vector.
using Log_visitor = std::function<void(Index, const Vec2&)>;

// Computes the logarithmic map from gradients of squared distances (see Log_map_fit). The engine of
// the method runs once from the base point and once from each location of a stencil around it.
//
// If the base is refined, these queries run on a mesh whose edges are shorter around the stencil.
// If the map is smoothed, the directions change and the lengths remain the distances.
class CGAL_GEODESIC_PROCESSING_EXPORT Gradient_engine
{
public:
  Gradient_engine(Distance_method method, std::shared_ptr<const Surface_arrays> triangles);

  // Calls visit(vertex, tangent vector) for each vertex up to the maximum distance from the base
  // point.
  void run(const Tangent_plane& plane, const Log_map_options& options, const Log_visitor& visit);

private:
  double stencil_length_ratio(const Tangent_plane& plane) const;
  Stencil make_stencil(const Tangent_plane& plane, const std::vector<Index>& vertices,
                       const std::vector<double>& distances, double length, std::size_t size) const;

  Distance_method m_method;
  std::shared_ptr<const Surface_arrays> m_triangles;
  Distance_engine m_engine;
};

// Computes the logarithmic map on a mesh from the initial directions of exact shortest paths.
class CGAL_GEODESIC_PROCESSING_EXPORT Exact_log_engine
{
public:
  explicit Exact_log_engine(std::shared_ptr<const Surface_arrays> triangles);

  // Calls visit(vertex, tangent vector) for each vertex up to the maximum distance from the base
  // point.
  void run(const Tangent_plane& plane, const Log_map_options& options, const Log_visitor& visit);

private:
  Window_propagation m_windows;
};

// Computes the discrete exponential map (Schmidt, Grimm and Wyvill 2006): sums of transported edge
// vectors along shortest graph paths.
class CGAL_GEODESIC_PROCESSING_EXPORT Discrete_exponential_engine
{
public:
  explicit Discrete_exponential_engine(std::shared_ptr<const Surface_arrays> triangles);

  // Calls visit(vertex, tangent vector) for each vertex up to the maximum distance from the base
  // point.
  void run(const Tangent_plane& plane, const Log_map_options& options, const Log_visitor& visit);

private:
  void accumulate_steps(const Tangent_plane& plane, Index v);

  std::shared_ptr<const Surface_arrays> m_triangles;
  Front m_front;
  std::vector<Vec2> m_vectors; // #vertices; of the last run
};

enum class Log_method
{
  gradient,
  exact,
  discrete_exponential
};

struct Log_kind
{
  Log_method method = Log_method::gradient;
  Distance_method distances = Distance_method::euclidean_front; // that the gradient is taken of
};

// Computes tangent vectors by a method that is chosen at run time.
class CGAL_GEODESIC_PROCESSING_EXPORT Log_engine
{
public:
  Log_engine(const Log_kind& kind, std::shared_ptr<const Surface_arrays> triangles);

  // Throws Invalid_argument_error if an option is out of its range, and Unsupported_surface_error
  // if the method or the surface does not admit it.
  void check(const Log_map_options& options) const;

  // Requires options that pass check().
  void run(const Tangent_plane& plane, const Log_map_options& options, const Log_visitor& visit);

private:
  bool m_is_cloud;
  std::variant<Gradient_engine, Exact_log_engine, Discrete_exponential_engine> m_engine;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_LOG_ENGINE_H
