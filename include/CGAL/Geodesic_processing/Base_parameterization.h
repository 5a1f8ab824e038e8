// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BASE_PARAMETERIZATION_H
#define CGAL_GEODESIC_PROCESSING_BASE_PARAMETERIZATION_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/geodesic_delaunay_remeshing.h>
#include <CGAL/Geodesic_processing/internal/adaptors/Reconstructed_domain.h>
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

#ifndef DOXYGEN_RUNNING
using internal::Base_coordinates;
#else
/// \ingroup PkgGeodesicProcessingRemeshing
///
/// The kind of barycentric coordinates inside a base face. Base edges are parameterized by arc
/// length.
enum class Base_coordinates
{
  /// Areas of planar triangles whose edge lengths are the lengths of the base edges and the
  /// geodesic distances to the corners. They preserve distances if the surface is flat.
  /// \cgalCite{cgal:pc-grfp-03}
  heron,
  mean_value, ///< convex combinations of the neighbors with mean value weights (Floater 2003)
  uniform     ///< the mean of the neighbors (Tutte 1963)
};
#endif

namespace internal {

// Converts the named parameters of a base mesh to options.
template <typename Domain, typename NamedParameters>
Remeshing_options base_mesh_options(const Domain& domain, std::size_t number,
                                    const NamedParameters& np)
{
  Remeshing_options result = remeshing_options(domain, number, np);
  result.does_fit_to_input = false;
  result.maximum_deviation = infinity;
  return result;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingRemeshing
/// A location on a base mesh.
struct Base_location
{
  std::size_t face = 0;                             ///< index of the base face
  std::array<double, 3> barycentric = {1., 0., 0.}; ///< weights of its corners
};

/// \ingroup PkgGeodesicProcessingRemeshing
///
/// A continuous, one-to-one map between a surface and a base mesh with few triangles.
/// \cgalCite{cgal:pc-grfp-03}
///
/// The base mesh is the geodesic Delaunay triangulation of samples. Its edges are paths on the
/// surface; see `geodesic_base_mesh()`. A cloud is reconstructed first, as for
/// `geodesic_delaunay_remeshing()`: then the mesh in the following is the reconstructed one. Each
/// location of the cloud is mapped as the closest location of that mesh, and locations of that mesh
/// are returned as the closest locations on the cloud.
///
/// Heron coordinates can fold triangles of the mesh if the curvature within a base face is high. If
/// coordinates fold a triangle, the whole base face gets mean value coordinates. If round-off
/// errors fold triangles of these, it gets uniform coordinates. Both are convex combinations, which
/// do not fold triangles and have the same boundary values (Tutte 1963, Floater 1997). If round-off
/// errors fold triangles of these, too, base vertices are added inside the base face.
///
/// The object stores the descriptors of the mesh, as a `Mesh_domain` does, but not the mesh.
/// Members that do not state their time take O(1) time.
///
/// \tparam Surface a model of `FaceListGraph` or of `SurfelRange`
template <typename Surface>
class Base_parameterization
{
  using Domain = internal::Manifold_domain_of<Surface>;

public:
  using Vertex = typename Domain::Vertex;     ///< a vertex descriptor, or the index of a surfel
  using Location = typename Domain::Location; ///< `Geodesic_processing::Location<Surface>`
  using Point_3 = typename Domain::Point_3;

  /// Computes the base mesh and the map.
  ///
  /// \param surface a mesh, all of whose faces are triangles, or a cloud
  /// \param number the number of base vertices; more are added if the topology requires them, or if
  ///        triangles would be inverted
  /// \param np parameters of `make_domain()`; `random_seed`, `number_of_relaxation_steps`,
  ///        `first_samples`, `speed_map`, `face_speed_map`, `sharp_angle`,
  ///        `edge_is_constrained_map`, `curve_spacing`, `edge_spacing_map` and `callback` as for
  ///        `geodesic_delaunay_remeshing()`. Base edges follow the boundary, sharp edges and
  ///        constrained edges exactly. In addition:
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{base_coordinates}
  ///     \cgalParamDescription{the coordinates inside base faces}
  ///     \cgalParamType{`Base_coordinates`}
  ///     \cgalParamDefault{`Base_coordinates::heron`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Unsupported_surface_error if the triangles of the mesh cannot be remeshed, or if edges
  ///         cannot be traced on the mesh. The latter happens if needles are split into more than
  ///         150,000 + 10 n triangles, for n triangles and base edges
  /// \throws Invalid_argument_error if the mesh has no triangles
  /// \throws as `geodesic_delaunay_remeshing()`
  ///
  /// Takes near-linear time in the size of the mesh and in the length of the base edges, measured
  /// in edges of the mesh. Exact distances visit each vertex three times.
  template <typename NamedParameters = internal::Default_parameters>
  Base_parameterization(const Surface& surface, std::size_t number,
                        const NamedParameters& np = NamedParameters())
      : Base_parameterization(internal::Domain_of<Surface>(surface, np), number, np)
  {}
  /// Computes the base mesh and the map of a domain.
  ///
  /// \param domain a domain of the surface
  /// \param number, np as for a surface
  /// \throws as for a surface
  ///
  /// The time is that for a surface.
  template <typename NamedParameters = internal::Default_parameters>
  Base_parameterization(const internal::Domain_of<Surface>& domain, std::size_t number,
                        const NamedParameters& np = NamedParameters());
  /// Returns the number of vertices of the base mesh.
  std::size_t number_of_base_vertices() const { return m_map->base().samples.size(); }
  /// Returns the number of faces of the base mesh.
  std::size_t number_of_base_faces() const { return m_map->base().triangles.size(); }
  /// Returns the indices of the base vertices at the corners of a base face, counterclockwise.
  /// Barycentric coordinates are in the same order.
  /// \param face the index of a base face
  /// \throws Invalid_argument_error if the index is out of range
  std::array<std::size_t, 3> base_face(std::size_t face) const
  {
    check_face(face);
    const auto& f = m_map->base().triangles[face];
    return {f[0], f[1], f[2]};
  }
  /// Returns the location of a base vertex on the mesh. On a cloud of n surfels, this takes O(log
  /// n) time.
  /// \param vertex the index of a base vertex
  /// \throws Invalid_argument_error if the index is out of range
  Location base_vertex(std::size_t vertex) const
  {
    if(vertex >= number_of_base_vertices())
      throw Invalid_argument_error("The index of a base vertex is out of range.");
    return m_domain.outer(m_map->base().samples[vertex]);
  }

  /// Returns the number of inverted triangles. It is zero unless round-off errors invert triangles
  /// after base vertices have been added ten times.
  std::size_t number_of_flips() const { return m_map->number_of_flips(); }
  /// Returns the number of base faces whose coordinates were replaced by another kind.
  std::size_t number_of_repaired_faces() const { return m_map->number_of_repaired_regions(); }

  /// Maps a location of the mesh to the base mesh. Takes time proportional to the number of parts
  /// into which base edges divide its face. On a cloud of n surfels, the search for the closest
  /// location of the reconstructed mesh takes another O(log n).
  /// \param location a location on the surface
  /// \returns the location on the base mesh
  /// \throws Invalid_argument_error if the location is not on the surface
  Base_location operator()(const Location& location) const
  {
    return locate(internal::canonical(*m_domain.triangles(), m_domain.inner(location)));
  }
  /// Maps a vertex or surfel to the base mesh. The time is that for a location.
  /// \param vertex a vertex or surfel
  /// \returns the location on the base mesh
  /// \throws Invalid_argument_error if the vertex has no face, or if it does not belong to the
  ///         surface
  Base_location operator()(Vertex vertex) const
  {
    return locate(internal::canonical(*m_domain.triangles(), m_domain.inner_vertex(vertex)));
  }
  /// Maps a location of the base mesh to the mesh. Takes time proportional to the number of faces
  /// of the divided mesh in its base face. On a cloud of n surfels, it takes another O(log n).
  /// \param location a location on the base mesh
  /// \returns the location on the surface
  /// \throws Invalid_argument_error if the index of the base face is out of range, or if a
  ///         barycentric coordinate is negative or their sum is not one
  Location inverse(const Base_location& location) const { return m_domain.outer(inner(location)); }
  /// Maps a location of the base mesh to the point on the mesh. Takes time as `inverse()`.
  /// \param location a location on the base mesh
  /// \returns the point in space; on a cloud, a point of the reconstructed mesh
  /// \throws Invalid_argument_error as `inverse()`
  Point_3 point(const Base_location& location) const { return m_domain.point(inner(location)); }

  /// \cond INTERNAL
  // Access for other functions of this package.
  const Domain& domain() const { return m_domain; }
  const internal::Base_map& map() const { return *m_map; }
  /// \endcond

private:
  void check_face(std::size_t face) const
  {
    if(face >= number_of_base_faces())
      throw Invalid_argument_error("The index of a base face is out of range.");
  }
  Base_location locate(const internal::Surface_location& location) const
  {
    if(location.triangle == internal::none)
      throw Invalid_argument_error("An isolated vertex has no location on the base mesh.");
    const internal::Base_location found = (*m_map)(location);
    return {found.triangle, found.barycentric};
  }
  internal::Surface_location inner(const Base_location& location) const
  {
    check_face(location.face);
    const auto& b = location.barycentric;
    // The tolerance of 1e-6 admits round-off errors in the sum of three coordinates.
    if(!((std::min)({b[0], b[1], b[2]}) > -1e-6) || !(std::abs(b[0] + b[1] + b[2] - 1.) < 1e-6))
      throw Invalid_argument_error("Barycentric coordinates are negative or do not sum to one.");
    return m_map->inverse({internal::Index(location.face), b});
  }

  Domain m_domain;
  std::shared_ptr<const internal::Base_map> m_map;
};

template <typename Surface>
template <typename NamedParameters>
Base_parameterization<Surface>::Base_parameterization(const internal::Domain_of<Surface>& domain,
                                                      std::size_t number, const NamedParameters& np)
    : m_domain(domain)
{
  m_map = internal::build_base_map(
      m_domain.triangles(), internal::base_mesh_options(m_domain, number, np),
      internal::parameter(np, internal_np::base_coordinates, Base_coordinates::heron));
  if(!m_map)
    throw Cancelled();
  if(m_map->base().triangles.empty())
    throw Invalid_argument_error("The mesh has no triangles.");
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_BASE_PARAMETERIZATION_H
