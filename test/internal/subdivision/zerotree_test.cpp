// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/subdivision/zerotree.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "subdivided_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace zerotree_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

constexpr std::size_t no_limit = 1000000;

struct Model
{
  std::shared_ptr<const Subdivision> subdivision;
  std::vector<double> points;
  Wavelet_signal signal;
};

Model model(const Triangulation& surface, unsigned times,
            const std::function<Point(const Point&)>& map_point, bool is_in_frames = true,
            double scale = 1.)
{
  Model result;
  result.subdivision = std::make_shared<Subdivision>(subdivided(surface, times));
  result.points = flattened(subdivided_points(*result.subdivision, surface.points, map_point));
  for(double& x : result.points)
    x *= scale;
  result.signal = {3, Prediction::butterfly, true, is_in_frames, result.points};
  Lifting(result.subdivision, Prediction::butterfly, true)
      .analyze(result.signal.values, 3, is_in_frames);
  return result;
}

Decoded_wavelets decoded(const std::vector<std::uint8_t>& bytes)
{
  return decode(bytes.data(), bytes.size(), no_limit);
}

// Returns the offset of the first plane: the size of the header and of the base mesh's packet.
std::size_t size_of_base(const std::vector<std::uint8_t>& bytes)
{
  const std::size_t header = 4 + 5 + 2 + 4 + 4 + 3 * 8 + 4;
  std::size_t length = 0;
  for(int i = 3; i >= 0; --i)
    length = 256 * length + bytes[header + i];
  return header + 8 + length;
}

TEST(Zerotree, decodes_to_precision_of_last_plane)
{
  const auto wave = [](const Point& p) {
    return Point{p[0], p[1], 0.1 * std::sin(7. * p[0] + p[1])};
  };
  for(const double scale : {1e-6, 1., 1e6})
    for(const bool is_in_frames : {false, true})
      for(const Model& m : {model(icosphere(0), 3, onto_bumpy_sphere, is_in_frames, scale),
                            model(annulus(5, 1, 1., 2.), 3, wave, is_in_frames, scale)})
      {
        const unsigned planes = 30;
        const Decoded_wavelets d = decoded(encode(*m.subdivision, m.signal, planes, 0));
        EXPECT_EQ(d.planes, planes);
        EXPECT_FALSE(d.is_damaged);
        EXPECT_EQ(d.subdivision->finest().triangles, m.subdivision->finest().triangles);
        EXPECT_EQ(d.signal.is_in_frames, is_in_frames);
        const std::vector<double> norms = detail_norms(*m.subdivision);
        double max_magnitude = 0.;
        for(std::size_t i = 0; i < m.signal.values.size(); ++i)
          max_magnitude = std::max(max_magnitude, norms[i / 3] * std::abs(m.signal.values[i]));
        // The error is at most the unit of the last plane. The largest coefficient is at least
        // half of 2^exponent.
        for(std::size_t i = 0; i < m.signal.values.size(); ++i)
          ASSERT_NEAR(norms[i / 3] * d.signal.values[i], norms[i / 3] * m.signal.values[i],
                      2. * max_magnitude * std::ldexp(1., -int(planes)) * (1. + 1e-6));
      }
}

TEST(Zerotree, every_prefix_decodes_and_error_decreases)
{
  const Model m = model(icosphere(0), 3, onto_bumpy_sphere);
  const std::vector<std::uint8_t> bytes = encode(*m.subdivision, m.signal, 16);
  const std::size_t base = size_of_base(bytes);
  double best = infinity, last = 0.;
  for(std::size_t size = 0; size <= bytes.size(); ++size)
  {
    const std::vector<std::uint8_t> prefix(bytes.begin(), bytes.begin() + std::ptrdiff_t(size));
    if(size < base)
    {
      EXPECT_THROW(decoded(prefix), Invalid_argument_error);
      continue;
    }
    const Decoded_wavelets d = decoded(prefix);
    EXPECT_FALSE(d.is_damaged);
    EXPECT_EQ(d.planes == 16, size == bytes.size());
    if(size % 40 != 0 && size != bytes.size())
      continue;
    last = root_mean_square(decoded_values(d), m.points);
    EXPECT_LT(last,
              1.05 * best); // local frames of an incomplete surface can increase the error slightly
    best = std::min(best, last);
  }
  // The unit of the last plane is 2^-15 of the largest coefficient, which is weighted by its norm.
  // The weights of the finest details are small. Measured: 4e-4.
  EXPECT_LT(last, 1e-3);
}

// If any bit is flipped in the header or base mesh, decode() throws. Otherwise it returns the
// planes before the bit.
TEST(Zerotree, detects_damage)
{
  const Model m = model(tetrahedron(), 2, onto_bumpy_sphere);
  const std::vector<std::uint8_t> bytes = encode(*m.subdivision, m.signal, 8);
  const std::size_t base = size_of_base(bytes);
  const Decoded_wavelets whole = decoded(bytes);
  for(std::size_t i = 0; i < bytes.size(); ++i)
    for(int bit = 0; bit < 8; ++bit)
    {
      std::vector<std::uint8_t> damaged = bytes;
      damaged[i] ^= std::uint8_t(1u << bit);
      if(i < base)
      {
        EXPECT_THROW(decoded(damaged), Invalid_argument_error);
        continue;
      }
      const Decoded_wavelets d = decoded(damaged);
      EXPECT_LT(d.planes, whole.planes);
      for(const double x : decoded_values(d))
        ASSERT_TRUE(std::isfinite(x));
    }
}

TEST(Zerotree, respects_max_number_of_bytes)
{
  const Model m = model(icosphere(0), 3, onto_bumpy_sphere);
  const std::vector<std::uint8_t> all = encode(*m.subdivision, m.signal, 16);
  for(const std::size_t max_size : {std::size_t(0), all.size() / 3, all.size(), 2 * all.size()})
  {
    const auto truncated = encode(*m.subdivision, m.signal, 16, 2, max_size);
    EXPECT_EQ(truncated.size(), std::min(max_size, all.size()));
    EXPECT_TRUE(std::equal(truncated.begin(), truncated.end(), all.begin()));
  }
}

// With 6 bits per vertex, the error is less than 1 % of the error of uniform quantization. The
// latter has 2 bits per coordinate, whose range is at least 2, so that its error is
// 2 / 4 / sqrt(12) per coordinate.
TEST(Zerotree, compresses_smooth_surfaces)
{
  const Model m = model(icosphere(0), 5, onto_bumpy_sphere);
  const std::size_t n = m.subdivision->number_of_vertices();
  const auto bytes = encode(*m.subdivision, m.signal, 24, 2, 6 * n / 8);
  EXPECT_LT(100. * root_mean_square(decoded_values(decoded(bytes)), m.points),
            std::sqrt(3.) * 2. / 4. / std::sqrt(12.));
}

TEST(Zerotree, throws_on_invalid_input)
{
  Model m = model(tetrahedron(), 1, onto_bumpy_sphere);
  const auto encode_it = [&](unsigned planes) { return encode(*m.subdivision, m.signal, planes); };
  const auto bytes = encode_it(8);
  EXPECT_THROW(encode_it(0), Invalid_argument_error);
  EXPECT_THROW(encode_it(49), Invalid_argument_error);
  EXPECT_THROW(decode(bytes.data(), bytes.size(), 9), Invalid_argument_error);
  EXPECT_EQ(decode(bytes.data(), bytes.size(), 10).subdivision->number_of_vertices(), 10u);
  for(const double x : {std::numeric_limits<double>::quiet_NaN(), infinity, 1e299})
    for(const std::size_t i : {0u, 20u})
    {
      Model bad = m;
      bad.signal.values[i] = x;
      EXPECT_THROW(encode(*bad.subdivision, bad.signal, 8), Invalid_argument_error);
    }
}

TEST(Zerotree, preserves_zeros)
{
  Model m = model(tetrahedron(), 2, onto_bumpy_sphere);
  std::fill(m.signal.values.begin(), m.signal.values.end(), 0.);
  for(const double x : decoded(encode(*m.subdivision, m.signal, 8)).signal.values)
    EXPECT_EQ(x, 0.);
}

} // namespace zerotree_test
