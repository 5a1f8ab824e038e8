// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_LIMITS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_LIMITS_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns 1 / speed of each triangle; null for an empty optional, which stands for no map.
template <typename Domain, typename SpeedMap>
std::shared_ptr<const std::vector<double>> slowness(const Domain& domain, const SpeedMap& speed)
{
  return std::make_shared<const std::vector<double>>(domain.slowness(speed));
}
template <typename Domain, typename SpeedMap>
std::shared_ptr<const std::vector<double>> slowness(const Domain& domain,
                                                    const std::optional<SpeedMap>& speed)
{
  return speed ? slowness(domain, *speed) : nullptr;
}

// Converts the named parameters of a distance query (maximum distance, callback, targets, speed
// map, relative tolerance) to the limits of a front, in scaled units.  Throws Invalid_argument_error
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
  result.callback = parameter(np, CGAL::internal_np::callback, std::function<bool(double)>());
  if constexpr(has_parameter<NamedParameters, internal_np::targets_t>)
    result.targets = locations(domain, parameter(np, internal_np::targets, none));
  if constexpr(has_parameter<NamedParameters, internal_np::speed_map_t>)
    result.slowness = slowness(domain, parameter(np, internal_np::speed_map, none));
  return result;
}

// Returns the number of threads: 1 if `Concurrency_tag` is `Sequential_tag`, otherwise the named
// parameter `threads`, by default the number of hardware threads.
template <typename Concurrency_tag, typename NamedParameters>
unsigned threads(const NamedParameters& np)
{
  if constexpr(std::is_same_v<Concurrency_tag, Sequential_tag>)
    return 1;
  else
    return parameter(np, internal_np::threads, (std::max)(1u, std::thread::hardware_concurrency()));
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_LIMITS_H
