// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BASE_PARAMETERIZATION_H
#define CGAL_GEODESIC_PROCESSING_BASE_PARAMETERIZATION_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/geodesic_delaunay_remeshing.h>
#include <CGAL/Geodesic_processing/internal/adaptors/add_faces.h>
#include <CGAL/Geodesic_processing/internal/remeshing/base_map.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/adaptors/remeshing_options.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingRemeshing
///
/// how places inside of a base face get their coordinates; on its edges they divide these by length.
///
/// `heron`: the areas of the planar triangles whose sides are geodesic distances to the corners and the
/// edges' lengths, \cgalCite{cgal:pc-grfp-03} which keep distances where the surface is flat.  `mean_value`:
/// Floater's convex combinations (2003).  `uniform`: the mean of the neighbours (Tutte 1963).
using Base_coordinates = internal::Base_coordinates;

namespace internal {

// What named parameters ask of a base mesh.
template <typename Surface, typename Domain, typename NamedParameters>
Remeshing_options base_mesh_options(const Surface& surface, const Domain& domain,
                                    std::size_t number, const NamedParameters& np)
{
  Remeshing_options result = remeshing_options(surface, domain, number, np);
  result.does_fit_to_input = false;
  result.maximum_deviation = infinity;
  return result;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingRemeshing
/// a place on a base mesh.
struct Base_location
{
  std::size_t face = 0;                             ///< its number
  std::array<double, 3> barycentric = {1., 0., 0.}; ///< the shares of its corners
};

/// \ingroup PkgGeodesicProcessingRemeshing
///
/// A mesh and a base of few triangles, which are mapped onto each other: continuous, and one to one.
/// \cgalCite{cgal:pc-grfp-03}
///
/// The base is the geodesic Delaunay triangulation of samples; its edges are drawn on the mesh as
/// `geodesic_base_mesh()` tells.  Where coordinates fold a triangle, which Heron's do where the surface bends
/// much within a base face, the whole face gets mean value coordinates, and where rounding folds these,
/// uniform ones: these are convex combinations and do not fold, for the same boundary (Tutte 1963, Floater
/// 1997).
///
/// Knows the mesh's descriptors, as a `Mesh_domain`, but not the mesh.
template <typename TriangleMesh>
class Base_parameterization
{
  using Domain = Mesh_domain<TriangleMesh>;

public:
  using Surface = TriangleMesh;
  using Location = typename Domain::Location; ///< `Polygon_mesh_processing::Face_location`
  using Point_3 = typename Domain::Point_3;

  /// finds the base, and the map.
  ///
  /// \param mesh all of whose faces are triangles
  /// \param number of base vertices; more come where it takes them
  /// \param np what `make_domain()` takes, `random_seed`, `number_of_relaxation_steps`, `first_samples`,
  ///        `speed_map`, `sharp_angle`, `edge_is_constrained_map`, `curve_spacing`, `edge_spacing_map` and
  ///        `callback` as for `geodesic_delaunay_remeshing()`: base edges follow borders, sharp and
  ///        constrained edges exactly; and
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{base_coordinates}
  ///     \cgalParamDescription{a `Base_coordinates`} \cgalParamDefault{`Base_coordinates::heron`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Unsupported_surface_error when edges cannot be drawn, which rounding alone could cause, or
  ///         triangles of the mesh cannot be remeshed
  /// \throws Invalid_argument_error as `geodesic_delaunay_remeshing()`, and when the callback cancels
  ///
  /// Near-linear in the mesh and the length of the edges, in its sides; exact distances visit each vertex
  /// three times.
  template <typename NamedParameters = internal::Default_parameters>
  Base_parameterization(const TriangleMesh& mesh, std::size_t number,
                        const NamedParameters& np = NamedParameters())
      : m_domain(mesh, np)
  {
    auto base = std::make_shared<internal::Base_mesh>(internal::build_base_mesh(
        m_domain.triangles(), internal::base_mesh_options(mesh, m_domain, number, np)));
    if(base->triangles.empty())
      throw Invalid_argument_error("The mesh has no triangle, or the base was cancelled.");
    m_map = std::make_shared<const internal::Base_map>(
        std::move(base),
        internal::parameter(np, internal_np::base_coordinates, Base_coordinates::heron));
  }

  std::size_t number_of_base_vertices() const { return m_map->base().samples.size(); }
  std::size_t number_of_base_faces() const { return m_map->base().triangles.size(); }
  /// the numbers of the corners of a base face, counterclockwise, to which coordinates belong.
  std::array<std::size_t, 3> base_face(std::size_t face) const
  {
    check_face(face);
    const auto& f = m_map->base().triangles[face];
    return {f[0], f[1], f[2]};
  }
  /// where a base vertex is.
  Location base_vertex(std::size_t vertex) const
  {
    if(vertex >= number_of_base_vertices())
      throw Invalid_argument_error("There is no base vertex of that number.");
    return m_domain.outer(m_map->base().samples[vertex]);
  }

  /// the number of triangles that are folded: zero, but where rounding folds uniform coordinates.
  std::size_t folds() const { return m_map->folds(); }
  /// the number of base faces whose coordinates are not those asked for.
  std::size_t repaired_faces() const { return m_map->number_of_repaired_regions(); }

  /// returns where a place of the mesh is on the base.  Proportional to the parts of its face.
  Base_location operator()(const Location& location) const
  {
    return locate(internal::canonical(*m_domain.triangles(), m_domain.inner(location)));
  }
  /// the same for a vertex; one that has no face throws `Invalid_argument_error`.
  Base_location operator()(typename Domain::Vertex vertex) const
  {
    return locate(
        internal::vertex_location(*m_domain.triangles(), m_domain.inner_vertex(vertex).vertex));
  }
  /// returns what place of the mesh is at a place of the base.  Proportional to the faces of its base face.
  Location inverse(const Base_location& location) const { return m_domain.outer(inner(location)); }
  /// the same as a point.
  Point_3 point(const Base_location& location) const { return m_domain.point(inner(location)); }

  /// \name For other functions of this package
  /// @{
  const Domain& domain() const { return m_domain; }
  const internal::Base_map& map() const { return *m_map; }
  /// @}

private:
  void check_face(std::size_t face) const
  {
    if(face >= number_of_base_faces())
      throw Invalid_argument_error("There is no base face of that number.");
  }
  Base_location locate(const internal::Surface_location& location) const
  {
    if(location.triangle == internal::none)
      throw Invalid_argument_error("An isolated vertex has no place on a base mesh.");
    const internal::Base_location found = (*m_map)(location);
    return {found.triangle, found.barycentric};
  }
  internal::Surface_location inner(const Base_location& location) const
  {
    check_face(location.face);
    const auto& b = location.barycentric;
    // 1e-6 is what rounding can do to the sum of three.
    if(!((std::min)({b[0], b[1], b[2]}) > -1e-6) || !(std::abs(b[0] + b[1] + b[2] - 1.) < 1e-6))
      throw Invalid_argument_error("Barycentric coordinates are negative or do not sum to one.");
    return m_map->inverse({internal::Index(location.face), b});
  }

  Domain m_domain;
  std::shared_ptr<const internal::Base_map> m_map;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_BASE_PARAMETERIZATION_H
