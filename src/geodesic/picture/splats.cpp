// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/splats.h"

#include "picture/vectors.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>

namespace program {

Render_mesh make_splats(const std::vector<Point>& points, const std::vector<Point>& normals,
                        const std::vector<Color>& colors)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;
  std::vector<Kernel::Point_3> unique_points;
  for(const Point& p : points)
    unique_points.emplace_back(p[0], p[1], p[2]);
  std::sort(unique_points.begin(), unique_points.end());
  unique_points.erase(std::unique(unique_points.begin(), unique_points.end()), unique_points.end());
  Search::Tree tree(unique_points.begin(), unique_points.end());

  std::vector<double> radius(points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Search search(tree, {points[i][0], points[i][1], points[i][2]}, 7);
    double max_squared_distance = 0.;
    for(const auto& neighbor : search)
      max_squared_distance = std::max(max_squared_distance, neighbor.second);
    radius[i] = 0.75 * std::sqrt(max_squared_distance);
  }
  // Disks of isolated points must neither vanish nor cover other points.
  std::vector<double> sorted = radius;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  const double median = std::max(sorted[sorted.size() / 2], 1e-3);

  constexpr std::uint32_t number_of_sides = 10;
  Render_mesh mesh;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Point& n = normals[i];
    const Point helper = std::abs(n[0]) < 0.6 ? Point{1., 0., 0.} : Point{0., 1., 0.};
    Point u = cross(n, helper);
    u = (1. / length(u)) * u;
    const Point v = cross(n, u);
    const double r = std::clamp(radius[i], 0.4 * median, 1.8 * median);
    const auto first_index = static_cast<std::uint32_t>(mesh.points.size());
    for(std::uint32_t k = 0; k < number_of_sides; ++k)
    {
      const double angle = 2. * 3.14159265358979 * k / number_of_sides;
      mesh.points.push_back(points[i] + (r * std::cos(angle)) * u + (r * std::sin(angle)) * v);
      mesh.normals.push_back(n);
      mesh.colors.push_back(colors[i]);
      if(k >= 2)
        mesh.corners.insert(mesh.corners.end(),
                            {first_index, first_index + k - 1, first_index + k});
    }
  }
  return mesh;
}

} // namespace program
