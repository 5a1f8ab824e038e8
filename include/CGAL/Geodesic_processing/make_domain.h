// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_MAKE_DOMAIN_H
#define CGAL_GEODESIC_PROCESSING_MAKE_DOMAIN_H

#include <CGAL/Geodesic_processing/Mesh_domain.h>
#include <CGAL/Geodesic_processing/Surfel_domain.h>
#include <CGAL/Geodesic_processing/internal/adaptors/number_of_threads.h>

#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL::Geodesic_processing {

namespace internal {

template <typename Surface>
using Domain_of =
    std::conditional_t<Is_cloud<Surface>::value, Surfel_domain<Surface>, Mesh_domain<Surface>>;

} // namespace internal

/// \ingroup PkgGeodesicProcessingDomain
///
/// Constructs a domain: the preprocessed form of a surface, for any number of calls. It can be
/// passed to functions instead of the surface.
///
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default), or `CGAL::Parallel_tag` for
///         several threads on a cloud. The results are identical.
/// \tparam Surface a model of `FaceListGraph`, all of whose faces are triangles, or of
///         `SurfelRange`
/// \param surface a mesh or a cloud
/// \param np named parameters of `Mesh_domain` or `Surfel_domain`. With `CGAL::Parallel_tag`, the
///        default of `number_of_threads` is the number of hardware threads.
/// \returns a `Mesh_domain` or a `Surfel_domain`
/// \throws as the constructors of `Mesh_domain` and `Surfel_domain`
///
/// O(n) for a mesh of n vertices, O(n log n) for a cloud of n surfels.
template <typename Concurrency_tag = Sequential_tag, typename Surface,
          typename NamedParameters = internal::Default_parameters,
          std::enable_if_t<internal::is_named_parameters<NamedParameters>, int> = 0>
internal::Domain_of<Surface> make_domain(const Surface& surface,
                                         const NamedParameters& np = NamedParameters())
{
  if constexpr(std::is_same_v<Concurrency_tag, Sequential_tag>)
    return internal::Domain_of<Surface>(surface, np);
  else
    return internal::Domain_of<Surface>(
        surface,
        internal::chain(np).number_of_threads(internal::number_of_threads<Concurrency_tag>(np)));
}

/// \ingroup PkgGeodesicProcessingDomain
///
/// Returns the domain itself, so that functions accept both. O(1).
///
/// \tparam Concurrency_tag has no effect
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \param domain a domain
/// \returns a copy that shares the data
template <typename Concurrency_tag = Sequential_tag, typename TriangleMesh,
          typename NamedParameters = internal::Default_parameters>
Mesh_domain<TriangleMesh> make_domain(const Mesh_domain<TriangleMesh>& domain,
                                      const NamedParameters& = NamedParameters())
{
  return domain;
}

/// \ingroup PkgGeodesicProcessingDomain
///
/// Returns the domain itself, so that functions accept both. O(1).
///
/// \tparam Concurrency_tag has no effect
/// \tparam SurfelRange a model of the concept `SurfelRange`
/// \param domain a domain
/// \returns a copy that shares the data
template <typename Concurrency_tag = Sequential_tag, typename SurfelRange,
          typename NamedParameters = internal::Default_parameters>
Surfel_domain<SurfelRange> make_domain(const Surfel_domain<SurfelRange>& domain,
                                       const NamedParameters& = NamedParameters())
{
  return domain;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_MAKE_DOMAIN_H
