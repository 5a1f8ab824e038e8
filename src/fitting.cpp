// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/fitting.h>

#include <CGAL/Geodesic_processing/internal/unfold.h>

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The mean distance of a scan from 5,000 vertices falls from 0.031 percent of the diagonal to 0.018 in one
// step, 0.0174 in two and 0.016 in ten; but the least angles fall too, with each.
constexpr int steps_of_fit = 2;

// The triangles around each point.
std::vector<std::vector<Index>> stars(const Coarse_mesh& mesh)
{
  std::vector<std::vector<Index>> result(mesh.points.size());
  for(Index f = 0; f < mesh.triangles.size(); ++f)
    for(const Index point : mesh.triangles[f])
      result[point].push_back(f);
  return result;
}

// What is nearest to a place on some triangles.
struct Nearest
{
  Index triangle = none;
  std::array<double, 3> barycentric;
  Spatial way; // from there to the place
  double length = infinity;
};

Nearest nearest_on(const std::vector<Index>& star, const Coarse_mesh& mesh, const Spatial& p)
{
  Nearest result;
  for(const Index f : star)
  {
    const auto& triangle = mesh.triangles[f];
    const Spatial &a = mesh.points[triangle[0]], &b = mesh.points[triangle[1]],
                  &c = mesh.points[triangle[2]];
    const auto nearest = nearest_in_triangle(a, b, c, p);
    const Spatial way = p - (nearest[0] * a + nearest[1] * b + nearest[2] * c);
    if(const double length = norm(way); length < result.length)
      result = {f, nearest, way, length};
  }
  return result;
}

} // namespace

std::vector<Index> far_sites(const Glued_triangles& fine, const std::vector<Index>& labels,
                             const Coarse_mesh& coarse, double most)
{
  const auto star = stars(coarse);
  std::vector<std::pair<double, Index>> farthest(coarse.points.size(), {most, none});
  for(Index site = 0; site < labels.size(); ++site)
    if(const Index cell = labels[site]; cell != none)
      if(const double length = nearest_on(star[cell], coarse, fine.point[site]).length;
         length < infinity && length > farthest[cell].first)
        farthest[cell] = {length, site};
  std::vector<Index> result;
  for(const auto& [length, site] : farthest)
    if(site != none)
      result.push_back(site);
  return result;
}

void fit(const Glued_triangles& fine, const std::vector<Index>& labels,
         const std::vector<bool>& is_fixed, Coarse_mesh& coarse, double most)
{
  const std::vector<Spatial> before = coarse.points;
  std::vector<double> area(labels.size(), 0.);
  for(Index f = 0; f < fine.number_of_triangles(); ++f)
    for(Index side = 3 * f; side < 3 * f + 3; ++side)
      area[fine.corner[side]] +=
          twice_area(fine.length[3 * f], fine.length[3 * f + 1], fine.length[3 * f + 2]);
  const auto star = stars(coarse);
  for(int step = 0; step < steps_of_fit; ++step)
  {
    std::vector<Spatial> moves(coarse.points.size(), Spatial{0., 0., 0.});
    std::vector<double> weights(coarse.points.size(), 0.);
    for(Index site = 0; site < labels.size(); ++site)
      if(const Index cell = labels[site]; cell != none)
        if(const Nearest nearest = nearest_on(star[cell], coarse, fine.point[site]);
           nearest.triangle != none)
          for(int k = 0; k < 3; ++k)
          {
            const Index point = coarse.triangles[nearest.triangle][k];
            const double weight = area[site] * nearest.barycentric[k];
            moves[point] = moves[point] + weight * nearest.way;
            weights[point] += weight;
          }
    for(std::size_t i = 0; i < coarse.points.size(); ++i)
      if(weights[i] > 0. && !is_fixed[i])
      {
        const Spatial way = coarse.points[i] + (1. / weights[i]) * moves[i] - before[i];
        coarse.points[i] = before[i] + std::min(1., most / norm(way)) * way;
      }
  }
}

} // namespace CGAL::Geodesic_processing::internal
