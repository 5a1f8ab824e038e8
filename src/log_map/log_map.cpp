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

// The minimum length of a path that ends at the boundary, as a fraction of the stencil's length.
constexpr double min_length_ratio = 0.3;

// The 2 x 2 matrix of a least-squares problem: the sum of q q^T.
struct Normal_matrix
{
  double xx = 0., xy = 0., yy = 0.;

  void add(const Vec2& q)
  {
    xx += q[0] * q[0];
    xy += q[0] * q[1];
    yy += q[1] * q[1];
  }
  double determinant() const { return xx * yy - xy * xy; }
  // Returns whether the vectors are not almost parallel.
  bool is_regular() const
  {
    const double trace = xx + yy;
    return determinant() > 1e-4 * trace * trace;
  }
  Vec2 solve(const Vec2& b) const
  {
    return (1. / determinant()) * Vec2{yy * b[0] - xy * b[1], xx * b[1] - xy * b[0]};
  }
};

bool is_regular(const Stencil& stencil)
{
  Normal_matrix matrix;
  for(const Vec2& q : stencil.vectors)
    matrix.add(q);
  return matrix.is_regular();
}

Vec2 unit_vector(double angle) { return {std::cos(angle), std::sin(angle)}; }

} // namespace

Stencil straightest_stencil(const Tangent_plane& plane, double length, std::size_t count)
{
  Stencil stencil;
  for(int halvings = 0; halvings < 20; ++halvings, length /= 2.)
  {
    stencil = {};
    for(std::size_t i = 0; i < count; ++i)
    {
      const double angle = plane.total_angle() * (double(i) + 0.5) / double(count);
      const Straightest_path path = plane.straightest_path(angle, length);
      if(path.length < min_length_ratio * length)
        continue;
      stencil.locations.push_back(path.locations.back());
      stencil.vectors.push_back(path.length * unit_vector(angle));
    }
    if(is_regular(stencil))
      break;
  }
  return stencil;
}

Stencil vertex_stencil(const Surface_arrays& t, const Tangent_plane& plane,
                       const std::vector<Index>& vertices, const std::vector<double>& distances,
                       double length, std::size_t count)
{
  Stencil stencil;
  for(int doublings = 0; doublings < 20; ++doublings, length *= 2.)
  {
    std::vector<Index> farthest(count, none); // positions among the candidates
    std::vector<Vec2> directions(count);
    for(Index i = 0; i < vertices.size(); ++i)
    {
      const Vec3 offset = t.point[vertices[i]] - plane.point();
      const Vec2 projected = {dot(offset, plane.x()), dot(offset, plane.y())};
      if(!(distances[i] > 0.) || distances[i] > length || !(norm(projected) > 0.))
        continue;
      const double normalized_angle = std::atan2(projected[1], projected[0]) / (2. * pi) + 1.;
      const std::size_t sector = std::size_t(normalized_angle * double(count)) % count;
      if(farthest[sector] != none && distances[i] <= distances[farthest[sector]])
        continue;
      farthest[sector] = i;
      directions[sector] = (1. / norm(projected)) * projected;
    }
    stencil = {};
    for(std::size_t sector = 0; sector < count; ++sector)
      if(const Index i = farthest[sector]; i != none)
      {
        stencil.locations.push_back(vertex_location(t, vertices[i]));
        stencil.vectors.push_back(distances[i] * directions[sector]);
      }
    if(is_regular(stencil))
      break;
  }
  return stencil;
}

double mean_edge_length(const Surface_arrays& t, const Surface_location& location)
{
  double sum = 0., count = 0.;
  for(const Index triangle : triangles_at(t, canonical(t, location)))
    for(Index h = 3 * triangle; h < 3 * triangle + 3; ++h, ++count)
      sum += t.length[h];
  return count > 0. ? sum / count : 0.;
}

double mean_normal_angle(const Surface_arrays& t, const Surface_location& location)
{
  double sum = 0., count = 0.;
  for(const Index triangle : triangles_at(t, canonical(t, location)))
  {
    std::array<Vec3, 3> normal;
    for(Index k = 0; k < 3; ++k)
      normal[k] = vertex_normal(t, t.corner[3 * triangle + k]);
    for(Index k = 0; k < 3; ++k, ++count)
      sum += std::acos(std::clamp(dot(normal[k], normal[(k + 1) % 3]), -1., 1.));
  }
  return count > 0. ? sum / count : 0.;
}

Log_map_fit::Log_map_fit(std::vector<Vec2> stencil) : m_stencil(std::move(stencil)) {}

Vec2 Log_map_fit::gradient(double distance, const double* stencil_distances) const
{
  Normal_matrix matrix;
  Vec2 sum = {0., 0.};
  for(std::size_t j = 0; j < m_stencil.size(); ++j)
  {
    const Vec2& q = m_stencil[j];
    if(!std::isfinite(stencil_distances[j]))
      continue;
    matrix.add(q);
    sum = sum +
          ((stencil_distances[j] - distance) * (stencil_distances[j] + distance) - dot(q, q)) * q;
  }
  if(!matrix.is_regular())
    return {0., 0.};
  return -0.5 * matrix.solve(sum);
}

Vec2 Log_map_fit::with_length(const Vec2& direction, double length)
{
  const double size = norm(direction);
  return size > 0. ? (length / size) * direction : Vec2{0., 0.};
}

Vec2 transported_step(const Tangent_plane& plane, const Vec3& normal, const Vec3& step)
{
  const Vec3 base_normal = plane.normal();
  Vec3 transported = step - dot(step, normal) * normal;
  // If the normals are opposite, the smallest rotation is not unique, and none is applied.
  if(const double sum = 1. + dot(normal, base_normal); sum > 0.)
    transported = transported - (dot(transported, base_normal) / sum) * (normal + base_normal);
  const Vec2 projected = {dot(transported, plane.x()), dot(transported, plane.y())};
  const double size = norm(projected);
  return size > 0. ? (norm(step) / size) * projected : Vec2{0., 0.};
}

Log_map_defects find_map_defects(const Surface_arrays& t, const std::vector<Index>& reached,
                                 const std::vector<Vec2>& coordinates)
{
  Log_map_defects result;
  for(const Index v : reached)
    for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
    {
      const Index triangle = t.ring[i] / 3;
      std::array<Vec2, 3> image;
      bool has_image = true, is_first = true;
      for(Index k = 0; k < 3; ++k)
      {
        const Index corner = t.corner[3 * triangle + k];
        image[k] = coordinates[corner];
        has_image = has_image && std::isfinite(image[k][0]);
        is_first = is_first && v <= corner;
      }
      if(!has_image || !is_first)
        continue;
      bool is_cut_triangle = false;
      for(Index k = 0; k < 3; ++k)
        is_cut_triangle =
            is_cut_triangle || is_cut(t, 3 * triangle + k, image[k], image[(k + 1) % 3]);
      if(is_cut_triangle)
        result.cut_triangles.push_back(triangle);
      else if(cross(image[1] - image[0], image[2] - image[0]) < 0.)
        ++result.number_of_flips;
    }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
