// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the calls in the tables of the page "Migration" on a planar grid, where distances are known.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Point_2 = Kernel::Point_2;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Cloud = CGAL::Point_set_3<Point, Vector>;

namespace GP = CGAL::Geodesic_processing;

namespace {

constexpr int n = 20; // squares per side

bool is_correct = true;

// Compares a result with its exact value.  The default tolerance is far above round-off errors.
void expect_near(const char* name, double value, double exact, double tolerance = 1e-9)
{
  const bool is_near = std::abs(value - exact) <= tolerance;
  std::cout << name << ": " << value << (is_near ? "" : ", which is wrong") << '\n';
  is_correct = is_correct && is_near;
}

// The heat method is a smooth approximation, whose largest error on this grid is 2.6 %.
constexpr double heat_tolerance = 0.05 * n * 1.4142135623730951;

} // namespace

int main()
{
  Mesh mesh;
  CGAL::make_grid(
      n, n, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);
  const auto at = [](int i, int j) { return Vertex(i + j * (n + 1)); };
  const Vertex source = at(0, 0), target = at(n, n);
  const std::vector<Vertex> sources = {at(0, 0), at(n, 0)};
  const double diagonal = n * std::sqrt(2.);
  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;

  // One distance field.
  GP::geodesic_distances(mesh, source, distance);
  expect_near("exact distance", distance[target], diagonal);
  GP::geodesic_distances(mesh, sources, distance);
  expect_near("distance to two sources", distance[target], n);
  GP::geodesic_distances<GP::Heat>(mesh, source, distance);
  expect_near("distance by heat", distance[target], diagonal, heat_tolerance);
  GP::geodesic_distances<GP::Heat>(mesh, sources, distance);
  expect_near("distance by heat to two sources", distance[target], n, heat_tolerance);

  // Many distance fields with the same factorizations.
  GP::Geodesic_distance_solver<Mesh, GP::Heat> heat(mesh);
  heat.compute(source);
  heat.write_distances(distance);
  expect_near("distance by a solver with heat", distance[target], diagonal, heat_tolerance);
  heat.compute(sources);
  expect_near("distance of a vertex", heat.distance(target), n, heat_tolerance);

  // Exact distances and shortest paths.
  GP::Geodesic_distance_solver<Mesh> solver(mesh);
  const Point point(n - 0.5, n - 0.25, 1.);
  const GP::Location<Mesh> location = GP::locate_on_surface(mesh, point);
  solver.compute(source);
  expect_near("from a vertex", solver.distance(target), diagonal);
  solver.compute(location);
  expect_near("from a location", solver.distance(source), std::hypot(n - 0.5, n - 0.25));
  solver.compute(sources);
  expect_near("of a location", solver.distance(location), std::hypot(0.5, n - 0.25));
  expect_near("closest source", double(solver.source_label(target)), 1.);
  const std::vector<Point> points = solver.path(location).points;
  expect_near("end of the path", CGAL::squared_distance(points.back(), Point(n, 0., 0.)), 0.);
  const std::vector<GP::Location<Mesh>> locations = solver.path(location).locations;
  expect_near("size of the path", double(locations.size()), double(points.size()));
  solver.compute(sources, GP::parameters::maximum_distance(3.));
  expect_near("is reached", std::isinf(solver.distance(target)), 1.);
  solver.compute(source, GP::parameters::targets(target));
  expect_near("distance of a target", solver.distance(target), diagonal);
  const GP::Surface_path<Mesh> path = GP::geodesic_path(mesh, source, target);
  expect_near("shortest path", path.length, diagonal);

  // Curves.
  GP::Geodesic_path_finder<Mesh> finder(mesh);
  const auto locally_shortest = finder.locally_shortest_path(source, target);
  expect_near("locally shortest path", locally_shortest.length, diagonal);
  const std::vector<Vertex> corners = {at(0, 0), at(n, 0), at(n, n)};
  const auto polyline = GP::geodesic_polyline(mesh, corners);
  expect_near("path through vertices", polyline.length, 2. * n);
  const auto loop = GP::shorten_loop(mesh, corners);
  expect_near("loop in a disk", loop.is_point(), 1.);
  const auto bezier = GP::geodesic_bezier_curve(mesh, corners);
  // The length of the planar curve with these control points.  The subdivision is a polyline, whose
  // length differs by 0.003 %.
  const double parabola = n * (1. + std::asinh(1.) / std::sqrt(2.));
  expect_near("Bezier curve", bezier.length, parabola, 1e-3 * parabola);
  const Vector direction(3., 4., 0.);
  const auto straightest = GP::straightest_geodesic(mesh, source, direction, 5.);
  expect_near("straightest geodesic",
              CGAL::squared_distance(straightest.points.back(), Point(3., 4., 0.)), 0.);
  GP::geodesic_distances(mesh, source, distance);
  const std::vector<double> isovalues = {5., 10.};
  std::vector<GP::Isoline<Mesh>> lines;
  GP::isolines(mesh, distance, isovalues, std::back_inserter(lines));
  expect_near("number of isolines", double(lines.size()), 2.);

  // Maps, means, cells and curvatures.
  auto uv = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
  GP::logarithmic_map(mesh, source, uv);
  // Gradients of the default method have an error of less than 1 % on the grid.
  expect_near("logarithmic map", std::sqrt(CGAL::squared_distance(uv[target], Point_2(0., 0.))),
              diagonal, 0.01 * diagonal);
  const auto mean = GP::karcher_mean(mesh, sources);
  expect_near("Karcher mean", CGAL::squared_distance(mean.point, Point(n / 2., 0., 0.)), 0.);
  auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  const std::size_t number_of_cells = GP::geodesic_centroidal_tessellation(mesh, 10, patch);
  expect_near("number of cells", double(number_of_cells), 10.);
  auto cell = mesh.add_property_map<Vertex, std::size_t>("v:cell").first;
  GP::geodesic_voronoi_diagram(mesh, sources, cell);
  expect_near("Voronoi cell", double(cell[target]), 1.);
  auto curvature = mesh.add_property_map<Vertex, GP::Principal_curvatures<Mesh>>("v:k").first;
  GP::principal_curvatures(mesh, curvature);
  expect_near("curvature", curvature[at(n / 2, n / 2)].max_curvature, 0.);

  // Arrays of points and triangles.
  std::vector<Point> V;
  std::vector<std::array<std::size_t, 3>> F;
  for(Vertex v : mesh.vertices())
    V.push_back(mesh.point(v));
  for(Mesh::Face_index f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    F.push_back({mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
  const auto domain = GP::make_domain(V, F);
  std::vector<double> D(V.size());
  GP::geodesic_distances(domain, source, CGAL::make_property_map(D));
  expect_near("distance in a vector", D[target], diagonal);

  // A cloud.  The front has second order; its error on this grid is below 1 %.
  Cloud cloud(true);
  for(const Point& p : V)
    cloud.insert(p, Vector(0., 0., 1.));
  auto cloud_distance = cloud.add_property_map<double>("distance").first;
  const Cloud::Index surfel(0);
  GP::geodesic_distances(cloud, surfel, cloud_distance);
  expect_near("distance on a cloud", cloud_distance[target.idx()], diagonal, 0.01 * diagonal);

  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
