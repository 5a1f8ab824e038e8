// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the distortion of normal coordinates with its theory.
#include <CGAL/Geodesic_processing.h>

#include "models.h"
#include "normal_coordinates.h"
#include "report.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <complex>
#include <cstring>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;
namespace test = CGAL::Geodesic_processing::test;
using test::Measure_asymptotics;
using Complex = std::complex<double>;
using Size = Mesh::size_type;

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
  Table table("coefficients of measures",
              {"measure", "m", "K = 1", "Gradient, K = 1", "Exact, K = 1", "K = -1",
               "Gradient, K = -1", "Exact, K = -1"});
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
  Table table("metric on the sphere",
              {"u", "vertices", "Gradient", "Exact", "expansion", "sphere"});
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
  Table coefficients("Taylor coefficients of the metric",
                     {"surface", "method", "vertices", "radius", "K/3", "g11 v^2", "g12 uv",
                      "g22 u^2", "other", "constant", "linear"});
  Table residuals("deviation of the metric",
                  {"surface", "method", "vertices", "0.1", "0.2", "0.4", "0.6"});
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
  Table table("optimality",
              {"vertices", "edge length", "Exact", "Gradient", "orthogonal projection", "LSCM"});
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
  Table table("cylinder", {"measure", "Gradient", "Exact", "orthogonal projection"});
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

} // namespace

// distortion [--quick | metric]
int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  std::printf("Distortion of normal coordinates\n\n");
  if(argc > 1 && std::strcmp(argv[1], "metric") == 0)
    return compare_metrics(false), 0;
  compare_with_theory(quick);
  compare_metrics(quick);
  compare_linearity(quick);
  compare_on_cylinder();
}
