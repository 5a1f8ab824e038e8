// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"
#include "path_checks.h"

#include <gtest/gtest.h>

namespace translation_and_scale_invariance {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Rounds coordinates to multiples of 2^-20. A translation by up to 2^32 does not change them.
Triangulation rounded_to_dyadic(Triangulation surface)
{
  for(Point& p : surface.points)
    for(double& x : p)
      x = std::ldexp(std::round(std::ldexp(x, 20)), -20);
  return surface;
}

Triangulation translated(Triangulation surface, const Point& translation)
{
  for(Point& p : surface.points)
    for(int k = 0; k < 3; ++k)
      p[k] += translation[k];
  return surface;
}

TEST(Translation_and_scale_invariance, distances_are_translation_invariant)
{
  for(const Triangulation& shape :
      {rounded_to_dyadic(square(16, 0.24)), rounded_to_dyadic(jittered(icosphere(3), 0.03))})
  {
    const Array_surface surface(shape);
    for(const Point& translation : {Point{0x1p32, -0x1p31, 0x1p32}, Point{-12345678., 0., 0.}})
    {
      const Array_surface translated_surface(translated(shape, translation));
      EXPECT_EQ(translated_surface.scale(), surface.scale());
      for(const Method method : all_methods)
      {
        const auto expected = distances(surface, method, {surface.source(100)});
        EXPECT_LT(
            largest_error(distances(translated_surface, method, {translated_surface.source(100)}),
                          [&](Index i) { return expected[i]; }),
            // Lengths are bitwise equal. A solve may use another order of summation.
            method == Method::heat ? 1e-9 : round_off_tolerance)
            << method;
      }
    }
  }
}

TEST(Translation_and_scale_invariance, path_lengths_are_translation_invariant)
{
  const Triangulation shape = rounded_to_dyadic(jittered(icosphere(3), 0.03));
  const Array_surface surface(shape),
      translated_surface(translated(shape, {0x1p32, -0x1p31, 0x1p32}));
  const auto length = [](const Array_surface& s, Index from)
  {
    const std::vector<internal::Front_source> sources = {s.source(0)};
    internal::Front front(s.triangles(), internal::Front_kind::euclidean);
    front.run(sources);
    const auto found = path(*s.triangles(), front, sources, s.at(from));
    expect_path_on_surface(*s.triangles(), found, s.at(from), s.at(0));
    return s.scale() * internal::path_length(*s.triangles(), found);
  };
  for(Index from = 1; from < surface.size(); from += 40)
    EXPECT_NEAR(length(translated_surface, from), length(surface, from), round_off_tolerance);
}

TEST(Translation_and_scale_invariance, distances_are_scale_invariant)
{
  const Triangulation shape = jittered(icosphere(3), 0.03);
  const Array_surface surface(shape);
  for(const int exponent : {-26, 26}) // about 1e-8 and 1e8
  {
    Triangulation scaled = shape;
    for(Point& p : scaled.points)
      for(double& x : p)
        x = std::ldexp(x, exponent);
    const Array_surface other(scaled);
    for(const Method method : all_methods)
    {
      const auto expected = distances(surface, method, {surface.source(7)});
      const auto d = distances(other, method, {other.source(7)});
      for(Index i = 0; i < d.size(); ++i)
        EXPECT_EQ(std::ldexp(d[i], -exponent), expected[i])
            << method; // scaling by a power of two is exact
    }
  }
}

} // namespace translation_and_scale_invariance
