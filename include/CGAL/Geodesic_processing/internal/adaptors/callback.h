// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_CALLBACK_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_CALLBACK_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

// Receives the completed fraction; returns false to cancel.
using Callback = std::function<bool(double)>;

// Returns the named parameter `callback`, which is empty by default.
template <typename NamedParameters>
Callback read_callback(const NamedParameters& np)
{
  static_assert(
      std::is_convertible_v<decltype(parameter(np, CGAL::internal_np::callback, Callback())),
                            Callback>,
      "callback is a function that takes the completed fraction, a double, and returns a "
      "bool.");
  return parameter(np, CGAL::internal_np::callback, Callback());
}

// Returns the named parameter `callback` as a function that throws Cancelled instead of returning
// false.
template <typename NamedParameters>
Callback read_throwing_callback(const NamedParameters& np)
{
  Callback given = read_callback(np);
  if(!given)
    return given;
  return [given = std::move(given)](double fraction)
  {
    if(!given(fraction))
      throw Cancelled();
    return true;
  };
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_CALLBACK_H
