// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_IS_SUPPORTED_H
#define CGAL_GEODESIC_PROCESSING_IS_SUPPORTED_H

#include <CGAL/Geodesic_processing/Location.h>

// The functions and classes of this package that take a surface: those for meshes and clouds, those
// for meshes only, and those for clouds only. The latter two state the reason in a sentence that
// the compiler prints. The manual has the same table.
#define CGAL_GEODESIC_PROCESSING_FUNCTIONS(BOTH, MESHES, CLOUDS)                                   \
  BOTH(make_domain)                                                                                \
  BOTH(locate_on_surface)                                                                          \
  BOTH(Surface_locator)                                                                            \
  MESHES(border_sources, "A cloud has no boundary cycles, because its triangles overlap.")         \
  BOTH(geodesic_distances)                                                                         \
  BOTH(Geodesic_distance_solver)                                                                   \
  BOTH(geodesic_distance_matrix)                                                                   \
  BOTH(sparse_geodesic_distance_matrix)                                                            \
  BOTH(write_geodesic_distance_matrix)                                                             \
  MESHES(geodesic_distance_derivatives,                                                            \
         "The local triangles of a cloud change if surfels move: use a mesh.")                     \
  MESHES(isolines, "The triangles of a cloud overlap: lines on them cross.")                       \
  MESHES(split_at_isolines, "The triangles of a cloud overlap: they cannot be cut.")               \
  MESHES(geodesic_ball, "The triangles of a cloud overlap: they cannot be cut.")                   \
  BOTH(geodesic_eccentricity)                                                                      \
  MESHES(geodesic_diameter, "Bounds need exact distances, which need a mesh.")                     \
  MESHES(geodesic_radius, "Bounds need exact distances, which need a mesh.")                       \
  BOTH(geodesic_path)                                                                              \
  BOTH(Geodesic_path_finder)                                                                       \
  BOTH(shorten_polyline)                                                                           \
  MESHES(geodesic_bezier_curve,                                                                    \
         "Paths on a cloud end at projections of their ends: subdivision would add these errors.") \
  MESHES(geodesic_spline,                                                                          \
         "Paths on a cloud end at projections of their ends: subdivision would add these errors.") \
  BOTH(geodesic_polyline)                                                                          \
  MESHES(shorten_loop, "The triangles of a cloud overlap: loops on them have no homotopy class.")  \
  MESHES(loop_basis, "The triangles of a cloud overlap: it has no genus.")                         \
  MESHES(shortest_noncontractible_loop, "The triangles of a cloud overlap: it has no genus.")      \
  BOTH(straightest_geodesic)                                                                       \
  CLOUDS(surfel_geodesic_path, "The energy is that of surfels: use geodesic_path() on a mesh.")    \
  CLOUDS(Surfel_path_finder, "The energy is that of surfels: use Geodesic_path_finder on a mesh.") \
  BOTH(principal_curvatures)                                                                       \
  BOTH(curvature_speeds)                                                                           \
  BOTH(similar_curvature_speeds)                                                                   \
  BOTH(image_speeds)                                                                               \
  BOTH(farthest_point_sampling)                                                                    \
  BOTH(farthest_vertex_sampling)                                                                   \
  BOTH(geodesic_voronoi_diagram)                                                                   \
  MESHES(geodesic_voronoi_cells, "The triangles of a cloud overlap: they cannot be cut.")          \
  BOTH(geodesic_centroidal_tessellation)                                                           \
  BOTH(geodesic_delaunay_remeshing)                                                                \
  BOTH(geodesic_base_mesh)                                                                         \
  BOTH(Base_parameterization)                                                                      \
  BOTH(parameterize_over_base)                                                                     \
  BOTH(semi_regular_remeshing)                                                                     \
  MESHES(Subdivision_wavelet, "A cloud has no faces, from which the levels of wavelets follow.")   \
  BOTH(logarithmic_map)                                                                            \
  BOTH(Logarithmic_map)                                                                            \
  BOTH(exponential_map)                                                                            \
  BOTH(Decal_placer)                                                                               \
  BOTH(composite_decal)                                                                            \
  MESHES(bake_decals, "A cloud has no faces, which a texture needs: use composite_decal().")       \
  BOTH(geodesic_lle)                                                                               \
  BOTH(geodesic_mds)                                                                               \
  MESHES(minimize_distortion, "The triangles of a cloud overlap: no map of them is one-to-one.")   \
  MESHES(face_distortion, "A cloud has no faces: use surface_distortion().")                       \
  BOTH(surface_distortion)                                                                         \
  BOTH(flattening_distortion)                                                                      \
  BOTH(texture_atlas)                                                                              \
  MESHES(bake_atlas, "A cloud has no faces: texture_atlas() creates a mesh with a texture.")       \
  BOTH(earth_movers_distance)                                                                      \
  BOTH(Earth_movers_solver)                                                                        \
  BOTH(transport_streamlines)                                                                      \
  BOTH(transport_to_region)                                                                        \
  BOTH(Region_transport_solver)                                                                    \
  BOTH(feature_distance)                                                                           \
  BOTH(transport_barycenter)                                                                       \
  BOTH(Transport_barycenter_solver)                                                                \
  BOTH(geodesic_barycenter)                                                                        \
  BOTH(karcher_mean)                                                                               \
  BOTH(fuzzy_geodesic)                                                                             \
  BOTH(fuzzy_geodesic_by_distances)                                                                \
  BOTH(Transport_metric)                                                                           \
  BOTH(Biharmonic_metric)                                                                          \
  BOTH(hodge_decomposition)                                                                        \
  MESHES(mean_value_coordinates,                                                                   \
         "A cloud encloses no volume: the coordinates need a closed mesh.")                        \
  MESHES(volumetric_distance, "A cloud encloses no volume: the distance needs a closed mesh.")     \
  MESHES(Volumetric_metric, "A cloud encloses no volume: the metric needs a closed mesh.")

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDomain
/// Names a function or class of this package that takes a surface. The enumerators have the names
/// of these functions and classes.
enum class Function
{
#define CGAL_GEODESIC_PROCESSING_NAME(name, ...) name,
  CGAL_GEODESIC_PROCESSING_FUNCTIONS(CGAL_GEODESIC_PROCESSING_NAME, CGAL_GEODESIC_PROCESSING_NAME,
                                     CGAL_GEODESIC_PROCESSING_NAME)
#undef CGAL_GEODESIC_PROCESSING_NAME
};

namespace internal {

// The support of a function for meshes and for clouds. check() fails to compile with the reason if
// there is none.
template <Function function>
struct Support;

#define CGAL_GEODESIC_PROCESSING_SUPPORT(name, on_meshes, on_clouds, reason)                       \
  template <>                                                                                      \
  struct Support<Function::name>                                                                   \
  {                                                                                                \
    static constexpr bool meshes = on_meshes, clouds = on_clouds;                                  \
    template <bool is_supported>                                                                   \
    static constexpr bool check()                                                                  \
    {                                                                                              \
      static_assert(is_supported, reason);                                                         \
      return true;                                                                                 \
    }                                                                                              \
  };
#define CGAL_GEODESIC_PROCESSING_BOTH(name) CGAL_GEODESIC_PROCESSING_SUPPORT(name, true, true, "")
#define CGAL_GEODESIC_PROCESSING_MESHES(name, reason)                                              \
  CGAL_GEODESIC_PROCESSING_SUPPORT(name, true, false, reason)
#define CGAL_GEODESIC_PROCESSING_CLOUDS(name, reason)                                              \
  CGAL_GEODESIC_PROCESSING_SUPPORT(name, false, true, reason)
CGAL_GEODESIC_PROCESSING_FUNCTIONS(CGAL_GEODESIC_PROCESSING_BOTH, CGAL_GEODESIC_PROCESSING_MESHES,
                                   CGAL_GEODESIC_PROCESSING_CLOUDS)
#undef CGAL_GEODESIC_PROCESSING_CLOUDS
#undef CGAL_GEODESIC_PROCESSING_MESHES
#undef CGAL_GEODESIC_PROCESSING_BOTH
#undef CGAL_GEODESIC_PROCESSING_SUPPORT

} // namespace internal

/// \ingroup PkgGeodesicProcessingDomain
/// Whether a function or class accepts a surface: `is_supported_v<Function::texture_atlas, Mesh>`.
/// If it is `false`, a call does not compile, and the compiler prints the reason.
///
/// \tparam function the name of the function or class
/// \tparam Surface a mesh, a cloud, or the domain of one of them
template <Function function, typename Surface>
inline constexpr bool is_supported_v =
    internal::Is_cloud<Surface_of<Surface>>::value ? internal::Support<function>::clouds
                                                   : internal::Support<function>::meshes;

namespace internal {

// Fails to compile, with the reason, if a function does not accept a surface.
template <Function function, typename Surface>
constexpr bool require_support()
{
  return Support<function>::template check<is_supported_v<function, Surface>>();
}

} // namespace internal
} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_IS_SUPPORTED_H
