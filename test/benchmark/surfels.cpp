// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the errors of geodesics on clean and noisy point set surfaces, compared with the tables
// of Ruggeri, Darom, Saupe and Kiryati 2006.
#include <CGAL/Geodesic_processing/internal/paths/Cloud_path_finder.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_estimation.h>

#include "clouds.h"
#include "report.h"

#include <CGAL/IO/read_points.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <random>

namespace {

using namespace benchmarks;
using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

constexpr unsigned number_of_pairs = 100;

using Curve = std::vector<Vec3>;
struct Geodesic
{
  Curve curve;
  double length;
};

// Returns the geodesics between two points of a surface, shortest first. On the cylinder there are
// two, one in each direction.
using Geodesics = std::function<std::vector<Geodesic>(const Vec3&, const Vec3&)>;

constexpr int curve_resolution = 2000; // segments of a reference curve

std::vector<Geodesic> straight_segment(const Vec3& p, const Vec3& q)
{
  Curve curve;
  for(int i = 0; i <= curve_resolution; ++i)
    curve.push_back(p + double(i) / curve_resolution * (q - p));
  return {{curve, norm(q - p)}};
}

std::vector<Geodesic> great_circle(const Vec3& p, const Vec3& q)
{
  const double angle = 2. * std::asin(std::min(1., norm(q - p) / 2.));
  const Vec3 across = unit(q - dot(p, q) * p);
  Curve curve;
  for(int i = 0; i <= curve_resolution; ++i)
    curve.push_back(std::cos(angle * i / curve_resolution) * p +
                    std::sin(angle * i / curve_resolution) * across);
  return {{curve, angle}};
}

constexpr double cylinder_radius = 15., cylinder_height = 30.;

std::vector<Geodesic> helices(const Vec3& p, const Vec3& q)
{
  const double begin = std::atan2(p[1], p[0]);
  const double turn = std::remainder(std::atan2(q[1], q[0]) - begin, 2. * pi);
  std::vector<Geodesic> result;
  for(const double angle : {turn, turn - std::copysign(2. * pi, turn)})
  {
    Curve curve;
    for(int i = 0; i <= curve_resolution; ++i)
    {
      const double t = double(i) / curve_resolution, a = begin + t * angle;
      curve.push_back(
          {cylinder_radius * std::cos(a), cylinder_radius * std::sin(a), p[2] + t * (q[2] - p[2])});
    }
    result.push_back({curve, std::hypot(cylinder_radius * angle, q[2] - p[2])});
  }
  return result;
}

// Returns the root mean squared distance of the vertices of `points` to the polyline.
double rms_distance(const Curve& points, const Curve& polyline)
{
  double sum = 0.;
  for(const Vec3& p : points)
  {
    double min_squared_distance = infinity;
    for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
    {
      const Vec3 segment = polyline[i + 1] - polyline[i], offset = p - polyline[i];
      const double square = dot(segment, segment);
      const double t = square > 0. ? std::clamp(dot(offset, segment) / square, 0., 1.) : 0.;
      const Vec3 rest = offset - t * segment;
      min_squared_distance = std::min(min_squared_distance, dot(rest, rest));
    }
    sum += min_squared_distance;
  }
  return std::sqrt(sum / double(points.size()));
}

// Relative length and path errors, root mean squares over the pairs. `control_points` is a mean.
struct Errors
{
  double length = 0., path = 0., control_points = 0.;
};

struct Surface
{
  std::string name;
  Cloud clean;
  Geodesics geodesics;
};

// Returns random pairs of surfels. Pairs closer than a twentieth of the bounding box diagonal are
// drawn again. Their relative errors measure the noise of two surfels rather than the path.
std::vector<std::pair<Index, Index>> random_pairs(const Cloud& cloud)
{
  Vec3 low = cloud.points[0], high = low;
  for(const Vec3& p : cloud.points)
    for(int k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  std::mt19937 random(1);
  std::vector<std::pair<Index, Index>> result;
  while(result.size() < number_of_pairs)
  {
    const Index a = Index(random() % cloud.size()), b = Index(random() % cloud.size());
    if(norm(cloud.points[a] - cloud.points[b]) > 0.05 * norm(high - low))
      result.emplace_back(a, b);
  }
  return result;
}

Errors errors(const Surface& surface, const Cloud& cloud, const Cloud_path_options& options)
{
  const auto fitted_cloud = std::make_shared<const Fitted_cloud>(cloud.points, cloud.normals,
                                                                 std::vector<double>(), options);
  Cloud_path_finder finder(fitted_cloud);
  const Surfel_cloud& c = fitted_cloud->cloud();
  Errors sum;
  for(const auto& [a, b] : random_pairs(surface.clean))
  {
    const Cloud_path found =
        finder({c.internal_vertex[a], {0., 0.}}, {c.internal_vertex[b], {0., 0.}});
    Curve path;
    for(const Projection& projection : found.path.points)
      path.push_back(c.frame.origin + c.frame.scale * projection.point);
    const auto truths = surface.geodesics(surface.clean.points[a], surface.clean.points[b]);
    const double truth = truths.front().length;
    const double e = c.frame.scale * found.path.length / truth - 1.;
    // If another geodesic is at most 2 % longer, the path may follow it.
    double d = infinity;
    for(const auto& [curve, length] : truths)
      if(length <= (1. + 0.02) * truth)
        d = std::min(d, std::max(rms_distance(path, curve), rms_distance(curve, path)) / truth);
    sum.length += e * e;
    sum.path += d * d;
    sum.control_points += double(found.path.number_of_control_points);
  }
  return {std::sqrt(sum.length / number_of_pairs), std::sqrt(sum.path / number_of_pairs),
          sum.control_points / number_of_pairs};
}

std::string percent(double value) { return format_significant(100. * value); }

struct Published_errors
{
  double length, path;
};

void add_row(Table& table, const std::string& name, std::size_t surfels,
             const Published_errors& paper, const Published_errors& hp, const Errors& disks,
             const Errors& ours)
{
  table.add({name, std::to_string(surfels), format_significant(paper.length),
             format_significant(paper.path), format_significant(hp.length),
             format_significant(hp.path), percent(disks.length), percent(disks.path),
             percent(ours.length), percent(ours.path), format_fixed(ours.control_points, 0)});
}

std::vector<std::string> table_header()
{
  return {"surface",  "surfels", "EG paper", "EP", "EG HP",         "EP",
          "EG disks", "EP",      "EG ours",  "EP", "control points"};
}

Cloud_path_options with_method(Surfel_path_method method)
{
  Cloud_path_options options;
  options.method = method;
  return options;
}

void print_clean(std::vector<Surface>& surfaces)
{
  std::printf("Table 3, clean clouds: relative errors in percent\n");
  Table table(table_header());
  const Published_errors paper[] = {{8.0e-2, 3.5e-2}, {2.1e-5, 1.1e-4}, {4.5e-2, 5.1e-3}},
                         hp[] = {{4.0e-2, 1.0e-2}, {2.7e-5, 2.7e-7}, {4.6e-1, 9.0e-2}};
  for(std::size_t i = 0; i < surfaces.size(); ++i)
    add_row(table, surfaces[i].name, surfaces[i].clean.size(), paper[i], hp[i],
            errors(surfaces[i], surfaces[i].clean, with_method(Surfel_path_method::disks)),
            errors(surfaces[i], surfaces[i].clean, {}));
  table.print();
}

void print_spheres()
{
  std::printf("Table 4, unit spheres subdivided from the octahedron: relative errors in percent\n");
  Table table(table_header());
  const Published_errors paper[] = {
      {6.20, 2.162}, {2.95, 0.885}, {1.02, 0.275}, {0.34, 0.074}, {0.08, 0.035}};
  for(unsigned i = 0; i < 5; ++i)
  {
    const Surface sphere = {"level " + std::to_string(3 + i), octahedron_sphere(3 + i),
                            great_circle};
    add_row(table, sphere.name, sphere.clean.size(), paper[i], {std::nan(""), std::nan("")},
            errors(sphere, sphere.clean, with_method(Surfel_path_method::disks)),
            errors(sphere, sphere.clean, {}));
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

void print_noisy(std::vector<Surface>& surfaces)
{
  std::printf(
      "Table 5, noise in percent of the surfel radius: relative errors in percent. \"+5 %%\": 5 %% "
      "of outliers\nwith a noise of 200 %% are added\n");
  Table table(table_header()),
      weights({"surface", "surfels", "EG spheres", "EP", "EG robust spheres", "EP"});
  const Published_errors paper[] = {{0.49, 0.25}, {0.019, 0.097}, {0.69, 0.46},
                                    {0.88, 0.31}, {0.023, 0.11},  {1.04, 0.71}},
                         hp[] = {{8.50, 0.10},  {0.12, 0.24}, {2.50, 0.94},
                                 {22.20, 0.15}, {0.49, 0.8},  {16.38, 3.70}};
  const Published_errors not_published = {std::nan(""), std::nan("")};
  const auto add_weights = [&](const Surface& s, const std::string& name, const Cloud& cloud)
  {
    std::vector<std::string> row = {name, std::to_string(cloud.size())};
    for(const auto method : {Surfel_path_method::spheres, Surfel_path_method::robust_spheres})
    {
      Cloud_path_options options = with_method(method);
      options.noise = Surfel_noise::kept;
      const Errors e = errors(s, cloud, options);
      row.push_back(percent(e.length));
      row.push_back(percent(e.path));
    }
    weights.add(row);
  };
  const auto add = [&](const Surface& s, const std::string& name, const Cloud& noisy,
                       const Published_errors& p, const Published_errors& h)
  {
    add_row(table, name, noisy.size(), p, h,
            errors(s, noisy, with_method(Surfel_path_method::disks)), errors(s, noisy, {}));
  };
  for(int level = 1; level <= 2; ++level)
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Surface& s = surfaces[i];
      const std::vector<double> r = radii(s.clean);
      const Cloud noisy = with_noise(s.clean, r, 0.5 * level, 7);
      const std::size_t row = 3 * std::size_t(level - 1) + i;
      const std::string name = s.name + " " + std::to_string(50 * level) + " %";
      add(s, name, noisy, paper[row], hp[row]);
      add(s, name + " +5 %", with_outliers(noisy, s.clean, r, 0.05, 2., 8), not_published,
          not_published);
    }
  const Cloud scanned = scanned_square(94, 70, 3);
  Surface square = {"scan", scanned_square(94, 70, 0), straight_segment};
  add(square, "scanned plane", scanned, {0.15, 0.25}, {0.40, 0.33});
  table.print();
  std::printf("Plain and robust weights, without prior removal of noise and outliers\n");
  for(std::size_t i = 0; i < 3; ++i)
  {
    const Surface& s = surfaces[i];
    const std::vector<double> r = radii(s.clean);
    for(const int level : {0, 2, 10})
    {
      const Cloud cloud = level == 0 ? s.clean : with_noise(s.clean, r, 0.01 * level, 7);
      const std::string name = s.name + " " + std::to_string(level) + " %";
      add_weights(s, name, cloud);
      add_weights(s, name + " +5 %", with_outliers(cloud, s.clean, r, 0.05, 2., 8));
    }
  }
  weights.print();
}

// The zero level set of a function.
class Implicit_surface : public Path_surface
{
public:
  using Function = std::function<double(const Vec3&, Vec3& gradient)>;

  explicit Implicit_surface(Function function) : m_function(std::move(function)) {}

  Projection project(const Vec3& point, Index) const override
  {
    Projection result = {point, {0., 0., 0.}, {0., 0., 0.}, 0};
    for(int i = 0; i < 6; ++i)
    {
      Vec3 gradient;
      const double value = m_function(result.point, gradient);
      result.normal = unit(gradient);
      result.point = result.point - value / dot(gradient, gradient) * gradient;
    }
    return result;
  }

private:
  Function m_function;
};

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

// Measures the convergence order of lengths. The reference is the geodesic on the implicit surface,
// obtained by shortening the path with a thousand control points.
void print_orders()
{
  std::printf(
      "Convergence on surfaces that algebraic spheres do not represent exactly: EG in percent, "
      "relative to\ngeodesics of the implicit surface\n");
  Table table({"surface", "surfels", "EG", "reduction factor"});
  const auto add =
      [&](const std::string& name, const Implicit_surface& surface, const auto& make_points)
  {
    double before = std::nan("");
    for(std::size_t n = 1000; n <= 64000; n *= 4)
    {
      const Cloud cloud = make_points(n);
      Cloud_path_finder finder(std::make_shared<const Fitted_cloud>(
          cloud.points, cloud.normals, std::vector<double>(), Cloud_path_options()));
      const Surfel_cloud& c = finder.fitted_cloud()->cloud();
      double sum = 0.;
      for(const auto& [a, b] : random_pairs(cloud))
      {
        const Cloud_path found =
            finder({c.internal_vertex[a], {0., 0.}}, {c.internal_vertex[b], {0., 0.}});
        std::vector<Projection> chain = found.path.points;
        for(Projection& projection : chain)
          projection.point = c.frame.origin + c.frame.scale * projection.point;
        chain.front().point = cloud.points[a];
        chain.back().point = cloud.points[b];
        Path_options options;
        options.number_of_control_points = 1000;
        const double truth = shorten_path(surface, options, chain).length;
        sum += std::pow(c.frame.scale * found.path.length / truth - 1., 2);
      }
      const double error = std::sqrt(sum / number_of_pairs);
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
  Table table(
      {"surface", "surfels", "paper, points", "paper", "HP", "ours, points", "ours", "set-up"});
  const auto add = [&](const std::string& name, const Cloud& clean, const Cloud& cloud,
                       double paper_points, double paper, double hp)
  {
    std::shared_ptr<const Fitted_cloud> fitted_cloud;
    const double preparation = cpu_seconds(
        [&]
        {
          fitted_cloud = std::make_shared<const Fitted_cloud>(
              cloud.points, cloud.normals, std::vector<double>(), Cloud_path_options());
        });
    Cloud_path_finder finder(fitted_cloud);
    const std::vector<Index>& internal_vertex = fitted_cloud->cloud().internal_vertex;
    const auto ends = random_pairs(clean);
    double points = 0.;
    const double paths = cpu_seconds(
        [&]
        {
          for(const auto& [a, b] : ends)
            points += double(finder({internal_vertex[a], {0., 0.}}, {internal_vertex[b], {0., 0.}})
                                 .path.number_of_control_points);
        });
    table.add({name, std::to_string(cloud.size()), format_fixed(paper_points, 2),
               format_fixed(paper, 2), format_fixed(hp, 2),
               format_fixed(points / number_of_pairs, 0), format_fixed(paths, 2),
               format_fixed(preparation, 2)});
  };
  const Cloud model = ellipsoid_cloud(134345, axes);
  add("ellipsoid", model, model, 74.55, 19.37, 5.68);
  const double published[][3] = {{68.55, 3.44, 1.83}, {20.58, 0.68, 1.21}, {37.04, 7.11, 2.05}};
  for(std::size_t i = 0; i < 3; ++i)
    add(surfaces[i].name + " 50 %", surfaces[i].clean,
        with_noise(surfaces[i].clean, radii(surfaces[i].clean), 0.5, 7), published[i][0],
        published[i][1], published[i][2]);
  const Cloud scanned = scanned_square(94, 70, 3);
  add("scanned plane", scanned, scanned, 30.81, 0.69, 0.57);
  table.print();
  std::printf("Target: 1 s on the ellipsoid.\n\n");
}

// Measures times on ellipsoids with the numbers of surfels of the paper's models.
void print_times(bool is_quick)
{
  std::printf(
      "Table 1, seconds on ellipsoids with equal numbers of surfels (in the paper: Pentium 4, "
      "2.8 GHz)\n");
  Table table({"surfels", "paper, graph", "graph, 2 threads", "processor", "set-up", "100 paths",
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
    const auto ends = random_pairs(cloud);
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
               format_fixed(points / number_of_pairs, 0), format_fixed(1e6 * paths / points, 1),
               format_fixed(coarse_to_fine, 2), format_fixed(a_star, 2),
               percent(length / shortest - 1.) + " %"});
  }
  table.print();
  std::printf("Targets: 1.5 s for the graph of a million surfels; 100 paths no slower than with a "
              "hundred thousand.\n\n");
}

// Reads a cloud with its normals. If it has none, they are computed by estimate_surfels().
Cloud load_scan(const std::filesystem::path& file)
{
  CGAL::Point_set_3<CGAL::Simple_cartesian<double>::Point_3> points;
  Cloud cloud;
  if(!CGAL::IO::read_point_set(file.string(), points))
    return cloud;
  const auto spatial = [](const auto& p) -> Vec3 { return {p.x(), p.y(), p.z()}; };
  for(const auto& index : points)
    cloud.add(spatial(points.point(index)),
              points.has_normal_map() ? spatial(points.normal(index)) : Vec3{0., 0., 1.});
  if(!points.has_normal_map())
    cloud.normals = estimate_surfels(cloud.points, 18, 0., 1).normals;
  return cloud;
}

// Statistics of paths on a scan.
struct Path_adherence
{
  std::size_t pairs = 0, points = 0, number_outside = 0, crossings = 0, longer = 0;
  double max_distance = 0.; // largest distance divided by the local spacing
};

// Counts path points outside of the cloud, and path steps between separate sheets.
//
// A point is outside if its distance to the nearest surfel exceeds the local spacing. The local
// spacing is the 95th percentile, over the 60 nearest surfels, of the distance to the sixth
// neighbor.
//
// Two surfels agree if their normals differ by less than 100 degrees, and if their chord rises
// above neither of them by more than that difference. Two surfels are on separate sheets if no
// short chain connects them in which each surfel agrees with the next. A chain is short if its
// length is at most twice the step plus three radii of each surfel. A step of a path crosses if its
// two surfels are on separate sheets. The surfels are the smoothed ones of the path finder. Their
// neighbors are selected by normals, regardless of the graph of the path. Therefore paths that
// start in a graph without normals reveal if the cloud has such sheets. If normals are random, as
// between trees, chains lead around nearly everything but gaps and walls.
Path_adherence measure_adherence(const Cloud& cloud, std::size_t max_pairs, unsigned seed,
                                 Surfel_graph graph)
{
  constexpr std::size_t number_of_neighbors = 60, percentile_index = 57;
  std::vector<Vec3> cloud_points = cloud.points;
  std::vector<Index> order;
  const Kd_tree tree(cloud_points, order);
  std::vector<Kd_tree::Neighbor> near;
  std::vector<double> spacing, local_spacing;
  for(const Vec3& p : cloud_points)
  {
    tree.nearest(cloud_points, p, 7, near);
    spacing.push_back(std::sqrt(near.back().squared_distance));
  }
  Cloud_path_options options;
  options.cloud.graph = graph;
  const auto fitted_cloud = std::make_shared<const Fitted_cloud>(cloud.points, cloud.normals,
                                                                 std::vector<double>(), options);
  Cloud_path_finder finder(fitted_cloud);
  const Surfel_cloud& c = fitted_cloud->cloud();
  const Surfel_cloud sheet_cloud = make_cloud(c.point, c.normal);
  const auto crosses_sheets = [&](const Projection& from, const Projection& to)
  {
    const Index a = sheet_cloud.internal_vertex[from.vertex],
                b = sheet_cloud.internal_vertex[to.vertex];
    const double max_path_length = 2. * norm(to.point - from.point) / sheet_cloud.frame.scale +
                                   3. * (sheet_cloud.radius[a] + sheet_cloud.radius[b]);
    return !is_connected_within(sheet_cloud, a, b, max_path_length);
  };
  Path_adherence result;
  std::mt19937 random(seed);
  while(result.pairs < max_pairs)
  {
    const Index a = c.internal_vertex[random() % cloud.size()],
                b = c.internal_vertex[random() % cloud.size()];
    if(a == b || c.component[a] != c.component[b])
      continue;
    ++result.pairs;
    const Cloud_path found = finder({a, {0., 0.}}, {b, {0., 0.}});
    const std::vector<Projection>& points = found.path.points;
    result.longer += found.path.length > found.initial_length * (1. + 1e-12); // round-off error
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      tree.nearest(cloud_points, c.frame.origin + c.frame.scale * points[i].point,
                   number_of_neighbors, near);
      local_spacing.clear();
      for(const Kd_tree::Neighbor& neighbor : near)
        local_spacing.push_back(spacing[neighbor.point]);
      std::nth_element(local_spacing.begin(), local_spacing.begin() + percentile_index,
                       local_spacing.end());
      const double ratio =
          std::sqrt(near.front().squared_distance) / local_spacing[percentile_index];
      ++result.points;
      result.number_outside += ratio > 1.;
      result.max_distance = std::max(result.max_distance, ratio);
      result.crossings += i > 0 && crosses_sheets(points[i - 1], points[i]);
    }
  }
  return result;
}

void print_scans(unsigned seed)
{
  std::printf(
      "Scans: distances of paths to the cloud, and steps between separate sheets (seed %u)\n",
      seed);
  Table table({"scan", "surfels", "paths", "points", "outside", "maximum distance", "longer",
               "crossings", "without normals"});
  std::vector<std::filesystem::path> files;
  const auto folder = std::filesystem::path(GEODESIC_PROCESSING_DATA) / "points";
  if(exists(folder))
    files.assign(std::filesystem::directory_iterator(folder), {});
  std::sort(files.begin(), files.end());
  for(const auto& file : files)
    if(const Cloud cloud = load_scan(file); cloud.size() > 60)
    {
      const Path_adherence k = measure_adherence(cloud, 60, seed, Surfel_graph::extended_spheres),
                           without_normals =
                               measure_adherence(cloud, 60, seed, Surfel_graph::nearest);
      table.add({file.stem().string(), std::to_string(cloud.size()), std::to_string(k.pairs),
                 std::to_string(k.points), std::to_string(k.number_outside),
                 format_fixed(k.max_distance, 3), std::to_string(k.longer),
                 std::to_string(k.crossings), std::to_string(without_normals.crossings)});
    }
  table.print();
  std::printf("Targets: no point outside, no path longer than its initial path, no crossings (some "
              "are allowed without normals).\n\n");
}

} // namespace

int main(int argc, char* argv[])
{
  const std::string argument = argc > 1 ? argv[1] : "";
  const bool is_quick = argument == "--quick";
  if(argument == "--scans")
    return print_scans(argc > 2 ? unsigned(std::stoul(argv[2])) : 1), 0;
  std::vector<Surface> surfaces = {
      {"sphere", octahedron_sphere(7), great_circle},
      {"plane", square_cloud(100), straight_segment},
      {"cylinder", cylinder_cloud(201, 60, cylinder_radius, cylinder_height), helices}};
  if(argument == "--times")
    return print_path_times(surfaces), print_times(false), 0;
  print_clean(surfaces);
  print_spheres();
  print_noisy(surfaces);
  print_orders();
  print_scans(1);
  print_path_times(surfaces);
  print_times(is_quick);
}
