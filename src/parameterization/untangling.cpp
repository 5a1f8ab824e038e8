// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/untangling.h>

#include <CGAL/Geodesic_processing/internal/parameterization/charts.h>
#include <CGAL/Geodesic_processing/internal/parameterization/symmetric_dirichlet.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Few rings cause the least change of the map; the larger neighborhood is tried if the smaller one
// fails.
constexpr int ring_counts[] = {4, 8};
constexpr std::size_t max_triangles_per_region = 1000, max_triangles = 3000;

// Maximum number of Newton steps. Regions that can be repaired need at most half of them.
constexpr std::size_t max_steps = 50;
constexpr double energy_tolerance = 1e-4;

// Mean energy above which a result is rejected: it is that of triangles stretched by a factor of
// ten.
constexpr double max_energy = 100.;

// Returns the triangles of positive area whose image has not.
std::vector<Index> inverted_triangles(const Surface_arrays& t, const std::vector<Vec2>& image)
{
  std::vector<Index> result;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    if(!(twice_area_of_image(t, image, f) > 0.) &&
       twice_area(t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]) > 0.)
      result.push_back(f);
  return result;
}

// Grows triangles by rings of vertex neighbors and divides them into edge-connected regions.
// Regions that exceed the limits are dropped. Returns the region of each triangle, or none, and
// the number of regions.
std::pair<std::vector<Index>, Index> grow_regions(const Surface_arrays& t,
                                                  std::vector<Index> triangles, int number_of_rings)
{
  constexpr Index unassigned = none - 1;
  std::vector<Index> region(t.number_of_triangles(), none);
  for(const Index f : triangles)
    region[f] = unassigned;
  for(std::size_t begin = 0; number_of_rings > 0; --number_of_rings)
    for(const std::size_t end = triangles.size(); begin < end; ++begin)
      for(int k = 0; k < 3; ++k)
      {
        const Index vertex = t.corner[3 * triangles[begin] + Index(k)];
        for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
          if(Index& other = region[t.ring[i] / 3]; other == none)
          {
            other = unassigned;
            triangles.push_back(t.ring[i] / 3);
          }
      }
  Index number_of_regions = 0;
  std::size_t total = 0;
  std::vector<Index> component;
  for(const Index start : triangles)
  {
    if(region[start] != unassigned)
      continue;
    component.assign(1, start);
    region[start] = number_of_regions;
    for(std::size_t i = 0; i < component.size(); ++i)
      for(Index h = 3 * component[i]; h < 3 * component[i] + 3; ++h)
        if(t.twin[h] != none && region[t.twin[h] / 3] == unassigned)
        {
          region[t.twin[h] / 3] = number_of_regions;
          component.push_back(t.twin[h] / 3);
        }
    if(component.size() <= std::min(max_triangles_per_region, max_triangles - total))
    {
      total += component.size();
      ++number_of_regions;
    }
    else
      for(const Index f : component)
        region[f] = none;
  }
  return {region, number_of_regions};
}

// Returns whether the triangles of a vertex cover its neighborhood once: their angles in the image
// must not exceed a full turn, or the angle on the surface, by half a turn.
bool is_winding_once(const Surface_arrays& t, const std::vector<Vec2>& image, Index vertex)
{
  double angle = 0., surface_angle = 0.;
  bool is_interior = true;
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
  {
    const Index corner = t.ring[i];
    is_interior =
        is_interior && t.twin[corner] != none && t.twin[previous_halfedge(corner)] != none;
    const Vec2 p = image[t.corner[next_halfedge(corner)]] - image[vertex],
               q = image[t.corner[previous_halfedge(corner)]] - image[vertex],
               on_surface = corner_angle(t, corner);
    angle += std::atan2(cross(p, q), dot(p, q));
    surface_angle += std::atan2(on_surface[1], on_surface[0]);
  }
  return angle < (is_interior ? 3. * pi : std::max(2. * pi, surface_angle + pi));
}

// Repairs the image of a chart, scaled to the area of the surface. The image is unchanged if this
// fails.
void unflip(const Surface_arrays& t, Chart& chart, std::vector<Vec2>& image, double scale)
{
  const Surface_arrays& surface = chart.surface;
  std::vector<Index> vertices(surface.number_of_vertices());
  for(std::size_t c = 0; c < surface.corner.size(); ++c)
    vertices[surface.corner[c]] = t.corner[3 * std::size_t(chart.triangles[c / 3]) + c % 3];
  std::vector<bool> is_fixed;
  std::vector<Vec2> before;
  for(Index i = 0; i < vertices.size(); ++i)
  {
    chart.image.push_back(scale * image[vertices[i]]);
    before.push_back(image[vertices[i]]);
    is_fixed.push_back(surface.ring_begin[i + 1] - surface.ring_begin[i] <
                       t.ring_begin[vertices[i] + 1] - t.ring_begin[vertices[i]]);
  }
  if(!unflip(surface, chart.image, max_steps, is_fixed))
    return;
  const Minimization_result found =
      minimize_symmetric_dirichlet(surface, chart.image, max_steps, {}, energy_tolerance, is_fixed);
  if(!(found.energy < max_energy))
    return;
  for(Index i = 0; i < vertices.size(); ++i)
    if(!is_fixed[i])
      image[vertices[i]] = (1. / scale) * chart.image[i];
  if(!std::all_of(vertices.begin(), vertices.end(),
                  [&](Index vertex) { return is_winding_once(t, image, vertex); }))
    for(Index i = 0; i < vertices.size(); ++i)
      image[vertices[i]] = before[i];
}

} // namespace

void orient_positively(const Surface_arrays& t, std::vector<Vec2>& image)
{
  double sum = 0.;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    sum += (t.weight.empty() ? 1. : double(t.weight[f])) * twice_area_of_image(t, image, f);
  if(sum < 0.)
    for(Vec2& p : image)
      p[1] = -p[1];
}

void untangle(const Surface_arrays& t, std::vector<Vec2>& image)
{
  if(t.is_cloud())
    return;
  const double scale = scale_to_area(t, image);
  if(scale == 0.)
    return;
  for(const int number_of_rings : ring_counts)
  {
    std::vector<Index> inverted = inverted_triangles(t, image);
    if(inverted.empty())
      return;
    const auto [region, number_of_regions] = grow_regions(t, std::move(inverted), number_of_rings);
    for(Chart& chart : extract_charts(t, region, number_of_regions))
      unflip(t, chart, image, scale);
  }
}

} // namespace CGAL::Geodesic_processing::internal
