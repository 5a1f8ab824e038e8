// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/fitting.h"

#include "core/unfold.h"

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The mean distance of a scan from 5,000 vertices falls from 0.031 percent of the diagonal to 0.018 in one
// step, 0.0174 in two and 0.016 in ten; but the least angles fall too, with each.
constexpr int steps_of_fit = 2;

// In steps with care no triangle gets a smaller angle than this of 42 degrees: next to none of a mesh that is
// relaxed well have, so that careful steps cost a tenth of a degree of the mean, and nothing of its first percentile.
constexpr double cosine_to_keep = 0.743;

// The triangles around each point.
std::vector<std::vector<Index>> triangles_around(const Coarse_mesh& mesh)
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

// The triangles around points, and what tells from afar which of them is near.
class Stars
{
public:
  explicit Stars(const Coarse_mesh& mesh)
      : m_mesh(mesh), m_star(triangles_around(mesh)), m_slabs(mesh.triangles.size())
  {
    for(std::size_t f = 0; f < m_slabs.size(); ++f)
    {
      const std::array<Spatial, 3> p = corners(Index(f));
      Slab& slab = m_slabs[f];
      slab.normal = unit(cross(p[1] - p[0], p[2] - p[0]));
      for(int k = 0; k < 3; ++k)
        slab.outwards[k] = unit(cross(p[(k + 1) % 3] - p[k], slab.normal));
    }
  }

  // On the triangles around a point.
  Nearest nearest(Index point, const Spatial& p)
  {
    const std::vector<Index>& star = m_star[point];
    m_bounds.clear();
    std::size_t first = 0;
    for(const Index f : star)
    {
      m_bounds.push_back(squared_bound(f, p));
      if(m_bounds.back() < m_bounds[first])
        first = m_bounds.size() - 1;
    }
    Nearest result;
    const auto look_at = [&](Index f)
    {
      const auto [a, b, c] = corners(f);
      const auto nearest = nearest_in_triangle(a, b, c, p);
      const Spatial way = p - (nearest[0] * a + nearest[1] * b + nearest[2] * c);
      if(const double length = norm(way); length < result.length)
        result = {f, nearest, way, length};
    };
    if(!star.empty())
      look_at(star[first]);
    for(std::size_t i = 0; i < star.size(); ++i)
      if(i != first && m_bounds[i] < result.length * result.length)
        look_at(star[i]);
    return result;
  }

private:
  struct Slab
  {
    Spatial normal;
    std::array<Spatial, 3> outwards; // from each side, in the plane
  };

  std::array<Spatial, 3> corners(Index f) const
  {
    const auto& triangle = m_mesh.triangles[f];
    return {m_mesh.points[triangle[0]], m_mesh.points[triangle[1]], m_mesh.points[triangle[2]]};
  }

  // No place of the triangle is nearer.
  double squared_bound(Index f, const Spatial& p) const
  {
    const Slab& slab = m_slabs[f];
    const auto& triangle = m_mesh.triangles[f];
    double aside = 0.;
    for(int k = 0; k < 3; ++k)
      aside = std::max(aside, dot(slab.outwards[k], p - m_mesh.points[triangle[k]]));
    const double above = dot(slab.normal, p - m_mesh.points[triangle[0]]);
    return aside * aside + above * above;
  }

  const Coarse_mesh& m_mesh;
  std::vector<std::vector<Index>> m_star;
  std::vector<Slab> m_slabs;
  std::vector<double> m_bounds; // of a star
};

// Takes points back to where they were before, until no triangle has got a smaller angle that is small.
void undo_where_angles_suffer(const std::vector<Spatial>& before, Coarse_mesh& mesh)
{
  for(bool is_undone = true; is_undone;)
  {
    is_undone = false;
    for(const auto& [a, b, c] : mesh.triangles)
    {
      std::vector<Spatial>& now = mesh.points;
      const double cosine = largest_cosine(now[a], now[b], now[c]);
      if(cosine <= cosine_to_keep || cosine <= largest_cosine(before[a], before[b], before[c]))
        continue;
      for(const Index i : {a, b, c})
        now[i] = before[i];
      is_undone = true;
    }
  }
}

} // namespace

std::vector<Index> far_sites(const Glued_triangles& fine, const std::vector<Index>& labels,
                             const Coarse_mesh& coarse, double most)
{
  Stars stars(coarse);
  std::vector<std::pair<double, Index>> farthest(coarse.points.size(), {most, none});
  for(Index site = 0; site < labels.size(); ++site)
    if(const Index cell = labels[site]; cell != none)
      if(const double length = stars.nearest(cell, fine.point[site]).length;
         length < infinity && length > farthest[cell].first)
        farthest[cell] = {length, site};
  std::vector<Index> result;
  for(const auto& [length, site] : farthest)
    if(site != none)
      result.push_back(site);
  return result;
}

void fit(const Glued_triangles& fine, const std::vector<Index>& labels,
         const std::vector<bool>& is_fixed, Coarse_mesh& coarse, double most, int careful_steps)
{
  const std::vector<Spatial> first = coarse.points;
  std::vector<double> area(labels.size(), 0.);
  for(Index f = 0; f < fine.number_of_triangles(); ++f)
    for(Index side = 3 * f; side < 3 * f + 3; ++side)
      area[fine.corner[side]] +=
          twice_area(fine.length[3 * f], fine.length[3 * f + 1], fine.length[3 * f + 2]);
  for(int step = 0; step < steps_of_fit + careful_steps; ++step)
  {
    const std::vector<Spatial> before = coarse.points;
    Stars stars(coarse);
    std::vector<Spatial> moves(coarse.points.size(), Spatial{0., 0., 0.});
    std::vector<double> weights(coarse.points.size(), 0.);
    for(Index site = 0; site < labels.size(); ++site)
      if(const Index cell = labels[site]; cell != none)
        if(const Nearest nearest = stars.nearest(cell, fine.point[site]); nearest.triangle != none)
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
        const Spatial way = coarse.points[i] + (1. / weights[i]) * moves[i] - first[i];
        coarse.points[i] = first[i] + std::min(1., most / norm(way)) * way;
      }
    if(step >= steps_of_fit)
      undo_where_angles_suffer(before, coarse);
  }
}

} // namespace CGAL::Geodesic_processing::internal
