// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <gtest/gtest.h>

namespace source_inside_a_face {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

TEST(Source_inside_a_face, distance_to_corners_is_euclidean)
{
  const Triangulation shape = jittered(icosphere(2), 0.03);
  const Array_surface surface(shape);
  const Surface_arrays& t = *surface.triangles();
  std::mt19937 random(1);
  for(int i = 0; i < 100; ++i)
  {
    const Surface_location location = random_location(t, random);
    for(const Method method : fronts)
    {
      const auto d = distances(surface, method, {surface.source(location)});
      for(int k = 0; k < 3; ++k)
      {
        const Index corner = surface.caller_vertex(t.corner[3 * location.triangle + k]);
        EXPECT_NEAR(d[corner], distance(shape.points[corner], point_at(t, location)),
                    round_off_tolerance)
            << method;
      }
    }
  }
}

TEST(Source_inside_a_face, accepts_round_off_in_barycentric_coordinates)
{
  const Triangulation plane = square(6, 0.2);
  const Array_surface surface(plane);
  const double tiny = 1e-15;
  for(const std::array<double, 3>& barycentric : {std::array<double, 3>{1. + tiny, -tiny, 0.},
                                                  {0.5, 0.5 + tiny, -tiny},
                                                  {-0., 0., 1.},
                                                  {-tiny, -tiny, 1. + 2. * tiny},
                                                  {tiny, 0.5, 0.5 - tiny},
                                                  {0., 1e-300, 1.}})
    for(const Index face : {0u, 30u, 71u})
    {
      const Surface_location location =
          internal::checked(*surface.triangles(), surface.in(face, barycentric));
      const Point p = point_at(*surface.triangles(), location);
      for(const Method method : all_methods)
        for(const double value : distances(surface, method, {surface.source(location)}))
          EXPECT_TRUE(value >= 0. && value < internal::infinity) << method; // and not NaN
      EXPECT_LT(
          largest_error(distances(surface, Method::euclidean_front, {surface.source(location)}),
                        [&](Index i) { return distance(p, plane.points[i]); }),
          front_tolerance);
    }
}

TEST(Source_inside_a_face, distance_is_continuous_towards_corner)
{
  const Array_surface surface(jittered(icosphere(2), 0.03));
  const Surface_arrays& t = *surface.triangles();
  for(const double fraction : {0., 1e-300, 1e-17, 1e-13, 1e-9})
    for(const Method method : fronts)
    {
      const Surface_location location =
          surface.in(17, {1. - fraction, fraction / 2., fraction / 2.});
      const Index corner = t.corner[3 * location.triangle];
      const auto from_vertex =
          distances(surface, method, {surface.source(surface.caller_vertex(corner))});
      const auto from_face = distances(surface, method, {surface.source(location)});
      // A front from a face crosses other triangles than one from a vertex. Around a source
      // vertex, a planar front is exact; around a location in a face, it is not.
      const double error = method == Method::euclidean_front ? 1e-3
                           : method == Method::dijkstra      ? 2. * fraction + round_off_tolerance
                                                             : 0.05;
      EXPECT_LT(largest_error(from_face, [&](Index i) { return from_vertex[i]; }), error)
          << method << ", share " << fraction;
    }
}

} // namespace source_inside_a_face
