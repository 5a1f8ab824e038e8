// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_METHODS_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_METHODS_H

#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/distances/heat.h>
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>

#include "Array_surface.h"

#include <ostream>
#include <vector>

// All methods of computing distances behind one function, for properties that all of them have.

namespace CGAL::Geodesic_processing::test {

enum class Method
{
  dijkstra,
  fast_marching,
  euclidean_front,
  heat
};
constexpr Method fronts[] = {Method::dijkstra, Method::fast_marching, Method::euclidean_front};
constexpr Method all_methods[] = {Method::dijkstra, Method::fast_marching, Method::euclidean_front,
                                  Method::heat};

inline std::ostream& operator<<(std::ostream& out, Method method)
{
  constexpr const char* names[] = {"Dijkstra", "fast marching", "Euclidean front", "heat"};
  return out << names[int(method)];
}

// A finalized vertex is reopened if its distance decreases by at least one part in 10^12. Smaller
// decreases are ignored, which adds up along some tens of vertices in these tests.
constexpr double front_tolerance = 1e-10;
// Round-off errors of sums of some hundred lengths.
constexpr double round_off_tolerance = 1e-12;

inline internal::Front_kind kind_of(Method method)
{
  return method == Method::dijkstra        ? internal::Front_kind::dijkstra
         : method == Method::fast_marching ? internal::Front_kind::planar
                                           : internal::Front_kind::euclidean;
}

// Computes the distances at the points of a surface, in its unit.
inline std::vector<double> distances(const Array_surface& surface, Method method,
                                     const std::vector<internal::Front_source>& sources)
{
  if(method == Method::heat)
  {
    internal::Heat_solver solver(surface.triangles());
    solver.run(sources);
    return surface.distances(solver);
  }
  internal::Front front(surface.triangles(), kind_of(method));
  front.run(sources);
  return surface.distances(front);
}

// Returns the path of the Euclidean front from a location to the nearest source.
inline std::vector<Surface_location> path(const Surface_arrays& triangles,
                                          const internal::Front& front,
                                          const std::vector<internal::Front_source>& sources,
                                          const Surface_location& from)
{
  return internal::path_to_sources(
      triangles, from, sources, [&](Index i) { return front.distance(i); },
      [&](Index i) { return front.predecessor(i); }, [&](Index i) { return front.source(i); });
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_METHODS_H
