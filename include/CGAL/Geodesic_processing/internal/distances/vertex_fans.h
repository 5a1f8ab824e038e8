// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_VERTEX_FANS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_VERTEX_FANS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <array>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// All that a front reads around a site, in one run of memory: a front visits sites all over
// it, and waits for memory longer than it computes.
struct Vertex_fans
{
  // A side, seen from the site, and the triangle between it and the next spoke.
  struct Fan_edge
  {
    enum Flag : Index
    {
      has_triangle = 1,         // else it is the last one of its fan
      is_repeated = 2,          // it begins or ends a closed fan, and stands at both ends
      is_obtuse_split = 4,      // the triangle's corner at this end is obtuse, and split
      is_next_obtuse_split = 8, // that at the next spoke's end is
      is_curved = 16, // the first one of a site whose triangles turn by more or less than 2 pi
    };
    Index vertex; // the site at the far end
    Index flags;
    double length;
    Vec2 opening; // unit vector at the triangle's angle, seen from this spoke
  };
  // Half of an obtuse corner, which the site behind the opposite side splits into two acute angles
  // once the triangles between are unfolded into its plane (Kimmel and Sethian 1998, section 3):
  // a triangle as good as a real one to reach that corner, seen from one end of its base.
  struct Split
  {
    Index corner;   // the obtuse one
    Index target;   // its site
    Index along;    // the site at the other end of the base
    Index neighbor; // the end that is a neighbour of the corner's site
    double base;    // its length
    Vec2 apex;      // where the corner lies when the base runs from this end along the first axis
  };

  // Where the spokes and the splits of a site begin, and its star: as in a CSR.
  struct Offsets
  {
    Index edge, split, ring;
  };

  std::vector<Offsets> begin; // #sites + 1
  std::vector<Fan_edge>
      edges; // of each fan counterclockwise; the first one again ends a closed fan
  std::vector<Split> splits;
};

// O(#triangles).  The corners of meshes are split, where that is asked for; at most 20 triangles are
// unfolded for each.
CGAL_GEODESIC_PROCESSING_EXPORT Vertex_fans build_vertex_fans(const Surface_arrays& triangles,
                                                              bool with_splits);

// The same, made anew only when nobody else has them: for triangles that change no more.
CGAL_GEODESIC_PROCESSING_EXPORT
std::shared_ptr<const Vertex_fans> shared_vertex_fans(const Surface_arrays& triangles,
                                                      bool with_splits);

// Where the triangle of a corner stands around the site of that corner.
struct Fan_position
{
  Index edge; // the one that the triangle follows
  Index ring; // the triangle's place in the star
};

inline Fan_position fan_position(const Surface_arrays& triangles, const Vertex_fans& fans,
                                 Index vertex, Index corner)
{
  Fan_position position = {fans.begin[vertex].edge, fans.begin[vertex].ring};
  for(; triangles.ring[position.ring] != corner; ++position.ring, ++position.edge)
    if(!(fans.edges[position.edge + 1].flags & Vertex_fans::Fan_edge::has_triangle))
      ++position.edge;
  return position;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_VERTEX_FANS_H
