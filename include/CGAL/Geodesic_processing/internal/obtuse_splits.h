// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OBTUSE_SPLITS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OBTUSE_SPLITS_H

#include <CGAL/Geodesic_processing/internal/Glued_triangles.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// For each obtuse corner the site behind the opposite side that splits it into two acute angles,
// once the triangles between are unfolded into its plane (Kimmel and Sethian 1998, section 3).
struct Obtuse_splits
{
  struct Split
  {
    Index corner;               // the obtuse one
    Index site;                 // what splits it
    double length;              // from the corner to that site
    std::array<double, 2> base; // from that site to the corner's two neighbours, the one that the
                                //   corner's side runs to first
  };
  std::vector<Split> splits;
  std::vector<Index> split_of_corner; // 3 #triangles: none at acute corners and where no site
                                      //   within reach splits the corner (at borders)
  std::vector<Index> first, behind;   // CSR: the splits that use a site as the one behind
};

// O(#triangles); at most `steps` triangles are unfolded for a corner.
CGAL_GEODESIC_PROCESSING_EXPORT
Obtuse_splits obtuse_splits(const Glued_triangles& triangles, int steps = 20);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OBTUSE_SPLITS_H
