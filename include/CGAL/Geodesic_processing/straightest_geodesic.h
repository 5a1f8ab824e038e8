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
/// a straightest geodesic, and whether it met a border before it had the length asked for.
template <typename Surface>
struct Straightest_geodesic : Surface_path<Surface>
{
  bool is_cut_by_boundary = false;
};

/// \ingroup PkgGeodesicProcessingPaths
///
/// goes straight on from a place of a triangle mesh in a direction: the exponential map.
///
/// Faces are unfolded one after the other; a vertex that is hit is left with equal angles on both sides.
/// \cgalCite{cgal:ps-sgps-98}  At a border it ends.
///
/// \param mesh a model of `FaceListGraph` or a `Mesh_domain`; a cloud has no straight lines
/// \param from a vertex or a location
/// \param direction is projected to the plane of the face of `from` (of a vertex: of its face whose plane
///        is the nearest to it)
/// \param length how far to go, finite and not negative
/// \returns the path; its `length` is smaller than asked for only at a border
/// \throws Invalid_argument_error when the direction has no part in the plane, or the length is not usable
///
/// O(number of faces crossed) after `make_domain()`.
template <typename Mesh, typename QueryLocation, typename Vector,
          typename NamedParameters = internal::Default_parameters>
auto straightest_geodesic(const Mesh& mesh, const QueryLocation& from, const Vector& direction,
                          double length, const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(mesh, np);
  using Surface = typename decltype(domain)::Surface;
  static_assert(!internal::Is_cloud<Surface>::value,
                "straightest_geodesic: a surfel cloud is not a manifold; go on a mesh.");
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
