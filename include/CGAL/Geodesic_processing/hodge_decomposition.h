// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_HODGE_DECOMPOSITION_H
#define CGAL_GEODESIC_PROCESSING_HODGE_DECOMPOSITION_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/field_vectors.h>
#include <CGAL/Geodesic_processing/internal/operators/hodge.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <cmath>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// splits a field of tangent vectors into three that are orthogonal to each other: one that comes from
/// sources and goes to sinks, one that turns around places, and one that does neither, but winds around
/// handles and holes.
///
/// The first is the gradient of a function of vertices, the second the quarter turn of the gradient of a
/// function of edges that is constant along the border; of the third there are, for each component,
/// 2 genus + max(border loops - 1, 0) independent ones.  \cgalCite{cgal:pp-ivfs-03}
///
/// \param mesh a model of `FaceListGraph` or a `Mesh_domain`; a cloud does not have the edges
/// \param field a readable map of a `Vector_3` for each face; what is normal to the face is left out
/// \param gradient_map, rotation_map, harmonic_map receive a `Vector_3` for each face
/// \param np what `make_domain()` takes
/// \throws Invalid_argument_error when a vector is not finite
///
/// Two factorizations.
template <typename Mesh, typename Field, typename GradientMap, typename RotationMap,
          typename HarmonicMap, typename NamedParameters = internal::Default_parameters>
void hodge_decomposition(const Mesh& mesh, Field field, GradientMap gradient_map,
                         RotationMap rotation_map, HarmonicMap harmonic_map,
                         const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(mesh, np);
  const internal::Surface_arrays& t = *domain.triangles();
  internal::Field planar(t.number_of_triangles());
  for(internal::Index f = 0; f < planar.size(); ++f)
  {
    const auto vector = get(field, domain.face(f));
    planar[f] = internal::in_plane(
        t, f, {to_double(vector.x()), to_double(vector.y()), to_double(vector.z())});
    if(!std::isfinite(planar[f][0]) || !std::isfinite(planar[f][1]))
      throw Invalid_argument_error("A vector of the field is not finite.");
  }
  const internal::Hodge_components components =
      internal::Hodge_solver(t, internal::operators(t)).decompose(planar);
  internal::write_vectors(domain, components.gradient, gradient_map);
  internal::write_vectors(domain, components.rotation, rotation_map);
  internal::write_vectors(domain, components.harmonic, harmonic_map);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_HODGE_DECOMPOSITION_H
