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
