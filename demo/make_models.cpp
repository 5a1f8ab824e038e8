// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What can be shown where no real models are to be had?
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;

// A tube along a curve that winds around a torus, closed in both directions.
Mesh tube(int length, int girth)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertex;
  for(int i = 0; i < length; ++i)
    for(int j = 0; j < girth; ++j)
    {
      const double t = 2. * CGAL_PI * i / length, a = 2. * CGAL_PI * j / girth;
      const double r = 0.42 + 0.05 * std::sin(9. * t);
      const double ring = 2. + std::cos(3. * t) + r * std::cos(a);
      vertex.push_back(mesh.add_vertex(Point(ring * std::cos(2. * t), ring * std::sin(2. * t),
                                             std::sin(3. * t) + r * std::sin(a))));
    }
  const auto at = [&](int i, int j) { return vertex[(i % length) * girth + j % girth]; };
  for(int i = 0; i < length; ++i)
    for(int j = 0; j < girth; ++j)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

int main(int argc, char* argv[])
{
  const std::string folder = argc > 1 ? argv[1] : ".";
  Mesh hills;
  const auto height = [](double x, double y)
  { return 9. * std::sin(x / 9.) * std::cos(y / 13.) + 3. * std::sin((x + 2. * y) / 7.); };
  CGAL::make_grid(
      120, 120, hills, [&](int i, int j) { return Point(i, j, height(i, j)); }, true);

  std::ofstream cloud(folder + "/scan.xyz"), noisy(folder + "/noisy.xyz");
  const Mesh knot = tube(600, 40);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0., 0.02); // a third of the distance between points
  for(Mesh::Vertex_index v : knot.vertices())
  {
    cloud << knot.point(v) << '\n';
    noisy << knot.point(v) + Vector(noise(random), noise(random), noise(random)) << '\n';
  }
  // A sphere, and a pipe with noise, one in twenty of its points four times as much.
  std::ofstream sphere(folder + "/sphere.xyz"), pipe(folder + "/pipe.xyz");
  for(int i = 0; i < 10000; ++i)
  {
    const double z = 1. - (2. * i + 1.) / 10000., r = std::sqrt(1. - z * z);
    const double a = i * CGAL_PI * (3. - std::sqrt(5.));
    sphere << Point(r * std::cos(a), r * std::sin(a), z) << '\n';
  }
  std::uniform_real_distribution<double> offset(-0.5, 0.5);
  for(int i = 0; i < 201 * 60; ++i)
  {
    const double a = 2. * CGAL_PI * (i % 201) / 201., z = 30. * (i / 201) / 59.;
    const double r = 15. + (i % 20 == 0 ? 4. : 1.) * offset(random);
    pipe << Point(r * std::cos(a), r * std::sin(a), z) << '\n';
  }

  const bool written = CGAL::IO::write_polygon_mesh(folder + "/knot.off", knot) &&
                       CGAL::IO::write_polygon_mesh(folder + "/hills.off", hills) && cloud &&
                       noisy && sphere && pipe;
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
