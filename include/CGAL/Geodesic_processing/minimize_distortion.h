// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_MINIMIZE_DISTORTION_H
#define CGAL_GEODESIC_PROCESSING_MINIMIZE_DISTORTION_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/parameterization/symmetric_dirichlet.h>
#include <CGAL/Geodesic_processing/internal/parameterization/tutte_map.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/adaptors/planar_value.h>
#include <CGAL/Geodesic_processing/internal/parameterization/untangling.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingFlattening
/// The summary of a call of `minimize_distortion()`.
struct Distortion_minimum
{
  std::size_t number_of_flips_before = 0; ///< inverted or degenerate faces of the given map
  std::size_t number_of_flips = 0;        ///< inverted or degenerate faces of the resulting map
  std::size_t number_of_iterations = 0;   ///< steps of Newton's method
  double symmetric_dirichlet = 0.;        ///< the final mean energy per area, at least 4
};

/// \ingroup PkgGeodesicProcessingFlattening
///
/// Minimizes the symmetric Dirichlet energy \cgalCite{cgal:ss-bpfb-15} of a map of a mesh to the
/// plane without inverting faces.
///
/// The energy is infinite if a face has no area, and each Newton step stops before the first
/// inversion. If the given map has few inverted faces, they are unflipped first by minimizing a
/// regularized energy, which is finite for inverted faces. \cgalCite{cgal:gkkprs-ffm-21} If this
/// fails, the map is replaced by Tutte's map. \cgalCite{cgal:t-hdg-63} It has no inverted faces,
/// except due to round-off errors on thin triangles; `Distortion_minimum::number_of_flips` counts
/// these.
///
/// Lengths on the mesh are preserved as well as possible. The image may still overlap itself if the
/// images of boundary edges intersect.
///
/// \tparam Surface a model of `FaceListGraph`, or its domain
/// \tparam UVMap a model of `ReadWritePropertyMap` with vertices as keys and `Point_2` or arrays of
///         two numbers as values
/// \param mesh a triangle mesh or its domain: a topological disk, possibly with holes
/// \param uv_map a property map of vertices that is read and written: values are `Point_2` or
///        arrays
/// \param np parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_number_of_iterations}
///     \cgalParamDescription{maximum number of Newton steps}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{200}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the fraction done. If it returns false,
///       the function throws `Cancelled`}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre The UV map has a value for each vertex.
/// \returns the numbers of inverted faces and of steps, and the energy
/// \throws Unsupported_surface_error if the mesh is not connected, has no boundary, has handles, or
///         touches itself at a vertex
/// \throws Invalid_argument_error if a value of the map is not finite
/// \throws Cancelled if the callback returns false
///
/// Takes a factorization of a matrix with two unknowns per vertex in each step. The iteration ends if
/// a step decreases the energy by less than 10<SUP>-6</SUP> of it. About ten steps are needed, and
/// up to a hundred if the iteration starts at Tutte's map. Convergence is slow if large parts must
/// rotate: on a maze, it ends at the energy 4.005 from the map of `geodesic_lle()`, although the
/// minimum is 4.
template <typename Surface, typename UVMap, typename NamedParameters = internal::Default_parameters>
Distortion_minimum minimize_distortion(const Surface& mesh, UVMap uv_map,
                                       const NamedParameters& np = NamedParameters())
{
  using Value = typename boost::property_traits<UVMap>::value_type;
  const auto domain = make_domain(mesh, np);
  static_assert(internal::require_support<Function::minimize_distortion,
                                          typename decltype(domain)::Surface>());
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
      internal::read_callback(np));
  if(!found.is_complete)
    throw Cancelled();
  result.number_of_flips = number_of_flips(triangles, image);
  result.number_of_iterations = found.number_of_iterations;
  result.symmetric_dirichlet = found.energy;
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
