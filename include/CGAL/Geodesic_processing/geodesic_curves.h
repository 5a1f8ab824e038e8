// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_CURVES_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_CURVES_H

#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/distances/curves.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <vector>

namespace CGAL::Geodesic_processing {

namespace internal {

template <typename NamedParameters>
Curve_options curve_options(const NamedParameters& np)
{
  static_assert(!has_parameter<NamedParameters, internal_np::speed_map_t> &&
                    !has_parameter<NamedParameters, internal_np::face_speed_map_t>,
                "Curves do not support speeds, because they consist of exact shortest paths.");
  Curve_options result;
  result.number_of_subdivisions =
      parameter(np, internal_np::number_of_subdivisions, result.number_of_subdivisions);
  result.callback = read_throwing_callback(np);
  return result;
}

// Converts the locations of a curve.
template <typename Domain>
Surface_path<typename Domain::Surface> curve_path(const Domain& domain,
                                                  const std::vector<Surface_location>& curve)
{
  Surface_path<typename Domain::Surface> result = surface_path(domain, curve, 0.);
  result.front_distance = result.length;
  return result;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes a B&eacute;zier curve on a mesh.
///
/// The control polygon is subdivided by the algorithm of de Casteljau, in which the midpoint of two
/// points is that of a shortest path between them \cgalCite{cgal:mnpp-bsvg-22}. In the plane, the
/// points of the curve are those of the B&eacute;zier curve. The curve begins at the first control
/// point and ends at the last one. There, it is tangent to the shortest paths to the adjacent
/// control points. Each subdivision reduces the difference to the limit curve by a factor of about
/// four, unless control points are so far from each other that shortest paths between them jump
/// from one side of an obstacle to the other one.
///
/// \tparam Surface a model of `FaceListGraph`, or its domain
/// \tparam ControlPoints a range of vertices or of `Location<Surface>`
/// \param mesh as for `geodesic_distances()`, but not a cloud
/// \param control_points at least two vertices or locations. The degree is their number minus one
/// \param np the named parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_subdivisions}
///     \cgalParamDescription{the number of subdivisions k, at most 20. The result has
///       2<SUP>k</SUP> + 1 points of the curve, which are joined by shortest paths}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{6}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the completed fraction; if it returns
///       false, the computation is canceled}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns a path whose `front_distance` is its length
/// \throws Invalid_argument_error if there are fewer than two control points, if one is invalid, if
///         two consecutive ones are not connected, or if there are more than 20 subdivisions
/// \throws Cancelled if the callback returns false
///
/// For degree p, takes 2<SUP>k</SUP> (1 + p (p + 1) / 2) queries of `Geodesic_path_finder`. Each
/// takes time proportional to the number of visited faces. The paths of one subdivision are half as
/// long as those of the previous one.
template <typename Surface, typename ControlPoints,
          typename NamedParameters = internal::Default_parameters>
Surface_path<Surface_of<Surface>>
geodesic_bezier_curve(const Surface& mesh, const ControlPoints& control_points,
                      const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::geodesic_bezier_curve, Surface>());
  const auto domain = make_domain(mesh, np);
  return internal::curve_path(domain,
                              internal::bezier_curve(domain.triangles(),
                                                     internal::locations(domain, control_points),
                                                     internal::curve_options(np)));
}

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes a uniform B-spline on a mesh.
///
/// The control polygon is subdivided by the algorithm of Lane and Riesenfeld
/// \cgalCite{cgal:lr-tdsa-80} with midpoints of shortest paths. In the plane, the control points of
/// each subdivision are those of the B-spline. An open spline begins at the first control point and
/// ends at the last one, because these count `degree` times. There, it is tangent to the shortest
/// paths to the adjacent control points. For degrees above one, each subdivision reduces the
/// difference to the limit curve by a factor of about four, with the exception that
/// `geodesic_bezier_curve()` states.
///
/// \tparam Surface a model of `FaceListGraph`, or its domain
/// \tparam ControlPoints a range of vertices or of `Location<Surface>`
/// \param mesh as for `geodesic_distances()`, but not a cloud
/// \param control_points at least two vertices or locations
/// \param np the named parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{degree}
///     \cgalParamDescription{the degree, positive}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{3}
///   \cgalParamNEnd
///   \cgalParamNBegin{is_closed}
///     \cgalParamDescription{whether the spline is a closed curve. Then its last location equals
///       the first one}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_subdivisions}
///     \cgalParamDescription{the number of subdivisions, at most 20. The result joins the control
///       points of the last one by shortest paths}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{6}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the completed fraction; if it returns
///       false, the computation is canceled}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns a path whose `front_distance` is its length
/// \throws as `geodesic_bezier_curve()`, and Invalid_argument_error if the degree is zero
///
/// For n control points, degree p and k subdivisions, takes about 2<SUP>k</SUP> n (2 p + 1) queries
/// of `Geodesic_path_finder`, as `geodesic_bezier_curve()`.
template <typename Surface, typename ControlPoints,
          typename NamedParameters = internal::Default_parameters>
Surface_path<Surface_of<Surface>> geodesic_spline(const Surface& mesh,
                                                  const ControlPoints& control_points,
                                                  const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::geodesic_spline, Surface>());
  const auto domain = make_domain(mesh, np);
  return internal::curve_path(
      domain, internal::b_spline(domain.triangles(), internal::locations(domain, control_points),
                                 internal::parameter(np, internal_np::degree, 3u),
                                 internal::parameter(np, internal_np::is_closed, false),
                                 internal::curve_options(np)));
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_CURVES_H
