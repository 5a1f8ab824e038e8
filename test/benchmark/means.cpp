// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures Karcher means of random locations in a ball: the time, the iterations, the gradient and,
// on spheres and tori, the distance to the mean on the smooth surface. Uses one thread. --quick:
// surfaces with some thousand vertices.
#include "models.h"
#include "report.h"
#include "torus_geodesic.h"

#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace {

namespace GP = CGAL::Geodesic_processing;
using namespace benchmarks;
using GP::internal::dot;
using GP::internal::norm;
using GP::internal::unit;
using GP::internal::Vec3;
using GP::internal::operator*;
using GP::internal::operator+;
using GP::internal::operator-;
using GP::test::Torus;

constexpr double pi = GP::internal::pi;

Vec3 to_vec(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

std::string format_error(double error)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.1e", error);
  return text;
}

// Returns the mean of points of the unit sphere: a zero of the sum of their logarithms.
Vec3 spherical_mean(const std::vector<Vec3>& points)
{
  Vec3 mean = {0., 0., 0.};
  for(const Vec3& p : points)
    mean = mean + p;
  mean = unit(mean);
  for(int i = 0; i < 1000; ++i)
  {
    Vec3 step = {0., 0., 0.};
    for(const Vec3& p : points)
    {
      const Vec3 across = p - dot(p, mean) * mean;
      if(const double sine = norm(across); sine > 0.)
        step = step + std::atan2(sine, dot(p, mean)) / sine / double(points.size()) * across;
    }
    const double length = norm(step);
    if(length < 1e-15)
      break;
    mean = unit(std::cos(length) * mean + std::sin(length) / length * step);
  }
  return mean;
}

// Returns random locations in the faces whose vertices are closer to a vertex than a radius.
std::vector<GP::Location<Mesh>> random_locations(const GP::Mesh_domain<Mesh>& domain, Vertex center,
                                                 double radius, std::size_t number)
{
  const Mesh& mesh = domain.mesh();
  GP::Geodesic_distance_solver<Mesh, GP::Exact> solver(domain);
  solver.compute(center, GP::parameters::maximum_distance(radius));
  std::vector<Face> faces;
  for(const Face face : mesh.faces())
  {
    bool is_inside = true;
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
      is_inside = is_inside && solver.distance(v) <= radius;
    if(is_inside)
      faces.push_back(face);
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit_interval(0., 1.);
  std::vector<GP::Location<Mesh>> result;
  while(!faces.empty() && result.size() < number)
  {
    double a = unit_interval(random), b = unit_interval(random);
    if(a + b > 1.)
    {
      a = 1. - a;
      b = 1. - b;
    }
    result.emplace_back(faces[random() % faces.size()], std::array<double, 3>{1. - a - b, a, b});
  }
  return result;
}

// `radius` is a fraction of the largest distance from the center.
void add_mesh(Table& table, const std::string& name, const Mesh& mesh, double radius,
              std::size_t number, bool is_sphere)
{
  const auto domain = GP::make_domain(mesh);
  const Vertex center(mesh.number_of_vertices() / 3);
  GP::Geodesic_distance_solver<Mesh, GP::Exact> solver(domain);
  solver.compute(center);
  double farthest = 0.;
  for(const Vertex v : solver.reached())
    farthest = std::max(farthest, solver.distance(v));
  const auto locations = random_locations(domain, center, radius * farthest, number);
  GP::Karcher_mean<Mesh> mean;
  const double time = cpu_seconds([&] { mean = GP::karcher_mean(domain, locations); });
  std::string error = "-";
  if(is_sphere)
  {
    std::vector<Vec3> points;
    for(const auto& location : locations)
      points.push_back(unit(to_vec(domain.point(location))));
    error = format_error(norm(unit(to_vec(mean.point)) - spherical_mean(points)));
  }
  double barycenter_time = 0.;
  if(number <= 100)
    barycenter_time = cpu_seconds([&] { GP::geodesic_barycenter<GP::Exact>(domain, locations); });
  table.add({name, std::to_string(mesh.number_of_vertices()), std::to_string(number),
             format_fixed(radius * farthest, 2), format_fixed(time, 2),
             std::to_string(mean.number_of_iterations), mean.is_converged ? "yes" : "no",
             format_error(mean.gradient_norm / farthest), error,
             number <= 100 ? format_fixed(barycenter_time, 2) : "-"});
}

void print_meshes(bool is_quick)
{
  Table table("means on meshes",
              {"mesh", "vertices", "locations", "radius", "time [s]", "iterations", "converged",
               "gradient / extent", "error", "barycenter [s]"});
  for(const unsigned level : is_quick ? std::vector<unsigned>{4} : std::vector<unsigned>{4, 5, 6})
    for(const double radius : {0.1, 0.22, 0.45}) // the radius of uniqueness is 0.5
      for(const std::size_t number : {10u, 1000u})
        add_mesh(table, "sphere", icosphere(level), radius, number, true);
  std::vector<std::string> names = {"cow_2k9", "elephant_2k8"};
  if(!is_quick)
    names.insert(names.end(), {"kitten_9k", "bunny_37k", "armadillo_26k"});
  for(const std::string& name : names)
    if(const auto mesh = load_model(name))
      for(const double radius : {0.1, 0.3, 1.})
        add_mesh(table, name, *mesh, radius, 1000, false);
  table.print();
}

using Cloud = CGAL::Point_set_3<Kernel::Point_3>;

void add_surfel(Cloud& cloud, const Vec3& p, const Vec3& n)
{
  cloud.insert({p[0], p[1], p[2]}, {n[0], n[1], n[2]});
}

// Random points of the unit sphere.
Cloud random_sphere(std::size_t number)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Cloud cloud(true);
  while(cloud.size() < number)
  {
    const Vec3 p = unit({normal(random), normal(random), normal(random)});
    add_surfel(cloud, p, p);
  }
  return cloud;
}

Cloud random_torus(std::size_t number)
{
  const Torus torus;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit_interval(0., 1.);
  Cloud cloud(true);
  while(cloud.size() < number)
  {
    const double u = 2. * pi * unit_interval(random), v = 2. * pi * unit_interval(random);
    if(1.4 * unit_interval(random) <= 1. + 0.4 * std::cos(v))
      add_surfel(cloud, torus.point(u, v), Torus::normal(u, v));
  }
  return cloud;
}

void add_cloud(Table& table, const std::string& name, const Cloud& cloud,
               const std::vector<Vec3>& points, const Vec3& expected)
{
  const GP::Surface_locator<Cloud> locate(cloud);
  std::vector<GP::Location<Cloud>> locations;
  for(const Vec3& p : points)
    locations.push_back(locate(Kernel::Point_3(p[0], p[1], p[2])));
  GP::Karcher_mean<Cloud> mean;
  const double time = cpu_seconds([&] { mean = GP::karcher_mean(cloud, locations); });
  table.add({name, std::to_string(cloud.size()), std::to_string(points.size()),
             format_fixed(time, 2), std::to_string(mean.number_of_iterations),
             mean.is_converged ? "yes" : "no", format_error(mean.gradient_norm),
             format_error(norm(to_vec(mean.point) - expected))});
}

// On the torus, the logarithms of the points sum to zero.
void print_clouds(bool is_quick)
{
  Table table("means on clouds", {"cloud", "surfels", "locations", "time [s]", "iterations",
                                  "converged", "gradient", "error"});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit_interval(0., 1.);
  for(const std::size_t size :
      is_quick ? std::vector<std::size_t>{2500} : std::vector<std::size_t>{2500, 10000, 40000})
    for(const std::size_t number : {10u, 100u})
    {
      const Vec3 center = unit({0.3, 0.4, 0.8});
      std::vector<Vec3> on_sphere, on_torus;
      const auto [x, y] = GP::internal::tangent_frame(center);
      for(std::size_t i = 0; i < number; ++i)
      {
        const double angle = 2. * pi * unit_interval(random), distance = unit_interval(random);
        on_sphere.push_back(std::cos(distance) * center +
                            std::sin(distance) * (std::cos(angle) * x + std::sin(angle) * y));
        on_torus.push_back(Torus().geodesic(0.4, 0.9, 0.3 + 2. * pi * double(i) / double(number),
                                            i % 2 == 0 ? 0.2 : 0.5));
      }
      add_cloud(table, "random sphere", random_sphere(size), on_sphere, spherical_mean(on_sphere));
      add_cloud(table, "random torus", random_torus(size), on_torus, Torus().point(0.4, 0.9));
    }
  table.print();
}

} // namespace

int main(int argc, char* argv[])
{
  const bool is_quick = argc > 1 && std::string(argv[1]) == "--quick";
  print_meshes(is_quick);
  print_clouds(is_quick);
}
