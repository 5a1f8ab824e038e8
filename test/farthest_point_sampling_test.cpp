// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/farthest_point_sampling.h>

#include <CGAL/Geodesic_processing/geodesic_distances.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>

#include "Array_surface.h"
#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

namespace farthest_point_sampling_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using GP::internal::operator*;
using Samples = std::vector<GP::Location<Mesh>>;
using Radii = std::vector<double>;

const std::size_t all = std::numeric_limits<std::size_t>::max();

Samples sampled(const Mesh& mesh, std::size_t number)
{
  Samples samples;
  GP::farthest_point_sampling(mesh, number, std::back_inserter(samples));
  return samples;
}

TEST(Farthest_point_sampling, starts_at_square_corners)
{
  const Mesh mesh = mesh_of(square(20, 0.2));
  std::set<Point> corners;
  for(const auto& sample : sampled(mesh, 4))
    corners.insert(point_of(mesh, sample));
  EXPECT_EQ(corners, (std::set<Point>{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {1., 1., 0.}}));
}

TEST(Farthest_point_sampling, second_sample_on_sphere_is_antipodal)
{
  const Mesh mesh = mesh_of(icosphere(4));
  const Samples samples = sampled(mesh, 2);
  ASSERT_EQ(samples.size(), 2u);
  // The longest edge of this icosphere.
  EXPECT_LT(distance(point_of(mesh, samples[0]), -1. * point_of(mesh, samples[1])), 0.0812);
}

TEST(Farthest_point_sampling, samples_cover_and_are_separated)
{
  Mesh mesh = mesh_of(square(30, 0.2));
  std::vector<Vertex> sampled_vertices;
  Radii radii;
  auto label = vertex_map<std::size_t>(mesh);
  GP::farthest_vertex_sampling(mesh, 60, std::back_inserter(sampled_vertices),
                               GP::parameters::covering_radius_output(std::back_inserter(radii))
                                   .random_seed(3)
                                   .source_label_map(label));
  ASSERT_EQ(sampled_vertices.size(), 60u);
  ASSERT_EQ(radii.size(), 60u);
  EXPECT_TRUE(std::is_sorted(radii.rbegin(), radii.rend()));
  // On cell boundaries, a distance may be too long by some thousandths of an edge length.
  const double error = 0.01 / 30.;
  const auto vertex_distance = [&](Vertex a, Vertex b)
  { return std::sqrt(CGAL::squared_distance(mesh.point(a), mesh.point(b))); };
  for(std::size_t i = 1; i < 60; ++i)
    for(std::size_t j = 0; j < i; ++j)
      EXPECT_GE(vertex_distance(sampled_vertices[i], sampled_vertices[j]), radii[i - 1] - error);
  for(const Vertex v : mesh.vertices())
  {
    double nearest = GP::internal::infinity;
    for(const Vertex sampled_vertex : sampled_vertices)
      nearest = std::min(nearest, vertex_distance(sampled_vertex, v));
    EXPECT_LE(nearest, radii.back() + error);
    ASSERT_LT(get(label, v), 60u);
    EXPECT_LE(vertex_distance(sampled_vertices[get(label, v)], v), nearest + error);
  }
}

TEST(Farthest_point_sampling, stops_at_covering_radius)
{
  const Mesh mesh = mesh_of(square(20, 0.2));
  Samples samples;
  Radii radii;
  GP::farthest_point_sampling(
      mesh, all, std::back_inserter(samples),
      GP::parameters::covering_radius(0.15).covering_radius_output(std::back_inserter(radii)));
  EXPECT_LE(radii.back(), 0.15);
  EXPECT_GT(radii[radii.size() - 2], 0.15);
  // Disks of radius r / 2 do not overlap, and disks of radius r cover the square. Their number is
  // at least 1 / (pi r^2). Widening the square by r / 2 on each side yields the upper bound.
  EXPECT_GT(samples.size(), 1. / (pi * 0.15 * 0.15));
  EXPECT_LT(samples.size(), 1.15 * 1.15 / (pi * 0.075 * 0.075));
}

// Without a limit of the number, progress follows from the covering radius.
TEST(Farthest_point_sampling, reports_progress_towards_covering_radius)
{
  const Mesh mesh = mesh_of(square(20, 0.2));
  Samples samples;
  std::vector<double> fractions;
  GP::farthest_point_sampling(mesh, all, std::back_inserter(samples),
                              GP::parameters::covering_radius(0.05).callback(
                                  [&](double fraction)
                                  {
                                    fractions.push_back(fraction);
                                    return true;
                                  }));
  ASSERT_FALSE(fractions.empty());
  EXPECT_EQ(fractions.front(), 0.);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_LE(fractions.back(), 1.);
  // The radius of the next to last sample is less than a third larger than that of the last one.
  EXPECT_GT(fractions.back(), 0.5);
  // Half of the progress is reached after a quarter to three quarters of the calls.
  const auto half = std::lower_bound(fractions.begin(), fractions.end(), 0.5);
  const double calls = double(half - fractions.begin()) / double(fractions.size());
  EXPECT_GT(calls, 0.25);
  EXPECT_LT(calls, 0.75);
}

TEST(Farthest_point_sampling, continues_from_first_samples)
{
  Mesh mesh = mesh_of(square(20, 0.2));
  Samples samples;
  auto label = vertex_map<std::size_t>(mesh);
  GP::farthest_point_sampling(
      mesh, 1, std::back_inserter(samples),
      GP::parameters::first_samples(std::vector<Vertex>{Vertex(0), Vertex(20), Vertex(420)})
          .source_label_map(label));
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_EQ(point_of(mesh, samples[0]), (Point{1., 1., 0.}));
  EXPECT_EQ(get(label, Vertex(0)), 0u);
  EXPECT_EQ(get(label, Vertex(20)), 1u);
  EXPECT_EQ(get(label, Vertex(440)), 3u);

  // Samples in two calls or in one.
  Samples two = sampled(mesh, 5);
  const Samples one = sampled(mesh, 12);
  GP::farthest_point_sampling(mesh, 7, std::back_inserter(two),
                              GP::parameters::first_samples(Samples(two)));
  EXPECT_EQ(two, one);
}

TEST(Farthest_point_sampling, density_follows_speed)
{
  Mesh mesh = mesh_of(square(30, 0.2));
  const auto speed = mesh.add_property_map<Face, double>("f:speed", 1.).first;
  for(const Face f : mesh.faces())
    if(point_of(mesh, GP::Location<Mesh>(f, {1. / 3., 1. / 3., 1. / 3.}))[0] < 0.5)
      put(speed, f, 0.2);
  Samples samples;
  GP::farthest_point_sampling(mesh, 104, std::back_inserter(samples),
                              GP::parameters::face_speed_map(speed));
  const auto left =
      std::count_if(samples.begin(), samples.end(),
                    [&](const auto& sample) { return point_of(mesh, sample)[0] < 0.5; });
  // 25/26 of the samples, minus the effect of the boundary. Accurate to 10 %.
  EXPECT_NEAR(double(left), 100., 10.);
}

TEST(Farthest_point_sampling, is_deterministic_for_seed_and_method)
{
  const Mesh mesh = mesh_of(jittered(icosphere(3), 0.02));
  const auto with = [&](unsigned seed)
  {
    Samples samples;
    GP::farthest_point_sampling(mesh, 20, std::back_inserter(samples),
                                GP::parameters::random_seed(seed));
    return samples;
  };
  EXPECT_EQ(with(1), with(1));
  EXPECT_NE(with(1), with(2));
  EXPECT_EQ(with(0), sampled(mesh, 20));
  std::vector<Vertex> graph_samples, front_samples;
  GP::farthest_vertex_sampling<GP::Dijkstra>(mesh, 20, std::back_inserter(graph_samples));
  GP::farthest_vertex_sampling<GP::Fast_marching>(mesh, 20, std::back_inserter(front_samples));
  EXPECT_EQ(graph_samples.size(), 20u);
  EXPECT_EQ(front_samples.size(), 20u);
  EXPECT_NE(graph_samples, front_samples);
}

TEST(Farthest_point_sampling, is_scale_invariant)
{
  for(const double scale : {1e-6, 1e6})
  {
    const Triangulation plane = square(20, 0.2);
    const Mesh mesh = mesh_of(plane), large = mesh_of(scaled(plane, scale));
    Radii radii, large_radii;
    std::vector<Vertex> sampled_vertices;
    GP::farthest_vertex_sampling(mesh, 30, std::back_inserter(sampled_vertices),
                                 GP::parameters::covering_radius_output(std::back_inserter(radii)));
    GP::farthest_vertex_sampling(
        large, 30, std::back_inserter(sampled_vertices),
        GP::parameters::covering_radius_output(std::back_inserter(large_radii)));
    // Round-off errors may select the other of two equally distant vertices. Radii differ by at
    // most the round-off error.
    for(std::size_t i = 0; i < 30; ++i)
      EXPECT_NEAR(large_radii[i], scale * radii[i], 1e-9 * scale);
  }
}

TEST(Farthest_point_sampling, covers_components_and_skips_isolated_vertices)
{
  Triangulation components = disjoint_union(icosphere(2), disjoint_union(square(4), tetrahedron()));
  components.points.push_back({5., 5., 5.});
  const Mesh mesh = mesh_of(components);
  std::vector<Vertex> sampled_vertices;
  Radii radii;
  GP::farthest_vertex_sampling(mesh, all, std::back_inserter(sampled_vertices),
                               GP::parameters::covering_radius_output(std::back_inserter(radii)));
  EXPECT_EQ(sampled_vertices.size(), components.points.size() - 1);
  EXPECT_EQ(radii[1], GP::internal::infinity);
  EXPECT_LT(radii[2], GP::internal::infinity);
  EXPECT_EQ(radii.back(), 0.);
}

TEST(Farthest_point_sampling, accepts_polyhedron_and_domain)
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
  Polyhedron polyhedron;
  CGAL::make_icosahedron<Polyhedron, Polyhedron::Point_3>(polyhedron);
  std::vector<GP::Location<Polyhedron>> samples;
  GP::farthest_point_sampling(polyhedron, 2, std::back_inserter(samples));
  EXPECT_EQ(samples.size(), 2u);

  const Mesh mesh = mesh_of(square(10));
  Samples again;
  GP::farthest_point_sampling(GP::make_domain(mesh), 9, std::back_inserter(again));
  EXPECT_EQ(again, sampled(mesh, 9));
}

TEST(Farthest_point_sampling, samples_surfels_of_a_cloud)
{
  const Surfels surfels = sphere_surfels(4);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  std::vector<GP::Location<Surfels>> samples;
  Radii radii;
  GP::farthest_point_sampling(surfels, 50, std::back_inserter(samples),
                              maps.covering_radius_output(std::back_inserter(radii)));
  ASSERT_EQ(samples.size(), 50u);
  const auto point = [&](std::size_t i)
  {
    EXPECT_EQ(samples[i].offset, (std::array<double, 2>{0., 0.}));
    return to_array(surfels[samples[i].surfel].first);
  };
  // Accurate to an edge length of the icosphere.
  EXPECT_LT(distance(point(0), -1. * point(1)), 0.0812);
  EXPECT_TRUE(std::is_sorted(radii.rbegin(), radii.rend()));
  // A front on this cloud errs by one or two percent, most on cell boundaries.
  const double front_error = 0.03;
  for(std::size_t i = 1; i < 50; ++i)
    for(std::size_t j = 0; j < i; ++j)
      EXPECT_GE(great_circle(point(i), point(j)), (1. - front_error) * radii[i - 1]);
  for(const auto& surfel : surfels)
  {
    double nearest = GP::internal::infinity;
    for(std::size_t i = 0; i < 50; ++i)
      nearest = std::min(nearest, great_circle(point(i), to_array(surfel.first)));
    EXPECT_LE(nearest, (1. + front_error) * radii.back());
  }

  CGAL::Point_set_3<Kernel::Point_3> set(true);
  for(const auto& [p, n] : surfels)
    set.insert(p, n);
  std::vector<std::size_t> sampled_vertices;
  GP::farthest_vertex_sampling(set, 50, std::back_inserter(sampled_vertices));
  for(std::size_t i = 0; i < 50; ++i)
    EXPECT_EQ(sampled_vertices[i], samples[i].surfel);
}

TEST(Farthest_point_sampling, skips_surfels_without_neighbors)
{
  Surfels surfels = flat_surfels(500);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  const auto sampled = [&]
  {
    std::vector<std::size_t> sampled_vertices;
    GP::farthest_vertex_sampling(surfels, 20, std::back_inserter(sampled_vertices), maps);
    return sampled_vertices;
  };
  const std::vector<std::size_t> without = sampled();
  surfels.push_back({{0.5, 0.5, 3.}, {0., 0., 1.}});
  // Two surfels at the same position are neighbors.
  surfels.push_back({{9., 9., 0.}, {0., 0., 1.}});
  surfels.push_back(surfels.back());
  const std::vector<std::size_t> with = sampled();
  EXPECT_EQ(std::count(with.begin(), with.end(), 500u), 0);
  EXPECT_EQ(std::count_if(with.begin(), with.end(), [](std::size_t i) { return i > 500; }), 1);
  EXPECT_EQ(without.size(), 20u);
  EXPECT_EQ(with.size(), 20u);
}

TEST(Farthest_point_sampling, cloud_sampling_uses_seed_first_samples_and_speed)
{
  const Surfels surfels = flat_surfels(3000);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  const auto with = [&](const auto& np)
  {
    std::vector<std::size_t> sampled_vertices;
    GP::farthest_vertex_sampling(surfels, 100, std::back_inserter(sampled_vertices), np);
    return sampled_vertices;
  };
  EXPECT_EQ(with(maps.random_seed(1u)), with(maps.random_seed(1u)));
  EXPECT_NE(with(maps.random_seed(1u)), with(maps.random_seed(2u)));

  const auto x = [&](std::size_t i) { return surfels[i].first.x(); };
  const auto leftmost = [&](std::size_t i, std::size_t j) { return x(i) < x(j); };
  std::vector<std::size_t> all_surfels(surfels.size());
  std::iota(all_surfels.begin(), all_surfels.end(), 0);
  const std::size_t first_sample =
      *std::min_element(all_surfels.begin(), all_surfels.end(), leftmost);
  Radii radii;
  std::vector<double> speed;
  for(const std::size_t i : all_surfels)
    speed.push_back(x(i) < 0.5 ? 0.2 : 1.);
  const auto sampled_vertices = with(maps.first_samples(first_sample)
                                         .speed_map(CGAL::make_property_map(speed))
                                         .covering_radius_output(std::back_inserter(radii)));
  EXPECT_EQ(std::count(sampled_vertices.begin(), sampled_vertices.end(), first_sample), 0);
  EXPECT_TRUE(std::is_sorted(radii.rbegin(), radii.rend()));
  const auto left = std::count_if(sampled_vertices.begin(), sampled_vertices.end(),
                                  [&](std::size_t i) { return x(i) < 0.5; });
  // 25/26 of the samples, minus the effect of the boundary. Accurate to 10 %.
  EXPECT_NEAR(double(left), 96., 10.);
}

TEST(Farthest_point_sampling, throws_on_invalid_arguments)
{
  const Mesh mesh = mesh_of(square(4));
  Samples samples;
  const auto with = [&](const auto& np)
  { GP::farthest_point_sampling(mesh, 3, std::back_inserter(samples), np); };
  EXPECT_THROW(with(GP::parameters::covering_radius(-1.)), GP::Invalid_argument_error);
  EXPECT_THROW(with(GP::parameters::covering_radius(std::nan(""))), GP::Invalid_argument_error);
  EXPECT_THROW(with(GP::parameters::first_samples(Vertex(100))), GP::Invalid_argument_error);
  EXPECT_TRUE(samples.empty());
  EXPECT_TRUE(sampled(mesh, 0).empty());
  EXPECT_TRUE(sampled(Mesh(), 3).empty());
}

TEST(Farthest_point_sampling, can_be_cancelled)
{
  const Mesh mesh = mesh_of(square(20));
  Samples samples;
  EXPECT_THROW(GP::farthest_point_sampling(mesh, 100, std::back_inserter(samples),
                                           GP::parameters::callback(std::function<bool(double)>(
                                               [](double done) { return done < 0.1; }))),
               GP::Cancelled);
  EXPECT_TRUE(samples.empty());
}

} // namespace farthest_point_sampling_test
