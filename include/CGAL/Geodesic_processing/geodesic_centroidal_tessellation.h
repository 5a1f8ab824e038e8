// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_CENTROIDAL_TESSELLATION_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_CENTROIDAL_TESSELLATION_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/method.h>
#include <CGAL/Geodesic_processing/internal/sampling/tessellation.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingFlattening
///
/// Computes a centroidal tessellation: divides a surface into geodesic Voronoi cells of about equal
/// size. Centers are moved to the intrinsic centroids of their cells. \cgalCite{cgal:pc-ssgct-04}
///
/// Centers are initialized by farthest point sampling. Each step moves a center \f$c\f$ by the mean
/// of the logarithms of its cell, or by a fraction of this mean. The mean is \f$-\frac{1}{2}\f$ of
/// the gradient of the energy \f$\int d(c, x)^2 dx\f$, divided by the area. No step increases the
/// sum of the energies of all cells.
///
/// On a mesh the cells are patches of faces. Each patch is connected and does not touch itself at a
/// single vertex, provided that an adjacent cell can take the disconnected fragments. Patches need
/// not be disks unless `do_make_discs` is set: a cell around a tube is an annulus.
///
/// \tparam Method `Euclidean_front` (the default), `Fast_marching` or `Dijkstra`; `Runtime_method`
///         reads the named parameter `method`
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`, which
///         processes several cells at a time, with the same result
/// \tparam Surface as for `geodesic_distances()`
/// \tparam LabelMap a model of `WritablePropertyMap` with faces of the mesh or surfels as keys and
///         `std::size_t` as values
/// \param surface as for `geodesic_distances()`
/// \param number the number of cells. There are fewer if the surface does not have as many
///        different locations. A component without a center is in no cell
/// \param label_map receives the label of the cell for each face of a mesh or each surfel of a
///        cloud. Labels are from 0 to one less than the number of cells. If no center reaches a
///        face or surfel, the value is the largest `std::size_t`
/// \param np parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{do_make_discs}
///     \cgalParamDescription{on a mesh: whether each patch is required to be a topological disk.
///       Cells that are not disks get additional centers, and cells that are still not disks are
///       split in two. The result therefore has more cells than requested. If the surface has more
///       handles than `number`, centers are moved only after cells were added to obtain disks. Two
///       holes count as one handle}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_iterations}
///     \cgalParamDescription{the maximum number of steps, and at most as many again after cells
///       were added to obtain disks. Iteration stops if a step decreases the energy by less than a
///       thousandth}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{20}
///   \cgalParamNEnd
///   \cgalParamNBegin{speed_map, face_speed_map}
///     \cgalParamDescription{as for `Geodesic_distance_solver::compute()`: cells are smaller in
///       regions of lower speed}
///     \cgalParamType{as for `Geodesic_distance_solver::compute()`}
///     \cgalParamDefault{1 everywhere}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{as for `farthest_point_sampling()`}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{center_output}
///     \cgalParamDescription{an output iterator that takes the center of each cell as
///       `Location<Surface>`}
///     \cgalParamType{a model of `OutputIterator` for `Location<Surface>`}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{energy_output}
///     \cgalParamDescription{an output iterator that takes the energy at the start, after each
///       step, and after cells were added to obtain disks. Its unit is an area times a squared
///       distance}
///     \cgalParamType{a model of `OutputIterator` for `double`}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_threads}
///     \cgalParamDescription{number of threads with `CGAL::Parallel_tag`}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{all hardware threads}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the fraction done. If it returns false,
///       the function throws `Cancelled`}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the number of cells
/// \throws Invalid_argument_error if the number is zero or a speed is not usable
/// \throws Cancelled if the callback returns false
///
/// Each step takes about the time of five fronts over the surface.
template <typename Method = Euclidean_front, typename Concurrency_tag = Sequential_tag,
          typename Surface, typename LabelMap,
          typename NamedParameters = internal::Default_parameters>
std::size_t geodesic_centroidal_tessellation(const Surface& surface, std::size_t number,
                                             LabelMap label_map,
                                             const NamedParameters& np = NamedParameters())
{
  using internal::Index;
  const auto domain = make_domain(surface, np);
  constexpr bool is_cloud =
      internal::Is_cloud<typename std::decay_t<decltype(domain)>::Surface>::value;
  constexpr std::size_t no_label = (std::numeric_limits<std::size_t>::max)();
  if(number == 0)
    throw Invalid_argument_error("The number of cells must be positive.");
  const internal::Front_limits front_limits = internal::limits(domain, np);
  internal::Tessellation_options options;
  options.number_of_cells = number;
  options.max_steps =
      internal::parameter(np, internal_np::maximum_number_of_iterations, options.max_steps);
  options.does_make_disks = internal::parameter(np, internal_np::do_make_discs, false);
  options.seed = unsigned(internal::parameter(np, CGAL::internal_np::random_seed, 0u));
  options.number_of_threads = internal::number_of_threads<Concurrency_tag>(np);
  options.callback = front_limits.callback;
  const internal::Tessellation found = internal::tessellate(
      domain.triangles(),
      internal::Front(domain.triangles(), internal::read_front_kind<Method>(np)),
      front_limits.slowness, options);
  if(!found.is_finished)
    throw Cancelled();

  const auto label = [](Index cell)
  { return cell == internal::none ? no_label : std::size_t(cell); };
  if constexpr(is_cloud)
    domain.write([&](Index vertex) { return label(found.labels[vertex]); }, label_map);
  else
    for(Index f = 0; f < found.labels.size(); ++f)
      put(label_map, domain.face(f), label(found.labels[f]));
  if constexpr(internal::has_parameter<NamedParameters, internal_np::center_output_t>)
  {
    auto out = internal::parameter(np, internal_np::center_output, 0);
    for(const internal::Surface_location& center : found.centers)
      *out++ = domain.outer(center);
  }
  if constexpr(internal::has_parameter<NamedParameters, internal_np::energy_output_t>)
  {
    auto out = internal::parameter(np, internal_np::energy_output, 0);
    const double square = domain.triangles()->scale * domain.triangles()->scale;
    for(const double energy : found.energies)
      *out++ = square * square * energy;
  }
  return found.centers.size();
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_CENTROIDAL_TESSELLATION_H
