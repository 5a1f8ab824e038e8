// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DEPARTURE_FINDER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DEPARTURE_FINDER_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_state.h>

#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Meeting;

// The length of the shortest path from a source to a location, and its direction at the source, as
// Departure::polar_angle. The length is infinite if there is no path.
struct Polar_departure
{
  double length = infinity;
  double polar_angle = 0.;
};

// Computes the departures of the exact shortest paths from one location to many.
//
// One window propagation measures the distances of all locations (see Window_propagation). It ends
// at the farthest of them. Then the last straight line of each path is followed back to the source,
// in O(#crossed triangles) time. Results are those of Window_propagation::departure(), which
// searches for each location separately.
class CGAL_GEODESIC_PROCESSING_EXPORT Departure_finder
{
public:
  // Throws Unsupported_surface_error if the arrays are a cloud.
  //
  // to  canonical locations
  Departure_finder(std::shared_ptr<const Surface_arrays> triangles,
                   std::vector<Surface_location> to);

  // Returns the arrays without degenerate triangles, to which the lengths and angles refer.
  const std::shared_ptr<const Surface_arrays>& triangles() const { return m_state.triangles; }

  // Returns the departure to each location from a canonical location. If the callback returns
  // false, throws Cancelled. Throws Unsupported_surface_error as Window_propagation::run().
  std::vector<Polar_departure> operator()(const Surface_location& from,
                                          const std::function<bool(double)>& callback = {});

private:
  // Points of a triangle: the locations, in each of their triangles.
  struct Target
  {
    std::size_t number; // in the array of locations
    Source_piece piece;
  };

  Polar_departure departure_of_vertex(Index vertex) const;
  Polar_departure departure_of_target(const Source_piece& piece, const Meeting& meeting) const;
  Polar_departure departure_of_line(const Source_piece& piece, const Meeting& meeting) const;
  Polar_departure departure_of_path(const std::vector<Surface_location>& path, double length) const;

  Window_state m_state;
  std::vector<Surface_location> m_to;
  std::vector<Target> m_targets;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DEPARTURE_FINDER_H
