// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_map/gradient_smoothing.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

namespace gradient_smoothing_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

using Field = std::function<Vec2(const Point&)>;

// A field of vectors at all vertices of a surface.
struct Sampled_field
{
  std::vector<Index> vertices;
  std::vector<double> distances;
  std::vector<Vec2> vectors;

  Sampled_field(const Surface_arrays& t, const Field& field)
      : vertices(t.number_of_vertices()), distances(vertices.size(), 1.)
  {
    std::iota(vertices.begin(), vertices.end(), Index(0));
    for(const Point& p : t.point)
      vectors.push_back(field({t.origin[0] + t.scale * p[0], t.origin[1] + t.scale * p[1],
                               t.origin[2] + t.scale * p[2]}));
  }
};

std::vector<Vec2> smoothed(const Surface_arrays& t, Sampled_field field, std::size_t steps)
{
  smooth_gradients(t, field.vertices, field.distances, steps, field.vectors);
  return field.vectors;
}

double largest_difference(const std::vector<Vec2>& a, const std::vector<Vec2>& b)
{
  double result = 0.;
  for(std::size_t i = 0; i < a.size(); ++i)
    result = std::max(result, norm(a[i] - b[i]));
  return result;
}

Vec2 linear(const Point& p) { return {2. * p[0] - p[1] + 0.3, 0.7 * p[1] + 0.1 * p[0]}; }

// Independent errors of each value.
Field noisy(double amount)
{
  auto random = std::make_shared<std::mt19937>(5);
  return [=](const Point& p)
  {
    std::uniform_real_distribution<double> error(-amount, amount);
    const double x = error(*random), y = error(*random);
    return linear(p) + Vec2{x, y};
  };
}

// Round-off errors of some tens of averages of values below 10.
constexpr double round_off = 1e-13;

TEST(gradient_smoothing, reproduces_linear_functions)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Array_surface surface(scaled(square(12, 0.25), scale));
    const Sampled_field field(surface.t(),
                              [=](const Point& p) {
                                return linear({p[0] / scale, p[1] / scale, 0.});
                              });
    EXPECT_LT(largest_difference(smoothed(surface.t(), field, 30), field.vectors), round_off);
  }
}

TEST(gradient_smoothing, adds_a_constant_to_squared_distances)
{
  // On a regular grid, the mean of d^2 over the neighbors of a vertex is d^2 plus a constant,
  // whatever the source. Steps from k to k + 1 reach one more ring from the boundary.
  const Array_surface surface(square(16));
  const auto squared_distance = [](double x, double y)
  {
    return [=](const Point& p) -> Vec2 {
      return {std::pow(p[0] - x, 2) + std::pow(p[1] - y, 2), 0.};
    };
  };
  const Sampled_field a(surface.t(), squared_distance(0.2, 0.3)),
      b(surface.t(), squared_distance(0.8, 0.1));
  const auto smooth_a = smoothed(surface.t(), a, 3), smooth_b = smoothed(surface.t(), b, 3);
  const Index middle = surface.vertex(8 + 17 * 8);
  const double constant = smooth_a[middle][0] - a.vectors[middle][0];
  EXPECT_GT(constant, 0.);
  for(Index i = 4; i <= 12; ++i)
    for(Index j = 4; j <= 12; ++j)
    {
      const Index v = surface.vertex(i + 17 * j);
      EXPECT_NEAR(smooth_a[v][0] - a.vectors[v][0], constant, round_off);
      EXPECT_NEAR(smooth_b[v][0] - b.vectors[v][0], constant, round_off);
    }
}

TEST(gradient_smoothing, is_linear_in_the_maps)
{
  // Smoothing a linear combination of maps is the combination of the smoothed maps.
  const Array_surface surface(square(10, 0.2));
  Sampled_field a(surface.t(), noisy(0.05)), b(surface.t(), linear), sum = a;
  for(std::size_t i = 0; i < a.vectors.size(); ++i)
  {
    b.vectors[i] = b.vectors[i] + Vec2{0.02 * std::sin(double(i)), 0.};
    sum.vectors[i] = 2. * a.vectors[i] + (-0.5) * b.vectors[i];
  }
  const auto smooth_a = smoothed(surface.t(), a, 4), smooth_b = smoothed(surface.t(), b, 4);
  std::vector<Vec2> expected;
  for(std::size_t i = 0; i < a.vectors.size(); ++i)
    expected.push_back(2. * smooth_a[i] + (-0.5) * smooth_b[i]);
  EXPECT_LT(largest_difference(smoothed(surface.t(), sum, 4), expected), round_off);
}

TEST(gradient_smoothing, reduces_independent_errors)
{
  const Array_surface surface(square(30, 0.2));
  const Sampled_field clean(surface.t(), linear), field(surface.t(), noisy(0.05));
  const auto mean_square = [&](const std::vector<Vec2>& vectors)
  {
    double sum = 0., count = 0.;
    for(std::size_t i = 0; i < vectors.size(); ++i)
    {
      const Point& p = surface.point(surface.caller_vertex(Index(i)));
      if(std::min({p[0], p[1], 1. - p[0], 1. - p[1]}) < 0.2) // six rings from the boundary
        continue;
      const Vec2 error = vectors[i] - clean.vectors[i];
      sum += dot(error, error);
      ++count;
    }
    return sum / count;
  };
  double last = mean_square(field.vectors),
         largest = largest_difference(field.vectors, clean.vectors);
  for(const std::size_t steps : {1, 2, 5, 10, 40})
  {
    const auto vectors = smoothed(surface.t(), field, steps);
    EXPECT_LT(mean_square(vectors), last);
    last = mean_square(vectors);
    // The weights are positive: no error exceeds the largest one.
    EXPECT_LE(largest_difference(vectors, clean.vectors), largest + round_off);
  }
  // The errors of k = 40 steps are averaged over about pi k edges squared.
  EXPECT_LT(last, 0.1 * mean_square(field.vectors));
}

TEST(gradient_smoothing, keeps_base_boundary_and_discontinuities)
{
  const Array_surface surface(square(10));
  Sampled_field field(surface.t(), noisy(0.05));
  const Index base = surface.vertex(5 + 11 * 5), outside = surface.vertex(2 + 11 * 2);
  field.distances[base] = 0.;
  field.vectors[base] = {0.001, 0.};
  field.vertices.erase(field.vertices.begin() + outside);
  field.distances.erase(field.distances.begin() + outside);
  field.vectors.erase(field.vectors.begin() + outside);
  const auto vectors = smoothed(surface.t(), field, 3);
  for(std::size_t i = 0; i < vectors.size(); ++i)
  {
    const Index v = field.vertices[i], caller = surface.caller_vertex(v);
    const Index x = caller % 11, y = caller / 11;
    bool is_kept = x == 0 || x == 10 || y == 0 || y == 10;
    for(Index r = surface.t().ring_begin[v]; r < surface.t().ring_begin[v + 1]; ++r)
      for(Index k = 0; k < 3; ++k)
        is_kept = is_kept || surface.t().corner[3 * (surface.t().ring[r] / 3) + k] == outside;
    if(v == base)
      EXPECT_EQ(vectors[i], (Vec2{0., 0.}));
    else
      EXPECT_EQ(vectors[i] == field.vectors[i], is_kept);
  }

  // The map jumps between two columns, by 20 units.
  const Field jump = [](const Point& p) { return Vec2{p[0] < 0.45 ? -10. : 10., p[1]}; };
  const Sampled_field cut(surface.t(), jump);
  const auto kept = smoothed(surface.t(), cut, 10);
  EXPECT_LT(largest_difference(kept, cut.vectors), 1e-12); // averages of values of 10
}

TEST(gradient_smoothing, reproduces_linear_functions_on_clouds)
{
  // Random points of a tilted plane; neighbors are closer than 0.2.
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit_interval(0., 1.);
  Surface_arrays t;
  for(int i = 0; i < 300; ++i)
  {
    const double x = unit_interval(random), y = unit_interval(random);
    t.point.push_back({x, 0.6 * y, 0.8 * y});
    t.normal.push_back({0., -0.8, 0.6});
  }
  t.graph.begin.push_back(0);
  for(const Point& p : t.point)
  {
    for(Index j = 0; j < t.point.size(); ++j)
      if(&p != &t.point[j] && distance(p, t.point[j]) < 0.2)
        t.graph.target.push_back(j);
    t.graph.begin.push_back(Index(t.graph.target.size()));
  }
  t.ring_begin.assign(t.point.size() + 1, 0);
  const Sampled_field field(t, linear), errors(t, noisy(0.05));
  EXPECT_LT(largest_difference(smoothed(t, field, 30), field.vectors), round_off);

  const auto smooth = smoothed(t, errors, 3);
  std::size_t number_of_kept = 0;
  for(std::size_t i = 0; i < t.point.size(); ++i)
  {
    const double x = t.point[i][0], y = t.point[i][1] / 0.6;
    const bool is_kept = smooth[i] == errors.vectors[i];
    // A surfel whose neighborhood does not reach the boundary is smoothed.
    if(std::min({x, y, 1. - x, 1. - y}) > 0.2)
    {
      EXPECT_FALSE(is_kept);
    }
    number_of_kept += is_kept;
  }
  EXPECT_GT(number_of_kept, 10u); // vertices of the convex hull, and more
}

TEST(gradient_smoothing, accepts_degenerate_faces)
{
  // The middle column has faces without area; vectors between equal ones stay finite.
  const Array_surface slit(rectangle_with_slit(5));
  for(const Vec2& vector : smoothed(slit.t(), Sampled_field(slit.t(), linear), 20))
    EXPECT_TRUE(std::isfinite(norm(vector)));
  // An edge of length zero.
  Triangulation collapsed = square(4);
  collapsed.points[12] = collapsed.points[13];
  const Array_surface surface(collapsed);
  for(const Vec2& vector : smoothed(surface.t(), Sampled_field(surface.t(), linear), 20))
    EXPECT_TRUE(std::isfinite(norm(vector)));
  // Two triangles that share a vertex, which is on the boundary of both.
  const Array_surface bow_tie(
      {{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}},
       {0, 1, 2, 0, 3, 4}});
  const Sampled_field field(bow_tie.t(), linear);
  EXPECT_EQ(smoothed(bow_tie.t(), field, 20), field.vectors);
}

} // namespace gradient_smoothing_test
