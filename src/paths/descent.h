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
      locations;       // as in Locally_shortest_path; empty when no source can be reached
  Index source = none; // the position among the sources of the one where it ends
};

// Paths down a distance field on a mesh, from anywhere to the sources of the field.
class CGAL_GEODESIC_PROCESSING_EXPORT Descent
{
public:
  // Keeps a reference to the triangles.  Linear in the triangles around the sources.
  Descent(const Surface_arrays& triangles, const std::vector<Front_source>& sources);

  // The path of steepest descent of the linearly interpolated field.  Each step lowers the field,
  // so that it never turns in circles; in a pit of the field that holds no source it climbs out
  // along arcs, to the nearest site that is lower.  It ends at a source as soon as one in the same
  // triangle explains the field's value, or in a pit next to one.  Where the value at `from` is
  // infinite it begins at the nearest corner where it is not.
  //
  // distance  of each site, in any unit; infinite where no source reaches.  How it was found does
  //           not matter.
  Descent_path operator()(const Surface_location& from,
                          const std::function<double(Index)>& distance) const;

private:
  // A straight part of a source in a triangle, by the coordinates of its ends.
  struct Piece
  {
    Index triangle;
    Index source;
    double offset;
    std::array<double, 3> begin, end;
  };
  struct Tracer;

  const Surface_arrays& m_triangles;
  std::vector<Piece> m_pieces;                     // by triangle
  std::vector<std::pair<Index, Index>> m_isolated; // sites without triangles, and their sources
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_DESCENT_H
