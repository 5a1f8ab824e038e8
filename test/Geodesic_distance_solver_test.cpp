// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace Geodesic_distance_solver_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Mesh_source = GP::Source<Mesh>;

// Round-off errors of sums of some tens of lengths below 4.
constexpr double round_off = 1e-12;

// A front corrects a final vertex if its distance changes by more than 1e-12. Errors below add up.
constexpr double front_tolerance = 1e-10;

template <typename Method>
class Geodesic_distance_solver : public testing::Test
{
public:
  using Solver = GP::Geodesic_distance_solver<Mesh, Method>;

  const Mesh mesh = mesh_of(jittered(icosphere(4), 0.01));
  const GP::Mesh_domain<Mesh> domain{mesh};

  std::vector<double> distances(const Solver& solver) const
  {
    std::vector<double> result;
    for(const Vertex v : mesh.vertices())
      result.push_back(solver.distance(v));
    return result;
  }
};

using Methods = testing::Types<GP::Dijkstra, GP::Fast_marching, GP::Euclidean_front, GP::Exact,
                               GP::Heat, GP::Automatic>;
TYPED_TEST_SUITE(Geodesic_distance_solver, Methods);

TYPED_TEST(Geodesic_distance_solver, is_independent_of_previous_queries)
{
  using Solver = typename TestFixture::Solver;
  Solver reused(this->domain);
  std::mt19937 random(1);
  for(int i = 0; i < 6; ++i)
  {
    const std::vector<Mesh_source> sources = {random_location_of(this->mesh, random),
                                              Vertex(Mesh::size_type(random() % 2000))};
    Solver fresh(this->domain);
    if(i % 2 == 0)
    {
      fresh.compute(sources);
      reused.compute(sources);
    }
    else
    {
      fresh.compute(sources, GP::parameters::maximum_distance(0.5));
      reused.compute(sources, GP::parameters::maximum_distance(0.5));
    }
    EXPECT_EQ(this->distances(reused), this->distances(fresh));
    EXPECT_EQ(reused.reached(), fresh.reached());
  }
}

TYPED_TEST(Geodesic_distance_solver, copies_compute_concurrently)
{
  using Solver = typename TestFixture::Solver;
  Solver first(this->domain), expected = first;
  Solver second = first;
  std::thread other([&] { second.compute(Vertex(900)); });
  first.compute(Vertex(3));
  other.join();
  expected.compute(Vertex(3));
  EXPECT_EQ(this->distances(first), this->distances(expected));
  expected.compute(Vertex(900));
  EXPECT_EQ(this->distances(second), this->distances(expected));
}

TYPED_TEST(Geodesic_distance_solver, written_maps_match_queries)
{
  using Solver = typename TestFixture::Solver;
  Mesh mesh = this->mesh;
  Solver solver(mesh);
  solver.compute(std::vector<Mesh_source>{Mesh_source(Vertex(3), 0., 5), Vertex(1000)},
                 GP::parameters::maximum_distance(1.));
  auto distance = vertex_map(mesh);
  auto label = vertex_map<std::size_t>(mesh);
  auto predecessor = vertex_map<Vertex>(mesh);
  solver.write_distances(distance);
  solver.write_source_labels(label);
  solver.write_predecessors(predecessor);
  const auto reached = solver.reached();
  for(const Vertex v : mesh.vertices())
  {
    EXPECT_EQ(distance[v], solver.distance(v));
    EXPECT_EQ(label[v], solver.source_label(v));
    EXPECT_EQ(predecessor[v], solver.predecessor(v));
    EXPECT_EQ(distance[v] < infinity,
              std::find(reached.begin(), reached.end(), v) != reached.end());
    if(distance[v] < infinity)
    {
      EXPECT_LE(distance[v], 1.);
      EXPECT_TRUE(label[v] == 5 || label[v] == 1);
    }
  }
  EXPECT_LT(reached.size(), mesh.number_of_vertices());
}

TYPED_TEST(Geodesic_distance_solver, distances_of_targets_match_full_run)
{
  using Solver = typename TestFixture::Solver;
  Solver solver(this->domain), full(this->domain);
  std::mt19937 random(2);
  full.compute(Vertex(3));
  for(int i = 0; i < 10; ++i)
  {
    const auto target = random_location_of(this->mesh, random);
    solver.compute(Vertex(3), GP::parameters::targets(target));
    EXPECT_NEAR(solver.distance(target), full.distance(target), front_tolerance);
    const std::vector<Vertex> targets = {Vertex(10), Vertex(Mesh::size_type(random() % 2000))};
    solver.compute(Vertex(3), GP::parameters::targets(targets));
    for(const Vertex v : targets)
      EXPECT_NEAR(solver.distance(v), full.distance(v), front_tolerance);
  }
}

TYPED_TEST(Geodesic_distance_solver, respects_maximum_distance_inside_faces)
{
  using Solver = typename TestFixture::Solver;
  Solver solver(this->domain), full(this->domain);
  std::mt19937 random(2);
  full.compute(Vertex(3));
  solver.compute(Vertex(3), GP::parameters::maximum_distance(0.5));
  for(int i = 0; i < 200; ++i)
  {
    const auto location = random_location_of(this->mesh, random);
    const double full_distance = full.distance(location);
    if(full_distance > 0.5 + front_tolerance)
    {
      EXPECT_EQ(solver.distance(location), infinity);
    }
    else if(full_distance < 0.4) // in the interior, all corners are within the limit
    {
      EXPECT_NEAR(solver.distance(location), full_distance, front_tolerance);
    }
  }
}

TYPED_TEST(Geodesic_distance_solver, keeps_results_if_an_argument_is_invalid)
{
  typename TestFixture::Solver solver(this->domain);
  const std::vector<Mesh_source> sources = {Vertex(3), Vertex(500)};
  solver.compute(sources);
  const std::vector<double> distances = this->distances(solver);
  const std::vector<Mesh_source> invalid = {Vertex(3), Mesh::null_vertex()};
  EXPECT_THROW(solver.compute(invalid), GP::Invalid_argument_error);
  EXPECT_THROW(solver.compute(sources, GP::parameters::maximum_distance(-1.)),
               GP::Invalid_argument_error);
  EXPECT_EQ(this->distances(solver), distances);
  EXPECT_EQ(solver.source_label(Vertex(3)), 0u);
  EXPECT_EQ(solver.source_label(Vertex(500)), 1u);
}

TYPED_TEST(Geodesic_distance_solver, has_no_label_and_no_path_beyond_maximum_distance)
{
  typename TestFixture::Solver solver(this->domain);
  solver.compute(Vertex(3), GP::parameters::maximum_distance(0.5));
  std::size_t number_of_unreached = 0;
  for(const Vertex v : this->mesh.vertices())
    if(std::isinf(solver.distance(v)))
    {
      ++number_of_unreached;
      EXPECT_EQ(solver.source_label(v), (std::numeric_limits<std::size_t>::max)());
      EXPECT_EQ(solver.predecessor(v), v);
      EXPECT_TRUE(solver.path(v).empty());
    }
  EXPECT_GT(number_of_unreached, 0u);
}

// The label of the last result is beyond the sources of the interrupted query.
TYPED_TEST(Geodesic_distance_solver, can_be_read_after_exception_of_callback)
{
  typename TestFixture::Solver solver(this->domain);
  solver.compute(std::vector<Mesh_source>{Vertex(3), Vertex(500)});
  const auto throw_exception = [](double) -> bool { throw std::logic_error("interrupted"); };
  EXPECT_THROW(solver.compute(Vertex(3), GP::parameters::callback(throw_exception)),
               std::logic_error);
  for(const Vertex v : this->mesh.vertices())
    EXPECT_NE(solver.source_label(v), 1u);
}

// The second source of the last result is beyond the sources of the query that is not supported.
TYPED_TEST(Geodesic_distance_solver, keeps_results_if_query_is_not_supported)
{
  typename TestFixture::Solver solver(this->domain);
  const std::vector<Mesh_source> sources = {Vertex(3), Vertex(500)};
  solver.compute(sources);
  const std::vector<double> distances = this->distances(solver);
  std::vector<double> speeds(distances.size(), 1.);
  speeds[0] = 2.;
  try
  {
    solver.compute(Vertex(7), GP::parameters::relative_tolerance(0.1).speed_map(
                                  CGAL::make_property_map(speeds)));
    FAIL() << "No method admits both a tolerance and speeds.";
  }
  catch(const GP::Unsupported_surface_error&)
  {}
  EXPECT_EQ(this->distances(solver), distances);
  EXPECT_EQ(solver.source_label(Vertex(500)), 1u);
  EXPECT_EQ(solver.path(Vertex(500)).locations.size(), 1u);
}

TYPED_TEST(Geodesic_distance_solver, reports_cancellation)
{
  using Solver = typename TestFixture::Solver;
  Solver solver(this->domain);
  EXPECT_THROW(solver.compute(Vertex(3), GP::parameters::callback(std::function<bool(double)>(
                                             [](double) { return false; }))),
               GP::Cancelled);
  EXPECT_TRUE(solver.reached().empty());
  EXPECT_EQ(solver.distance(Vertex(3)), infinity);
  solver.compute(Vertex(3), GP::parameters::callback(
                                std::function<bool(double)>([](double) { return true; })));
  EXPECT_EQ(solver.reached().size(), this->mesh.number_of_vertices());
}

TYPED_TEST(Geodesic_distance_solver, distances_are_continuous)
{
  using Solver = typename TestFixture::Solver;
  Solver solver(this->domain);
  solver.compute(std::vector<Vertex>{Vertex(3), Vertex(1000)});
  for(const Face f : this->mesh.faces())
  {
    // Each exact distance in a face is a separate search, so only some faces are tested.
    if(std::is_same_v<TypeParam, GP::Exact> && f % 20 != 0)
      continue;
    auto h = this->mesh.halfedge(f);
    for(int k = 0; k < 3; ++k, h = this->mesh.next(h))
    {
      std::array<double, 3> corner = {0., 0., 0.};
      corner[k] = 1.;
      EXPECT_EQ(solver.distance({f, corner}), solver.distance(this->mesh.source(h)));
      // The midpoint of an edge, located in both incident faces.
      std::array<double, 3> middle = {0.5, 0.5, 0.5};
      middle[(k + 2) % 3] = 0.;
      const auto opposite = this->mesh.opposite(h);
      const Face other = this->mesh.face(opposite);
      std::array<double, 3> barycentric_in_other = {0.5, 0.5, 0.5};
      auto g = this->mesh.halfedge(other);
      for(int i = 0; i < 3; ++i, g = this->mesh.next(g))
        if(this->mesh.prev(g) == opposite)
          barycentric_in_other[(i + 1) % 3] = 0.;
      // Round-off errors of the same evaluations.
      EXPECT_NEAR(solver.distance({f, middle}), solver.distance({other, barycentric_in_other}),
                  round_off);
    }
  }
}

TEST(Default_geodesic_distance_solver, is_exact_unless_speeds_differ)
{
  const Mesh mesh = mesh_of(jittered(icosphere(3), 0.1));
  GP::Geodesic_distance_solver<Mesh> solver(mesh);
  GP::Geodesic_distance_solver<Mesh, GP::Exact> exact(mesh);
  GP::Geodesic_distance_solver<Mesh, GP::Euclidean_front> front(mesh);
  solver.compute(Vertex(7));
  exact.compute(Vertex(7));
  for(const Vertex v : mesh.vertices())
  {
    EXPECT_EQ(solver.distance(v), exact.distance(v));
    EXPECT_EQ(solver.predecessor(v), exact.predecessor(v));
  }
  EXPECT_EQ(solver.path(Vertex(300)).length, exact.path(Vertex(300)).length);
  EXPECT_EQ(solver.departure(Vertex(300)).polar_angle, exact.departure(Vertex(300)).polar_angle);
  EXPECT_EQ(solver.shortest_paths(Vertex(300)).size(), exact.shortest_paths(Vertex(300)).size());

  Mesh copy = mesh;
  auto speed = copy.add_property_map<Face, double>("f:speed", 1.).first;
  speed[Face(20)] = 0.5;
  solver.compute(Vertex(7), GP::parameters::face_speed_map(speed));
  front.compute(Vertex(7), GP::parameters::face_speed_map(speed));
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(solver.distance(v), front.distance(v));
  EXPECT_EQ(solver.path(Vertex(300)).length, front.path(Vertex(300)).length);
  EXPECT_THROW(solver.departure(Vertex(300)), GP::Unsupported_surface_error);
  EXPECT_THROW(solver.shortest_paths(Vertex(300)), GP::Unsupported_surface_error);
  EXPECT_THROW(exact.compute(Vertex(7), GP::parameters::face_speed_map(speed)),
               GP::Unsupported_surface_error);
}

TEST(Default_geodesic_distance_solver, is_exact_around_obstacles)
{
  // A wall with a gap at the end, so that the shortest way is bent at the end of the wall.
  const std::size_t n = 10;
  Mesh mesh = mesh_of(square(n));
  auto speed = mesh.add_property_map<Face, double>("f:speed", 1.).first;
  for(const Face f : mesh.faces())
  {
    double x = 0., y = 0.;
    for(const Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    {
      x += mesh.point(v).x() / 3.;
      y += mesh.point(v).y() / 3.;
    }
    if(x > 0.5 && x < 0.6 && y < 0.7)
      speed[f] = 0.;
  }
  GP::Geodesic_distance_solver<Mesh> solver(mesh);
  solver.compute(Vertex(0), GP::parameters::face_speed_map(speed));
  const Vertex to(static_cast<Mesh::size_type>(n));
  const double expected = std::hypot(0.5, 0.7) + 0.1 + std::hypot(0.4, 0.7);
  EXPECT_NEAR(solver.distance(to), expected, round_off);
  const auto path = solver.path(to);
  EXPECT_NEAR(path.length, expected, round_off);
  EXPECT_LE(path.lower, expected);
  EXPECT_GE(path.lower, expected * (1. - 1e-11)); // the tolerance of exact paths
}

// Distances are travel times plus the offset of the source. The lower bound of a path is a length.
TEST(Default_geodesic_distance_solver, lower_bound_of_path_is_a_length)
{
  Mesh mesh = mesh_of(square(10));
  const Vertex from(0), to(120); // opposite corners
  const double expected = std::sqrt(2.), tolerance = 0.01;
  GP::Geodesic_distance_solver<Mesh> solver(mesh);
  for(const double speed : {0.5, 1., 2.})
  {
    auto speeds = mesh.add_property_map<Face, double>("f:speed", speed).first;
    for(const double offset : {0., 10.})
    {
      const GP::Source<Mesh> source(from, offset);
      const auto np = GP::parameters::face_speed_map(speeds);
      solver.compute(source, np.relative_tolerance(tolerance));
      EXPECT_NEAR(solver.distance(to), offset + expected / speed,
                  tolerance * (offset + expected / speed));
      const auto path = solver.path(to);
      EXPECT_NEAR(path.length, expected, round_off);
      EXPECT_LE(path.lower, expected * (1. + round_off));
      EXPECT_GE(path.lower, expected * (1. - tolerance) - round_off);
    }
    mesh.remove_property_map(speeds);
  }
}

TEST(Default_geodesic_distance_solver, is_the_euclidean_front_on_clouds)
{
  const Surfels cloud = sphere_surfels(3);
  const auto np = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  const GP::Surfel_domain<Surfels> domain(cloud, np);
  GP::Geodesic_distance_solver<Surfels> solver(domain);
  GP::Geodesic_distance_solver<Surfels, GP::Euclidean_front> front(domain);
  solver.compute(std::size_t(5));
  front.compute(std::size_t(5));
  for(std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_EQ(solver.distance(i), front.distance(i));
}

TYPED_TEST(Geodesic_distance_solver, distances_of_ranges_match_single_ones)
{
  using Solver = typename TestFixture::Solver;
  Solver solver(this->domain);
  solver.compute(Vertex(3));
  std::mt19937 random(1);
  std::vector<GP::Location<Mesh>> locations;
  for(int i = 0; i < 20; ++i)
    locations.push_back(random_location_of(this->mesh, random));
  std::vector<double> distances;
  solver.distances(locations, std::back_inserter(distances));
  ASSERT_EQ(distances.size(), locations.size());
  for(std::size_t i = 0; i < locations.size(); ++i)
    EXPECT_NEAR(distances[i], solver.distance(locations[i]), round_off);
  distances.clear();
  solver.distances(Vertex(30), std::back_inserter(distances));
  EXPECT_EQ(distances, std::vector<double>{solver.distance(Vertex(30))});
}

TEST(Exact_geodesic_distance_solver, finds_all_shortest_paths)
{
  // Both paths around a pipe to the opposite point.
  const Mesh mesh = mesh_of(cylinder(16, 8, 1., 2.));
  GP::Geodesic_distance_solver<Mesh, GP::Exact> solver(mesh);
  solver.compute(Vertex(16 * 3));
  const auto both_paths = solver.shortest_paths(Vertex(16 * 3 + 8));
  ASSERT_EQ(both_paths.size(), 2u);
  const double half_circumference = 16. * std::sin(pi / 16.); // half of the polygon's circumference
  for(const auto& path : both_paths)
  {
    EXPECT_NEAR(path.length, half_circumference, round_off);
    EXPECT_NEAR(path.front_distance, half_circumference, round_off);
    EXPECT_LT(distance(to_array(path.points.front()), to_array(mesh.point(Vertex(16 * 3 + 8)))),
              round_off);
    EXPECT_LT(distance(to_array(path.points.back()), to_array(mesh.point(Vertex(16 * 3)))),
              round_off);
  }
  EXPECT_EQ(solver.shortest_paths(Vertex(16 * 3 + 7)).size(), 1u);
  EXPECT_EQ(solver.shortest_paths(location_of(7, {0.2, 0.3, 0.5})).size(), 1u);
}

TEST(Exact_geodesic_distance_solver, rejects_invalid_relative_tolerances)
{
  Mesh mesh = mesh_of(square(4));
  GP::Geodesic_distance_solver<Mesh> solver(mesh);
  for(const double tolerance : {-1., std::nan("")})
    EXPECT_THROW(solver.compute(Vertex(0), GP::parameters::relative_tolerance(tolerance)),
                 GP::Invalid_argument_error);
  // With speeds, the default method is a front.
  auto speed = mesh.add_property_map<Face, double>("f:speed", 1.).first;
  speed[Face(3)] = 2.;
  EXPECT_THROW(
      solver.compute(Vertex(0), GP::parameters::relative_tolerance(0.1).face_speed_map(speed)),
      GP::Unsupported_surface_error);
  GP::Geodesic_distance_solver<Mesh, GP::Euclidean_front> front(mesh);
  EXPECT_THROW(front.compute(Vertex(0), GP::parameters::relative_tolerance(0.1)),
               GP::Unsupported_surface_error);
  solver.compute(Vertex(0), GP::parameters::relative_tolerance(0.1));
  EXPECT_THROW(solver.departure(Vertex(20)), GP::Unsupported_surface_error);
  EXPECT_THROW(solver.shortest_paths(Vertex(20)), GP::Unsupported_surface_error);
}

TEST(Exact_geodesic_distance_solver, departures_match_directions_in_plane)
{
  const Triangulation plane = square(16, 0.24);
  const Mesh mesh = mesh_of(plane);
  GP::Geodesic_distance_solver<Mesh, GP::Exact> solver(mesh);
  // Departure directions follow the first segments of paths, which may be short.
  const double direction_error = 1e-10;
  std::mt19937 random(1);
  const auto location = location_of(300, {0.2, 0.3, 0.5});
  const std::vector<GP::Source<Mesh>> sources = {{Vertex(8 * 17 + 8)}, {location, 0.3}};
  for(const auto& source : sources)
  {
    solver.compute(source);
    const Point from = source.offset() == 0. ? plane.points[8 * 17 + 8] : point_of(mesh, location);
    const double first = solver.departure(Vertex(0)).polar_angle -
                         std::atan2(plane.points[0][1] - from[1], plane.points[0][0] - from[0]);
    for(int i = 0; i < 20; ++i)
    {
      const auto to = random_location_of(mesh, random);
      const Point p = point_of(mesh, to);
      const auto departure = solver.departure(to);
      EXPECT_NEAR(departure.length, distance(from, p), round_off);
      EXPECT_LT(distance(point_of(mesh, departure.from), from), round_off);
      EXPECT_NEAR(departure.direction.x() * departure.length, p[0] - from[0], direction_error);
      EXPECT_NEAR(departure.direction.y() * departure.length, p[1] - from[1], direction_error);
      EXPECT_NEAR(
          std::remainder(departure.polar_angle - first - std::atan2(p[1] - from[1], p[0] - from[0]),
                         2. * pi),
          0., direction_error);
    }
  }
  solver.compute(Vertex(0), GP::parameters::maximum_distance(0.1));
  const auto unreachable = solver.departure(Vertex(200));
  EXPECT_EQ(unreachable.length, infinity);
  EXPECT_EQ(unreachable.direction, CGAL::NULL_VECTOR);
}

} // namespace Geodesic_distance_solver_test
