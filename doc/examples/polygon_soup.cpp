// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes distances on an open book with three pages, which is not a manifold: all pages meet at
// the spine. The polygons are quadrilaterals without a consistent orientation.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Each page has its own points, also on the spine, which is the z-axis.
  const std::size_t n = 10; // squares per side
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  for(const double angle : {0., 1., 2.})
  {
    const std::size_t first = points.size();
    for(std::size_t i = 0; i <= n; ++i)
      for(std::size_t j = 0; j <= n; ++j)
        points.emplace_back(i * std::cos(angle), i * std::sin(angle), j);
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t j = 0; j < n; ++j)
      {
        const std::size_t a = first + i * (n + 1) + j, b = a + n + 1;
        polygons.push_back({a, b, b + 1, a + 1});
        if((i + j) % 3 == 0)
          std::reverse(polygons.back().begin(), polygons.back().end());
      }
  }

  // Equal points are merged, so that the pages are connected.
  const auto domain = GP::make_domain(points, polygons, GP::parameters::merge_tolerance(0.));
  const GP::Soup_report& report = domain.report();
  std::cout << report.number_of_merged_points << " points were merged, "
            << report.number_of_reversed_triangles
            << " triangles were reversed, and the surface was "
            << "split at " << report.number_of_split_edges << " edges\n";

  // Vertex i of the mesh of the domain is point i.
  using Vertex = CGAL::Surface_mesh<Point>::Vertex_index;
  std::vector<double> distance(points.size());
  const std::size_t source = n * (n + 1); // (10, 0, 0), a corner of the first page
  GP::geodesic_distances(domain, Vertex(source), CGAL::make_property_map(distance));

  // The shortest path to the opposite corner of the last page is the diagonal of two pages. It
  // crosses the spine at a vertex.
  const double exact = std::hypot(2. * n, n);
  std::cout << "distance " << distance.back() << ", exact distance " << exact << '\n';
  return std::abs(distance.back() - exact) < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
