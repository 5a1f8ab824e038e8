// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the errors of normal coordinates.
#include <CGAL/Geodesic_processing.h>
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/log_map/log_map.h>

#include "clouds.h"
#include "models.h"
#include "normal_coordinates.h"
#include "report.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Polygon_mesh_processing/smooth_shape.h>
#include <CGAL/convex_hull_3.h>

#include <complex>
#include <cstring>
#include <limits>
#include <random>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;
namespace test = CGAL::Geodesic_processing::test;
using Complex = std::complex<double>;
using Size = Mesh::size_type;

constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

constexpr double half_pi = CGAL_PI / 2.;

// ------------------------------------------------------------------------------------------
// spheres

// Returns random points on the unit sphere, triangulated by their convex hull (their Delaunay
// triangulation on the sphere).
Mesh random_sphere(std::size_t n)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Kernel::Point_3> points;
  while(points.size() < n)
  {
    const auto p = Kernel::Vector_3(normal(random), normal(random), normal(random));
    points.push_back(CGAL::ORIGIN + p / std::sqrt(p.squared_length()));
  }
  Mesh mesh;
  CGAL::convex_hull_3(points.begin(), points.end(), mesh);
  return mesh;
}

// Returns the mean error of tangent vectors over several bases, in percent.
template <typename Method>
double mean_error(const Mesh& mesh, double stencil_length)
{
  GP::Logarithmic_map<Mesh, Method> map(mesh);
  const std::size_t number_of_bases = num_vertices(mesh) > 100000 ? 2 : 6;
  double result = 0.;
  for(std::size_t i = 0; i < number_of_bases; ++i)
  {
    map.compute(Vertex(Size(i * num_vertices(mesh) / number_of_bases)),
                GP::parameters::maximum_distance(half_pi).stencil_length(stencil_length));
    result += 100. * test::mean_error_on_sphere(map, [&](Vertex v) { return mesh.point(v); }) /
              double(number_of_bases);
  }
  return result;
}

// Table with a row for each method and a column for each mesh. Each mesh has four times as many
// vertices as the previous one.
class Error_table
{
public:
  explicit Error_table(std::vector<Mesh> meshes) : m_meshes(std::move(meshes)) {}

  template <typename Method>
  void add(const std::string& name, double stencil_length = 0., std::size_t max_vertices = all)
  {
    std::vector<std::string> row = {name};
    std::vector<double> errors;
    for(const Mesh& mesh : m_meshes)
      if(num_vertices(mesh) <= max_vertices)
      {
        errors.push_back(mean_error<Method>(mesh, stencil_length));
        row.push_back(format_significant(errors.back()));
      }
      else
        row.push_back("-");
    row.push_back(order(errors));
    m_rows.push_back(row);
  }

  void print(const std::string& title) const
  {
    std::vector<std::string> head = {"method"};
    for(const Mesh& mesh : m_meshes)
      head.push_back(std::to_string(num_vertices(mesh)));
    head.push_back("order");
    Table table(title, head);
    for(const auto& row : m_rows)
      table.add(row);
    table.print();
  }

private:
  // Returns the exponent of the edge length, between the first and the last error.
  static std::string order(const std::vector<double>& errors)
  {
    if(errors.size() < 2)
      return "-";
    return format_fixed(std::log2(errors.front() / errors.back()) / double(errors.size() - 1), 2);
  }

  std::vector<Mesh> m_meshes;
  std::vector<std::vector<std::string>> m_rows;
};

void add_methods(Error_table& table)
{
  table.add<GP::Gradient<>>("Gradient<Euclidean_front>");
  table.add<GP::Gradient<>>("Gradient<Euclidean_front>, stencil of 0.1", 0.1);
  table.add<GP::Gradient<>>("Gradient<Euclidean_front>, stencil of 0.2", 0.2);
  table.add<GP::Gradient<GP::Exact>>("Gradient<Exact>");
  table.add<GP::Gradient<GP::Heat>>("Gradient<Heat>", 0., 20000);
  table.add<GP::Gradient<GP::Fast_marching>>("Gradient<Fast_marching>");
  table.add<GP::Gradient<GP::Fast_marching>>("Gradient<Fast_marching>, stencil of 0.2", 0.2);
  table.add<GP::Gradient<GP::Dijkstra>>("Gradient<Dijkstra>");
  table.add<GP::Exact>("Exact");
  table.add<GP::Discrete_exponential>("Discrete_exponential");
}

void compare_on_spheres(bool quick)
{
  std::printf(
      "Unit sphere: mean error of tangent vectors relative to the distance, in percent, over the "
      "vertices\nwithin a distance of pi / 2\n");
  std::vector<Mesh> regular, irregular;
  for(const unsigned level : quick ? std::vector<unsigned>{4, 5} : std::vector<unsigned>{5, 6, 7})
  {
    regular.push_back(icosphere(level));
    irregular.push_back(random_sphere(num_vertices(regular.back())));
  }
  Error_table on_regular(std::move(regular)), on_irregular(std::move(irregular));
  add_methods(on_regular);
  on_regular.print("errors on icospheres, %");
  std::printf("Targets for Gradient<Euclidean_front>: 0.2 at 10242 and 0.06 at 163842 vertices; "
              "order 1.\n\n");
  add_methods(on_irregular);
  on_irregular.print("errors on random points, %");
}

void compare_on_clouds(std::size_t n)
{
  Table table("spherical clouds",
              {"mean error % on a spherical cloud", "surfels", "Gradient<Euclidean_front>"});
  test::Cloud random_cloud, spiral;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for(std::size_t i = 0; i < n; ++i)
  {
    const test::Vec3 p = GP::internal::unit({normal(random), normal(random), normal(random)}),
                     q = test::on_spiral(i, n);
    random_cloud.add(p, p);
    spiral.add(q, q);
  }
  const auto add = [&](const std::string& name, const test::Cloud& cloud)
  {
    using Cloud = CGAL::Point_set_3<Kernel::Point_3>;
    Cloud points(true);
    for(const auto& p : cloud.points)
      points.insert({p[0], p[1], p[2]}, {p[0], p[1], p[2]});
    GP::Logarithmic_map<Cloud> map(points);
    double sum = 0.;
    for(const std::size_t base : {0, 1, 2, 3})
    {
      map.compute(Cloud::Index(base * cloud.size() / 4), GP::parameters::maximum_distance(half_pi));
      sum += test::mean_error_on_sphere(map, [&](Cloud::Index i) { return points.point(i); }) / 4.;
    }
    table.add({name, std::to_string(cloud.size()), format_significant(100. * sum)});
  };
  add("random", random_cloud);
  add("spiral", spiral);
  add("octahedron", test::octahedron_sphere(5));
  table.print();
  std::printf("Target: at most 2 %%.\n\n");
}

// ------------------------------------------------------------------------------------------ others

// Returns the largest difference between a map and the true vectors over the reached vertices. It
// is relative to the largest true distance.
template <typename Map, typename Truth>
double largest_error(const Map& map, Truth truth)
{
  double error = 0., size = 0.;
  for(const Vertex v : map.reached())
  {
    const auto found = map(v), expected = truth(v);
    error = std::max(error, std::hypot(found[0] - expected[0], found[1] - expected[1]));
    size = std::max(size, std::hypot(expected[0], expected[1]));
  }
  return error / size;
}

void compare_on_developables(std::size_t n)
{
  Table table("square and cylinder",
              {"maximum relative error", "Gradient<Euclidean_front>", "Exact"});
  const auto add =
      [&](const std::string& name, const Mesh& mesh, Vertex base, auto limits, auto truth)
  {
    GP::Logarithmic_map<Mesh> gradient(mesh);
    GP::Logarithmic_map<Mesh, GP::Exact> exact(mesh);
    gradient.compute(base, limits);
    exact.compute(base, limits);
    table.add({name, format_significant(largest_error(gradient, truth(gradient))),
               format_significant(largest_error(exact, truth(exact)))});
  };
  const Mesh plane = jittered_square(n + 1);
  const Vertex middle(Size((n + 2) * (n / 2)));
  add("square, jittered", plane, middle, GP::parameters::up_direction(Kernel::Vector_3(0., 1., 0.)),
      [&](const auto&)
      {
        return [&](Vertex v)
        {
          const auto offset = plane.point(v) - plane.point(middle);
          return std::array<double, 2>{offset.x(), offset.y()};
        };
      });
  // The mesh is developable. Each triangle has one edge on the regular polygon of a ring, and its
  // third corner is slightly farther from the axis than the midpoint of that edge.
  const Mesh cylinder = mesh_of(test::cylinder(n, n / 2, 1., 6.));
  const Vertex base(Size(n * (n / 4)));
  const double side = 2. * std::sin(CGAL_PI / double(n)), step = 6. / double(n / 2),
               height = std::hypot(step, 1. - std::cos(CGAL_PI / double(n)));
  add("cylinder", cylinder, base,
      GP::parameters::maximum_distance(2.5).up_direction(Kernel::Vector_3(0., 0., 1.)),
      [&](const auto&)
      {
        return [&](Vertex v)
        {
          const auto &p = cylinder.point(v), &o = cylinder.point(base);
          const double turn =
              std::remainder(std::atan2(p.y(), p.x()) - std::atan2(o.y(), o.x()), 2. * CGAL_PI);
          return std::array<double, 2>{turn / (2. * CGAL_PI) * double(n) * side,
                                       (p.z() - o.z()) / step * height};
        };
      });
  table.print();
  std::printf("Target: 1e-6.\n\n");
}

double diagonal(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for(const Vertex v : mesh.vertices())
    box += mesh.point(v).bbox();
  return std::sqrt(squared_distance(Kernel::Point_3(box.xmin(), box.ymin(), box.zmin()),
                                    Kernel::Point_3(box.xmax(), box.ymax(), box.zmax())));
}

// Returns the radius around the base in which the map is injective: the distance to the first cut.
double injectivity_radius(const Mesh& mesh, const GP::Logarithmic_map<Mesh, GP::Exact>& map)
{
  double radius = std::numeric_limits<double>::infinity();
  map.for_each_cut_face(
      [&](Face f)
      {
        for(const Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
          radius = std::min(radius, std::hypot(map(v)[0], map(v)[1]));
      });
  return radius;
}

std::vector<Vertex> random_vertices(const Mesh& mesh, std::size_t number)
{
  std::mt19937 random(3);
  std::vector<Vertex> result;
  while(result.size() < number)
    if(const Vertex v(Size(random() % num_vertices(mesh))); !mesh.is_isolated(v))
      result.push_back(v);
  return result;
}

// Returns the quantile of `values` at `fraction`, or nan if there are no values.
double quantile(std::vector<double> values, double fraction)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? std::nan("") : values[std::size_t(fraction * double(values.size() - 1))];
}

double angle_between(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  return std::fabs(std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]));
}

// Returns the angles in degrees between a map and the exact map, around eight vertices up to a
// radius.
template <typename Method>
std::vector<double> angles_against_exact(const Mesh& mesh, double radius)
{
  GP::Logarithmic_map<Mesh, GP::Exact> exact(mesh);
  GP::Logarithmic_map<Mesh, Method> map(exact.domain());
  const auto limits = GP::parameters::maximum_distance(radius);
  std::vector<double> angles;
  for(const Vertex base : random_vertices(mesh, 8))
  {
    exact.compute(base, limits);
    map.compute(base, limits);
    const double max_radius = injectivity_radius(mesh, exact);
    for(const Vertex v : exact.reached())
      if(v != base && map.is_inside(v) && std::hypot(exact(v)[0], exact(v)[1]) < max_radius)
        angles.push_back(angle_between(exact(v), map(v)) * 180. / CGAL_PI);
  }
  return angles;
}

void compare_on_models(const std::vector<std::string>& names)
{
  Table table("models", {"model", "angles", "Gradient<Euclidean_front>", "Gradient<Fast_marching>",
                         "Discrete_exponential"});
  bool has_models = false;
  for(const std::string& name : names)
  {
    const auto mesh = load_model(name);
    if(!mesh)
      continue;
    has_models = true;
    const double radius = 0.15 * diagonal(*mesh);
    const auto format_angles = [](const std::vector<double>& angles) {
      return format_significant(median(angles)) + " / " + format_significant(quantile(angles, 0.9));
    };
    const auto gradient = angles_against_exact<GP::Gradient<>>(*mesh, radius);
    table.add({name, std::to_string(gradient.size()), format_angles(gradient),
               format_angles(angles_against_exact<GP::Gradient<GP::Fast_marching>>(*mesh, radius)),
               format_angles(angles_against_exact<GP::Discrete_exponential>(*mesh, radius))});
  }
  if(!has_models)
  {
    std::printf("No models: there is no folder %s.\n\n", GEODESIC_PROCESSING_DATA);
    return;
  }
  std::printf(
      "Models: angles between the map and Exact in degrees, median / 90th percentile. Around eight "
      "vertices,\nup to 0.15 times the bounding box diagonal and the first cut of the map.\n");
  table.print();
}

// Returns the angle at `base` from its first halfedge to the direction of `target_point`, a point
// of an incident face. The angle is divided by the total angle at the vertex.
double normalized_angle(const Mesh& mesh, Vertex base, const Kernel::Point_3& target_point)
{
  const auto angle = [](const Kernel::Vector_3& a, const Kernel::Vector_3& b)
  { return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b); };
  const Kernel::Point_3& o = mesh.point(base);
  double accumulated_angle = 0., min_excess = std::numeric_limits<double>::infinity(), result = 0.;
  auto h = mesh.opposite(mesh.halfedge(base)); // its source is the base
  const auto first = h;
  do
  {
    const auto next = mesh.opposite(mesh.prev(h));
    const auto a = mesh.point(mesh.target(h)) - o, b = mesh.point(mesh.target(next)) - o;
    const double face_angle = angle(a, b), angle_to_direction = angle(a, target_point - o);
    // The excess is zero if the direction lies in this face.
    const double excess = angle_to_direction + angle(target_point - o, b) - face_angle;
    if(excess < min_excess)
    {
      min_excess = excess;
      result = accumulated_angle + angle_to_direction;
    }
    accumulated_angle += face_angle;
    h = next;
  } while(h != first);
  return result / accumulated_angle;
}

// Compares the exact map with the directions and lengths of shortest paths from CGAL's exact
// algorithm.
void compare_with_cgal(const std::string& name, const Mesh& mesh)
{
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
  const Vertex base(Size(num_vertices(mesh) / 2));
  CGAL::Surface_mesh_shortest_path<Traits> paths(mesh);
  paths.add_source_point(base);
  GP::Logarithmic_map<Mesh, GP::Exact> map(mesh);
  map.compute(base, GP::parameters::maximum_distance(0.15 * diagonal(mesh)));
  std::vector<Complex> ours, theirs;
  Complex rotation = 0.;
  for(const Vertex v : map.reached())
  {
    std::vector<Kernel::Point_3> path;
    const double distance =
        paths.shortest_path_points_to_source_points(v, std::back_inserter(path)).first;
    if(path.size() < 2)
      continue;
    theirs.push_back(
        std::polar(distance, 2. * CGAL_PI * normalized_angle(mesh, base, path[path.size() - 2])));
    ours.emplace_back(map(v)[0], map(v)[1]);
    rotation += ours.back() * std::conj(theirs.back()) / std::norm(theirs.back());
  }
  std::vector<double> errors;
  for(std::size_t i = 0; i < ours.size(); ++i)
    errors.push_back(std::abs(theirs[i] * rotation / std::abs(rotation) - ours[i]) /
                     std::abs(ours[i]));
  std::printf(
      "Exact compared with CGAL's shortest paths on %s, %zu vectors. Relative difference: median "
      "%s,\n90th percentile %s, maximum %s. Target: 0.02.\n\n",
      name.c_str(), errors.size(), format_significant(median(errors)).c_str(),
      format_significant(quantile(errors, 0.9)).c_str(),
      format_significant(*std::max_element(errors.begin(), errors.end())).c_str());
}

// --------------------------------------------------------------------------------------------
// noise

// Root mean squares of angles in degrees: against the exact map of the same mesh, and against the
// noise-free sphere after the best rotation.
struct Noise_errors
{
  double exact, sphere;
};

template <typename Map>
Noise_errors noise_errors(const Mesh& mesh, const GP::Logarithmic_map<Mesh, GP::Exact>& exact,
                          const Map& map)
{
  const auto frame = map.frame();
  double against_exact = 0., count = 0.;
  std::vector<double> angles; // on the sphere
  Complex mean = 0.;
  for(const Vertex v : exact.reached())
  {
    const auto found = map(v), expected = test::vector_on_sphere(frame, mesh.point(v));
    if(!map.is_inside(v) || std::hypot(found[0], found[1]) == 0.) // the base
      continue;
    against_exact += std::pow(angle_between(exact(v), found), 2);
    angles.push_back(std::atan2(expected[0] * found[1] - expected[1] * found[0],
                                expected[0] * found[0] + expected[1] * found[1]));
    mean += std::polar(1., angles.back());
    ++count;
  }
  double against_sphere = 0.;
  for(const double angle : angles)
    against_sphere += std::pow(std::remainder(angle - std::arg(mean), 2. * CGAL_PI), 2);
  return {std::sqrt(against_exact / count) * 180. / CGAL_PI,
          std::sqrt(against_sphere / count) * 180. / CGAL_PI};
}

template <typename Method>
void add_noise_row(Table& table, const std::string& name, double noise, const Mesh& mesh,
                   const std::vector<double>& rings, std::size_t smoothing_steps = 0,
                   std::size_t base_refinements = 0)
{
  GP::Logarithmic_map<Mesh, GP::Exact> exact(mesh);
  GP::Logarithmic_map<Mesh, Method> map(exact.domain());
  const auto limits = GP::parameters::maximum_distance(1.);
  const double edge = mean_edge_length(mesh);
  const auto bases = random_vertices(mesh, 4);
  std::vector<Noise_errors> errors(rings.size(), {0., 0.});
  for(const Vertex base : bases)
  {
    exact.compute(base, limits);
    for(std::size_t i = 0; i < rings.size(); ++i)
    {
      map.compute(base, limits.stencil_length(rings[i] * edge)
                            .number_of_smoothing_steps(smoothing_steps)
                            .number_of_base_refinements(base_refinements));
      const Noise_errors found = noise_errors(mesh, exact, map);
      errors[i].exact += found.exact / double(bases.size());
      errors[i].sphere += found.sphere / double(bases.size());
    }
  }
  std::vector<std::string> row = {format_fixed(100. * noise, 0), name};
  for(const Noise_errors& e : errors)
    row.push_back(format_fixed(e.exact, 2) + " / " + format_fixed(e.sphere, 2));
  table.add(row);
}

// Adds the rows of a method: without options, with smoothed distance maps, with a refined mesh
// around the base, and with both.
template <typename Method>
void add_noise_rows(Table& table, const std::string& name, double noise, const Mesh& mesh,
                    const std::vector<double>& rings)
{
  add_noise_row<Method>(table, name, noise, mesh, rings);
  add_noise_row<Method>(table, name + ", 10 steps", noise, mesh, rings, 10);
  add_noise_row<Method>(table, name + ", 30 steps", noise, mesh, rings, 30);
  add_noise_row<Method>(table, name + ", 3 refinements", noise, mesh, rings, 0, 3);
  add_noise_row<Method>(table, name + ", 30 steps, 3 refinements", noise, mesh, rings, 30, 3);
}

// Adds a row of relative errors of lengths, in percent, against Exact on the same mesh: of the
// distances, and of the lengths that the gradients have before they are replaced by the distances.
void add_length_row(Table& table, const std::string& name, GP::Distance_method method, double noise,
                    const Mesh& mesh, const std::vector<double>& rings)
{
  using namespace GP::internal;
  GP::Logarithmic_map<Mesh, GP::Exact> exact(mesh);
  const auto& triangles = exact.domain().triangles();
  Distance_engine engine(method, triangles);
  const double edge = mean_edge_length(mesh) / triangles->scale;
  std::vector<double> squares(rings.size() + 1, 0.);
  double count = 0.;
  for(const Vertex base : random_vertices(mesh, 4))
  {
    exact.compute(base, GP::parameters::maximum_distance(1.));
    const Surface_location location{none, exact.domain().index(base), {}};
    const Tangent_plane plane(*triangles, location);
    std::vector<Index> vertices;
    std::vector<double> truths, distances;
    engine.run({Front_source{{location}}});
    for(const Vertex v : exact.reached())
      if(v != base)
      {
        vertices.push_back(exact.domain().index(v));
        truths.push_back(std::hypot(exact(v)[0], exact(v)[1]) / triangles->scale);
        distances.push_back(engine.distance(vertices.back()));
        squares[0] += std::pow(distances.back() / truths.back() - 1., 2);
      }
    count += double(vertices.size());
    for(std::size_t k = 0; k < rings.size(); ++k)
    {
      const Stencil stencil = straightest_stencil(plane, rings[k] * edge, 8);
      const std::size_t size = stencil.locations.size();
      std::vector<double> to_stencil(vertices.size() * size);
      for(std::size_t j = 0; j < size; ++j)
      {
        engine.run({Front_source{{stencil.locations[j]}}});
        for(std::size_t i = 0; i < vertices.size(); ++i)
          to_stencil[i * size + j] = engine.distance(vertices[i]);
      }
      const Log_map_fit fit(stencil.vectors);
      for(std::size_t i = 0; i < vertices.size(); ++i)
        squares[k + 1] +=
            std::pow(norm(fit.gradient(distances[i], &to_stencil[i * size])) / truths[i] - 1., 2);
    }
  }
  std::vector<std::string> row = {format_fixed(100. * noise, 0), name};
  for(const double square : squares)
    row.push_back(format_significant(100. * std::sqrt(square / count)));
  table.add(row);
}

// Returns an icosphere with uniform noise of a standard deviation of `noise` mean edge lengths.
Mesh noisy_sphere(unsigned level, double noise)
{
  return mesh_of(test::jittered(test::icosphere(level),
                                std::sqrt(3.) * noise * mean_edge_length(icosphere(level))));
}

void compare_lengths(unsigned level)
{
  std::printf(
      "Lengths: root mean square relative errors in percent within a distance of 1, to Exact on "
      "the same mesh:\nof the distance, which is the length of a tangent vector, and of the "
      "length that the gradient of the squared\ndistance has, by the length of the stencil in "
      "rings of neighbors\n");
  Table table("lengths on noisy spheres",
              {"noise %", "method", "distance", "fitted length, 0.6 rings", "1 ring", "2 rings",
               "3 rings", "4 rings"});
  using Method = GP::Distance_method;
  const std::vector<double> rings = {0.6, 1., 2., 3., 4.};
  for(const double noise : {0., 0.01, 0.05})
  {
    const Mesh mesh = noisy_sphere(level, noise);
    add_length_row(table, "Gradient<Dijkstra>", Method::dijkstra, noise, mesh, rings);
    add_length_row(table, "Gradient<Fast_marching>", Method::fast_marching, noise, mesh, rings);
    add_length_row(table, "Gradient<Euclidean_front>", Method::euclidean_front, noise, mesh, rings);
    add_length_row(table, "Gradient<Exact>", Method::exact, noise, mesh, rings);
  }
  table.print();
}

void compare_noise(unsigned level)
{
  std::printf(
      "Noise: root mean square angles in degrees within a distance of 1, to Exact on the same "
      "mesh / to the\nnoise-free sphere after the best rotation. Standard deviation of each "
      "coordinate in percent of the mean\nedge length, stencil lengths in rings of neighbors.\n");
  Table table("angles on noisy spheres",
              {"noise %", "method", "default stencil", "1 ring", "2 rings", "3 rings"});
  const Mesh clean = icosphere(level);
  const std::vector<double> rings = {0., 1., 2., 3.};
  for(const double noise : {0., 0.01, 0.05})
  {
    const Mesh mesh = noisy_sphere(level, noise);
    add_noise_rows<GP::Gradient<GP::Dijkstra>>(table, "Gradient<Dijkstra>", noise, mesh, rings);
    add_noise_rows<GP::Gradient<GP::Fast_marching>>(table, "Gradient<Fast_marching>", noise, mesh,
                                                    rings);
    add_noise_rows<GP::Gradient<>>(table, "Gradient<Euclidean_front>", noise, mesh, rings);
    add_noise_row<GP::Gradient<GP::Heat>>(table, "Gradient<Heat>", noise, mesh, rings);
    add_noise_row<GP::Gradient<GP::Exact>>(table, "Gradient<Exact>", noise, mesh, rings);
    add_noise_row<GP::Exact>(table, "Exact", noise, mesh, {0.});
    add_noise_row<GP::Discrete_exponential>(table, "Discrete_exponential", noise, mesh, {0.});
    if(noise == 0.)
      continue;
    // Mean curvature flow for one squared edge length, which removes most of the noise.
    Mesh smooth = mesh;
    CGAL::Polygon_mesh_processing::smooth_shape(faces(smooth), smooth,
                                                std::pow(mean_edge_length(clean), 2));
    add_noise_row<GP::Gradient<>>(table, "Gradient<Euclidean_front>, smoothed mesh", noise, smooth,
                                  rings);
    add_noise_row<GP::Exact>(table, "Exact, smoothed mesh", noise, smooth, {0.});
  }
  table.print();
}

} // namespace

// logmap [--quick | noise]
int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  std::printf("Normal coordinates\n\n");
  if(argc > 1 && std::strcmp(argv[1], "noise") == 0)
    return compare_noise(5), compare_lengths(5), 0;
  compare_on_spheres(quick);
  compare_on_clouds(quick ? 2500 : 10000);
  compare_on_developables(quick ? 40 : 100);
  compare_on_models(quick ? std::vector<std::string>{"elephant_2k8", "kitten_9k"}
                          : std::vector<std::string>{"bunny_37k", "armadillo_26k", "nefertiti_35k",
                                                     "boot_20k", "fandisk_6k5", "kitten_9k",
                                                     "camel_10k", "eight_5k", "elephant_2k8"});
  compare_with_cgal("a sphere", icosphere(4));
  if(const auto kitten = load_model("kitten_9k"); kitten && !quick)
    compare_with_cgal("kitten_9k", *kitten);
  compare_noise(quick ? 4 : 5);
  compare_lengths(quick ? 4 : 5);
}
