// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/charts.h>

#include <CGAL/Geodesic_processing/internal/parameterization/base_points.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include <CGAL/Geodesic_processing/internal/parameterization/symmetric_dirichlet.h>
#include <CGAL/Geodesic_processing/internal/parameterization/tutte_map.h>
#include <CGAL/Geodesic_processing/internal/parameterization/lle.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include "mesh/patches.h"
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include <CGAL/Geodesic_processing/internal/parameterization/untangling.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Number of base points of a chart and of neighbors of each. They can be few, because the map is
// optimized afterwards.
constexpr std::size_t number_of_base_points = 24, number_of_neighbors = 8;

// Up to this number of vertices, Tutte's map is a good enough initial map.
constexpr std::size_t max_vertices_for_tutte = 100;

// Mean energies above which a chart is split: those of maps that scale all lengths by 2 or 1/2, and
// by 7 or 1/7. The latter is for charts of few vertices, whose splits are visible. Almost closed
// charts have no better map.
constexpr double max_mean_energy = 8.5, max_mean_energy_of_few = 100.;

void sort_unique(std::vector<Index>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

std::vector<Vec2> flatten_triangle(const Surface_arrays& surface)
{
  // Its longest edge is the base; its height has a lower bound as in symmetric_dirichlet.cpp.
  constexpr double min_height_ratio = 1e-7;
  Index base = 0;
  for(Index h = 1; h < 3; ++h)
    if(surface.length[h] > surface.length[base])
      base = h;
  Vec2 apex = third_corner(surface.length[base], surface.length[previous_halfedge(base)],
                           surface.length[next_halfedge(base)]);
  apex[0] = std::clamp(apex[0], 0., surface.length[base]);
  apex[1] = std::max(apex[1], min_height_ratio * surface.length[base]);
  std::vector<Vec2> image(3);
  image[surface.corner[base]] = {0., 0.};
  image[surface.corner[next_halfedge(base)]] = {surface.length[base], 0.};
  image[surface.corner[previous_halfedge(base)]] = apex;
  return image;
}

// Computes a map by geodesic locally linear embedding. It can have inverted triangles, or be
// empty.
std::vector<Vec2> lle_embedding(const Surface_arrays& surface)
{
  // Does not own the arrays: all copies end in this function.
  const std::shared_ptr<const Surface_arrays> triangles(std::shared_ptr<void>(), &surface);
  const Front front(triangles, Front_kind::euclidean);
  Sampling sampling(triangles, front, Sample_location::vertex);
  Sampling_options options;
  options.number_of_samples = number_of_base_points;
  sample_farthest_points(sampling, options, [](double) {});
  const Base_points base =
      nearest_base_points(surface, sampling, front, number_of_nearest_for(number_of_neighbors));
  const std::vector<Vec2> positions = embed_base_points(base, number_of_neighbors);
  if(positions.empty())
    return {};
  std::vector<Vec2> image = extend_embedding(base, positions, number_of_neighbors);
  orient_positively(surface, image);
  untangle(surface, image);
  return image;
}

// Computes an initial map without inverted triangles: the embedding if it has none, otherwise
// Tutte's map.
std::vector<Vec2> initial_map(const Surface_arrays& surface)
{
  if(surface.number_of_vertices() > max_vertices_for_tutte)
  {
    std::vector<Vec2> image = lle_embedding(surface);
    if(!image.empty() && number_of_flips(surface, image) == 0)
      return image;
  }
  return tutte_map(surface);
}

// Computes the image of a chart. If no injective image is found, returns the pieces to flatten
// instead.
std::vector<Chart> flatten_chart(Chart& chart, const Chart_options& options)
{
  const Surface_arrays& surface = chart.surface;
  if(surface.number_of_triangles() == 1)
  {
    chart.image = flatten_triangle(surface);
    return {};
  }
  // A piece of a chart begins with the map of the chart.
  const bool has_initial_image = !chart.image.empty() && number_of_flips(chart) == 0;
  if(!has_initial_image)
    chart.image = initial_map(surface);
  std::vector<Vec2> initial_image = chart.image;
  double energy = infinity;
  if(number_of_flips(surface, chart.image) == 0)
    energy = minimize_symmetric_dirichlet(surface, chart.image, options.max_steps, {},
                                          options.energy_tolerance)
                 .energy;
  const double max_energy = surface.number_of_vertices() > max_vertices_for_tutte
                                ? max_mean_energy
                                : max_mean_energy_of_few;
  const bool is_too_distorted = energy > max_energy;
  if(!is_too_distorted)
  {
    if(is_injective(chart))
      return {};
    std::swap(chart.image, initial_image);
    // It is a part of the map of a larger chart, which can be too distorted.
    if(has_initial_image && is_injective(chart) &&
       minimize_symmetric_dirichlet(surface, chart.image, 0).energy <= max_energy)
      return {};
    std::swap(chart.image, initial_image);
  }
  const auto [first, second] =
      is_too_distorted ? farthest_triangle_pair(surface) : triangles_to_separate(chart);
  return split_chart(chart, first, second);
}

} // namespace

std::vector<Chart> extract_charts(const Surface_arrays& t, const std::vector<Index>& patch,
                                  Index number_of_patches)
{
  std::vector<Chart> charts(number_of_patches);
  std::vector<Index> local_index(patch.size(), none); // index in its chart
  for(Index f = 0; f < patch.size(); ++f)
    if(patch[f] != none)
    {
      local_index[f] = Index(charts[patch[f]].triangles.size());
      charts[patch[f]].triangles.push_back(f);
    }
  charts.erase(std::remove_if(charts.begin(), charts.end(),
                              [](const Chart& chart) { return chart.triangles.empty(); }),
               charts.end());
  std::vector<Index> vertices;
  for(Chart& chart : charts)
  {
    vertices.clear();
    for(const Index f : chart.triangles)
      vertices.insert(vertices.end(), &t.corner[3 * std::size_t(f)],
                      &t.corner[3 * std::size_t(f)] + 3);
    sort_unique(vertices);
    Surface_arrays& surface = chart.surface;
    surface.scale = t.scale;
    for(const Index f : chart.triangles)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Index twin = t.twin[h];
        surface.corner.push_back(Index(
            std::lower_bound(vertices.begin(), vertices.end(), t.corner[h]) - vertices.begin()));
        surface.twin.push_back(twin == none || patch[twin / 3] != patch[f]
                                   ? none
                                   : 3 * local_index[twin / 3] + twin % 3);
        surface.length.push_back(t.length[h]);
      }
    build_rings(surface, vertices.size());
  }
  return charts;
}

Outline outline(const Chart& chart, std::vector<Index>* halfedges)
{
  const std::vector<Index> boundary = boundary_loops(chart.surface).front();
  Outline result;
  for(const Index h : boundary)
    result.push_back(chart.image[chart.surface.corner[h]]);
  if(halfedges)
    *halfedges = boundary;
  return result;
}

std::size_t number_of_flips(const Chart& chart)
{
  std::size_t result = 0;
  const std::vector<Index>& corner = chart.surface.corner;
  for(std::size_t c = 0; c < corner.size(); c += 3)
    result += !is_left_turn(chart.image[corner[c]], chart.image[corner[c + 1]],
                            chart.image[corner[c + 2]]);
  return result;
}

bool is_injective(const Chart& chart)
{
  return number_of_flips(chart) == 0 && !find_self_intersection(outline(chart));
}

std::array<Index, 2> triangles_to_separate(const Chart& chart)
{
  if(number_of_flips(chart) == 0)
  {
    std::vector<Index> halfedges;
    const Outline boundary = outline(chart, &halfedges);
    if(const auto intersection = find_self_intersection(boundary))
    {
      const Index first = halfedges[intersection->first] / 3,
                  second = halfedges[intersection->second] / 3;
      if(first != second)
        return {first, second};
    }
  }
  return farthest_triangle_pair(chart.surface);
}

std::vector<Chart> split_chart(const Chart& chart, Index first, Index second)
{
  std::vector<Index> patch = bisect_patch(chart.surface, first, second);
  const auto new_patches = split_into_disks(chart.surface, patch, 2);
  std::vector<Chart> result = extract_charts(chart.surface, patch, Index(2 + new_patches.size()));
  for(Chart& piece : result)
  {
    piece.image.resize(piece.surface.number_of_vertices());
    for(Index f = 0; f < piece.triangles.size(); ++f)
    {
      for(Index k = 0; k < 3; ++k)
        piece.image[piece.surface.corner[3 * f + k]] =
            chart.image[chart.surface.corner[3 * piece.triangles[f] + k]];
      piece.triangles[f] = chart.triangles[piece.triangles[f]];
    }
  }
  return result;
}

std::vector<Chart> injective_charts(const Surface_arrays& t, const std::vector<Index>& patch,
                                    Index number_of_patches, const Chart_options& options)
{
  std::vector<Chart> result, queue = extract_charts(t, patch, number_of_patches);
  while(!queue.empty())
  {
    std::vector<std::vector<Chart>> pieces(queue.size());
    for_each_block(queue.size(), 1, options.number_of_threads,
                   [&](std::size_t i, std::size_t, std::size_t)
                   { pieces[i] = flatten_chart(queue[i], options); });
    std::vector<Chart> next;
    for(std::size_t i = 0; i < queue.size(); ++i)
      if(pieces[i].empty())
        result.push_back(std::move(queue[i]));
      else
        std::move(pieces[i].begin(), pieces[i].end(), std::back_inserter(next));
    if(options.callback &&
       !options.callback(double(result.size()) / double(result.size() + next.size())))
      return {};
    queue = std::move(next);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
