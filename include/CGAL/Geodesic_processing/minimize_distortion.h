// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_MINIMIZE_DISTORTION_H
#define CGAL_GEODESIC_PROCESSING_MINIMIZE_DISTORTION_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/parameterization/symmetric_dirichlet.h>
#include <CGAL/Geodesic_processing/internal/parameterization/tutte_map.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/adaptors/planar_value.h>
#include <CGAL/Geodesic_processing/internal/parameterization/untangling.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingFlattening
/// what `minimize_distortion()` has done.
struct Distortion_minimum
{
  std::size_t number_of_flips_before = 0; ///< in the map that was given
  std::size_t number_of_flips = 0;        ///< in the one that was made
  std::size_t number_of_steps = 0;
  double symmetric_dirichlet = 0.; ///< its mean, 4 at least
  bool is_complete = true;         ///< false: the callback cancelled it
};

/// \ingroup PkgGeodesicProcessingFlattening
///
/// moves a map of a mesh to the plane to where its symmetric Dirichlet energy \cgalCite{cgal:ss-bpfb-15} is
/// least, without flips.
///
/// The energy is infinite where a face loses its area, so that none is turned round on the way: Newton's method
/// stops short of that.  Flips of the map that is given are turned back where they are few, for which the energy is
/// made finite there \cgalCite{cgal:gkkprs-ffm-21}.  A map that has more is replaced by Tutte's
/// \cgalCite{cgal:t-hdg-63}, which has none but for rounding on needles, and the way starts from there;
/// `Distortion_minimum::number_of_flips` counts those.  Lengths along the mesh are kept as well as they can; the image may still
/// overlap itself, where the border meets itself.
///
/// \param mesh a triangle mesh, or its domain: a disk, maybe with holes
/// \param uv_map of vertices, read and written: values are `Point_2` or arrays
/// \param np what `make_domain()` takes, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_number_of_iterations} \cgalParamDescription{steps of Newton's method}
///     \cgalParamDefault{200} \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a `std::function<bool(double)>` that is told the fraction done and cancels by
///       returning false: what was found until then has no flips either} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Unsupported_surface_error when the mesh is not one piece, has no border, or has handles,
///         or touches itself at a vertex
/// \throws Invalid_argument_error when a value of the map is not finite
///
/// Each step factorizes a matrix of two unknowns a vertex; some ten of them, up to a hundred from Tutte's map.
template <typename Surface, typename UVMap, typename NamedParameters = internal::Default_parameters>
Distortion_minimum minimize_distortion(const Surface& mesh, UVMap uv_map,
                                       const NamedParameters& np = NamedParameters())
{
  using Value = typename boost::property_traits<UVMap>::value_type;
  const auto domain = make_domain(mesh, np);
  static_assert(!internal::Is_cloud<typename decltype(domain)::Surface>::value,
                "Flips are of faces; a surfel cloud has none.");
  const internal::Surface_arrays& triangles = *domain.triangles();
  std::vector<internal::Vec2> image(domain.number_of_vertices());
  for(internal::Index i = 0; i < image.size(); ++i)
  {
    const auto& value = get(uv_map, domain.vertex(i));
    image[i] = {CGAL::to_double(value[0]) / triangles.scale,
                CGAL::to_double(value[1]) / triangles.scale};
  }
  check_is_disk(triangles);
  for(internal::Index i = 0; i < image.size(); ++i)
    if(triangles.ring_begin[i] < triangles.ring_begin[i + 1] &&
       !(std::isfinite(image[i][0]) && std::isfinite(image[i][1])))
      throw Invalid_argument_error("A value of the map is not finite.");

  Distortion_minimum result;
  result.number_of_flips_before = number_of_flips(triangles, image);
  if(result.number_of_flips_before > 0)
    untangle(triangles, image);
  if(number_of_flips(triangles, image) > 0)
    image = tutte_map(triangles);
  const internal::Minimization_result found = minimize_symmetric_dirichlet(
      triangles, image,
      internal::parameter(np, internal_np::maximum_number_of_iterations, std::size_t(200)),
      internal::parameter(np, CGAL::internal_np::callback, std::function<bool(double)>()));
  result.number_of_flips = number_of_flips(triangles, image);
  result.number_of_steps = found.number_of_steps;
  result.symmetric_dirichlet = found.energy;
  result.is_complete = found.is_complete;
  domain.write(
      [&](internal::Index i)
      {
        return internal::planar_value<Value>(triangles.scale * image[i][0],
                                             triangles.scale * image[i][1]);
      },
      uv_map);
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_MINIMIZE_DISTORTION_H
