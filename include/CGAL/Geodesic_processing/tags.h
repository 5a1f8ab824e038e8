// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TAGS_H
#define CGAL_GEODESIC_PROCESSING_TAGS_H

namespace CGAL::Geodesic_processing {

/// \addtogroup PkgGeodesicProcessingMethods
/// How a distance is found: the first template argument of `geodesic_distances()`.
/// @{

/// chooses the length of the shortest chain of edges, or of arcs between surfels. \cgalCite{cgal:d-ntpcg-59}
///
/// Never shorter than the distance on the surface, and not getting closer to it under refinement:
/// along the diagonals of a regular grid it stays 41 percent too long.
struct Dijkstra
{};

/// chooses a front that crosses each triangle as a straight line, with obtuse triangles split by
/// unfolding. \cgalCite{cgal:ks-cgpm-98}
///
/// The error falls with the power 0.7 to 0.8 of the length of the edges; about 1 percent on common
/// meshes.  Admits speeds.
struct Fast_marching
{};

/// chooses a front that crosses each triangle as a circle around an unfolded source, of which each
/// vertex knows the direction.
///
/// Exact to rounding where the surface between the source and a vertex unfolds to a plane, also through
/// needles (among hundreds of thousands of them a few vertices may be off by a thousandth); elsewhere of second order, with errors of some hundredths of a percent on common meshes, up
/// to a few tenths on rough scans.  After Reimers's idea of circular fronts \cgalCite{cgal:r-tvs-04},
/// with the curvature of the circle fitted to a direction and two distances instead of assumed.  With
/// a speed the front is that of `Fast_marching`.
struct Euclidean_front
{};

/// chooses the exact distance on the polyhedron, on meshes only: windows are propagated over edges.
/// \cgalCite{cgal:mmp-dgp-87}
///
/// Right to rounding on every mesh, with saddles, borders and needles; paths are shortest ones, and
/// distances are exact in faces too, each at the cost of a search from there.  Where the mesh is flat
/// it takes a few times as long as `Euclidean_front`; on curved ones the windows grow as
/// O(n<SUP>1.5</SUP>).  Windows of neighbouring edges cross a face together, after Qin et al.
/// \cgalCite{cgal:qhyyz-fedgc-16}
struct Exact
{};

/// chooses the heat method: one linear system for the direction of the flow of heat, one for the
/// distance. \cgalCite{cgal:cww-ghnac-13}
///
/// A smooth approximation, with errors of 0.4 to 3 percent; a solver prepares the factorizations.
struct Heat
{};

/// @}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_TAGS_H
