// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/charts.h>

#include <CGAL/Geodesic_processing/internal/parameterization/base_points.h>
#include <CGAL/Geodesic_processing/internal/mesh/glue.h>
#include <CGAL/Geodesic_processing/internal/parameterization/injective.h>
#include <CGAL/Geodesic_processing/internal/parameterization/lle.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include "mesh/patches.h"
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include <CGAL/Geodesic_processing/internal/parameterization/untangling.h>
#include "core/unfold.h"
#include <CGAL/Geodesic_processing/tags.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Base points of a chart, and how many are around each: few, as Newton's method goes on from there.
constexpr std::size_t base_points = 24, neighbors = 8;

// Fewer sites need no base points: Tutte's map is as good a start.
constexpr std::size_t few_sites = 100;

// A chart is cut as well where its mean energy is that of lengths all twice or half as long.
constexpr double most_energy = 8.5;

void sort_unique(std::vector<Index>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

std::vector<Planar> image_of_triangle(const Glued_triangles& shape)
{
  // Over its longest side, no flatter than what the others may be.
  constexpr double least_height = 1e-7;
  Index base = 0;
  for(Index side = 1; side < 3; ++side)
    if(shape.length[side] > shape.length[base])
      base = side;
  Planar top = third_corner(shape.length[base], shape.length[previous_side(base)],
                            shape.length[next_side(base)]);
  top[0] = std::clamp(top[0], 0., shape.length[base]);
  top[1] = std::max(top[1], least_height * shape.length[base]);
  std::vector<Planar> image(3);
  image[shape.corner[base]] = {0., 0.};
  image[shape.corner[next_side(base)]] = {shape.length[base], 0.};
  image[shape.corner[previous_side(base)]] = top;
  return image;
}

// By geodesic locally linear embedding; it may have flips, or be empty.
std::vector<Planar> embedding(const Glued_triangles& shape)
{
  // Not owned: what shares it ends here.
  const std::shared_ptr<const Glued_triangles> triangles(std::shared_ptr<void>(), &shape);
  const Engine<Euclidean_front> front(triangles);
  Sampling sampling(triangles, front, Sample_place::site);
  Sampling_goal goal;
  goal.number = base_points;
  sample_farthest(sampling, goal, [](double) {});
  const Base_points base = nearest_base_points(shape, sampling, front, nearest_for(neighbors));
  const std::vector<Planar> places = embedded(base, neighbors);
  if(places.empty())
    return {};
  std::vector<Planar> image = extended(base, places, neighbors);
  face_up(shape, image);
  untangle(shape, image);
  return image;
}

std::vector<Planar> start(const Glued_triangles& shape)
{
  if(shape.number_of_sites() > few_sites)
  {
    std::vector<Planar> image = embedding(shape);
    if(!image.empty() && number_of_flips(shape, image) == 0)
      return image;
  }
  return tutte_map(shape);
}

// What is nearer to one triangle than to another, as discs; their images are those of the whole.
std::vector<Chart> parts(const Chart& chart, Index first, Index second)
{
  std::vector<Index> patch = halves(chart.shape, first, second);
  const auto added = split_into_discs(chart.shape, patch, 2);
  std::vector<Chart> result = cut_out(chart.shape, patch, Index(2 + added.size()));
  for(Chart& part : result)
  {
    part.image.resize(part.shape.number_of_sites());
    for(Index f = 0; f < part.triangles.size(); ++f)
    {
      for(Index k = 0; k < 3; ++k)
        part.image[part.shape.corner[3 * f + k]] =
            chart.image[chart.shape.corner[3 * part.triangles[f] + k]];
      part.triangles[f] = chart.triangles[part.triangles[f]];
    }
  }
  return result;
}

// Gives a chart its image; or returns the parts of one that has none.
std::vector<Chart> lay_out(Chart& chart, const Chart_options& options)
{
  const Glued_triangles& shape = chart.shape;
  if(shape.number_of_triangles() == 1)
  {
    chart.image = image_of_triangle(shape);
    return {};
  }
  // A part begins as it lay in the whole.
  const bool is_part = !chart.image.empty() && number_of_flips(chart) == 0;
  if(!is_part)
    chart.image = start(shape);
  std::vector<Planar> before = chart.image;
  double energy = infinity;
  if(number_of_flips(shape, chart.image) == 0)
    energy = minimize_symmetric_dirichlet(shape, chart.image, options.most_steps, {},
                                          options.least_progress)
                 .energy;
  const bool is_to_be_cut = energy > most_energy && shape.number_of_sites() > few_sites;
  if(!is_to_be_cut)
  {
    if(is_injective(chart))
      return {};
    std::swap(chart.image, before);
    if(is_part && is_injective(chart))
      return {};
    std::swap(chart.image, before);
  }

  // Where the border meets itself; else across, as what is stretched too much is long, or was turned by rounding.
  auto [first, second] = ends(shape);
  if(!is_to_be_cut && number_of_flips(chart) == 0)
  {
    std::vector<Index> sides;
    const Outline border = outline(chart, &sides);
    if(const auto meeting = meeting_sides(border);
       meeting && sides[meeting->first] / 3 != sides[meeting->second] / 3)
    {
      first = sides[meeting->first] / 3;
      second = sides[meeting->second] / 3;
    }
  }
  return parts(chart, first, second);
}

} // namespace

std::vector<Chart> cut_out(const Glued_triangles& t, const std::vector<Index>& patch,
                           Index number_of_patches)
{
  std::vector<Chart> charts(number_of_patches);
  std::vector<Index> place(patch.size(), none); // in the chart
  for(Index f = 0; f < patch.size(); ++f)
    if(patch[f] != none)
    {
      place[f] = Index(charts[patch[f]].triangles.size());
      charts[patch[f]].triangles.push_back(f);
    }
  charts.erase(std::remove_if(charts.begin(), charts.end(),
                              [](const Chart& chart) { return chart.triangles.empty(); }),
               charts.end());
  std::vector<Index> sites;
  for(Chart& chart : charts)
  {
    sites.clear();
    for(const Index f : chart.triangles)
      sites.insert(sites.end(), &t.corner[3 * std::size_t(f)], &t.corner[3 * std::size_t(f)] + 3);
    sort_unique(sites);
    Glued_triangles& shape = chart.shape;
    shape.scale = t.scale;
    for(const Index f : chart.triangles)
      for(Index side = 3 * f; side < 3 * f + 3; ++side)
      {
        const Index twin = t.twin[side];
        shape.corner.push_back(
            Index(std::lower_bound(sites.begin(), sites.end(), t.corner[side]) - sites.begin()));
        shape.twin.push_back(
            twin == none || patch[twin / 3] != patch[f] ? none : 3 * place[twin / 3] + twin % 3);
        shape.length.push_back(t.length[side]);
      }
    build_stars(shape, sites.size());
  }
  return charts;
}

Outline outline(const Chart& chart, std::vector<Index>* sides)
{
  const std::vector<Index> border = borders(chart.shape).front();
  Outline result;
  for(const Index side : border)
    result.push_back(chart.image[chart.shape.corner[side]]);
  if(sides)
    *sides = border;
  return result;
}

std::size_t number_of_flips(const Chart& chart)
{
  std::size_t result = 0;
  const std::vector<Index>& corner = chart.shape.corner;
  for(std::size_t c = 0; c < corner.size(); c += 3)
    result +=
        !turns_left(chart.image[corner[c]], chart.image[corner[c + 1]], chart.image[corner[c + 2]]);
  return result;
}

bool is_injective(const Chart& chart)
{
  return number_of_flips(chart) == 0 && !meeting_sides(outline(chart));
}

std::vector<Chart> injective_charts(const Glued_triangles& t, const std::vector<Index>& patch,
                                    Index number_of_patches, const Chart_options& options)
{
  std::vector<Chart> result, waiting = cut_out(t, patch, number_of_patches);
  while(!waiting.empty())
  {
    std::vector<std::vector<Chart>> made(waiting.size());
    for_each_block(waiting.size(), 1, options.threads,
                   [&](std::size_t i, std::size_t, std::size_t)
                   { made[i] = lay_out(waiting[i], options); });
    std::vector<Chart> next;
    for(std::size_t i = 0; i < waiting.size(); ++i)
      if(made[i].empty())
        result.push_back(std::move(waiting[i]));
      else
        std::move(made[i].begin(), made[i].end(), std::back_inserter(next));
    if(options.callback &&
       !options.callback(double(result.size()) / double(result.size() + next.size())))
      return {};
    waiting = std::move(next);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
