// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/continuous_flow.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>
#include <CGAL/Geodesic_processing/internal/transport/transport.h>

#include "Glued_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

double exact_distance(const Glued_surface& surface, Index from, Index to)
{
  Window_propagation windows(surface.triangles());
  windows.run({surface.source(from)});
  return windows.distance(surface.site(to));
}

Transport transport(const Glued_surface& surface, Index from, Index to)
{
  Vector masses = Vector::Zero(surface.size());
  masses[surface.site(from)] -= 1.;
  masses[surface.site(to)] += 1.;
  return Transport_solver(operators(surface.t())).solve(masses);
}

double cost_of_continuous_flow(const Glued_triangles& t, const Operators& o, const Field& flow,
                               const std::vector<Tensor>& measure = {})
{
  return continuous_flow(t, o, flow, measure).cost;
}

TEST(continuous_flow, never_costs_less_than_the_way)
{
  for(const Triangulation& shape :
      {shaken(icosphere(3), 0.02), torus(40, 16), double_ring(2), cylinder(24, 8, 1., 2.),
       cone(12, 6, 4.), cone(12, 6, 8.), square(16, 0.24), annulus(24, 6, 0.5, 1.)})
  {
    const Glued_surface surface(shape);
    const Operators o = operators(surface.t());
    for(const Index to : {7u, surface.size() / 2, surface.size() - 1})
    {
      const double exact = exact_distance(surface, 0, to);
      const double cost = cost_of_continuous_flow(surface.t(), o, transport(surface, 0, to).flow);
      EXPECT_GE(cost, exact);
      // Spreading around both ends takes at most a side each, and what enters through sides and not
      // through corners needs up to half as much again on surfaces of some ten sides.
      EXPECT_LE(cost, 1.5 * exact + 2. * 2.);
    }
  }
}

TEST(continuous_flow, comes_nearer_on_finer_surfaces)
{
  double before = infinity;
  for(const unsigned level : {2u, 3u, 4u})
  {
    const Glued_surface surface(icosphere(level));
    const double cost = cost_of_continuous_flow(surface.t(), operators(surface.t()),
                                                transport(surface, 0, 30).flow) /
                        exact_distance(surface, 0, 30);
    EXPECT_GE(cost, 1.);
    EXPECT_LT(cost, before);
    before = cost;
  }
}

TEST(continuous_flow, passes_pinched_sites)
{
  // Two squares that touch in a corner, and masses on either.
  Triangulation shape = apart(square(4), square(4));
  for(std::size_t i = 25; i < 50; ++i)
    for(std::size_t c = 0; c < 2; ++c)
      shape.points[i][c] = shape.points[i - 25][c] + 1.;
  for(Index& corner : shape.corners)
    if(corner == 25)
      corner = 24;
  const Glued_surface surface(shape);
  const Operators o = operators(surface.t());
  const double exact = exact_distance(surface, 0, 49);
  const double cost = cost_of_continuous_flow(surface.t(), o, transport(surface, 0, 49).flow);
  EXPECT_GE(cost, exact);
  EXPECT_LE(cost, 2.5 * exact); // four ends in corners of squares that are four sides wide
}

TEST(continuous_flow, measures_as_told)
{
  const Glued_surface surface(shaken(icosphere(2), 0.03));
  const Operators o = operators(surface.t());
  const Field flow = transport(surface, 0, 100).flow;
  const double cost = cost_of_continuous_flow(surface.t(), o, flow);
  const std::vector<Tensor> twice(o.number_of_triangles(), {2., 0., 2.});
  EXPECT_NEAR(cost_of_continuous_flow(surface.t(), o, flow, twice), 2. * cost, 1e-6 * cost);
  // Longer in one direction: between once and twice as much.
  const std::vector<Tensor> uneven(o.number_of_triangles(), {1.5, 0.5, 1.5});
  const double more = cost_of_continuous_flow(surface.t(), o, flow, uneven);
  EXPECT_GT(more, cost);
  EXPECT_LT(more, 2. * cost);
}

TEST(continuous_flow, refuses_clouds)
{
  const Cloud cloud = octahedron_sphere(2);
  const Glued_triangles sphere = glue_surfels(cloud.points, cloud.normals).triangles;
  const Operators o = operators(sphere);
  EXPECT_THROW(continuous_flow(sphere, o, Field(o.number_of_triangles(), Planar{0., 0.})),
               Unsupported_surface_error);
}

} // namespace
