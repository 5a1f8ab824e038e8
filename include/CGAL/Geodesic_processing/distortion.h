// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_DISTORTION_H
#define CGAL_GEODESIC_PROCESSING_DISTORTION_H

#include <CGAL/Geodesic_processing/internal/numerics/singular_values.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingLogMap
/// how a map of a mesh to the plane stretches a face, as the other way round, from the plane to the
/// face: the singular values of its Jacobian.
struct Face_distortion
{
  double sigma_1 = 1.,
         sigma_2 = 1.;    ///< \f$ \sigma_1 \geq \sigma_2 \f$; infinite where the image has no area
  bool is_folded = false; ///< the image is turned round
  double area = 0.;       ///< of the face

  /// \name Measures
  /// of the literature, all of them least where \f$ \sigma_1 = \sigma_2 = 1 \f$ or, for those of angles
  /// alone, where both are equal.
  /// @{

  /// \f$ \sigma_1 / \sigma_2 \f$ (Hormann and Greiner 2000, without the other way round).
  double mips() const { return sigma_1 / sigma_2; }
  /// \f$ \sigma_1 / \sigma_2 + \sigma_2 / \sigma_1 \f$.
  double symmetric_mips() const { return sigma_1 / sigma_2 + sigma_2 / sigma_1; }
  /// \f$ (\sigma_1 - \sigma_2)^2 / 2 \f$, the energy of conformal maps.
  double conformal() const { return 0.5 * (sigma_1 - sigma_2) * (sigma_1 - sigma_2); }
  /// \f$ (\sigma_1^2 - 1)^2 + (\sigma_2^2 - 1)^2 \f$.
  double green_lagrange() const
  {
    const double a = sigma_1 * sigma_1 - 1., b = sigma_2 * sigma_2 - 1.;
    return a * a + b * b;
  }
  /// angles and areas: \f$ (\sigma_1/\sigma_2 + \sigma_2/\sigma_1)
  /// (\sigma_1 \sigma_2 + 1/(\sigma_1 \sigma_2))^\theta \f$ (Degener, Meseth and Klein 2003).
  double combined(double theta) const
  {
    const double area = sigma_1 * sigma_2;
    return symmetric_mips() * std::pow(area + 1. / area, theta);
  }
  /// \f$ (\sigma_1^2 + \sigma_2^2) / 2 \f$.
  double dirichlet() const { return 0.5 * (sigma_1 * sigma_1 + sigma_2 * sigma_2); }
  /// the root of `dirichlet()` (Sander, Snyder, Gortler and Hoppe 2001).
  double l2_stretch() const { return std::sqrt(dirichlet()); }
  /// \f$ \sigma_1 \f$.
  double linf_stretch() const { return sigma_1; }
  /// \f$ \max(\sigma_1, 1/\sigma_2) \f$ (Sorkine and others 2002).
  double symmetric_stretch() const { return (std::max)(sigma_1, 1. / sigma_2); }
  /// \f$ \sigma_1^2 + \sigma_2^2 + 1/\sigma_1^2 + 1/\sigma_2^2 \f$ (Smith and Schaefer 2015).
  double symmetric_dirichlet() const
  {
    return sigma_1 * sigma_1 + sigma_2 * sigma_2 + 1. / (sigma_1 * sigma_1) +
           1. / (sigma_2 * sigma_2);
  }
  /// the distance of the metric from that of the plane:
  /// \f$ 2 \sqrt{\log^2 \sigma_1 + \log^2 \sigma_2} \f$.
  double riemannian() const { return 2. * std::hypot(std::log(sigma_1), std::log(sigma_2)); }
  /// @}
};

namespace internal {

// The image of the corner of a face that a halfedge points to: of a map of vertices, or of halfedges.
template <typename Mesh, typename UVMap>
Vec2 image_of(typename boost::graph_traits<Mesh>::halfedge_descriptor h, const Mesh& mesh,
              const UVMap& uv_map)
{
  const auto planar = [](const auto& value) -> Vec2 {
    return {CGAL::to_double(value[0]), CGAL::to_double(value[1])};
  };
  using Key = typename boost::property_traits<UVMap>::key_type;
  if constexpr(std::is_same_v<Key, typename boost::graph_traits<Mesh>::halfedge_descriptor>)
    return planar(get(uv_map, h));
  else
    return planar(get(uv_map, target(h, mesh)));
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingLogMap
///
/// returns how a map to the plane distorts a face.
///
/// \param face a triangle of `mesh`
/// \param uv_map of vertices, or of halfedges: of the corner that a halfedge of the face points to.
///        Values are `Point_2` or arrays.
/// \param np `vertex_point_map`
template <typename Mesh, typename UVMap, typename NamedParameters = internal::Default_parameters>
Face_distortion face_distortion(typename boost::graph_traits<Mesh>::face_descriptor face,
                                const Mesh& mesh, UVMap uv_map,
                                const NamedParameters& np = NamedParameters())
{
  const auto points = internal::parameter(np, CGAL::internal_np::vertex_point,
                                          get_const_property_map(vertex_point, mesh));
  std::array<internal::Vec2, 3> image;
  std::array<double, 3> lengths;
  auto h = halfedge(face, mesh);
  for(std::size_t k = 0; k < 3; ++k, h = next(h, mesh))
  {
    // Side k leads from the corner that h points to, to the next one.
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

/// \ingroup PkgGeodesicProcessingLogMap
/// a measure of distortion over all faces that a map knows.
template <typename Mesh>
struct Mesh_distortion
{
  using Face = typename boost::graph_traits<Mesh>::face_descriptor;

  double integral = 0.; ///< over the area of the faces
  double area = 0.;     ///< of these
  double worst = 0.;    ///< the largest value
  Face worst_face = boost::graph_traits<Mesh>::null_face();
  std::size_t number_of_faces = 0;
  std::size_t number_of_folded_faces = 0;

  double mean() const { return integral / area; }
};

/// \ingroup PkgGeodesicProcessingLogMap
///
/// measures how a map to the plane distorts a mesh, integrated and at its worst.
///
/// \param uv_map as for `face_distortion()`.  Faces with a corner that is not a number are left out: those
///        outside of a logarithmic map.
/// \param measure a function of a `Face_distortion`, as `&Face_distortion::conformal`
/// \param np `vertex_point_map`
///
/// O(n).
template <typename Mesh, typename UVMap, typename Measure,
          typename NamedParameters = internal::Default_parameters>
Mesh_distortion<Mesh> mesh_distortion(const Mesh& mesh, UVMap uv_map, Measure measure,
                                      const NamedParameters& np = NamedParameters())
{
  Mesh_distortion<Mesh> result;
  for(const auto face : faces(mesh))
  {
    const Face_distortion distortion = face_distortion(face, mesh, uv_map, np);
    if(std::isnan(distortion.sigma_1))
      continue;
    const double value = std::invoke(measure, distortion);
    result.integral += distortion.area * value;
    result.area += distortion.area;
    if(result.number_of_faces++ == 0 || value > result.worst)
    {
      result.worst = value;
      result.worst_face = face;
    }
    result.number_of_folded_faces += distortion.is_folded;
  }
  return result;
}

/// \ingroup PkgGeodesicProcessingLogMap
/// how a map to the plane distorts a mesh, in the numbers by which flattenings are compared, where both have
/// the same area.  Means are by the area of the faces.
struct Flattening_distortion
{
  /// of angles: the root of the mean of \f$ \sigma_1/\sigma_2 + \sigma_2/\sigma_1 - 2 \f$, 0 of a conformal map.
  double conformal = 0.;
  /// of areas: the root of the mean of \f$ \sigma_1 \sigma_2 + 1/(\sigma_1 \sigma_2) - 2 \f$, 0 where areas
  /// are kept.
  double authalic = 0.;
  double symmetric_dirichlet =
      0.;                   ///< the mean of `Face_distortion::symmetric_dirichlet()`, 4 at least
  double l2_stretch = 0.;   ///< the root of the mean of `Face_distortion::dirichlet()`
  double linf_stretch = 0.; ///< the largest `Face_distortion::linf_stretch()`
  /// of faces whose image is turned round or has no area, though they have one.
  std::size_t number_of_flips = 0;
  std::size_t number_of_faces = 0;
};

/// \ingroup PkgGeodesicProcessingLogMap
///
/// measures how a map to the plane distorts a mesh, whatever its scale.
///
/// Faces that have no area themselves do not count; the others whose image has none make means infinite.
///
/// \param uv_map as for `mesh_distortion()`
/// \param np `vertex_point_map`
///
/// O(n).
template <typename Mesh, typename UVMap, typename NamedParameters = internal::Default_parameters>
Flattening_distortion flattening_distortion(const Mesh& mesh, UVMap uv_map,
                                            const NamedParameters& np = NamedParameters())
{
  const auto for_each = [&](auto f)
  {
    for(const auto face : faces(mesh))
    {
      const Face_distortion distortion = face_distortion(face, mesh, uv_map, np);
      if(distortion.area > 0. && !std::isnan(distortion.sigma_1))
        f(distortion);
    }
  };
  double area = 0., image = 0.;
  for_each(
      [&](const Face_distortion& face)
      {
        area += face.area;
        image += face.area / (face.sigma_1 * face.sigma_2);
      });
  const double scale = std::sqrt(image / area);

  Flattening_distortion result;
  for_each(
      [&](Face_distortion face)
      {
        ++result.number_of_faces;
        result.number_of_flips += face.is_folded || std::isinf(face.sigma_1);
        face.sigma_1 *= scale;
        face.sigma_2 *= scale;
        const double area_fraction = face.area / area;
        // As squares: what is left of 1 + 1 - 2 would be rounding.
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
