// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/log_map.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Of the length of a stencil, that a path must have got on before a border.
constexpr double least_part = 0.3;

// The sums of products of vectors.
struct Normal_matrix
{
  double xx = 0., xy = 0., yy = 0.;

  void add(const Planar& q)
  {
    xx += q[0] * q[0];
    xy += q[0] * q[1];
    yy += q[1] * q[1];
  }
  double determinant() const { return xx * yy - xy * xy; }
  // Whether the vectors have two directions, and not almost one.
  bool is_regular() const
  {
    const double trace = xx + yy;
    return determinant() > 1e-4 * trace * trace;
  }
  Planar solve(const Planar& b) const
  {
    return (1. / determinant()) * Planar{yy * b[0] - xy * b[1], xx * b[1] - xy * b[0]};
  }
};

bool is_regular(const Stencil& stencil)
{
  Normal_matrix matrix;
  for(const Planar& q : stencil.vectors)
    matrix.add(q);
  return matrix.is_regular();
}

Planar at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

} // namespace

Stencil straight_stencil(const Tangent_plane& plane, double length, std::size_t number)
{
  Stencil stencil;
  for(int halvings = 0; halvings < 20; ++halvings, length /= 2.)
  {
    stencil = {};
    for(std::size_t i = 0; i < number; ++i)
    {
      const double angle = plane.opening() * (double(i) + 0.5) / double(number);
      const Straightest_path path = plane.straight(angle, length);
      if(path.length < least_part * length)
        continue;
      stencil.places.push_back(path.locations.back());
      stencil.vectors.push_back(path.length * at_angle(angle));
    }
    if(is_regular(stencil))
      break;
  }
  return stencil;
}

Stencil stencil_of_sites(const Glued_triangles& t, const Tangent_plane& plane,
                         const std::vector<Index>& sites, const std::vector<double>& distances,
                         double length, std::size_t number)
{
  Stencil stencil;
  for(int doublings = 0; doublings < 20; ++doublings, length *= 2.)
  {
    std::vector<Index> farthest(number, none);
    std::vector<Planar> directions(number);
    for(const Index site : sites)
    {
      const Spatial way = t.point[site] - plane.point();
      const Planar seen = {dot(way, plane.x()), dot(way, plane.y())};
      if(!(distances[site] > 0.) || distances[site] > length || !(norm(seen) > 0.))
        continue;
      const double turn = std::atan2(seen[1], seen[0]) / (2. * pi) + 1.;
      const std::size_t sector = std::size_t(turn * double(number)) % number;
      if(farthest[sector] != none && distances[site] <= distances[farthest[sector]])
        continue;
      farthest[sector] = site;
      directions[sector] = (1. / norm(seen)) * seen;
    }
    stencil = {};
    for(std::size_t sector = 0; sector < number; ++sector)
      if(const Index site = farthest[sector]; site != none)
      {
        stencil.places.push_back(at_site(t, site));
        stencil.vectors.push_back(distances[site] * directions[sector]);
      }
    if(is_regular(stencil))
      break;
  }
  return stencil;
}

double mean_length_around(const Glued_triangles& t, const Location& at)
{
  double sum = 0., number = 0.;
  for(const Index triangle : triangles_at(t, cleaned(t, at)))
    for(Index side = 3 * triangle; side < 3 * triangle + 3; ++side, ++number)
      sum += t.length[side];
  return number > 0. ? sum / number : 0.;
}

double mean_bend_around(const Glued_triangles& t, const Location& at)
{
  double sum = 0., number = 0.;
  for(const Index triangle : triangles_at(t, cleaned(t, at)))
  {
    std::array<Spatial, 3> normal;
    for(Index k = 0; k < 3; ++k)
      normal[k] = site_normal(t, t.corner[3 * triangle + k]);
    for(Index k = 0; k < 3; ++k, ++number)
      sum += std::acos(std::clamp(dot(normal[k], normal[(k + 1) % 3]), -1., 1.));
  }
  return number > 0. ? sum / number : 0.;
}

Log_fit::Log_fit(std::vector<Planar> stencil) : m_stencil(std::move(stencil)) {}

Planar Log_fit::operator()(double distance, const double* from_stencil) const
{
  Normal_matrix matrix;
  Planar sum = {0., 0.};
  for(std::size_t j = 0; j < m_stencil.size(); ++j)
  {
    const Planar& q = m_stencil[j];
    if(!std::isfinite(from_stencil[j]))
      continue;
    matrix.add(q);
    sum = sum + ((from_stencil[j] - distance) * (from_stencil[j] + distance) - dot(q, q)) * q;
  }
  if(!matrix.is_regular())
    return {0., 0.};
  const Planar way = -1. * matrix.solve(sum);
  const double size = norm(way);
  return size > 0. ? (distance / size) * way : Planar{0., 0.};
}

Planar step_in_plane(const Tangent_plane& plane, const Spatial& normal, const Spatial& step)
{
  const Spatial up = plane.normal();
  Spatial along = step - dot(step, normal) * normal;
  // Where the normals are opposite to each other, no rotation is the least one.
  if(const double sum = 1. + dot(normal, up); sum > 0.)
    along = along - (dot(along, up) / sum) * (normal + up);
  const Planar seen = {dot(along, plane.x()), dot(along, plane.y())};
  const double size = norm(seen);
  return size > 0. ? (norm(step) / size) * seen : Planar{0., 0.};
}

Log_triangles look_at_triangles(const Glued_triangles& t, const std::vector<Index>& reached,
                                const std::vector<Planar>& coordinates)
{
  Log_triangles result;
  for(const Index site : reached)
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      const Index triangle = t.star[i] / 3;
      std::array<Planar, 3> image;
      bool is_inside = true, is_first = true;
      for(Index k = 0; k < 3; ++k)
      {
        const Index corner = t.corner[3 * triangle + k];
        image[k] = coordinates[corner];
        is_inside = is_inside && std::isfinite(image[k][0]);
        is_first = is_first && site <= corner;
      }
      if(!is_inside || !is_first)
        continue;
      bool has_cut = false;
      for(Index k = 0; k < 3; ++k)
        has_cut = has_cut || is_cut(t, 3 * triangle + k, image[k], image[(k + 1) % 3]);
      if(has_cut)
        result.cut.push_back(triangle);
      else if(cross(image[1] - image[0], image[2] - image[0]) < 0.)
        ++result.folded;
    }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
