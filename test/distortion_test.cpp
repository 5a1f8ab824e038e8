// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/distortion.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/property_map.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace distortion_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Halfedge = Mesh::Halfedge_index;
using UV = std::array<double, 2>;

TEST(distortion, measures_match_the_literature)
{
  const GP::Face_distortion d{2., 0.5, false, 1.};
  EXPECT_DOUBLE_EQ(d.mips(), 4.);
  EXPECT_DOUBLE_EQ(d.symmetric_mips(), 4.25);
  EXPECT_DOUBLE_EQ(d.conformal(), 1.125);
  EXPECT_DOUBLE_EQ(d.green_lagrange(), 9. + 0.5625);
  EXPECT_DOUBLE_EQ(d.combined(1.), 8.5); // areas are preserved
  EXPECT_DOUBLE_EQ(d.dirichlet(), 2.125);
  EXPECT_DOUBLE_EQ(d.l2_stretch(), std::sqrt(2.125));
  EXPECT_DOUBLE_EQ(d.linf_stretch(), 2.);
  EXPECT_DOUBLE_EQ(d.symmetric_stretch(), 2.);
  EXPECT_DOUBLE_EQ(d.riemannian(), 2. * std::sqrt(2.) * std::log(2.));
  const GP::Face_distortion none{};
  EXPECT_EQ(none.mips(), 1.);
  EXPECT_EQ(none.symmetric_mips(), 2.);
  EXPECT_EQ(none.conformal(), 0.);
  EXPECT_EQ(none.green_lagrange(), 0.);
  EXPECT_EQ(none.combined(3.), 16.);
  EXPECT_EQ(none.riemannian(), 0.);
}

// Near its pole, the normal map of a sphere distorts by known coefficients of |u|^2 or |u|^4. They
// follow from the curvature (Gauss's lemma and the sine of the distance).
TEST(distortion, distortion_of_normal_coordinates_follows_curvature)
{
  // A cap in normal coordinates, whose vertices lie on rings 0.01 apart.
  const Triangulation cap = rings(
      400, 29, [](double s) { return std::sin(0.01 + 0.29 * s); },
      [](double s) { return std::cos(0.01 + 0.29 * s); });
  Mesh mesh = mesh_of(cap);
  const auto uv = mesh.add_property_map<Vertex, UV>("v:uv").first;
  for(const Vertex v : mesh.vertices())
  {
    const auto& p = mesh.point(v);
    const double size = std::hypot(p.x(), p.y()), r = std::atan2(size, p.z());
    uv[v] = size > 0. ? UV{r * p.x() / size, r * p.y() / size} : UV{0., 0.};
  }
  const auto largest = [&](auto measure)
  { return GP::surface_distortion(mesh, uv, measure).worst; };
  const double r = 0.3, square = r * r, fourth = square * square;
  using D = GP::Face_distortion;
  // The next order contributes at most r^2 / 10, i.e. 1 %. A ring is 3 % of the radius, i.e. 7 %
  // of its square.
  const double square_error = 0.07 * square, fourth_error = 0.14 * fourth;
  EXPECT_NEAR(largest(&D::mips) - 1., square / 6., square_error / 6.);
  EXPECT_NEAR(largest(&D::conformal), fourth / 72., fourth_error / 72.);
  EXPECT_NEAR(largest(&D::green_lagrange), fourth / 9., fourth_error / 9.);
  EXPECT_NEAR(largest(&D::riemannian), square / 3., square_error / 3.);
  EXPECT_NEAR(largest(&D::symmetric_stretch) - 1., square / 6., square_error / 6.);
  EXPECT_NEAR(largest(&D::linf_stretch), 1., 1e-3); // edges are chords of arcs of length 0.01
}

// A mesh and its parallel projection to a plane, as maps of vertices and of corners.
struct Sheared_mesh
{
  Mesh mesh;
  Mesh::Property_map<Vertex, UV> uv;
  Mesh::Property_map<Halfedge, UV> corners;

  explicit Sheared_mesh(const Triangulation& triangulation)
      : mesh(mesh_of(triangulation)), uv(mesh.add_property_map<Vertex, UV>("v:uv").first),
        corners(mesh.add_property_map<Halfedge, UV>("h:uv").first)
  {
    for(const Vertex v : mesh.vertices())
      uv[v] = {mesh.point(v).x(), mesh.point(v).y() + 0.3 * mesh.point(v).z()};
    for(const Halfedge h : mesh.halfedges())
      corners[h] = uv[mesh.target(h)];
  }
};

TEST(distortion, halfedge_and_vertex_maps_agree)
{
  const Sheared_mesh sheared(icosphere(1));
  const auto& [mesh, uv, corners] = sheared;
  for(const Face f : mesh.faces())
  {
    const auto a = GP::face_distortion(f, mesh, uv), b = GP::face_distortion(f, mesh, corners);
    EXPECT_EQ(a.sigma_1, b.sigma_1);
    EXPECT_EQ(a.sigma_2, b.sigma_2);
    EXPECT_EQ(a.is_inverted, b.is_inverted);
  }
}

TEST(distortion, skips_faces_without_finite_image)
{
  Mesh mesh = mesh_of(square(4));
  const auto uv = mesh.add_property_map<Vertex, UV>("v:uv").first;
  for(const Vertex v : mesh.vertices())
    uv[v] = {2. * mesh.point(v).x(), mesh.point(v).y()};
  const auto all = GP::surface_distortion(mesh, uv, &GP::Face_distortion::mips);
  const double round_off = 1e-13; // of sums of 32 terms
  EXPECT_NEAR(all.area, 1., 0.1 * round_off);
  EXPECT_NEAR(all.integral, 2., round_off);
  EXPECT_NEAR(all.mean(), 2., round_off);
  EXPECT_NEAR(all.worst, 2., round_off);
  EXPECT_EQ(all.number_of_triangles, 32u);
  EXPECT_EQ(all.number_of_flips, 0u);
  uv[Vertex(0)] = {std::numeric_limits<double>::quiet_NaN(), 0.};
  EXPECT_LT(GP::surface_distortion(mesh, uv, &GP::Face_distortion::mips).number_of_triangles, 32u);
}

// If the image of a face has no area, all measures are infinite, and faces without area on the
// surface do not count.
TEST(distortion, is_infinite_if_an_image_has_no_area)
{
  GP::Face_distortion flat;
  flat.sigma_1 = flat.sigma_2 = std::numeric_limits<double>::infinity();
  const auto measures = {
      &GP::Face_distortion::mips,         &GP::Face_distortion::symmetric_mips,
      &GP::Face_distortion::conformal,    &GP::Face_distortion::green_lagrange,
      &GP::Face_distortion::dirichlet,    &GP::Face_distortion::l2_stretch,
      &GP::Face_distortion::linf_stretch, &GP::Face_distortion::symmetric_stretch,
      &GP::Face_distortion::riemannian,   &GP::Face_distortion::symmetric_dirichlet};
  Mesh mesh = mesh_of(square(4));
  const auto uv = mesh.add_property_map<Vertex, UV>("v:uv").first;
  const auto expect_infinite = [&](std::size_t flips)
  {
    for(const auto measure : measures)
    {
      EXPECT_EQ((flat.*measure)(), std::numeric_limits<double>::infinity());
      const auto found = GP::surface_distortion(mesh, uv, measure);
      EXPECT_EQ(found.mean(), std::numeric_limits<double>::infinity());
      EXPECT_EQ(found.worst, std::numeric_limits<double>::infinity());
    }
    const GP::Flattening_distortion found = GP::flattening_distortion(mesh, uv);
    EXPECT_EQ(found.number_of_flips, flips);
    for(const double value : {found.conformal, found.authalic, found.symmetric_dirichlet,
                              found.l2_stretch, found.linf_stretch})
      EXPECT_EQ(value, std::numeric_limits<double>::infinity());
  };
  EXPECT_EQ(flat.combined(1.), std::numeric_limits<double>::infinity());
  for(const Vertex v : mesh.vertices())
    uv[v] = {mesh.point(v).x(), mesh.point(v).y()};
  const auto h = halfedge(Face(0), mesh);
  uv[target(h, mesh)] = uv[source(h, mesh)];
  std::size_t flips = 0;
  for(const Face f : mesh.faces())
    flips += std::isinf(GP::face_distortion(f, mesh, uv).sigma_1);
  EXPECT_GT(flips, 0u);
  expect_infinite(flips);
  for(const Vertex v : mesh.vertices())
    uv[v] = {mesh.point(v).x(), 0.};
  expect_infinite(32);
}

TEST(distortion, flattening_distortion_is_scale_invariant)
{
  Mesh mesh = mesh_of(square(6, 0.2));
  const auto uv = mesh.add_property_map<Vertex, UV>("v:uv").first;
  for(const double scale : {1., 0.01})
  {
    // Stretches by 2 along one axis. With equal areas, the stretches are sqrt(2) and its inverse.
    for(const Vertex v : mesh.vertices())
      uv[v] = {2. * scale * mesh.point(v).x(), scale * mesh.point(v).y()};
    const auto found = GP::flattening_distortion(mesh, uv);
    EXPECT_EQ(found.number_of_triangles, 72u);
    EXPECT_EQ(found.number_of_flips, 0u);
    // The conformal error is the root of 2 + 1/2 - 2.
    const double round_off = 1e-12; // of sums of 72 terms
    EXPECT_NEAR(found.conformal, std::sqrt(0.5), round_off);
    EXPECT_NEAR(found.authalic, 0., round_off);
    EXPECT_NEAR(found.symmetric_dirichlet, 5., round_off);
    EXPECT_NEAR(found.l2_stretch, std::sqrt(1.25), round_off);
    EXPECT_NEAR(found.linf_stretch, std::sqrt(2.), round_off);
  }
  for(const Vertex v : mesh.vertices())
    uv[v] = {-mesh.point(v).x(), mesh.point(v).y()};
  EXPECT_EQ(GP::flattening_distortion(mesh, uv).number_of_flips, 72u);
  for(const Vertex v : mesh.vertices())
    uv[v] = {1., 0.};
  EXPECT_EQ(GP::flattening_distortion(mesh, uv).number_of_flips, 72u);
}

// At these scales, areas overflow or underflow.
TEST(distortion, flattening_distortion_does_not_depend_on_units)
{
  for(const double scale : {1., 1e-160, 1e160})
    for(const double image_scale : {1., 1e-160, 1e160})
    {
      Triangulation triangulation = square(6, 0.2);
      for(auto& point : triangulation.points)
        for(double& x : point)
          x *= scale;
      Mesh mesh = mesh_of(triangulation);
      const auto uv = mesh.add_property_map<Vertex, UV>("v:uv").first;
      for(const Vertex v : mesh.vertices())
        uv[v] = {2. * image_scale * (mesh.point(v).x() / scale),
                 image_scale * (mesh.point(v).y() / scale)};
      const auto found = GP::flattening_distortion(mesh, uv);
      EXPECT_EQ(found.number_of_triangles, 72u);
      EXPECT_EQ(found.number_of_flips, 0u);
      const double round_off = 1e-12; // of sums of 72 terms
      EXPECT_NEAR(found.conformal, std::sqrt(0.5), round_off);
      EXPECT_NEAR(found.authalic, 0., round_off);
      EXPECT_NEAR(found.symmetric_dirichlet, 5., round_off);
      EXPECT_NEAR(found.l2_stretch, std::sqrt(1.25), round_off);
      EXPECT_NEAR(found.linf_stretch, std::sqrt(2.), round_off);
    }
}

TEST(distortion, domain_gives_the_values_of_its_mesh)
{
  const Sheared_mesh sheared(torus(24, 12));
  const auto& [mesh, uv, corners] = sheared;
  const auto domain = GP::make_domain(mesh);
  const auto expect_equal = [](double a, double b)
  { EXPECT_NEAR(a, b, 1e-12 * std::abs(b)); }; // coordinates relative to the domain's origin
  for(const Face f : mesh.faces())
    for(const auto& found :
        {GP::face_distortion(f, domain, uv), GP::face_distortion(f, domain, corners)})
    {
      const auto expected = GP::face_distortion(f, mesh, uv);
      expect_equal(found.sigma_1, expected.sigma_1);
      expect_equal(found.area, expected.area);
      EXPECT_EQ(found.is_inverted, expected.is_inverted);
    }
  const auto of_mesh = GP::surface_distortion(mesh, corners, &GP::Face_distortion::symmetric_mips),
             of_domain = GP::surface_distortion(domain, uv, &GP::Face_distortion::symmetric_mips);
  EXPECT_EQ(of_mesh.integral, of_domain.integral);
  EXPECT_EQ(of_mesh.worst, of_domain.worst);
  EXPECT_EQ(of_mesh.worst_location, of_domain.worst_location);
  EXPECT_EQ(GP::face_distortion(of_mesh.worst_location.first, domain, uv).symmetric_mips(),
            of_mesh.worst);
}

// The orthographic projection of a cap of the unit sphere stretches by 1/cos(t) along the
// meridians, at the angle t from the pole. The mean over the cap is -log(cos a) / (1 - cos a).
TEST(distortion, distortion_of_cloud_follows_closed_form)
{
  double last_error = 1.;
  for(const unsigned level : {4u, 5u})
  {
    const Surfels sphere = sphere_surfels(level);
    const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
    std::vector<UV> uv;
    for(const auto& [p, n] : sphere)
      uv.push_back({p.z() > 0.5 ? p.x() : std::numeric_limits<double>::quiet_NaN(), p.y()});
    const auto found = GP::surface_distortion(sphere, CGAL::make_property_map(uv),
                                              &GP::Face_distortion::mips, maps);
    const double edge = 1.2 / double(1u << level); // at most the distance of neighbors
    // Triangles across the boundary are ignored: a strip whose width is less than an edge.
    const double strip = 2. * GP::internal::pi * std::sin(GP::internal::pi / 3.) * edge;
    EXPECT_LT(found.area, GP::internal::pi);
    EXPECT_GT(found.area, GP::internal::pi - strip);
    const double error = std::abs(found.mean() - 2. * std::log(2.));
    EXPECT_LT(error, strip / GP::internal::pi * 0.7); // the mean in the strip is at most 2
    EXPECT_LT(error, 0.6 * last_error);               // about half
    last_error = error;
    EXPECT_EQ(found.number_of_flips, 0u);
    EXPECT_LE(found.worst, 2.);
    EXPECT_GT(std::hypot(uv[found.worst_location.surfel][0], uv[found.worst_location.surfel][1]),
              0.8); // near the boundary, at sin(pi / 3)

    const auto whole =
        GP::flattening_distortion(GP::make_domain(sphere, maps), CGAL::make_property_map(uv));
    EXPECT_EQ(whole.number_of_triangles, found.number_of_triangles);
    EXPECT_EQ(whole.number_of_flips, 0u);
    // The mean of (sigma - 1)^2 / sigma is that of sigma - 2 + 1 / sigma, and the mean of the
    // cosine is 3 / 4.
    EXPECT_NEAR(whole.conformal, std::sqrt(2. * std::log(2.) - 2. + 0.75), edge);
  }
}

} // namespace distortion_test
