// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_LOGARITHMIC_MAP_H
#define CGAL_GEODESIC_PROCESSING_LOGARITHMIC_MAP_H

#include <CGAL/Geodesic_processing/internal/log_map/Log_engine.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/planar_value.h>
#include <CGAL/Geodesic_processing/internal/adaptors/oriented_tangent_plane.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Origin.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingMethods
/// chooses tangent vectors by the gradient of squared distances from their base.
///
/// Distances are measured from the base and from a few places around it; by `Distance_method`.
template <typename Distance_method = Euclidean_front>
struct Gradient
{};

/// \ingroup PkgGeodesicProcessingMethods
/// chooses tangent vectors by the discrete exponential map \cgalCite{cgal:sgw-idcde-06}, for comparison.
///
/// Along shortest chains of edges each step is turned, with the normal of its vertex, to the tangent plane of the
/// base and added; as quick as `Dijkstra`.  Errors need not get smaller with the edges.
struct Discrete_exponential
{};

/// \ingroup PkgGeodesicProcessingLogMap
/// the tangent plane at the base of a logarithmic map, in space.
template <typename Surface>
struct Tangent_frame
{
  using Point_3 = typename internal::Surface_traits<Surface>::Point_3;
  using Vector_3 = typename internal::Surface_traits<Surface>::Vector_3;

  Point_3 origin = ORIGIN;
  Vector_3 u = NULL_VECTOR, v = NULL_VECTOR; ///< unit vectors along the axes of the map

  Vector_3 normal() const { return CGAL::cross_product(u, v); }
};

namespace internal {

// The engine that a tag stands for.
template <typename Method>
struct Log_tag;
template <typename Method>
struct Log_tag<Gradient<Method>>
{
  static constexpr Log_kind kind = {Log_method::gradient, distance_method<Method>()};
};
template <>
struct Log_tag<Exact>
{
  static constexpr Log_kind kind = {Log_method::exact};
};
template <>
struct Log_tag<Discrete_exponential>
{
  static constexpr Log_kind kind = {Log_method::discrete_exponential};
};

} // namespace internal

/// \ingroup PkgGeodesicProcessingLogMap
///
/// Riemannian normal coordinates around a place, one base after the other: of each site the tangent
/// vector whose geodesic leads there, as long as the distance.
///
/// What a computation costs depends on the sites that it reaches.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
/// \tparam Method `Gradient<Distance_method>`, `Discrete_exponential`, or on a mesh `Exact`
template <typename Surface, typename Method = Gradient<>>
class Logarithmic_map
{
  static_assert(!internal::Is_cloud<Surface>::value || !std::is_same_v<Method, Exact>,
                "Exact tangent vectors need a mesh; a surfel cloud has no edges to cross.");

public:
  using Domain = internal::Domain_of<Surface>;
  using Vertex = typename Domain::Vertex;
  using Location = typename Domain::Location;
  using Vector_3 = typename Domain::Vector_3;
  using Vector = std::array<double, 2>;

  /// prepares the surface; `np` is what `make_domain()` takes.
  template <typename NamedParameters = internal::Default_parameters>
  explicit Logarithmic_map(const Surface& surface, const NamedParameters& np = NamedParameters())
      : Logarithmic_map(Domain(surface, np))
  {}
  explicit Logarithmic_map(const Domain& domain)
      : Logarithmic_map(domain, internal::Log_tag<Method>::kind)
  {}
#ifndef DOXYGEN_RUNNING
  Logarithmic_map(const Domain& domain, const internal::Log_kind& kind)
      : m_domain(domain), m_engine(kind, domain.triangles()),
        m_coordinates(domain.triangles()->number_of_vertices(), outside)
  {}
#endif

  const Domain& domain() const { return m_domain; }

  /// computes the map around a site or a location; what the last call found is forgotten.
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{maximum_distance} \cgalParamDescription{sites farther away, of
  ///     `Discrete_exponential` by chains of edges, are outside}
  ///     \cgalParamDefault{infinity} \cgalParamNEnd
  ///   \cgalParamNBegin{up_direction} \cgalParamDescription{a vector in space, along whose part in the
  ///     tangent plane the second axis points} \cgalParamDefault{the first axis runs along the first
  ///     edge of the base} \cgalParamNEnd
  ///   \cgalParamNBegin{stencil_length} \cgalParamDescription{how far from the base `Gradient` measures
  ///     distances as well: the farther, the less noise and detail}
  ///     \cgalParamDefault{from 0.6 mean lengths of the edges there, where they bend by a third or more,
  ///     to 4 where it is flat; on a cloud 2.5} \cgalParamNEnd
  ///   \cgalParamNBegin{stencil_size} \cgalParamDescription{from how many places}
  ///     \cgalParamDefault{8} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Invalid_argument_error when the base is an isolated vertex, a length is negative or not a
  ///         number, the stencil is smaller than three, or the direction is normal to the surface
  template <typename Place, typename NamedParameters = internal::Default_parameters>
  void compute(const Place& base, const NamedParameters& np = NamedParameters());

  /// \name The last computation
  /// @{

  /// the tangent plane in space.  Around a vertex that is no plane its axes are those that agree best
  /// with the edges.
  Tangent_frame<Surface> frame() const;

  /// returns the sites inside, nearly in the order of their distances.
  std::vector<Vertex> reached() const
  {
    std::vector<Vertex> result;
    for(const internal::Index vertex : m_reached)
      result.push_back(m_domain.vertex(vertex));
    return result;
  }
  bool is_inside(Vertex vertex) const { return std::isfinite(inner(vertex)[0]); }
  /// returns the tangent vector of a site; not a number outside.
  Vector operator()(Vertex vertex) const
  {
    return {scale() * inner(vertex)[0], scale() * inner(vertex)[1]};
  }

  /// returns how many faces are cut: the images of two corners are four times as far apart as the
  /// corners.  Behind these the map is no longer one to one.
  std::size_t number_of_cut_faces() const { return m_defects.cut_triangles.size(); }
  /// returns how many of the others are turned round.
  std::size_t number_of_folded_faces() const { return m_defects.number_of_folded; }
  /// calls `f(face)` for each face that is cut; on a mesh.
  template <typename Function>
  void for_each_cut_face(Function f) const
  {
    for(const internal::Index triangle : m_defects.cut_triangles)
      f(m_domain.face(triangle));
  }

  /// writes the tangent vectors: values of `uv_map` are made of two numbers, which are not numbers outside.
  template <typename UVMap>
  void write(UVMap uv_map) const
  {
    using Value = typename boost::property_traits<UVMap>::value_type;
    m_domain.write(
        [&](internal::Index vertex)
        {
          return internal::planar_value<Value>(scale() * m_coordinates[vertex][0],
                                               scale() * m_coordinates[vertex][1]);
        },
        uv_map);
  }

  /// returns the place to which a tangent vector leads, straight on: the exponential map.  Where it meets
  /// a border, the place there.  On a mesh.
  /// \throws Invalid_argument_error when the vector is not finite
  Location exponential(const Vector& vector) const
  {
    return internal::exponential(m_domain, *m_plane, vector);
  }
  /// @}

  /// \name Between the map and the kernels
  /// @{
  const std::vector<internal::Index>& reached_indices() const { return m_reached; }
  const std::vector<internal::Vec2>& internal_coordinates() const { return m_coordinates; }
  /// @}

private:
  static constexpr internal::Vec2 outside = {std::numeric_limits<double>::quiet_NaN(),
                                             std::numeric_limits<double>::quiet_NaN()};

  double scale() const { return m_domain.triangles()->scale; }
  const internal::Vec2& inner(Vertex vertex) const { return m_coordinates[m_domain.index(vertex)]; }

  Domain m_domain;
  internal::Log_engine m_engine;
  std::vector<internal::Vec2> m_coordinates; // #sites
  std::vector<internal::Index> m_reached;
  internal::Log_map_defects m_defects;
  std::optional<internal::Oriented_tangent_plane> m_plane;
};

template <typename Surface, typename Method>
template <typename Place, typename NamedParameters>
void Logarithmic_map<Surface, Method>::compute(const Place& base, const NamedParameters& np)
{
  using internal::parameter;
  internal::Log_map_options options;
  options.maximum_distance = internal::limits(m_domain, np).maximum_distance;
  options.stencil_length = parameter(np, internal_np::stencil_length, 0.) / scale();
  options.stencil_size = parameter(np, internal_np::stencil_size, options.stencil_size);
  if(!(options.stencil_length >= 0.))
    throw Invalid_argument_error("The length of the stencil is negative or not a number.");
  if(options.stencil_size < 3)
    throw Invalid_argument_error("A stencil has three places or more.");
  m_plane.emplace(internal::oriented_tangent_plane(m_domain, base, np));
  for(const internal::Index vertex : m_reached)
    m_coordinates[vertex] = outside;
  m_reached.clear();
  const internal::Vec2 turn = {std::cos(m_plane->rotation), std::sin(m_plane->rotation)};
  m_engine.run(m_plane->plane, options,
               [&](internal::Index vertex, const internal::Vec2& vector)
               {
                 m_reached.push_back(vertex);
                 m_coordinates[vertex] = internal::rotated(vector, turn);
               });
  m_defects = internal::find_map_defects(*m_domain.triangles(), m_reached, m_coordinates);
}

template <typename Surface, typename Method>
Tangent_frame<Surface> Logarithmic_map<Surface, Method>::frame() const
{
  const auto vector = [&](double angle)
  {
    const internal::Vec3 p = m_plane->plane.direction(angle - m_plane->rotation);
    return Vector_3(p[0], p[1], p[2]);
  };
  return {m_domain.point(m_plane->plane.location()), vector(0.), vector(internal::pi / 2.)};
}

/// \ingroup PkgGeodesicProcessingLogMap
///
/// computes Riemannian normal coordinates around a place: of each vertex or surfel the tangent vector whose
/// geodesic leads there.
///
/// \tparam Method `Gradient<Distance_method>` (the default: `Gradient<Euclidean_front>`),
///         `Discrete_exponential`, or on a mesh `Exact`
/// \param surface as for `geodesic_distances()`
/// \param base a site or a location
/// \param uv_map receives tangent vectors: values are made of two numbers, which are not numbers outside
/// \param np what `make_domain()` takes, and `Logarithmic_map::compute()`
/// \returns the tangent plane in space
/// \throws as `Logarithmic_map::compute()`
template <typename Method = Gradient<>, typename Surface, typename Place, typename UVMap,
          typename NamedParameters = internal::Default_parameters>
auto logarithmic_map(const Surface& surface, const Place& base, UVMap uv_map,
                     const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  Logarithmic_map<typename decltype(domain)::Surface, Method> map(domain);
  map.compute(base, np);
  map.write(uv_map);
  return map.frame();
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_LOGARITHMIC_MAP_H
