// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "triangulations.h"

#include <gtest/gtest.h>

namespace path_locations_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Surface_location location(Index triangle, std::array<double, 3> barycentric)
{
  Surface_location result;
  result.triangle = triangle;
  result.barycentric = barycentric;
  return result;
}

TEST(Path_locations, canonical_form_removes_round_off)
{
  const Mesh_arrays mesh = arrays_of(one_triangle());
  const Surface_location canonical_location =
      canonical(mesh.arrays, location(0, {1. + 1e-16, 1e-15, -1e-16}));
  EXPECT_EQ(canonical_location.barycentric, (std::array<double, 3>{1., 0., 0.}));
  EXPECT_EQ(corner_of(canonical_location), 0u);
  EXPECT_EQ(halfedge_of(canonical_location), none);
  EXPECT_EQ(vertex_of(mesh.arrays, canonical_location), mesh.arrays.corner[0]);
}

TEST(Path_locations, corner_has_exact_unit_weight)
{
  // The coordinate differs from one by the round-off error of a sum.
  const Mesh_arrays mesh = arrays_of(one_triangle());
  const Surface_location canonical_location =
      canonical(mesh.arrays, location(0, {0., 1. - 2.2e-16, 1e-15}));
  EXPECT_EQ(canonical_location.barycentric, (std::array<double, 3>{0., 1., 0.}));
}

TEST(Path_locations, vertex_is_same_point_in_all_incident_triangles)
{
  const Mesh_arrays mesh = arrays_of(tetrahedron());
  const Surface_arrays& t = mesh.arrays;
  for(Index corner = 0; corner < 12; ++corner)
  {
    const Surface_location p = vertex_location(t, t.corner[corner]);
    const auto seen = barycentric_in(t, corner / 3, p);
    ASSERT_TRUE(seen);
    EXPECT_EQ(*seen, location(0, {corner % 3 == 0 ? 1. : 0., corner % 3 == 1 ? 1. : 0.,
                                  corner % 3 == 2 ? 1. : 0.})
                         .barycentric);
    EXPECT_TRUE(is_same_point(t, p, location(corner / 3, *seen)));
  }
}

TEST(Path_locations, edge_point_is_same_in_twin_triangle)
{
  const Mesh_arrays mesh = arrays_of(icosphere(1));
  const Surface_arrays& t = mesh.arrays;
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    std::array<double, 3> b = {0., 0., 0.};
    b[h % 3] = 0.25;
    b[next_halfedge(h) % 3] = 0.75;
    const Surface_location p = location(h / 3, b);
    EXPECT_EQ(halfedge_of(p), h);
    const auto seen = barycentric_in(t, t.twin[h] / 3, p);
    ASSERT_TRUE(seen);
    const Surface_location q = location(t.twin[h] / 3, *seen);
    EXPECT_TRUE(is_same_point(t, p, q));
    const Point a = point_at(t, p), c = point_at(t, q);
    EXPECT_NEAR(distance(a, c), 0., 1e-15); // round-off errors of coordinates below 1
    EXPECT_NE(common_triangle(t, p, q), none);
  }
}

TEST(Path_locations, distant_locations_have_no_common_triangle)
{
  const Mesh_arrays mesh = arrays_of(icosphere(2));
  const Surface_arrays& t = mesh.arrays;
  const Surface_location p = vertex_location(t, mesh.internal_vertex[0]),
                         q = vertex_location(t, mesh.internal_vertex[3]);
  EXPECT_EQ(common_triangle(t, p, q), none);
  EXPECT_THROW(path_length(t, {p, q}), Invalid_argument_error);
}

TEST(Path_locations, path_length_is_sum_of_segments)
{
  const Mesh_arrays mesh = arrays_of(one_triangle());
  const Surface_arrays& t = mesh.arrays;
  const double length = path_length(t, {location(0, {1., 0., 0.}), location(0, {0., 0.5, 0.5}),
                                        location(0, {0., 0.5, 0.5}), location(0, {0., 1., 0.})});
  EXPECT_NEAR(length * t.scale, std::sqrt(2.), 1e-15 * 4); // a few round-off errors
}

TEST(straight_distance, is_a_tight_lower_bound_of_the_chord)
{
  const Array_surface surface(square(6, 0.24));
  const Surface_location p = surface.at(3), q = surface.in(40, {0.2, 0.3, 0.5});
  const double chord =
      distance(point_at(surface.t(), p), point_at(surface.t(), q)) / surface.scale();
  EXPECT_LT(straight_distance(surface.t(), p, q), chord);
  EXPECT_GT(straight_distance(surface.t(), p, q), chord - 1e-14); // 20 epsilon
  EXPECT_EQ(straight_distance(surface.t(), p, p), 0.);
}

} // namespace path_locations_test
