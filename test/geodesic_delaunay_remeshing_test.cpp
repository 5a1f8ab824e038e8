// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_delaunay_remeshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/property_map.h>

#include "Array_surface.h"
#include "Mesh_of.h"
#include "openmesh.h"
#include "rough_surfaces.h"
#include "topology.h"

#include <gtest/gtest.h>

#include <iterator>
#include <map>
#include <set>

namespace geodesic_delaunay_remeshing_test {

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;
using namespace GP::test;

// Returns the corners of a mesh's faces. Vertices are numbered in the order of iteration.
template <typename AnyMesh>
std::vector<Index> corners_of(const AnyMesh& mesh)
{
  std::map<typename boost::graph_traits<AnyMesh>::vertex_descriptor, Index> number;
  for(const auto v : vertices(mesh))
    number.emplace(v, Index(number.size()));
  std::vector<Index> result;
  for(const auto f : faces(mesh))
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      result.push_back(number.at(source(h, mesh)));
  return result;
}

template <typename Output>
void expect_remeshes_sphere()
{
  const Mesh sphere = mesh_of(icosphere(3));
  Output output;
  EXPECT_EQ(GP::geodesic_delaunay_remeshing(sphere, 100, output).number_of_added_vertices, 0u);
  EXPECT_EQ(num_vertices(output), 100u);
  EXPECT_EQ(num_faces(output), 196u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(output));
  EXPECT_TRUE(CGAL::is_closed(output));
  EXPECT_EQ(topology(corners_of(output)), (Topology{true, {{2, 0}}}));
  const auto points = get(CGAL::vertex_point, output);
  for(const auto v : vertices(output))
  {
    const double radius = distance(to_array(get(points, v)), {0., 0., 0.});
    // Vertices lie on edges or faces of the icosphere, whose distance from the center is at least
    // 0.995.
    EXPECT_GE(radius, 0.995);
    EXPECT_LE(radius, 1. + 1e-6); // OpenMesh coordinates have single precision
  }
}

TEST(Geodesic_delaunay_remeshing, writes_all_mesh_types)
{
  expect_remeshes_sphere<Mesh>();
  expect_remeshes_sphere<CGAL::Polyhedron_3<Kernel>>();
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  expect_remeshes_sphere<OpenMesh::TriMesh_ArrayKernelT<>>();
#endif
}

TEST(Geodesic_delaunay_remeshing, accepts_polyhedron_and_domain)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Polyhedron polyhedron;
  CGAL::make_icosahedron<Polyhedron, Polyhedron::Point_3>(polyhedron);
  Mesh output;
  GP::geodesic_delaunay_remeshing(polyhedron, 50, output);
  EXPECT_EQ(num_vertices(output), 50u);
  EXPECT_TRUE(CGAL::is_closed(output));
  EXPECT_TRUE(PMP::is_outward_oriented(output));

  Mesh again;
  GP::geodesic_delaunay_remeshing(GP::make_domain(polyhedron), 50, again);
  EXPECT_EQ(corners_of(again), corners_of(output));
}

TEST(Geodesic_delaunay_remeshing, adds_samples_or_throws)
{
  const Mesh torus_mesh = mesh_of(torus(40, 16));
  Mesh output;
  const auto result = GP::geodesic_delaunay_remeshing(torus_mesh, 5, output);
  // A torus has at least seven vertices.
  EXPECT_GE(result.number_of_added_vertices, 2u);
  EXPECT_EQ(num_vertices(output), 5 + result.number_of_added_vertices);
  EXPECT_EQ(topology(corners_of(output)), (Topology{true, {{0, 0}}}));

  Mesh none;
  const auto throwing = GP::parameters::too_few_samples(GP::Too_few_samples::are_wrong);
  EXPECT_THROW(GP::geodesic_delaunay_remeshing(torus_mesh, 5, none, throwing),
               GP::Invalid_argument_error);
  EXPECT_TRUE(is_empty(none));
  EXPECT_EQ(
      GP::geodesic_delaunay_remeshing(torus_mesh, 200, none, throwing).number_of_added_vertices,
      0u);
  // The smallest number of vertices is not reported as too few.
  EXPECT_GE(GP::geodesic_delaunay_remeshing(torus_mesh, 0, none, throwing).number_of_added_vertices,
            7u);
}

TEST(Geodesic_delaunay_remeshing, error_reports_required_number_of_samples)
{
  const Mesh torus_mesh = mesh_of(torus(40, 16));
  const auto near = GP::parameters::maximum_deviation(0.05);
  Mesh output;
  const std::size_t number =
      50 + GP::geodesic_delaunay_remeshing(torus_mesh, 50, output, near).number_of_added_vertices;
  EXPECT_GT(number, 50u);
  try
  {
    GP::geodesic_delaunay_remeshing(torus_mesh, 50, output,
                                    near.too_few_samples(GP::Too_few_samples::are_wrong));
    ADD_FAILURE();
  }
  catch(const GP::Invalid_argument_error& error)
  {
    const std::string text = error.what();
    EXPECT_NE(text.find(" make " + std::to_string(number) + " samples."), std::string::npos)
        << text;
    EXPECT_EQ(text.find("topology"), std::string::npos) << text;
  }
}

TEST(Geodesic_delaunay_remeshing, writes_vertex_locations)
{
  const Mesh plane = mesh_of(square(20, 0.2));
  Mesh output;
  CGAL::Unique_hash_map<Vertex, GP::Location<Mesh>> locations;
  GP::geodesic_delaunay_remeshing(
      plane, 80, output, GP::parameters::location_map(boost::make_assoc_property_map(locations)));
  double area = 0.;
  for(const Vertex v : output.vertices())
    // A few round-off errors.
    EXPECT_LT(distance(point_of(plane, locations[v]), to_array(output.point(v))), 1e-14);
  for(const Face f : output.faces())
    area += PMP::face_area(f, output);
  EXPECT_NEAR(area, 1., 1e-12); // a sum of 150 terms
}

TEST(Geodesic_delaunay_remeshing, writes_edge_paths)
{
  const Mesh sphere = mesh_of(icosphere(4));
  Mesh output;
  using Edge = boost::graph_traits<Mesh>::edge_descriptor;
  std::vector<std::pair<Edge, GP::Surface_path<Mesh>>> paths;
  GP::geodesic_delaunay_remeshing(sphere, 60, output,
                                  GP::parameters::edge_path_output(std::back_inserter(paths)));
  std::set<Edge> edges;
  for(const auto& [e, path] : paths)
  {
    edges.insert(e);
    ASSERT_FALSE(path.empty());
    const Point p = to_array(output.point(source(e, output))),
                q = to_array(output.point(target(e, output)));
    // Round-off errors of coordinates near 1.
    EXPECT_LT(distance(to_array(path.points.front()), p), 1e-14);
    EXPECT_LT(distance(to_array(path.points.back()), q), 1e-14);
    // Within 1 % of the great circle. The icosphere is 0.3 % too small.
    EXPECT_NEAR(path.length, 2. * std::asin(0.5 * distance(p, q)), 0.01 * path.length);
  }
  EXPECT_EQ(edges.size(), num_edges(output));
  EXPECT_EQ(paths.size(), num_edges(output));

  const Mesh plane = mesh_of(square(10));
  Mesh flat;
  paths.clear();
  GP::geodesic_delaunay_remeshing(plane, 30, flat,
                                  GP::parameters::edge_path_output(std::back_inserter(paths)));
  EXPECT_EQ(paths.size(), num_edges(flat));
}

// Returns the length of the edges whose dihedral angle deviates from flat by more than 45 degrees.
double length_of_sharp_edges(const Mesh& mesh)
{
  double result = 0.;
  for(const auto e : mesh.edges())
  {
    const auto h = mesh.halfedge(e);
    const auto normal = [&](Face f) { return PMP::compute_face_normal(f, mesh); };
    if(!mesh.is_border(e) &&
       normal(mesh.face(h)) * normal(mesh.face(mesh.opposite(h))) < std::sqrt(0.5))
      result += PMP::edge_length(e, mesh);
  }
  return result;
}

TEST(Geodesic_delaunay_remeshing, preserves_sharp_edges)
{
  const int size = 6;
  const Mesh ring = mesh_of(double_torus(size));
  for(const std::size_t number : {50u, 300u, 2000u})
  {
    Mesh output;
    GP::geodesic_delaunay_remeshing(ring, number, output, GP::parameters::sharp_angle(60.));
    EXPECT_EQ(topology(corners_of(output)), (Topology{true, {{-2, 0}}}));
    // Sums of some hundred terms.
    EXPECT_NEAR(length_of_sharp_edges(output), length_of_sharp_edges(ring), 1e-9);
    EXPECT_NEAR(PMP::area(output), PMP::area(ring), 1e-9);
  }
}

TEST(Geodesic_delaunay_remeshing, preserves_constrained_edges)
{
  Mesh plane = mesh_of(square(20));
  const auto is_kept =
      plane.add_property_map<boost::graph_traits<Mesh>::edge_descriptor, bool>("e:kept", false)
          .first;
  // The horizontal center line.
  const auto is_on_center_line = [&](const Point& p) { return std::abs(p[1] - 0.5) < 1e-12; };
  for(const auto e : plane.edges())
    put(is_kept, e,
        is_on_center_line(to_array(plane.point(source(e, plane)))) &&
            is_on_center_line(to_array(plane.point(target(e, plane)))));
  for(const std::size_t number : {20u, 100u, 500u})
  {
    Mesh output;
    GP::geodesic_delaunay_remeshing(
        plane, number, output,
        GP::parameters::edge_is_constrained_map(is_kept).number_of_relaxation_steps(2));
    double length = 0.;
    for(const auto e : output.edges())
      if(is_on_center_line(to_array(output.point(source(e, output)))) &&
         is_on_center_line(to_array(output.point(target(e, output)))))
        length += PMP::edge_length(e, output);
    EXPECT_NEAR(length, 1., 1e-12); // a sum of some ten terms
  }
}

TEST(Geodesic_delaunay_remeshing, respects_feature_spacing)
{
  // Divides the lower boundary cycle into 80 edges and the upper one into 30.
  Mesh pipe = mesh_of(cylinder(40, 20, 1., 3.)), output;
  const auto spacing = pipe.add_property_map<Mesh::Edge_index, double>("e:spacing", 0.).first;
  for(const auto e : edges(pipe))
    if(is_border(e, pipe))
    {
      const double height = pipe.point(source(halfedge(e, pipe), pipe)).z();
      spacing[e] = 2. * 40. * std::sin(GP::internal::pi / 40.) / (height == 0. ? 80. : 30.);
    }
  const auto number_at = [&](double height)
  {
    std::size_t number = 0;
    for(const auto v : vertices(output))
      number += std::abs(output.point(v).z() - height) < 1e-14; // round-off errors
    return number;
  };
  GP::geodesic_delaunay_remeshing(pipe, 150, output, GP::parameters::edge_spacing_map(spacing));
  EXPECT_EQ(number_at(0.), 80u);
  EXPECT_EQ(number_at(3.), 30u);
  EXPECT_EQ(topology(corners_of(output)), (Topology{true, {{0, 2}}}));

  Mesh of_domain;
  GP::geodesic_delaunay_remeshing(GP::make_domain(pipe), 150, of_domain,
                                  GP::parameters::edge_spacing_map(spacing));
  EXPECT_EQ(corners_of(of_domain), corners_of(output));

  output.clear();
  GP::geodesic_delaunay_remeshing(GP::make_domain(pipe), 150, output,
                                  GP::parameters::curve_spacing(0.1));
  EXPECT_EQ(number_at(0.), 63u); // expected length 6.277
  EXPECT_EQ(number_at(3.), 63u);
}

template <typename Cloud, typename Normals>
void expect_reconstructs_sphere(const Cloud& cloud, const Normals& np)
{
  Mesh output;
  const auto domain = GP::make_domain(cloud, np);
  using Location = typename std::decay_t<decltype(domain)>::Location;
  const auto location = output.add_property_map<Vertex, Location>("v:location").first;
  std::vector<std::pair<Mesh::Edge_index, GP::Surface_path<Cloud>>> paths;
  EXPECT_EQ(
      GP::geodesic_delaunay_remeshing(
          cloud, 80, output, np.location_map(location).edge_path_output(std::back_inserter(paths)))
          .number_of_added_vertices,
      0u);
  EXPECT_EQ(num_vertices(output), 80u);
  EXPECT_EQ(topology(corners_of(output)), (Topology{true, {{2, 0}}}));
  EXPECT_TRUE(PMP::is_outward_oriented(output));
  for(const auto v : vertices(output))
  {
    // Points in the triangles between 642 surfels lie up to 0.006 below the sphere. They are
    // equally close to the tangent planes, which contain the cloud's locations.
    const double depth = 0.006;
    const auto p = domain.point(domain.inner(location[v]));
    EXPECT_LT(distance(to_array(p), to_array(output.point(v))), 2. * depth);
    EXPECT_NEAR(distance(to_array(output.point(v)), {0., 0., 0.}), 1., depth);
  }
  EXPECT_EQ(paths.size(), num_edges(output));
  for(const auto& [e, path] : paths)
    EXPECT_GE(path.length,
              0.98 *
                  PMP::edge_length(e, output)); // path ends are up to 0.012 away from the vertices
}

TEST(Geodesic_delaunay_remeshing, reconstructs_surface_from_cloud)
{
  const Surfels surfels = sphere_surfels(3);
  expect_reconstructs_sphere(
      surfels, GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  CGAL::Point_set_3<Kernel::Point_3> points;
  points.add_normal_map();
  for(const auto& [p, n] : surfels)
    points.insert(p, n);
  expect_reconstructs_sphere(points, GP::parameters::random_seed(1u));

  // The speed is low in one half. The first surfel is kept.
  auto speed = points.add_property_map<double>("speed", 1.).first;
  for(const auto& i : points)
    if(points.point(i).z() > 0.)
      speed[i] = 0.25;
  Mesh output;
  GP::geodesic_delaunay_remeshing(points, 200, output,
                                  GP::parameters::speed_map(speed).first_samples(*points.begin()));
  // Round-off errors of coordinates near 1.
  EXPECT_LT(distance(to_array(output.point(Vertex(0))), to_array(points.point(*points.begin()))),
            1e-12);
  std::size_t above = 0;
  for(const auto v : vertices(output))
    above += output.point(v).z() > 0.;
  EXPECT_GT(above, 150u); // 16 times as dense: 188 of 200, minus the effect of the transition

  CGAL::Point_set_3<Kernel::Point_3> pair;
  pair.add_normal_map();
  pair.insert({0., 0., 0.}, {0., 0., 1.});
  pair.insert({1., 0., 0.}, {0., 0., 1.});
  EXPECT_THROW(GP::geodesic_delaunay_remeshing(pair, 2, output), GP::Unsupported_surface_error);
  EXPECT_THROW(GP::geodesic_delaunay_remeshing(decltype(pair)(true), 2, output),
               GP::Unsupported_surface_error);
}

TEST(Geodesic_delaunay_remeshing, respects_maximum_deviation)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Triangulation torus_surface = scaled(torus(60, 24), scale);
    const Mesh mesh = mesh_of(torus_surface);
    Mesh output;
    GP::geodesic_delaunay_remeshing(mesh, 50, output,
                                    GP::parameters::maximum_deviation(0.02 * scale));
    EXPECT_GT(num_vertices(output), 50u);
    EXPECT_LE(PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(mesh.points(), output),
              0.02 * scale * (1. + 1e-9)); // round-off errors
  }
}

TEST(Geodesic_delaunay_remeshing, deviation_is_symmetric)
{
  // A square with a round hole. With few vertices, output faces cover the hole partly. They must
  // cover the whole input.
  Triangulation plate = annulus(80, 10, 0.5, 1.);
  for(Point& p : plate.points)
  {
    const double radius = distance(p, {0., 0., 0.});
    const double scale_to_square = radius / std::max(std::abs(p[0]), std::abs(p[1])),
                 blend = 2. * radius - 1.;
    for(double& x : p)
      x *= (0.5 * (1. - blend) + scale_to_square * blend) / radius;
  }
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Mesh mesh = mesh_of(scaled(plate, scale));
    const auto input_to_output = [&](const Mesh& output)
    { return PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(mesh.points(), output); };
    const auto output_to_input = [&](const Mesh& output)
    {
      std::vector<Kernel::Point_3> positions;
      for(const auto e : edges(output))
        for(int k = 0; k <= 8; ++k)
          positions.push_back(CGAL::barycenter(output.point(source(e, output)), k,
                                               output.point(target(e, output)), 8 - k));
      return PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(positions, mesh);
    };
    Mesh coarse, output;
    GP::geodesic_delaunay_remeshing(mesh, 30, coarse);
    // Faces that cover the input and a part of the hole deviate in one direction only.
    EXPECT_LT(input_to_output(coarse), 0.005 * scale);
    EXPECT_GT(output_to_input(coarse), 0.02 * scale);
    GP::geodesic_delaunay_remeshing(mesh, 30, output,
                                    GP::parameters::maximum_deviation(0.005 * scale));
    // The requested deviation.
    EXPECT_LT(input_to_output(output), 0.005 * scale);
    EXPECT_LT(output_to_input(output),
              0.0055 * scale); // the deviation may be larger between edge midpoints
    EXPECT_LT(num_vertices(output), 200u);
    EXPECT_EQ(topology(corners_of(output)), (Topology{true, {{0, 2}}}));
  }
}

TEST(Geodesic_delaunay_remeshing, reaches_input_for_tiny_deviation)
{
  // The tolerance is smaller than the deviation of any face that is not a face of the input.
  const Mesh mesh = mesh_of(torus(20, 10));
  Mesh output;
  GP::geodesic_delaunay_remeshing(mesh, 20, output, GP::parameters::maximum_deviation(1e-9));
  EXPECT_EQ(num_vertices(output), num_vertices(mesh));
  // Round-off errors of a sum of 400 areas.
  EXPECT_NEAR(PMP::area(output), PMP::area(mesh), 1e-12);
}

TEST(Geodesic_delaunay_remeshing, fit_respects_maximum_deviation)
{
  // If faces fit a sphere best, their corners are three times as far above it as their centers are
  // below it, here 0.018. These corners are vertices of the input.
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Mesh mesh = mesh_of(scaled(icosphere(4), scale));
    const double max_deviation = 0.012 * scale;
    Mesh unfitted, output;
    GP::geodesic_delaunay_remeshing(mesh, 100, unfitted,
                                    GP::parameters::maximum_deviation(max_deviation));
    GP::geodesic_delaunay_remeshing(mesh, 100, output,
                                    GP::parameters::do_fit(true).maximum_deviation(max_deviation));
    for(const bool is_output_to_input : {false, true})
      EXPECT_LE(PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(
                    is_output_to_input ? output.points() : mesh.points(),
                    is_output_to_input ? mesh : output),
                max_deviation * (1. + 1e-9));                      // round-off errors
    EXPECT_LT(num_vertices(output), 0.7 * num_vertices(unfitted)); // measured: 0.55
  }
}

TEST(Geodesic_delaunay_remeshing, fit_reduces_mean_distance)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Triangulation ball = scaled(icosphere(5), scale);
    const Mesh mesh = mesh_of(ball);
    const auto mean_distance = [&](bool do_fit)
    {
      Mesh output;
      GP::geodesic_delaunay_remeshing(
          mesh, 200, output,
          GP::parameters::number_of_relaxation_steps(std::size_t(5)).do_fit(do_fit));
      double sum = 0.;
      for(const Mesh::Face_index f : output.faces())
      {
        const auto h = output.halfedge(f);
        const auto middle =
            CGAL::centroid(output.point(output.source(h)), output.point(output.target(h)),
                           output.point(output.target(output.next(h))));
        sum += 1. - std::sqrt((middle - CGAL::ORIGIN).squared_length()) / scale;
      }
      EXPECT_EQ(num_vertices(output), 200u);
      return sum / double(num_faces(output));
    };
    // The center of an equilateral triangle with circumradius r is r^2 / 2 below the sphere, and
    // the mean area is 3/8 r^2. Fitting raises the faces by this amount, which leaves a quarter.
    const double unfitted = mean_distance(false), fitted = mean_distance(true);
    EXPECT_GT(unfitted, 0.01);
    // Actual triangles are not quite equilateral. Measured: 0.246.
    EXPECT_NEAR(fitted / unfitted, 0.25, 0.02);
  }
}

TEST(Geodesic_delaunay_remeshing, fit_preserves_boundary_and_deviation)
{
  const Mesh mesh = mesh_of(grid(30, 30,
                                 [](double u, double v) {
                                   return Point{u, v, 0.1 * std::sin(9. * u) * v};
                                 }));
  Mesh output;
  GP::geodesic_delaunay_remeshing(mesh, 60, output,
                                  GP::parameters::do_fit(true).maximum_deviation(0.005));
  EXPECT_LE(PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(mesh.points(), output),
            0.005 * (1. + 1e-9)); // round-off errors
  for(const auto v : output.vertices())
    if(output.is_border(v))
    {
      const auto& p = output.point(v);
      EXPECT_TRUE(p.x() == 0. || p.x() == 1. || p.y() == 0. || p.y() == 1.) << p;
    }
}

using Exact_mesh = CGAL::Surface_mesh<CGAL::Epick::Point_3>;

std::size_t number_of_self_intersections(const Exact_mesh& mesh)
{
  std::vector<std::pair<Exact_mesh::Face_index, Exact_mesh::Face_index>> pairs;
  PMP::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

TEST(Geodesic_delaunay_remeshing, avoids_self_intersections)
{
  for(const double scale : {1e-6, 1e6})
  {
    // With forty vertices per sphere, faces are up to 0.1 below their sphere.
    const Triangulation sheets = disjoint_union(icosphere(4), scaled(icosphere(4), 0.95));
    const Mesh mesh = mesh_of(scaled(sheets, scale));
    Exact_mesh left, output;
    const auto plain = GP::geodesic_delaunay_remeshing(
        mesh, 80, left, GP::parameters::do_avoid_self_intersections(false));
    EXPECT_EQ(plain.number_of_added_vertices, 0u);
    EXPECT_EQ(plain.number_of_self_intersections, 0u); // removal was not requested
    EXPECT_GT(number_of_self_intersections(left), 0u);
    const auto found = GP::geodesic_delaunay_remeshing(mesh, 80, output);
    EXPECT_GT(found.number_of_added_vertices, 0u);
    EXPECT_LT(found.number_of_added_vertices, 300u); // the input has 5,124 vertices
    EXPECT_EQ(found.number_of_self_intersections, 0u);
    EXPECT_EQ(number_of_self_intersections(output), 0u);
    EXPECT_EQ(topology(corners_of(output)), topology(sheets.corners));
  }
}

TEST(Geodesic_delaunay_remeshing, keeps_self_intersections_of_input)
{
  Triangulation moved = icosphere(4);
  for(Point& p : moved.points)
    p[0] += 1.;
  const Mesh mesh = mesh_of(disjoint_union(icosphere(4), moved));
  Exact_mesh output;
  const auto found = GP::geodesic_delaunay_remeshing(mesh, 300, output);
  EXPECT_GT(found.number_of_self_intersections, 0u);
  EXPECT_EQ(found.number_of_self_intersections, number_of_self_intersections(output));
  EXPECT_LT(found.number_of_added_vertices,
            30u); // near the intersection curves, faces that need no refinement may be refined
}

TEST(Geodesic_delaunay_remeshing, discards_unsuccessful_samples)
{
  // The spheres are too close for ten rounds.
  const Mesh mesh = mesh_of(disjoint_union(icosphere(4), scaled(icosphere(4), 1. - 1e-7)));
  Exact_mesh output;
  const auto found = GP::geodesic_delaunay_remeshing(mesh, 80, output);
  EXPECT_EQ(found.number_of_added_vertices, 0u);
  EXPECT_GT(found.number_of_self_intersections, 0u);
}

TEST(Geodesic_delaunay_remeshing, appends_to_output)
{
  Mesh output = mesh_of(tetrahedron());
  GP::geodesic_delaunay_remeshing(mesh_of(square(10)), 30, output);
  EXPECT_EQ(num_vertices(output), 34u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(output));
  EXPECT_EQ(topology(corners_of(output)), (Topology{true, {{1, 1}, {2, 0}}}));
}

TEST(Geodesic_delaunay_remeshing, is_scale_invariant)
{
  const Triangulation ring = annulus(60, 12, 0.5, 1.);
  Mesh output;
  GP::geodesic_delaunay_remeshing(mesh_of(ring), 100, output);
  for(const double scale : {0x1p-40, 0x1p40}) // scaling by powers of two is exact
  {
    Mesh large;
    GP::geodesic_delaunay_remeshing(mesh_of(scaled(ring, scale)), 100, large);
    EXPECT_EQ(corners_of(large), corners_of(output));
  }
}

TEST(Geodesic_delaunay_remeshing, density_follows_speed_after_relaxation)
{
  Mesh plane = mesh_of(square(30, 0.2));
  const auto speed = plane.add_property_map<Vertex, double>("v:speed").first;
  for(const Vertex v : plane.vertices())
    put(speed, v, plane.point(v).x() < 0.5 ? 0.25 : 1.);
  Mesh output;
  GP::geodesic_delaunay_remeshing(
      plane, 170, output,
      GP::parameters::speed_map(speed).number_of_relaxation_steps(std::size_t(2)).random_seed(2));
  const auto left = std::count_if(output.vertices().begin(), output.vertices().end(),
                                  [&](Vertex v) { return output.point(v).x() < 0.5; });
  // 16/17 of the samples, minus the effect of the boundary.
  EXPECT_GT(left, 140);
  EXPECT_LT(left, 170);
}

TEST(Geodesic_delaunay_remeshing, preserves_topology_of_rough_surfaces)
{
  const auto has_distance_from_axes = [](const Point& p)
  { return std::hypot(p[0], p[1]) > 0.4 && std::hypot(p[1], p[2]) > 0.4; };
  std::vector<std::pair<std::string, Triangulation>> surfaces = {
      {"animal", animal()},
      {"animal with four holes", part_of(animal(), has_distance_from_axes)},
      {"spool", spool(60)},
      {"knot, bone and animal", disjoint_union(knot(200, 16), disjoint_union(bone(), animal(3)))}};
  add_models(surfaces, {"meshes/pig_468.off", "meshes/joint_221.off", "meshes/spool_649.off",
                        "meshes/bones_26comp_2k.off", "meshes/knot2_2comp_6k.off",
                        "meshes/mech_holes_shark_5k.off", "meshes/cow_2k9.off"});
  for(const auto& [name, surface] : surfaces)
  {
    const Mesh mesh = mesh_of(surface);
    for(const std::size_t number : {200u, 1000u})
    {
      Mesh output;
      GP::geodesic_delaunay_remeshing(mesh, number, output);
      EXPECT_TRUE(CGAL::is_valid_polygon_mesh(output));
      EXPECT_EQ(topology(corners_of(output)), topology(surface.corners)) << name;
      EXPECT_GE(num_vertices(output), number);
    }
  }
}

TEST(Geodesic_delaunay_remeshing, throws_on_invalid_arguments)
{
  Triangulation with_isolated_vertex = square(4);
  with_isolated_vertex.points.push_back({5., 5., 5.});
  Mesh plane = mesh_of(with_isolated_vertex), output;
  const auto with = [&](const auto& np) { GP::geodesic_delaunay_remeshing(plane, 10, output, np); };
  EXPECT_THROW(with(GP::parameters::first_samples(Vertex(100))), GP::Invalid_argument_error);
  EXPECT_THROW(with(GP::parameters::first_samples(Vertex(25))), GP::Invalid_argument_error);
  const auto speed = plane.add_property_map<Face, double>("f:speed", 1.).first;
  put(speed, Face(3), 0.);
  EXPECT_THROW(with(GP::parameters::face_speed_map(speed)), GP::Invalid_argument_error);
  put(speed, Face(3), std::nan(""));
  EXPECT_THROW(with(GP::parameters::face_speed_map(speed)), GP::Invalid_argument_error);
  EXPECT_THROW(with(GP::parameters::sharp_angle(-1.)), GP::Invalid_argument_error);
  for(const double spacing : {-1., std::nan(""), GP::internal::infinity})
    EXPECT_THROW(with(GP::parameters::curve_spacing(spacing)), GP::Invalid_argument_error);
  for(const double deviation : {0., -1., std::nan("")})
    EXPECT_THROW(with(GP::parameters::maximum_deviation(deviation)), GP::Invalid_argument_error);
  EXPECT_THROW(with(GP::parameters::sharp_angle(std::nan(""))), GP::Invalid_argument_error);
  EXPECT_TRUE(is_empty(output));
  GP::geodesic_delaunay_remeshing(Mesh(), 10, output);
  EXPECT_TRUE(is_empty(output));
  with(GP::parameters::first_samples(Vertex(12)));
  EXPECT_EQ(to_array(output.point(Vertex(0))), to_array(plane.point(Vertex(12))));
}

TEST(Geodesic_delaunay_remeshing, can_be_cancelled)
{
  const Mesh sphere = mesh_of(icosphere(3));
  Mesh output;
  EXPECT_THROW(GP::geodesic_delaunay_remeshing(sphere, 100, output,
                                               GP::parameters::callback(std::function<bool(double)>(
                                                   [](double done) { return done < 0.2; }))),
               GP::Cancelled);
  EXPECT_TRUE(is_empty(output));
}

} // namespace geodesic_delaunay_remeshing_test
