// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_METHOD_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_METHOD_H

#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/parameters.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <type_traits>

namespace CGAL::Geodesic_processing::internal {

// Returns the method of a tag. If it is Runtime_method, returns the named parameter `method`, or
// `default_method` if it is not given.
template <typename Method, typename NamedParameters>
Distance_method read_method(const NamedParameters& np,
                            Distance_method default_method = Distance_method::automatic)
{
  if constexpr(std::is_same_v<Method, Runtime_method>)
    return parameter(np, internal_np::method, default_method);
  else
  {
    static_assert(!has_parameter<NamedParameters, internal_np::method_t>,
                  "The named parameter method requires the tag Runtime_method.");
    return distance_method<Method>();
  }
}

// As read_method(), for functions whose method is a front. Throws Invalid_argument_error if the
// method that is selected at run time is not a front.
template <typename Method, typename NamedParameters>
Front_kind read_front_kind(const NamedParameters& np)
{
  static_assert(is_front<Method> || std::is_same_v<Method, Runtime_method>,
                "The method must be a front: Euclidean_front, Fast_marching or Dijkstra.");
  return front_kind(read_method<Method>(np, Distance_method::euclidean_front));
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_METHOD_H
