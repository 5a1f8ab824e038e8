// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the errors of geodesics on clean and noisy point set surfaces, compared with the tables
// of Ruggeri, Darom, Saupe and Kiryati 2006.
#include "clouds.h"
#include "report.h"
#include "surfel_paths.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace benchmarks;
using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

constexpr std::size_t number_of_pairs = 100;
constexpr double cylinder_radius = 15., cylinder_height = 30.;

std::string percent(double value) { return format_significant(100. * value); }

struct Method
{
  std::string name;
  Cloud_path_options options;
};

Cloud_path_options with_method(Surfel_path_method method, Surfel_noise noise,
                               bool do_enforce_guarantees = true)
{
  Cloud_path_options options;
  options.method = method;
  options.noise = noise;
  options.do_enforce_guarantees = do_enforce_guarantees;
  return options;
}

// The paper's energy and the method of Hofer and Pottmann on the surfels as they are, the paper's
// energy on denoised surfels, and the default.
const std::vector<Method>& methods()
{
  static const std::vector<Method> result = {
      {"disks", with_method(Surfel_path_method::disks, Surfel_noise::kept, false)},
      {"planes", with_method(Surfel_path_method::projected_planes, Surfel_noise::kept, false)},
      {"denoised disks", with_method(Surfel_path_method::disks, Surfel_noise::removed_when_found)},
      {"default", {}}};
  return result;
}

// Errors in percent that the paper lists; NaN if it lists none.
struct Published_errors
{
  double length = std::nan(""), path = std::nan("");
};

// A table of the errors of all methods. If it compares with the paper, the columns of the published
// numbers come first: "paper" is the authors' method, "HP" their implementation of Hofer and
// Pottmann's.
class Error_table
{
public:
  Error_table(const std::string& title, bool has_published_errors)
      : m_has_published_errors(has_published_errors), m_table(title, header(has_published_errors)),
        m_longer(title + ": paths longer than initial", names())
  {}

  void add(const Surface& surface, const std::string& name, const Cloud& cloud,
           const Published_errors& paper = {}, const Published_errors& hp = {})
  {
    std::vector<std::string> row = {name, std::to_string(cloud.size())}, longer = {name};
    if(m_has_published_errors)
      for(const Published_errors& published : {paper, hp})
      {
        row.push_back(format_significant(published.length));
        row.push_back(format_significant(published.path));
      }
    double polyline = 0., control_points = 0.; // of the default, which is last
    for(const Method& method : methods())
    {
      const Errors e = errors(surface, cloud, method.options, number_of_pairs);
      row.push_back(percent(e.length));
      row.push_back(percent(e.path));
      longer.push_back(std::to_string(e.number_of_longer_paths));
      polyline = e.polyline;
      control_points = e.control_points;
    }
    row.push_back(percent(polyline));
    row.push_back(format_fixed(control_points, 0));
    m_table.add(row);
    m_longer.add(longer);
  }
  void print() const
  {
    m_table.print();
    m_longer.print();
  }

private:
  static std::vector<std::string> names()
  {
    std::vector<std::string> result = {"surface"};
    for(const Method& method : methods())
      result.push_back(method.name);
    return result;
  }
  static std::vector<std::string> header(bool has_published_errors)
  {
    std::vector<std::string> result = {"surface", "surfels"};
    const auto add = [&](const std::string& name)
    {
      result.push_back("EG " + name);
      result.push_back("EP " + name);
    };
    if(has_published_errors)
    {
      add("paper");
      add("HP, paper");
    }
    for(const Method& method : methods())
      add(method.name);
    result.push_back("EG polyline");
    result.push_back("control points");
    return result;
  }

  bool m_has_published_errors;
  Table m_table, m_longer;
};

std::vector<Surface> exactly_fitted_surfaces()
{
  const Cloud sphere = octahedron_sphere(7), plane = square_cloud(100),
              cylinder = cylinder_cloud(201, 60, cylinder_radius, cylinder_height);
  return {{"sphere", sphere, great_circles(sphere)},
          {"plane", plane, straight_segments(plane)},
          {"cylinder", cylinder, helices(cylinder, cylinder_radius)}};
}

void print_clean(const std::vector<Surface>& surfaces)
{
  std::printf("Table 3, clean clouds: relative errors in percent\n");
  Error_table table("clean clouds, %", true);
  const Published_errors paper[] = {{8.0e-2, 3.5e-2}, {2.1e-5, 1.1e-4}, {4.5e-2, 5.1e-3}},
                         hp[] = {{4.0e-2, 1.0e-2}, {2.7e-5, 2.7e-7}, {4.6e-1, 9.0e-2}};
  for(std::size_t i = 0; i < surfaces.size(); ++i)
    table.add(surfaces[i], surfaces[i].name, surfaces[i].clean, paper[i], hp[i]);
  table.print();
}

void print_spheres()
{
  std::printf("Table 4, unit spheres subdivided from the octahedron: relative errors in percent\n");
  Error_table table("spheres, %", true);
  const Published_errors paper[] = {
      {6.20, 2.162}, {2.95, 0.885}, {1.02, 0.275}, {0.34, 0.074}, {0.08, 0.035}};
  for(unsigned i = 0; i < 5; ++i)
  {
    const Cloud cloud = octahedron_sphere(3 + i);
    const Surface sphere = {"level " + std::to_string(3 + i), cloud, great_circles(cloud)};
    table.add(sphere, sphere.name, cloud, paper[i]);
  }
  table.print();
}

std::vector<double> radii(const Cloud& cloud)
{
  const Surfel_cloud c = make_cloud(cloud.points, cloud.normals);
  std::vector<double> result;
  for(const Index v : c.internal_vertex)
    result.push_back(c.frame.scale * c.radius[v]);
  return result;
}

void print_noisy(const std::vector<Surface>& surfaces)
{
  std::printf(
      "Table 5, noise in percent of the surfel radius: relative errors in percent. \"+5 %%\": 5 %% "
      "of outliers\nwith a noise of 200 %% are added. The scanned plane is simulated here\n");
  Error_table table("noisy clouds, %", true);
  const Published_errors paper[] = {{0.49, 0.25}, {0.019, 0.097}, {0.69, 0.46},
                                    {0.88, 0.31}, {0.023, 0.11},  {1.04, 0.71}},
                         hp[] = {{8.50, 0.10},  {0.12, 0.24}, {2.50, 0.94},
                                 {22.20, 0.15}, {0.49, 0.8},  {16.38, 3.70}};
  for(int level = 1; level <= 2; ++level)
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Surface& s = surfaces[i];
      const std::vector<double> r = radii(s.clean);
      const Cloud noisy = with_noise(s.clean, r, 0.5 * level, 7);
      const std::size_t row = 3 * std::size_t(level - 1) + i;
      const std::string name = s.name + " " + std::to_string(50 * level) + " %";
      table.add(s, name, noisy, paper[row], hp[row]);
      table.add(s, name + " +5 %", with_outliers(noisy, s.clean, r, 0.05, 2., 8));
    }
  const Cloud scanned = scanned_square(94, 70, 3), exact = scanned_square(94, 70, 0);
  table.add({"scan", exact, straight_segments(exact)}, "simulated scan", scanned, {0.15, 0.25},
            {0.40, 0.33});
  table.print();
}

// With fewer control points, a path follows less of the noise. The authors used about 69 on the noisy
// sphere, 37 on the cylinder and 21 on the plane.
void print_control_points(const std::vector<Surface>& surfaces)
{
  std::printf("Energy of the paper by the number of control points, noise kept\n");
  constexpr std::size_t numbers_of_control_points[] = {9, 21, 37, 75};
  std::vector<std::string> header = {"surface"};
  for(const std::size_t number : numbers_of_control_points)
  {
    header.push_back("EG " + std::to_string(number));
    header.push_back("EP " + std::to_string(number));
  }
  Table table("control points, %", header);
  for(const Surface& s : surfaces)
    for(int level = 0; level <= 2; ++level)
    {
      const Cloud cloud =
          level == 0 ? s.clean : with_noise(s.clean, radii(s.clean), 0.5 * level, 7);
      std::vector<std::string> row = {s.name + " " + std::to_string(50 * level) + " %"};
      for(const std::size_t number : numbers_of_control_points)
      {
        Cloud_path_options options =
            with_method(Surfel_path_method::disks, Surfel_noise::kept, false);
        options.path.number_of_control_points = number;
        const Errors e = errors(s, cloud, options, number_of_pairs);
        row.push_back(percent(e.length));
        row.push_back(percent(e.path));
      }
      table.add(row);
    }
  table.print();
}

void print_weights(const std::vector<Surface>& surfaces)
{
  std::printf("Plain and robust weights, without prior removal of noise and outliers\n");
  Table table("robust weights", {"surface", "surfels", "EG spheres", "EP spheres",
                                 "EG robust spheres", "EP robust spheres"});
  const auto add = [&](const Surface& s, const std::string& name, const Cloud& cloud)
  {
    std::vector<std::string> row = {name, std::to_string(cloud.size())};
    for(const auto method : {Surfel_path_method::spheres, Surfel_path_method::robust_spheres})
    {
      const Errors e = errors(s, cloud, with_method(method, Surfel_noise::kept), number_of_pairs);
      row.push_back(percent(e.length));
      row.push_back(percent(e.path));
    }
    table.add(row);
  };
  for(const Surface& s : surfaces)
  {
    const std::vector<double> r = radii(s.clean);
    for(const int level : {0, 2, 10})
    {
      const Cloud cloud = level == 0 ? s.clean : with_noise(s.clean, r, 0.01 * level, 7);
      const std::string name = s.name + " " + std::to_string(level) + " %";
      add(s, name, cloud);
      add(s, name + " +5 %", with_outliers(cloud, s.clean, r, 0.05, 2., 8));
    }
  }
  table.print();
}

double torus(const Vec3& p, Vec3& gradient)
{
  const double ring = std::hypot(p[0], p[1]), out = std::hypot(ring - 1., p[2]);
  const double along = (ring - 1.) / (out * ring);
  gradient = {along * p[0], along * p[1], p[2] / out};
  return out - 0.4;
}

constexpr Vec3 axes = {1., 0.7, 0.5};

double ellipsoid(const Vec3& p, Vec3& gradient)
{
  double value = -1.;
  for(int k = 0; k < 3; ++k)
  {
    value += p[k] * p[k] / (axes[k] * axes[k]);
    gradient[k] = 2. * p[k] / (axes[k] * axes[k]);
  }
  return value;
}

// Measures errors on surfaces that none of the fits represents exactly.
void print_other_surfaces()
{
  std::printf("Surfaces that no fit represents exactly: relative errors in percent, with noise and "
              "outliers as in table 5\n");
  std::vector<Surface> surfaces = {
      implicit_surface("torus", torus_cloud(16000, 0.4), torus),
      implicit_surface("ellipsoid", ellipsoid_cloud(16000, axes), ellipsoid)};
  if(const auto scan = sampled_mesh("bunny_zipper_36k", 40000, 1))
    surfaces.push_back(*scan);
  Error_table table("other surfaces, %", false);
  for(const Surface& s : surfaces)
  {
    const std::vector<double> r = radii(s.clean);
    for(const int level : {0, 50, 100})
    {
      const Cloud cloud = level == 0 ? s.clean : with_noise(s.clean, r, 0.01 * level, 7);
      table.add(s, s.name + " " + std::to_string(level) + " %", cloud);
    }
    table.add(s, s.name + " 100 % +5 %",
              with_outliers(with_noise(s.clean, r, 1., 7), s.clean, r, 0.05, 2., 8));
  }
  table.print();
}

// Measures the convergence order of lengths. The reference is the geodesic on the implicit surface,
// obtained by shortening the path with a thousand control points.
void print_orders()
{
  std::printf(
      "Convergence on surfaces that algebraic spheres do not represent exactly: EG in percent, "
      "relative to\ngeodesics of the implicit surface\n");
  Table table("order of convergence", {"surface", "surfels", "EG", "reduction factor"});
  const auto add =
      [&](const std::string& name, const Implicit_surface& surface, const auto& make_points)
  {
    double before = std::nan("");
    for(std::size_t n = 1000; n <= 64000; n *= 4)
    {
      const Cloud cloud = make_points(n);
      Path_source paths(cloud, {});
      double sum = 0.;
      for(const auto& [a, b] : random_pairs(cloud, number_of_pairs))
      {
        const Cloud_path found = paths.find(a, b);
        Curve curve = paths.curve(found.path);
        curve.front() = cloud.points[a];
        curve.back() = cloud.points[b];
        const double truth = shorten_on(surface, curve, 1000).length;
        sum += std::pow(paths.length(found.path) / truth - 1., 2);
      }
      const double error = std::sqrt(sum / double(number_of_pairs));
      table.add(
          {name, std::to_string(cloud.size()), percent(error), format_fixed(before / error, 1)});
      before = error;
    }
  };
  add("torus", Implicit_surface(torus), [](std::size_t n) { return torus_cloud(n, 0.4); });
  add("ellipsoid", Implicit_surface(ellipsoid),
      [](std::size_t n) { return ellipsoid_cloud(n, axes); });
  table.print();
  std::printf("Target: a factor of 4 with 4 times as many surfels.\n\n");
}

// Measures the time of 100 paths on prepared clouds, on one core. The paper's model of 134,345
// surfels is replaced by an ellipsoid.
void print_path_times(const std::vector<Surface>& surfaces)
{
  std::printf("Table 2, seconds for 100 paths (in the paper: Pentium 4, 2.8 GHz)\n");
  std::vector<std::string> header = {"surface", "surfels", "paper, points", "paper", "HP, paper"};
  for(const Method& method : methods())
    header.push_back(method.name);
  header.insert(header.end(), {"points", "set-up"});
  Table table("table 2 of the paper, seconds", header);
  const auto add = [&](const std::string& name, const Cloud& clean, const Cloud& cloud,
                       double paper_points, double paper, double hp)
  {
    std::vector<std::string> row = {name, std::to_string(cloud.size()),
                                    format_fixed(paper_points, 2), format_fixed(paper, 2),
                                    format_fixed(hp, 2)};
    const auto ends = random_pairs(clean, number_of_pairs);
    double points = 0., preparation = 0.; // of the default, which is last
    for(const Method& method : methods())
    {
      std::unique_ptr<Path_source> paths;
      preparation =
          cpu_seconds([&] { paths = std::make_unique<Path_source>(cloud, method.options); });
      points = 0.;
      row.push_back(format_fixed(cpu_seconds(
                                     [&]
                                     {
                                       for(const auto& [a, b] : ends)
                                         points += double(
                                             paths->find(a, b).path.number_of_control_points);
                                     }),
                                 2));
    }
    row.push_back(format_fixed(points / double(number_of_pairs), 0));
    row.push_back(format_fixed(preparation, 2));
    table.add(row);
  };
  const Cloud model = ellipsoid_cloud(134345, axes);
  add("ellipsoid", model, model, 74.55, 19.37, 5.68);
  const double published[][3] = {{68.55, 3.44, 1.83}, {20.58, 0.68, 1.21}, {37.04, 7.11, 2.05}};
  for(std::size_t i = 0; i < 3; ++i)
    add(surfaces[i].name + " 50 %", surfaces[i].clean,
        with_noise(surfaces[i].clean, radii(surfaces[i].clean), 0.5, 7), published[i][0],
        published[i][1], published[i][2]);
  const Cloud scanned = scanned_square(94, 70, 3);
  add("simulated scan", scanned, scanned, 30.81, 0.69, 0.57);
  table.print();
  std::printf("Target: 1 s on the ellipsoid.\n\n");
}

// Measures times on ellipsoids with the numbers of surfels of the paper's models.
void print_times(bool is_quick)
{
  std::printf(
      "Table 1, seconds on ellipsoids with equal numbers of surfels (in the paper: Pentium 4, "
      "2.8 GHz)\n");
  Table table("table 1 of the paper, seconds",
              {"surfels", "paper, graph", "graph, 2 threads", "processor", "set-up", "100 paths",
               "control points", "us per point", "initial paths", "by A*", "length excess"});
  const std::pair<std::size_t, double> models[] = {
      {35948, 3.50},  {52809, 3.90},   {101685, 4.73},   {134345, 6.08},
      {183408, 7.16}, {546137, 33.07}, {1060220, 46.75}, {1279519, 56.39}};
  for(const auto& [n, paper] : models)
  {
    if(is_quick && n > 200000)
      continue;
    const Cloud cloud = ellipsoid_cloud(n, axes);
    Surfel_cloud_options options;
    options.number_of_threads = 2;
    double processor = 0.;
    const double graph = wall_seconds(
        [&] {
          processor = cpu_seconds([&] { make_cloud(cloud.points, cloud.normals, {}, options); });
        });
    std::shared_ptr<const Fitted_cloud> fitted_cloud;
    const double preparation = cpu_seconds(
        [&]
        {
          fitted_cloud = std::make_shared<const Fitted_cloud>(
              cloud.points, cloud.normals, std::vector<double>(), Cloud_path_options());
        });
    Cloud_path_finder finder(fitted_cloud);
    const Surfel_cloud& c = fitted_cloud->cloud();
    const auto ends = random_pairs(cloud, number_of_pairs);
    double points = 0.;
    const double paths = cpu_seconds(
        [&]
        {
          for(const auto& [a, b] : ends)
            points +=
                double(finder({c.internal_vertex[a], {0., 0.}}, {c.internal_vertex[b], {0., 0.}})
                           .path.number_of_control_points);
        });
    Graph_search search(c.graph, c.point, finder.fitted_cloud()->regions());
    const auto chains = [&](Surfel_search method, double& length)
    {
      return cpu_seconds(
          [&]
          {
            for(const auto& [a, b] : ends)
            {
              const auto chain = search(c.internal_vertex[a], c.internal_vertex[b], method);
              for(std::size_t i = 0; i + 1 < chain.size(); ++i)
                length += norm(c.point[chain[i + 1]] - c.point[chain[i]]);
            }
          });
    };
    double length = 0., shortest = 0.;
    const double coarse_to_fine = chains(Surfel_search::coarse_to_fine, length),
                 a_star = chains(Surfel_search::a_star, shortest);
    table.add({std::to_string(n), format_fixed(paper, 2), format_fixed(graph, 2),
               format_fixed(processor, 2), format_fixed(preparation, 2), format_fixed(paths, 2),
               format_fixed(points / double(number_of_pairs), 0),
               format_fixed(1e6 * paths / points, 1), format_fixed(coarse_to_fine, 2),
               format_fixed(a_star, 2), percent(length / shortest - 1.) + " %"});
  }
  table.print();
  std::printf("Targets: 1.5 s for the graph of a million surfels; 100 paths no slower than with a "
              "hundred thousand.\n\n");
}

} // namespace

int main(int argc, char* argv[])
{
  const std::string argument = argc > 1 ? argv[1] : "";
  const std::vector<Surface> surfaces = exactly_fitted_surfaces();
  const bool is_complete = argument.empty() || argument == "--quick";
  if(is_complete || argument == "--clean")
  {
    print_clean(surfaces);
    print_spheres();
  }
  if(is_complete || argument == "--noisy")
    print_noisy(surfaces);
  if(is_complete || argument == "--control-points")
    print_control_points(surfaces);
  if(is_complete || argument == "--weights")
    print_weights(surfaces);
  if(is_complete || argument == "--other-surfaces")
    print_other_surfaces();
  if(is_complete || argument == "--orders")
    print_orders();
  if(is_complete || argument == "--times")
  {
    print_path_times(surfaces);
    print_times(argument == "--quick");
  }
}
