// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_HODGE_DECOMPOSITION_H
#define CGAL_GEODESIC_PROCESSING_HODGE_DECOMPOSITION_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/field_vectors.h>
#include <CGAL/Geodesic_processing/internal/operators/hodge.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

namespace internal {

// Writes the values of halfedges, 3 #triangles numbers, to a map of edges. Both halfedges of an
// edge have the same value.
template <typename Domain, typename EdgeMap>
void write_edges(const Domain& domain, const std::vector<double>& values, EdgeMap map)
{
  const auto& mesh = domain.mesh();
  static_assert(
      is_keyed_by<EdgeMap, typename boost::graph_traits<Surface_of<Domain>>::edge_descriptor>,
      "rotation_potential_map is a property map with edges as keys.");
  for(Index f = 0; f < values.size() / 3; ++f)
  {
    auto h = halfedge(domain.face(f), mesh);
    for(Index k = 0; k < 3; ++k, h = next(h, mesh))
      put(map, edge(h, mesh), values[3 * std::size_t(f) + k]);
  }
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes the Hodge decomposition of a field of tangent vectors. The components are a gradient
/// field, a rotation field and a harmonic field, which are orthogonal to each other. The gradient
/// field flows from sources to sinks, and the rotation field consists of vortices. The harmonic
/// field has neither, and winds around handles and holes.
///
/// The gradient field is the gradient of a function on vertices, its potential, which is linear in
/// each face. The rotation field is the gradient of a function on edges, its potential, rotated by
/// a right angle counterclockwise. This function is linear in each face and given at the midpoints
/// of edges, where it is continuous. It is zero along the boundary. On each component, the harmonic
/// fields have dimension 2 genus + max(boundary loops - 1, 0). \cgalCite{cgal:pp-ivfs-03}
///
/// \tparam Mesh a model of `FaceListGraph`, or its domain
/// \tparam Field a model of `ReadablePropertyMap` with faces as keys and vectors as values
/// \tparam GradientMap a model of `WritablePropertyMap` with faces as keys and `Vector_3` as values
/// \tparam RotationMap as `GradientMap`
/// \tparam HarmonicMap as `GradientMap`
/// \param mesh a model of `FaceListGraph` or a `Mesh_domain`. On a cloud no rotation field is
///        defined, because its edges do not separate two triangles.
/// \param field a readable map of a `Vector_3` for each face; the normal component is ignored
/// \param gradient_map, rotation_map, harmonic_map receive a `Vector_3` for each face
/// \param np named parameters of `make_domain()`, and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{gradient_potential_map}
///     \cgalParamDescription{receives for each vertex the potential of the gradient field. Its
///       integral over each component is zero}
///     \cgalParamType{a model of `WritablePropertyMap` with vertices as keys and `double` as
///       values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{rotation_potential_map}
///     \cgalParamDescription{receives the potential of the rotation field at the midpoint of each
///       edge. Its integral over each component without boundary is zero}
///     \cgalParamType{a model of `WritablePropertyMap` with edges as keys and `double` as values}
///     \cgalParamDefault{nothing is written}
///     \cgalParamExtra{The value at a corner of a face is the sum of the values of its two edges at
///       the corner minus the value of the third edge.}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_rotation_potential_map}
///     \cgalParamDescription{receives for each vertex the value of a function that is linear in
///       each face and continuous, as in \cgalCite{cgal:srgb-emd-14}, section 4.1. Among the
///       functions that are zero along the boundary, its rotated gradient is closest to the field.
///       The rotation field contains this rotated gradient and is longer in general. The integral
///       over each component without boundary is zero}
///     \cgalParamType{a model of `WritablePropertyMap` with vertices as keys and `double` as
///       values}
///     \cgalParamDefault{nothing is written}
///     \cgalParamExtra{This potential takes a third factorization.}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre The map `field` has a value for each face.
/// \throws Invalid_argument_error if a vector is not finite
/// \throws Unsupported_surface_error if the surface is empty
///
/// Takes two factorizations.
template <typename Mesh, typename Field, typename GradientMap, typename RotationMap,
          typename HarmonicMap, typename NamedParameters = internal::Default_parameters,
          std::enable_if_t<!internal::is_named_parameters<HarmonicMap>, bool> = true>
void hodge_decomposition(const Mesh& mesh, Field field, GradientMap gradient_map,
                         RotationMap rotation_map, HarmonicMap harmonic_map,
                         const NamedParameters& np = NamedParameters())
{
  static_assert(!internal::Is_cloud<Surface_of<Mesh>>::value,
                "A cloud has no rotation part, because its edges do not separate two triangles: "
                "pass maps of the gradient and the remainder.");
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
  const internal::Operators operators = internal::operators(t);
  const internal::Hodge_components components =
      internal::Hodge_solver(t, operators).decompose(planar);
  using internal::has_parameter;
  constexpr bool has_vertex_rotation =
      has_parameter<NamedParameters, internal_np::vertex_rotation_potential_map_t>;
  internal::Vector vertex_rotation;
  if constexpr(has_vertex_rotation)
    vertex_rotation = internal::vertex_rotation_potential(t, operators, planar);
  internal::write_vectors(domain, components.gradient, gradient_map);
  internal::write_vectors(domain, components.rotation, rotation_map);
  internal::write_vectors(domain, components.harmonic, harmonic_map);
  // Gradients are those in the unit of the caller.
  if constexpr(has_parameter<NamedParameters, internal_np::gradient_potential_map_t>)
    domain.write([&](internal::Index i) { return t.scale * components.gradient_potential[i]; },
                 internal::parameter(np, internal_np::gradient_potential_map, 0));
  if constexpr(has_parameter<NamedParameters, internal_np::rotation_potential_map_t>)
  {
    std::vector<double> values = components.rotation_potential;
    for(double& value : values)
      value *= t.scale;
    internal::write_edges(domain, values,
                          internal::parameter(np, internal_np::rotation_potential_map, 0));
  }
  if constexpr(has_vertex_rotation)
    domain.write([&](internal::Index i) { return t.scale * vertex_rotation[i]; },
                 internal::parameter(np, internal_np::vertex_rotation_potential_map, 0));
}

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes the gradient component of a field of tangent vectors on a surfel cloud, and the
/// remainder. The remainder contains the rotation field and the harmonic field. They cannot be
/// separated, because the edges of a cloud do not separate two triangles.
///
/// The gradient field is the gradient of the function on surfels that is closest to the field on
/// the weighted triangles of the cloud. The sum of both components is the tangential component of
/// the field. If the field is smooth, both components converge to those of the surface as the
/// density increases. If coincident surfels have different vectors, the gradient is that of their
/// mean. Surfels without triangles have no gradient component.
///
/// \tparam SurfelRange a model of the concept `SurfelRange`, or its domain
/// \tparam Field a model of `ReadablePropertyMap` with surfels as keys and vectors as values
/// \tparam GradientMap a model of `WritablePropertyMap` with surfels as keys and `Vector_3` as
///         values
/// \tparam RemainderMap as `GradientMap`
/// \param surfels a cloud or a `Surfel_domain`
/// \param field a readable map of a `Vector_3` for each surfel; the normal component is ignored
/// \param gradient_map, remainder_map receive a `Vector_3` for each surfel, in its tangent plane
/// \param np named parameters of `make_domain()`, and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{gradient_potential_map}
///     \cgalParamDescription{receives for each surfel the value of the function whose gradient is
///       taken. Its integral over the weighted triangles of each component is zero. It is zero at
///       surfels without triangles}
///     \cgalParamType{a model of `WritablePropertyMap` with surfels as keys and `double` as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre The map `field` has a value for each surfel.
/// \throws Invalid_argument_error if a vector is not finite
/// \throws Unsupported_surface_error if the surface is empty
///
/// Takes one factorization.
template <typename SurfelRange, typename Field, typename GradientMap, typename RemainderMap,
          typename NamedParameters = internal::Default_parameters,
          std::enable_if_t<internal::is_named_parameters<NamedParameters>, bool> = true>
void hodge_decomposition(const SurfelRange& surfels, Field field, GradientMap gradient_map,
                         RemainderMap remainder_map, const NamedParameters& np = NamedParameters())
{
  static_assert(internal::Is_cloud<Surface_of<SurfelRange>>::value,
                "A mesh has three components: pass maps of the gradient, the rotation and the "
                "harmonic field.");
  static_assert(
      !internal::has_parameter<NamedParameters, internal_np::rotation_potential_map_t> &&
          !internal::has_parameter<NamedParameters, internal_np::vertex_rotation_potential_map_t>,
      "A cloud has no rotation part and no potential of it.");
  const auto domain = make_domain(surfels, np);
  using Vector_3 = typename std::decay_t<decltype(domain)>::Vector_3;
  std::vector<internal::Vec3> vectors(domain.number_of_vertices());
  for(internal::Index i = 0; i < vectors.size(); ++i)
  {
    const auto vector = get(field, domain.vertex(i));
    vectors[i] = {to_double(vector.x()), to_double(vector.y()), to_double(vector.z())};
    for(const double component : vectors[i])
      if(!std::isfinite(component))
        throw Invalid_argument_error("A vector of the field is not finite.");
  }
  const internal::Surfel_field_components components =
      internal::gradient_and_remainder(*domain.triangles(), std::move(vectors));
  const auto write = [&](const std::vector<internal::Vec3>& component, auto map)
  {
    domain.write([&](internal::Index i)
                 { return Vector_3(component[i][0], component[i][1], component[i][2]); },
                 map);
  };
  write(components.gradient, gradient_map);
  write(components.remainder, remainder_map);
  if constexpr(internal::has_parameter<NamedParameters, internal_np::gradient_potential_map_t>)
    domain.write([&, scale = domain.triangles()->scale](internal::Index i)
                 { return scale * components.potential[i]; },
                 internal::parameter(np, internal_np::gradient_potential_map, 0));
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_HODGE_DECOMPOSITION_H
