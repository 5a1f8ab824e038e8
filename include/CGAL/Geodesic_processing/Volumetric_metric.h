// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_VOLUMETRIC_METRIC_H
#define CGAL_GEODESIC_PROCESSING_VOLUMETRIC_METRIC_H

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/transport_options.h>
#include <CGAL/Geodesic_processing/internal/transport/volumetric.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/mean_value_coordinates.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <iterator>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes distances between points in space, inside and outside of a closed mesh. The distances
/// account for the obstacles that the surface forms.
///
/// The mean value coordinates of a point are masses at the vertices; other barycentric coordinates
/// can be passed. The distance of two points is the cost of transporting the masses of one point to
/// the masses of the other along the surface. \cgalCite{cgal:srgb-emd-14}, section 6
///
/// Between points on the surface, the distance is that of `Earth_movers_solver`: the geodesic
/// distance, up to a fraction of an edge. It is never below the Euclidean distance, and it is zero
/// only between equal points. It is symmetric. The triangle inequality holds up to the gaps between
/// the bounds. If all coordinates are positive, as inside convex meshes, the distance is at most
/// the diameter of the surface.
///
/// Copies share all data, and can be queried concurrently.
///
/// \tparam TriangleMesh as for `geodesic_distances()`: a closed mesh with one connected component
template <typename TriangleMesh>
class Volumetric_metric
{
  static_assert(internal::require_support<Function::Volumetric_metric, TriangleMesh>());

public:
  using Domain = internal::Domain_of<TriangleMesh>;
  using Point_3 = typename Domain::Point_3;

  /// Precomputes the factorizations, as `Earth_movers_solver`.
  ///
  /// \param mesh the mesh
  /// \param np named parameters of `make_domain()`, `number_of_refinements` as for
  ///        `Earth_movers_solver`, and
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{barycentric_coordinates}
  ///     \cgalParamDescription{a function of a point that returns its barycentric coordinates: one
  ///       weight for each vertex, in the order of `vertices(mesh)`. The weights sum to one, and
  ///       the weighted sum of the vertices is the point. At a vertex, its weight is one and the
  ///       others are zero. These properties are checked at each point. One thread at a time calls
  ///       the function}
  ///     \cgalParamType{a copyable function object with a parameter of type `Point_3` that returns
  ///       a range of `double`}
  ///     \cgalParamDefault{mean value coordinates}
  ///     \cgalParamExtra{If the coordinates at points of an edge or a face are not those of the
  ///       edge or the face, the distance is not that of the surface. Differences of a point and
  ///       the weighted sum of up to 10<SUP>-6</SUP> times the extent of the mesh are accepted.
  ///       Bounds refer to the weighted sum.}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws as `Earth_movers_solver`
  /// \throws Unsupported_surface_error if the mesh has a boundary or several components
  ///
  /// Takes two factorizations, each about O(n<SUP>1.5</SUP>).
  template <typename NamedParameters = internal::Default_parameters>
  explicit Volumetric_metric(const TriangleMesh& mesh,
                             const NamedParameters& np = NamedParameters())
      : Volumetric_metric(Domain(mesh, np), np)
  {}
  /// Uses an existing `domain`, which is shared. The time and `np` are as for a mesh.
  /// \throws as for a mesh, except for the exceptions of `make_domain()`
  template <typename NamedParameters = internal::Default_parameters>
  explicit Volumetric_metric(const Domain& domain, const NamedParameters& np = NamedParameters())
      : m_domain(domain), m_distances(std::make_shared<const internal::Volumetric_distances>(
                              domain.triangles(), internal::number_of_refinements(domain, np),
                              coordinate_function(domain, np)))
  {}

  /// Returns the domain of the mesh. O(1).
  const Domain& domain() const { return m_domain; }

  /// Computes the distance between two points, with bounds.
  ///
  /// The residual is relative to the mass that moves: half the sum of the absolute differences of
  /// the coordinates.
  ///
  /// \tparam From, To a `Point_3` of any kernel
  /// \param from, to `Point_3` of any kernel
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{the gap between the bounds, relative to the upper bound, at which
  ///       the iteration ends}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{0.001}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_number_of_iterations}
  ///     \cgalParamDescription{the maximum number of iterations}
  ///     \cgalParamType{`unsigned`}
  ///     \cgalParamDefault{100}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{do_bound_from_above}
  ///     \cgalParamDescription{whether `Earth_movers_cost::upper_continuous` is computed, which
  ///       takes a few times as long}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{false}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{potential_map}
  ///     \cgalParamDescription{receives for each vertex the value of a function of slope one, which
  ///       certifies a lower bound}
  ///     \cgalParamType{a model of `WritablePropertyMap` with vertices or surfels as keys and
  ///       `double` as values}
  ///     \cgalParamDefault{nothing is written}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{flow_map}
  ///     \cgalParamDescription{receives the flow, a `Vector_3` for each face}
  ///     \cgalParamType{a model of `WritablePropertyMap` with faces or surfels as keys and
  ///       `Vector_3` as values}
  ///     \cgalParamDefault{nothing is written}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a function that receives the fraction done. If it returns false, the
  ///       function throws `Cancelled`}
  ///     \cgalParamType{`std::function<bool(double)>`}
  ///     \cgalParamDefault{no callback}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws as `mean_value_coordinates()` for a point, or as the function
  ///         `barycentric_coordinates`
  /// \throws Invalid_argument_error if a coordinate of a point is not finite, or if the values of
  ///         `barycentric_coordinates` are not barycentric coordinates of it
  /// \throws Invalid_argument_error if the tolerance is not positive
  /// \throws Cancelled if the callback returns false
  /// \returns the distance with bounds
  ///
  /// 5 to 20 iterations of O(n<SUP>1.5</SUP>) each.
  template <typename From, typename To, typename NamedParameters = internal::Default_parameters>
  Earth_movers_cost cost(const From& from, const To& to,
                         const NamedParameters& np = NamedParameters()) const
  {
    const internal::Transport_result found = m_distances->cost(
        internal::spatial(from), internal::spatial(to), internal::transport_options(np));
    internal::write_transport_maps(m_domain, found, np);
    return found;
  }
  /// Returns the value of `cost()`, and takes the same time. `From`, `To`, `from`, `to` and `np`
  /// are as for `cost()`.
  /// \throws as `cost()`
  template <typename From, typename To, typename NamedParameters = internal::Default_parameters>
  double distance(const From& from, const To& to,
                  const NamedParameters& np = NamedParameters()) const
  {
    return cost(from, to, np).value;
  }

  /// Returns the distances from one point to many, for example for a slice through space. By
  /// default they are certified within one percent, in a tenth of the time of separate queries.
  ///
  /// Potentials and flows of nearby points approximate those of a point. Only a few hundred points
  /// are solved separately, for any number of points.
  ///
  /// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`. The
  ///         results are identical bit by bit.
  /// \tparam From a `Point_3` of any kernel
  /// \tparam Points a range of points as `from`
  /// \param from a `Point_3` of any kernel
  /// \param to a range of points as `from`
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{the maximum gap between the bounds, relative to the upper bound; the
  ///       error of the value is at most half of it}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{0.02}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{number_of_threads}
  ///     \cgalParamDescription{as for `geodesic_distance_matrix()`}
  ///     \cgalParamType{`unsigned`}
  ///     \cgalParamDefault{the number of hardware threads}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a function that receives the fraction done. If it returns false, the
  ///       function throws `Cancelled`}
  ///     \cgalParamType{`std::function<bool(double)>`}
  ///     \cgalParamDefault{no callback}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \returns an `Earth_movers_cost` for each point, in their order, without `residual` and
  ///          `upper_continuous`
  /// \throws as `cost()`
  ///
  /// It takes about 24 bytes per vertex of the refined mesh for each point that is solved
  /// separately.
  template <typename Concurrency_tag = Sequential_tag, typename From, typename Points,
            typename NamedParameters = internal::Default_parameters>
  std::vector<Earth_movers_cost> costs(const From& from, const Points& to,
                                       const NamedParameters& np = NamedParameters()) const
  {
    internal::Volumetric_options options;
    options.tolerance = internal::parameter(np, internal_np::tolerance, options.tolerance);
    options.number_of_threads = internal::number_of_threads<Concurrency_tag>(np);
    options.callback = internal::read_throwing_callback(np);
    std::vector<internal::Vec3> points;
    for(const auto& point : to)
      points.push_back(internal::spatial(point));
    std::vector<Earth_movers_cost> result;
    for(const internal::Volumetric_bounds& found :
        m_distances->one_to_many(internal::spatial(from), points, options))
    {
      Earth_movers_cost cost;
      cost.lower = found.lower;
      cost.upper = found.upper;
      cost.value = cost.estimate = 0.5 * (found.lower + found.upper);
      cost.number_of_iterations = found.number_of_iterations;
      cost.is_converged = found.upper - found.lower <= options.tolerance * found.upper;
      result.push_back(cost);
    }
    return result;
  }

  /// Computes a path by gradient descent of the distance to its end. The path does not cross the
  /// surface. In a bent cavity it follows the center line, and it is not the shortest path.
  ///
  /// No step is longer than a fraction of the distance to the surface. Each step takes the time of
  /// a `cost()`.
  ///
  /// \tparam From, To a `Point_3` of any kernel
  /// \tparam OutputIterator a model of `OutputIterator` for `Point_3`
  /// \param from, to `Point_3` of any kernel, both inside or both outside
  /// \param path an output iterator that receives `Point_3`, from the first to the last
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{maximum_number_of_iterations}
  ///     \cgalParamDescription{the maximum number of distance computations along the path}
  ///     \cgalParamType{`unsigned`}
  ///     \cgalParamDefault{1,000}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \returns whether the path reaches its end
  /// \throws Invalid_argument_error if a point is on the surface, or if the surface separates the
  ///         points
  /// \throws as `mean_value_coordinates()`
  template <typename From, typename To, typename OutputIterator,
            typename NamedParameters = internal::Default_parameters>
  bool write_path(const From& from, const To& to, OutputIterator path,
                  const NamedParameters& np = NamedParameters()) const
  {
    const internal::Volumetric_path found = m_distances->path(
        internal::spatial(from), internal::spatial(to),
        internal::parameter(np, internal_np::maximum_number_of_iterations, 1000u));
    for(const internal::Vec3& p : found.points)
      *path++ = Point_3(p[0], p[1], p[2]);
    return found.has_arrived;
  }

private:
  // Converts `barycentric_coordinates` to the order of the domain; empty if it is not given.
  template <typename NamedParameters>
  static internal::Volumetric_distances::Coordinate_function
  coordinate_function(const Domain& domain, const NamedParameters& np)
  {
    if constexpr(internal::has_parameter<NamedParameters, internal_np::barycentric_coordinates_t>)
      return [domain, function = internal::parameter(np, internal_np::barycentric_coordinates, 0)](
                 const internal::Vec3& point)
      {
        const auto weights = function(Point_3(point[0], point[1], point[2]));
        internal::Vector result = internal::Vector::Zero(Eigen::Index(domain.number_of_vertices()));
        auto weight = std::begin(weights);
        for(const auto vertex : vertices(domain.mesh()))
        {
          if(weight == std::end(weights))
            throw Invalid_argument_error("There are fewer barycentric coordinates than vertices.");
          // Vertices of a soup that are merged have the same index.
          result[domain.index(vertex)] += to_double(*weight++);
        }
        if(weight != std::end(weights))
          throw Invalid_argument_error("There are more barycentric coordinates than vertices.");
        return result;
      };
    else
      return {};
  }

  Domain m_domain;
  std::shared_ptr<const internal::Volumetric_distances> m_distances;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_VOLUMETRIC_METRIC_H
