// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_STRAIGHTEST_GEODESIC_H
#define CGAL_GEODESIC_PROCESSING_STRAIGHTEST_GEODESIC_H

#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/paths/trace_straightest.h>
#include <CGAL/Geodesic_processing/make_domain.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
/// A straightest geodesic, and whether it reached the boundary before it had the requested length.
template <typename Surface>
struct Straightest_geodesic : Surface_path<Surface>
{
  bool is_cut_by_boundary = false;
};

/// \ingroup PkgGeodesicProcessingPaths
///
/// Traces the straightest geodesic on a triangle mesh from a location in a direction.  Its endpoint
/// is the exponential map.
///
/// Faces are unfolded one after the other.  If the path hits a vertex, it continues with equal
/// angles on both sides. \cgalCite{cgal:ps-sgps-98}  If it reaches a boundary edge, or
/// a boundary vertex that it cannot pass, it ends there.
///
/// \tparam Mesh a model of `FaceListGraph`, or its domain
/// \tparam QueryLocation a vertex or a `Location<Mesh>`
/// \tparam Vector a 3D vector of any kernel
/// \param mesh a model of `FaceListGraph` or a `Mesh_domain`; clouds are not supported
/// \param from a vertex or a location
/// \param direction a vector in space, which is projected to the plane of the face of `from`.  At a
///        vertex, it is the incident face that contains the projected direction.  If several do,
///        the face whose plane is closest to the direction is used
/// \param length the length of the path, finite and not negative
/// \param np the named parameters of `make_domain()`
/// \returns the path; its `length` is smaller than the requested length only if it ends at the
///          boundary
/// \throws Invalid_argument_error if the direction is normal to the plane, or if the length is
///         invalid
///
/// O(number of crossed faces) time after `make_domain()`.
template <typename Mesh, typename QueryLocation, typename Vector,
          typename NamedParameters = internal::Default_parameters>
Straightest_geodesic<Surface_of<Mesh>>
straightest_geodesic(const Mesh& mesh, const QueryLocation& from, const Vector& direction,
                     double length, const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(mesh, np);
  using Surface = typename decltype(domain)::Surface;
  static_assert(
      !internal::Is_cloud<Surface>::value,
      "Straightest geodesics require a mesh, because the triangles of a cloud are not connected.");
  const internal::Surface_arrays& t = *domain.triangles();
  const internal::Straightest_path path = internal::trace_straightest_in_space(
      t, internal::location(domain, from),
      {CGAL::to_double(direction.x()), CGAL::to_double(direction.y()),
       CGAL::to_double(direction.z())},
      length / t.scale);
  Straightest_geodesic<Surface> result{
      internal::surface_path(domain, path.locations, t.scale * path.length)};
  result.length = t.scale * path.length;
  result.is_cut_by_boundary = path.end == internal::Straightest_path_end::boundary;
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_STRAIGHTEST_GEODESIC_H
