// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/logarithmic_map.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Vector_3 = Kernel::Vector_3;

// The tangent vector at the first point of a unit sphere that leads to the second, in a frame.
template <typename Frame>
std::array<double, 2> on_sphere(const Frame& frame, const Kernel::Point_3& p)
{
  const Vector_3 base = frame.origin - CGAL::ORIGIN, to = p - CGAL::ORIGIN;
  const double u = to * frame.u, v = to * frame.v, size = std::hypot(u, v);
  const double angle = std::atan2(size, to * base);
  return size > 0. ? std::array<double, 2>{angle * u / size, angle * v / size}
                   : std::array<double, 2>{0., 0.};
}

// The mean error of tangent vectors, relative to the distance, of vertices nearer than half of pi.
template <typename Method>
double error_on_sphere(unsigned level)
{
  const Mesh mesh = mesh_of(icosphere(level));
  GP::Logarithmic_map<Mesh, Method> map(mesh);
  map.compute(Vertex(0), GP::parameters::maximum_distance(CGAL_PI / 2.));
  const auto frame = map.frame();
  double sum = 0.;
  std::size_t number = 0;
  for(const Vertex v : map.reached())
  {
    const auto truth = on_sphere(frame, mesh.point(v)), found = map(v);
    const double distance = std::hypot(truth[0], truth[1]);
    if(v == Vertex(0))
      continue;
    sum += std::hypot(found[0] - truth[0], found[1] - truth[1]) / distance;
    ++number;
  }
  EXPECT_GT(number, mesh.number_of_vertices() / 3);
  EXPECT_EQ(map.number_of_cut_faces(), 0u);
  EXPECT_EQ(map.number_of_folded_faces(), 0u);
  return sum / double(number);
}

TEST(logarithmic_map, is_near_to_that_of_a_sphere)
{
  // Of first order at least.
  const double coarse = error_on_sphere<GP::Gradient<>>(4),
               fine = error_on_sphere<GP::Gradient<>>(5);
  EXPECT_LT(fine, 0.002);
  EXPECT_LT(fine, 0.6 * coarse);
  EXPECT_LT(error_on_sphere<GP::Exact>(5), 0.001); // what the mesh differs from the sphere by
}

TEST(logarithmic_map, is_the_plane_of_a_plane)
{
  Mesh mesh = mesh_of(square(12, 0.25));
  const auto uv = mesh.add_property_map<Vertex, std::array<double, 2>>("v:uv").first;
  const auto frame =
      GP::logarithmic_map(mesh, Vertex(84), uv, GP::parameters::up_direction(Vector_3(1., 2., 5.)));
  EXPECT_NEAR(frame.v * Vector_3(1., 2., 0.), std::sqrt(5.), 1e-12); // the part in the plane
  EXPECT_EQ(frame.origin, mesh.point(Vertex(84)));
  for(const Vertex v : mesh.vertices())
  {
    const Vector_3 way = mesh.point(v) - frame.origin;
    // Fronts are exact to 4e-15 of the extent there, which the stencil's length divides.
    EXPECT_NEAR(uv[v][0], way * frame.u, 1e-12);
    EXPECT_NEAR(uv[v][1], way * frame.v, 1e-12);
  }
}

TEST(logarithmic_map, unrolls_a_cylinder)
{
  const Mesh mesh = mesh_of(cylinder(60, 30, 1., 6.));
  GP::Logarithmic_map<Mesh, GP::Exact> exact(mesh);
  GP::Logarithmic_map<Mesh> gradient(mesh);
  const Vertex base(60 * 15);
  const auto np = GP::parameters::maximum_distance(2.5).up_direction(Vector_3(0., 0., 1.));
  exact.compute(base, np);
  gradient.compute(base, np);
  EXPECT_EQ(exact.reached().size(), gradient.reached().size());
  for(const Vertex v : exact.reached())
    for(int k = 0; k < 2; ++k)
      EXPECT_NEAR(gradient(v)[k], exact(v)[k], 1e-6);
}

TEST(logarithmic_map, does_not_go_beyond_its_distance)
{
  const Mesh mesh = mesh_of(icosphere(3));
  GP::Logarithmic_map<Mesh> map(mesh);
  map.compute(Vertex(3), GP::parameters::maximum_distance(0.5));
  std::size_t inside = 0;
  for(const Vertex v : mesh.vertices())
  {
    EXPECT_EQ(map.is_inside(v), std::isfinite(map(v)[0]));
    inside += map.is_inside(v);
    if(map.is_inside(v))
    {
      EXPECT_LE(std::hypot(map(v)[0], map(v)[1]), 0.5 * (1. + 1e-12));
    }
  }
  EXPECT_EQ(inside, map.reached().size());
  EXPECT_LT(inside, mesh.number_of_vertices() / 10);
  // Another place: nothing is left of the last one.
  map.compute(Vertex(100), GP::parameters::maximum_distance(0.));
  EXPECT_EQ(map.reached().size(), 1u);
  EXPECT_FALSE(map.is_inside(Vertex(3)));
}

TEST(logarithmic_map, exponential_leads_back)
{
  const Mesh mesh = mesh_of(icosphere(4));
  GP::Logarithmic_map<Mesh, GP::Exact> map(mesh);
  using Location = GP::Logarithmic_map<Mesh, GP::Exact>::Location;
  const Location base(Face(17), {0.2, 0.3, 0.5});
  map.compute(base, GP::parameters::maximum_distance(1.).up_direction(Vector_3(0.3, 1., 0.2)));
  for(const Vertex v : map.reached())
  {
    const Location there = map.exponential(map(v));
    const auto p = CGAL::Polygon_mesh_processing::construct_point(there, mesh);
    EXPECT_LT(std::sqrt(CGAL::squared_distance(p, mesh.point(v))), 1e-9);
  }
}

TEST(logarithmic_map, knows_where_it_is_cut)
{
  // All around a sphere: around the point opposite, and nowhere else.
  const Mesh mesh = mesh_of(icosphere(4));
  GP::Logarithmic_map<Mesh, GP::Exact> map(mesh);
  map.compute(Vertex(0));
  EXPECT_EQ(map.reached().size(), mesh.number_of_vertices());
  EXPECT_GT(map.number_of_cut_faces(), 4u);
  std::size_t number = 0;
  map.for_each_cut_face(
      [&](Face f)
      {
        ++number;
        for(const Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
          EXPECT_GT(std::hypot(map(v)[0], map(v)[1]), 2.3); // 2.47 less a side
      });
  EXPECT_EQ(number, map.number_of_cut_faces());
}

TEST(logarithmic_map, takes_clouds_and_polyhedra)
{
  const Surfels surfels = sphere_surfels(5);
  GP::Logarithmic_map<Surfels> map(GP::make_domain(
      surfels, GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map())));
  map.compute(std::size_t(0), GP::parameters::maximum_distance(CGAL_PI / 2.));
  const auto frame = map.frame();
  double sum = 0.;
  const auto sites = map.reached();
  for(const auto site : sites)
  {
    const auto& p = surfels[site].first;
    const auto truth = on_sphere(frame, {p.x(), p.y(), p.z()}), found = map(site);
    const double distance = std::hypot(truth[0], truth[1]);
    if(distance > 0.)
      sum += std::hypot(found[0] - truth[0], found[1] - truth[1]) / distance;
  }
  EXPECT_LT(sum / double(sites.size()), 0.02);

  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::copy_face_graph(mesh_of(icosphere(2)), polyhedron);
  GP::Logarithmic_map<CGAL::Polyhedron_3<Kernel>> on_polyhedron(polyhedron);
  on_polyhedron.compute(*vertices(polyhedron).begin());
  EXPECT_EQ(on_polyhedron.reached().size(), num_vertices(polyhedron));
}

TEST(logarithmic_map, refuses_what_makes_no_sense)
{
  const Mesh mesh = mesh_of(square(3));
  GP::Logarithmic_map<Mesh> map(mesh);
  EXPECT_THROW(map.compute(Vertex(0), GP::parameters::maximum_distance(-1.)),
               GP::Invalid_argument_error);
  EXPECT_THROW(map.compute(Vertex(0), GP::parameters::stencil_length(-1.)),
               GP::Invalid_argument_error);
  EXPECT_THROW(map.compute(Vertex(0), GP::parameters::stencil_size(2)), GP::Invalid_argument_error);
  EXPECT_THROW(map.compute(Vertex(5), GP::parameters::up_direction(Vector_3(0., 0., 1.))),
               GP::Invalid_argument_error);
}

} // namespace
