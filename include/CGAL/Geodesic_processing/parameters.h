// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_PARAMETERS_H
#define CGAL_GEODESIC_PROCESSING_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <type_traits>
#include <utility>

namespace CGAL::Geodesic_processing {

namespace internal_np {

enum maximum_distance_t
{
  maximum_distance
};
enum targets_t
{
  targets
};
enum speed_map_t
{
  speed_map
};
enum source_label_map_t
{
  source_label_map
};
enum predecessor_map_t
{
  predecessor_map
};
enum radius_map_t
{
  radius_map
};
enum threads_t
{
  threads
};
enum covering_radius_t
{
  covering_radius
};
enum covering_radius_output_t
{
  covering_radius_output
};
enum first_samples_t
{
  first_samples
};
enum face_label_map_t
{
  face_label_map
};
enum bisector_output_t
{
  bisector_output
};
enum ball_radius_t
{
  ball_radius
};
enum too_few_samples_t
{
  too_few_samples
};
enum number_of_relaxation_steps_t
{
  number_of_relaxation_steps
};
enum maximum_deviation_t
{
  maximum_deviation
};
enum do_fit_t
{
  do_fit
};
enum sharp_angle_t
{
  sharp_angle
};
enum curve_spacing_t
{
  curve_spacing
};
enum edge_spacing_map_t
{
  edge_spacing_map
};
enum location_map_t
{
  location_map
};
enum edge_path_output_t
{
  edge_path_output
};
enum strength_t
{
  strength
};
enum surfel_path_method_t
{
  surfel_path_method
};
enum surfel_noise_t
{
  surfel_noise
};
enum surfel_graph_t
{
  surfel_graph
};
enum surfel_search_t
{
  surfel_search
};
enum number_of_control_points_t
{
  number_of_control_points
};
enum node_weight_t
{
  node_weight
};
enum segment_weight_t
{
  segment_weight
};
enum outlier_percentage_t
{
  outlier_percentage
};
enum number_of_neighbors_t
{
  number_of_neighbors
};
enum stencil_length_t
{
  stencil_length
};
enum stencil_size_t
{
  stencil_size
};
enum up_direction_t
{
  up_direction
};
enum tolerance_t
{
  tolerance
};
enum maximum_number_of_iterations_t
{
  maximum_number_of_iterations
};
enum number_of_refinements_t
{
  number_of_refinements
};
enum metric_map_t
{
  metric_map
};
enum potential_map_t
{
  potential_map
};
enum flow_map_t
{
  flow_map
};
enum arrival_map_t
{
  arrival_map
};
enum capacities_t
{
  capacities
};
enum spreading_weight_t
{
  spreading_weight
};
enum weights_t
{
  weights
};
enum objective_map_t
{
  objective_map
};
enum do_normalize_t
{
  do_normalize
};
enum do_bound_from_above_t
{
  do_bound_from_above
};
enum do_start_from_last_t
{
  do_start_from_last
};
enum do_make_discs_t
{
  do_make_discs
};
enum center_output_t
{
  center_output
};
enum energy_output_t
{
  energy_output
};
enum do_straighten_t
{
  do_straighten
};
enum width_t
{
  width
};
enum base_points_t
{
  base_points
};
enum number_of_base_points_t
{
  number_of_base_points
};

} // namespace internal_np

/// The named parameters of this package, chained with the ones of \cgal in any order.
namespace parameters {

using namespace CGAL::parameters;

/// a chain of named parameters: one of \cgal to every function that reads it, with our names as
/// further links.
template <typename NamedParameters>
struct Chain : NamedParameters
{
  using NamedParameters::NamedParameters;
  explicit Chain(const NamedParameters& np) : NamedParameters(np) {}

  const NamedParameters& plain() const { return *this; }

// A link X with the tag of a namespace.
#define CGAL_GEODESIC_PROCESSING_LINK(SPACE, TAG, X)                                               \
  template <typename T>                                                                            \
  auto X(const T& value) const                                                                     \
  {                                                                                                \
    using Link = CGAL::Named_function_parameters<T, SPACE::TAG, NamedParameters>;                  \
    return Chain<Link>(Link(value, *this));                                                        \
  }

#define CGAL_GEODESIC_PROCESSING_LINKS(LINK)                                                       \
  LINK(Geodesic_processing::internal_np, maximum_distance_t, maximum_distance)                     \
  LINK(Geodesic_processing::internal_np, targets_t, targets)                                       \
  LINK(Geodesic_processing::internal_np, speed_map_t, speed_map)                                   \
  LINK(Geodesic_processing::internal_np, source_label_map_t, source_label_map)                     \
  LINK(Geodesic_processing::internal_np, predecessor_map_t, predecessor_map)                       \
  LINK(Geodesic_processing::internal_np, radius_map_t, radius_map)                                 \
  LINK(Geodesic_processing::internal_np, threads_t, threads)                                       \
  LINK(Geodesic_processing::internal_np, covering_radius_t, covering_radius)                       \
  LINK(Geodesic_processing::internal_np, covering_radius_output_t, covering_radius_output)         \
  LINK(Geodesic_processing::internal_np, first_samples_t, first_samples)                           \
  LINK(Geodesic_processing::internal_np, face_label_map_t, face_label_map)                         \
  LINK(Geodesic_processing::internal_np, bisector_output_t, bisector_output)                       \
  LINK(Geodesic_processing::internal_np, ball_radius_t, ball_radius)                               \
  LINK(Geodesic_processing::internal_np, too_few_samples_t, too_few_samples)                       \
  LINK(Geodesic_processing::internal_np, number_of_relaxation_steps_t, number_of_relaxation_steps) \
  LINK(Geodesic_processing::internal_np, maximum_deviation_t, maximum_deviation)                   \
  LINK(Geodesic_processing::internal_np, do_fit_t, do_fit)                                         \
  LINK(Geodesic_processing::internal_np, sharp_angle_t, sharp_angle)                               \
  LINK(Geodesic_processing::internal_np, curve_spacing_t, curve_spacing)                           \
  LINK(Geodesic_processing::internal_np, edge_spacing_map_t, edge_spacing_map)                     \
  LINK(Geodesic_processing::internal_np, location_map_t, location_map)                             \
  LINK(Geodesic_processing::internal_np, edge_path_output_t, edge_path_output)                     \
  LINK(Geodesic_processing::internal_np, strength_t, strength)                                     \
  LINK(Geodesic_processing::internal_np, surfel_path_method_t, surfel_path_method)                 \
  LINK(Geodesic_processing::internal_np, surfel_noise_t, surfel_noise)                             \
  LINK(Geodesic_processing::internal_np, surfel_graph_t, surfel_graph)                             \
  LINK(Geodesic_processing::internal_np, surfel_search_t, surfel_search)                           \
  LINK(Geodesic_processing::internal_np, number_of_control_points_t, number_of_control_points)     \
  LINK(Geodesic_processing::internal_np, node_weight_t, node_weight)                               \
  LINK(Geodesic_processing::internal_np, segment_weight_t, segment_weight)                         \
  LINK(Geodesic_processing::internal_np, outlier_percentage_t, outlier_percentage)                 \
  LINK(Geodesic_processing::internal_np, number_of_neighbors_t, number_of_neighbors)               \
  LINK(Geodesic_processing::internal_np, stencil_length_t, stencil_length)                         \
  LINK(Geodesic_processing::internal_np, stencil_size_t, stencil_size)                             \
  LINK(Geodesic_processing::internal_np, up_direction_t, up_direction)                             \
  LINK(Geodesic_processing::internal_np, tolerance_t, tolerance)                                   \
  LINK(Geodesic_processing::internal_np, maximum_number_of_iterations_t,                           \
       maximum_number_of_iterations)                                                               \
  LINK(Geodesic_processing::internal_np, number_of_refinements_t, number_of_refinements)           \
  LINK(Geodesic_processing::internal_np, metric_map_t, metric_map)                                 \
  LINK(Geodesic_processing::internal_np, potential_map_t, potential_map)                           \
  LINK(Geodesic_processing::internal_np, flow_map_t, flow_map)                                     \
  LINK(Geodesic_processing::internal_np, arrival_map_t, arrival_map)                               \
  LINK(Geodesic_processing::internal_np, capacities_t, capacities)                                 \
  LINK(Geodesic_processing::internal_np, spreading_weight_t, spreading_weight)                     \
  LINK(Geodesic_processing::internal_np, weights_t, weights)                                       \
  LINK(Geodesic_processing::internal_np, objective_map_t, objective_map)                           \
  LINK(Geodesic_processing::internal_np, do_normalize_t, do_normalize)                             \
  LINK(Geodesic_processing::internal_np, do_bound_from_above_t, do_bound_from_above)               \
  LINK(Geodesic_processing::internal_np, do_start_from_last_t, do_start_from_last)                 \
  LINK(Geodesic_processing::internal_np, do_make_discs_t, do_make_discs)                           \
  LINK(Geodesic_processing::internal_np, center_output_t, center_output)                           \
  LINK(Geodesic_processing::internal_np, energy_output_t, energy_output)                           \
  LINK(Geodesic_processing::internal_np, do_straighten_t, do_straighten)                           \
  LINK(Geodesic_processing::internal_np, width_t, width)                                           \
  LINK(Geodesic_processing::internal_np, base_points_t, base_points)                               \
  LINK(Geodesic_processing::internal_np, number_of_base_points_t, number_of_base_points)           \
  LINK(CGAL::internal_np, edge_is_constrained_t, edge_is_constrained_map)                          \
  LINK(CGAL::internal_np, callback_t, callback)                                                    \
  LINK(CGAL::internal_np, random_seed_t, random_seed)                                              \
  LINK(CGAL::internal_np, vertex_point_t, vertex_point_map)                                        \
  LINK(CGAL::internal_np, vertex_index_t, vertex_index_map)                                        \
  LINK(CGAL::internal_np, face_index_t, face_index_map)                                            \
  LINK(CGAL::internal_np, point_t, point_map)                                                      \
  LINK(CGAL::internal_np, normal_t, normal_map)                                                    \
  LINK(CGAL::internal_np, geom_traits_t, geom_traits)

  CGAL_GEODESIC_PROCESSING_LINKS(CGAL_GEODESIC_PROCESSING_LINK)
#undef CGAL_GEODESIC_PROCESSING_LINK
};

// The first link of a chain.
#define CGAL_GEODESIC_PROCESSING_LINK(SPACE, TAG, X)                                               \
  template <typename T>                                                                            \
  auto X(const T& value)                                                                           \
  {                                                                                                \
    using Link = CGAL::Named_function_parameters<T, SPACE::TAG>;                                   \
    return Chain<Link>(Link(value));                                                               \
  }
CGAL_GEODESIC_PROCESSING_LINKS(CGAL_GEODESIC_PROCESSING_LINK)
#undef CGAL_GEODESIC_PROCESSING_LINK
#undef CGAL_GEODESIC_PROCESSING_LINKS

} // namespace parameters

namespace internal {

using Default_parameters = CGAL::parameters::Default_named_parameters;

// A chain as CGAL knows it: its functions deduce their own class, not one derived from it.
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

// The same parameters, ready for our own links.
template <typename NamedParameters>
auto chain(const NamedParameters& np)
{
  using Plain = std::decay_t<decltype(plain(np))>;
  return parameters::Chain<Plain>(plain(np));
}

template <typename NamedParameters, typename Tag, typename Default>
auto parameter(const NamedParameters& np, Tag tag, Default otherwise)
{
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
