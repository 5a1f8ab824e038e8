// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_SOLVER_H

#include <CGAL/Geodesic_processing/Source.h>
#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/method.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <CGAL/Origin.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
/// The departure of the shortest path to a location from its source: the location's coordinates in
/// the exact logarithmic map.
template <typename Surface>
struct Geodesic_departure
{
  using Location = typename internal::Surface_traits<Surface>::Location;
  using Vector_3 = typename internal::Surface_traits<Surface>::Vector_3;

  Location from;                    ///< the starting point on the source
  Vector_3 direction = NULL_VECTOR; ///< unit vector; zero if there is no path or its length is zero
  /// The polar angle of the direction around `from`, in radians, counterclockwise. The reference
  /// direction is the same for all departures from `from`.
  double polar_angle = 0.;
  /// The length of the path, without the offset of the source; infinite if there is no path.
  double length = internal::infinity;
};

/// \ingroup PkgGeodesicProcessingDistances
///
/// Computes geodesic distances for many queries on one surface.
///
/// The cost of a query depends on the number of vertices or surfels that it reaches, not on the
/// size of the surface. `Heat` is an exception: each of its queries is global. Copies share the
/// domain, and different copies can compute concurrently. Together with the result, and in addition
/// to the domain, a solver on a mesh takes about 30 bytes per vertex with `Dijkstra`, 55 to 165
/// with `Fast_marching`, 45 to 325 with `Euclidean_front`, and 80 to 130 with `Exact`. On meshes of
/// up to 4 million vertices, a solver stores more data after some queries on the whole surface,
/// which speed up later ones: 300 to 350 bytes per vertex in addition with `Fast_marching`, and 100
/// in addition with `Euclidean_front`. On a cloud a solver takes 28 bytes per surfel, or 47 with
/// `Euclidean_front`. There, queries after the construction only access the surfels that they reach
/// and those adjacent to them, and allocate O(m) memory for m reached surfels.
///
/// Before the first computation, no vertex or surfel is reached. Members that write a property map
/// take O(n) time. Other members that do not state their time take O(1) time.
///
/// \tparam Surface as for `geodesic_distances()`, but not a domain
/// \tparam Method as for `geodesic_distances()`
template <typename Surface, typename Method = Automatic>
class Geodesic_distance_solver
{
  static_assert(!internal::Is_cloud<Surface>::value || !std::is_same_v<Method, Exact>,
                "Exact distances need a mesh, because the triangles of a cloud are not connected.");

public:
  using Domain = internal::Domain_of<Surface>;
  using Vertex = typename Domain::Vertex;
  using Location = typename Domain::Location;

  /// Precomputes the domain of the surface in the time of `make_domain()`, and uses it.
  ///
  /// \param surface the surface
  /// \param np the named parameters of `make_domain()`, and
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{method}
  ///     \cgalParamDescription{the method, if `Method` is `Runtime_method`; otherwise the call does
  ///       not compile}
  ///     \cgalParamType{`Distance_method`}
  ///     \cgalParamDefault{`Distance_method::automatic`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{heat_time_step}
  ///     \cgalParamDescription{the time step of `Heat` in squared mean edge lengths, positive.
  ///       Larger steps result in smoother and less accurate distances. Its square root is at least
  ///       w/600 and at most 10 w, where the width w is an upper bound of the diameter of all
  ///       components}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{1}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a function that `Heat` calls with 0 before each of its two
  ///       factorizations and the steps before them; if it returns false, the constructor throws
  ///       `Cancelled`. A factorization cannot be interrupted}
  ///     \cgalParamType{`std::function<bool(double)>`}
  ///     \cgalParamDefault{no callback}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws as `make_domain()`; `Heat` also throws `Unsupported_surface_error` if the surface is
  ///         empty
  /// \throws Invalid_argument_error if the time step is not positive and finite
  /// \throws Unsupported_surface_error if a time step is given and the method is not `Heat`, or if
  ///         `method` is `Distance_method::exact` and the surface is a cloud
  template <typename NamedParameters = internal::Default_parameters>
  explicit Geodesic_distance_solver(const Surface& surface,
                                    const NamedParameters& np = NamedParameters())
      : Geodesic_distance_solver(Domain(surface, np), np)
  {}
  /// Uses an existing `domain`, which is shared. The fronts on a mesh copy its one-rings in O(n)
  /// time. `Heat` factorizes two matrices, each in about O(n<SUP>1.5</SUP>) time. `np` is as for a
  /// surface.
  /// \throws as for a surface, except for the exceptions of `make_domain()`
  template <typename NamedParameters = internal::Default_parameters>
  explicit Geodesic_distance_solver(const Domain& domain,
                                    const NamedParameters& np = NamedParameters())
      : m_domain(domain),
        m_engine(internal::read_method<Method>(np), domain.triangles(),
                 internal::read_heat_time_step(np), internal::read_throwing_callback(np))
  {}

  /// Returns the domain of the surface.
  const Domain& domain() const { return m_domain; }

  /// Computes distances to the nearest source. The result replaces that of the last call.
  ///
  /// \tparam Sources a vertex, a surfel, a location, a `Source`, or a range of one of these
  /// \param sources a vertex, a surfel, a location, a `Source`, or a non-empty range of one of
  ///        these
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{maximum_distance}
  ///     \cgalParamDescription{vertices or surfels farther than this distance are not reached}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{infinity}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{targets}
  ///     \cgalParamDescription{a vertex, a surfel, a location, or a range of them: the computation
  ///       can stop as soon as their distances are final}
  ///     \cgalParamType{a vertex, a surfel, a location, or a range of these}
  ///     \cgalParamDefault{no targets}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{speed_map}
  ///     \cgalParamDescription{the speed of the front at vertices or surfels, finite and not
  ///       negative, zero at obstacles. 1/speed of a triangle is the mean of 1/speed at its
  ///       corners}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with vertices or surfels as keys and
  ///       `double` values}
  ///     \cgalParamDefault{1 everywhere}
  ///     \cgalParamExtra{With speeds, all distances, also `maximum_distance` and the offsets of
  ///       sources, are travel times.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{face_speed_map}
  ///     \cgalParamDescription{the speed of the front in the faces of a mesh, finite and not
  ///       negative, zero in obstacles}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with faces as keys and `double` values}
  ///     \cgalParamDefault{1 everywhere}
  ///     \cgalParamExtra{A call with both `speed_map` and `face_speed_map` does not compile.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{relative_tolerance}
  ///     \cgalParamDescription{a fraction, not negative. If it is positive, `Exact` merges similar
  ///       windows, which takes a fifth of the time on fine smooth meshes. The difference of
  ///       `lower()` and `upper()` is then at most this fraction of `lower()`, and in addition the
  ///       errors of thin triangles (see `lower()`). `maximum_distance` is a bound of `lower()`}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{0: exact distances}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a function that is called with the completed fraction; if it returns
  ///       false, the computation is canceled}
  ///     \cgalParamType{`std::function<bool(double)>`}
  ///     \cgalParamDefault{no callback}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \pre Property maps have a value for each of their keys. If a map reads a vector, as those of
  ///      `CGAL::make_property_map()` do, the length of the vector is not checked.
  /// \throws Invalid_argument_error if there is no source, or if an offset, a location, a speed,
  ///         the maximum distance or the relative tolerance is invalid
  /// \throws Unsupported_surface_error if speeds are not all 1 and the method does not support
  ///         speeds, if the relative tolerance is positive and the method is not exact, or if
  ///         `Exact` exceeds its limit of windows
  /// \throws Cancelled if the callback returns false. Then only vertices or surfels whose
  ///         distances were final are reached, also if the callback throws an exception. On a
  ///         cloud, some of these distances can be a few percent longer than after a complete
  ///         computation, because the front can still correct them, as near `maximum_distance`
  ///
  /// After an `Invalid_argument_error` or an `Unsupported_surface_error` the results of the last
  /// computation remain, unless the limit of windows was exceeded. Then nothing is reached.
  ///
  /// Takes O(m log m) time if m vertices or surfels are reached. `Exact` takes O(m<SUP>1.5</SUP>)
  /// time in practice. `Heat` takes back substitutions on the whole surface.
  template <typename Sources, typename NamedParameters = internal::Default_parameters>
  void compute(const Sources& sources, const NamedParameters& np = NamedParameters())
  {
    const internal::Front_limits limits = internal::limits(m_domain, np);
    std::vector<std::size_t> labels;
    std::vector<internal::Front_source> front_sources =
        internal::sources(m_domain, sources, labels);
    // If this throws an exception, the last result remains, which needs the last sources.
    m_engine.select(limits);
    m_sources = std::move(front_sources);
    m_labels = std::move(labels);
    if(!m_engine.run(m_sources, limits))
      throw Cancelled();
  }

  /// \name The last computation
  /// @{

  /// Returns the distance of a vertex or surfel; +infinity if no source reaches it.
  /// \param vertex a vertex or surfel of the surface
  /// \pre `vertex` belongs to the surface. This is not checked.
  double distance(Vertex vertex) const
  {
    return scale() * m_engine.distance(m_domain.index(vertex));
  }
  /// Returns the distance of any location on the surface; +infinity if no source reaches it. With
  /// `Exact`, a location inside a face takes a search whose time depends on the visited faces.
  /// \param location a location on the surface
  /// \throws Invalid_argument_error if the location is not on the surface
  double distance(const Location& location) const
  {
    return scale() * m_engine.distance(m_domain.inner(location));
  }
  /// Returns a certified lower bound of the exact polyhedral distance of a vertex, up to round-off
  /// errors; +infinity if no source reaches it. It equals `upper()` unless the mesh has triangles
  /// whose longest edge exceeds their height more than 30 times, or the computation had a
  /// `relative_tolerance`. In the latter case `distance()` is the mean of both, up to the errors of
  /// these triangles. With a speed, it is a bound of the travel time.
  /// The method must be `Exact` or `Automatic` and the surface a mesh, otherwise the call does not
  /// compile.
  /// \param vertex a vertex of the mesh
  /// \throws Unsupported_surface_error if `Automatic` did not use `Exact` in the last computation
  double lower(Vertex vertex) const { return scale() * windows().lower(m_domain.index(vertex)); }
  /// Returns a certified upper bound, as `lower()`. It is the length of a path.
  /// \param vertex a vertex of the mesh
  /// \throws Unsupported_surface_error as `lower()`
  double upper(Vertex vertex) const { return scale() * windows().upper(m_domain.index(vertex)); }
  /// Returns a certified lower bound of the distance of any location, as that of a vertex. The
  /// time is that of `distance()`.
  /// \param location a location on the mesh
  /// \throws Unsupported_surface_error as `lower()`
  /// \throws Invalid_argument_error if the location is not on the mesh
  double lower(const Location& location) const
  {
    return scale() * windows().bounds(m_domain.inner(location)).lower;
  }
  /// Returns a certified upper bound of the distance of any location, as that of a vertex. The
  /// time is that of `distance()`.
  /// \param location a location on the mesh
  /// \throws Unsupported_surface_error as `lower()`
  /// \throws Invalid_argument_error if the location is not on the mesh
  double upper(const Location& location) const
  {
    return scale() * windows().bounds(m_domain.inner(location)).upper;
  }
  /// Writes the distance of each location of a range to an output iterator; +infinity if no source
  /// reaches it.
  ///
  /// With `Exact`, the distance of a location inside a face takes a separate search. Without a
  /// relative tolerance, this function takes one more computation for all locations.
  /// \tparam Locations a vertex, surfel or location, or a range of these
  /// \tparam OutputIterator a model of `OutputIterator` for `double`
  /// \param locations a vertex, surfel or location, or a range of these
  /// \param out receives the distances in the order of the locations
  /// \returns the output iterator past the last distance
  /// \throws Invalid_argument_error if a location is not on the surface
  template <typename Locations, typename OutputIterator>
  OutputIterator distances(const Locations& locations, OutputIterator out) const
  {
    for(const double distance : m_engine.distances(internal::locations(m_domain, locations)))
      *out++ = scale() * distance;
    return out;
  }
  /// Returns the label of the nearest source; the largest `std::size_t` if no source reaches
  /// `vertex`.
  std::size_t source_label(Vertex vertex) const { return label(m_domain.index(vertex)); }
  /// Returns a neighbor that is closer to the source. The shortest path arrives through a triangle
  /// with this neighbor, or along the edge to it. Returns `vertex` itself at sources, and if no
  /// source reaches it.
  Vertex predecessor(Vertex vertex) const
  {
    return m_domain.vertex(predecessor_index(m_domain.index(vertex)));
  }
  /// Returns the vertices or surfels that were reached, approximately in the order of their
  /// distances. Takes linear time in their number.
  std::vector<Vertex> reached() const
  {
    std::vector<Vertex> result;
    result.reserve(m_engine.reached().size());
    for(const internal::Index index : m_engine.reached())
      result.push_back(m_domain.vertex(index));
    return result;
  }
  /// Returns the path from a vertex, surfel or location to its nearest source; empty if no source
  /// reaches it. With `Exact`, the default on meshes, its length equals the distance, up to the
  /// errors of thin triangles (see `Exact`). With a
  /// relative tolerance or another method, it is a locally shortest path. With different speeds, it
  /// is a fast path instead; see `geodesic_path()`. Takes time proportional to the number of
  /// visited faces; with different speeds, O(m log m) time for m faces near the path.
  /// \tparam QueryLocation a vertex, a surfel or a location
  /// \param from a vertex, a surfel or a location
  /// \throws Invalid_argument_error if the location is not on the surface
  template <typename QueryLocation>
  Surface_path<Surface> path(const QueryLocation& from) const
  {
    const internal::Surface_location inner = internal::location(m_domain, from);
    const double distance = scale() * m_engine.distance(inner);
    // The search for a path has no maximum distance.
    if(!(distance < internal::infinity))
      return internal::surface_path(m_domain, {}, distance);
    // An exact path can be missing only because of degenerate triangles.
    if(const internal::Window_propagation* windows = m_engine.windows())
      if(const internal::Bounded_path path = windows->path(inner); !path.locations.empty())
      {
        auto result = internal::surface_path(m_domain, path.locations, distance);
        result.lower = (std::max)(result.lower, scale() * path.lower);
        return result;
      }
    return internal::surface_path(m_domain,
                                  internal::path_to_sources(
                                      *m_domain.triangles(), inner, m_sources,
                                      [&](internal::Index i) { return m_engine.distance(i); },
                                      [&](internal::Index i) { return m_engine.predecessor(i); },
                                      [&](internal::Index i) { return m_engine.source(i); },
                                      m_engine.slowness()),
                                  distance);
  }

  /// Returns all shortest paths from a vertex or location to the sources, but at most 64 paths, and
  /// none if no source reaches it.
  /// On the cut locus, there are two or more. The method must be `Exact` or `Automatic`. Takes
  /// time proportional to the number of visited faces.
  ///
  /// \tparam QueryLocation a vertex or a location
  /// \param from a vertex or a location
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{paths that are longer by at most this fraction of the distance count
  ///       as shortest, which compensates for round-off errors. The excess length must be far
  ///       smaller than an edge.}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{1e-9}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Unsupported_surface_error if `Automatic` did not use `Exact` in the last computation,
  ///         or if there was a relative tolerance
  /// \throws Invalid_argument_error if the location is not on the mesh
  template <typename QueryLocation, typename NamedParameters = internal::Default_parameters>
  std::vector<Surface_path<Surface>>
  shortest_paths(const QueryLocation& from, const NamedParameters& np = NamedParameters()) const
  {
    const internal::Window_propagation& exact = windows();
    const double tolerance = internal::parameter(np, internal_np::tolerance, 1e-9);
    const internal::Surface_location inner = internal::location(m_domain, from);
    const double distance = scale() * m_engine.distance(inner);
    std::vector<Surface_path<Surface>> result;
    if(!(distance < internal::infinity))
      return result;
    for(const auto& path : exact.paths(inner, tolerance))
      result.push_back(internal::surface_path(m_domain, path, distance));
    return result;
  }
  /// Returns the departure of the shortest path to a vertex or location from its source. The
  /// method must be `Exact` or `Automatic`. Takes time proportional to the number of visited faces.
  /// \tparam QueryLocation a vertex or a location
  /// \param to a vertex or a location
  /// \throws Unsupported_surface_error if `Automatic` did not use `Exact` in the last computation,
  ///         or if there was a relative tolerance
  /// \throws Invalid_argument_error if the location is not on the mesh
  template <typename QueryLocation>
  Geodesic_departure<Surface> departure(const QueryLocation& to) const
  {
    const internal::Surface_location inner = internal::location(m_domain, to);
    const internal::Departure found = windows().departure(inner);
    Geodesic_departure<Surface> result;
    if(!(found.length < internal::infinity && m_engine.distance(inner) < internal::infinity))
      return result;
    result.from = m_domain.outer(found.from);
    result.polar_angle = found.polar_angle;
    result.length = scale() * found.length;
    const auto first_segment = m_domain.point(found.next) - m_domain.point(found.from);
    const double x = to_double(first_segment.x()), y = to_double(first_segment.y()),
                 z = to_double(first_segment.z());
    if(const double size = std::hypot(x, y, z); size > 0.)
      result.direction = typename Domain::Vector_3(x / size, y / size, z / size);
    return result;
  }

  /// Writes the distance of each vertex or surfel to a property map.
  /// \tparam DistanceMap a model of `WritablePropertyMap` with vertices or surfels as keys and
  ///         `double` as values
  /// \param map receives a value for each vertex or surfel
  template <typename DistanceMap>
  void write_distances(DistanceMap map) const
  {
    m_engine.visit(
        [&](const auto& kernel)
        {
          m_domain.write([&kernel, scale = scale()](internal::Index i)
                         { return scale * kernel.distance(i); },
                         map);
        });
  }
  /// Writes `source_label()` of each vertex or surfel to a property map.
  /// \tparam LabelMap a model of `WritablePropertyMap` with vertices or surfels as keys and
  ///         `std::size_t` as values
  /// \param map receives a value for each vertex or surfel
  template <typename LabelMap>
  void write_source_labels(LabelMap map) const
  {
    m_domain.write([&](internal::Index i) { return label(i); }, map);
  }
  /// Writes `predecessor()` of each vertex or surfel to a property map.
  /// \tparam PredecessorMap a model of `WritablePropertyMap` with vertices or surfels as keys and
  ///         vertices or surfels as values
  /// \param map receives a value for each vertex or surfel
  template <typename PredecessorMap>
  void write_predecessors(PredecessorMap map) const
  {
    m_domain.write([&](internal::Index i) { return m_domain.vertex(predecessor_index(i)); }, map);
  }
  /// @}

private:
  // Returns the kernel of exact distances.
  const internal::Window_propagation& windows() const
  {
    static_assert(!internal::is_approximate<Method> && !internal::Is_cloud<Surface>::value,
                  "This query requires the method Exact, which needs a mesh.");
    if(const internal::Window_propagation* windows = m_engine.windows())
      return *windows;
    throw Unsupported_surface_error("This query requires the method Exact.");
  }
  double scale() const { return m_domain.triangles()->scale; }
  // The sources and predecessors of Heat are those of Dijkstra's algorithm, which also reaches
  // vertices beyond the maximum distance.
  bool is_reached(internal::Index index) const
  {
    return m_engine.distance(index) < internal::infinity;
  }
  std::size_t label(internal::Index index) const
  {
    const internal::Index source = m_engine.source(index);
    return is_reached(index) && source != internal::none
               ? m_labels[source]
               : (std::numeric_limits<std::size_t>::max)();
  }
  internal::Index predecessor_index(internal::Index index) const
  {
    const internal::Index predecessor = m_engine.predecessor(index);
    return is_reached(index) && predecessor != internal::none ? predecessor : index;
  }

  Domain m_domain;
  internal::Distance_engine m_engine;
  std::vector<internal::Front_source> m_sources;
  std::vector<std::size_t> m_labels;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_SOLVER_H
