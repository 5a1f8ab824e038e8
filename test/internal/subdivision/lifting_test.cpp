// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/subdivision/lifting.h>

#include "subdivided_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

namespace lifting_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

struct Model
{
  std::shared_ptr<const Subdivision> subdivision;
  std::vector<double> values; // three channels
};

Model model(const Triangulation& surface, unsigned times,
            const std::function<Point(const Point&)>& map_point = identity)
{
  const auto s = std::make_shared<Subdivision>(subdivided(surface, times));
  return {s, flattened(subdivided_points(*s, surface.points, map_point))};
}

std::vector<Model> models()
{
  const auto wave = [](const Point& p) {
    return Point{p[0], p[1], 0.1 * std::sin(7. * p[0] + p[1])};
  };
  return {model(icosphere(0), 3, onto_bumpy_sphere), model(square(4, 0.2), 2, wave),
          model(annulus(5, 1, 1., 2.), 2, wave), model(tetrahedron(), 4, onto_bumpy_sphere),
          model(one_triangle(), 4, wave)};
}

double max_magnitude(const std::vector<double>& values)
{
  double result = 0.;
  for(const double x : values)
    result = std::max(result, std::abs(x));
  return result;
}

TEST(Lifting, synthesis_is_the_inverse_of_analysis)
{
  for(const Model& m : models())
    for(const Prediction prediction : {Prediction::linear, Prediction::butterfly})
      for(const bool use_update : {false, true})
        for(const bool is_in_frames : {false, true})
          for(const double scale : {1e-6, 1., 1e6})
          {
            const Lifting lifting(m.subdivision, prediction, use_update);
            std::vector<double> values = m.values;
            for(double& x : values)
              x *= scale;
            const std::vector<double> before = values;
            lifting.analyze(values, 3, is_in_frames);
            // Details are much smaller than coordinates. Measured differences are at least 0.58.
            EXPECT_GT(root_mean_square(values, before), 0.3 * scale);
            lifting.synthesize(values, 3, is_in_frames);
            for(std::size_t i = 0; i < values.size(); ++i)
              ASSERT_NEAR(values[i], before[i], 1e-12 * max_magnitude(before)); // round-off errors
          }
}

// Random and coincident points, which have no reliable local frames.
TEST(Lifting, inverts_arbitrary_values)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Model m = model(icosphere(0), 3);
  const Lifting lifting(m.subdivision, Prediction::butterfly, true);
  for(const double noise : {1., 0.})
  {
    for(double& x : m.values)
      x = 5. + noise * normal(random);
    std::vector<double> values = m.values;
    lifting.analyze(values, 3, true);
    lifting.synthesize(values, 3, true);
    for(std::size_t i = 0; i < values.size(); ++i)
      ASSERT_NEAR(values[i], m.values[i], 1e-12 * max_magnitude(m.values)); // round-off errors
  }
}

TEST(Lifting, supports_any_number_of_channels)
{
  const Model m = model(icosphere(0), 2, onto_bumpy_sphere);
  const Lifting lifting(m.subdivision, Prediction::butterfly, true);
  std::vector<double> three = m.values;
  lifting.analyze(three, 3, false);
  for(std::size_t c = 0; c < 3; ++c)
  {
    std::vector<double> one;
    for(std::size_t i = c; i < m.values.size(); i += 3)
      one.push_back(m.values[i]);
    lifting.analyze(one, 1, false);
    for(std::size_t v = 0; v < one.size(); ++v)
      EXPECT_EQ(one[v], three[3 * v + c]);
  }
}

TEST(Lifting, preserves_weighted_sum)
{
  for(const Model& m : models())
    for(const Prediction prediction : {Prediction::linear, Prediction::butterfly})
    {
      const Lifting lifting(m.subdivision, prediction, true);
      std::vector<double> values = m.values;
      lifting.analyze(values, 3, false);
      for(std::size_t c = 0; c < 3; ++c)
      {
        double fine = 0., coarse = 0.;
        for(std::size_t i = c; i < m.values.size(); i += 3)
          fine += m.values[i];
        const auto& weights = lifting.weights(0);
        for(Index v = 0; v < weights.size(); ++v)
          coarse += weights[v] * values[3 * v + c];
        // The round-off errors of sums of so many terms; measured are 1e-16 of this product.
        EXPECT_NEAR(coarse, fine, 1e-14 * double(m.values.size()) * max_magnitude(m.values));
      }
    }
}

// Constants are reproduced everywhere, and linear functions on regular triangulations, including
// the boundary.
TEST(Prediction_stencils, reproduce_constants_and_planes)
{
  for(const Model& m : models())
    for(const Prediction prediction : {Prediction::linear, Prediction::butterfly})
      for(std::size_t level = 0; level + 1 < m.subdivision->levels.size(); ++level)
      {
        const Prediction_stencils rows = prediction_stencils(*m.subdivision, level, prediction);
        for(std::size_t row = 0; row + 1 < rows.begin.size(); ++row)
          EXPECT_NEAR(std::accumulate(rows.weight.begin() + rows.begin[row],
                                      rows.weight.begin() + rows.begin[row + 1], 0.),
                      1., 1e-14); // round-off errors of a sum of ten weights
      }
  const Model plane = model(square(4), 2);
  const Lifting lifting(plane.subdivision, Prediction::butterfly, false);
  std::vector<double> values = plane.values;
  lifting.analyze(values, 3, false);
  for(std::size_t i = 75; i < values.size(); ++i)
  {
    // At the four corners of the square, the boundary is not straight.
    const Index v = Index(i / 3);
    const auto [a, b] = plane.subdivision->parents[v];
    const auto is_corner = [&](Index w)
    {
      const double x = plane.values[3 * w], y = plane.values[3 * w + 1];
      return (x == 0. || x == 1.) && (y == 0. || y == 1.);
    };
    if(is_corner(a) || is_corner(b))
      continue;
    EXPECT_NEAR(values[i], 0., 1e-14); // round-off errors of a stencil of eight vertices
  }
}

// Compares with the weights of Zorin, Schröder and Sweldens (1996, figure 2 and section 3).
TEST(Prediction_stencils, match_modified_butterfly)
{
  // On level 0, all vertices have valence 5: the stencil is the mean of both ring stencils with
  // K = 5.
  const Subdivision s = subdivided(icosphere(0), 2);
  const Prediction_stencils rows = prediction_stencils(s, 0, Prediction::butterfly);
  const auto [a, b] = s.parents[12];
  std::map<Index, double> weight;
  for(Index i = rows.begin[0]; i < rows.begin[1]; ++i)
    weight[rows.vertex[i]] += rows.weight[i];
  const double end_weight = (0.25 + 1. + 0.5) / 5.;
  // Sums of a few weights below 1.
  EXPECT_NEAR(weight[a], 0.5 * (0.75 + end_weight), 1e-15);
  EXPECT_NEAR(weight[b], 0.5 * (0.75 + end_weight), 1e-15);

  // On level 1, an edge has at most one extraordinary vertex.
  const Prediction_stencils finer = prediction_stencils(s, 1, Prediction::butterfly);
  std::map<std::size_t, int> sizes;
  for(std::size_t row = 0; row + 1 < finer.begin.size(); ++row)
    ++sizes[finer.begin[row + 1] - finer.begin[row]];
  EXPECT_EQ(sizes[6], 60); // edges at the 12 vertices of valence 5: the ring and the vertex
  EXPECT_EQ(sizes[8], 60); // regular edges: the butterfly
}

// On the interior of a regular grid, linear prediction has second order and the butterfly fourth
// order. So each level divides the details by 4 or 16.
TEST(Lifting, smooth_values_have_small_details)
{
  const Model m = model(square(4), 5);
  for(const Prediction prediction : {Prediction::linear, Prediction::butterfly})
  {
    const Lifting lifting(m.subdivision, prediction, false);
    std::vector<double> values;
    for(std::size_t i = 0; i < m.values.size(); i += 3)
      values.push_back(std::sin(2. * m.values[i] + 3. * m.values[i + 1]));
    lifting.analyze(values, 1, false);
    std::array<double, 5> size = {};
    for(std::size_t j = 0; j < 5; ++j)
      for(Index v = m.subdivision->levels[j].number_of_vertices;
          v < m.subdivision->levels[j + 1].number_of_vertices; ++v)
        if(std::abs(m.values[3 * v] - 0.5) < 0.2 && std::abs(m.values[3 * v + 1] - 0.5) < 0.2)
          size[j] = std::max(size[j], std::abs(values[v]));
    const double ratio = size[3] / size[4], expected = prediction == Prediction::linear ? 4. : 16.;
    EXPECT_GT(ratio, 0.8 * expected); // the asymptotic ratio is reached up to 20 %
    EXPECT_LT(ratio, 1.2 * expected);
  }
}

TEST(Lifting, ten_percent_of_details_beat_subsampling)
{
  for(const Model& m : {model(icosphere(0), 5, onto_bumpy_sphere)})
  {
    const Subdivision& s = *m.subdivision;
    const std::size_t n = s.number_of_vertices(), number = n / 10;
    const Lifting lifting(m.subdivision, Prediction::butterfly, true);
    std::vector<double> values = m.values;
    lifting.analyze(values, 3, true);
    keep_largest(values, 3, s, number - s.levels[0].number_of_vertices);
    std::size_t number_kept = 0;
    for(std::size_t v = 0; v < n; ++v)
      number_kept += values[3 * v] != 0. || values[3 * v + 1] != 0. || values[3 * v + 2] != 0.;
    EXPECT_LE(number_kept, number);
    lifting.synthesize(values, 3, true);

    std::vector<double> samples = m.values;
    for(std::size_t v = number; v < n; ++v)
      for(std::size_t c = 0; c < 3; ++c)
        samples[3 * v + c] =
            0.5 * (samples[3 * s.parents[v][0] + c] + samples[3 * s.parents[v][1] + c]);
    EXPECT_LT(3. * root_mean_square(values, m.values), root_mean_square(samples, m.values));
  }
}

TEST(Lifting, keeps_largest_details)
{
  const Model m = model(icosphere(0), 2, onto_bumpy_sphere);
  const std::vector<double> norms = detail_norms(*m.subdivision);
  std::vector<double> values = m.values;
  keep_largest(values, 3, *m.subdivision, 50);
  double smallest_kept = infinity, largest_dropped = 0.;
  std::size_t kept = 0;
  for(std::size_t v = 12; v < norms.size(); ++v)
  {
    const double size =
        norms[v] * std::hypot(m.values[3 * v], m.values[3 * v + 1], m.values[3 * v + 2]);
    const bool is_kept = values[3 * v] != 0. || values[3 * v + 1] != 0. || values[3 * v + 2] != 0.;
    kept += is_kept;
    (is_kept ? smallest_kept : largest_dropped) =
        is_kept ? std::min(smallest_kept, size) : std::max(largest_dropped, size);
  }
  EXPECT_EQ(kept, 50u);
  EXPECT_GE(smallest_kept, largest_dropped);
  keep_largest(values, 3, *m.subdivision, 0);
  for(std::size_t i = 0; i < values.size(); ++i)
    EXPECT_EQ(values[i], i < 36 ? m.values[i] : 0.);
}

TEST(Lifting, single_level_is_identity)
{
  const Model m = model(icosphere(0), 0);
  const Lifting lifting(m.subdivision, Prediction::butterfly, true);
  std::vector<double> values = m.values;
  lifting.analyze(values, 3, true);
  EXPECT_EQ(values, m.values);
  lifting.synthesize(values, 3, true);
  EXPECT_EQ(values, m.values);
}

} // namespace lifting_test
