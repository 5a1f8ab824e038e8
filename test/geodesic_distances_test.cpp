// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_distances.h>

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/farthest_point_sampling.h>
#include <CGAL/Geodesic_processing/geodesic_distance_matrix.h>
#include <CGAL/Geodesic_processing/geodesic_path.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/property_map.h>

#include "Array_surface.h"
#include "Mesh_of.h"
#include "meshes.h"
#include "openmesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

namespace geodesic_distances_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Mesh_source = GP::Source<Mesh>;

// The sum of improvements that the front ignores; see the tests of the front.
constexpr double front_tolerance = 1e-10;

template <typename Sources>
std::vector<double> distances_from(Mesh& mesh, const Sources& sources)
{
  auto map = vertex_map(mesh);
  GP::geodesic_distances(mesh, sources, map);
  return values(mesh, map);
}

TEST(Geodesic_distances, are_exact_in_plane)
{
  const Triangulation plane = square(20, 0.24);
  Mesh mesh = mesh_of(plane);
  const auto d = distances_from(mesh, Vertex(100));
  EXPECT_LT(largest_error(d, [&](Index i) { return distance(plane.points[i], plane.points[100]); }),
            front_tolerance);
}

TEST(Geodesic_distances, accept_all_kinds_of_sources)
{
  const Triangulation plane = square(20, 0.24);
  Mesh mesh = mesh_of(plane);
  const auto expect = [&](const auto& sources, const auto& expected)
  { EXPECT_LT(largest_error(distances_from(mesh, sources), expected), front_tolerance); };

  const auto to = [&](Index k)
  { return [&, k](Index i) { return distance(plane.points[i], plane.points[k]); }; };
  expect(Vertex(5), to(5));
  expect(Mesh_source(Vertex(5)), to(5));
  expect(std::vector<Vertex>{Vertex(5)}, to(5));
  expect(std::vector<Mesh_source>{Vertex(5)}, to(5));

  for(const std::array<double, 3>& barycentric :
      {std::array<double, 3>{0.2, 0.3, 0.5}, {0.6, 0., 0.4}, {0., 1., 0.}})
  {
    const auto location = location_of(333, barycentric);
    const Point p = point_of(mesh, location);
    const auto to_p = [&](Index i) { return distance(plane.points[i], p); };
    expect(location, to_p);
    expect(Mesh_source(location), to_p);
    expect(std::vector<GP::Location<Mesh>>{location}, to_p);
    expect(std::array<Mesh_source, 1>{Mesh_source(location, 0.25)},
           [&](Index i) { return 0.25 + to_p(i); });
  }
  const std::vector<Vertex> corners = {Vertex(0), Vertex(440)};
  // In a triangle in which both fronts meet, each may have to follow an edge of length 1/20.
  EXPECT_LT(largest_error(distances_from(mesh, corners),
                          [&](Index i) { return std::min(to(0)(i), to(440)(i)); }),
            0.5 / 20.);
}

TEST(Geodesic_distances, accept_boundary_cycles_as_sources)
{
  const Triangulation plane = square(20, 0.24);
  Mesh mesh = mesh_of(plane);
  std::vector<Mesh_source> boundary_sources;
  GP::border_sources(mesh, std::back_inserter(boundary_sources));
  ASSERT_EQ(boundary_sources.size(), 1u);
  const auto d = distances_from(mesh, boundary_sources);
  const auto expected = [&](Index i)
  {
    const Point& p = plane.points[i];
    return std::min({p[0], p[1], 1. - p[0], 1. - p[1]});
  };
  // At the creases along the diagonals, and in triangles that touch the boundary at one corner
  // only. The error is a fraction of the edge length 1/20.
  EXPECT_LT(largest_error(d, expected), 0.2 / 20.);
}

TEST(Geodesic_distances, write_source_labels_and_predecessors)
{
  const Triangulation plane = square(20, 0.24);
  Mesh mesh = mesh_of(plane);
  auto map = vertex_map(mesh);
  auto label = vertex_map<std::size_t>(mesh);
  auto predecessor = vertex_map<Vertex>(mesh);
  const std::vector<Mesh_source> sources = {Mesh_source(Vertex(0), 0., 7), Mesh_source(Vertex(20)),
                                            Mesh_source(Vertex(440), 0.125, 7)};
  GP::geodesic_distances(mesh, sources, map,
                         GP::parameters::source_label_map(label).predecessor_map(predecessor));
  for(const Vertex v : mesh.vertices())
  {
    const Point& p = plane.points[v];
    const double to_7 =
                     std::min(distance(p, plane.points[0]), 0.125 + distance(p, plane.points[440])),
                 to_1 = distance(p, plane.points[20]);
    // Near the bisector, either source may be chosen.
    if(std::abs(to_7 - to_1) > 0.05)
    {
      EXPECT_EQ(label[v], to_7 < to_1 ? 7u : 1u);
    }
    if(predecessor[v] != v)
    {
      EXPECT_LT(map[predecessor[v]], map[v]);
      EXPECT_NE(mesh.halfedge(predecessor[v], v), Mesh::null_halfedge());
    }
    else
    {
      EXPECT_TRUE(v == Vertex(0) || v == Vertex(20) || v == Vertex(440));
    }
  }
}

TEST(Geodesic_distances, are_infinite_and_unlabeled_if_unreached)
{
  Mesh mesh = mesh_of(disjoint_union(square(4), tetrahedron()));
  auto map = vertex_map(mesh);
  auto label = vertex_map<std::size_t>(mesh);
  auto predecessor = vertex_map<Vertex>(mesh);
  GP::geodesic_distances(mesh, Vertex(0), map,
                         GP::parameters::source_label_map(label).predecessor_map(predecessor));
  for(std::size_t i = 25; i < 29; ++i)
  {
    const Vertex v{Mesh::size_type(i)};
    EXPECT_EQ(map[v], infinity);
    EXPECT_EQ(label[v], std::numeric_limits<std::size_t>::max());
    EXPECT_EQ(predecessor[v], v);
  }
}

TEST(Geodesic_distances, accept_vertex_and_face_speeds)
{
  Mesh mesh = mesh_of(jittered(icosphere(3), 0.02));
  auto original = vertex_map(mesh), scaled_distance = vertex_map(mesh), speed = vertex_map(mesh);
  auto face_speed = mesh.add_property_map<Face, double>("f:speed", 0.5).first;
  for(const Vertex v : mesh.vertices())
    speed[v] = 0.5;
  GP::geodesic_distances<GP::Fast_marching>(mesh, Vertex(3), original);
  GP::geodesic_distances<GP::Fast_marching>(mesh, Vertex(3), scaled_distance,
                                            GP::parameters::face_speed_map(face_speed));
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(scaled_distance[v], 2. * original[v]);
  GP::geodesic_distances<GP::Fast_marching>(mesh, Vertex(3), scaled_distance,
                                            GP::parameters::speed_map(speed));
  for(const Vertex v : mesh.vertices())
    EXPECT_NEAR(scaled_distance[v], 2. * original[v], 1e-13); // the mean of three halves is rounded
  GP::geodesic_distances(mesh, Vertex(3), original);
  GP::geodesic_distances(mesh, Vertex(3), scaled_distance,
                         GP::parameters::face_speed_map(face_speed));
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(scaled_distance[v], 2. * original[v]);
  face_speed[Face(0)] = 0.25; // then the default method is a front
  GP::geodesic_distances<GP::Euclidean_front>(mesh, Vertex(3), original,
                                              GP::parameters::face_speed_map(face_speed));
  GP::geodesic_distances(mesh, Vertex(3), scaled_distance,
                         GP::parameters::face_speed_map(face_speed));
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(scaled_distance[v], original[v]);
}

// Vertices and faces both convert to the keys of a map of a vector. A closed mesh has about twice
// as many faces as vertices.
// A speed of 1 everywhere is no speed, also for fronts that differ from those with speeds.
TEST(Geodesic_distances, ignore_speed_of_one)
{
  Mesh mesh = mesh_of(jittered(icosphere(3), 0.1));
  auto expected = vertex_map(mesh), found = vertex_map(mesh);
  const std::vector<double> ones(mesh.number_of_faces(), 1.);
  GP::geodesic_distances<GP::Euclidean_front>(mesh, Vertex(3), expected);
  GP::geodesic_distances<GP::Euclidean_front>(
      mesh, Vertex(3), found, GP::parameters::speed_map(CGAL::make_property_map(ones)));
  EXPECT_EQ(values(mesh, found), values(mesh, expected));
  GP::geodesic_distances<GP::Euclidean_front>(
      mesh, Vertex(3), found, GP::parameters::face_speed_map(CGAL::make_property_map(ones)));
  EXPECT_EQ(values(mesh, found), values(mesh, expected));

  const Surfels surfels = sphere_surfels(4);
  const auto domain = GP::make_domain(
      surfels, GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  std::vector<double> expected_on_cloud(surfels.size()), found_on_cloud(surfels.size());
  const std::vector<double> surfel_ones(surfels.size(), 1.);
  GP::geodesic_distances(domain, std::size_t(3), CGAL::make_property_map(expected_on_cloud));
  GP::geodesic_distances(domain, std::size_t(3), CGAL::make_property_map(found_on_cloud),
                         GP::parameters::speed_map(CGAL::make_property_map(surfel_ones)));
  EXPECT_EQ(found_on_cloud, expected_on_cloud);
}

// Fronts of both sides of a thin part mix, so that single distances are far too short.
TEST(Geodesic_distances, are_not_below_straight_lines_on_thin_clouds)
{
  Surfels surfels = sphere_surfels(3);
  constexpr double thickness = 0.03;
  for(auto& [p, n] : surfels)
  {
    p = Kernel::Point_3(p[0], p[1], thickness * p[2]);
    const double length = std::hypot(n[0], n[1], n[2] / thickness);
    n = Kernel::Vector_3(n[0], n[1], n[2] / thickness) / length;
  }
  const auto domain = GP::make_domain(
      surfels, GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  GP::Geodesic_distance_solver<Surfels> solver(domain);
  for(std::size_t source = 0; source < surfels.size(); source += 40)
  {
    solver.compute(source, GP::parameters::default_values());
    for(std::size_t i = 0; i < surfels.size(); ++i)
      EXPECT_GE(solver.distance(i),
                std::sqrt(CGAL::squared_distance(surfels[i].first, surfels[source].first)) - 1e-14);
  }
}

// With speed 4 everywhere, all results are a quarter of those without speeds, also for fronts that
// differ from those with speeds. Multiplications by 4 are exact.
template <typename Method, typename Domain>
void expect_quarter(const Domain& domain, typename Domain::Vertex from, typename Domain::Vertex to)
{
  using Surface = typename Domain::Surface;
  const std::size_t n = domain.triangles()->number_of_vertices();
  const std::vector<double> fours(n, 4.);
  const auto speed = GP::parameters::speed_map(CGAL::make_property_map(fours));
  GP::Geodesic_distance_solver<Surface, Method> without(domain), with(domain);
  const auto expect_equal = [&]
  {
    EXPECT_EQ(with.reached(), without.reached());
    for(const auto v : without.reached())
      EXPECT_EQ(4. * with.distance(v), without.distance(v));
  };
  without.compute(from);
  with.compute(from, speed);
  expect_equal();
  const double limit = 0.5 * without.distance(to);
  without.compute(from, GP::parameters::maximum_distance(limit));
  with.compute(from, speed.maximum_distance(0.25 * limit));
  expect_equal();
  EXPECT_LT(without.reached().size(), n);
  const std::vector<GP::Source<Surface>> sources = {{from, limit}, {to, 0.}},
                                         faster = {{from, 0.25 * limit}, {to, 0.}};
  without.compute(sources, GP::parameters::targets(from));
  with.compute(faster, speed.targets(from));
  expect_equal();
  // Without speeds again
  with.compute(from);
  without.compute(from);
  EXPECT_EQ(with.distance(to), without.distance(to));
}

TEST(Geodesic_distances, are_inverse_to_constant_speeds)
{
  Mesh mesh = mesh_of(jittered(icosphere(3), 0.1));
  const auto on_mesh = GP::make_domain(mesh);
  expect_quarter<GP::Euclidean_front>(on_mesh, Vertex(3), Vertex(100));
  expect_quarter<GP::Fast_marching>(on_mesh, Vertex(3), Vertex(100));
  expect_quarter<GP::Dijkstra>(on_mesh, Vertex(3), Vertex(100));
  const Surfels surfels = sphere_surfels(4);
  const auto on_cloud = GP::make_domain(
      surfels, GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  expect_quarter<GP::Euclidean_front>(on_cloud, std::size_t(3), std::size_t(100));
  expect_quarter<GP::Fast_marching>(on_cloud, std::size_t(3), std::size_t(100));
  expect_quarter<GP::Dijkstra>(on_cloud, std::size_t(3), std::size_t(100));
}

// Each sample uses the distances of the previous ones, which are travel times.
TEST(Geodesic_distances, samples_do_not_depend_on_constant_speed)
{
  Mesh mesh = mesh_of(jittered(icosphere(3), 0.1));
  const std::vector<double> fours(mesh.number_of_faces(), 4.);
  std::vector<Vertex> expected, found;
  std::vector<double> radii, with_speed;
  GP::farthest_vertex_sampling(mesh, 30, std::back_inserter(expected),
                               GP::parameters::covering_radius_output(std::back_inserter(radii)));
  GP::farthest_vertex_sampling(
      mesh, 30, std::back_inserter(found),
      GP::parameters::covering_radius_output(std::back_inserter(with_speed))
          .face_speed_map(CGAL::make_property_map(fours)));
  EXPECT_EQ(found, expected);
  ASSERT_EQ(with_speed.size(), radii.size());
  for(std::size_t i = 0; i < radii.size(); ++i)
    EXPECT_EQ(4. * with_speed[i], radii[i]);
}

TEST(Geodesic_distances, read_speeds_from_vectors)
{
  Mesh mesh = mesh_of(jittered(icosphere(3), 0.02));
  auto expected = vertex_map(mesh), found = vertex_map(mesh), speed = vertex_map(mesh);
  auto face_speed = mesh.add_property_map<Face, double>("f:speed").first;
  std::vector<double> speeds, face_speeds;
  for(const Vertex v : mesh.vertices())
    speeds.push_back(speed[v] = 1. + 0.5 * mesh.point(v).z());
  for(const Face f : mesh.faces())
    face_speeds.push_back(face_speed[f] = 1. + 0.1 * double(f % 7));
  GP::geodesic_distances(mesh, Vertex(3), expected, GP::parameters::speed_map(speed));
  GP::geodesic_distances(mesh, Vertex(3), found,
                         GP::parameters::speed_map(CGAL::make_property_map(speeds)));
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(found[v], expected[v]);
  GP::geodesic_distances(mesh, Vertex(3), expected, GP::parameters::face_speed_map(face_speed));
  GP::geodesic_distances(mesh, Vertex(3), found,
                         GP::parameters::face_speed_map(CGAL::make_property_map(face_speeds)));
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(found[v], expected[v]);
}

// A map of faces that is passed as speed_map does not compile, because this trait is asserted.
template <typename TriangleMesh>
void check_keys_of_speeds()
{
  using Graph = boost::graph_traits<TriangleMesh>;
  using Vertices =
      typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<double>>::type;
  using Faces =
      typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<double>>::type;
  using GP::internal::is_keyed_by;
  EXPECT_TRUE((is_keyed_by<Vertices, typename Graph::vertex_descriptor>));
  EXPECT_FALSE((is_keyed_by<Faces, typename Graph::vertex_descriptor>));
  EXPECT_TRUE((is_keyed_by<Faces, typename Graph::face_descriptor>));
  EXPECT_FALSE((is_keyed_by<Vertices, typename Graph::face_descriptor>));
}

TEST(Geodesic_distances, distinguish_speeds_of_vertices_and_faces)
{
  check_keys_of_speeds<Mesh>();
  check_keys_of_speeds<CGAL::Polyhedron_3<Kernel>>();
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  check_keys_of_speeds<OpenMesh::TriMesh_ArrayKernelT<>>();
#endif
}

TEST(Geodesic_distances, do_not_cross_obstacles)
{
  Mesh mesh = mesh_of(square(10));
  auto map = vertex_map(mesh), speed = vertex_map(mesh);
  for(const Vertex v : mesh.vertices())
    speed[v] = mesh.point(v).x() == 0.5 ? 0. : 1.;
  GP::geodesic_distances<GP::Fast_marching>(mesh, Vertex(0), map, GP::parameters::speed_map(speed));
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(map[v] < infinity, mesh.point(v).x() < 0.45);
  GP::geodesic_distances(mesh, Vertex(0), map, GP::parameters::speed_map(speed));
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(map[v] < infinity, mesh.point(v).x() < 0.45);
}

TEST(Geodesic_distances, accept_named_parameters_in_any_order)
{
  Mesh mesh = mesh_of(square(10, 0.24));
  auto map = vertex_map(mesh), other = vertex_map(mesh);
  auto label = vertex_map<std::size_t>(mesh);
  auto points = mesh.add_property_map<Vertex, Kernel::Point_3>().first;
  for(const Vertex v : mesh.vertices())
    points[v] = Kernel::Point_3(2. * mesh.point(v).x(), 2. * mesh.point(v).y(), 0.);
  int calls = 0;
  const std::function<bool(double)> callback = [&](double) { return ++calls > 0; };
  GP::geodesic_distances(mesh, Vertex(0), map,
                         GP::parameters::vertex_point_map(points)
                             .maximum_distance(1.)
                             .source_label_map(label)
                             .callback(callback)
                             .random_seed(1));
  GP::geodesic_distances(mesh, Vertex(0), other,
                         GP::parameters::maximum_distance(1.)
                             .callback(callback)
                             .random_seed(1)
                             .source_label_map(label)
                             .vertex_point_map(points));
  EXPECT_GE(calls, 2);
  for(const Vertex v : mesh.vertices())
  {
    EXPECT_EQ(map[v], other[v]);
    const double expected = std::hypot(points[v].x(), points[v].y());
    if(std::abs(expected - 1.) > 1e-6)
    {
      EXPECT_EQ(map[v] < infinity, expected < 1.);
      EXPECT_EQ(label[v], expected < 1. ? 0u : std::numeric_limits<std::size_t>::max());
    }
  }
  // A chain of CGAL's parameters only.
  GP::geodesic_distances(mesh, Vertex(0), map, CGAL::parameters::vertex_point_map(points));
  EXPECT_NEAR(map[Vertex(120)], 2. * std::sqrt(2.), front_tolerance);
}

TEST(Geodesic_distances, write_to_any_property_map)
{
  Mesh mesh = mesh_of(tetrahedron());
  std::map<Vertex, float> distances;
  GP::geodesic_distances(mesh, Vertex(0), boost::make_assoc_property_map(distances));
  EXPECT_EQ(distances.size(), 4u);
  EXPECT_NEAR(distances[Vertex(1)], std::sqrt(8.), 1e-6); // single precision
}

TEST(Geodesic_distances, agree_on_polyhedron)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Triangulation surface = jittered(icosphere(3), 0.03);
  Mesh mesh = mesh_of(surface);
  const auto d = distances_from(mesh, Vertex(9));
  Numbered<Polyhedron> polyhedron;
  fill(polyhedron, surface);
  std::map<boost::graph_traits<Polyhedron>::vertex_descriptor, double> distances;
  GP::geodesic_distances(polyhedron.mesh, polyhedron.vertices[9],
                         boost::make_assoc_property_map(distances));
  for(Index i = 0; i < d.size(); ++i)
    EXPECT_NEAR(distances[polyhedron.vertices[i]], d[i], 1e-8); // faces begin at other corners
}

TEST(Geodesic_distances, throw_on_invalid_input)
{
  Mesh mesh = mesh_of(square(3));
  auto map = vertex_map(mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto np = GP::parameters::maximum_distance(1.);
  EXPECT_THROW(GP::geodesic_distances(mesh, std::vector<Vertex>(), map, np),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_distances(mesh, Vertex(0), map, GP::parameters::maximum_distance(-1.)),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_distances(mesh, Vertex(0), map, GP::parameters::maximum_distance(nan)),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_distances(mesh, Mesh::null_vertex(), map), GP::Invalid_argument_error);
  for(const double bad : {-1., nan, infinity})
  {
    auto speed = mesh.add_property_map<Vertex, double>("v:bad", bad).first;
    EXPECT_THROW(GP::geodesic_distances(mesh, Vertex(0), map, GP::parameters::speed_map(speed)),
                 GP::Invalid_argument_error);
    mesh.remove_property_map(speed);
  }
  auto speed = mesh.add_property_map<Vertex, double>("v:speed", 2.).first;
  EXPECT_THROW(
      GP::geodesic_distances<GP::Heat>(mesh, Vertex(0), map, GP::parameters::speed_map(speed)),
      GP::Unsupported_surface_error);
  EXPECT_THROW(GP::geodesic_distances(mesh, Vertex(0), map,
                                      GP::parameters::targets(location_of(0, {2., -1., 0.}))),
               GP::Invalid_argument_error);
  Mesh quads;
  CGAL::make_grid(2, 2, quads);
  EXPECT_THROW(GP::geodesic_distances(quads, Vertex(0), vertex_map(quads)),
               GP::Unsupported_surface_error);
}

TEST(Geodesic_distances, are_exact_on_flat_point_set)
{
  const Surfels cloud = flat_surfels(4000);
  std::vector<double> d(cloud.size()), a(cloud.size());
  std::vector<std::size_t> labels(cloud.size());
  const auto np = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  const auto map_of = [](auto& values) { return CGAL::make_property_map(values); };
  GP::geodesic_distances(cloud, std::size_t(17), map_of(d), np.source_label_map(map_of(labels)));
  GP::geodesic_distances<GP::Dijkstra>(cloud, std::size_t(17), map_of(a), np);
  double mean = 0., mean_of_dijkstra = 0.;
  for(std::size_t i = 0; i < cloud.size(); ++i)
  {
    EXPECT_EQ(labels[i], 0u);
    const double expected = std::sqrt(CGAL::squared_distance(cloud[i].first, cloud[17].first));
    EXPECT_GE(a[i], expected * (1. - 1e-12)); // round-off error
    mean += std::abs(d[i] - expected) / double(cloud.size());
    mean_of_dijkstra += std::abs(a[i] - expected) / double(cloud.size());
  }
  // Interior distances are exact. At the boundary, paths detour around gaps of some radii of 0.03.
  EXPECT_LT(mean, 1e-3);
  EXPECT_LT(mean, 0.2 * mean_of_dijkstra);
}

TEST(Geodesic_distances, reach_duplicate_surfels_with_speeds)
{
  Surfels surfels = flat_surfels(300);
  const Surfels original = surfels;
  surfels.insert(surfels.end(), original.begin(), original.end());
  std::vector<double> speed(surfels.size(), 2.), map(surfels.size());
  const auto np = GP::parameters::point_map(Surfel_point_map())
                      .normal_map(Surfel_normal_map())
                      .speed_map(CGAL::make_property_map(speed));
  const auto check = [&](auto method)
  {
    // The source is a point that has a duplicate, and then the duplicate itself.
    for(const std::size_t source : {std::size_t(7), original.size() + 7})
    {
      GP::geodesic_distances<decltype(method)>(surfels, source, CGAL::make_property_map(map), np);
      for(std::size_t i = 0; i < original.size(); ++i)
      {
        EXPECT_LT(map[i], std::numeric_limits<double>::infinity());
        EXPECT_EQ(map[i], map[original.size() + i]);
      }
    }
  };
  check(GP::Fast_marching());
  check(GP::Euclidean_front());
}

TEST(Geodesic_distances, are_accurate_on_spherical_point_set)
{
  const Surfels cloud = sphere_surfels(4);
  std::vector<double> d(cloud.size());
  GP::geodesic_distances(
      cloud, std::size_t(100), CGAL::make_property_map(d),
      GP::parameters::normal_map(Surfel_normal_map()).point_map(Surfel_point_map()));
  const std::vector<Point> points = icosphere(4).points;
  // Local triangles between 2,562 surfels have the error of the mesh, 0.5 %.
  EXPECT_LT(
      mean_relative_error(d, 0.1, [&](Index i) { return great_circle(points[i], points[100]); }),
      0.01);
}

// Compares the default method and the default path with closed forms, on a cone and on a saddle
// whose coordinates are scaled.
template <typename Any_mesh>
void expect_exact_default(double scale, double tolerance)
{
  const Index n = 8;
  for(const double total : {1.5 * pi, 3. * pi})
  {
    Triangulation surface = cone(n, 4, total);
    for(Point& p : surface.points)
      for(double& coordinate : p)
        coordinate *= scale;
    Numbered<Any_mesh> numbered;
    fill(numbered, surface);
    std::map<typename Numbered<Any_mesh>::Vertex, double> distances;
    GP::geodesic_distances(numbered.mesh, numbered.vertices[1],
                           boost::make_assoc_property_map(distances));
    for(Index i = 1; i < surface.points.size(); ++i)
    {
      const double exact =
          scale * distance_on_cone(1., 1. + (i - 1) / n, (i - 1) % n * total / n, total);
      EXPECT_NEAR(distances[numbered.vertices[i]], exact, tolerance * scale);
      const auto path =
          GP::geodesic_path(numbered.mesh, numbered.vertices[1], numbered.vertices[i]);
      EXPECT_NEAR(path.length, exact, tolerance * scale);
      EXPECT_LE(path.lower, path.length);
    }
  }
}

TEST(Geodesic_distances, default_is_exact_at_all_scales)
{
  // Some tens of round-off errors of distances below 10.
  constexpr double tolerance = 1e-13;
  for(const double scale : {1e-6, 1., 1e6})
  {
    expect_exact_default<Mesh>(scale, tolerance);
    expect_exact_default<CGAL::Polyhedron_3<Kernel>>(scale, tolerance);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
    // Its coordinates have single precision.
    expect_exact_default<OpenMesh::TriMesh_ArrayKernelT<>>(scale, 1e-5);
#endif
  }
}

// Compares bounds with exact distances on a sphere whose coordinates are scaled.
template <typename Any_mesh>
void expect_bounds_contain_distances(double scale)
{
  Triangulation sphere = jittered(icosphere(4), 0.02); // without thin triangles
  for(Point& p : sphere.points)
    for(double& coordinate : p)
      coordinate *= scale;
  Numbered<Any_mesh> numbered;
  fill(numbered, sphere);
  GP::Geodesic_distance_solver<Any_mesh> exact(numbered.mesh), approximate(numbered.mesh);
  exact.compute(numbered.vertices[7]);
  const double tolerance = 1e-3;
  approximate.compute(numbered.vertices[7], GP::parameters::relative_tolerance(tolerance));
  double largest_gap = 0.;
  for(const auto v : numbered.vertices)
  {
    const double distance = exact.distance(v), lower = approximate.lower(v),
                 upper = approximate.upper(v);
    EXPECT_EQ(exact.lower(v), distance);
    EXPECT_EQ(exact.upper(v), distance);
    const double round_off = 1e-12; // of some hundred sums
    EXPECT_LE(lower, distance * (1. + round_off));
    EXPECT_GE(upper, distance * (1. - round_off));
    EXPECT_LE(upper, lower * (1. + tolerance * (1. + 1e-6))); // errors are stored as floats
    EXPECT_GE(approximate.distance(v), lower);
    EXPECT_LE(approximate.distance(v), upper);
    EXPECT_GE(approximate.path(v).length, lower * (1. - round_off));
    largest_gap = std::max(largest_gap, upper - lower);
  }
  // Windows are merged: a gap of a tenth of the tolerance.
  EXPECT_GT(largest_gap, 1e-4 * scale);
}

TEST(Geodesic_distances, relative_tolerance_gives_bounds_at_all_scales)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    expect_bounds_contain_distances<Mesh>(scale);
    expect_bounds_contain_distances<CGAL::Polyhedron_3<Kernel>>(scale);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
    expect_bounds_contain_distances<OpenMesh::TriMesh_ArrayKernelT<>>(scale);
#endif
  }
}

// All functions with distances of Heat read the time step, and compute the distances of a solver.
TEST(Geodesic_distances, depend_on_heat_time_step)
{
  Mesh mesh = mesh_of(jittered(icosphere(3), 0.02));
  const auto np = GP::parameters::heat_time_step(30.);
  auto map = vertex_map(mesh), default_map = mesh.add_property_map<Vertex, double>("v:d").first,
       one_map = mesh.add_property_map<Vertex, double>("v:one").first;
  GP::geodesic_distances<GP::Heat>(mesh, Vertex(0), map, np);
  GP::geodesic_distances<GP::Heat>(mesh, Vertex(0), default_map);
  GP::geodesic_distances<GP::Heat>(mesh, Vertex(0), one_map, GP::parameters::heat_time_step(1.));
  EXPECT_EQ(values(mesh, one_map), values(mesh, default_map));
  GP::Geodesic_distance_solver<Mesh, GP::Heat> solver(mesh, np);
  solver.compute(Vertex(0));
  double largest_change = 0.;
  for(const Vertex v : mesh.vertices())
  {
    EXPECT_EQ(map[v], solver.distance(v));
    largest_change = std::max(largest_change, std::abs(map[v] - default_map[v]));
  }
  EXPECT_GT(largest_change, 0.01); // the mean edge length is 0.15
  const std::vector<Vertex> targets = {Vertex(5), Vertex(100)};
  const auto matrix = GP::geodesic_distance_matrix<GP::Heat>(
      mesh, Vertex(0), GP::parameters::targets(targets).heat_time_step(30.));
  EXPECT_EQ(matrix(0, 0), map[targets[0]]);
  EXPECT_EQ(matrix(0, 1), map[targets[1]]);
  EXPECT_EQ(GP::geodesic_path<GP::Heat>(mesh, Vertex(100), Vertex(0), np).front_distance,
            map[Vertex(100)]);
}

TEST(Geodesic_distances, on_clouds_depend_on_heat_time_step)
{
  const Surfels surfels = flat_surfels(2000);
  const auto compute = [&](const auto& np)
  {
    std::vector<double> result(surfels.size());
    GP::geodesic_distances<GP::Heat>(
        surfels, std::size_t(0), CGAL::make_property_map(result),
        np.point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
    return result;
  };
  const std::vector<double> small = compute(GP::parameters::heat_time_step(1.)),
                            large = compute(GP::parameters::heat_time_step(1000.));
  double small_error = 0., large_error = 0.;
  for(std::size_t i = 0; i < surfels.size(); ++i)
  {
    const double exact = std::sqrt(CGAL::squared_distance(surfels[0].first, surfels[i].first));
    small_error += std::abs(small[i] - exact);
    large_error += std::abs(large[i] - exact);
  }
  // The longer heat flows, the more its directions depend on the boundary.
  EXPECT_LT(small_error, 0.5 * large_error);
}

TEST(Geodesic_distances, throw_on_invalid_heat_time_step)
{
  Mesh mesh = mesh_of(icosphere(1));
  auto map = vertex_map(mesh);
  for(const double bad : {0., -1., std::nan(""), GP::internal::infinity})
    EXPECT_THROW(
        GP::geodesic_distances<GP::Heat>(mesh, Vertex(0), map, GP::parameters::heat_time_step(bad)),
        GP::Invalid_argument_error);
  const auto np = GP::parameters::heat_time_step(2.);
  EXPECT_THROW(GP::geodesic_distances(mesh, Vertex(0), map, np), GP::Unsupported_surface_error);
  EXPECT_THROW(GP::geodesic_distance_matrix<GP::Dijkstra>(mesh, Vertex(0), np),
               GP::Unsupported_surface_error);
}

} // namespace geodesic_distances_test
