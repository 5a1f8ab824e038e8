// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/splats.h"

#include "readers/vectors.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>

namespace program {

namespace {

// Returns the radius of each disk: 0.75 times the distance of the farthest of 7 neighbors. The
// neighbors include the point itself; coincident points count once.
std::vector<double> splat_radii(const std::vector<Point>& points)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Neighbor_search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;
  std::vector<Point> unique_points = points;
  std::sort(unique_points.begin(), unique_points.end());
  unique_points.erase(std::unique(unique_points.begin(), unique_points.end()), unique_points.end());
  Neighbor_search::Tree tree;
  for(const Point& p : unique_points)
    tree.insert({p[0], p[1], p[2]});

  std::vector<double> radii(points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Point& p = points[i];
    double squared_distance = 0.;
    for(const auto& neighbor : Neighbor_search(tree, {p[0], p[1], p[2]}, 7))
      squared_distance = std::max(squared_distance, neighbor.second);
    radii[i] = 0.75 * std::sqrt(squared_distance);
  }
  // Disks of isolated points must neither vanish nor cover other points.
  std::vector<double> sorted = radii;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  const double median = std::max(sorted[sorted.size() / 2], 1e-3);
  for(double& radius : radii)
    radius = std::clamp(radius, 0.4 * median, 1.8 * median);
  return radii;
}

void append_disk(const Point& center, const Point& normal, double radius, const Color& color,
                 Render_mesh& mesh)
{
  constexpr std::uint32_t number_of_sides = 10;
  const Point helper = std::abs(normal[0]) < 0.6 ? Point{1., 0., 0.} : Point{0., 1., 0.};
  Point u = cross(normal, helper);
  u = (1. / norm(u)) * u;
  const Point v = cross(normal, u);
  const auto first_index = static_cast<std::uint32_t>(mesh.points.size());
  for(std::uint32_t k = 0; k < number_of_sides; ++k)
  {
    const double angle = 2. * 3.14159265358979 * k / number_of_sides;
    mesh.points.push_back(center + (radius * std::cos(angle)) * u + (radius * std::sin(angle)) * v);
    mesh.normals.push_back(normal);
    mesh.colors.push_back(color);
    if(k >= 2)
      mesh.corners.insert(mesh.corners.end(), {first_index, first_index + k - 1, first_index + k});
  }
}

} // namespace

Render_mesh make_splats(const std::vector<Point>& points, const std::vector<Point>& normals,
                        const std::vector<Color>& colors)
{
  const std::vector<double> radii = splat_radii(points);
  Render_mesh mesh;
  for(std::size_t i = 0; i < points.size(); ++i)
    append_disk(points[i], normals[i], radii[i], colors[i], mesh);
  return mesh;
}

} // namespace program
