// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <variant>

namespace Distance_engine_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using test::Array_surface;

struct Distance_engines : testing::Test
{
  Array_surface surface{test::square(8, 0.2)};

  // The engine gives the same answers as the kernel that it wraps.
  template <typename Kernel>
  void expect_same(Distance_method method, Kernel kernel)
  {
    Distance_engine engine(method, surface.triangles());
    const std::vector<Front_source> sources = {surface.source(3), surface.source(70, 0.1)};
    EXPECT_EQ(engine.run(sources), kernel.run(sources));
    const Distance_engine copy = engine;
    for(Index i = 0; i < surface.size(); ++i)
    {
      EXPECT_EQ(copy.distance(i), kernel.distance(i));
      EXPECT_EQ(copy.source(i), kernel.source(i));
      EXPECT_EQ(copy.predecessor(i), kernel.predecessor(i));
    }
    const Surface_location location = surface.in(5, {0.2, 0.3, 0.5});
    EXPECT_EQ(copy.distance(location), kernel.distance(location));
    EXPECT_EQ(copy.reached(), kernel.reached());
    EXPECT_TRUE(std::holds_alternative<const Kernel*>(copy.row_engine()));
    EXPECT_EQ(copy.windows() != nullptr, method == Distance_method::exact);
  }
};

TEST_F(Distance_engines, match_their_kernels)
{
  expect_same(Distance_method::dijkstra, Front(surface.triangles(), Front_kind::dijkstra));
  expect_same(Distance_method::fast_marching, Front(surface.triangles(), Front_kind::planar));
  expect_same(Distance_method::euclidean_front,
              Front(surface.triangles(), Front_kind::euclidean, Bisected_edges::long_edges));
  expect_same(Distance_method::exact, Window_propagation(surface.triangles()));
  expect_same(Distance_method::heat, Heat_solver(surface.triangles()));
}

TEST_F(Distance_engines, pass_the_time_step_to_heat_only)
{
  Distance_engine engine(Distance_method::heat, surface.triangles(), 20.);
  EXPECT_TRUE(engine.run({surface.source(3)}));
  Heat_solver solver(surface.triangles(), 20.);
  EXPECT_TRUE(solver.run({surface.source(3)}));
  EXPECT_EQ(surface.distances(engine), surface.distances(solver));
  for(const Distance_method method :
      {Distance_method::dijkstra, Distance_method::exact, Distance_method::automatic})
    EXPECT_THROW(Distance_engine(method, surface.triangles(), 20.),
                 CGAL::Geodesic_processing::Unsupported_surface_error);
}

TEST_F(Distance_engines, return_false_if_cancelled)
{
  Front_limits limits;
  limits.callback = [](double) { return false; };
  EXPECT_FALSE(
      Distance_engine(Distance_method::heat, surface.triangles()).run({surface.source(3)}, limits));
}

TEST_F(Distance_engines, choose_the_kernel_by_the_speeds)
{
  Distance_engine engine(Distance_method::automatic, surface.triangles());
  const std::vector<Front_source> sources = {surface.source(3)};
  EXPECT_TRUE(engine.run(sources));
  EXPECT_NE(engine.windows(), nullptr);

  Front_limits limits;
  std::vector<double> slowness(surface.t().number_of_triangles(), 1.);
  slowness[7] = infinity;
  limits.slowness = std::make_shared<const std::vector<double>>(slowness);
  EXPECT_TRUE(engine.run(sources, limits));
  EXPECT_NE(engine.windows(), nullptr);

  slowness[9] = 2.;
  limits.slowness = std::make_shared<const std::vector<double>>(slowness);
  EXPECT_TRUE(engine.run(sources, limits));
  EXPECT_EQ(engine.windows(), nullptr);
  Front front(surface.triangles(), Front_kind::euclidean);
  front.run(sources, limits);
  for(Index i = 0; i < surface.size(); ++i)
    EXPECT_EQ(engine.distance(i), front.distance(i));

  EXPECT_TRUE(engine.run(sources));
  EXPECT_NE(engine.windows(), nullptr);
}

TEST_F(Distance_engines, return_the_same_distances_at_many_locations)
{
  for(const Distance_method method : {Distance_method::exact, Distance_method::euclidean_front})
  {
    Distance_engine engine(method, surface.triangles());
    engine.run({surface.source(3)});
    const std::vector<Surface_location> locations = {surface.at(5),
                                                     surface.in(20, {0.2, 0.3, 0.5})};
    const std::vector<double> distances = engine.distances(locations);
    ASSERT_EQ(distances.size(), 2u);
    for(int i = 0; i < 2; ++i)
      EXPECT_NEAR(distances[i], engine.distance(locations[i]), 1e-14); // of order one
  }
}

TEST(Distance_method, follows_from_the_tag)
{
  static_assert(distance_method<Automatic>() == Distance_method::automatic);
  static_assert(distance_method<Dijkstra>() == Distance_method::dijkstra);
  static_assert(distance_method<Fast_marching>() == Distance_method::fast_marching);
  static_assert(distance_method<Euclidean_front>() == Distance_method::euclidean_front);
  static_assert(distance_method<Exact>() == Distance_method::exact);
  static_assert(distance_method<Heat>() == Distance_method::heat);
  static_assert(front_kind<Dijkstra>() == Front_kind::dijkstra);
  static_assert(front_kind<Fast_marching>() == Front_kind::planar);
  static_assert(front_kind<Euclidean_front>() == Front_kind::euclidean);
  static_assert(!is_front<Exact> && !is_front<Heat>);
}

} // namespace Distance_engine_test
