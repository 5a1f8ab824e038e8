// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_IN_STRIP_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_IN_STRIP_H

#include "mesh/Split_mesh.h"

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A path from a site to another that runs through no site between, by the sides that it crosses, each
// given in the triangle that it leaves, and where it crosses each.
struct Strip_path
{
  std::vector<Index> halfedges; // empty when the sites are in a common triangle, or it crosses none
  std::vector<double> fractions;
};

// Pulls a path taut, which keeps off the ends of the sides it crosses by Split_mesh::margin: the
// funnel of its strip (Lee and Preparata 1984), led around the other side of a site as long as that
// makes it shorter (Xin and Wang 2007).  Unlike straighten(), it meets no site.
//
// is_barred  #sites: those around whose other side it is not led
// sides      that some path crosses; loops are taken out
//
// Proportional to the strip times the turns, of which there are less in very long strips.
CGAL_GEODESIC_PROCESSING_EXPORT
Strip_path shorten_in_strip(const Split_mesh& mesh, const std::vector<bool>& is_barred, Index from,
                            Index to, std::vector<Index> halfedges);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_IN_STRIP_H
