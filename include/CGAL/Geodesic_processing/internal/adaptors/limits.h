// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_LIMITS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_LIMITS_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/adaptors/number_of_threads.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

template <typename T>
inline constexpr bool is_optional = false;
template <typename T>
inline constexpr bool is_optional<std::optional<T>> = true;

// Returns whether a map is given: an empty optional stands for no map.
template <typename PropertyMap>
bool is_given(const PropertyMap& map)
{
  if constexpr(is_optional<PropertyMap>)
    return map.has_value();
  else
    return true;
}

// #triangles: 1 / speed of each triangle; null if the speed is 1 everywhere.
using Shared_slowness = std::shared_ptr<const std::vector<double>>;

inline Shared_slowness shared_slowness(std::vector<double> values)
{
  if(std::all_of(values.begin(), values.end(), [](double value) { return value == 1.; }))
    return nullptr;
  return std::make_shared<const std::vector<double>>(std::move(values));
}

// Reads the speeds of vertices or surfels. An empty optional stands for no map.
template <typename Domain, typename SpeedMap>
Shared_slowness vertex_slowness(const Domain& domain, const SpeedMap& speed)
{
  static_assert(is_keyed_by<SpeedMap, typename Domain::Vertex>,
                "speed_map is a property map with vertices or surfels as keys. Pass speeds of "
                "faces as face_speed_map. CGAL::make_property_map() makes a map of a vector.");
  return shared_slowness(domain.slowness(speed));
}
template <typename Domain, typename SpeedMap>
Shared_slowness vertex_slowness(const Domain& domain, const std::optional<SpeedMap>& speed)
{
  return speed ? vertex_slowness(domain, *speed) : nullptr;
}

// Reads the speeds of faces. An empty optional stands for no map.
template <typename Domain, typename FaceSpeedMap>
Shared_slowness face_slowness(const Domain& domain, const FaceSpeedMap& speed)
{
  using Surface = typename Domain::Surface;
  static_assert(!Is_cloud<Surface>::value,
                "A cloud has no faces; pass speeds of surfels as speed_map.");
  static_assert(is_keyed_by<FaceSpeedMap, typename boost::graph_traits<Surface>::face_descriptor>,
                "face_speed_map is a property map with faces as keys. Pass speeds of vertices as "
                "speed_map. CGAL::make_property_map() makes a map of a vector.");
  return shared_slowness(domain.face_slowness(speed));
}

template <typename Domain, typename FaceSpeedMap>
Shared_slowness face_slowness(const Domain& domain, const std::optional<FaceSpeedMap>& speed)
{
  return speed ? face_slowness(domain, *speed) : nullptr;
}

// Reads the named parameter `speed_map` or `face_speed_map`. Both can be passed as optionals if at
// most one of them has a value.
template <typename Domain, typename NamedParameters>
Shared_slowness read_slowness(const Domain& domain, const NamedParameters& np)
{
  constexpr bool at_vertices = has_parameter<NamedParameters, internal_np::speed_map_t>;
  constexpr bool in_faces = has_parameter<NamedParameters, internal_np::face_speed_map_t>;
  if constexpr(at_vertices && in_faces)
  {
    auto vertex_speed = parameter(np, internal_np::speed_map, none);
    auto face_speed = parameter(np, internal_np::face_speed_map, none);
    static_assert(is_optional<decltype(vertex_speed)> && is_optional<decltype(face_speed)>,
                  "Pass speed_map or face_speed_map, not both.");
    return face_speed ? face_slowness(domain, face_speed) : vertex_slowness(domain, vertex_speed);
  }
  else if constexpr(at_vertices)
    return vertex_slowness(domain, parameter(np, internal_np::speed_map, none));
  else if constexpr(in_faces)
    return face_slowness(domain, parameter(np, internal_np::face_speed_map, none));
  else
    return nullptr;
}

// Reads the named parameter `heat_time_step`; empty if it is not given or an empty optional. Throws
// Invalid_argument_error if it is not positive or not finite.
template <typename NamedParameters>
std::optional<double> read_heat_time_step(const NamedParameters& np)
{
  std::optional<double> result;
  if constexpr(has_parameter<NamedParameters, internal_np::heat_time_step_t>)
  {
    result = parameter(np, internal_np::heat_time_step, 1.);
    if(result && !(*result > 0. && *result < infinity))
      throw Invalid_argument_error("The time step of the heat method is not positive and finite.");
  }
  return result;
}

// Converts the named parameters of a distance query (maximum distance, callback, targets, speeds,
// relative tolerance) to the limits of a front, in scaled units. Throws Invalid_argument_error
// if the maximum distance or the tolerance is negative or not a number.
template <typename Domain, typename NamedParameters>
Front_limits limits(const Domain& domain, const NamedParameters& np)
{
  Front_limits result;
  const double maximum = parameter(np, internal_np::maximum_distance, infinity);
  if(!(maximum >= 0.))
    throw Invalid_argument_error("The maximum distance is negative or not a number.");
  result.maximum_distance = maximum / domain.triangles()->scale;
  result.relative_tolerance = parameter(np, internal_np::relative_tolerance, 0.);
  if(!(result.relative_tolerance >= 0.))
    throw Invalid_argument_error("The relative tolerance is negative or not a number.");
  result.callback = read_callback(np);
  if constexpr(has_parameter<NamedParameters, internal_np::targets_t>)
    result.targets = locations(domain, parameter(np, internal_np::targets, none));
  result.slowness = read_slowness(domain, np);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_LIMITS_H
