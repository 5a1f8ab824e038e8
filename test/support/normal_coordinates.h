// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_NORMAL_COORDINATES_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_NORMAL_COORDINATES_H

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/distortion.h>

#include "triangulations.h"

#include <CGAL/Origin.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/function_property_map.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

// Exact results about normal coordinates: formulas on surfaces of constant curvature, and the
// asymptotics of their distortion.

namespace CGAL::Geodesic_processing::test {

// Returns the logarithm of a point of the unit sphere at the origin of a frame. The plane of the
// frame is tangent to a mesh, so its vectors are first projected to the tangent plane of the
// sphere.
template <typename Frame, typename Point_3>
std::array<double, 2> vector_on_sphere(const Frame& frame, const Point_3& p)
{
  const auto base = frame.origin - CGAL::ORIGIN, to = p - CGAL::ORIGIN,
             across = to - (to * base) * base;
  const double u = across * frame.u, v = across * frame.v, size = std::hypot(u, v);
  const double angle = std::atan2(std::sqrt(across * across), to * base);
  return size > 0. ? std::array<double, 2>{angle * u / size, angle * v / size}
                   : std::array<double, 2>{0., 0.};
}

// Returns the mean error of a logarithmic map of the unit sphere, relative to the distance, over
// all vertices that it reached.
//
// point: the point of a vertex
template <typename Map, typename PointOf>
double mean_error_on_sphere(const Map& map, PointOf point)
{
  const auto frame = map.frame();
  double sum = 0., number = 0.;
  for(const auto& v : map.reached())
  {
    const auto truth = vector_on_sphere(frame, point(v)), found = map(v);
    const double distance = std::hypot(truth[0], truth[1]);
    if(distance < 1e-9) // the base point itself, up to round-off errors
      continue;
    sum += std::hypot(found[0] - truth[0], found[1] - truth[1]) / distance;
    ++number;
  }
  return sum / number;
}

// A square patch of the pseudosphere, of curvature -1, as a grid of n x n squares in normal
// coordinates (n is even). The coordinates reach 0.6 along the axes, and `base` is the center. In
// the upper half-plane model, of which the pseudosphere is the part above 1, the base is at (0,
// 2.4).
struct Hyperbolic_patch
{
  Triangulation surface;
  Index base;
};
inline Hyperbolic_patch hyperbolic_patch(std::size_t n, double jitter)
{
  const auto position_at = [](double s, double t) -> Point
  {
    const double u = 0.6 * (2. * s - 1.), v = 0.6 * (2. * t - 1.), r = std::hypot(u, v);
    const double cosine = r > 0. ? u / r : 1., sine = r > 0. ? v / r : 0.;
    // Along the semicircle that leaves the base in this direction.
    const double below = std::cosh(r) - sine * std::sinh(r);
    const double x = 2.4 * cosine * std::sinh(r) / below, y = 2.4 / below;
    return {std::cos(x) / y, std::sin(x) / y, std::acosh(y) - std::sqrt(1. - 1. / (y * y))};
  };
  return {grid(n, n, position_at, jitter), Index((n + 1) * (n / 2) + n / 2)};
}

// The asymptotics of a distortion measure m near the origin of normal coordinates: m = at_base + c
// |u|^power + O(|u|^(power+2)).
struct Measure_asymptotics
{
  const char* name;
  std::function<double(const Face_distortion&)> measure;
  double at_base;
  int power;
  std::function<double(double)> coefficient; // c as a function of the curvature at the base
};

inline std::vector<Measure_asymptotics> measure_asymptotics()
{
  using D = Face_distortion;
  using std::fabs;
  return {
      {"mips", &D::mips, 1., 2, [](double k) { return fabs(k) / 6.; }},
      {"symmetric_mips", &D::symmetric_mips, 2., 4, [](double k) { return k * k / 36.; }},
      {"conformal", &D::conformal, 0., 4, [](double k) { return k * k / 72.; }},
      {"green_lagrange", &D::green_lagrange, 0., 4, [](double k) { return k * k / 9.; }},
      {"combined(1)", [](const D& d) { return d.combined(1.); }, 4., 4,
       [](double k) { return k * k / 9.; }},
      {"dirichlet", &D::dirichlet, 1., 2, [](double k) { return -k / 6.; }},
      {"l2_stretch", &D::l2_stretch, 1., 2, [](double k) { return -k / 12.; }},
      {"linf_stretch", &D::linf_stretch, 1., 2, [](double k) { return std::max(-k, 0.) / 6.; }},
      {"symmetric_stretch", &D::symmetric_stretch, 1., 2, [](double k) { return fabs(k) / 6.; }},
      {"riemannian", &D::riemannian, 0., 2, [](double k) { return fabs(k) / 3.; }},
  };
}

// The distortion of a face, and its distance from the base.
struct Distorted_face
{
  double distance;
  Face_distortion distortion;
};

// Returns the faces of a mesh whose distance from the base of a map is in an interval.
template <typename Mesh, typename Map>
std::vector<Distorted_face> faces_around(const Mesh& mesh, const Map& map, double from, double to)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  const auto uv = boost::make_function_property_map<Vertex>([&](Vertex v) { return map(v); });
  std::vector<Distorted_face> result;
  for(const auto face : faces(mesh))
  {
    std::array<double, 2> center = {0., 0.};
    for(const Vertex v : vertices_around_face(halfedge(face, mesh), mesh))
      for(int k = 0; k < 2; ++k)
        center[k] += map(v)[k] / 3.;
    const double distance = std::hypot(center[0], center[1]);
    if(distance >= from && distance <= to) // false for NaN
      result.push_back({distance, face_distortion(face, mesh, uv)});
  }
  return result;
}

// Fits the coefficient c of a measure: least squares over the faces with c |u|^power + c'
// |u|^(power+2).
inline double fitted_coefficient(const Measure_asymptotics& measure,
                                 const std::vector<Distorted_face>& faces)
{
  double aa = 0., ab = 0., bb = 0., ay = 0., by = 0.;
  for(const Distorted_face& face : faces)
  {
    const double a = std::pow(face.distance, measure.power), b = a * face.distance * face.distance;
    const double y = measure.measure(face.distortion) - measure.at_base,
                 weight = face.distortion.area;
    aa += weight * a * a;
    ab += weight * a * b;
    bb += weight * b * b;
    ay += weight * a * y;
    by += weight * b * y;
  }
  return (ay * bb - by * ab) / (aa * bb - ab * ab);
}

// The metric of a map in a face.
struct Face_metric
{
  std::array<double, 2> center; // the image of the centroid
  std::array<double, 3> entry;  // g_11, g_12 and g_22
  double area;                  // of the image
};

// Returns the metrics G = (A A^T)^-1 of the faces whose distance from the base of a map is in an
// interval, where A maps the edge vectors of a face to those of its image. If the columns of X and
// U are two edge vectors and their images, A = U (X^T X)^-1 X^T and G = U^-T X^T X U^-1.
template <typename Mesh, typename Map>
std::vector<Face_metric> metrics_around(const Mesh& mesh, const Map& map, double from, double to)
{
  const auto points = get(CGAL::vertex_point, mesh);
  std::vector<Face_metric> result;
  for(const auto face : faces(mesh))
  {
    const auto h = halfedge(face, mesh);
    const std::array corner = {source(h, mesh), target(h, mesh), target(next(h, mesh), mesh)};
    Eigen::Matrix2d images, squares;
    std::array<double, 2> center = {0., 0.};
    for(int i = 0; i < 2; ++i)
    {
      for(int j = 0; j < 2; ++j)
      {
        images(i, j) = map(corner[j + 1])[i] - map(corner[0])[i];
        squares(i, j) = (get(points, corner[i + 1]) - get(points, corner[0])) *
                        (get(points, corner[j + 1]) - get(points, corner[0]));
      }
      center[i] = (map(corner[0])[i] + map(corner[1])[i] + map(corner[2])[i]) / 3.;
    }
    const double distance = std::hypot(center[0], center[1]);
    if(!(distance >= from && distance <= to)) // true for NaN
      continue;
    const Eigen::Matrix2d inverse = images.inverse();
    const Eigen::Matrix2d g = inverse.transpose() * squares * inverse;
    result.push_back({center, {g(0, 0), g(0, 1), g(1, 1)}, std::fabs(images.determinant()) / 2.});
  }
  return result;
}

// The second-order expansion of the metric in normal coordinates, I - 1/3 R_ikjl u^k u^l, at the
// coordinates u: the entries 11, 12 and 22 for Gaussian curvature k at the base.
inline std::array<double, 3> expanded_metric(double k, const std::array<double, 2>& u)
{
  return {1. - k / 3. * u[1] * u[1], k / 3. * u[0] * u[1], 1. - k / 3. * u[0] * u[0]};
}

// The Taylor coefficients of the entries 11, 12 and 22 of a metric at the base.
struct Metric_expansion
{
  std::array<double, 3> constant;
  std::array<std::array<double, 2>, 3> linear;    // of u_1 and u_2
  std::array<std::array<double, 3>, 3> quadratic; // of u_1^2, u_1 u_2 and u_2^2
};

// Fits polynomials of degree four to the entries, by least squares weighted by area.
inline Metric_expansion fitted_metric(const std::vector<Face_metric>& faces)
{
  constexpr int number_of_terms = 15;
  Eigen::MatrixXd terms(faces.size(), number_of_terms), entries(faces.size(), 3);
  for(std::size_t f = 0; f < faces.size(); ++f)
  {
    const double weight = std::sqrt(faces[f].area);
    const auto row = Eigen::Index(f);
    int column = 0;
    for(int degree = 0; degree <= 4; ++degree)
      for(int k = 0; k <= degree; ++k)
        terms(row, column++) =
            weight * std::pow(faces[f].center[0], degree - k) * std::pow(faces[f].center[1], k);
    for(int i = 0; i < 3; ++i)
      entries(row, i) = weight * faces[f].entry[std::size_t(i)];
  }
  const Eigen::MatrixXd solution = terms.householderQr().solve(entries);
  Metric_expansion result;
  for(int i = 0; i < 3; ++i)
  {
    const auto e = std::size_t(i);
    result.constant[e] = solution(0, i);
    result.linear[e] = {solution(1, i), solution(2, i)};
    result.quadratic[e] = {solution(3, i), solution(4, i), solution(5, i)};
  }
  return result;
}

// Returns the largest difference of the quadratic coefficients from those of expanded_metric().
inline double quadratic_error(const Metric_expansion& found, double k)
{
  const double c = k / 3.;
  const std::array<std::array<double, 3>, 3> expected = {{{0., 0., -c}, {0., c, 0.}, {-c, 0., 0.}}};
  double result = 0.;
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      result = std::max(result, std::fabs(found.quadratic[i][j] - expected[i][j]));
  return result;
}

// Returns the largest difference of the metric at the base from the unit matrix, and the largest
// first derivative.
inline std::array<double, 2> base_errors(const Metric_expansion& found)
{
  const std::array<double, 3> unit_matrix = {1., 0., 1.};
  std::array<double, 2> result = {0., 0.};
  for(int i = 0; i < 3; ++i)
  {
    result[0] = std::max(result[0], std::fabs(found.constant[i] - unit_matrix[i]));
    for(const double derivative : found.linear[i])
      result[1] = std::max(result[1], std::fabs(derivative));
  }
  return result;
}

// Returns the maximum of |d(x, y) - |f(x) - f(y)|| / |f(y)|^2 over the neighbors y of the base and
// all vertices x up to a radius, with f(base) = 0. Only for normal coordinates f it stays bounded
// as edges get shorter.
template <typename Mesh, typename Vertex, typename Map>
double departure_from_linearity(const Mesh& mesh, Vertex base, double radius, const Map& f)
{
  Geodesic_distance_solver<Mesh, Exact> from_base(mesh), solver(from_base.domain());
  from_base.compute(base, parameters::maximum_distance(radius));
  double result = 0.;
  for(const Vertex y : vertices_around_target(base, mesh))
  {
    solver.compute(y);
    for(const Vertex x : from_base.reached())
    {
      const double image = std::hypot(f(x)[0] - f(y)[0], f(x)[1] - f(y)[1]);
      result = std::max(result, std::fabs(solver.distance(x) - image) /
                                    (f(y)[0] * f(y)[0] + f(y)[1] * f(y)[1]));
    }
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_NORMAL_COORDINATES_H
