// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_MASSES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_MASSES_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/transport/Multilevel_transport_solver.h>
#include <CGAL/Geodesic_processing/internal/adaptors/field_vectors.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/core/slowness.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/mass_density.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

template <typename T>
struct Is_density : std::false_type
{};
template <typename PropertyMap>
struct Is_density<Mass_density<PropertyMap>> : std::true_type
{};

// Detects property maps by their category, since std::set also has a key_type and a value_type.
template <typename T, typename = void>
struct Is_property_map : std::false_type
{};
template <typename T>
struct Is_property_map<T, std::void_t<typename boost::property_traits<T>::category>>
    : std::true_type
{};

// #vertices: returns the values of a property map in the internal order of the domain.
template <typename Domain, typename PropertyMap>
Vector vertex_values(const Domain& domain, const PropertyMap& map)
{
  Vector result(Eigen::Index(domain.number_of_vertices()));
  for(Index i = 0; i < domain.number_of_vertices(); ++i)
    result[i] = to_double(get(map, domain.vertex(i)));
  return result;
}

// Converts a vertex or location (unit mass), a range of these (unit mass in equal fractions), a
// property map of masses, or a Mass_density. Throws Invalid_argument_error if a range is empty
// or a location is invalid.
template <typename Domain, typename From>
Mass_distribution masses(const Domain& domain, const From& from)
{
  Mass_distribution result;
  if constexpr(std::is_same_v<From, Mass_distribution>)
    return from;
  else if constexpr(names_location<Domain, From>)
    result.at_locations.emplace_back(location(domain, from), 1.);
  else if constexpr(Is_density<From>::value)
    result.density = vertex_values(domain, from.map);
  else if constexpr(Is_property_map<From>::value)
    result.at_vertices = vertex_values(domain, from);
  else
  {
    static_assert(
        names_location<Domain, Element_of<From>>,
        "A mass is a vertex, a surfel, a location, a range of these, a property map, or a "
        "Mass_density. CGAL::make_property_map() makes a map of a vector of masses.");
    const std::vector<Surface_location> located = locations(domain, from);
    if(located.empty())
      throw Invalid_argument_error("A range of locations for a mass is empty.");
    for(const Surface_location& point : located)
      result.at_locations.emplace_back(point, 1. / double(located.size()));
  }
  return result;
}

// Returns the square root of a symmetric positive definite tensor.
inline Metric_tensor square_root(const Metric_tensor& a)
{
  const double determinant = std::sqrt(a[0] * a[2] - a[1] * a[1]);
  const double factor = 1. / std::sqrt(a[0] + a[2] + 2. * determinant);
  return {factor * (a[0] + determinant), factor * a[1], factor * (a[2] + determinant)};
}

// Restricts a metric in space to the planes of the triangles and multiplies the kernels' metric by
// its square root.
//
// metric: returns the metric of a triangle as an `Eigen::Matrix3d`
// result: #triangles, or empty for the identity
//
// Throws Invalid_argument_error if a tensor is not positive definite. O(n).
template <typename Metric>
void multiply_by_metric(const Surface_arrays& t, const Metric& metric,
                        std::vector<Metric_tensor>& result)
{
  result.resize(t.number_of_triangles(), {1., 0., 1.});
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const auto [u, v] = axes(t, f);
    if(v == Vec3{0., 0., 0.})
      continue;
    const Eigen::Matrix3d tensor = metric(f);
    const auto product = [&tensor](const Vec3& a, const Vec3& b)
    {
      using Eigen_vector = Eigen::Map<const Eigen::Vector3d>;
      return Eigen_vector(a.data()).dot(tensor * Eigen_vector(b.data()));
    };
    const Metric_tensor squared = {product(u, u), product(u, v), product(v, v)};
    if(!(squared[0] > 0. && squared[0] * squared[2] > squared[1] * squared[1]) ||
       !std::isfinite(squared[0] + squared[2]))
      throw Invalid_argument_error("A metric is not positive definite.");
    const double slowness = result[f][0];
    result[f] = square_root(squared);
    for(double& entry : result[f])
      entry *= slowness;
  }
}

// Multiplies the kernels' metric by the metrics of vertices or surfels; see multiply_by_metric().
// An empty optional stands for no map.
template <typename Domain, typename MetricMap>
void multiply_by_vertex_metric(const Domain& domain, const MetricMap& map,
                               std::vector<Metric_tensor>& result)
{
  static_assert(is_keyed_by<MetricMap, typename Domain::Vertex>,
                "metric_map is a property map with vertices or surfels as keys. Pass metrics of "
                "faces as face_metric_map.");
  const Surface_arrays& t = *domain.triangles();
  const auto mean_metric = [&](Index triangle)
  {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for(std::size_t k = 0; k < 3; ++k)
      sum += get(map, domain.vertex(t.corner[3 * std::size_t(triangle) + k]));
    return Eigen::Matrix3d(sum / 3.);
  };
  multiply_by_metric(t, mean_metric, result);
}
template <typename Domain, typename MetricMap>
void multiply_by_vertex_metric(const Domain& domain, const std::optional<MetricMap>& map,
                               std::vector<Metric_tensor>& result)
{
  if(map)
    multiply_by_vertex_metric(domain, *map, result);
}

// As multiply_by_vertex_metric(), for metrics of faces.
template <typename Domain, typename FaceMetricMap>
void multiply_by_face_metric(const Domain& domain, const FaceMetricMap& map,
                             std::vector<Metric_tensor>& result)
{
  using Surface = typename Domain::Surface;
  static_assert(!Is_cloud<Surface>::value,
                "A cloud has no faces; pass metrics of surfels as metric_map.");
  static_assert(is_keyed_by<FaceMetricMap, typename boost::graph_traits<Surface>::face_descriptor>,
                "face_metric_map is a property map with faces as keys. Pass metrics of vertices as "
                "metric_map.");
  multiply_by_metric(
      *domain.triangles(), [&](Index triangle) { return get(map, domain.face(triangle)); }, result);
}
template <typename Domain, typename FaceMetricMap>
void multiply_by_face_metric(const Domain& domain, const std::optional<FaceMetricMap>& map,
                             std::vector<Metric_tensor>& result)
{
  if(map)
    multiply_by_face_metric(domain, *map, result);
}

// #triangles: returns the tensors A of the kernels' metric, by which lengths of vectors v are
// |A v|, from the named parameters of speeds and metrics; empty if all are missing. A is the
// square root of the metric divided by the speed. Metrics of vertices and of faces can both be
// passed as optionals if at most one of them has a value. Throws Invalid_argument_error if a speed
// is invalid or a metric is not positive definite. O(n).
template <typename Domain, typename NamedParameters>
std::vector<Metric_tensor> read_metric(const Domain& domain, const NamedParameters& np)
{
  constexpr bool at_vertices = has_parameter<NamedParameters, internal_np::metric_map_t>;
  constexpr bool in_faces = has_parameter<NamedParameters, internal_np::face_metric_map_t>;
  std::vector<Metric_tensor> result;
  if(const auto slowness = read_slowness(domain, np))
    for(const double slow : *slowness)
      result.push_back({slow, 0., slow});
  [[maybe_unused]] auto vertex_metric = parameter(np, internal_np::metric_map, none);
  [[maybe_unused]] auto face_metric = parameter(np, internal_np::face_metric_map, none);
  static_assert(!(at_vertices && in_faces) ||
                    (is_optional<decltype(vertex_metric)> && is_optional<decltype(face_metric)>),
                "Pass metric_map or face_metric_map, not both.");
  if constexpr(at_vertices)
    multiply_by_vertex_metric(domain, vertex_metric, result);
  if constexpr(in_faces)
    multiply_by_face_metric(domain, face_metric, result);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_MASSES_H
