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
/// Selects the computation of tangent vectors from the gradient of the squared distance at the base
/// point.
///
/// `Method` computes the distances from the base point and from a stencil of locations
/// around it.
template <typename Method = Euclidean_front>
struct Gradient
{};

/// \ingroup PkgGeodesicProcessingMethods
/// Selects the discrete exponential map \cgalCite{cgal:sgw-idcde-06}, for comparison.
///
/// Tangent vectors are sums of edge vectors along shortest edge paths. Each edge vector is
/// rotated, with the normal of its vertex, to the tangent plane of the base point. The method is
/// as fast as `Dijkstra`. Its errors do not necessarily converge to zero with the edge length.
struct Discrete_exponential
{};

/// \ingroup PkgGeodesicProcessingLogMap
/// The tangent plane in space at the base point of a logarithmic map.
template <typename Surface>
struct Tangent_frame
{
  using Point_3 = typename internal::Surface_traits<Surface>::Point_3;
  using Vector_3 = typename internal::Surface_traits<Surface>::Vector_3;

  /// The base point. On a cloud, a location with an offset is a point of a tangent plane; then this
  /// is the point of a triangle of neighboring surfels that is above or below it, in the direction
  /// of the surfel's normal.
  Point_3 origin = ORIGIN;
  Vector_3 u = NULL_VECTOR; ///< the unit vector along the first axis of the map
  Vector_3 v = NULL_VECTOR; ///< the unit vector along the second axis

  /// Returns the unit normal, the cross product of `u` and `v`. O(1).
  Vector_3 normal() const { return CGAL::cross_product(u, v); }
};

namespace internal {

// Maps a method tag to the kind of the engine.
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
/// Computes Riemannian normal coordinates around a base point, for one base point at a time.
///
/// The normal coordinates of a vertex or surfel are the tangent vector at the base point whose
/// geodesic ends there. Their norm is the geodesic distance. The cost of a computation depends on
/// the number of vertices or surfels that it reaches. Members that do not state their time take
/// O(1) time.
///
/// \tparam Surface as for `geodesic_distances()`, but not a domain
/// \tparam Method `Gradient<Method>`, `Discrete_exponential`, or on a mesh `Exact`
template <typename Surface, typename Method = Gradient<>>
class Logarithmic_map
{
  static_assert(
      !internal::Is_cloud<Surface>::value || !std::is_same_v<Method, Exact>,
      "Exact tangent vectors need a mesh, because the triangles of a cloud are not connected.");

public:
  using Domain = internal::Domain_of<Surface>;
  using Vertex = typename Domain::Vertex;
  using Location = typename Domain::Location;
  using Vector_3 = typename Domain::Vector_3;
  using Vector = std::array<double, 2>; ///< a tangent vector: components along the two axes

  /// Precomputes the domain of the surface in the time of `make_domain()`, and uses it.
  ///
  /// \param surface the surface
  /// \param np the named parameters of `make_domain()`
  /// \throws as `make_domain()`
  template <typename NamedParameters = internal::Default_parameters>
  explicit Logarithmic_map(const Surface& surface, const NamedParameters& np = NamedParameters())
      : Logarithmic_map(Domain(surface, np))
  {
    m_exponential = internal::Exponential_tracer<Domain>(
        internal::parameter(np, internal_np::number_of_threads, 1u));
  }
  /// Uses an existing `domain`, which is shared. O(n) time.
  explicit Logarithmic_map(const Domain& domain)
      : Logarithmic_map(domain, internal::Log_tag<Method>::kind)
  {}
#ifndef DOXYGEN_RUNNING
  Logarithmic_map(const Domain& domain, const internal::Log_kind& kind)
      : m_domain(domain), m_engine(kind, domain.triangles()),
        m_coordinates(domain.triangles()->number_of_vertices(), outside)
  {}
#endif

  /// Returns the domain of the surface.
  const Domain& domain() const { return m_domain; }

  /// Computes the map around a base point. The result replaces that of the last call.
  ///
  /// \tparam Place a vertex, a surfel or a location
  /// \param base a vertex, a surfel or a location
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{maximum_distance}
  ///     \cgalParamDescription{vertices or surfels farther than this distance are outside the map.
  ///       `Discrete_exponential` measures it along edge paths}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{infinity}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{up_direction}
  ///     \cgalParamDescription{a vector in space; the second axis of the map is its projection to
  ///       the tangent plane, approximately if the triangles at the base point are not in a plane}
  ///     \cgalParamType{a 3D vector of any kernel}
  ///     \cgalParamDefault{not given: in a face, the first axis points along `halfedge(face)`; at a
  ///       vertex or surfel, along any of its edges}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{stencil_length}
  ///     \cgalParamDescription{the distance from the base point to the stencil from which
  ///       `Gradient` measures distances. A longer stencil reduces both noise and detail}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{on a mesh, 0.6 to 4 mean lengths of the edges at the base point: 0.6 if
  ///       the mean angle between adjacent normals is at least a third of a radian, 4 in flat
  ///       regions. On a cloud, 2.5 mean lengths}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{stencil_size}
  ///     \cgalParamDescription{the number of locations of the stencil}
  ///     \cgalParamType{`std::size_t`}
  ///     \cgalParamDefault{8}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{number_of_smoothing_steps}
  ///     \cgalParamDescription{the number of steps, at most 1000, in which `Gradient` smooths the
  ///       squared distance maps before it differentiates them. A step replaces half of a value by
  ///       a weighted mean of the adjacent ones. It changes directions only: the length of a
  ///       vector is the distance. In the plane, exact vectors do not change. The boundary of the
  ///       map is not smoothed}
  ///     \cgalParamType{`std::size_t`}
  ///     \cgalParamDefault{0}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{number_of_base_refinements}
  ///     \cgalParamDescription{how many times, at most 8, the edges around the base point are
  ///       halved before `Gradient` computes distances on the mesh. The surface does not change.
  ///       Faces are divided up to the length of the stencil plus four mean lengths of the edges
  ///       at the base point; this margin is halved with each refinement}
  ///     \cgalParamType{`std::size_t`}
  ///     \cgalParamDefault{0}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Invalid_argument_error if the base point is an isolated vertex, a length is negative
  ///         or not a number, the stencil size is less than three, a number of steps or refinements
  ///         is too large, or the direction is normal to the surface
  /// \throws Invalid_argument_error if the base point does not belong to the surface
  /// \throws Unsupported_surface_error if `Exact` exceeds its limit of windows. Then nothing is
  ///         inside the map. After an `Invalid_argument_error` the last map remains.
  /// \throws Unsupported_surface_error if there are smoothing steps or base refinements and the
  ///         method is not `Gradient`, or if there are base refinements on a cloud. Then the last
  ///         map remains.
  ///
  /// `Gradient` takes the time of a distance computation from the base point and from each location
  /// of the stencil. A smoothing step adds O(m) time for m reached vertices or surfels, and a base
  /// refinement adds O(n) time for n vertices of the refined mesh. `Exact` takes the time of one
  /// exact computation. `Discrete_exponential` takes O(m log m) time.
  template <typename Place, typename NamedParameters = internal::Default_parameters>
  void compute(const Place& base, const NamedParameters& np = NamedParameters());

  /// \name The last computation
  /// @{

  /// Returns the tangent plane in space. If the one-ring of the base vertex is not planar, the
  /// axes are those that agree best with the incident edges.
  /// \throws Invalid_argument_error if no map was computed
  Tangent_frame<Surface> frame() const;

  /// Returns the vertices or surfels inside the map, approximately in the order of their distances.
  /// Takes linear time in their number.
  std::vector<Vertex> reached() const
  {
    std::vector<Vertex> result;
    for(const internal::Index vertex : m_reached)
      result.push_back(m_domain.vertex(vertex));
    return result;
  }
  /// Returns whether a vertex or surfel is inside the map.
  /// \param vertex a vertex or surfel of the surface
  bool is_inside(Vertex vertex) const { return std::isfinite(inner(vertex)[0]); }
  /// Returns the tangent vector of a vertex or surfel; NaN if it is outside the map.
  /// \param vertex a vertex or surfel of the surface
  Vector operator()(Vertex vertex) const
  {
    return {scale() * inner(vertex)[0], scale() * inner(vertex)[1]};
  }

  /// Returns the number of faces that are cut. A face is cut if the distance of the images of two
  /// corners exceeds four times the length of their edge. Beyond these faces, the map is not
  /// injective.
  std::size_t number_of_cut_faces() const { return m_defects.cut_triangles.size(); }
  /// Returns the number of inverted faces among the faces that are not cut.
  std::size_t number_of_flips() const { return m_defects.number_of_flips; }
  /// Calls `f(face)` for each face that is cut. It requires a mesh. Takes linear time in the
  /// number of cut faces.
  /// \tparam Function a function object
  /// \param f a function of a face descriptor
  template <typename Function>
  void for_each_cut_face(Function f) const
  {
    for(const internal::Index triangle : m_defects.cut_triangles)
      f(m_domain.face(triangle));
  }

  /// Writes the tangent vectors to a property map. The values of `uv_map` are constructed from two
  /// numbers, which are NaN outside the map. O(n).
  /// \tparam UVMap a model of `WritablePropertyMap` with vertices or surfels as keys and `Point_2`
  ///         or arrays of two numbers as values
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

  /// Returns the exponential map of a tangent vector: the endpoint of the straightest geodesic in
  /// its direction. If the geodesic meets the boundary, it ends there.
  ///
  /// On a mesh, it takes O(number of crossed faces) time. On a cloud, the geodesic is traced on a
  /// surface that is fitted to the surfels, see `straightest_geodesic()`. The first call fits the
  /// surface, in O(n log n) time. Later calls and calls of copies reuse it, and different copies
  /// can be used concurrently.
  /// \tparam TangentVector `Vector_2`, `Point_2`, or an array of two numbers
  /// \param vector the tangent vector, in the axes of `frame()`
  /// \throws Invalid_argument_error if no map was computed, or if the vector is not finite
  template <typename TangentVector = Vector>
  Location exponential(const TangentVector& vector) const
  {
    return m_exponential(m_domain, plane(), internal::tangent_vector(vector));
  }
  /// @}

  /// \cond INTERNAL
  // Access for the kernels.
  const std::vector<internal::Index>& reached_indices() const { return m_reached; }
  const std::vector<internal::Vec2>& internal_coordinates() const { return m_coordinates; }
  /// \endcond

private:
  static constexpr internal::Vec2 outside = {std::numeric_limits<double>::quiet_NaN(),
                                             std::numeric_limits<double>::quiet_NaN()};

  double scale() const { return m_domain.triangles()->scale; }
  // Returns the plane of the last map. Throws Invalid_argument_error if there was none.
  const internal::Oriented_tangent_plane& plane() const
  {
    if(!m_plane)
      throw Invalid_argument_error("Nothing was computed yet: compute() must be called before.");
    return *m_plane;
  }
  const internal::Vec2& inner(Vertex vertex) const { return m_coordinates[m_domain.index(vertex)]; }

  Domain m_domain;
  internal::Log_engine m_engine;
  std::vector<internal::Vec2> m_coordinates; // #vertices: NaN outside the map
  std::vector<internal::Index> m_reached;
  internal::Log_map_defects m_defects;
  std::optional<internal::Oriented_tangent_plane> m_plane;
  internal::Exponential_tracer<Domain> m_exponential{};
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
  options.number_of_smoothing_steps =
      parameter(np, internal_np::number_of_smoothing_steps, options.number_of_smoothing_steps);
  options.number_of_base_refinements =
      parameter(np, internal_np::number_of_base_refinements, options.number_of_base_refinements);
  if(!(options.stencil_length >= 0.))
    throw Invalid_argument_error("The length of the stencil is negative or not a number.");
  if(options.stencil_size < 3)
    throw Invalid_argument_error("The stencil must have at least 3 points.");
  m_engine.check(options);
  m_plane.emplace(internal::oriented_tangent_plane(m_domain, base, np));
  for(const internal::Index vertex : m_reached)
    m_coordinates[vertex] = outside;
  m_reached.clear();
  m_defects = {};
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
    const internal::Vec3 p = plane().plane.direction(angle - plane().rotation);
    return Vector_3(p[0], p[1], p[2]);
  };
  return {m_domain.point(plane().plane.location()), vector(0.), vector(internal::pi / 2.)};
}

/// \ingroup PkgGeodesicProcessingLogMap
///
/// Computes Riemannian normal coordinates around a base point. The normal coordinates of a vertex
/// or surfel are the tangent vector at the base point whose geodesic ends there.
///
/// \tparam Method `Gradient<Method>` (the default: `Gradient<Euclidean_front>`),
///         `Discrete_exponential`, or on a mesh `Exact`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Place a vertex, a surfel or a `Location<Surface>`
/// \tparam UVMap a model of `WritablePropertyMap` with vertices or surfels as keys and `Point_2` or
///         arrays of two numbers as values
/// \param surface the surface, as for `geodesic_distances()`
/// \param base a vertex, a surfel or a location
/// \param uv_map a writable property map that receives the tangent vectors. Its values are
///        constructed from two numbers, which are NaN outside the map
/// \param np the named parameters of `make_domain()` and `Logarithmic_map::compute()`
/// \returns the tangent plane in space
/// \throws as `Logarithmic_map::compute()`
///
/// Takes the time of `Logarithmic_map::compute()`.
template <typename Method = Gradient<>, typename Surface, typename Place, typename UVMap,
          typename NamedParameters = internal::Default_parameters>
Tangent_frame<Surface_of<Surface>> logarithmic_map(const Surface& surface, const Place& base,
                                                   UVMap uv_map,
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
