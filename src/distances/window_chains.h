// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_CHAINS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_CHAINS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_state.h>

#include <optional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Paths from the results of window propagation. A path from a vertex to its source is a chain of
// straight lines between pseudo-sources. Each vertex stores the last one as a Window_arrival.

// A straight line from a location, in a direction of the layout of its triangle, to the origin of a
// window.
struct Line_to_origin
{
  Surface_location from;
  Vec2 direction;
  double length;
  Index origin;
};

// Returns the location of the origin of windows, or nothing if it is a segment.
std::optional<Surface_location> source_point(const Window_state& windows, Index origin);

// Returns the length of the straight line by which a window arrived.
double line_length(const Window_state& windows, const Window_arrival& arrival);

// Appends the path from a vertex to its source, without the vertex itself, and returns its length.
CGAL_GEODESIC_PROCESSING_EXPORT
double append_chain(const Window_state& windows, Index vertex, std::vector<Surface_location>& path);

// Appends the straight line from the vertex of an arrival to the origin of the arrival, without the
// vertex itself, and returns its length.
double append_arrival(const Window_state& windows, const Window_arrival& arrival,
                      std::vector<Surface_location>& path);

// Appends the points of a straight line, without its first one, and returns its length.
double append_line(const Window_state& windows, const Line_to_origin& line,
                   std::vector<Surface_location>& path);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_CHAINS_H
