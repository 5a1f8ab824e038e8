// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_DESCENT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_DESCENT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Descent_path
{
  std::vector<Surface_location>
      locations;       // as in Locally_shortest_path; empty if no source can be reached
  Index source = none; // index of the source at which the path ends
};

// Traces paths on a mesh by descending a distance field to its sources.
class CGAL_GEODESIC_PROCESSING_EXPORT Descent
{
public:
  // Keeps a reference to the triangles. Takes O(n log n) time for n triangles that contain a
  // source location. Throws Unsupported_surface_error on a cloud.
  Descent(const Surface_arrays& triangles, const std::vector<Front_source>& sources);

  // Returns the path of steepest descent of the linearly interpolated field.
  //
  // Each step decreases the field, so that the path has no cycles. From a local minimum without a
  // source, the path continues along edges to the nearest vertex with a smaller value. The path
  // ends if a source in the same triangle is at most as far as the field's value. It also ends at
  // a local minimum in a triangle that contains a source. If the value at `from` is infinite, the
  // path starts with the closest corner at which it is finite.
  //
  // distance  returns the distance of a vertex in the scale of the surface arrays; infinite if no
  //           source reaches it. The distances may be approximate.
  Descent_path operator()(const Surface_location& from,
                          const std::function<double(Index)>& distance) const;

private:
  // The segment of a source in a triangle; its endpoints have barycentric coordinates.
  struct Piece
  {
    Index triangle;
    Index source;
    double offset;
    std::array<double, 3> begin, end;
  };
  struct Tracer;

  const Surface_arrays& m_triangles;
  std::vector<Piece> m_pieces;                     // sorted by triangle
  std::vector<std::pair<Index, Index>> m_isolated; // isolated vertices and their sources
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_DESCENT_H
