// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ORIENTED_TANGENT_PLANE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ORIENTED_TANGENT_PLANE_H

#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/log_map/tangent_plane.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/Origin.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

// The tangent plane at the base point of a logarithmic map, and the angle by which the axes of the
// map are rotated in it.
struct Oriented_tangent_plane
{
  Tangent_plane plane;
  double rotation = 0.;
};

template <typename Domain, typename VertexOrLocation, typename NamedParameters>
Oriented_tangent_plane oriented_tangent_plane(const Domain& domain, const VertexOrLocation& base,
                                              const NamedParameters& np)
{
  Oriented_tangent_plane result{Tangent_plane(*domain.triangles(), location(domain, base))};
  if constexpr(has_parameter<NamedParameters, internal_np::up_direction_t>)
  {
    using Vector_3 = typename Domain::Vector_3;
    const auto up = parameter(np, internal_np::up_direction, Vector_3(NULL_VECTOR));
    result.rotation =
        pi / 2. - result.plane.tangent_angle(Vec3{CGAL::to_double(up.x()), CGAL::to_double(up.y()),
                                                  CGAL::to_double(up.z())});
  }
  return result;
}

template <typename Domain>
typename Domain::Location exponential(const Domain& domain, const Oriented_tangent_plane& at,
                                      const std::array<double, 2>& vector)
{
  static_assert(!Is_cloud<typename Domain::Surface>::value,
                "The exponential map requires a mesh: it traces straightest geodesics.");
  const double angle = std::atan2(vector[1], vector[0]) - at.rotation;
  const double length = std::hypot(vector[0], vector[1]) / domain.triangles()->scale;
  return domain.outer(at.plane.straightest_path(angle, length).locations.back());
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ORIENTED_TANGENT_PLANE_H
