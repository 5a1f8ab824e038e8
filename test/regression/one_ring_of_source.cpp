// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <gtest/gtest.h>

namespace one_ring_of_source {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// The distance of a vertex adjacent to the source is the edge length, not less and not NaN.
void expect_edge_lengths(const Triangulation& shape)
{
  const Array_surface surface(shape);
  for(const Method method : fronts)
    for(Index source = 0; source < surface.size(); source += 7)
    {
      const auto d = distances(surface, method, {surface.source(source)});
      EXPECT_EQ(d[source], 0.);
      for(std::size_t c = 0; c < shape.corners.size(); ++c)
        if(shape.corners[c] == source)
          for(const Index corner :
              {internal::next_halfedge(Index(c)), internal::previous_halfedge(Index(c))})
          {
            const Index neighbor = shape.corners[corner];
            EXPECT_NEAR(d[neighbor], distance(shape.points[source], shape.points[neighbor]),
                        round_off_tolerance)
                << method;
          }
    }
}

TEST(One_ring_of_source, is_at_edge_length_in_plane) { expect_edge_lengths(square(12, 0.24)); }

TEST(One_ring_of_source, is_at_edge_length_on_sphere) { expect_edge_lengths(icosphere(3)); }

TEST(One_ring_of_source, is_at_edge_length_at_extreme_scales)
{
  for(const double factor : {1e-8, 1e8})
  {
    Triangulation plane = square(6, 0.24);
    for(Point& p : plane.points)
      for(double& x : p)
        x *= factor;
    const Array_surface surface(plane);
    for(const Method method : fronts)
      EXPECT_NEAR(distances(surface, method, {surface.source(24)})[25] / factor,
                  distance(plane.points[24], plane.points[25]) / factor, round_off_tolerance);
  }
}

} // namespace one_ring_of_source
