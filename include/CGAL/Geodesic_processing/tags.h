// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TAGS_H
#define CGAL_GEODESIC_PROCESSING_TAGS_H

namespace CGAL::Geodesic_processing {

/// \addtogroup PkgGeodesicProcessingMethods
/// Methods for distances: the first template argument of `geodesic_distances()`.
/// @{

/// Selects Dijkstra's algorithm: the length of the shortest path along edges, or along graph edges
/// between surfels. \cgalCite{cgal:d-ntpcg-59}
///
/// On a mesh the result is never shorter than the distance on the surface; on a cloud, edges are
/// chords of the surface. It does not converge to this distance under refinement: along the
/// diagonals of a regular grid it remains 41 percent too long.
struct Dijkstra
{};

/// Selects fast marching: the front crosses each triangle as a straight line. Obtuse triangles are
/// split by unfolding. \cgalCite{cgal:ks-cgpm-98}
///
/// The error is proportional to the edge length to the power of 0.7 to 0.8. It is about 1 percent
/// on common meshes. Speeds can be used.
struct Fast_marching
{};

/// Selects a circular front: it crosses each triangle as a circle around an unfolded source. Each
/// vertex stores the direction to its source.
///
/// The triangles are those of an intrinsic triangulation with the metric of the mesh.
/// \cgalCite{cgal:fsbs-acidt-07} Edges are flipped if the opposite angles sum to more than 198
/// degrees, or 190 degrees if large triangles cover a tenth of the area. Therefore needles and caps
/// need no more time than other triangles. If an edge is longer than five times the root of the
/// mean area per vertex, all edges longer than three times this root are bisected, because large
/// triangles cause large errors. A mesh of few vertices counts as one of 500. A solver computes
/// this triangulation once. Samples, cells and charts, which need many fronts, use it without
/// bisected edges.
///
/// If the surface between the source and a vertex unfolds to a plane, the distance is exact up to
/// round-off errors. Elsewhere the method is of second order. Errors are some hundredths of a
/// percent on common meshes, and up to some tenths on rough scans. On CAD models the mean error is
/// up to one percent, and single distances are wrong by some percent. On clouds of smooth surfaces
/// they are as on common meshes; on sharp or thin parts with few surfels, single distances are
/// wrong by more than ten percent. On a mesh, no distance exceeds the length of a path along edges.
/// From a single point, none is below the length of the straight line.
///
/// Circular fronts are due to Reimers \cgalCite{cgal:r-tvs-04}. Here the curvature of the circle is
/// not assumed, but fitted to a direction and two distances. If speeds are not all equal, the front
/// is that of `Fast_marching`.
struct Euclidean_front
{};

/// Selects the exact distance on the polyhedron, on meshes only. Windows are propagated across
/// edges. \cgalCite{cgal:mmp-dgp-87}
///
/// The distance is exact up to round-off errors on every mesh, including saddles, boundaries and
/// needles. Paths are shortest paths. Distances inside faces are exact as well, and each takes a
/// separate search from there. Faces of speed zero are obstacles: distances are exact on the
/// surface without them. All other speeds must be equal. Thin triangles amplify the round-off
/// errors of the lengths of their edges. A triangle with the longest edge c and the height h
/// changes a distance by at most 2.3e-15 c<SUP>2</SUP>/h, and by at most 7e-8 c. Lower and
/// upper bounds contain these errors.
///
/// With a positive `relative_tolerance`, similar windows are merged, and the solver has certified
/// bounds of the distances. \cgalCite{cgal:sskgh-feagm-05} On smooth meshes of 100,000 vertices
/// this takes a fifth of the time.
///
/// On flat regions this takes a few times as long as `Euclidean_front`. On curved meshes the
/// number of windows grows as O(n<SUP>1.5</SUP>). The windows of adjacent edges cross a face
/// together, as proposed by Qin et al. \cgalCite{cgal:qhyyz-fedgc-16}
///
/// Around vertices of very high degree O(n<SUP>2</SUP>) windows are possible. A query that
/// needs more than 10<SUP>9</SUP> + 10 h<SUP>1.5</SUP> steps of windows on h halfedges throws
/// `Unsupported_surface_error`.
struct Exact
{};

/// Selects the heat method. One linear system determines the direction of the heat flow, and
/// another one the distance. \cgalCite{cgal:cww-ghnac-13}
///
/// The result is a smooth approximation. Its mean error is about 1 percent on fine scans and 7
/// percent on most public meshes, and its largest error about seven times as large. A solver
/// precomputes the factorizations.
struct Heat
{};

/// Selects the default method: the most accurate one that the surface and the speeds admit.
///
/// - On a mesh it is `Exact`, if no speed is given, or if all speeds that are not zero are equal.
/// - On a mesh with other speeds, and on a cloud, it is `Euclidean_front`.
///
/// The choice is made for each query.
struct Automatic
{};

/// Lists the methods. It is the type of the named parameter `method` of `Runtime_method`.
enum class Distance_method
{
  dijkstra,        ///< `Dijkstra`
  fast_marching,   ///< `Fast_marching`
  euclidean_front, ///< `Euclidean_front`
  exact,           ///< `Exact`
  heat,            ///< `Heat`
  automatic        ///< `Automatic`
};

/// Selects the method at run time by the named parameter `method`. Its default is the default
/// method of the function.
///
/// Use it if the users of a program choose the method: a function is then compiled once for all
/// methods. Every function and class that accepts these methods accepts it, except for
/// `geodesic_path()` and `Gradient`. Functions that accept only fronts throw `Invalid_argument_error` for
/// `Distance_method::exact` and `Distance_method::heat`. On a cloud, `Distance_method::exact`
/// throws `Unsupported_surface_error`.
struct Runtime_method
{};

/// @}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_TAGS_H
