// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_FILL_HOLES_H
#define CGAL_GEODESIC_PROCESSING_FILL_HOLES_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/adaptors/mesh_holes.h>
#include <CGAL/Geodesic_processing/internal/mesh/unfold_hole.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingRemeshing
/// The triangulations with which `fill_holes()` fills a hole.
enum class Hole_filling_method
{
  /// The triangulation with the smallest dihedral angles, see
  /// `CGAL::Polygon_mesh_processing::triangulate_hole()`
  minimal_dihedral_angles,
  /// The constrained Delaunay triangulation of the boundary, after it is unfolded to the plane
  unfolding
};

/// \ingroup PkgGeodesicProcessingRemeshing
/// The result of `fill_holes()`.
struct Hole_filling_result
{
  std::size_t number_of_holes = 0;  ///< number of holes before the call
  std::size_t number_of_filled = 0; ///< number of holes that were filled
  /// number of holes that satisfy the bounds, but have no valid triangulation
  std::size_t number_of_failed = 0;
  /// number of holes filled by `Hole_filling_method::unfolding`
  std::size_t number_of_unfolded = 0;
  std::size_t number_of_faces = 0; ///< number of new faces
};

namespace internal {

// Returns the length of the boundary of a hole.
template <typename TriangleMesh, typename PointMap>
double perimeter(const Hole_cycle<TriangleMesh>& hole, const TriangleMesh& mesh,
                 const PointMap& points)
{
  double result = 0.;
  for(const auto h : hole)
  {
    const auto &p = get(points, source(h, mesh)), &q = get(points, target(h, mesh));
    result += std::hypot(CGAL::to_double(p[0]) - CGAL::to_double(q[0]),
                         CGAL::to_double(p[1]) - CGAL::to_double(q[1]),
                         CGAL::to_double(p[2]) - CGAL::to_double(q[2]));
  }
  return result;
}

// Triangulates a hole by a method, or by the other method if the first one fails.
inline Hole_triangles triangulate(const Hole_boundary& hole, Hole_filling_method method,
                                  double& steps_left, bool& is_unfolded)
{
  is_unfolded = method == Hole_filling_method::unfolding;
  Hole_triangles triangles =
      is_unfolded ? triangulate_unfolded_hole(hole) : triangulate_hole(hole, steps_left);
  if(triangles.empty())
  {
    is_unfolded = !is_unfolded;
    triangles = is_unfolded ? triangulate_unfolded_hole(hole) : triangulate_hole(hole, steps_left);
  }
  return triangles;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingRemeshing
///
/// Fills the holes of a mesh with triangles between the vertices of their boundaries. No vertex is
/// added or moved.
///
/// A hole is a boundary cycle. A cycle that visits a vertex several times counts as several holes.
/// Parts of the mesh that only touch at a vertex have separate holes. After these are filled, the
/// vertex has several closed fans of faces, and circulators visit one of them. The outer boundary
/// of an open surface is also a hole: use `maximum_number_of_edges` or `maximum_perimeter` to keep
/// it open.
///
/// If the method of the named parameter `hole_filling_method` has no valid triangulation of a hole,
/// the other method is used. A triangulation is valid if its triangles have an area and contain no
/// edge between two vertices that have an edge already. A hole is left open if neither method has a
/// valid triangulation, or if it is the boundary of an isolated face. Triangles can intersect each
/// other or the mesh.
///
/// <b>Minimal dihedral angles.</b> The largest dihedral angle is minimized first, the area second
/// \cgalCite{cgal:l-fhm-03}. Holes of more than 200 edges are filled by a planar or Delaunay
/// triangulation only, those of more than 1,000 edges by a planar one only. Those of more than
/// 5,000 edges are not filled. Small holes are filled first, and the total number of steps is
/// limited: it is sufficient if half of the vertices are on typical boundary cycles.
///
/// <b>Unfolding.</b> The boundary is unfolded to a polygon in the plane, with the lengths of its
/// edges and the angles between them. If the polygon does not close, the missing angle and the gap
/// are distributed. The hole is filled by the constrained Delaunay triangulation of the polygon
/// \cgalCite{cgal:pc-grfp-03}. There is no valid triangulation if the polygon intersects itself.
///
/// \tparam TriangleMesh a model of `HalfedgeListGraph` and `MutableFaceGraph`
/// \param mesh a mesh; faces that are not at a hole can be any polygons
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_number_of_edges}
///     \cgalParamDescription{holes with more edges are left open}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{the largest `std::size_t`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_perimeter}
///     \cgalParamDescription{holes with a longer boundary are left open}
///     \cgalParamType{`double`, the unit of the coordinates}
///     \cgalParamDefault{infinity}
///   \cgalParamNEnd
///   \cgalParamNBegin{hole_filling_method}
///     \cgalParamDescription{the triangulation of holes}
///     \cgalParamType{`Hole_filling_method`}
///     \cgalParamDefault{`Hole_filling_method::minimal_dihedral_angles`}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_output}
///     \cgalParamDescription{an output iterator that takes the new faces}
///     \cgalParamType{a model of `OutputIterator` for faces of the mesh}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the positions of the vertices}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertices as keys and 3D points as
///       values}
///     \cgalParamDefault{the vertex point map of the mesh}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the completed fraction between two
///       holes. If it returns false, the function throws `Cancelled`}
///     \cgalParamType{a function object that takes a `double` and returns a `bool`}
///     \cgalParamDefault{no function is called}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre The mesh is valid: `CGAL::is_valid_polygon_mesh(mesh)`. The property map has a value for
///      each vertex.
/// \returns the numbers of holes and of new faces
/// \throws Invalid_argument_error if a coordinate at the boundary of a hole is not finite, or if
///         the maximum perimeter is negative or not a number
/// \throws Cancelled if the callback returns false; the mesh is unchanged
///
/// O(n) for n vertices, and for each hole of k edges O(k<SUP>3</SUP>), or O(k log k) for unfolding.
template <typename TriangleMesh, typename NamedParameters = internal::Default_parameters>
Hole_filling_result fill_holes(TriangleMesh& mesh, const NamedParameters& np = NamedParameters())
{
  static_assert(!internal::Is_cloud<TriangleMesh>::value,
                "A cloud has no boundary cycles, because its triangles overlap.");
  const auto max_edges = static_cast<std::size_t>(internal::parameter(
      np, internal_np::maximum_number_of_edges, (std::numeric_limits<std::size_t>::max)()));
  const double max_perimeter = internal::parameter(np, internal_np::maximum_perimeter,
                                                   std::numeric_limits<double>::infinity());
  const auto method = internal::parameter(np, internal_np::hole_filling_method,
                                          Hole_filling_method::minimal_dihedral_angles);
  auto out = internal::parameter(np, internal_np::face_output, CGAL::Emptyset_iterator());
  const auto points = internal::parameter(np, CGAL::internal_np::vertex_point,
                                          get_const_property_map(vertex_point, mesh));
  const internal::Callback callback = internal::read_throwing_callback(np);
  if(!(max_perimeter >= 0.))
    throw Invalid_argument_error("The maximum perimeter of a hole is negative or not a number.");

  std::vector<internal::Hole_cycle<TriangleMesh>> holes = internal::find_holes(mesh);
  Hole_filling_result result;
  result.number_of_holes = holes.size();
  holes.erase(std::remove_if(holes.begin(), holes.end(),
                             [&](const auto& hole) {
                               return hole.size() > max_edges ||
                                      internal::perimeter(hole, mesh, points) > max_perimeter;
                             }),
              holes.end());
  // Small holes are filled first, so that a large hole does not exhaust their steps.
  std::stable_sort(holes.begin(), holes.end(),
                   [](const auto& a, const auto& b) { return a.size() < b.size(); });
  double steps_left = 1e7 + 500. * static_cast<double>(num_vertices(mesh));

  // The mesh is changed after all triangulations are known: cancelling leaves it unchanged.
  std::vector<internal::Hole_triangles> triangulations(holes.size());
  internal::Boundary_neighbors<TriangleMesh> neighbors =
      internal::find_boundary_neighbors(holes, mesh);
  const auto position = get(dynamic_vertex_property_t<internal::Index>(), mesh);
  for(const auto v : vertices(mesh))
    put(position, v, internal::none);
  for(std::size_t i = 0; i < holes.size(); ++i)
  {
    if(callback)
      callback(static_cast<double>(i) / static_cast<double>(holes.size()));
    bool is_unfolded = false;
    if(holes[i].size() >= 3 && !internal::is_around_isolated_face(holes[i], mesh))
      triangulations[i] =
          internal::triangulate(internal::read_hole(holes[i], mesh, points, neighbors, position),
                                method, steps_left, is_unfolded);
    if(triangulations[i].empty())
    {
      ++result.number_of_failed;
      continue;
    }
    ++result.number_of_filled;
    result.number_of_unfolded += is_unfolded;
    for(const auto& triangle : triangulations[i])
      for(std::size_t k = 0; k < 3; ++k)
      {
        const auto from = source(holes[i][triangle[k]], mesh),
                   to = source(holes[i][triangle[(k + 1) % 3]], mesh);
        neighbors[from].push_back(to);
        neighbors[to].push_back(from);
      }
  }
  std::vector<internal::Hole_cycle<TriangleMesh>> filled;
  for(std::size_t i = 0; i < holes.size(); ++i)
    if(!triangulations[i].empty())
    {
      internal::add_hole_faces(holes[i], triangulations[i], mesh,
                               [&](auto face)
                               {
                                 *out++ = face;
                                 ++result.number_of_faces;
                               });
      filled.push_back(std::move(holes[i]));
    }
  internal::link_boundaries(filled, mesh);
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_FILL_HOLES_H
