// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_PARAMETERS_H
#define CGAL_GEODESIC_PROCESSING_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <type_traits>
#include <utility>

namespace CGAL::Geodesic_processing {

// The names of the parameters of this package. For each name there is a tag, and a function that
// extends a chain of parameters.
#define CGAL_GEODESIC_PROCESSING_OWN_NAMES(NAME)                                                   \
  NAME(method)                                                                                     \
  NAME(maximum_distance)                                                                           \
  NAME(targets)                                                                                    \
  NAME(row_range)                                                                                  \
  NAME(region_map)                                                                                 \
  NAME(row_region_map)                                                                             \
  NAME(do_average_regions)                                                                         \
  NAME(tile_size)                                                                                  \
  NAME(speed_map)                                                                                  \
  NAME(face_speed_map)                                                                             \
  NAME(relative_tolerance)                                                                         \
  NAME(vertex_tolerance)                                                                           \
  NAME(second_path_tolerance)                                                                      \
  NAME(heat_time_step)                                                                             \
  NAME(source_label_map)                                                                           \
  NAME(predecessor_map)                                                                            \
  NAME(merge_tolerance)                                                                            \
  NAME(do_remove_degenerate_faces)                                                                 \
  NAME(radius_map)                                                                                 \
  NAME(number_of_threads)                                                                          \
  NAME(covering_radius)                                                                            \
  NAME(covering_radius_output)                                                                     \
  NAME(first_samples)                                                                              \
  NAME(face_label_map)                                                                             \
  NAME(bisector_output)                                                                            \
  NAME(ball_radius)                                                                                \
  NAME(too_few_samples)                                                                            \
  NAME(number_of_relaxation_steps)                                                                 \
  NAME(maximum_deviation)                                                                          \
  NAME(do_fit)                                                                                     \
  NAME(do_avoid_self_intersections)                                                                \
  NAME(sharp_angle)                                                                                \
  NAME(curve_spacing)                                                                              \
  NAME(edge_spacing_map)                                                                           \
  NAME(location_map)                                                                               \
  NAME(edge_path_output)                                                                           \
  NAME(do_fit_circles)                                                                             \
  NAME(do_shorten)                                                                                 \
  NAME(do_close)                                                                                   \
  NAME(maximum_number_of_edges)                                                                    \
  NAME(maximum_perimeter)                                                                          \
  NAME(hole_filling_method)                                                                        \
  NAME(face_output)                                                                                \
  NAME(strength)                                                                                   \
  NAME(surfel_path_method)                                                                         \
  NAME(surfel_noise)                                                                               \
  NAME(surfel_graph)                                                                               \
  NAME(surfel_search)                                                                              \
  NAME(number_of_control_points)                                                                   \
  NAME(node_weight)                                                                                \
  NAME(segment_weight)                                                                             \
  NAME(do_enforce_guarantees)                                                                      \
  NAME(outlier_percentage)                                                                         \
  NAME(number_of_neighbors)                                                                        \
  NAME(stencil_length)                                                                             \
  NAME(stencil_size)                                                                               \
  NAME(number_of_smoothing_steps)                                                                  \
  NAME(number_of_base_refinements)                                                                 \
  NAME(up_direction)                                                                               \
  NAME(tolerance)                                                                                  \
  NAME(maximum_number_of_iterations)                                                               \
  NAME(number_of_refinements)                                                                      \
  NAME(metric_map)                                                                                 \
  NAME(face_metric_map)                                                                            \
  NAME(transport_flow)                                                                             \
  NAME(potential_map)                                                                              \
  NAME(gradient_potential_map)                                                                     \
  NAME(rotation_potential_map)                                                                     \
  NAME(vertex_rotation_potential_map)                                                              \
  NAME(flow_map)                                                                                   \
  NAME(arrival_map)                                                                                \
  NAME(capacities)                                                                                 \
  NAME(spreading_weight)                                                                           \
  NAME(smoothing_radius)                                                                           \
  NAME(weights)                                                                                    \
  NAME(barycentric_coordinates)                                                                    \
  NAME(objective_map)                                                                              \
  NAME(initial_location)                                                                           \
  NAME(do_normalize)                                                                               \
  NAME(do_bound_from_above)                                                                        \
  NAME(do_start_from_last)                                                                         \
  NAME(do_fix_masses)                                                                              \
  NAME(do_make_discs)                                                                              \
  NAME(center_output)                                                                              \
  NAME(energy_output)                                                                              \
  NAME(do_straighten)                                                                              \
  NAME(width)                                                                                      \
  NAME(base_points)                                                                                \
  NAME(number_of_base_points)                                                                      \
  NAME(flattening_start)                                                                           \
  NAME(number_of_rigid_steps)                                                                      \
  NAME(texture_size)                                                                               \
  NAME(gutter_width)                                                                               \
  NAME(chart_map)                                                                                  \
  NAME(background)                                                                                 \
  NAME(base_coordinates)                                                                           \
  NAME(subdivision_scheme)                                                                         \
  NAME(level_map)                                                                                  \
  NAME(number_of_levels)                                                                           \
  NAME(number_of_subdivisions)                                                                     \
  NAME(degree)                                                                                     \
  NAME(is_closed)                                                                                  \
  NAME(wavelet_prediction)                                                                         \
  NAME(do_update)                                                                                  \
  NAME(do_use_frames)                                                                              \
  NAME(number_of_bit_planes)                                                                       \
  NAME(maximum_number_of_bytes)                                                                    \
  NAME(maximum_number_of_vertices)

namespace internal_np {

#define CGAL_GEODESIC_PROCESSING_TAG(X) enum X##_t{X};
CGAL_GEODESIC_PROCESSING_OWN_NAMES(CGAL_GEODESIC_PROCESSING_TAG)
#undef CGAL_GEODESIC_PROCESSING_TAG

} // namespace internal_np

/// The named parameters of this package and, in addition, those of \cgal. A chain can mix the names
/// of this package with the names of \cgal that its functions read, for example `vertex_point_map`
/// and `callback`. Other names of \cgal must follow at the end of the chain.
namespace parameters {

using namespace CGAL::parameters;

/// Represents a chain of named parameters. Functions of \cgal can read it as one of their own
/// chains. In addition, it can be extended by the names of this package.
template <typename NamedParameters>
struct Chain : NamedParameters
{
  using NamedParameters::NamedParameters;
  explicit Chain(const NamedParameters& np) : NamedParameters(np) {}

  const NamedParameters& plain() const { return *this; }

// Generates the functions for the names of this package, and for names of CGAL. The tags of the
// latter differ from the names.
#define CGAL_GEODESIC_PROCESSING_LINKS                                                             \
  CGAL_GEODESIC_PROCESSING_OWN_NAMES(CGAL_GEODESIC_PROCESSING_OWN_LINK)                            \
  CGAL_GEODESIC_PROCESSING_LINK(CGAL::internal_np::edge_is_constrained_t, edge_is_constrained_map) \
  CGAL_GEODESIC_PROCESSING_LINK(CGAL::internal_np::callback_t, callback)                           \
  CGAL_GEODESIC_PROCESSING_LINK(CGAL::internal_np::random_seed_t, random_seed)                     \
  CGAL_GEODESIC_PROCESSING_LINK(CGAL::internal_np::vertex_point_t, vertex_point_map)               \
  CGAL_GEODESIC_PROCESSING_LINK(CGAL::internal_np::vertex_index_t, vertex_index_map)               \
  CGAL_GEODESIC_PROCESSING_LINK(CGAL::internal_np::face_index_t, face_index_map)                   \
  CGAL_GEODESIC_PROCESSING_LINK(CGAL::internal_np::point_t, point_map)                             \
  CGAL_GEODESIC_PROCESSING_LINK(CGAL::internal_np::normal_t, normal_map)                           \
  CGAL_GEODESIC_PROCESSING_LINK(CGAL::internal_np::geom_traits_t, geom_traits)
#define CGAL_GEODESIC_PROCESSING_OWN_LINK(X)                                                       \
  CGAL_GEODESIC_PROCESSING_LINK(Geodesic_processing::internal_np::X##_t, X)

// The functions that extend a chain.
#define CGAL_GEODESIC_PROCESSING_LINK(TAG, X)                                                      \
  template <typename T>                                                                            \
  auto X(const T& value) const                                                                     \
  {                                                                                                \
    using Link = CGAL::Named_function_parameters<T, TAG, NamedParameters>;                         \
    return Chain<Link>(Link(value, *this));                                                        \
  }
  CGAL_GEODESIC_PROCESSING_LINKS
#undef CGAL_GEODESIC_PROCESSING_LINK
};

// The functions that begin a chain.
#define CGAL_GEODESIC_PROCESSING_LINK(TAG, X)                                                      \
  template <typename T>                                                                            \
  auto X(const T& value)                                                                           \
  {                                                                                                \
    using Link = CGAL::Named_function_parameters<T, TAG>;                                          \
    return Chain<Link>(Link(value));                                                               \
  }
CGAL_GEODESIC_PROCESSING_LINKS
#undef CGAL_GEODESIC_PROCESSING_LINK
#undef CGAL_GEODESIC_PROCESSING_OWN_LINK
#undef CGAL_GEODESIC_PROCESSING_LINKS
#undef CGAL_GEODESIC_PROCESSING_OWN_NAMES

} // namespace parameters

namespace internal {

using Default_parameters = CGAL::parameters::Default_named_parameters;

// Converts a chain to the type of CGAL, since functions of CGAL deduce this type and not a derived
// one.
template <typename NamedParameters>
const NamedParameters& plain(const NamedParameters& np)
{
  return np;
}
template <typename NamedParameters>
const NamedParameters& plain(const parameters::Chain<NamedParameters>& np)
{
  return np.plain();
}

// Converts parameters to a chain that can be extended by the names of this package.
template <typename NamedParameters>
auto chain(const NamedParameters& np)
{
  using Plain = std::decay_t<decltype(plain(np))>;
  return parameters::Chain<Plain>(plain(np));
}

template <typename T, typename Tag, typename Base>
std::true_type test_named_parameters(const CGAL::Named_function_parameters<T, Tag, Base>*);
std::false_type test_named_parameters(const void*);

// True for the type of any chain of named parameters.
template <typename T>
inline constexpr bool is_named_parameters =
    decltype(test_named_parameters(static_cast<const T*>(nullptr)))::value;

template <typename NamedParameters, typename Tag, typename Default>
auto parameter(const NamedParameters& np, Tag tag, Default otherwise)
{
  static_assert(is_named_parameters<NamedParameters>,
                "The last argument of a function is a chain of named parameters.");
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(plain(np), tag),
                                            std::move(otherwise));
}

template <typename NamedParameters, typename Tag>
inline constexpr bool has_parameter =
    !std::is_same_v<std::decay_t<decltype(CGAL::parameters::get_parameter(
                        plain(std::declval<const NamedParameters&>()), std::declval<Tag>()))>,
                    CGAL::internal_np::Param_not_found>;

} // namespace internal
} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_PARAMETERS_H
