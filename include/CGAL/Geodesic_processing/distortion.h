// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_DISTORTION_H
#define CGAL_GEODESIC_PROCESSING_DISTORTION_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/numerics/singular_values.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingLogMap
/// The distortion of one face by a map of a mesh to the plane.
///
/// It is described by the singular values of the Jacobian of the inverse map, from the plane to the
/// face. All members take O(1) time.
struct Face_distortion
{
  double sigma_1 = 1.;      ///< the larger singular value; infinite if the image has no area
  double sigma_2 = 1.;      ///< the smaller singular value; infinite if the image has no area
  bool is_inverted = false; ///< true if the image is clockwise (inverted)
  double area = 0.;         ///< the area of the face on the surface

  /// \name Measures
  /// Distortion measures of the literature.
  ///
  /// `mips()`, `symmetric_mips()` and `conformal()` measure angles: they are minimal if
  /// \f$ \sigma_1 = \sigma_2 \f$. `dirichlet()`, `l2_stretch()` and `linf_stretch()` increase with
  /// the singular values. The others are minimal if \f$ \sigma_1 = \sigma_2 = 1 \f$. If the image
  /// has no area, all measures are infinite.
  /// @{

  /// Returns \f$ \sigma_1 / \sigma_2 \f$ (Hormann and Greiner 2000, without the reciprocal term).
  double mips() const { return std::isinf(sigma_1) ? sigma_1 : sigma_1 / sigma_2; }
  /// Returns \f$ \sigma_1 / \sigma_2 + \sigma_2 / \sigma_1 \f$.
  double symmetric_mips() const
  {
    return std::isinf(sigma_1) ? sigma_1 : sigma_1 / sigma_2 + sigma_2 / sigma_1;
  }
  /// Returns the conformal energy \f$ (\sigma_1 - \sigma_2)^2 / 2 \f$.
  double conformal() const
  {
    return std::isinf(sigma_1) ? sigma_1 : 0.5 * (sigma_1 - sigma_2) * (sigma_1 - sigma_2);
  }
  /// Returns \f$ (\sigma_1^2 - 1)^2 + (\sigma_2^2 - 1)^2 \f$.
  double green_lagrange() const
  {
    const double a = sigma_1 * sigma_1 - 1., b = sigma_2 * sigma_2 - 1.;
    return a * a + b * b;
  }
  /// Returns a measure of angles and areas: \f$ (\sigma_1/\sigma_2 + \sigma_2/\sigma_1)
  /// (\sigma_1 \sigma_2 + 1/(\sigma_1 \sigma_2))^\theta \f$ (Degener, Meseth and Klein 2003).
  /// \param theta the exponent of the distortion of areas
  double combined(double theta) const
  {
    const double area = sigma_1 * sigma_2;
    return symmetric_mips() * std::pow(area + 1. / area, theta);
  }
  /// Returns \f$ (\sigma_1^2 + \sigma_2^2) / 2 \f$.
  double dirichlet() const { return 0.5 * (sigma_1 * sigma_1 + sigma_2 * sigma_2); }
  /// Returns the square root of `dirichlet()` (Sander, Snyder, Gortler and Hoppe 2001).
  double l2_stretch() const { return std::sqrt(dirichlet()); }
  /// Returns \f$ \sigma_1 \f$.
  double linf_stretch() const { return sigma_1; }
  /// Returns \f$ \max(\sigma_1, 1/\sigma_2) \f$ (Sorkine and others 2002).
  double symmetric_stretch() const { return (std::max)(sigma_1, 1. / sigma_2); }
  /// Returns \f$ \sigma_1^2 + \sigma_2^2 + 1/\sigma_1^2 + 1/\sigma_2^2 \f$ (Smith and Schaefer
  /// 2015).
  double symmetric_dirichlet() const
  {
    return sigma_1 * sigma_1 + sigma_2 * sigma_2 + 1. / (sigma_1 * sigma_1) +
           1. / (sigma_2 * sigma_2);
  }
  /// Returns the distance between the metric of the face and the metric of its image:
  /// \f$ 2 \sqrt{\log^2 \sigma_1 + \log^2 \sigma_2} \f$.
  double riemannian() const { return 2. * std::hypot(std::log(sigma_1), std::log(sigma_2)); }
  /// @}
};

namespace internal {

// True if the keys of a UV map are the halfedges of a mesh.
template <typename Surface, typename UVMap, bool is_cloud = Is_cloud<Surface>::value>
inline constexpr bool is_keyed_by_halfedges =
    std::is_same_v<typename boost::property_traits<UVMap>::key_type,
                   typename boost::graph_traits<Surface>::halfedge_descriptor>;
template <typename Cloud, typename UVMap>
inline constexpr bool is_keyed_by_halfedges<Cloud, UVMap, true> = false;

template <typename Value>
Vec2 to_vec2(const Value& value)
{
  return {CGAL::to_double(value[0]), CGAL::to_double(value[1])};
}

// Returns the image of the corner that a halfedge points to. The keys of the map are vertices or
// halfedges.
template <typename Mesh, typename UVMap>
Vec2 image_of(typename boost::graph_traits<Mesh>::halfedge_descriptor h, const Mesh& mesh,
              const UVMap& uv_map)
{
  if constexpr(is_keyed_by_halfedges<Mesh, UVMap>)
    return to_vec2(get(uv_map, h));
  else
    return to_vec2(get(uv_map, target(h, mesh)));
}

// Returns the images of the corners of a triangle of a domain.
template <typename Domain, typename UVMap>
std::array<Vec2, 3> image_of_triangle(const Domain& domain, Index triangle, const UVMap& uv_map)
{
  std::array<Vec2, 3> image;
  if constexpr(is_keyed_by_halfedges<typename Domain::Surface, UVMap>)
  {
    const auto& mesh = domain.mesh();
    auto h = prev(halfedge(domain.face(triangle), mesh), mesh); // points to corner 0
    for(std::size_t k = 0; k < 3; ++k, h = next(h, mesh))
      image[k] = to_vec2(get(uv_map, h));
  }
  else
    for(Index k = 0; k < 3; ++k)
      image[k] = to_vec2(get(uv_map, domain.vertex(domain.triangles()->corner[3 * triangle + k])));
  return image;
}

// Computes the distortion of a triangle of a domain. The area is multiplied by the weight of the
// triangle. Lengths on the surface are in units of the caller, or of the domain if `scale` is 1.
template <typename Domain, typename UVMap>
Face_distortion distortion_of_triangle(const Domain& domain, Index triangle, const UVMap& uv_map,
                                       double scale)
{
  const Surface_arrays& t = *domain.triangles();
  // The lengths of the arrays are not used, because they have a positive minimum.
  std::array<double, 3> lengths;
  for(Index k = 0; k < 3; ++k)
    lengths[k] = scale * norm(t.point[t.corner[3 * triangle + (k + 1) % 3]] -
                              t.point[t.corner[3 * triangle + k]]);
  const Singular_values found =
      singular_values(lengths, image_of_triangle(domain, triangle, uv_map));
  const double weight = t.weight.empty() ? 1. : double(t.weight[triangle]);
  return {found.sigma_1, found.sigma_2, found.is_inverted, weight * found.area};
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingLogMap
///
/// Computes the distortion of a face by a map to the plane.
///
/// \tparam Face a face descriptor of the mesh
/// \tparam Mesh a model of `FaceListGraph`, or its domain. A cloud has no faces: use
///         `surface_distortion()` or `flattening_distortion()`.
/// \tparam UVMap a model of `ReadablePropertyMap` with vertices or halfedges as keys and `Point_2`
///         or arrays of two numbers as values
/// \param face a triangle of `mesh`
/// \param mesh a model of `FaceListGraph`, or its domain
/// \param uv_map the UV map: a property map of vertices or of halfedges. For a halfedge it gives
///        the image of the corner that the halfedge points to. Values are `Point_2` or arrays.
/// \param np `vertex_point_map`; ignored for a domain
/// \pre `face` belongs to `mesh` and is a triangle. Property maps have a value for each of its
///      corners.
/// \returns the singular values of the map, the area of the face, and whether its image is inverted
///
/// O(1).
template <typename Face, typename Mesh, typename UVMap,
          typename NamedParameters = internal::Default_parameters>
Face_distortion face_distortion(Face face, const Mesh& mesh, UVMap uv_map,
                                const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::face_distortion, Mesh>());
  if constexpr(!std::is_same_v<Mesh, Surface_of<Mesh>>)
  {
    (void)np;
    return internal::distortion_of_triangle(mesh, mesh.triangle(face), uv_map,
                                            mesh.triangles()->scale);
  }
  else
  {
    const auto points = internal::parameter(np, CGAL::internal_np::vertex_point,
                                            get_const_property_map(vertex_point, mesh));
    std::array<internal::Vec2, 3> image;
    std::array<double, 3> lengths;
    auto h = halfedge(face, mesh);
    for(std::size_t k = 0; k < 3; ++k, h = next(h, mesh))
    {
      // Edge k begins at the corner that h points to and ends at the next corner.
      image[k] = internal::image_of(h, mesh, uv_map);
      const auto& p = get(points, target(h, mesh));
      const auto& q = get(points, target(next(h, mesh), mesh));
      lengths[k] = std::hypot(CGAL::to_double(q.x()) - CGAL::to_double(p.x()),
                              CGAL::to_double(q.y()) - CGAL::to_double(p.y()),
                              CGAL::to_double(q.z()) - CGAL::to_double(p.z()));
    }
    const internal::Singular_values found = internal::singular_values(lengths, image);
    return {found.sigma_1, found.sigma_2, found.is_inverted, found.area};
  }
}

/// \ingroup PkgGeodesicProcessingLogMap
/// A distortion measure, summarized over all triangles that have an image.
template <typename Surface>
struct Surface_distortion
{
  double integral = 0.; ///< the integral of the measure over the area of the triangles
  double area = 0.;     ///< the total area of these triangles
  double worst = 0.;    ///< the largest value of the measure
  Location<Surface> worst_location{};  ///< the center of a triangle with this value
  std::size_t number_of_triangles = 0; ///< triangles that have an image
  std::size_t number_of_flips = 0;     ///< triangles whose image is clockwise (inverted)

  /// Returns the mean of the measure, weighted by area. It is NaN if no triangle has area, or if the
  /// total area overflows. O(1).
  double mean() const { return integral / area; }
};

/// \ingroup PkgGeodesicProcessingLogMap
///
/// Computes the integral, the mean and the maximum of a distortion measure over a surface.
///
/// The triangles of a cloud overlap. Their areas are weighted such that the sum is the area of the
/// surface.
///
/// \tparam Surface as for `geodesic_distances()`
/// \tparam UVMap a model of `ReadablePropertyMap` with vertices, surfels or halfedges as keys and
///         `Point_2` or arrays of two numbers as values
/// \tparam Measure a function object, or a pointer to a member of `Face_distortion`
/// \param surface as for `geodesic_distances()`
/// \param uv_map as for `face_distortion()`. If a corner of a triangle has NaN coordinates, the
///        triangle is ignored. These are the triangles outside of the domain of a logarithmic map.
/// \param measure a function of a `Face_distortion`, such as `&Face_distortion::conformal`. If the
///        image of a triangle has no area, its measures are infinite, and so are the integral, the
///        mean and the maximum.
/// \param np the named parameters of `make_domain()`
/// \pre The UV map has a value for each corner of each face.
/// \returns the integral, the maximum and the numbers of triangles
/// \throws as `make_domain()`
///
/// O(n) after `make_domain()`.
template <typename Surface, typename UVMap, typename Measure,
          typename NamedParameters = internal::Default_parameters>
Surface_distortion<Surface_of<Surface>>
surface_distortion(const Surface& surface, UVMap uv_map, Measure measure,
                   const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  Surface_distortion<Surface_of<Surface>> result;
  for(internal::Index f = 0; f < domain.triangles()->number_of_triangles(); ++f)
  {
    const Face_distortion distortion =
        internal::distortion_of_triangle(domain, f, uv_map, domain.triangles()->scale);
    if(std::isnan(distortion.sigma_1))
      continue;
    const double value = std::invoke(measure, distortion);
    if(distortion.area > 0.)
      result.integral += distortion.area * value;
    result.area += distortion.area;
    if(result.number_of_triangles++ == 0 || value > result.worst)
    {
      result.worst = value;
      result.worst_location = domain.outer({f, internal::none, {1. / 3., 1. / 3., 1. / 3.}});
    }
    result.number_of_flips += distortion.is_inverted;
  }
  return result;
}

/// \ingroup PkgGeodesicProcessingLogMap
/// The distortion of a surface by a map to the plane, in the usual measures for comparing
/// flattenings.
///
/// All values refer to the map scaled to the area of the surface. Means are weighted by the area of
/// the triangles.
struct Flattening_distortion
{
  /// The distortion of angles: the square root of the mean of
  /// \f$ \sigma_1/\sigma_2 + \sigma_2/\sigma_1 - 2 \f$. It is 0 for a conformal map.
  double conformal = 0.;
  /// The distortion of areas: the square root of the mean of
  /// \f$ \sigma_1 \sigma_2 + 1/(\sigma_1 \sigma_2) - 2 \f$. It is 0 if areas are preserved.
  double authalic = 0.;
  double symmetric_dirichlet =
      0.;                   ///< the mean of `Face_distortion::symmetric_dirichlet()`, at least 4
  double l2_stretch = 0.;   ///< the square root of the mean of `Face_distortion::dirichlet()`
  double linf_stretch = 0.; ///< the maximum of `Face_distortion::linf_stretch()`
  /// The number of triangles of positive area whose image is inverted or has no area.
  std::size_t number_of_flips = 0;
  /// The number of triangles of positive area that have an image.
  std::size_t number_of_triangles = 0;
};

/// \ingroup PkgGeodesicProcessingLogMap
///
/// Computes the distortion of a surface by a map to the plane, independently of the map's scale.
///
/// Triangles without area are ignored. If the image of any other triangle has no area, the means
/// are infinite. The triangles of a cloud overlap, and their areas are weighted as by
/// `surface_distortion()`.
///
/// \tparam Surface as for `geodesic_distances()`
/// \tparam UVMap a model of `ReadablePropertyMap` with vertices, surfels or halfedges as keys and
///         `Point_2` or arrays of two numbers as values
/// \param surface as for `geodesic_distances()`
/// \param uv_map as for `surface_distortion()`
/// \param np the named parameters of `make_domain()`
/// \pre The UV map has a value for each corner of each face.
/// \returns the distortion in several measures
/// \throws as `make_domain()`
///
/// O(n) after `make_domain()`.
template <typename Surface, typename UVMap, typename NamedParameters = internal::Default_parameters>
Flattening_distortion flattening_distortion(const Surface& surface, UVMap uv_map,
                                            const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  const auto for_each = [&](auto f)
  {
    for(internal::Index i = 0; i < domain.triangles()->number_of_triangles(); ++i)
    {
      // In units of the domain, areas neither overflow nor underflow.
      const Face_distortion distortion = internal::distortion_of_triangle(domain, i, uv_map, 1.);
      if(distortion.area > 0. && !std::isnan(distortion.sigma_1))
        f(distortion);
    }
  };
  // The factor of lengths between the image and the surface is near this power of two.
  double unit = internal::infinity;
  for_each([&](const Face_distortion& face) { unit = (std::min)(unit, face.sigma_1); });
  unit = std::isinf(unit) ? 1. : std::ldexp(1., std::ilogb(unit));
  double area = 0., image = 0.;
  for_each(
      [&](const Face_distortion& face)
      {
        area += face.area;
        image += face.area / ((face.sigma_1 / unit) * (face.sigma_2 / unit));
      });
  const double scale = image > 0. ? std::sqrt(image / area) / unit : 1.;

  Flattening_distortion result;
  for_each(
      [&](Face_distortion face)
      {
        ++result.number_of_triangles;
        result.number_of_flips += face.is_inverted || std::isinf(face.sigma_1);
        face.sigma_1 *= scale;
        face.sigma_2 *= scale;
        const double area_fraction = face.area / area;
        // Computed as squares: near an isometry, the sum 1 + 1 - 2 would cancel to round-off
        // errors.
        const double product = std::sqrt(face.sigma_1 * face.sigma_2);
        const bool is_flat = std::isinf(face.sigma_1);
        const double angle = is_flat ? face.sigma_1 : (face.sigma_1 - face.sigma_2) / product,
                     size = is_flat ? face.sigma_1 : product - 1. / product;
        result.conformal += area_fraction * angle * angle;
        result.authalic += area_fraction * size * size;
        result.symmetric_dirichlet += area_fraction * face.symmetric_dirichlet();
        result.l2_stretch += area_fraction * face.dirichlet();
        result.linf_stretch = (std::max)(result.linf_stretch, face.linf_stretch());
      });
  result.conformal = std::sqrt(result.conformal);
  result.authalic = std::sqrt(result.authalic);
  result.l2_stretch = std::sqrt(result.l2_stretch);
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_DISTORTION_H
