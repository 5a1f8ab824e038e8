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
/// computes the Hodge decomposition of a field of tangent vectors. The components are a gradient
/// field, a rotation field and a harmonic field, which are orthogonal to each other. The gradient
/// field flows from sources to sinks, and the rotation field consists of vortices. The harmonic
/// field has neither, and winds around handles and holes.
///
/// The gradient field is the gradient of a function on vertices. The rotation field is the gradient
/// of a function on edges, rotated by a right angle; this function is constant along the boundary.
/// On each component, the harmonic fields have dimension 2 genus + max(boundary loops - 1, 0).
/// \cgalCite{cgal:pp-ivfs-03}
///
/// \tparam Mesh a model of `FaceListGraph`, or its domain
/// \tparam Field a model of `ReadablePropertyMap` with faces as keys and vectors as values
/// \tparam GradientMap a model of `WritablePropertyMap` with faces as keys and `Vector_3` as values
/// \tparam RotationMap as `GradientMap`
/// \tparam HarmonicMap as `GradientMap`
/// \param mesh a model of `FaceListGraph` or a `Mesh_domain`. A cloud is not supported, because it
///        lacks the edges.
/// \param field a readable map of a `Vector_3` for each face; the normal component is ignored
/// \param gradient_map, rotation_map, harmonic_map receive a `Vector_3` for each face
/// \param np named parameters of `make_domain()`
/// \throws Invalid_argument_error if a vector is not finite
///
/// Takes two factorizations.
template <typename Mesh, typename Field, typename GradientMap, typename RotationMap,
          typename HarmonicMap, typename NamedParameters = internal::Default_parameters>
void hodge_decomposition(const Mesh& mesh, Field field, GradientMap gradient_map,
                         RotationMap rotation_map, HarmonicMap harmonic_map,
                         const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(mesh, np);
  static_assert(!internal::Is_cloud<Surface_of<Mesh>>::value,
                "The decomposition needs a mesh, because a cloud has no faces.");
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
