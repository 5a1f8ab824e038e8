// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/parameters.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace parameters_test {

namespace GP = CGAL::Geodesic_processing;

// Checks the values that a function reads from a chain of three: two of this package, one of CGAL.
template <typename NamedParameters>
void expect_values(const NamedParameters& np)
{
  EXPECT_EQ(GP::internal::parameter(np, GP::internal_np::maximum_distance, 0.), 0.5);
  EXPECT_EQ(GP::internal::parameter(np, CGAL::internal_np::vertex_point, std::string()), "points");
  EXPECT_EQ(GP::internal::parameter(np, GP::internal_np::number_of_threads, 1u), 3u);
  EXPECT_TRUE((GP::internal::has_parameter<NamedParameters, GP::internal_np::number_of_threads_t>));
  EXPECT_FALSE((GP::internal::has_parameter<NamedParameters, GP::internal_np::targets_t>));
  EXPECT_EQ(GP::internal::parameter(np, GP::internal_np::targets, 7), 7);
}

TEST(Parameters, chain_with_cgal_parameters_in_any_order)
{
  const std::string points = "points";
  expect_values(
      GP::parameters::maximum_distance(0.5).vertex_point_map(points).number_of_threads(3u));
  expect_values(
      GP::parameters::maximum_distance(0.5).number_of_threads(3u).vertex_point_map(points));
  expect_values(
      GP::parameters::vertex_point_map(points).maximum_distance(0.5).number_of_threads(3u));
  expect_values(
      GP::parameters::number_of_threads(3u).vertex_point_map(points).maximum_distance(0.5));
  // A chain that begins with CGAL's parameters can be continued after chain() wraps it.
  expect_values(GP::internal::chain(CGAL::parameters::vertex_point_map(points))
                    .maximum_distance(0.5)
                    .number_of_threads(3u));
}

TEST(Parameters, are_independent)
{
  const auto np = GP::parameters::maximum_distance(1)
                      .targets(2)
                      .speed_map(3)
                      .source_label_map(4)
                      .predecessor_map(5)
                      .radius_map(6)
                      .number_of_threads(7)
                      .covering_radius(16)
                      .covering_radius_output(17)
                      .first_samples(18)
                      .face_label_map(19)
                      .bisector_output(20)
                      .ball_radius(21)
                      .strength(22)
                      .callback(8)
                      .random_seed(9)
                      .vertex_point_map(10)
                      .vertex_index_map(11)
                      .face_index_map(12)
                      .point_map(13)
                      .normal_map(14)
                      .geom_traits(15);
  namespace ours = GP::internal_np;
  namespace theirs = CGAL::internal_np;
  EXPECT_EQ(GP::internal::parameter(np, ours::maximum_distance, 0), 1);
  EXPECT_EQ(GP::internal::parameter(np, ours::targets, 0), 2);
  EXPECT_EQ(GP::internal::parameter(np, ours::speed_map, 0), 3);
  EXPECT_EQ(GP::internal::parameter(np, ours::source_label_map, 0), 4);
  EXPECT_EQ(GP::internal::parameter(np, ours::predecessor_map, 0), 5);
  EXPECT_EQ(GP::internal::parameter(np, ours::radius_map, 0), 6);
  EXPECT_EQ(GP::internal::parameter(np, ours::number_of_threads, 0), 7);
  EXPECT_EQ(GP::internal::parameter(np, ours::covering_radius, 0), 16);
  EXPECT_EQ(GP::internal::parameter(np, ours::covering_radius_output, 0), 17);
  EXPECT_EQ(GP::internal::parameter(np, ours::first_samples, 0), 18);
  EXPECT_EQ(GP::internal::parameter(np, ours::face_label_map, 0), 19);
  EXPECT_EQ(GP::internal::parameter(np, ours::bisector_output, 0), 20);
  EXPECT_EQ(GP::internal::parameter(np, ours::ball_radius, 0), 21);
  EXPECT_EQ(GP::internal::parameter(np, ours::strength, 0), 22);
  EXPECT_EQ(GP::internal::parameter(np, theirs::callback, 0), 8);
  EXPECT_EQ(GP::internal::parameter(np, theirs::random_seed, 0), 9);
  EXPECT_EQ(GP::internal::parameter(np, theirs::vertex_point, 0), 10);
  EXPECT_EQ(GP::internal::parameter(np, theirs::vertex_index, 0), 11);
  EXPECT_EQ(GP::internal::parameter(np, theirs::face_index, 0), 12);
  EXPECT_EQ(GP::internal::parameter(np, theirs::point_map, 0), 13);
  EXPECT_EQ(GP::internal::parameter(np, theirs::normal_map, 0), 14);
  EXPECT_EQ(GP::internal::parameter(np, theirs::geom_traits, 0), 15);
}

TEST(Parameters, store_function_objects)
{
  bool was_called = false;
  const auto np = GP::parameters::callback(std::function<bool(double)>(
                                               [&](double)
                                               {
                                                 was_called = true;
                                                 return false;
                                               }))
                      .maximum_distance(2.);
  const auto function =
      GP::internal::parameter(np, CGAL::internal_np::callback, std::function<bool(double)>());
  EXPECT_FALSE(function(0.));
  EXPECT_TRUE(was_called);
}

} // namespace parameters_test
