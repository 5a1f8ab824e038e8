// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ORIENTED_TANGENT_PLANE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ORIENTED_TANGENT_PLANE_H

#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/adaptors/trace_on_cloud.h>
#include <CGAL/Geodesic_processing/internal/log_map/tangent_plane.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/Origin.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>

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

template <typename T, typename = void>
inline constexpr bool has_z = false;
template <typename T>
inline constexpr bool has_z<T, std::void_t<decltype(std::declval<const T&>().z())>> = true;

// Reads a vector of the tangent plane. Throws Invalid_argument_error if it is not finite.
template <typename TangentVector>
std::array<double, 2> tangent_vector(const TangentVector& vector)
{
  static_assert(!has_z<TangentVector>,
                "A tangent vector has two components, along the axes of Tangent_frame. "
                "straightest_geodesic() accepts directions in space.");
  const std::array<double, 2> result = {CGAL::to_double(vector[0]), CGAL::to_double(vector[1])};
  if(!std::isfinite(std::hypot(result[0], result[1])))
    throw Invalid_argument_error("A tangent vector is not finite.");
  return result;
}

// Computes the exponential map. On a mesh, it traces straightest geodesics on the triangles.
template <typename Domain, bool is_cloud = Is_cloud<typename Domain::Surface>::value>
class Exponential_tracer
{
public:
  explicit Exponential_tracer(unsigned = 1) {}

  // Returns the endpoint of the geodesic with a finite tangent vector, in the caller's unit.
  typename Domain::Location operator()(const Domain& domain, const Oriented_tangent_plane& at,
                                       const std::array<double, 2>& vector) const
  {
    const double angle = std::atan2(vector[1], vector[0]) - at.rotation;
    const double length = std::hypot(vector[0], vector[1]) / domain.triangles()->scale;
    return domain.outer(at.plane.straightest_path(angle, length).locations.back());
  }
};

// On a cloud, it traces geodesics on the fitted surface. The surface is fitted at the first call;
// copies share it and can be used concurrently.
template <typename Domain>
class Exponential_tracer<Domain, true>
{
public:
  explicit Exponential_tracer(unsigned number_of_threads = 1)
      : m_shared(std::make_shared<Shared>()), m_number_of_threads(number_of_threads)
  {}

  typename Domain::Location operator()(const Domain& domain, const Oriented_tangent_plane& at,
                                       const std::array<double, 2>& vector) const
  {
    const double angle = std::atan2(vector[1], vector[0]) - at.rotation;
    const Traced_path path =
        tracer(domain)(traced_location(domain, domain.outer(at.plane.location())),
                       at.plane.direction(angle), std::hypot(vector[0], vector[1]));
    return outer_location(domain, path.locations.back());
  }

private:
  struct Shared
  {
    std::mutex mutex;
    std::optional<Cloud_tracer> tracer;
  };

  const Cloud_tracer& tracer(const Domain& domain) const
  {
    const std::lock_guard lock(m_shared->mutex);
    if(!m_shared->tracer)
      m_shared->tracer = make_cloud_tracer(domain, m_number_of_threads);
    return *m_shared->tracer;
  }

  std::shared_ptr<Shared> m_shared;
  unsigned m_number_of_threads;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ORIENTED_TANGENT_PLANE_H
