// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_TRACE_ON_CLOUD_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_TRACE_ON_CLOUD_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/paths/Cloud_tracer.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Fits a surface to the surfels of a domain, with the radii of the domain.  O(n log n).
template <typename Domain>
Cloud_tracer make_cloud_tracer(const Domain& domain, unsigned number_of_threads)
{
  const Surfel_arrays& surfels = domain.surfels();
  const Surface_arrays& t = surfels.arrays;
  const std::size_t n = surfels.internal_vertex.size();
  std::vector<Vec3> points(n), normals(n);
  std::vector<double> radii(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    const Index vertex = surfels.internal_vertex[i];
    points[i] = t.origin + t.scale * t.point[vertex];
    normals[i] = t.normal[vertex];
    radii[i] = t.scale * surfels.radius[vertex];
  }
  return Cloud_tracer(std::move(points), std::move(normals), radii, number_of_threads);
}

// Converts a surfel or a location of the caller to a location of a tracer.  Throws
// Invalid_argument_error if the surfel is not in the cloud or the offset is not finite.
template <typename Domain, typename SurfelOrLocation>
Tangent_location traced_location(const Domain& domain, const SurfelOrLocation& element)
{
  const auto position = [&](const typename Domain::Vertex& surfel)
  { return domain.surfels().caller_vertex[domain.inner_vertex(surfel).vertex]; };
  if constexpr(std::is_same_v<SurfelOrLocation, typename Domain::Location>)
  {
    if(!std::isfinite(element.offset[0]) || !std::isfinite(element.offset[1]))
      throw Invalid_argument_error("The offset of a location is not finite.");
    return {position(element.surfel), element.offset};
  }
  else
    return {position(element), {0., 0.}};
}

// Converts a location of a tracer to a location of the caller.
template <typename Domain>
typename Domain::Location outer_location(const Domain& domain, const Tangent_location& location)
{
  return {domain.vertex(domain.surfels().internal_vertex[location.vertex]), location.offset};
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_TRACE_ON_CLOUD_H
