// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the errors of normal coordinates, and verifies theoretical properties of them.
#include <CGAL/Geodesic_processing.h>
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/log_map/log_map.h>

#include "clouds.h"
#include "models.h"
#include "normal_coordinates.h"
#include "report.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/smooth_shape.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/convex_hull_3.h>

#include <complex>
#include <cstring>
#include <limits>
#include <random>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;
namespace test = CGAL::Geodesic_processing::test;
using test::Measure_asymptotics;
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
    std::vector<std::string> head = {title};
    for(const Mesh& mesh : m_meshes)
      head.push_back(std::to_string(num_vertices(mesh)));
    head.push_back("order");
    Table table(head);
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
  table.add<GP::Gradient<>>("  stencil of 0.1", 0.1);
  table.add<GP::Gradient<>>("  stencil of 0.2", 0.2);
  table.add<GP::Gradient<GP::Exact>>("Gradient<Exact>");
  table.add<GP::Gradient<GP::Heat>>("Gradient<Heat>", 0., 20000);
  table.add<GP::Gradient<GP::Fast_marching>>("Gradient<Fast_marching>");
  table.add<GP::Gradient<GP::Fast_marching>>("  stencil of 0.2", 0.2);
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
  on_regular.print("icosphere");
  std::printf("Targets for Gradient<Euclidean_front>: 0.2 at 10242 and 0.06 at 163842 vertices; "
              "order 1.\n\n");
  add_methods(on_irregular);
  on_irregular.print("random points");
}

void compare_on_clouds(std::size_t n)
{
  Table table({"mean error % on a spherical cloud", "surfels", "Gradient<Euclidean_front>"});
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
  Table table({"maximum relative error", "Gradient<Euclidean_front>", "Exact"});
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
  Table table({"model", "angles", "Gradient<Euclidean_front>", "Gradient<Fast_marching>",
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

// -------------------------------------------------------------------------------------------
// theory

// A stencil length that does not shrink with the edges. With the default stencil, the errors of
// neighbors differ by the same fraction of an edge on finer meshes.
constexpr double theory_stencil_length = 0.2;

template <typename Method>
std::vector<std::string> coefficients(const Mesh& mesh, Vertex base)
{
  GP::Logarithmic_map<Mesh, Method> map(mesh);
  map.compute(base, GP::parameters::maximum_distance(0.65).stencil_length(theory_stencil_length));
  const auto faces = test::faces_around(mesh, map, 0.05, 0.6);
  std::vector<std::string> result;
  for(const Measure_asymptotics& measure : test::measure_asymptotics())
    result.push_back(format_fixed(test::fitted_coefficient(measure, faces), 4));
  return result;
}

void compare_with_theory(bool quick)
{
  std::printf(
      "Distortion around the base: coefficients c of measure = value at the base + c |u|^m "
      "+ c' |u|^(m+2),\nfitted to the faces within a distance of 0.6, and theoretical values "
      "for curvature K\n");
  const Mesh sphere = icosphere(quick ? 5 : 6);
  const auto patch = test::hyperbolic_patch(quick ? 40 : 80, 0.2);
  const Mesh hyperbolic = mesh_of(patch.surface);
  const Vertex middle(Size(patch.base));
  const auto measures = test::measure_asymptotics();
  const auto gradient = coefficients<GP::Gradient<>>(sphere, Vertex(1000)),
             exact = coefficients<GP::Exact>(sphere, Vertex(1000)),
             hyperbolic_gradient = coefficients<GP::Gradient<>>(hyperbolic, middle),
             hyperbolic_exact = coefficients<GP::Exact>(hyperbolic, middle);
  Table table({"measure", "m", "K = 1", "Gradient", "Exact", "K = -1", "Gradient", "Exact"});
  for(std::size_t i = 0; i < measures.size(); ++i)
    table.add({measures[i].name, std::to_string(measures[i].power),
               format_fixed(measures[i].coefficient(1.), 4), gradient[i], exact[i],
               format_fixed(measures[i].coefficient(-1.), 4), hyperbolic_gradient[i],
               hyperbolic_exact[i]});
  table.print();
  std::printf(
      "Icosphere with %zu vertices, jittered pseudosphere with %zu vertices, stencils of length "
      "%.1f. Exact\nunfolds planar faces and is distorted only at vertices. Target for Gradient: 5 "
      "%%, or "
      "0.05/6 if the\ncoefficient is zero.\n\n",
      std::size_t(num_vertices(sphere)), std::size_t(num_vertices(hyperbolic)),
      theory_stencil_length);
}

// A surface with a known Gaussian curvature at a base vertex, at several resolutions.
struct Curved_surface
{
  std::string name;
  std::vector<Mesh> meshes;
  std::vector<Vertex> bases;
  std::vector<double> curvatures; // at the bases
};

// Returns the graph z = (x^2 + sign y^2) / 2 over [-1, 1]^2 with a base at about (x, 0).
Curved_surface quadric(const std::string& name, double sign, double x,
                       const std::vector<std::size_t>& sizes)
{
  Curved_surface result{name, {}, {}, {}};
  for(const std::size_t n : sizes)
  {
    const auto position = [sign](double u, double v) -> test::Point
    {
      const double px = 2. * u - 1., py = 2. * v - 1.;
      return {px, py, (px * px + sign * py * py) / 2.};
    };
    result.meshes.push_back(mesh_of(test::grid(n, n, position, 0.2)));
    const std::size_t column = std::size_t(double(n) * (x + 1.) / 2. + 0.5);
    result.bases.emplace_back(Size(column + (n + 1) * (n / 2)));
    const auto& p = result.meshes.back().point(result.bases.back());
    result.curvatures.push_back(sign / std::pow(1. + p.x() * p.x() + p.y() * p.y(), 2));
  }
  return result;
}

std::vector<Curved_surface> curved_surfaces(bool quick)
{
  Curved_surface sphere{"sphere", {}, {}, {}};
  for(const unsigned level : quick ? std::vector<unsigned>{4, 5} : std::vector<unsigned>{5, 6, 7})
  {
    sphere.meshes.push_back(icosphere(level));
    sphere.bases.emplace_back(100);
    sphere.curvatures.push_back(1.);
  }
  const std::vector<std::size_t> sizes =
      quick ? std::vector<std::size_t>{40, 80} : std::vector<std::size_t>{80, 160, 320};
  return {sphere, quadric("paraboloid, apex", 1., 0., sizes),
          quadric("paraboloid, x = 0.3", 1., 0.3, sizes), quadric("saddle", -1., 0., sizes)};
}

constexpr double metric_radius = 0.6;

// Computes the metrics of the faces around a base up to a radius, in normal coordinates.
template <typename Method>
std::vector<test::Face_metric> metrics(const Mesh& mesh, Vertex base, double radius = metric_radius)
{
  GP::Logarithmic_map<Mesh, Method> map(mesh);
  map.compute(
      base, GP::parameters::maximum_distance(radius + 0.05).stencil_length(theory_stencil_length));
  return test::metrics_around(mesh, map, 0.02, radius);
}

// Adds a row for each mesh, and rows of smaller radii for the finest mesh.
template <typename Method>
void add_metric_rows(Table& table, const std::string& method, const Curved_surface& surface)
{
  const auto add = [&](std::size_t i, double radius)
  {
    const auto found =
        test::fitted_metric(metrics<Method>(surface.meshes[i], surface.bases[i], radius));
    const auto& q = found.quadratic;
    const double other = std::max({std::fabs(q[0][0]), std::fabs(q[0][1]), std::fabs(q[1][0]),
                                   std::fabs(q[1][2]), std::fabs(q[2][1]), std::fabs(q[2][2])});
    const auto [constant, linear] = test::base_errors(found);
    table.add({surface.name, method, std::to_string(num_vertices(surface.meshes[i])),
               format_fixed(radius, 1), format_fixed(surface.curvatures[i] / 3., 4),
               format_fixed(q[0][2], 4), format_fixed(q[1][1], 4), format_fixed(q[2][0], 4),
               format_significant(other), format_significant(constant),
               format_significant(linear)});
  };
  for(std::size_t i = 0; i < surface.meshes.size(); ++i)
    add(i, metric_radius);
  for(const double radius : {0.4, 0.3})
    add(surface.meshes.size() - 1, radius);
}

// Returns root mean squares over the faces in an interval of distances: of the difference of the
// metric from the unit matrix, and from its second-order expansion (Frobenius norms).
std::array<double, 2> metric_residuals(const std::vector<test::Face_metric>& faces, double k,
                                       double from, double to)
{
  std::array<double, 2> result = {0., 0.};
  double area = 0.;
  for(const test::Face_metric& face : faces)
  {
    const double distance = std::hypot(face.center[0], face.center[1]);
    if(distance < from || distance > to)
      continue;
    area += face.area;
    for(const int order : {0, 1})
    {
      const auto expected = test::expanded_metric(order * k, face.center);
      const double d11 = face.entry[0] - expected[0], d12 = face.entry[1] - expected[1],
                   d22 = face.entry[2] - expected[2];
      result[std::size_t(order)] += face.area * (d11 * d11 + 2. * d12 * d12 + d22 * d22);
    }
  }
  return {std::sqrt(result[0] / area), std::sqrt(result[1] / area)};
}

template <typename Method>
void add_residual_rows(Table& table, const std::string& method, const Curved_surface& surface)
{
  for(std::size_t i = 0; i < surface.meshes.size(); ++i)
  {
    const auto faces = metrics<Method>(surface.meshes[i], surface.bases[i]);
    std::vector<std::string> row = {surface.name, method,
                                    std::to_string(num_vertices(surface.meshes[i]))};
    for(const double distance : {0.1, 0.2, 0.4, 0.6})
    {
      const auto residuals =
          metric_residuals(faces, surface.curvatures[i], 0.8 * distance, distance);
      row.push_back(format_significant(residuals[0]) + " / " + format_significant(residuals[1]));
    }
    table.add(row);
  }
}

// Prints the mean metric of the faces around three locations of the sphere as a matrix.
void print_metric_matrices(const Curved_surface& sphere)
{
  std::printf("Metric tensors (A A^T)^-1 on the sphere as g11 g12 g22: means over the faces whose "
              "centers are at most\n0.05 from u, of the measured metrics, of the second-order "
              "expansion, and of the metric of the sphere\n");
  Table table({"u", "vertices", "Gradient", "Exact", "expansion", "sphere"});
  const auto format = [](const std::array<double, 3>& g)
  { return format_fixed(g[0], 4) + " " + format_fixed(g[1], 4) + " " + format_fixed(g[2], 4); };
  const auto gradient = metrics<GP::Gradient<>>(sphere.meshes.back(), sphere.bases.back()),
             exact = metrics<GP::Exact>(sphere.meshes.back(), sphere.bases.back());
  for(const auto& [u, v] : {std::pair{0.1, 0.}, {0.4, 0.}, {0.3, 0.3}, {0., 0.5}})
  {
    const auto mean = [u = u, v = v](const auto& faces, auto entries)
    {
      std::array<double, 3> result = {0., 0., 0.};
      double area = 0.;
      for(const test::Face_metric& face : faces)
        if(std::hypot(face.center[0] - u, face.center[1] - v) <= 0.05)
        {
          area += face.area;
          for(std::size_t i = 0; i < 3; ++i)
            result[i] += face.area * entries(face)[i];
        }
      for(double& entry : result)
        entry /= area;
      return result;
    };
    const auto measured = [](const test::Face_metric& face) { return face.entry; };
    const auto expansion = [](const test::Face_metric& face)
    { return test::expanded_metric(1., face.center); };
    // 1 in the direction of u and (sin r / r)^2 normal to it.
    const auto closed_form = [](const test::Face_metric& face)
    {
      const double r = std::hypot(face.center[0], face.center[1]),
                   c = (1. - std::pow(std::sin(r) / r, 2)) / (r * r);
      return test::expanded_metric(3. * c, face.center);
    };
    table.add({format_fixed(u, 1) + ", " + format_fixed(v, 1),
               std::to_string(num_vertices(sphere.meshes.back())), format(mean(gradient, measured)),
               format(mean(exact, measured)), format(mean(exact, expansion)),
               format(mean(exact, closed_form))});
  }
  table.print();
}

void compare_metrics(bool quick)
{
  std::printf(
      "Metric in normal coordinates: Taylor coefficients of its entries, fitted to the faces "
      "within a radius\nby polynomials of degree four. In theory, the coefficient of v^2 "
      "in g11 and of u^2 in g22 is -K/3,\nthat of uv in g12 is K/3, all other second-order "
      "coefficients are zero, the constant is the unit matrix, and\nthe linear terms vanish. The "
      "last three columns are the largest deviations.\n");
  const std::vector<Curved_surface> surfaces = curved_surfaces(quick);
  Table coefficients({"surface", "method", "vertices", "radius", "K/3", "g11 v^2", "g12 uv",
                      "g22 u^2", "other", "constant", "linear"});
  Table residuals({"surface", "method", "vertices", "0.1", "0.2", "0.4", "0.6"});
  for(const Curved_surface& surface : surfaces)
  {
    add_metric_rows<GP::Gradient<>>(coefficients, "Gradient", surface);
    add_metric_rows<GP::Exact>(coefficients, "Exact", surface);
    add_residual_rows<GP::Gradient<>>(residuals, "Gradient", surface);
    add_residual_rows<GP::Exact>(residuals, "Exact", surface);
  }
  coefficients.print();
  std::printf("Metric in normal coordinates by distance r from the base: root mean square "
              "differences of faces between\n0.8 r and r from the unit matrix / from the "
              "second-order expansion\n");
  residuals.print();
  print_metric_matrices(surfaces.front());
}

// Returns the part of a sphere within `radius` of its first vertex, which keeps index 0.
test::Triangulation spherical_cap(unsigned level, double radius)
{
  const test::Triangulation sphere = test::icosphere(level);
  const GP::internal::Vec3 pole = sphere.points[0];
  std::vector<GP::internal::Index> new_index(sphere.points.size(), GP::internal::none);
  test::Triangulation result;
  for(std::size_t i = 0; i < sphere.points.size(); ++i)
    if(GP::internal::dot(sphere.points[i], pole) > std::cos(radius))
    {
      new_index[i] = GP::internal::Index(result.points.size());
      result.points.push_back(sphere.points[i]);
    }
  for(std::size_t c = 0; c < sphere.corners.size(); c += 3)
  {
    const auto* corner = &sphere.corners[c];
    if(new_index[corner[0]] != GP::internal::none && new_index[corner[1]] != GP::internal::none &&
       new_index[corner[2]] != GP::internal::none)
      result.corners.insert(result.corners.end(),
                            {new_index[corner[0]], new_index[corner[1]], new_index[corner[2]]});
  }
  return result;
}

// Returns the least squares conformal map. It is translated and scaled to agree with normal
// coordinates at the base.
std::vector<std::array<double, 2>> conformal_map(Mesh mesh, Vertex base)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  auto uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  SMP::parameterize(mesh, SMP::LSCM_parameterizer_3<Mesh>(), border, uv);
  double images = 0., edges = 0.;
  for(const Vertex v : vertices_around_target(base, mesh))
  {
    images += std::sqrt(squared_distance(uv[v], uv[base]));
    edges += std::sqrt(squared_distance(mesh.point(v), mesh.point(base)));
  }
  std::vector<std::array<double, 2>> result;
  for(const Vertex v : mesh.vertices())
  {
    const auto offset = edges / images * (uv[v] - uv[base]);
    result.push_back({offset.x(), offset.y()});
  }
  return result;
}

void compare_linearity(bool quick)
{
  std::printf(
      "Optimality on spherical caps: sup |d(x,y) - |f(x) - f(y)|| / |f(y)|^2 over neighbors "
      "y of the base and\nvertices x within a distance of 0.6. Only normal coordinates have "
      "a bounded supremum.\n");
  Table table({"vertices", "edge length", "Exact", "Gradient", "orthogonal projection", "LSCM"});
  for(unsigned level = 3; level <= (quick ? 5u : 6u); ++level)
  {
    const Mesh mesh = mesh_of(spherical_cap(level, 0.8));
    const Vertex base(0);
    const auto limits = GP::parameters::maximum_distance(0.7);
    GP::Logarithmic_map<Mesh, GP::Exact> exact(mesh);
    GP::Logarithmic_map<Mesh> gradient(exact.domain());
    exact.compute(base, limits);
    gradient.compute(base, limits.stencil_length(theory_stencil_length));
    const auto frame = exact.frame();
    const auto conformal = conformal_map(mesh, base);
    const auto format_departure = [&](const auto& f)
    { return format_significant(test::departure_from_linearity(mesh, base, 0.6, f)); };
    table.add({std::to_string(num_vertices(mesh)), format_significant(mean_edge_length(mesh)),
               format_departure(exact), format_departure(gradient),
               format_departure(
                   [&](Vertex v)
                   {
                     const auto offset = mesh.point(v) - frame.origin;
                     return std::array<double, 2>{offset * frame.u, offset * frame.v};
                   }),
               format_departure([&](Vertex v) { return conformal[v]; })});
  }
  table.print();
}

void compare_on_cylinder()
{
  std::printf(
      "Cylinder of radius 1, within a distance of 1: mean of each measure minus its value for an "
      "isometry\n");
  const Mesh mesh = mesh_of(test::cylinder(120, 60, 1., 4.));
  const Vertex base(120 * 30);
  GP::Logarithmic_map<Mesh, GP::Exact> exact(mesh);
  GP::Logarithmic_map<Mesh> gradient(exact.domain());
  exact.compute(base, GP::parameters::maximum_distance(1.));
  gradient.compute(base, GP::parameters::maximum_distance(1.));
  const auto frame = exact.frame();
  Table table({"measure", "Gradient", "Exact", "orthogonal projection"});
  for(const Measure_asymptotics& measure : test::measure_asymptotics())
  {
    const auto format_difference = [&](const auto& f)
    {
      const auto uv = boost::make_function_property_map<Vertex>(f);
      return format_significant(
          std::fabs(GP::surface_distortion(mesh, uv, measure.measure).mean() - measure.at_base));
    };
    table.add({measure.name, format_difference([&](Vertex v) { return gradient(v); }),
               format_difference([&](Vertex v) { return exact(v); }),
               format_difference(
                   [&](Vertex v)
                   {
                     const auto offset = mesh.point(v) - frame.origin;
                     const double outside = exact.is_inside(v) ? 0. : std::nan("");
                     return std::array<double, 2>{offset * frame.u + outside, offset * frame.v};
                   })});
  }
  table.print();
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
void add_length_row(Table& table, const std::string& name, GP::internal::Distance_method method,
                    double noise, const Mesh& mesh, const std::vector<double>& rings)
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
  Table table({"noise %", "method", "distance", "fitted length, 0.6 rings", "1 ring", "2 rings",
               "3 rings", "4 rings"});
  using Method = GP::internal::Distance_method;
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
  Table table({"noise %", "method", "default stencil", "1 ring", "2 rings", "3 rings"});
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

// logmap [--quick | noise | metric]
int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  std::printf("Normal coordinates\n\n");
  if(argc > 1 && std::strcmp(argv[1], "noise") == 0)
    return compare_noise(5), compare_lengths(5), 0;
  if(argc > 1 && std::strcmp(argv[1], "metric") == 0)
    return compare_metrics(false), 0;
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
  compare_with_theory(quick);
  compare_metrics(quick);
  compare_linearity(quick);
  compare_on_cylinder();
  compare_noise(quick ? 4 : 5);
  compare_lengths(quick ? 4 : 5);
}
