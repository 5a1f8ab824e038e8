// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_VOLUMETRIC_METRIC_H
#define CGAL_GEODESIC_PROCESSING_VOLUMETRIC_METRIC_H

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/transport_options.h>
#include <CGAL/Geodesic_processing/internal/transport/volumetric.h>
#include <CGAL/Geodesic_processing/mean_value_coordinates.h>

#include <CGAL/tags.h>

#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// measures between points in space, inside and outside of a closed mesh, such that distances go around
/// what is in the way.
///
/// The mean value coordinates of a point are masses at the vertices; the distance of two points is what it
/// costs to move those of one to those of the other along the surface.  Between points of the surface
/// that is what `Earth_movers_solver` finds, up to a part of an edge the geodesic distance; it is never
/// below the straight one, zero between equal points alone, symmetric, and the triangle inequality
/// holds within the gaps between bounds.  Where all coordinates are positive, as inside of convex
/// meshes, it is at most the surface's diameter.  \cgalCite{cgal:srgb-emd-14}, section 6
///
/// Copies share everything, and may be asked at the same time.
///
/// \tparam TriangleMesh as for `geodesic_distances()`: a mesh, closed and of one component
template <typename TriangleMesh>
class Volumetric_metric
{
  static_assert(!internal::Is_cloud<TriangleMesh>::value,
                "A cloud encloses nothing: volumetric distances need a closed mesh.");

public:
  using Domain = internal::Domain_of<TriangleMesh>;
  using Point_3 = typename Domain::Point_3;

  /// prepares the mesh, as `Earth_movers_solver` does.
  ///
  /// \param np what `make_domain()` takes, and `number_of_refinements` as for `Earth_movers_solver`
  /// \throws as `Earth_movers_solver`
  /// \throws Unsupported_surface_error when the mesh has a border or several components
  template <typename NamedParameters = internal::Default_parameters>
  explicit Volumetric_metric(const TriangleMesh& mesh,
                             const NamedParameters& np = NamedParameters())
      : Volumetric_metric(Domain(mesh, np), np)
  {}
  template <typename NamedParameters = internal::Default_parameters>
  explicit Volumetric_metric(const Domain& domain, const NamedParameters& np = NamedParameters())
      : m_domain(domain), m_distances(std::make_shared<const internal::Volumetric_distances>(
                              domain.triangles(), internal::number_of_refinements(domain, np)))
  {}

  const Domain& domain() const { return m_domain; }

  /// finds out how far two points are from each other, and bounds of it.
  ///
  /// The residual is relative to all that moves, with its sign.
  ///
  /// \param from, to `Point_3` of any kernel
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{of the gap between the bounds, relative to the upper one}
  ///     \cgalParamDefault{0.001} \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_number_of_iterations} \cgalParamDefault{100} \cgalParamNEnd
  ///   \cgalParamNBegin{do_bound_from_above}
  ///     \cgalParamDescription{whether to find `Earth_movers_cost::upper_continuous`: a few times as
  ///       long} \cgalParamDefault{false} \cgalParamNEnd
  ///   \cgalParamNBegin{potential_map}
  ///     \cgalParamDescription{receives for each vertex the function of slope one that proves a lower
  ///       bound} \cgalParamNEnd
  ///   \cgalParamNBegin{flow_map}
  ///     \cgalParamDescription{receives for each face the flow: a `Vector_3`} \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a `std::function<bool(double)>` that is told the fraction done and
  ///       ends by returning false: with the bounds that it has by then} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws as `mean_value_coordinates()` for a point
  /// \throws Invalid_argument_error when the tolerance is not positive
  ///
  /// 5 to 20 iterations of O(n<SUP>1.5</SUP>).
  template <typename From, typename To, typename NamedParameters = internal::Default_parameters>
  Earth_movers_cost cost(const From& from, const To& to,
                         const NamedParameters& np = NamedParameters()) const
  {
    const internal::Transport_result found = m_distances->cost(
        internal::spatial(from), internal::spatial(to), internal::transport_options(np));
    internal::write_transport_maps(m_domain, found, np);
    return found;
  }
  /// returns the value of `cost()`.
  template <typename From, typename To>
  double distance(const From& from, const To& to, double tolerance = 1e-3) const
  {
    return cost(from, to, parameters::tolerance(tolerance)).value;
  }

  /// returns how far one point is from each of many, for a slice through space: certified within a percent,
  /// by default, in a tenth of the time that these take one by one.
  ///
  /// Potentials and flows found for points nearby are nearly those of a point; a few hundred points,
  /// whatever their number, are solved on their own.
  ///
  /// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`.  The result is
  ///         the same to the last bit.
  /// \param from a `Point_3` of any kernel
  /// \param to a range of them
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{of the gap between the bounds, relative to the upper one: twice the
  ///       error of the value at most} \cgalParamDefault{0.02} \cgalParamNEnd
  ///   \cgalParamNBegin{threads} \cgalParamDescription{as for `geodesic_distance_matrix()`}
  ///     \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a `std::function<bool(double)>` that is told the fraction done, and
  ///       cancels by returning false} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \returns an `Earth_movers_cost` for each point, in their order, without `residual` and
  ///          `upper_continuous`; nothing when the callback cancelled it
  /// \throws as `cost()`
  ///
  /// It takes about 24 bytes per vertex, refined, for each point that is solved on its own.
  template <typename Concurrency_tag = Sequential_tag, typename From, typename Points,
            typename NamedParameters = internal::Default_parameters>
  std::vector<Earth_movers_cost> costs(const From& from, const Points& to,
                                       const NamedParameters& np = NamedParameters()) const
  {
    internal::Volumetric_options options;
    options.tolerance = internal::parameter(np, internal_np::tolerance, options.tolerance);
    options.threads = internal::threads<Concurrency_tag>(np);
    options.callback =
        internal::parameter(np, CGAL::internal_np::callback, std::function<bool(double)>());
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
      cost.iterations = found.iterations;
      cost.converged = found.upper - found.lower <= options.tolerance * found.upper;
      result.push_back(cost);
    }
    return result;
  }

  /// finds a path by going down the distance to its end, which stays on one side of the surface: it follows
  /// a bent room in its middle, though not by the shortest way.
  ///
  /// No step is longer than part of the way to the surface.
  ///
  /// \param from, to `Point_3` of any kernel, both inside or both outside
  /// \param path an output iterator that receives `Point_3`, from the first to the last
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{maximum_number_of_iterations}
  ///     \cgalParamDescription{of distances that are found on the way} \cgalParamDefault{1,000}
  ///     \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \returns whether the path arrives at its end
  /// \throws Invalid_argument_error when a point is on the surface, or they are on different sides of it
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
  Domain m_domain;
  std::shared_ptr<const internal::Volumetric_distances> m_distances;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_VOLUMETRIC_METRIC_H
