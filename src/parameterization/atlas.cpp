// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/atlas.h>

#include <CGAL/Geodesic_processing/internal/parameterization/symmetric_dirichlet.h>
#include "parameterization/packing.h"
#include "mesh/patches.h"
#include "core/unfold.h"

#include <iterator>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Divides the triangles without a patch, in components without a center, into disks with new
// labels. Returns the number of all patches.
Index label_remaining_components(const Surface_arrays& t, std::vector<Index>& patch,
                                 Index number_of_patches)
{
  const Index first_new_label = number_of_patches;
  std::vector<Index> stack;
  for(Index f = 0; f < patch.size(); ++f)
  {
    if(patch[f] != none)
      continue;
    patch[f] = number_of_patches;
    stack.push_back(f);
    while(!stack.empty())
    {
      const Index from = stack.back();
      stack.pop_back();
      for(Index h = 3 * from; h < 3 * from + 3; ++h)
        if(const Index twin = t.twin[h]; twin != none && patch[twin / 3] == none)
        {
          patch[twin / 3] = number_of_patches;
          stack.push_back(twin / 3);
        }
    }
    ++number_of_patches;
  }
  return number_of_patches == first_new_label
             ? number_of_patches
             : number_of_patches + Index(split_into_disks(t, patch, number_of_patches).size());
}

// Maximum number of times that charts are split and packed again.
constexpr unsigned max_splits = 8;

Packing pack_charts(const std::vector<Chart>& charts, const Atlas_options& options)
{
  std::vector<Outline> outlines;
  for(const Chart& chart : charts)
    outlines.push_back(outline(chart));
  return pack(outlines, options.texels, options.gutter, options.tessellation.number_of_threads);
}

// Returns a packed chart whose image has the rounded texture coordinates.
Chart placed(Chart chart, const Packing& packing, Index i, std::size_t texels)
{
  for(Vec2& p : chart.image)
    p = (1. / double(texels)) * packing(i, p);
  return chart;
}

// Writes the texture coordinates of packed charts, the chart of each triangle, and the statistics.
// Returns the charts that are not injective any more, because coordinates are rounded.
//
// result.chart  has the size #triangles
std::vector<Index> place_charts(const Surface_arrays& t, const std::vector<Chart>& charts,
                                const Packing& packing, std::size_t texels, Atlas& result)
{
  result.coordinates.resize(t.corner.size());
  result.number_of_charts = charts.size();
  result.texels_per_length = packing.scale;
  result.number_of_flips = result.number_of_overlaps = 0;
  result.coverage = 0.;
  std::vector<Index> not_injective;
  for(Index i = 0; i < charts.size(); ++i)
  {
    const Chart placed_chart = placed(charts[i], packing, i, texels);
    const std::size_t flips = number_of_flips(placed_chart);
    const bool does_overlap = find_self_intersection(outline(placed_chart)).has_value();
    result.number_of_flips += flips;
    result.number_of_overlaps += does_overlap;
    if(flips > 0 || does_overlap)
      not_injective.push_back(i);
    for(std::size_t f = 0; f < placed_chart.triangles.size(); ++f)
    {
      std::array<Vec2, 3> corners;
      for(std::size_t k = 0; k < 3; ++k)
        corners[k] = result.coordinates[3 * std::size_t(placed_chart.triangles[f]) + k] =
            placed_chart.image[placed_chart.surface.corner[3 * f + k]];
      result.chart[placed_chart.triangles[f]] = i;
      result.coverage += cross(corners[1] - corners[0], corners[2] - corners[0]) / 2.;
    }
  }
  return not_injective;
}

// Splits the given charts where their placed images overlap. The pieces follow the other charts.
// Returns whether a chart was split: one of a single triangle is not.
bool split_placed_charts(std::vector<Chart>& charts, const std::vector<Index>& which,
                         const Packing& packing, std::size_t texels)
{
  std::vector<Chart> pieces;
  for(const Index i : which)
    if(charts[i].triangles.size() > 1)
    {
      const auto [first, second] = triangles_to_separate(placed(charts[i], packing, i, texels));
      std::vector<Chart> split = split_chart(charts[i], first, second);
      charts[i] = std::move(split.back());
      split.pop_back();
      std::move(split.begin(), split.end(), std::back_inserter(pieces));
    }
  std::move(pieces.begin(), pieces.end(), std::back_inserter(charts));
  return !pieces.empty();
}

} // namespace

Atlas make_atlas(std::shared_ptr<const Surface_arrays> triangles, const Front& front,
                 std::shared_ptr<const std::vector<double>> slowness, const Atlas_options& options)
{
  const Surface_arrays& t = *triangles;
  const std::function<bool(double)>& callback = options.tessellation.callback;
  const auto subrange = [&](double from, double to) -> std::function<bool(double)>
  {
    if(!callback)
      return {};
    return [=](double done) { return callback(from + done * (to - from)); };
  };

  Atlas result;
  Tessellation_options tessellation = options.tessellation;
  tessellation.does_make_disks = true;
  tessellation.callback = subrange(0., 0.4);
  Tessellation cells = tessellate(triangles, front, std::move(slowness), tessellation);
  result.is_complete = cells.is_finished;
  if(!result.is_complete)
    return result;
  result.chart = std::move(cells.labels);
  const Index number_of_patches =
      label_remaining_components(t, result.chart, Index(cells.centers.size()));

  check_fits(number_of_patches, options.texels, options.gutter);

  Chart_options flattening = options.charts;
  flattening.number_of_threads = tessellation.number_of_threads;
  flattening.callback = subrange(0.4, 0.8);
  std::vector<Chart> charts = injective_charts(t, result.chart, number_of_patches, flattening);
  result.is_complete = !charts.empty() || result.chart.empty();
  if(!result.is_complete)
    return result;

  for(unsigned splits = 0;; ++splits)
  {
    const Packing packing = pack_charts(charts, options);
    const std::vector<Index> not_injective =
        place_charts(t, charts, packing, options.texels, result);
    if(splits == max_splits || !split_placed_charts(charts, not_injective, packing, options.texels))
      break;
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
