// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes the streamlines of an optimal flow and a fuzzy geodesic on a bent sheet.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Creates three quarters of a cylinder, which unrolls to a rectangle of size 4.7 by 2.
  const double pi = std::acos(-1.);
  const int n = 40;
  Mesh sheet;
  CGAL::make_grid(
      2 * n, n, sheet,
      [&](int i, int j)
      {
        const double angle = 1.5 * pi * i / (2 * n);
        return Point(std::cos(angle), std::sin(angle), 2. * j / n);
      },
      true);

  // Transports a Gaussian density at p to a wider one at q.
  const Vertex p(Mesh::size_type(10 * (2 * n + 1) + 10)), q(Mesh::size_type(30 * (2 * n + 1) + 65));
  const auto gaussian_mass = [&](Vertex middle, double width)
  {
    const auto density = [&sheet, middle, width](Vertex v)
    {
      return std::exp(-0.5 * CGAL::squared_distance(sheet.point(v), sheet.point(middle)) /
                      (width * width));
    };
    return GP::mass_density(boost::make_function_property_map<Vertex>(density));
  };
  GP::Earth_movers_solver<Mesh> solver(sheet);
  const GP::Earth_movers_cost cost = solver.compute(gaussian_mass(p, 0.15), gaussian_mass(q, 0.3),
                                                    GP::parameters::do_normalize(true));

  // Traces 200 streamlines. They are straight on the unrolled sheet.
  std::vector<GP::Streamline<Mesh>> lines;
  solver.streamlines()(200, std::back_inserter(lines));
  double mean_length = 0.;
  for(const auto& line : lines)
    mean_length += line.length / double(lines.size());
  std::cout << "A grain goes " << mean_length << " in the mean; the least is " << cost.value
            << ".\n";

  // Computes the likelihood of each vertex to be on a shortest path between neighborhoods of p and
  // q.
  auto likelihood = sheet.add_property_map<Vertex, double>("v:likelihood").first;
  GP::fuzzy_geodesic(sheet, p, q, likelihood, GP::parameters::width(0.15));
  const Vertex between(Mesh::size_type(20 * (2 * n + 1) + 38)), outside(Mesh::size_type(38));
  std::cout << "The likelihood is " << likelihood[between] << " between them, and "
            << likelihood[outside] << " beside.\n";
  return std::abs(mean_length - cost.value) < 0.02 * cost.value && likelihood[between] > 0.5 &&
                 likelihood[outside] < 0.05
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
