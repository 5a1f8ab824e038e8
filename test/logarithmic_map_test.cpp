// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/logarithmic_map.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include "Mesh_of.h"
#include "normal_coordinates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <thread>
#include <type_traits>
#include <vector>

namespace logarithmic_map_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Vector_3 = Kernel::Vector_3;

// Returns the mean error of tangent vectors relative to the distance, over vertices closer than pi
// / 2.
template <typename Method>
double error_on_sphere(unsigned level)
{
  const Mesh mesh = mesh_of(icosphere(level));
  GP::Logarithmic_map<Mesh, Method> map(mesh);
  map.compute(Vertex(0), GP::parameters::maximum_distance(CGAL_PI / 2.));
  EXPECT_GT(map.reached().size(), mesh.number_of_vertices() / 3);
  if(!std::is_same_v<Method, GP::Discrete_exponential>)
  {
    EXPECT_EQ(map.number_of_cut_faces(), 0u);
    EXPECT_EQ(map.number_of_flips(), 0u);
  }
  return mean_error_on_sphere(map, [&](Vertex v) { return mesh.point(v); });
}

TEST(logarithmic_map, converges_on_a_sphere)
{
  // The error decreases at least linearly with the edge length.
  const double coarse = error_on_sphere<GP::Gradient<>>(4),
               fine = error_on_sphere<GP::Gradient<>>(5);
  EXPECT_LT(fine, 0.001); // measured: 0.0005
  EXPECT_LT(fine, 0.6 * coarse);
  EXPECT_LT(error_on_sphere<GP::Exact>(5), 0.001); // deviation of the mesh from the sphere
}

TEST(logarithmic_map, is_exact_on_a_plane)
{
  Mesh mesh = mesh_of(square(12, 0.25));
  const auto uv = mesh.add_property_map<Vertex, std::array<double, 2>>("v:uv").first;
  const auto frame =
      GP::logarithmic_map(mesh, Vertex(84), uv, GP::parameters::up_direction(Vector_3(1., 2., 5.)));
  EXPECT_NEAR(frame.v * Vector_3(1., 2., 0.), std::sqrt(5.),
              1e-12); // the component in the tangent plane
  EXPECT_EQ(frame.origin, mesh.point(Vertex(84)));
  for(const Vertex v : mesh.vertices())
  {
    const Vector_3 offset = mesh.point(v) - frame.origin;
    // Fronts are exact to 4e-15 of the extent here. Division by the stencil length amplifies this.
    EXPECT_NEAR(uv[v][0], offset * frame.u, 1e-12);
    EXPECT_NEAR(uv[v][1], offset * frame.v, 1e-12);
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
      // Both maps are exact on a developable surface. Round-off errors of some tens of faces.
      EXPECT_NEAR(gradient(v)[k], exact(v)[k], 1e-12);
}

TEST(logarithmic_map, respects_maximum_distance)
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
      EXPECT_LE(std::hypot(map(v)[0], map(v)[1]), 0.5 * (1. + 1e-12)); // round-off error
    }
  }
  EXPECT_EQ(inside, map.reached().size());
  EXPECT_LT(inside, mesh.number_of_vertices() / 10);
  // A second query from another vertex discards all results of the first one.
  map.compute(Vertex(100), GP::parameters::maximum_distance(0.));
  EXPECT_EQ(map.reached().size(), 1u);
  EXPECT_FALSE(map.is_inside(Vertex(3)));
}

TEST(logarithmic_map, converges_linearly_on_irregular_meshes)
{
  // An icosphere whose vertices are displaced along the surface by up to a third of an edge
  // length.
  const auto error = [](unsigned level, double stencil_length)
  {
    Triangulation surface = jittered(icosphere(level), 0.3 * 1.2 / std::pow(2., level));
    for(Point& p : surface.points)
      p = GP::internal::unit(p);
    const Mesh mesh = mesh_of(surface);
    GP::Logarithmic_map<Mesh> map(mesh);
    double result = 0.;
    for(const unsigned base : {0u, 50u, 100u, 150u})
    {
      map.compute(Vertex(base),
                  GP::parameters::maximum_distance(1.).stencil_length(stencil_length));
      result += mean_error_on_sphere(map, [&](Vertex v) { return mesh.point(v); }) / 4.;
    }
    return result;
  };
  for(const double stencil_length : {0., 0.2}) // the first is the default
    EXPECT_LT(error(5, stencil_length),
              0.25 * error(3, stencil_length)); // the edges are a quarter as long
}

// Compares the distortion of normal coordinates near their base with theory (Riemann 1854; Brun
// 2006 for each measure). The distortion depends only on the curvature at the base.
void expect_theory(const Mesh& mesh, Vertex base, double curvature)
{
  GP::Logarithmic_map<Mesh> map(mesh);
  // Derivatives of the map need a stencil longer than an edge. With the default stencil, errors of
  // adjacent vertices differ by fractions of an edge length.
  map.compute(base, GP::parameters::maximum_distance(0.65).stencil_length(0.2));
  const auto faces = faces_around(mesh, map, 0.05, 0.6);
  EXPECT_GT(faces.size(), 1000u);
  for(const Measure_asymptotics& measure : measure_asymptotics())
  {
    const double expected = measure.coefficient(curvature),
                 found = fitted_coefficient(measure, faces);
    // 5 % of the expected coefficient. If it is zero, 5 % of the coefficient 1/6 of a stretch.
    EXPECT_NEAR(found, expected, 0.05 * (expected == 0. ? 1. / 6. : std::fabs(expected)))
        << measure.name;
  }
}

TEST(logarithmic_map, distortion_matches_curvature)
{
  expect_theory(mesh_of(icosphere(5)), Vertex(1000), 1.);
  const Hyperbolic_patch patch = hyperbolic_patch(40, 0.2);
  expect_theory(mesh_of(patch.surface), Vertex(patch.base), -1.);
}

TEST(logarithmic_map, metric_matches_curvature)
{
  // g_ij = delta_ij - 1/3 R_ikjl u^k u^l up to higher orders, whose curvature tensor has the
  // Gaussian curvature as its only component.
  const auto expect_metric = [](const Mesh& mesh, Vertex base, double curvature)
  {
    GP::Logarithmic_map<Mesh> map(mesh);
    map.compute(base, GP::parameters::maximum_distance(0.65).stencil_length(0.2));
    const Metric_expansion found = fitted_metric(metrics_around(mesh, map, 0.05, 0.6));
    // Measured: 0.003, 0.0001 and 0.0004 at most.
    EXPECT_LT(quadratic_error(found, curvature), 0.01);
    EXPECT_LT(base_errors(found)[0], 0.0005);
    EXPECT_LT(base_errors(found)[1], 0.002);
  };
  expect_metric(mesh_of(icosphere(5)), Vertex(1000), 1.);
  const Hyperbolic_patch patch = hyperbolic_patch(40, 0.2);
  expect_metric(mesh_of(patch.surface), Vertex(patch.base), -1.);
}

TEST(logarithmic_map, has_bounded_departure_from_linearity)
{
  // Measured with `Exact`: 0.20, 0.23 and 0.26. An orthogonal projection yields 1.5, 8 and 30,
  // which grows with the inverse square of the edge length.
  for(const unsigned level : {3u, 4u, 5u})
  {
    const Mesh mesh = mesh_of(icosphere(level));
    GP::Logarithmic_map<Mesh, GP::Exact> map(mesh);
    map.compute(Vertex(0), GP::parameters::maximum_distance(0.6));
    const auto frame = map.frame();
    EXPECT_LT(departure_from_linearity(mesh, Vertex(0), 0.59, map), 0.5);
    const auto projected = [&](Vertex v)
    {
      const Vector_3 offset = mesh.point(v) - frame.origin;
      return std::array<double, 2>{offset * frame.u, offset * frame.v};
    };
    // Half to two thirds of the measured values.
    EXPECT_GT(departure_from_linearity(mesh, Vertex(0), 0.59, projected),
              0.015 * std::pow(4., level));
  }
}

TEST(logarithmic_map, is_isometric_on_a_cylinder)
{
  const Mesh mesh = mesh_of(cylinder(60, 30, 1., 4.));
  GP::Logarithmic_map<Mesh> map(mesh);
  map.compute(Vertex(60 * 15), GP::parameters::maximum_distance(1.));
  const auto uv = boost::make_function_property_map<Vertex>([&](Vertex v) { return map(v); });
  for(const Measure_asymptotics& measure : measure_asymptotics())
  {
    const auto found = GP::surface_distortion(mesh, uv, measure.measure);
    EXPECT_GT(found.number_of_triangles, 100u);
    EXPECT_NEAR(found.worst, measure.at_base, 1e-6)
        << measure.name; // as exact as fronts on a plane
  }
}

TEST(logarithmic_map, discrete_exponential_is_exact_only_on_planes)
{
  const Mesh flat = mesh_of(square(12, 0.25));
  GP::Logarithmic_map<Mesh, GP::Discrete_exponential> map(flat);
  using Location = GP::Logarithmic_map<Mesh>::Location;
  map.compute(Location(Face(100), {0.2, 0.3, 0.5}));
  const auto frame = map.frame();
  EXPECT_EQ(map.reached().size(), flat.number_of_vertices());
  for(const Vertex v : flat.vertices())
  {
    // A sum of a few steps.
    EXPECT_NEAR(map(v)[0], (flat.point(v) - frame.origin) * frame.u, 1e-13);
    EXPECT_NEAR(map(v)[1], (flat.point(v) - frame.origin) * frame.v, 1e-13);
  }
  // If a chain of edges is far from the geodesic, a step across it is longer in normal coordinates
  // than here. Refinement does not help: 2.5, 2.4 and 2.3 % were measured at 2,562 to 40,962
  // vertices.
  const double coarse = error_on_sphere<GP::Discrete_exponential>(4),
               fine = error_on_sphere<GP::Discrete_exponential>(5);
  EXPECT_LT(fine, 0.03); // see above
  EXPECT_GT(fine, 0.8 * coarse);
}

TEST(logarithmic_map, exponential_inverts_map)
{
  const Mesh mesh = mesh_of(icosphere(4));
  GP::Logarithmic_map<Mesh, GP::Exact> map(mesh);
  using Location = GP::Logarithmic_map<Mesh, GP::Exact>::Location;
  const Location base(Face(17), {0.2, 0.3, 0.5});
  map.compute(base, GP::parameters::maximum_distance(1.).up_direction(Vector_3(0.3, 1., 0.2)));
  for(const Vertex v : map.reached())
  {
    const Location image = map.exponential(map(v));
    const auto p = CGAL::Polygon_mesh_processing::construct_point(image, mesh);
    // Round-off errors of some tens of faces.
    EXPECT_LT(std::sqrt(CGAL::squared_distance(p, mesh.point(v))), 1e-12);
  }
}

TEST(logarithmic_map, detects_cut_locus)
{
  // On a sphere, the cut locus is the antipodal point. Faces elsewhere are not cut.
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
          EXPECT_GT(std::hypot(map(v)[0], map(v)[1]), 2.3); // 2.47 minus an edge length
      });
  EXPECT_EQ(number, map.number_of_cut_faces());
}

TEST(logarithmic_map, supports_clouds_and_polyhedra)
{
  const Surfels surfels = sphere_surfels(5);
  GP::Logarithmic_map<Surfels> map(GP::make_domain(
      surfels, GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map())));
  map.compute(std::size_t(0), GP::parameters::maximum_distance(CGAL_PI / 2.));
  // Measured: 0.0024.
  EXPECT_LT(mean_error_on_sphere(map, [&](std::size_t i) { return surfels[i].first; }), 0.005);

  GP::Logarithmic_map<Surfels, GP::Discrete_exponential> discrete(map.domain());
  discrete.compute(std::size_t(0), GP::parameters::maximum_distance(CGAL_PI / 2.));
  // Same accuracy as on a mesh of these points.
  EXPECT_LT(mean_error_on_sphere(discrete, [&](std::size_t i) { return surfels[i].first; }), 0.03);

  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::copy_face_graph(mesh_of(icosphere(2)), polyhedron);
  GP::Logarithmic_map<CGAL::Polyhedron_3<Kernel>> on_polyhedron(polyhedron);
  on_polyhedron.compute(*vertices(polyhedron).begin());
  EXPECT_EQ(on_polyhedron.reached().size(), num_vertices(polyhedron));
}

TEST(logarithmic_map, frame_of_location_of_cloud_is_on_triangles)
{
  using Map = GP::Logarithmic_map<Surfels>;
  const Surfels surfels = sphere_surfels(5);
  Map map(surfels, GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  for(std::size_t surfel = 0; surfel < surfels.size(); surfel += 997)
  {
    const Map::Location base{surfel, {0.008, -0.005}}; // the surfels are 0.03 to 0.04 apart
    map.compute(base, GP::parameters::maximum_distance(0.2));
    const Vector_3 offset = map.frame().origin - map.domain().point(base);
    const Vector_3 normal = get(Surfel_normal_map(), surfels[surfel]);
    // The triangles are at most d^2/8 below the unit sphere if d is their longest edge, and the
    // tangent plane is 0.5 * 0.0094^2 = 4.5e-5 above it. Tangential components are round-off
    // errors.
    EXPECT_LT(offset * normal, 0.);
    EXPECT_GT(offset * normal, -0.05 * 0.05 / 8. - 4.5e-5);
    EXPECT_LT(CGAL::cross_product(offset, normal).squared_length(), 1e-28);
  }
  map.compute(std::size_t(7));
  EXPECT_EQ(map.frame().origin, surfels[7].first);
}

TEST(logarithmic_map, copies_share_fitted_surface_of_cloud)
{
  const Surfels surfels = sphere_surfels(4);
  GP::Logarithmic_map<Surfels> map(
      surfels, GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  map.compute(std::size_t(0), GP::parameters::maximum_distance(0.1));
  // The copies fit the surface concurrently at their first call.
  std::vector<GP::Logarithmic_map<Surfels>> copies(4, map);
  std::vector<GP::Logarithmic_map<Surfels>::Location> images(copies.size());
  std::vector<std::thread> threads;
  for(std::size_t i = 0; i < copies.size(); ++i)
    threads.emplace_back([&, i] { images[i] = copies[i].exponential({0.4, 0.9}); });
  for(std::thread& thread : threads)
    thread.join();
  const auto expected = map.exponential({0.4, 0.9});
  for(const auto& image : images)
  {
    EXPECT_EQ(image.surfel, expected.surfel);
    EXPECT_EQ(image.offset, expected.offset);
  }
}

// Returns the root mean square of the angles between a map and the sphere, up to a rotation.
template <typename Method, typename NamedParameters>
double angular_error(const Mesh& mesh, Vertex base, const NamedParameters& np)
{
  GP::Logarithmic_map<Mesh, Method> map(mesh);
  map.compute(base, np.maximum_distance(1.));
  const auto frame = map.frame();
  std::vector<double> angles;
  double x = 0., y = 0.;
  for(const Vertex v : map.reached())
  {
    const auto found = map(v), expected = vector_on_sphere(frame, mesh.point(v));
    if(v == base)
      continue;
    angles.push_back(std::atan2(found[1], found[0]) - std::atan2(expected[1], expected[0]));
    x += std::cos(angles.back());
    y += std::sin(angles.back());
  }
  double sum = 0.;
  for(const double angle : angles)
    sum += std::pow(std::remainder(angle - std::atan2(y, x), 2. * CGAL_PI), 2);
  return std::sqrt(sum / double(angles.size()));
}

// Expects smaller angular errors with 30 smoothing steps, with three base refinements and with
// both. The three numbers are ratios to the error without options.
template <typename Method>
void expect_smaller_errors(const Mesh& mesh, double smoothing, double refinement, double both)
{
  for(const unsigned i : {3u, 777u, 1500u})
  {
    const Vertex base(i);
    const auto np = GP::parameters::stencil_length(0.);
    const double plain = angular_error<Method>(mesh, base, np);
    EXPECT_LT(angular_error<Method>(mesh, base, np.number_of_smoothing_steps(30)),
              smoothing * plain);
    EXPECT_LT(angular_error<Method>(mesh, base, np.number_of_base_refinements(3)),
              refinement * plain);
    EXPECT_LT(angular_error<Method>(mesh, base,
                                    np.number_of_smoothing_steps(30).number_of_base_refinements(3)),
              both * plain);
  }
}

TEST(logarithmic_map, smoothing_and_refinement_reduce_errors)
{
  // A sphere of 2,562 vertices with uniform noise of up to 0.08 edge lengths.
  const Mesh mesh = mesh_of(jittered(icosphere(4), 0.006));
  // Measured: at most 0.62, 0.36 and 0.20, and with Dijkstra at most 0.60, 0.90 and 0.49.
  expect_smaller_errors<GP::Gradient<GP::Fast_marching>>(mesh, 0.8, 0.5, 0.35);
  expect_smaller_errors<GP::Gradient<GP::Dijkstra>>(mesh, 0.8, 1., 0.7);
}

TEST(logarithmic_map, options_keep_lengths_and_exact_maps)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Mesh mesh = mesh_of(scaled(square(12, 0.25), scale));
    GP::Logarithmic_map<Mesh> plain(mesh), map(mesh);
    GP::Logarithmic_map<Mesh, GP::Gradient<GP::Dijkstra>> rough(mesh), smooth(mesh);
    using Location = GP::Logarithmic_map<Mesh>::Location;
    for(const Location& base :
        {Location(Face(100), {0.2, 0.3, 0.5}), Location(Face(0), {1., 0., 0.}),
         Location(Face(31), {0.4, 0.6, 0.})})
    {
      const auto np = GP::parameters::number_of_smoothing_steps(10).number_of_base_refinements(2);
      plain.compute(base);
      map.compute(base, np);
      rough.compute(base);
      smooth.compute(base, GP::parameters::number_of_smoothing_steps(10));
      EXPECT_EQ(map.reached().size(), mesh.number_of_vertices());
      double change = 0.;
      for(const Vertex v : mesh.vertices())
      {
        // Fronts in the plane are exact up to round-off errors, which division by the length of the
        // stencil amplifies.
        EXPECT_NEAR(map(v)[0], plain(v)[0], 1e-11 * scale);
        EXPECT_NEAR(map(v)[1], plain(v)[1], 1e-11 * scale);
        EXPECT_NEAR(std::hypot(smooth(v)[0], smooth(v)[1]), std::hypot(rough(v)[0], rough(v)[1]),
                    1e-15 * scale); // one division
        change = std::max(change, std::fabs(smooth(v)[0] - rough(v)[0]));
      }
      EXPECT_GT(change, 1e-3 * scale);
    }
  }
}

TEST(logarithmic_map, options_are_off_by_default)
{
  const Mesh mesh = mesh_of(jittered(icosphere(3), 0.02));
  GP::Logarithmic_map<Mesh, GP::Gradient<GP::Dijkstra>> map(mesh), other(mesh);
  map.compute(Vertex(5));
  // A map with options leaves no traces in the next one.
  other.compute(Vertex(5),
                GP::parameters::number_of_smoothing_steps(3).number_of_base_refinements(1));
  other.compute(Vertex(5),
                GP::parameters::number_of_smoothing_steps(0).number_of_base_refinements(0));
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(map(v), other(v));
}

TEST(logarithmic_map, refinement_does_not_change_the_surface)
{
  // Exact distances on the refined mesh are those of the mesh.
  const Mesh mesh = mesh_of(jittered(icosphere(3), 0.02));
  GP::Logarithmic_map<Mesh, GP::Gradient<GP::Exact>> map(mesh), refined(mesh);
  map.compute(Vertex(5));
  refined.compute(Vertex(5), GP::parameters::number_of_base_refinements(2));
  for(const Vertex v : mesh.vertices())
    for(int k = 0; k < 2; ++k)
      // Round-off errors of windows, divided by the length of the stencil.
      EXPECT_NEAR(map(v)[k], refined(v)[k], 1e-10);
}

TEST(logarithmic_map, options_are_limited_to_the_component_and_the_radius)
{
  const Mesh mesh = mesh_of(disjoint_union(icosphere(2), scaled(icosphere(2), 3.)));
  GP::Logarithmic_map<Mesh> plain(mesh), map(mesh);
  const auto np = GP::parameters::maximum_distance(1.);
  plain.compute(Vertex(5), np);
  map.compute(Vertex(5), np.number_of_smoothing_steps(5).number_of_base_refinements(1));
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(plain.is_inside(v), map.is_inside(v));
  EXPECT_LT(map.reached().size(), 162u / 2);
}

TEST(logarithmic_map, smoothing_reduces_errors_on_clouds)
{
  const Surfels surfels = sphere_surfels(4);
  const auto np = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  const auto error = [&](std::size_t steps, unsigned number_of_threads)
  {
    GP::Logarithmic_map<Surfels, GP::Gradient<GP::Dijkstra>> map(
        GP::make_domain(surfels, np.number_of_threads(number_of_threads)));
    map.compute(std::size_t(9),
                GP::parameters::maximum_distance(1.).number_of_smoothing_steps(steps));
    return mean_error_on_sphere(map, [&](std::size_t i) { return surfels[i].first; });
  };
  EXPECT_LT(error(20, 1), 0.9 * error(0, 1)); // measured: 0.85
  EXPECT_EQ(error(20, 1), error(20, 2));
}

TEST(logarithmic_map, rejects_options_without_effect)
{
  const auto smoothing = GP::parameters::number_of_smoothing_steps(1);
  const auto refinement = GP::parameters::number_of_base_refinements(1);
  const Mesh mesh = mesh_of(square(3));
  GP::Logarithmic_map<Mesh, GP::Exact> exact(mesh);
  exact.compute(Vertex(5));
  const auto before = exact(Vertex(0));
  EXPECT_THROW(exact.compute(Vertex(6), smoothing), GP::Unsupported_surface_error);
  EXPECT_THROW(exact.compute(Vertex(6), refinement), GP::Unsupported_surface_error);
  EXPECT_EQ(exact(Vertex(0)), before); // the last map remains
  GP::Logarithmic_map<Mesh, GP::Discrete_exponential> discrete(mesh);
  EXPECT_THROW(discrete.compute(Vertex(6), smoothing), GP::Unsupported_surface_error);
  EXPECT_THROW(discrete.compute(Vertex(6), refinement), GP::Unsupported_surface_error);
  GP::Logarithmic_map<Mesh> map(mesh);
  EXPECT_THROW(map.compute(Vertex(0), GP::parameters::number_of_smoothing_steps(1001)),
               GP::Invalid_argument_error);
  EXPECT_THROW(map.compute(Vertex(0), GP::parameters::number_of_base_refinements(-1)),
               GP::Invalid_argument_error);

  const Surfels surfels = sphere_surfels(2);
  GP::Logarithmic_map<Surfels> on_cloud(
      surfels, GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  EXPECT_THROW(on_cloud.compute(std::size_t(0), refinement), GP::Unsupported_surface_error);
  EXPECT_NO_THROW(on_cloud.compute(std::size_t(0), smoothing.number_of_base_refinements(0)));

  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  GP::Logarithmic_map<CGAL::Polyhedron_3<Kernel>> on_polyhedron(polyhedron);
  on_polyhedron.compute(*vertices(polyhedron).begin(), smoothing.number_of_base_refinements(1));
  EXPECT_EQ(on_polyhedron.reached().size(), num_vertices(polyhedron));
}

TEST(logarithmic_map, throws_on_invalid_input)
{
  const Mesh mesh = mesh_of(square(3));
  GP::Logarithmic_map<Mesh> map(mesh);
  EXPECT_THROW(map.frame(), GP::Invalid_argument_error);
  EXPECT_THROW(map.exponential({0.1, 0.1}), GP::Invalid_argument_error);
  EXPECT_THROW(map.compute(Vertex(0), GP::parameters::maximum_distance(-1.)),
               GP::Invalid_argument_error);
  EXPECT_THROW(map.compute(Vertex(0), GP::parameters::stencil_length(-1.)),
               GP::Invalid_argument_error);
  EXPECT_THROW(map.compute(Vertex(0), GP::parameters::stencil_size(2)), GP::Invalid_argument_error);
  EXPECT_THROW(map.compute(Vertex(5), GP::parameters::up_direction(Vector_3(0., 0., 1.))),
               GP::Invalid_argument_error);
}

} // namespace logarithmic_map_test
