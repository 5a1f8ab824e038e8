// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_curves.h>

#include <CGAL/Geodesic_processing/geodesic_path.h>
#include <CGAL/Geodesic_processing/locate_on_surface.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include "Mesh_of.h"
#include "rough_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_curves_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using GP::internal::dot;
using GP::internal::norm;
using GP::internal::unit;
using GP::internal::operator*;
using GP::internal::operator+;
using GP::internal::operator-;
using GP::internal::Vec3;
using Point_3 = Kernel::Point_3;
using Curve = GP::Surface_path<Mesh>;

// Round-off errors of points after a few steps of midpoints, with the errors of shortest paths
// (2e-12).
constexpr double round_off = 1e-10;

Vec3 to_vec(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

double distance_to_curve(const Vec3& p, const Curve& curve)
{
  double result = GP::internal::infinity;
  for(std::size_t i = 0; i + 1 < curve.points.size(); ++i)
  {
    const Vec3 a = to_vec(curve.points[i]), step = to_vec(curve.points[i + 1]) - a;
    const double t = std::clamp(dot(p - a, step) / dot(step, step), 0., 1.);
    result = std::min(result, norm(p - (a + t * step)));
  }
  return result;
}

// Returns the largest distance of a vertex of one curve from the other one.
double difference(const Curve& a, const Curve& b)
{
  double result = 0.;
  for(const Point_3& p : a.points)
    result = std::max(result, distance_to_curve(to_vec(p), b));
  return result;
}

TEST(geodesic_curves, in_the_plane_are_polynomial)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Mesh mesh = mesh_of(scaled(square(10, 0.24), scale));
    const std::vector<Vec3> p = {{0.1, 0.2, 0.}, {0.3, 0.9, 0.}, {0.8, 0.7, 0.}, {0.9, 0.1, 0.}};
    std::vector<GP::Location<Mesh>> control;
    for(const Vec3& point : p)
      control.push_back(
          GP::locate_on_surface(mesh, Point_3(scale * point[0], scale * point[1], 0.)));
    const Curve bezier = GP::geodesic_bezier_curve(mesh, control);
    const Curve spline = GP::geodesic_spline(
        mesh, control, GP::parameters::is_closed(true).degree(2).number_of_subdivisions(7));
    for(int i = 0; i <= 64; ++i)
    {
      const double t = i / 64., s = 1. - t;
      const Vec3 on_bezier =
          s * s * s * p[0] + 3. * s * s * t * p[1] + 3. * s * t * t * p[2] + t * t * t * p[3];
      EXPECT_LT(distance_to_curve(scale * on_bezier, bezier), round_off * scale);
      // A quadratic B-spline differs from its control polygon by at most 1/8 of the second
      // difference, which is at most 4 sqrt(2) / 4^7 here.
      const Vec3 on_spline =
          0.5 * (s * s * p[0] + (1. + 2. * t - 2. * t * t) * p[1] + t * t * p[2]);
      EXPECT_LT(distance_to_curve(scale * on_spline, spline), std::sqrt(0.5) / 16384. * scale);
    }
    EXPECT_EQ(spline.points.front(), spline.points.back());
    EXPECT_EQ(bezier.locations.size(), bezier.points.size());
    EXPECT_EQ(bezier.front_distance, bezier.length);
    EXPECT_LE(bezier.lower, bezier.length);
  }
}

TEST(geodesic_curves, interpolate_end_points_and_tangents)
{
  const Mesh mesh = mesh_of(icosphere(4));
  const auto domain = GP::make_domain(mesh);
  std::vector<Vertex> control = {Vertex(0), Vertex(1), Vertex(2), Vertex(3)};
  const auto np = GP::parameters::number_of_subdivisions(9);
  for(const Curve& curve :
      {GP::geodesic_bezier_curve(domain, control, np), GP::geodesic_spline(domain, control, np)})
  {
    EXPECT_LT(norm(to_vec(curve.points.front()) - to_vec(mesh.point(control.front()))), round_off);
    EXPECT_LT(norm(to_vec(curve.points.back()) - to_vec(mesh.point(control.back()))), round_off);
    const auto first = GP::geodesic_path(domain, control[0], control[1]);
    const Vec3 tangent = unit(to_vec(first.points[1]) - to_vec(first.points[0]));
    const Vec3 start = unit(to_vec(curve.points[1]) - to_vec(curve.points[0]));
    // The angle between the first chord and the tangent is half of the angle by which a segment
    // turns. The curve turns by less than 2 pi, in 512 segments.
    EXPECT_GT(dot(tangent, start), std::cos(2. * pi / 512.));
  }
}

// The curves converge quadratically to the limit. Where few edges are between shortest paths, the
// corners of the surface reduce the rate.
TEST(geodesic_curves, converge_under_subdivision)
{
  std::vector<std::pair<std::string, Mesh>> surfaces = {{"square", mesh_of(square(12, 0.24))},
                                                        {"sphere", mesh_of(icosphere(4))},
                                                        {"animal", mesh_of(animal(4))}};
  add_models(surfaces, {"meshes/kitten_9k.ply"});
  for(const auto& [name, mesh] : surfaces)
  {
    SCOPED_TRACE(name);
    const auto domain = GP::make_domain(mesh);
    const unsigned n = unsigned(num_vertices(mesh));
    const std::vector<Vertex> control = {Vertex(n / 7), Vertex(n / 3), Vertex(n / 2)};
    for(const bool is_spline : {false, true})
    {
      std::vector<Curve> curves;
      for(const unsigned k : {1u, 2u, 3u, 4u, 5u})
      {
        const auto np = GP::parameters::number_of_subdivisions(k);
        curves.push_back(is_spline ? GP::geodesic_spline(domain, control, np)
                                   : GP::geodesic_bezier_curve(domain, control, np));
      }
      // Three subdivisions divide the difference by 64 in the limit.
      const double first = difference(curves[1], curves[0]),
                   last = difference(curves[4], curves[3]);
      EXPECT_LT(last, first / 20.);
    }
  }
}

TEST(geodesic_curves, follow_the_boundary)
{
  const Mesh mesh = mesh_of(annulus(24, 4, 1., 2.));
  // Paths between these vertices of the inner boundary run along it.
  const std::vector<Vertex> control = {Vertex(96), Vertex(100), Vertex(104)};
  const Curve curve = GP::geodesic_bezier_curve(mesh, control);
  ASSERT_FALSE(curve.empty());
  for(const Point_3& p : curve.points)
    EXPECT_NEAR(norm(to_vec(p)), 1., 1. - std::cos(pi / 24.) + round_off); // chords of the polygon
}

TEST(geodesic_curves, accept_polyhedra)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Numbered<Polyhedron> mesh;
  fill(mesh, square(4));
  const std::vector<Polyhedron::Vertex_handle> control = {mesh.vertices[0], mesh.vertices[12],
                                                          mesh.vertices[24]};
  // The control points are on the diagonal.
  EXPECT_NEAR(GP::geodesic_bezier_curve(mesh.mesh, control).length, std::sqrt(2.), round_off);
  EXPECT_NEAR(GP::geodesic_spline(mesh.mesh, control).length, std::sqrt(2.), round_off);
}

TEST(geodesic_curves, throw_on_invalid_input)
{
  const Mesh mesh = mesh_of(disjoint_union(square(2), square(2)));
  const std::vector<Vertex> control = {Vertex(0), Vertex(4), Vertex(8)};
  const std::vector<Vertex> apart = {Vertex(0), Vertex(9)};
  EXPECT_THROW(GP::geodesic_bezier_curve(mesh, std::vector<Vertex>{Vertex(0)}),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_bezier_curve(mesh, apart), GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_spline(mesh, apart), GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_spline(mesh, control, GP::parameters::degree(0)),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_bezier_curve(mesh, control, GP::parameters::number_of_subdivisions(21)),
               GP::Invalid_argument_error);
  EXPECT_THROW(
      GP::geodesic_spline(mesh, control, GP::parameters::callback([](double) { return false; })),
      GP::Cancelled);
}

} // namespace geodesic_curves_test
