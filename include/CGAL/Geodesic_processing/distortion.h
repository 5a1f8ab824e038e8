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
/// The distortion of one face by a map of a mesh to the plane.
///
/// It is described by the singular values of the Jacobian of the inverse map, from the plane to the
/// face.
struct Face_distortion
{
  double sigma_1 = 1.,
         sigma_2 = 1.;    ///< \f$ \sigma_1 \geq \sigma_2 \f$; infinite if the image has no area
  bool is_folded = false; ///< true if the image is clockwise (inverted)
  double area = 0.;       ///< the area of the face on the surface

  /// \name Measures
  /// Distortion measures of the literature.
  ///
  /// `mips()`, `symmetric_mips()` and `conformal()` measure angles: they are minimal if
  /// \f$ \sigma_1 = \sigma_2 \f$. `dirichlet()`, `l2_stretch()` and `linf_stretch()` increase with
  /// the singular values. The others are minimal if \f$ \sigma_1 = \sigma_2 = 1 \f$.
  /// @{

  /// Returns \f$ \sigma_1 / \sigma_2 \f$ (Hormann and Greiner 2000, without the reciprocal term).
  double mips() const { return sigma_1 / sigma_2; }
  /// Returns \f$ \sigma_1 / \sigma_2 + \sigma_2 / \sigma_1 \f$.
  double symmetric_mips() const { return sigma_1 / sigma_2 + sigma_2 / sigma_1; }
  /// Returns the conformal energy \f$ (\sigma_1 - \sigma_2)^2 / 2 \f$.
  double conformal() const { return 0.5 * (sigma_1 - sigma_2) * (sigma_1 - sigma_2); }
  /// Returns \f$ (\sigma_1^2 - 1)^2 + (\sigma_2^2 - 1)^2 \f$.
  double green_lagrange() const
  {
    const double a = sigma_1 * sigma_1 - 1., b = sigma_2 * sigma_2 - 1.;
    return a * a + b * b;
  }
  /// Returns a measure of angles and areas: \f$ (\sigma_1/\sigma_2 + \sigma_2/\sigma_1)
  /// (\sigma_1 \sigma_2 + 1/(\sigma_1 \sigma_2))^\theta \f$ (Degener, Meseth and Klein 2003).
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

// Returns the image of the corner that a halfedge points to. The keys of the map are vertices or
// halfedges.
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
/// Computes the distortion of a face by a map to the plane.
///
/// \tparam Mesh a model of `FaceListGraph`
/// \tparam UVMap a model of `ReadablePropertyMap` with vertices or halfedges as keys and `Point_2`
///         or arrays of two numbers as values
/// \param face a triangle of `mesh`
/// \param mesh a model of `FaceListGraph`
/// \param uv_map the UV map: a property map of vertices or of halfedges. For a halfedge it gives
///        the image of the corner that the halfedge points to. Values are `Point_2` or arrays.
/// \param np `vertex_point_map`
/// \returns the singular values of the map, the area of the face, and whether its image is inverted
///
/// O(1).
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

/// \ingroup PkgGeodesicProcessingLogMap
/// A distortion measure, summarized over all faces that have an image.
template <typename Mesh>
struct Mesh_distortion
{
  using Face = typename boost::graph_traits<Mesh>::face_descriptor;

  double integral = 0.; ///< the integral of the measure over the area of the faces
  double area = 0.;     ///< the total area of these faces
  double worst = 0.;    ///< the largest value of the measure
  Face worst_face = boost::graph_traits<Mesh>::null_face();
  std::size_t number_of_faces = 0;
  std::size_t number_of_folded_faces = 0;

  /// Returns the mean of the measure, weighted by area.
  double mean() const { return integral / area; }
};

/// \ingroup PkgGeodesicProcessingLogMap
///
/// Computes the integral, the mean and the maximum of a distortion measure over a mesh.
///
/// \tparam Mesh a model of `FaceListGraph`
/// \tparam UVMap a model of `ReadablePropertyMap` with vertices or halfedges as keys and `Point_2`
///         or arrays of two numbers as values
/// \tparam Measure a function object, or a pointer to a member of `Face_distortion`
/// \param mesh a triangle mesh
/// \param uv_map as for `face_distortion()`. If a corner of a face has NaN coordinates, the face is
///        ignored. These are the faces outside of the domain of a logarithmic map.
/// \param measure a function of a `Face_distortion`, such as `&Face_distortion::conformal`
/// \param np `vertex_point_map`
/// \returns the integral, the maximum and the numbers of faces
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
/// The distortion of a mesh by a map to the plane, in the usual measures for comparing flattenings.
///
/// All values refer to the map scaled to the area of the mesh. Means are weighted by the area of
/// the faces.
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
  /// The number of faces of positive area whose image is inverted or has no area.
  std::size_t number_of_flips = 0;
  /// The number of faces of positive area that have an image.
  std::size_t number_of_faces = 0;
};

/// \ingroup PkgGeodesicProcessingLogMap
///
/// Computes the distortion of a mesh by a map to the plane, independently of the map's scale.
///
/// Faces without area are ignored. If the image of any other face has no area, the means are
/// infinite.
///
/// \tparam Mesh a model of `FaceListGraph`
/// \tparam UVMap a model of `ReadablePropertyMap` with vertices or halfedges as keys and `Point_2`
///         or arrays of two numbers as values
/// \param mesh a triangle mesh
/// \param uv_map as for `mesh_distortion()`
/// \param np `vertex_point_map`
/// \returns the distortion in several measures
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
