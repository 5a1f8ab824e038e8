// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_CENTROIDAL_TESSELLATION_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_CENTROIDAL_TESSELLATION_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
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
/// divides a surface into cells of about equal size: those of a geodesic Voronoi diagram, whose centres have
/// gone to the intrinsic centres of mass of their cells. \cgalCite{cgal:pc-ssgct-04}
///
/// From farthest points on, each centre \f$c\f$ goes by the mean of the logarithms of its cell, which is
/// \f$-\frac{1}{2}\f$ of the gradient of the energy \f$\int d(c, x)^2 dx\f$ over the area, or a part of that way: no
/// step raises the sum of the energies of all cells.
///
/// On a mesh the cells are patches of faces. Each is in one piece and meets itself in no vertex alone, as far as
/// it has a neighbour that can take what does not fit. They need not be discs unless that is asked for: a cell
/// around a tube is an annulus.
///
/// \tparam Method `Euclidean_front` (the default), `Fast_marching` or `Dijkstra`
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`: several cells at a
///         time, with the same result
/// \param surface as for `geodesic_distances()`
/// \param number of cells; there are fewer where not as many places are apart, and a component without a
///        centre is in no cell
/// \param label_map receives for each face the label of its cell, 0 to one less than the number of cells, on a
///        cloud for each surfel; the largest `std::size_t` where there is no centre in reach
/// \param np what `make_domain()` takes, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{do_make_discs}
///     \cgalParamDescription{on a mesh: whether each patch is to be a topological disc. Cells that are none get
///       further centres, and what is left is cut in two; so there are more than asked for. Where handles are more
///       than these, centres begin to move when cells are discs}
///     \cgalParamDefault{`false`} \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_iterations}
///     \cgalParamDescription{steps, and as many once cells were added for discs; they end earlier where one gains
///       less than a thousandth of the energy}
///     \cgalParamDefault{20} \cgalParamNEnd
///   \cgalParamNBegin{speed_map}
///     \cgalParamDescription{as for `geodesic_distances()`: cells are smaller where the speed is lower}
///     \cgalParamDefault{1 everywhere} \cgalParamNEnd
///   \cgalParamNBegin{random_seed} \cgalParamDescription{as for `farthest_point_sampling()`}
///     \cgalParamDefault{0} \cgalParamNEnd
///   \cgalParamNBegin{center_output}
///     \cgalParamDescription{an output iterator that takes `Location<Surface>`: the centre of each cell}
///     \cgalParamNEnd
///   \cgalParamNBegin{energy_output}
///     \cgalParamDescription{an output iterator that takes the energy at the start, after each step and after
///       cells were added for discs, an area times a squared distance} \cgalParamNEnd
///   \cgalParamNBegin{threads} \cgalParamDescription{with `CGAL::Parallel_tag`}
///     \cgalParamDefault{as many as the machine has} \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a `std::function<bool(double)>` that is told the fraction done and cancels by
///       returning false; then what was found until then is written} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the number of cells
/// \throws Invalid_argument_error when the number is zero, or a speed is not usable
///
/// A step takes the time of about five fronts over the surface.
template <typename Method = Euclidean_front, typename Concurrency_tag = Sequential_tag,
          typename Surface, typename LabelMap,
          typename NamedParameters = internal::Default_parameters>
std::size_t geodesic_centroidal_tessellation(const Surface& surface, std::size_t number,
                                             LabelMap label_map,
                                             const NamedParameters& np = NamedParameters())
{
  using internal::Index;
  static_assert(internal::is_front<Method>,
                "Cells are found by fronts: Euclidean_front, Fast_marching or Dijkstra.");
  const auto domain = make_domain(surface, np);
  constexpr bool is_cloud =
      internal::Is_cloud<typename std::decay_t<decltype(domain)>::Surface>::value;
  constexpr std::size_t no_label = (std::numeric_limits<std::size_t>::max)();
  if(number == 0)
    throw Invalid_argument_error("A tessellation has one cell at least.");
  const internal::Front_limits front_limits = internal::limits(domain, np);
  internal::Tessellation_options options;
  options.number_of_cells = number;
  options.max_steps =
      internal::parameter(np, internal_np::maximum_number_of_iterations, options.max_steps);
  options.does_make_disks = internal::parameter(np, internal_np::do_make_discs, false);
  options.seed = unsigned(internal::parameter(np, CGAL::internal_np::random_seed, 0u));
  options.threads = internal::threads<Concurrency_tag>(np);
  options.callback = front_limits.callback;
  const internal::Tessellation found = internal::tessellate(
      domain.triangles(), internal::Front(domain.triangles(), internal::front_kind<Method>()),
      front_limits.slowness, options);

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
