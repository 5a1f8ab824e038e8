// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_DISTANCES_SPLIT_HALF_H
#define CGAL_GEODESIC_PROCESSING_DISTANCES_SPLIT_HALF_H

#include <CGAL/Geodesic_processing/internal/distances/obtuse_splits.h>
#include "core/unfold.h"

namespace CGAL::Geodesic_processing::internal {

// Returns the half of a split corner that a view of a vertex identifies.
inline Obtuse_splits::Half split_half(const Obtuse_splits& s, Index vertex,
                                      const Obtuse_splits::View& view)
{
  const Obtuse_splits::Split& split = s.splits[view.split()];
  const double base = split.base[view.half()], to_neighbor = split.to_neighbor[view.half()];
  if(view.is_from_splitting_vertex())
    return {split.corner, view.target, view.along,
            view.along,   base,        third_corner(base, split.length, to_neighbor)};
  return {split.corner, view.target, view.along,
          vertex,       base,        third_corner(base, to_neighbor, split.length)};
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_DISTANCES_SPLIT_HALF_H
