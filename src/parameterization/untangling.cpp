// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/untangling.h>

#include <CGAL/Geodesic_processing/internal/parameterization/charts.h>
#include <CGAL/Geodesic_processing/internal/parameterization/injective.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// What is moved: little distorts much, and more is tried where little does not do.
constexpr int rings[] = {4, 8};
constexpr std::size_t most_triangles = 1000, most_in_all = 3000;

// Newton's method turns back what it can in half of these steps.
constexpr std::size_t most_steps = 50;
constexpr double least_progress = 1e-4;

// Of what is moved: stretched ten times.
constexpr double most_energy = 100.;

// Triangles that have an area, which their image has not, or the other side up.
std::vector<Index> turned_round(const Glued_triangles& t, const std::vector<Planar>& image)
{
  std::vector<Index> result;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    if(!(twice_area_of_image(t, image, f) > 0.) &&
       twice_area(t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]) > 0.)
      result.push_back(f);
  return result;
}

// Triangles and rings of others about them, in regions that no side joins: a label for each triangle, or none,
// and how many there are, of those that are not too large, one by one and together.
std::pair<std::vector<Index>, Index> regions(const Glued_triangles& t, std::vector<Index> members,
                                             int number_of_rings)
{
  constexpr Index waiting = none - 1;
  std::vector<Index> region(t.number_of_triangles(), none);
  for(const Index f : members)
    region[f] = waiting;
  for(std::size_t begin = 0; number_of_rings > 0; --number_of_rings)
    for(const std::size_t end = members.size(); begin < end; ++begin)
      for(int k = 0; k < 3; ++k)
      {
        const Index site = t.corner[3 * members[begin] + Index(k)];
        for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
          if(Index& other = region[t.star[i] / 3]; other == none)
          {
            other = waiting;
            members.push_back(t.star[i] / 3);
          }
      }
  Index number = 0;
  std::size_t in_all = 0;
  std::vector<Index> piece;
  for(const Index start : members)
  {
    if(region[start] != waiting)
      continue;
    piece.assign(1, start);
    region[start] = number;
    for(std::size_t i = 0; i < piece.size(); ++i)
      for(Index side = 3 * piece[i]; side < 3 * piece[i] + 3; ++side)
        if(t.twin[side] != none && region[t.twin[side] / 3] == waiting)
        {
          region[t.twin[side] / 3] = number;
          piece.push_back(t.twin[side] / 3);
        }
    if(piece.size() <= std::min(most_triangles, most_in_all - in_all))
    {
      in_all += piece.size();
      ++number;
    }
    else
      for(const Index f : piece)
        region[f] = none;
  }
  return {region, number};
}

// Whether the triangles around a site lie around it once: not by a turn more than they do on the surface, or
// in the plane, whichever is more.
bool is_around_once(const Glued_triangles& t, const std::vector<Planar>& image, Index site)
{
  double angle = 0., own = 0.;
  bool is_inner = true;
  for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
  {
    const Index corner = t.star[i];
    is_inner = is_inner && t.twin[corner] != none && t.twin[previous_side(corner)] != none;
    const Planar p = image[t.corner[next_side(corner)]] - image[site],
                 q = image[t.corner[previous_side(corner)]] - image[site],
                 on_surface = corner_angle(t, corner);
    angle += std::atan2(cross(p, q), dot(p, q));
    own += std::atan2(on_surface[1], on_surface[0]);
  }
  return angle < (is_inner ? 3. * pi : std::max(2. * pi, own + pi));
}

void turn_back(const Glued_triangles& t, Chart& chart, std::vector<Planar>& image, double scale)
{
  const Glued_triangles& shape = chart.shape;
  std::vector<Index> sites(shape.number_of_sites());
  for(std::size_t c = 0; c < shape.corner.size(); ++c)
    sites[shape.corner[c]] = t.corner[3 * std::size_t(chart.triangles[c / 3]) + c % 3];
  std::vector<bool> is_held;
  std::vector<Planar> before;
  for(Index i = 0; i < sites.size(); ++i)
  {
    chart.image.push_back(scale * image[sites[i]]);
    before.push_back(image[sites[i]]);
    is_held.push_back(shape.first[i + 1] - shape.first[i] <
                      t.first[sites[i] + 1] - t.first[sites[i]]);
  }
  if(!turn_back(shape, chart.image, most_steps, is_held))
    return;
  const Flattest found =
      minimize_symmetric_dirichlet(shape, chart.image, most_steps, {}, least_progress, is_held);
  if(!(found.energy < most_energy))
    return;
  for(Index i = 0; i < sites.size(); ++i)
    if(!is_held[i])
      image[sites[i]] = (1. / scale) * chart.image[i];
  if(!std::all_of(sites.begin(), sites.end(),
                  [&](Index site) { return is_around_once(t, image, site); }))
    for(Index i = 0; i < sites.size(); ++i)
      image[sites[i]] = before[i];
}

} // namespace

void face_up(const Glued_triangles& t, std::vector<Planar>& image)
{
  double sum = 0.;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    sum += (t.weight.empty() ? 1. : double(t.weight[f])) * twice_area_of_image(t, image, f);
  if(sum < 0.)
    for(Planar& p : image)
      p[1] = -p[1];
}

void untangle(const Glued_triangles& t, std::vector<Planar>& image)
{
  if(t.is_cloud())
    return;
  const double scale = scale_to_area(t, image);
  if(scale == 0.)
    return;
  for(const int number : rings)
  {
    std::vector<Index> turned = turned_round(t, image);
    if(turned.empty())
      return;
    const auto [region, number_of_regions] = regions(t, std::move(turned), number);
    for(Chart& chart : cut_out(t, region, number_of_regions))
      turn_back(t, chart, image, scale);
  }
}

} // namespace CGAL::Geodesic_processing::internal
