// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include "Array_surface.h"
#include "topology.h"

#include <gtest/gtest.h>

namespace refinement_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

double area(const Surface_arrays& t)
{
  double result = 0.;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    result += 0.5 * twice_area(t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]);
  return t.scale * t.scale * result;
}

std::vector<bool> random_halfedges(const Surface_arrays& t, std::mt19937& random, unsigned one_in)
{
  std::vector<bool> result(t.corner.size(), false);
  for(Index h = 0; h < result.size(); ++h)
    if(random() % one_in == 0)
    {
      result[h] = true;
      if(t.twin[h] != none)
        result[t.twin[h]] = true;
    }
  return result;
}

void expect_same_surface(const Refinement& refinement)
{
  const Surface_arrays &fine = *refinement.triangles, &coarse = *refinement.coarse;
  EXPECT_EQ(topology(fine.corner), topology(coarse.corner));
  // Sums of a thousand terms.
  EXPECT_NEAR(area(fine), area(coarse), 1e-12 * area(coarse));
  for(Index h = 0; h < fine.corner.size(); ++h)
  {
    const Index twin = fine.twin[h];
    if(twin == none)
      continue;
    EXPECT_EQ(fine.twin[twin], h);
    EXPECT_EQ(fine.corner[h], fine.corner[next_halfedge(twin)]);
    EXPECT_EQ(fine.length[h], fine.length[twin]);
  }
}

TEST(Refinement, without_splits_is_input_surface)
{
  const Array_surface surface(icosphere(2));
  const Refinement unchanged = make_refinement(surface.triangles());
  EXPECT_EQ(unchanged.triangles, surface.triangles());
  const Surface_location location = surface.in(3, {0.2, 0.3, 0.5});
  EXPECT_EQ(to_coarse(unchanged, location).barycentric, location.barycentric);
  EXPECT_EQ(to_fine(unchanged, {location})[0].triangle, location.triangle);
}

TEST(Refinement, represents_input_surface)
{
  std::mt19937 random(1);
  for(const Triangulation& triangulation :
      {icosphere(1), square(6, 0.2), cylinder(7, 4, 1., 2.), torus(7, 5), one_triangle()})
    for(const unsigned one_in : {1u, 2u, 5u})
      for(const double scale : {1e-6, 1., 1e6})
      {
        const Array_surface surface(scaled(triangulation, scale));
        Refinement fine = make_refinement(surface.triangles());
        for(int i = 0; i < 3; ++i)
        {
          fine = split_edges(fine, random_halfedges(*fine.triangles, random, one_in));
          expect_same_surface(fine);
        }
        for(int i = 0; i < 50; ++i)
        {
          const Surface_location location = random_location(*fine.triangles, random);
          const Surface_location image = to_coarse(fine, location);
          const Point p = coordinates(*fine.triangles, location);
          // A few round-off errors of numbers up to the scale.
          EXPECT_LT(distance(p, coordinates(surface.t(), image)), 1e-14 * scale);
          EXPECT_LT(distance(p, coordinates(*fine.triangles, to_fine(fine, {image})[0])),
                    1e-13 * scale);
        }
        // Vertices of the input are vertices of the refinement, bitwise.
        for(Index i = 0; i < surface.size(); ++i)
        {
          const Surface_location image = to_fine(fine, {surface.at(i)})[0];
          const Index vertex = vertex_of(*fine.triangles, image);
          ASSERT_NE(vertex, none);
          EXPECT_EQ(vertex_of(surface.t(), to_coarse(fine, {none, vertex, {}})), surface.vertex(i));
        }
      }
}

TEST(Refinement, splits_exactly_given_edges)
{
  const Array_surface surface(one_triangle());
  const Refinement unrefined = make_refinement(surface.triangles());
  for(Index mask = 0; mask < 8; ++mask)
  {
    const std::vector<bool> is_split = {bool(mask & 1), bool(mask & 2), bool(mask & 4)};
    const std::size_t number = is_split[0] + is_split[1] + is_split[2];
    const Refinement fine = split_edges(unrefined, is_split);
    EXPECT_EQ(fine.triangles->number_of_triangles(), 1 + number);
    EXPECT_EQ(fine.triangles->number_of_vertices(), 3 + number);
    expect_same_surface(fine);
    const std::vector<Index> coarse = coarse_halfedges(fine);
    for(Index h = 0; h < 3; ++h)
      EXPECT_EQ(std::count(coarse.begin(), coarse.end(), h), is_split[h] ? 2 : 1);
  }
}

TEST(Refinement, nonmanifold_vertices_are_split)
{
  // Two tetrahedra with a common corner.
  Triangulation tetrahedra = tetrahedron();
  for(const Point& p : {Point{3., 1., 1.}, Point{3., 3., 1.}, Point{3., 1., 3.}})
    tetrahedra.points.push_back(p);
  tetrahedra.corners.insert(tetrahedra.corners.end(), {0, 4, 5, 0, 5, 6, 0, 6, 4, 4, 6, 5});
  const Array_surface surface(tetrahedra);
  EXPECT_FALSE(topology(surface.t().corner).is_simple);
  const Refinement split_surface = make_refinement(surface.triangles());
  EXPECT_EQ(split_surface.triangles->number_of_vertices(), 8u);
  EXPECT_EQ(topology(split_surface.triangles->corner), (Topology{true, {{2, 0}, {2, 0}}}));
  EXPECT_EQ(
      vertex_of(surface.t(), to_coarse(split_surface, to_fine(split_surface, {surface.at(0)})[0])),
      surface.vertex(0));
}

} // namespace refinement_test
