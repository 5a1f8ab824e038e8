// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/cone_descent.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace cone_descent_test {

using namespace CGAL::Geodesic_processing::internal;

// Round-off errors of sums of some tens of terms.
constexpr double round_off = 1e-12;

// Returns the directional derivative by its definition.
double derivative(const std::vector<Direction_fan>& fans, std::size_t fan_index, double angle,
                  const std::vector<Direction_pull>& pulls)
{
  double result = 0.;
  for(const Direction_pull& pull : pulls)
  {
    double between = pi;
    const Direction_fan& fan = fans[fan_index];
    if(pull.angle >= fan.begin && pull.angle <= fan.begin + fan.angle)
    {
      between = std::abs(pull.angle - fan.begin - angle);
      if(fan.is_closed)
        between = std::min(between, fan.angle - between);
    }
    result -= pull.moment * std::cos(std::min(between, pi));
  }
  return result;
}

TEST(Cone_descent, finds_minimum_over_all_directions)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0., 1.);
  const std::vector<std::vector<Direction_fan>> cases = {
      {{0., 1.5 * pi, true}},  {{0., 0.7 * pi, true}},
      {{0., 2.9 * pi, true}},  {{0., 2. * pi, true}},
      {{0., 0.5 * pi, false}}, {{0., 1.5 * pi, false}},
      {{0., 3.2 * pi, false}}, {{0., pi, true}, {pi, 2. * pi, false}}};
  for(const std::vector<Direction_fan>& fans : cases)
    for(int repetition = 0; repetition < 20; ++repetition)
    {
      const double total = fans.back().begin + fans.back().angle;
      std::vector<Direction_pull> pulls;
      for(int i = 0; i < 1 + repetition / 2; ++i)
        pulls.push_back({total * unit(random), unit(random)});
      const Cone_descent found = steepest_descent(fans, pulls);
      double smallest = infinity;
      const int number_of_samples = 2000;
      for(std::size_t k = 0; k < fans.size(); ++k)
        for(int i = 0; i <= number_of_samples; ++i)
          smallest =
              std::min(smallest, derivative(fans, k, fans[k].angle * i / number_of_samples, pulls));
      EXPECT_LE(found.slope, smallest + round_off);
      // The slope is Lipschitz continuous: its derivative is at most the sum of the moments.
      EXPECT_GE(found.slope, smallest - double(pulls.size()) * 3.2 * pi / number_of_samples);
      double angle = found.angle;
      if(fans.size() == 1)
        angle -= fans[0].angle * std::floor(angle / fans[0].angle);
      const std::size_t k = fans.size() > 1 && found.angle > fans[1].begin ? 1 : 0;
      EXPECT_NEAR(derivative(fans, k, angle - fans[k].begin, pulls), found.slope, round_off);
    }
}

// The mean of the derivative over all directions is -2 sin(angle / 2) / angle times the moment.
TEST(Cone_descent, always_descends_from_convex_vertices)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0., 1.);
  for(int repetition = 0; repetition < 50; ++repetition)
  {
    const double total = (0.1 + 1.8 * unit(random)) * pi;
    std::vector<Direction_pull> pulls;
    double moment = 0.;
    for(int i = 0; i < 10; ++i)
    {
      pulls.push_back({total * unit(random), unit(random)});
      moment += pulls.back().moment;
    }
    EXPECT_LE(steepest_descent({{0., total, true}}, pulls).slope,
              -2. * std::sin(total / 2.) / total * moment + round_off);
  }
}

TEST(Cone_descent, is_the_gradient_at_smooth_points)
{
  const std::vector<Direction_fan> plane = {{}};
  EXPECT_TRUE(is_smooth(plane));
  EXPECT_FALSE(is_smooth({{0., pi, false}}));
  EXPECT_FALSE(is_smooth({}));
  const std::vector<Direction_pull> pulls = {{0.1, 1.}, {0.1 + pi / 2., 2.}, {-3., 0.}};
  const Cone_descent found = steepest_descent(plane, pulls);
  EXPECT_NEAR(found.slope, -std::sqrt(5.), round_off);
  EXPECT_NEAR(found.angle, 0.1 + std::atan2(2., 1.), round_off);
  EXPECT_NEAR(norm(sum_of_pulls(pulls)), std::sqrt(5.), round_off);
}

// Opposite pulls with angles of at least pi on both sides hold a minimum at a saddle vertex.
TEST(Cone_descent, is_positive_at_minima)
{
  const std::vector<Direction_pull> pulls = {{0., 1.}, {1.25 * pi, 1.}};
  EXPECT_NEAR(steepest_descent({{0., 2.5 * pi, true}}, pulls).slope, 0., round_off);
  const std::vector<Direction_pull> three = {{0., 1.}, {pi, 1.}, {2. * pi, 1.}};
  EXPECT_NEAR(steepest_descent({{0., 3. * pi, true}}, three).slope, 1., round_off);
  // At a reflex boundary vertex, a path along each boundary edge.
  EXPECT_NEAR(steepest_descent({{0., 1.5 * pi, false}}, {{0., 1.}, {1.5 * pi, 1.}}).slope, 0.,
              round_off);
  EXPECT_EQ(steepest_descent({}, pulls).slope, 0.);
}

} // namespace cone_descent_test
